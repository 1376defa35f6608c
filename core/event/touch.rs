//! When do two bodies touch, or part from a plate? Reads the scene; writes nothing, picks closed form or bracket.

use super::bracket::{Found, Search};
use super::root;
use super::scene::Scene;
use crate::matter::{Body, Plane, flight};
use crate::number::{Product, Scalar, Vector, dot, norm};

/// At what time two bodies touch that nothing holds: BSFP14's rule. Uniform gravity leaves their
/// relative motion straight.
///
/// It depends on nothing but the two, not on when it is asked: both are taken at the later of their
/// clocks. `image` is what their separation lacks to that of the images which are near now.
#[inline]
pub(super) fn flying<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    [me, other]: [&Body<S, D>; 2],
    image: &Vector<S, D>,
) -> Option<S> {
    let (mut from, field) = (me.clock, scene.field());
    let (mut x, mut v) = (me.position, me.velocity);
    let (mut y, mut w) = (other.position, other.velocity);
    if other.clock <= from {
        (y, w) = flight::free(other, field, from);
    } else {
        from = other.clock;
        (x, v) = flight::free(me, field, from);
    }
    let span = root::spheres(&(x - y + image), &(v - w), me.radius + other.radius)?;
    Some(from + span)
}

/// What the separation of two bodies, one of them `here` now, lacks to that of their nearest images.
#[inline(never)]
pub(super) fn near_image<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    here: &Vector<S, D>,
    other: &Body<S, D>,
) -> Vector<S, D> {
    let apart = here - flight::free(other, scene.field(), scene.now).0;
    scene.boundary.nearest(apart) - apart
}

/// After which span two bodies touch of which at least one is held. Both are as they are now.
///
/// A pair in contact has one velocity copied twice; it is skipped by the caller so that rounding of
/// two clocks cannot make it meet itself.
pub(super) fn held<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    other: &Body<S, D>,
    limit: S,
) -> Found<S> {
    let reach = me.radius + other.radius;
    if me.is_frozen() && other.is_frozen() && me.planes == other.planes {
        return Found::Nothing;
    }
    let field = scene.field();
    let apart = flight::acceleration(me, field) - flight::acceleration(other, field);
    let together = flight::plates(me, field).eq(flight::plates(other, field));
    let alike = me.planes == other.planes && me.is_frozen() == other.is_frozen();
    if alike || (together && !(norm(&apart) > S::zero())) {
        let separation = scene.separation(me, other);
        let found = root::spheres(&separation, &(me.velocity - other.velocity), reach);
        return found.map_or(Found::Nothing, Found::Event);
    }
    let shaking = if together { S::zero() } else { shaking(scene, me) + shaking(scene, other) };
    let bound = norm(&apart) + shaking;
    Search::new(bound.larger(S::weak(reach, limit)), reach, limit).first(|t| {
        let [a, b] = [me, other].map(|body| flight::at(body, field, scene.now + t));
        overlap(&scene.separation(&a, &b), &(a.velocity - b.velocity), reach)
    })
}

/// f = |r| − σ and ḟ. The difference of squares keeps the last places of a touching pair.
fn overlap<S: Scalar, const D: usize>(r: &Vector<S, D>, v: &Vector<S, D>, sigma: S) -> (S, S) {
    let distance = norm(r);
    if !(distance > S::zero()) {
        return (-sigma, -norm(v));
    }
    ((S::dot(r, r) - sigma.times(sigma)).over(distance + sigma), S::dot(r, v).over(distance))
}

/// At what time a body that nothing holds touches a plane that does not move; from its own clock on.
#[inline]
pub(super) fn wall<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    plane: &Plane<S, D>,
) -> Option<S> {
    let n = &plane.normal;
    let gap = plane.mean_gap(&me.position, me.radius);
    Some(me.clock + root::plane(gap, dot(n, &me.velocity), dot(n, &scene.gravity))?)
}

/// When a body, as it is now, touches a plane that does not hold it.
pub(super) fn plane<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    plane: &Plane<S, D>,
    limit: S,
) -> Found<S> {
    let field = scene.field();
    let mean = plane.mean_gap(&me.position, me.radius);
    let (v, a) =
        (dot(&plane.normal, &me.velocity), dot(&plane.normal, &flight::acceleration(me, field)));
    let Some(vibration) = plane.vibration else {
        return match shaking_along(scene, me, &plane.normal) > S::zero() {
            false => root::plane(mean, v, a).map_or(Found::Nothing, Found::Event),
            true => shaken(scene, me, plane, S::zero(), limit),
        };
    };
    // Above the plate's highest place there is nothing to touch.
    let top = vibration.amplitude.magnitude();
    if mean > top && !(shaking_along(scene, me, &plane.normal) > S::zero()) {
        return match root::plane(mean - top, v, a) {
            Some(from) if from <= limit => shaken(scene, me, plane, from, limit),
            _ => Found::Nothing,
        };
    }
    shaken(scene, me, plane, S::zero(), limit)
}

