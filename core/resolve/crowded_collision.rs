//! What happens when two bodies touch, where contacts that last or crowd are integrated? Reads both, who is near, and the rule; writes both.
//!
//! A pair that nothing else can disturb has a contact of its own (E^φ, E^v) or collides at once. All others
//! are clustered, and so are those that gravity keeps together.

use super::accept_answer::ask;
use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::surface_contact::{Friction, Surfaces};
use super::{broken_contact, contact_begin, make_room, plane_collision, surface_collision};
use crate::cluster::{Course, MAX_COLLISIONS, Party, is_crowded};
use crate::error::Error;
use crate::law::{Outcome, Response, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, max_abs, norm};
use crate::space::Plane;

/// After so many collisions each soon after the last, forces decide.
const MAX_SOON: u16 = 64;

/// The same without gravity where they are slow. Such a collision alone keeps nobody together: a gas has
/// them, too.
const MAX_SLOW_SOON: u16 = 8;

/// Grain `i` touches its partner.
pub(super) fn touch<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, partner): (usize, Partner),
) -> Result<EventOutcome<S>, Error> {
    let other = partner.as_grain();
    if let Some(joined) = break_off(context, rule, [Some(i), other]) {
        return Ok(joined);
    }
    match (other, partner.as_plane()) {
        (Some(k), _) => touch_grain(context, rule, if i < k { [i, k] } else { [k, i] }),
        (None, Some(p)) => touch_plane(context, rule, (i, p)),
        (None, None) => Ok(EventOutcome::Unchanged),
    }
}

/// If one of these is in a contact of its own that is broken off, and all are clustered from now on.
#[inline(always)]
pub(super) fn break_off<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    grains: [Option<usize>; 2],
) -> Option<EventOutcome<S>> {
    let partners = grains.map(|x| broken_off(context, rule, x));
    partners.iter().any(Option::is_some).then(|| {
        make_room(context, rule, (grains, partners));
        join(context, grains)
    })
}

/// The contact of its own that a grain is in is broken off; returns with whom it was.
#[inline(never)]
fn broken_off<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    grain: Option<usize>,
) -> Option<Partner> {
    let body = context.particles.body(grain?).filter(|body| body.in_contact())?;
    let partner = body.partner;
    broken_contact::cluster(context, rule, grain?);
    Some(partner)
}

/// Those whose contacts were broken off are where they really are: into whom that put them gains nothing by it.
#[inline(never)]
fn make_room<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (two, partners): ([Option<usize>; 2], [Option<Partner>; 2]),
) {
    let grains =
        |x: Option<usize>, partner: Option<Partner>| [x, partner.and_then(Partner::as_grain)];
    let ([first, second], [with_first, with_second]) = (two, partners);
    let [first, second] = [grains(first, with_first), grains(second, with_second)];
    // Who comes gives way rather than who was in contact.
    let ordered = if with_first.is_none() { [second, first] } else { [first, second] };
    make_room::between(context, rule, ordered);
}

/// These are clustered from now on.
pub(super) fn join<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    grains: [Option<usize>; 2],
) -> EventOutcome<S> {
    context.count(Incident::Join);
    let clustered = |context: &Context<'_, '_, S, D>| context.clusters.count;
    let before = clustered(context);
    grains.into_iter().flatten().for_each(|grain| context.join(grain));
    if clustered(context) == before {
        // They were already: forces decide, and nothing at once until the step ends.
        for x in grains.into_iter().flatten() {
            if let Some(body) = context.particles.bodies.get_mut(x) {
                body.consecutive_collisions = MAX_COLLISIONS;
            }
        }
    }
    EventOutcome::Joined
}

