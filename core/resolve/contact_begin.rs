//! How does a lasting contact begin? Reads bodies and an outcome; writes bodies, turned and bound (E^φ).

use super::clearance::{Room, room};
use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::wake;
use crate::law::Outcome;
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct, dot, norm, reject};
use crate::space::{Domain, Plane};

/// E^φ: the line of centres turns, both grains take the velocity of their centre of mass, and what
/// they will have after the contact is kept for E^v (MP13 §VI.B.2). False if the turn would overlap a
/// third body (exception a): then nothing has changed.
pub(super) fn begin<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    [i, k]: [usize; 2],
    [a, b]: &[Body<S, D>; 2],
    (frame, outcome): (&ImpactFrame<S, D>, &Outcome<S>),
) -> bool {
    let turn = Turn::new(context, [a, b], (frame, outcome));
    let [at_a, at_b] = turn.positions;
    // Both take the velocity of their centre of mass, which is not faster than the faster of them.
    let fastest = a.velocity.zip_map(&b.velocity, |x, y| x.abs().max(y.abs()));
    let moving = (fastest, outcome.duration);
    if !(has_room(context, ((i, a), at_a, Partner::grain(k)), &moving)
        && has_room(context, ((k, b), at_b, Partner::grain(i)), &moving))
    {
        context.effects.alone = 0;
        context.count(Incident::RotationRefused);
        return false;
    }
    turn.bind(context, [i, k], [a, b], outcome.duration);
    true
}

/// The same where it is known that there is room.
pub(super) fn bind<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    who: [usize; 2],
    [a, b]: &[Body<S, D>; 2],
    (frame, outcome): (&ImpactFrame<S, D>, &Outcome<S>),
) {
    Turn::new(context, [a, b], (frame, outcome)).bind(context, who, [a, b], outcome.duration);
}

/// What a contact makes of two grains.
struct Turn<S: Scalar, const D: usize> {
    /// Where they stand then.
    positions: [Vector<S, D>; 2],
    /// What E^v will add to their velocities.
    changes: [Vector<S, D>; 2],
}

impl<S: Scalar, const D: usize> Turn<S, D> {
    #[inline]
    fn new(
        context: &Context<'_, '_, S, D>,
        [a, b]: [&Body<S, D>; 2],
        (frame, outcome): (&ImpactFrame<S, D>, &Outcome<S>),
    ) -> Self {
        let (separation, velocity) = frame.after(a.radius + b.radius, outcome);
        let mass = a.mass + b.mass;
        let (share_a, share_b) = (b.mass / mass, -(a.mass / mass));
        let moved = separation - context.domain.separation(a, b, context.now());
        // Steps on the lattice: positions then do not depend on the image in which a grain is kept.
        let step = |share| context.domain.boundary.on_lattice(moved * share);
        Self {
            positions: [a.position + step(share_a), b.position + step(share_b)],
            changes: [velocity * share_a, velocity * share_b],
        }
    }

    #[inline]
    fn bind(
        &self,
        context: &mut Context<'_, '_, S, D>,
        [i, k]: [usize; 2],
        [a, b]: [&Body<S, D>; 2],
        duration: S,
    ) {
        let [centre, centre_of_b] = centre_velocities(context.domain, [a, b]);
        let ([at_a, at_b], [change_a, change_b]) = (self.positions, self.changes);
        for (x, body, [position, velocity], velocity_change, partner) in
            [(i, a, [at_a, centre], change_a, k), (k, b, [at_b, centre_of_b], change_b, i)]
        {
            let there = Body { position, velocity, ..body.awake() };
            let bound = Body {
                velocity_change,
                contact_end: context.now() + duration,
                reference_time: uninterruptible_until(context, &there, duration),
                partner: Partner::grain(partner),
                ..there
            };
            context.relocate(x, bound);
            if body.is_supported() {
                wake::woke(context, x);
            }
        }
    }
}

/// The velocity of the centre of mass of two bodies, in the image of each.
pub(super) fn centre_velocities<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    [a, b]: [&Body<S, D>; 2],
) -> [Vector<S, D>; 2] {
    let share = a.mass / (a.mass + b.mass);
    let Some(image) = domain.image_velocity(a, b) else {
        return [b.velocity + (a.velocity - b.velocity) * share; 2];
    };
    let there = b.velocity + image;
    let centre = there + (a.velocity - there) * share;
    [centre, centre - image]
}

