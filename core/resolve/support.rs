//! What supports a grain, and what is left of a push on it? Reads bodies that touch; writes nothing.

use super::context::Context;
use super::parameters::Parameters;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot, norm};
use crate::space::{Domain, Particles, flight};

/// After so many slow collisions in a row a grain is slow enough to fall asleep.
pub(super) const BEFORE_SLEEP: u16 = 64;

/// After so many a slow grain that leaves a plane is laid onto it.
pub(super) const BEFORE_LANDING: u16 = BEFORE_SLEEP / 4;

/// The normals of what touches a body and does not give way.
type Supports<S, const D: usize> = heapless::Vec<Vector<S, D>, 24>;

/// Hops as high as 64 units in the last place of the size are no hops.
pub(super) fn rounding_height<S: Scalar>(size: S) -> S {
    size.rounding() * S::from_f32(64.0)
}

/// How far from its radius rounding can put a body.
pub(super) fn coordinate_scale<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    body.position.iter().fold(body.radius, |far, x| far.max(x.abs()))
}

/// The time below which a hop of a grain on others is none: (R/g)^½/64 in two and three dimensions.
///
/// There a grain slides down another in hops, which must not become ever shorter. In one dimension
/// nothing slides, and hops are followed down to the rounding.
pub(crate) fn min_hop_time<S: Scalar, const D: usize>(gravity: &Vector<S, D>, radius: S) -> S {
    let g = norm(gravity);
    if D == 1 || !(g > S::zero()) {
        S::zero()
    } else {
        radius.sqrt_of_ratio(g) * S::from_f64(1.0 / 64.0)
    }
}

/// Gravity as a body feels it that moves with the plate that carries `carried`.
pub(super) fn effective_gravity<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    carried: &Body<S, D>,
) -> Vector<S, D> {
    let plates = flight::carrying_plates(carried, context.domain);
    plates
        .fold(*context.domain.gravity(), |g, p| g - p.normal * p.motion(context.now()).acceleration)
}

/// The velocity of the plate that carries a body; zero if none does.
pub(super) fn carrier_velocity<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
) -> Vector<S, D> {
    let plates = flight::carrying_plates(body, context.domain);
    plates.fold(Vector::zeros(), |v, p| v + p.normal * p.motion(context.now()).speed)
}

/// Surfaces this near touch: within the height of a hop, or of rounding.
fn contact_tolerance<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    parameters: &Parameters<S, D>,
    body: &Body<S, D>,
) -> S {
    let g = norm(domain.gravity());
    let longest = parameters.min_hop_time.max(parameters.t_c);
    let height = g * longest * longest;
    let rounding = rounding_height(coordinate_scale(body)) * S::from_f32(8.0);
    height.min(body.radius * S::from_f32(0.001)) + rounding
}

/// What is left of a push `w` on grain `i`, standing as `body`, after its supports have taken their part:
/// the projection onto the directions in which it can move. The grain `not` does not count.
pub(super) fn unsupported_part<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    (i, body): (usize, &Body<S, D>),
    w: Vector<S, D>,
    not: Option<usize>,
) -> Vector<S, D> {
    let supports = supports(context, i, body, not);
    let mut taken = [S::zero(); 24];
    let mut left = w;
    // Gauss and Seidel, over-relaxed for grains wedged between steep sides: each support takes what is
    // pressed into it and gives back what was too much.
    let (rounds, relaxed) = if D == 1 { (1, 1.0) } else { (128, 1.875) };
    for _ in 0..rounds {
        for (n, t) in supports.iter().zip(&mut taken) {
            let more = (*t - dot(&left, n) * S::from_f32(relaxed)).max(S::zero());
            left += n * (more - *t);
            *t = more;
        }
        if is_negligible(&left, &(w * S::from_f32(0.1))) {
            break;
        }
    }
    left
}

/// The normals, towards grain `i`, of the planes and of the grains at rest (but `not`) that it touches.
fn supports<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    i: usize,
    body: &Body<S, D>,
    not: Option<usize>,
) -> Supports<S, D> {
    let mut supports = Supports::new();
    let near = contact_tolerance(context.domain, context.parameters, body);
    for plane in context.domain.boundary.planes() {
        if plane.gap(&body.position, body.radius, context.now()) <= near {
            let _ = supports.push(plane.normal);
        }
    }
    context.particles.cells.for_each_near(body.cell, body.radius, |k| {
        let at_rest = |other: &&Body<S, D>| k != i && Some(k) != not && can_support(*other);
        if context.particles.body(k).filter(at_rest).is_none() {
            return;
        }
        let other = context.present(k);
        let apart = context.domain.separation(body, &other, context.now());
        let distance = norm(&apart);
        if distance <= body.radius + other.radius + near && distance > S::zero() {
            let _ = supports.push(apart / distance);
        }
    });
    supports
}

/// Whether a grain can hold others: it lies still, or is about to.
fn can_support<S: Scalar, const D: usize>(body: &Body<S, D>) -> bool {
    body.is_asleep() || D > 1 && body.consecutive_collisions >= BEFORE_SLEEP / 2
}

/// Whether a part of a push this small is nothing.
pub(super) fn is_negligible<S: Scalar, const D: usize>(
    left: &Vector<S, D>,
    of: &Vector<S, D>,
) -> bool {
    S::is_negligible(left, of)
}

/// Whether grain `k` lies still and touches grain `i`.
pub(crate) fn lies_on<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    (now, parameters): (S, &Parameters<S, D>),
    [k, i]: [usize; 2],
) -> bool {
    if k == i || !particles.body(k).is_some_and(Body::is_asleep) {
        return false;
    }
    let [a, b] = [i, k].map(|grain| particles.present(grain, domain, now));
    let apart = domain.separation(&a, &b, now);
    let near = |body| contact_tolerance(domain, parameters, body);
    norm(&apart) <= a.radius + b.radius + near(&a).max(near(&b)) * S::from_f32(2.0)
}
