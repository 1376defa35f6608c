//! What does a slow collision with a supported grain leave? Reads both grains and their supports; writes velocities.

use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::instantaneous_collision;
use super::support::{effective_gravity, unsupported_part};
use super::wake::kick;
use crate::error::Error;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, WideProduct, norm};

/// An elastic collision of two grains of which each moves only as its supports let it, and no slower
/// than a quarter of what is slow: else one that slides down another would hop ever faster.
pub(super) fn collide<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    frame: &ImpactFrame<S, D>,
) -> Result<EventOutcome<S>, Error> {
    let [a, b] = pair;
    let [i, k] = who;
    let e = frame.e_r();
    let to_a = free_part(context, (i, a), e, k);
    let to_b = free_part(context, (k, b), -e, i);
    let mobility = S::dot(&e, &to_a).divided_by(a.mass) - S::dot(&e, &to_b).divided_by(b.mass);
    let largest = S::one() / a.mass + S::one() / b.mass;
    if !(mobility > largest * S::from_f32(1e-4)) {
        return instantaneous_collision::collide(context, who, pair, frame, (S::one(), true));
    }
    let g = effective_gravity(context, if a.is_supported() { a } else { b });
    let least = norm(&g) * context.parameters.min_hop_time * S::from_f32(0.125);
    let approach = -frame.radial;
    let impulse = (approach + approach.max(least)) / mobility;
    context.count(Incident::SupportedCollision);
    for (x, body, to) in [(i, a, to_a), (k, b, to_b)] {
        kick(context, x, body, to * (impulse / body.mass));
    }
    Ok(EventOutcome::Collision { restitution: S::one() })
}

/// What is left of a push on a grain: nothing if it lies still.
fn free_part<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    (x, body): (usize, &Body<S, D>),
    push: Vector<S, D>,
    other: usize,
) -> Vector<S, D> {
    match (body.is_asleep(), body.is_supported()) {
        (true, _) => Vector::zeros(),
        (_, true) => unsupported_part(context, (x, body), push, Some(other)),
        _ => push,
    }
}