fn touch_grain<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    who: [usize; 2],
) -> Result<EventOutcome<S>, Error> {
    let [i, k] = who;
    let pair = context.both_present(who);
    let [a, b] = &pair;
    let [separation, velocity] = context.domain.relative(a, b, context.now());
    let frame = ImpactFrame::new(separation, velocity);
    let settled = [a, b].into_iter().any(is_settled);
    let Some(frame) = frame.filter(|frame| frame.radial < S::zero()) else {
        if settled {
            return Ok(join(context, who.map(Some)));
        }
        // Grazing within rounding: they part already, and are predicted from here.
        who.iter().zip(&pair).for_each(|(&x, body)| context.replace(x, *body));
        return Ok(EventOutcome::Unchanged);
    };
    let impact = frame.impact(a, b);
    let lasts = rule.force(&impact, S::zero()).is_some();
    let radius = a.radius.min(b.radius);
    let crowd = move |context: &mut Context<'_, '_, S, D>| Ok(join(context, who.map(Some)));
    // What a law of one's own does in a contact that lasts is in no table.
    let shared = settled || rule.remembers();
    if if lasts { shared } else { is_held(context, [a, b], (-frame.radial, radius)) } {
        return crowd(context);
    }
    let surfaces = match lasts {
        true => Surfaces::new(context, rule, ((i, a), Some((k, b))), || (frame.e_r(), impact)),
        false => Surfaces::Smooth,
    };
    if let Surfaces::Rough(friction) = &surfaces {
        return touch_rough(context, rule, who, (&pair, friction));
    }
    if let Surfaces::Unknown = surfaces {
        return crowd(context);
    }
    let response = ask(rule, &impact, context.effects, (i, Partner::grain(k)))?;
    match without_force(response, settled) {
        Response::Lasting(outcome) => {
            if disturbed(context, who, &pair, &outcome) {
                return crowd(context);
            }
            // Nothing is where it turns to.
            contact_begin::bind(context, who, &pair, (&frame, &outcome));
            begins_now(context, who);
            context.count(Incident::Collision);
            Ok(EventOutcome::ContactBegan(outcome))
        }
        // Outside the table: forces know.
        Response::Instantaneous(_) if lasts => crowd(context),
        Response::Instantaneous(restitution) => {
            context.count(Incident::Collision);
            let mass = a.mass + b.mass;
            let least = min_parting_speed(&a.velocity) + min_parting_speed(&b.velocity);
            let away = (restitution * -frame.radial).max(least) - frame.radial;
            let change = frame.along(away);
            kick(context, (i, a, radius), change * (b.mass / mass));
            kick(context, (k, b, radius), -change * (a.mass / mass));
            surface_collision::act(context, rule, || frame.touch(who, restitution));
            Ok(EventOutcome::Collision { restitution })
        }
        Response::Refused { .. } | Response::Overflow(_) => Ok(EventOutcome::Unchanged),
    }
}

/// Two rough grains whose contact is their own affair.
fn touch_rough<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    who: [usize; 2],
    (pair, friction): (&[Body<S, D>; 2], &Friction<S, D>),
) -> Result<EventOutcome<S>, Error> {
    let pair = friction.begin(pair);
    let [a, b] = &pair;
    let [separation, velocity] = context.domain.relative(a, b, context.now());
    let Some(frame) = ImpactFrame::new(separation, velocity) else {
        return Ok(join(context, who.map(Some)));
    };
    let impact = frame.impact(a, b);
    let response = ask(rule, &impact, context.effects, (who[0], Partner::grain(who[1])))?;
    match response {
        Response::Lasting(outcome) if !disturbed(context, who, &pair, &outcome) => {
            contact_begin::bind(context, who, &pair, (&frame, &outcome));
            friction.end(context, who, (&frame, &outcome), impact.contact_distance);
            begins_now(context, who);
            context.count(Incident::Collision);
            Ok(EventOutcome::ContactBegan(outcome))
        }
        _ => Ok(join(context, who.map(Some))),
    }
}

/// Whether a body is clustered or asleep.
pub(super) fn is_settled<S: Scalar, const D: usize>(body: &Body<S, D>) -> bool {
    body.is_clustered() || body.is_asleep()
}

/// What a rule says of a grain that is clustered or asleep: such has no contacts of its own, so what lasts, but has
/// no force law by which it could go on, happens at once.
fn without_force<S: Scalar>(response: Response<S>, settled: bool) -> Response<S> {
    match response {
        Response::Lasting(outcome) if settled => Response::Instantaneous(outcome.restitution),
        other => other,
    }
}

/// Whether a collision without duration belongs to a contact that lasts: it is slow, and so soon after the
/// last one of either that gravity, not the collisions, decides; or there have been many in a row.
pub(super) fn is_held<'a, S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    bodies: impl IntoIterator<Item = &'a Body<S, D>>,
    (speed, radius): (S, S),
) -> bool {
    let settings = &context.parameters.settings;
    let is_slow = speed <= settings.slow_speed(radius);
    bodies.into_iter().any(|body| {
        let count = if is_settled(body) { 0 } else { body.consecutive_collisions };
        let is_soon = || match context.domain.is_weightless() {
            true => count >= MAX_SLOW_SOON,
            false => is_soon(context, body, radius, S::one()),
        };
        count >= MAX_SOON || is_slow && (is_settled(body) || is_soon())
    })
}

/// Whether the last collision of a body is less than this part of a contact time ago.
fn is_soon<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    radius: S,
    part: S,
) -> bool {
    let last = body.last_collision();
    let pi = S::from_f64(core::f64::consts::PI) * part;
    last > -S::NEVER && (context.now() - last) * context.parameters.settings.frequency(radius) < pi
}

/// Whether a third body could touch either before the contact ends.
fn disturbed<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    [i, k]: [usize; 2],
    [a, b]: &[Body<S, D>; 2],
    outcome: &Outcome<S>,
) -> bool {
    let mass = a.mass + b.mass;
    let [_, relative] = context.domain.relative(a, b, context.now());
    let centres = contact_begin::centre_velocities(context.domain, [a, b]);
    let speed = norm(&relative);
    let parties = [
        Party { grain: i, body: a, velocity: centres[0], speed: speed * (b.mass / mass) },
        Party { grain: k, body: b, velocity: centres[1], speed: speed * (a.mass / mass) },
    ];
    let course = Course { with: Partner::NOTHING, duration: outcome.duration };
    is_crowded(context.particles, context.domain, context.now(), &parties, &course)
}

