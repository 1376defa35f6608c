//! Where are two bodies in the middle of their contact? Reads the contact and the rule; writes both, clustered from now on.
//!
//! A pair's contact was begun as a whole (E^φ). When a third body comes, what has become of it so far is
//! needed: the touch is recovered (the rule, asked again, tells how the contact turned), and the pair's own
//! motion integrated from there.

use super::context::Context;
use super::plane_collision;
use crate::law::{Impact, Outcome, Response, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, norm};
use crate::space::{Plane, flight};

/// Steps of the integration in a contact's duration.
const STEPS: u32 = 64;

/// The contact of grain `i` is broken off: whoever takes part is clustered, as it is by now.
pub(crate) fn cluster<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    i: usize,
) {
    let Some(body) = context.particles.body(i).copied() else { return };
    let planes = context.domain.boundary.planes();
    if let Some(plane) = body.partner.as_plane().and_then(|p| planes.get(p)) {
        with_plane(context, rule, (i, &body), plane);
    } else if let Some(k) = body.partner.as_grain() {
        with_grain(context, rule, [i, k]);
        context.effects.predict_anew(k);
    }
}

/// Up to when the pair is integrated by itself: the beginning of the cluster's step, not before the touch.
fn until<S: Scalar, const D: usize>(context: &Context<'_, '_, S, D>, touch: S) -> S {
    let begin = if context.clusters.count > 0 { context.clusters.time } else { context.now() };
    begin.max(touch)
}

/// The speed of approach after which the rule gives this speed of separation, and what else it gives.
fn recover<S: Scalar>(
    rule: &impl Rule<S>,
    away: S,
    impact: impl Fn(S) -> Impact<S>,
) -> Option<(S, Outcome<S>)> {
    let mut speed = away;
    let mut found = None;
    for _ in 0..24 {
        let Response::Lasting(outcome) = rule.collide(&impact(speed)).response else { break };
        let next = away / outcome.restitution.max(S::from_f32(1e-3));
        found = Some((speed, outcome));
        if next == speed {
            break;
        }
        speed = next;
    }
    found
}

fn with_grain<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    [i, k]: [usize; 2],
) {
    let touch = context.particles.body(i).map_or(S::zero(), |body| body.reference_time);
    let to = until(context, touch);
    let [a, b] = [i, k].map(|x| context.particles.present(x, context.domain, to));
    let (apart, away) =
        (context.domain.separation(&a, &b, to), a.velocity_change - b.velocity_change);
    let reach = a.radius + b.radius;
    let distance = norm(&apart);
    let e = apart / distance;
    let out = dot(&e, &away);
    let across = away - e * out;
    let tangential = if D > 1 { norm(&across) } else { S::zero() };
    let t = if tangential > S::zero() { across / tangential } else { Vector::zeros() };
    let turned = tangential * (distance / reach);
    let impact = |speed| Impact {
        contact_distance: reach,
        effective_radius: a.radius / reach * b.radius,
        reduced_mass: a.mass / (a.mass + b.mass) * b.mass,
        normal_speed: speed,
        tangential_speed: turned,
        acceleration: S::zero(),
        materials: [a.material, b.material],
    };
    let mut relative = [apart, away];
    if let Some((speed, outcome)) = recover(rule, out, impact) {
        let (sin, cos) = outcome.angle.sin_cos();
        let e_r = e * cos - t * sin;
        let e_t = t * cos + e * sin;
        let touching = [e_r * reach, e_t * turned - e_r * speed];
        let step = outcome.duration / S::from_count(STEPS);
        relative = integrate(rule, &impact(speed), touching, (to - touch, step));
    }
    let mass = a.mass + b.mass;
    for (x, body, share) in [(i, &a, b.mass / mass), (k, &b, -(a.mass / mass))] {
        let step = context.domain.boundary.on_lattice((relative[0] - apart) * share);
        let free = Body {
            position: body.position + step,
            velocity: body.velocity + relative[1] * share,
            partner: Partner::NOTHING,
            ..*body
        };
        context.relocate(x, free);
        context.join(x);
    }
}

/// The relative motion of two bodies after so long, by Runge and Kutta's method of fourth order.
fn integrate<S: Scalar, const D: usize>(
    rule: &impl Rule<S>,
    impact: &Impact<S>,
    mut state: [Vector<S, D>; 2],
    (span, step): (S, S),
) -> [Vector<S, D>; 2] {
    let slope = |[x, v]: [Vector<S, D>; 2]| {
        let distance = norm(&x);
        let e = x / distance;
        let overlap = impact.contact_distance - distance;
        let force = match rule.force(impact, overlap.max(S::zero())) {
            Some(force) if overlap >= S::zero() => force.at_rate(-dot(&e, &v)),
            _ => S::zero(),
        };
        [v, e * (force / impact.reduced_mass - impact.acceleration)]
    };
    let steps = (span / step).to_count().min(STEPS) + 1;
    let h = span / S::from_count(steps);
    for _ in 0..steps {
        let on =
            |[x, v]: [Vector<S, D>; 2], [dx, dv]: [Vector<S, D>; 2], h: S| [x + dx * h, v + dv * h];
        let (half, sixth) = (h * S::half(), h * S::from_f64(1.0 / 6.0));
        let first = slope(state);
        let second = slope(on(state, first, half));
        let third = slope(on(state, second, half));
        let last = slope(on(state, third, h));
        let two = S::from_f32(2.0);
        for (n, x) in state.iter_mut().enumerate() {
            let of = |s: &[Vector<S, D>; 2]| s.get(n).copied().unwrap_or(Vector::zeros());
            *x += (of(&first) + (of(&second) + of(&third)) * two + of(&last)) * sixth;
        }
    }
    state
}

fn with_plane<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, body): (usize, &Body<S, D>),
    plane: &Plane<S, D>,
) {
    let (touch, n) = (body.reference_time, plane.normal);
    let to = until(context, touch);
    let there = flight::at(body, context.domain, to);
    let out = dot(&n, &body.velocity_change) - plane.motion(body.contact_end).speed;
    let begin = plane.motion(touch);
    let weight = begin.acceleration - dot(&n, context.domain.gravity());
    let impact = |speed| plane_collision::impact(body, plane, speed, weight);
    let (mut gap, mut rate) = (S::zero(), out);
    if let Some((speed, outcome)) = recover(rule, out, impact) {
        let impact = impact(speed);
        // As if against a body at rest: along one axis, the weight added.
        let step = outcome.duration / S::from_count(STEPS);
        let along = |x: S| {
            let mut v = Vector::<S, 1>::zeros();
            v.iter_mut().for_each(|y| *y = x);
            v
        };
        let [x, v] =
            integrate(rule, &impact, [along(body.radius), along(-speed)], (to - touch, step));
        (gap, rate) = (x.sum() - body.radius, v.sum());
    }
    let now = plane.motion(to);
    let shift = gap - plane.gap(&there.position, body.radius, to);
    let turn = now.speed + rate - dot(&n, &there.velocity);
    let free = Body {
        position: there.position + n * shift,
        velocity: there.velocity + n * turn,
        partner: Partner::NOTHING,
        ..there
    };
    context.relocate(i, free);
    context.join(i);
}