/// When a body touches a plane while either of them vibrates, looking from a span on.
fn shaken<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    plane: &Plane<S, D>,
    from: S,
    limit: S,
) -> Found<S> {
    let field = scene.field();
    let a = dot(&plane.normal, &flight::acceleration(me, field)).magnitude();
    let shaking = plane.vibration.map_or(S::zero(), |v| v.peak_acceleration())
        + shaking_along(scene, me, &plane.normal);
    let bound = (a + shaking).larger(S::weak(me.radius, limit));
    let found = Search::new(bound, me.radius, limit - from).first(|t| {
        let then = scene.now + (from + t);
        let body = flight::at(me, field, then);
        let rate = dot(&plane.normal, &body.velocity) - plane.motion(then).speed;
        (plane.gap(&body.position, me.radius, then), rate)
    });
    match found {
        Found::Event(span) => Found::Event(from + span),
        Found::NotBefore(span) => Found::NotBefore(from + span),
        Found::Nothing => Found::Nothing,
    }
}

/// When the plate that carries a body falls away faster than the body does: z̈₀ < g_n.
pub(super) fn take_off<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
) -> Found<S> {
    let leaves = flight::plates(me, scene.field()).map(|plate| falls_away(scene, plate));
    leaves.fold(Found::Nothing, |first, next| match (first, next) {
        (Found::Nothing, found) | (found, Found::Nothing) => found,
        (a, b) if b.span() < a.span() => b,
        (a, _) => a,
    })
}

fn falls_away<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, plate: &Plane<S, D>) -> Found<S> {
    let Some(vibration) = plate.vibration else { return Found::Nothing };
    let falls = dot(&plate.normal, &scene.gravity);
    let (omega, peak) = (vibration.angular_frequency(), vibration.peak_acceleration());
    if plate.motion(scene.now).acceleration < falls {
        return Found::Event(S::zero());
    }
    if peak <= -falls || !(peak > S::zero()) {
        return Found::Nothing;
    }
    let sign = if vibration.amplitude > S::zero() { S::one() } else { -S::one() };
    let search = Search::new(peak * omega * omega, peak, S::NEVER);
    search.first(|t| {
        let (sin, cos) = vibration.phase_at(scene.now + t);
        (-sign * peak * sin - falls, -sign * peak * cos * omega)
    })
}

/// The size of the acceleration that the plate carrying a body can give it; 0 if none does.
pub(super) fn shaking<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> S {
    let vibrations = flight::plates(me, scene.field()).filter_map(|plate| plate.vibration);
    vibrations.fold(S::zero(), |sum, v| sum + v.peak_acceleration())
}

/// The same along a direction.
fn shaking_along<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    n: &Vector<S, D>,
) -> S {
    flight::plates(me, scene.field()).fold(S::zero(), |sum, plate| {
        let peak = plate.vibration.map_or(S::zero(), |v| v.peak_acceleration());
        sum + peak * dot(&plate.normal, n).magnitude()
    })
}

/// Whether a plate shakes the body along an axis.
pub(super) fn is_shaken<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    axis: usize,
) -> bool {
    let mut plates = flight::plates(me, scene.field());
    plates.any(|p| p.normal.get(axis).is_some_and(|&n| n != S::zero()))
}

/// When a body that a plate carries crosses a face of its cell, now at this distance.
pub(super) fn shaken_face<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    axis: usize,
    gap: S,
    up: bool,
) -> Found<S> {
    let field = scene.field();
    let along = |v: &Vector<S, D>| {
        let x = v.get(axis).copied().unwrap_or(S::zero());
        if up { -x } else { x }
    };
    let (start, a) = (along(&me.position), along(&flight::acceleration(me, field)).magnitude());
    let bound = (a + shaking(scene, me)).larger(S::weak(me.radius, S::one()));
    Search::new(bound, me.radius, S::NEVER).first(|t| {
        let there = flight::at(me, field, scene.now + t);
        (gap + (along(&there.position) - start), along(&there.velocity))
    })
}
