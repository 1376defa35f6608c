//! What do rough surfaces do in an instantaneous collision? Reads how they move against each other; writes velocities and rotation.
//!
//! Smooth grains pass by: where the rule says so at compile time, nothing of this file is in the program.

use super::context::Context;
use crate::law::Rule;
use crate::particle::{Body, Partner};
use crate::scalar::{Axial, Scalar, Vector, moment, norm, sliding};

/// Who touches: a grain and a grain or a plane, and how.
pub(super) struct Touch<S: Scalar, const D: usize> {
    pub grain: usize,
    pub with: Partner,
    /// Of unit length, from the partner to the grain.
    pub normal: Vector<S, D>,
    /// By how much the velocity along the normal changed: (1 + ε) v_n.
    pub change: S,
}

/// The surfaces of two act on each other, whose velocities along the normal have changed already.
#[inline(always)]
pub(super) fn act<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    touch: impl FnOnce() -> Touch<S, D>,
) {
    if let Some(inertia) = rule.inertia() {
        act_on(context, rule, inertia, &touch());
    }
}

/// One of the two, and how far its centre is from the contact.
pub(super) struct Side<S: Scalar, const D: usize> {
    pub body: Body<S, D>,
    pub rotation: Axial<S>,
}

fn act_on<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    q: S,
    touch: &Touch<S, D>,
) {
    let Some(first) = side(context, touch.grain) else { return };
    let second = touch.with.as_grain().and_then(|k| side(context, k));
    let Some(law) = rule.tangential(materials(context, touch, &first, second.as_ref())) else {
        return;
    };
    let slip = sliding_of(context, touch, &first, second.as_ref());
    let speed = norm(&slip);
    if !(speed > S::zero()) {
        return;
    }
    // Of all that impulses across are shared by: 1/m_t = (1 + 1/q)/m_eff.
    let effective = match &second {
        Some(second) => first.body.mass / (first.body.mass + second.body.mass) * second.body.mass,
        None => first.body.mass,
    };
    let share = q / (S::one() + q);
    let most = touch.change / share / speed;
    let impulse = slip * -(share * law.impulse(most) * effective);
    push(context, (touch.grain, &first), (&touch.normal, &impulse), q);
    if let (Some(k), Some(second)) = (touch.with.as_grain(), &second) {
        push(context, (k, second), (&-touch.normal, &-impulse), q);
    }
}

fn side<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    grain: usize,
) -> Option<Side<S, D>> {
    let body = *context.particles.body(grain)?;
    Some(Side { body, rotation: context.particles.rotation.velocity::<D>(grain) })
}

fn materials<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    touch: &Touch<S, D>,
    first: &Side<S, D>,
    second: Option<&Side<S, D>>,
) -> [u8; 2] {
    let own = first.body.material;
    match (second, touch.with.as_plane()) {
        (Some(second), _) => [own, second.body.material],
        (None, Some(p)) => {
            let plane = context.domain.boundary.planes().get(p);
            plane.map_or([own; 2], |plane| plane.surface.materials(own))
        }
        (None, None) => {
            let facet =
                touch.with.as_facet().and_then(|k| context.domain.boundary.obstacles()?.facet(k));
            facet.map_or([own; 2], |facet| facet.surface().materials(own))
        }
    }
}

/// g_t: how the surface of the first moves against that of the second, across the normal.
pub(super) fn sliding_of<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    touch: &Touch<S, D>,
    first: &Side<S, D>,
    second: Option<&Side<S, D>>,
) -> Vector<S, D> {
    let mut turning = first.rotation * first.body.radius;
    let mut velocity = first.body.velocity;
    if let Some(second) = second {
        turning += second.rotation * second.body.radius;
        velocity -= second.body.velocity;
        if let Some(image) = context.domain.image_velocity(&first.body, &second.body) {
            velocity -= image;
        }
    }
    let at = first.body.position - touch.normal * first.body.radius;
    let surface = context.domain.boundary.surface_velocity(touch.with, &at, context.now());
    if let Some(surface) = surface {
        velocity -= surface;
    }
    sliding(&velocity, &turning, &touch.normal)
}

/// An impulse on the surface of a grain, whose contact lies against this normal.
fn push<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (grain, side): (usize, &Side<S, D>),
    (normal, impulse): (&Vector<S, D>, &Vector<S, D>),
    q: S,
) {
    let body = &side.body;
    let change = *impulse / body.mass;
    context.particles.change(grain, |place| place.velocity += change);
    let turn = moment(normal, &change) / (q * body.radius);
    context.particles.rotation.set_velocity::<D>(grain, &(side.rotation - turn));
    if body.is_clustered() {
        context.clusters.speed = context.clusters.speed.max(norm(&(body.velocity + change)));
    }
}
