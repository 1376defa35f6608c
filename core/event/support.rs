//! What holds a grain, and what is left of a push on it? Reads bodies that touch; writes nothing.

use super::scene::Scene;
use crate::matter::{Body, flight};
use crate::number::{Scalar, Vector, dot, norm};

/// After so many slow collisions in a row a grain is calm enough to lie still.
pub(super) const CALM: u16 = 64;

/// After so many a slow grain that leaves a plane is laid onto it.
pub(super) const HOPPING: u16 = CALM / 4;

/// The normals of what touches a body and does not give way.
type Supports<S, const D: usize> = heapless::Vec<Vector<S, D>, 24>;

/// Hops as high as 64 units in the last place of the size are no hops.
pub(super) fn unseen<S: Scalar>(size: S) -> S {
    size.rounding() * S::from_f32(64.0)
}

/// How far from its radius rounding can put a body.
pub(super) fn size<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    body.position.iter().fold(body.radius, |far, x| far.larger(x.magnitude()))
}

/// The time below which a hop of a grain on others is none: (R/g)^½/64 in two and three dimensions.
///
/// There a grain slides down another in hops, which must not become ever shorter. In one dimension
/// nothing slides, and hops are followed down to the rounding.
pub(crate) fn hop<S: Scalar, const D: usize>(gravity: &Vector<S, D>, radius: S) -> S {
    let g = norm(gravity);
    if D == 1 || !(g > S::zero()) {
        S::zero()
    } else {
        radius.root_of_ratio(g) * S::from_f64(1.0 / 64.0)
    }
}

/// Gravity as a body feels it that moves with the plate that carries `held`.
pub(super) fn felt<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    held: &Body<S, D>,
) -> Vector<S, D> {
    let plates = flight::plates(held, scene.field());
    plates.fold(scene.gravity, |g, p| g - p.normal * p.motion(scene.now).acceleration)
}

/// The velocity of the plate that carries a body; zero if none does.
pub(super) fn carried<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
) -> Vector<S, D> {
    let plates = flight::plates(body, scene.field());
    plates.fold(Vector::zeros(), |v, p| v + p.normal * p.motion(scene.now).speed)
}

/// Surfaces this near touch: within the height of a hop, or of rounding.
fn near<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, body: &Body<S, D>) -> S {
    let g = norm(&scene.gravity);
    let longest = scene.hop.larger(scene.t_c);
    let height = g * longest * longest;
    height.smaller(body.radius * S::from_f32(0.001)) + unseen(size(body)) * S::from_f32(8.0)
}

/// What is left of a push `w` on grain `i`, standing as `body`, after its supports have taken their part:
/// the projection onto the directions in which it can move. The grain `not` does not count.
pub(super) fn give<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (i, body): (usize, &Body<S, D>),
    w: Vector<S, D>,
    not: Option<usize>,
) -> Vector<S, D> {
    let supports = supports(scene, i, body, not);
    let mut taken = [S::zero(); 24];
    let mut left = w;
    // Gauss and Seidel, over-relaxed for grains wedged between steep sides: each support takes what is
    // pressed into it and gives back what was too much.
    let (rounds, relaxed) = if D == 1 { (1, 1.0) } else { (128, 1.875) };
    for _ in 0..rounds {
        for (n, t) in supports.iter().zip(&mut taken) {
            let more = (*t - dot(&left, n) * S::from_f32(relaxed)).larger(S::zero());
            left += n * (more - *t);
            *t = more;
        }
        if is_nothing(&left, &(w * S::from_f32(0.1))) {
            break;
        }
    }
    left
}

/// The normals, towards grain `i`, of the planes and of the grains at rest (but `not`) that it touches.
fn supports<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    i: usize,
    body: &Body<S, D>,
    not: Option<usize>,
) -> Supports<S, D> {
    let mut supports = Supports::new();
    let near = near(scene, body);
    for plane in scene.boundary.planes() {
        if plane.gap(&body.position, body.radius, scene.now) <= near {
            let _ = supports.push(plane.normal);
        }
    }
    scene.cells.near(body.cell, |k| {
        let at_rest = |other: &&Body<S, D>| k != i && Some(k) != not && stands(*other);
        if scene.body(k).filter(at_rest).is_none() {
            return;
        }
        let other = scene.present(k);
        let apart = scene.separation(body, &other);
        let distance = norm(&apart);
        if distance <= body.radius + other.radius + near && distance > S::zero() {
            let _ = supports.push(apart / distance);
        }
    });
    supports
}

/// Whether a grain can hold others: it lies still, or is about to.
fn stands<S: Scalar, const D: usize>(body: &Body<S, D>) -> bool {
    body.is_frozen() || D > 1 && body.burst >= CALM / 2
}

/// Whether a part of a push this small is nothing.
pub(super) fn is_nothing<S: Scalar, const D: usize>(
    left: &Vector<S, D>,
    of: &Vector<S, D>,
) -> bool {
    S::negligible(left, of)
}

/// Whether grain `k` lies still and touches grain `i`.
pub(crate) fn lies_on<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    k: usize,
    i: usize,
) -> bool {
    if k == i || !scene.body(k).is_some_and(Body::is_frozen) {
        return false;
    }
    let (a, b) = (scene.present(i), scene.present(k));
    let apart = scene.separation(&a, &b);
    let near = near(scene, &a).larger(near(scene, &b)) * S::from_f32(2.0);
    norm(&apart) <= a.radius + b.radius + near
}