/// Keeps when a contact began, so that the touch can be recovered.
fn begins_now<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    who: impl IntoIterator<Item = usize>,
) {
    let now = context.now();
    for x in who {
        if let Some(body) = context.particles.bodies.get_mut(x) {
            body.reference_time = now;
        }
    }
}

/// A grain's velocity changes at once. One that was asleep is clustered from now on.
pub(super) fn kick<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (x, body, radius): (usize, &Body<S, D>, S),
    change: Vector<S, D>,
) {
    if body.is_asleep() {
        context.join(x);
    }
    let soon = is_settled(body) || is_soon(context, body, radius, S::from_f32(1.0 / 16.0));
    let velocity = body.velocity + change;
    if is_settled(body) {
        context.clusters.speed = context.clusters.speed.max(norm(&velocity));
    }
    context.kick(x, [body.position, velocity], soon);
}

/// As [`super::instantaneous_collision`]: grains part at least so fast.
pub(super) fn min_parting_speed<S: Scalar, const D: usize>(velocity: &Vector<S, D>) -> S {
    max_abs(velocity).rounding() * S::from_f32(4.0)
}

fn touch_plane<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, p): (usize, usize),
) -> Result<EventOutcome<S>, Error> {
    let domain = context.domain;
    let Some(plane) = domain.boundary.planes().get(p) else { return Ok(EventOutcome::Unchanged) };
    let body = context.present(i);
    let motion = plane.motion(context.now());
    let speed = (motion.speed - dot(&plane.normal, &body.velocity)).max(S::zero());
    let weight = motion.acceleration - dot(&plane.normal, domain.gravity());
    let impact = plane_collision::impact(&body, plane, speed, weight);
    let restitution = plane.surface.restitution();
    let lasts = restitution.is_none() && rule.force(&impact, S::zero()).is_some();
    let held = !lasts && is_held(context, [&body], (speed, body.radius));
    let shared = is_settled(&body) || rule.remembers();
    if held || lasts && shared {
        return Ok(join(context, [Some(i), None]));
    }
    let surfaces = match lasts {
        true => Surfaces::new(context, rule, ((i, &body), None), || (plane.normal, impact)),
        false => Surfaces::Smooth,
    };
    if let Surfaces::Unknown = surfaces {
        return Ok(join(context, [Some(i), None]));
    }
    let response = match restitution {
        Some(restitution) => Response::Instantaneous(restitution),
        None => ask(rule, &impact, context.effects, (i, Partner::plane(p)))?,
    };
    match without_force(response, is_settled(&body)) {
        Response::Lasting(outcome) => {
            let heavy = weight.abs() * outcome.duration * S::from_f32(256.0) > speed;
            if heavy || is_disturbed_at(context, (i, &body), (p, plane), (speed, &outcome)) {
                return Ok(join(context, [Some(i), None]));
            }
            context.count(Incident::PlaneCollision);
            let rough = match &surfaces {
                Surfaces::Rough(friction) => Some(friction),
                _ => None,
            };
            let body = rough.map_or(body, |friction| friction.begin_with_plane(&body));
            let began =
                contact_begin::begin_with_plane(context, (i, p), &body, plane, (speed, &outcome));
            if let Some(friction) = rough {
                friction.end_with_plane(context, i, &plane.normal);
            }
            begins_now(context, [i]);
            Ok(began)
        }
        Response::Instantaneous(_) if lasts => Ok(join(context, [Some(i), None])),
        Response::Instantaneous(restitution) => {
            context.count(Incident::PlaneCollision);
            let least = min_parting_speed(&body.velocity);
            let away = (speed * restitution).max(least) + speed;
            kick(context, (i, &body, body.radius), plane.normal * away);
            surface_collision::act(context, rule, || {
                plane_collision::touch((i, Partner::plane(p)), plane, speed, restitution)
            });
            Ok(EventOutcome::Collision { restitution })
        }
        Response::Refused { .. } | Response::Overflow(_) => Ok(EventOutcome::Unchanged),
    }
}

/// Whether a third body, or another plane, could touch a grain before its contact with a plane ends.
fn is_disturbed_at<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    (i, body): (usize, &Body<S, D>),
    (p, plane): (usize, &Plane<S, D>),
    (speed, outcome): (S, &Outcome<S>),
) -> bool {
    let along = dot(&plane.normal, &body.velocity);
    let velocity = body.velocity - plane.normal * along;
    let course = Course { with: Partner::plane(p), duration: outcome.duration };
    let party = Party { grain: i, body, velocity, speed };
    is_crowded(context.particles, context.domain, context.now(), &[party], &course)
}