/// E^φ against a plane: the grain stays at ε_r R from it for the contact duration; the motion along
/// the plane goes on. If it cannot be put there it stays where it is.
///
/// So that gravity and the plane's own motion do not press the grain into the plane meanwhile, it
/// starts with the normal velocity ż₀ + (z̈₀ − g_n) τ/2 and is at the same distance at the end. What
/// they do to a real contact is in the outcome: the rule was asked with [`Impact::acceleration`](crate::law::Impact).
/// A grain too slow to outlast it comes to rest instead.
pub(super) fn begin_with_plane<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (i, p): (usize, usize),
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    (speed, outcome): (S, &Outcome<S>),
) -> EventOutcome<S> {
    let (n, start) = (&plane.normal, context.now());
    let shift = body.radius * (outcome.separation - S::one())
        - plane.gap(&body.position, body.radius, start);
    let mut position = body.position + n * shift;
    let moving = (body.velocity, outcome.duration);
    if !has_room(context, ((i, body), position, Partner::plane(p)), &moving) {
        context.count(Incident::RotationRefused);
        position = body.position;
    }
    let contact_end = start + outcome.duration;
    let (now, later) = (plane.motion(start), plane.motion(contact_end));
    let along = match plane.moves() {
        true => (later.place - now.place) / outcome.duration.max(start.rounding()),
        false => S::zero(),
    };
    let hold = along - dot(n, context.domain.gravity()) * outcome.duration * S::half();
    let velocity = reject(&body.velocity, n) + n * hold;
    let there = Body { position, velocity, ..*body };
    let bound = Body {
        velocity_change: n * (later.speed + speed * outcome.restitution),
        contact_end,
        reference_time: uninterruptible_until(context, &there, outcome.duration),
        partner: Partner::plane(p),
        ..there
    };
    context.relocate(i, bound.awake());
    EventOutcome::ContactBegan(*outcome)
}

/// Whether gravity points away from a plane and would move the grain visibly, by more than a 64th of its
/// radius, during the contact: g τ²/8 is how far the contact would bend its path into the plane.
pub(super) fn is_pulled_off<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    duration: S,
) -> bool {
    let away = dot(&plane.normal, context.domain.gravity()) * duration;
    away > S::zero() && away.times(duration) > body.radius.times(S::from_f32(0.125))
}

/// Whether there is room for a grain that moves on so fast, and how long; it is noted where nobody can come near meanwhile.
fn has_room<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    place: ((usize, &Body<S, D>), Vector<S, D>, Partner),
    moving: &(Vector<S, D>, S),
) -> bool {
    let ((grain, body), ..) = place;
    let margin = alone_within(context, body.radius, moving);
    let room = room(context.particles, context.domain, context.now(), place, margin);
    if room == Room::Alone {
        context.effects.stands_alone(grain);
    }
    room != Room::None
}

/// At what distance others cannot come near meanwhile, if that is less than a 64th of the grain's radius.
///
/// Only on small machines, which look at neighbours one by one, and for what flies freely in numbers that have no range.
#[cfg(not(feature = "alloc"))]
fn alone_within<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    radius: S,
    (velocity, duration): &(Vector<S, D>, S),
) -> Option<S> {
    let (particles, domain) = (&context.particles, context.domain);
    if S::RANGE.is_some() || particles.supported > 0 || domain.boundary.images().is_some() {
        return None;
    }
    let most = radius * S::from_f32(1.0 / 64.0);
    let way = particles.way_of_others(domain, (context.now(), *duration), velocity);
    // As much again for rounding.
    let margin = way + most * S::from_f32(1.0 / 64.0);
    (margin < most).then_some(margin)
}

#[cfg(feature = "alloc")]
fn alone_within<S: Scalar, const D: usize>(
    _: &Context<'_, '_, S, D>,
    _: S,
    _: &(Vector<S, D>, S),
) -> Option<S> {
    None
}

/// Until when a contact that begins now cannot be ended by a third body: a 64th of its duration, or,
/// if that is less, until it, or a plate towards it, can have moved a 64th of its radius or of its height
/// above a plane.
///
/// Meanwhile a third body may sink in by v τ/64, a fraction of what it would in a real contact; and the
/// centre of a grain that is pressed into a corner again and again does not come behind a plane.
pub(super) fn uninterruptible_until<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    duration: S,
) -> S {
    let (part, planes) = (S::from_f32(1.0 / 64.0), context.domain.boundary.planes());
    let height = planes.iter().fold(body.radius, |least, plane| {
        let height = plane.gap(&body.position, body.radius, context.now()) + body.radius;
        least.min(height.max(body.radius * part * part))
    });
    let shaken = planes.iter().fold(S::zero(), |most, plane| most.max(plane.peak_speed()));
    let (far, g) = (height * part, norm(context.domain.gravity()));
    let speed = norm(&body.velocity) + shaken;
    // v t + g t²/2 = far, without cancellation.
    let fastest = speed + (speed.times(speed) + (g + g).times(far)).sqrt();
    let brief = duration * part;
    context.now() + if fastest * brief > far + far { (far + far) / fastest } else { brief }
}
