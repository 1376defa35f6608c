//! What do rough surfaces do in a contact of two alone? Reads how they slide; writes velocities and rotation, before the contact and after it.
//!
//! Friction acts all through a contact, while the pair turns. Half of its impulse at the touch and half at the end, each
//! across the line of centres as it is then, leaves an error of second order in how far the pair turns (η). Momentum
//! and angular momentum are kept.

use super::context::Context;
use super::impact_frame::ImpactFrame;
use super::surface_collision::{Side, Touch, sliding_of};
use crate::law::{Impact, Outcome, Rule, SurfaceContact};
use crate::particle::{Body, Partner};
use crate::scalar::{Axial, Scalar, Vector, moment, norm};

/// What friction does to the first of two in half a contact, and q.
pub(super) struct Friction<S: Scalar, const D: usize> {
    half: Vector<S, D>,
    /// How far the contact is from the centre, in units of R. Of two grains one: half is what they have at a distance of
    /// R₁ + R₂, where angular momentum is counted.
    arm: S,
    q: S,
}

/// A grain's number and itself.
type Numbered<'a, S, const D: usize> = (usize, &'a Body<S, D>);

/// Whether a contact is one that friction acts in.
pub(super) enum Surfaces<S: Scalar, const D: usize> {
    Smooth,
    Rough(Friction<S, D>),
    /// What friction does there only integration knows.
    Unknown,
}

impl<S: Scalar, const D: usize> Surfaces<S, D> {
    /// Of a body and what it touches, along this normal from there; of a plane there is no second.
    #[inline(always)]
    pub fn new(
        context: &Context<'_, '_, S, D>,
        rule: &impl Rule<S>,
        bodies: (Numbered<'_, S, D>, Option<Numbered<'_, S, D>>),
        touch: impl FnOnce() -> (Vector<S, D>, Impact<S>),
    ) -> Self {
        let Some(q) = rule.inertia() else { return Self::Smooth };
        let (normal, impact) = touch();
        let half = half(context, rule, bodies, (&normal, &impact), q);
        half.map_or(Self::Unknown, Self::Rough)
    }
}

#[inline(never)]
fn half<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    ((i, a), other): (Numbered<'_, S, D>, Option<Numbered<'_, S, D>>),
    (normal, impact): (&Vector<S, D>, &Impact<S>),
    q: S,
) -> Option<Friction<S, D>> {
    let contact = SurfaceContact::new(rule, impact)?;
    let apart = contact.distance;
    // Two nearer each other move faster about each other; their arms are shorter.
    let nearer = if other.is_some() { apart } else { S::one() };
    let side = |x: usize, body: &Body<S, D>| Side {
        body: Body { velocity: body.velocity / nearer, ..*body },
        rotation: context.particles.rotation.velocity::<D>(x) * apart,
    };
    let second = other.map(|(k, b)| side(k, b));
    let with = other.map_or(Partner::NOTHING, |(k, _)| Partner::grain(k));
    let touch = Touch { grain: i, with, normal: *normal, change: S::zero() };
    let slip = sliding_of(context, &touch, &side(i, a), second.as_ref());
    let speed = norm(&slip);
    let impulse = match speed > S::zero() {
        true => contact.impulse(rule, impact, speed)? * impact.reduced_mass,
        false => S::zero(),
    };
    let half = slip * -(impulse * nearer * S::half());
    Some(Friction { half, arm: if other.is_some() { S::one() } else { apart }, q })
}

impl<S: Scalar, const D: usize> Friction<S, D> {
    /// Two grains after the first half.
    pub fn begin(&self, [a, b]: &[Body<S, D>; 2]) -> [Body<S, D>; 2] {
        let pushed = |body: &Body<S, D>, impulse: Vector<S, D>| {
            let velocity = body.velocity + impulse / body.mass;
            Body { velocity, ..*body }
        };
        [pushed(a, self.half), pushed(b, -self.half)]
    }

    /// One that touches a plane after the first half.
    pub fn begin_with_plane(&self, body: &Body<S, D>) -> Body<S, D> {
        Body { velocity: body.velocity + self.half / body.mass, ..*body }
    }

    /// The second half of two whose contact has begun: what E^v will add, and how both turn.
    pub fn end(
        &self,
        context: &mut Context<'_, '_, S, D>,
        who: [usize; 2],
        (frame, outcome): (&ImpactFrame<S, D>, &Outcome<S>),
        reach: S,
    ) {
        let (there, _) = frame.after(reach, outcome);
        let later = frame.turned(&self.half, outcome.angle);
        let torque = moment(&frame.e_r(), &self.half) + moment(&(there / reach), &later);
        for (x, impulse) in who.into_iter().zip([later, -later]) {
            self.leave(context, x, impulse);
            self.turn(context, x, torque);
        }
    }

    /// The same of one that touches a plane.
    pub fn end_with_plane(
        &self,
        context: &mut Context<'_, '_, S, D>,
        grain: usize,
        normal: &Vector<S, D>,
    ) {
        self.leave(context, grain, self.half);
        self.turn(context, grain, moment(normal, &(self.half + self.half)));
    }

    fn leave(&self, context: &mut Context<'_, '_, S, D>, x: usize, impulse: Vector<S, D>) {
        if let Some(body) = context.particles.bodies.get_mut(x) {
            body.velocity_change += impulse / body.mass;
        }
    }

    fn turn(&self, context: &mut Context<'_, '_, S, D>, x: usize, torque: Axial<S>) {
        let Some(body) = context.particles.body(x) else { return };
        let turn = torque * (self.arm / (self.q * body.mass) / body.radius);
        let rotation = context.particles.rotation.velocity::<D>(x) - turn;
        context.particles.rotation.set_velocity::<D>(x, &rotation);
    }
}
