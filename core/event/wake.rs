//! What lets a grain at rest go? Reads supports; writes bodies that are held no longer, and counters.
//!
//! It wakes when it is hit faster than slowly, when what holds it moves, or when its plate falls away.

use super::apply::{Affected, Deed};
use super::scene::Scene;
use super::support::{felt, give, is_nothing, size, unseen};
use crate::matter::Body;
use crate::number::{Scalar, Vector, dot, norm};

/// Adds to a body's velocity. What it was pushed off or into holds it no longer.
pub(super) fn push<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    body: &Body<S, D>,
    change: Vector<S, D>,
    affected: &mut Affected,
) {
    if body.is_frozen() && !(norm(&change) > S::zero()) {
        return;
    }
    let mut pushed = Body { velocity: body.velocity + change, moment: scene.now, ..*body };
    if body.is_held() {
        let was_frozen = body.is_frozen();
        pushed = pushed.let_go();
        for (p, plane) in scene.boundary.planes().iter().enumerate() {
            let near = unseen(size(body)) * S::from_f32(8.0);
            let lies = plane.gap(&body.position, body.radius, scene.now) <= near;
            if body.rests_on(p) && lies && dot(&plane.normal, &change) == S::zero() {
                pushed = pushed.resting_on(p);
            }
        }
        if was_frozen || pushed.planes != body.planes {
            grain(scene, x, affected);
        }
    }
    scene.place(x, pushed);
}

/// A grain that was at rest is not any more.
pub(super) fn grain<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    affected: &mut Affected,
) {
    scene.counters.take_offs += 1;
    affected.wakes(x);
}

/// The plate that carries grain `i` falls away faster than the grain does.
pub(crate) fn take_off<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) -> Deed<S> {
    affected.again(i);
    let free = scene.present(i).let_go();
    scene.place(i, free);
    grain(scene, i, affected);
    Deed::TakeOff
}

/// Something next to grain `i` has moved: is it still held?
pub(crate) fn check<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) -> Deed<S> {
    affected.again(i);
    let body = scene.present(i);
    let g = felt(scene, &body);
    if !body.is_frozen() || is_nothing(&give(scene, (i, &body), g, None), &g) {
        return Deed::Wander;
    }
    take_off(scene, i, affected)
}
