//! When does a grain get out of reach of the neighbours that were looked at? Reads the scene; writes nothing.

use super::bracket::Found;
use super::queue::{Kind, Slot};
use super::scene::Scene;
use super::{range, root, touch};
use crate::matter::grid::{Grid, Stride};
use crate::matter::{Body, Boundary, flight};
use crate::number::{Scalar, Vector, part};

/// When the body gets out of reach of the neighbours that were looked at.
#[inline]
pub(super) fn away<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    at: &[u32; D],
    free: [&Vector<S, D>; 2],
) -> Slot<S> {
    let first = match &scene.cells.grid {
        Some(grid) => crossing(scene, (grid, at), me, free),
        None => leash(scene, me).map(|span| (span, Slot::<S>::NO_FACE)),
    };
    let Some((span, face)) = range::within(scene, me, first) else { return Slot::EMPTY };
    Slot { face, ..Slot::alone(scene.now + span, Kind::Wander) }
}

/// When the grain leaves its cell, and through which face.
///
/// The faces obey the rule for planes: a grain that rounding has put just outside its cell crosses
/// at once if it flies outwards, and not at all if it flies back in.
#[inline]
fn crossing<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (grid, at): (&Grid<S, D>, &[u32; D]),
    body: &Body<S, D>,
    [position, velocity]: [&Vector<S, D>; 2],
) -> Option<(S, u8)> {
    if body.is_held() {
        return shaken_crossing(scene, grid, &flight::at(body, scene.field(), scene.now));
    }
    let mut first = (S::NEVER, Slot::<S>::NO_FACE);
    for axis in 0..D {
        let [x, v, a] = [position, velocity, &scene.gravity].map(|vector| part(vector, axis));
        if a == S::zero() {
            let stride = Stride { axis, up: v > S::zero() };
            let (face, is_open) = grid.face_ahead(at, stride);
            let span = ((face - x) / v).larger(S::zero());
            sooner(&mut first, span, stride, is_open & (v != S::zero()));
            continue;
        }
        let [low, high] = grid.faces(at, axis, x);
        for (gap, v, a, up) in [(low, v, a, false), (high, -v, -a, true)] {
            if let Some(span) = gap.and_then(|gap| root::plane(gap, v, a)) {
                sooner(&mut first, span, Stride { axis, up }, true);
            }
        }
    }
    (first.1 != Slot::<S>::NO_FACE).then_some(first)
}

/// Keeps the face that is crossed first, if it can be crossed: without a branch, for nobody can guess.
#[inline(always)]
fn sooner<S: Scalar>(first: &mut (S, u8), span: S, stride: Stride, is_open: bool) {
    let sooner = is_open & (span < first.0);
    first.0 = if sooner { span } else { first.0 };
    first.1 = if sooner { stride.code() } else { first.1 };
}

/// The same for a body that something holds, as it is now.
fn shaken_crossing<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    grid: &Grid<S, D>,
    me: &Body<S, D>,
) -> Option<(S, u8)> {
    let mut first = None::<(S, u8)>;
    let acceleration = flight::acceleration(me, scene.field());
    let at = grid.coordinates(me.cell);
    let motion = me.position.iter().zip(me.velocity.iter()).zip(acceleration.iter());
    for (axis, ((&x, &v), &a)) in motion.enumerate() {
        let [low, high] = grid.faces(&at, axis, x);
        let shaken = touch::is_shaken(scene, me, axis);
        for (gap, up) in [(low, false), (high, true)] {
            let Some(gap) = gap else { continue };
            let (v, a) = if up { (-v, -a) } else { (v, a) };
            let found = match shaken {
                true => touch::shaken_face(scene, me, axis, gap, up),
                false => root::plane(gap, v, a).map_or(Found::Nothing, Found::Event),
            };
            let (span, face) = match found {
                Found::Event(span) => (span, Stride { axis, up }.code()),
                Found::NotBefore(span) => (span, Slot::<S>::NO_FACE),
                Found::Nothing => continue,
            };
            if first.is_none_or(|(least, _)| span < least) {
                first = Some((span, face));
            }
        }
    }
    first
}

/// When the grain has flown to the end of its leash along a periodic axis. No plate moves along one.
fn leash<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, body: &Body<S, D>) -> Option<S> {
    let mut first = None::<S>;
    let me = flight::at(body, scene.field(), scene.now);
    let acceleration = flight::acceleration(&me, scene.field());
    for (axis, periodic) in scene.boundary.periodic_axes() {
        let far = Boundary::<S, D>::leash(&periodic, scene.largest_radius);
        let (v, a) = (me.velocity.get(axis), acceleration.get(axis));
        let span = v.zip(a).and_then(|(&v, &a)| root::leaving(far, v, a));
        first = match (first, span) {
            (Some(a), Some(b)) => Some(a.smaller(b)),
            (a, b) => a.or(b),
        };
    }
    first
}
