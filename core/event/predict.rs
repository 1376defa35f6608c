//! When is a grain's next event? Reads the scene; writes nothing, returns the earliest slot.

use super::queue::{Kind, Slot};
use super::root;
use super::scene::Scene;
use crate::matter::grid::{Grid, Stride};
use crate::matter::{Body, Boundary, Partner, Plane, flight};
use crate::number::Scalar;

/// The earliest event of this grain.
pub(crate) fn next<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, grain: usize) -> Slot<S> {
    let me = scene.present(grain);
    let mut slot = release(&me);
    for k in scene.cells.near(me.cell) {
        let Some(other) = scene.body(k).filter(|_| k != grain) else { continue };
        if me.partner == Partner::grain(k) && other.partner == Partner::grain(grain) {
            continue;
        }
        if let Some(span) = pair(scene, &me, other) {
            let from = not_before(&me).larger(not_before(other));
            earlier(&mut slot, meeting(scene, span, from, Partner::grain(k)));
        }
    }
    for (p, plane) in scene.boundary.planes().iter().enumerate() {
        if let Some(span) = against(scene, &me, p, plane) {
            earlier(&mut slot, meeting(scene, span, not_before(&me), Partner::plane(p)));
        }
    }
    let wander = match &scene.cells.grid {
        Some(grid) => crossing(scene, grid, &me),
        None => leash(scene, &me).map(|span| (span, 0)),
    };
    if let Some((span, stamp)) = wander {
        let wander = Slot { stamp, ..Slot::alone(scene.now + span, Kind::Wander) };
        earlier(&mut slot, wander);
    }
    slot
}

/// Whether a predicted event is void because the partner's trajectory has changed since.
pub(crate) fn is_stale<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, slot: &Slot<S>) -> bool {
    let partner = slot.partner.as_grain().and_then(|k| scene.body(k));
    partner.is_some_and(|body| body.stamp != slot.stamp)
}

/// When the two touch: BSFP14's rule. Uniform gravity leaves their relative motion straight.
///
/// A pair in contact has one velocity copied twice; it is skipped by the caller so that rounding of
/// two clocks cannot make it meet itself.
fn pair<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    other: &Body<S, D>,
) -> Option<S> {
    let span = scene.now - other.clock;
    let position = flight::position_after(other, &scene.gravity, span);
    let velocity = me.velocity - flight::velocity_after(other, &scene.gravity, span);
    let separation = scene.boundary.nearest(me.position - position);
    root::spheres(&separation, &velocity, me.radius + other.radius)
}

/// When the grain touches a plane. The plane it is in contact with does not count.
fn against<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    me: &Body<S, D>,
    number: usize,
    plane: &Plane<S, D>,
) -> Option<S> {
    if me.partner == Partner::plane(number) {
        return None;
    }
    let gap = plane.gap(&me.position, me.radius);
    root::plane(gap, plane.normal.dot(&me.velocity), plane.normal.dot(&scene.gravity))
}

/// When the grain leaves its cell, and through which face.
///
/// The faces obey the rule for planes: a grain that rounding has put just outside its cell crosses
/// at once if it flies outwards, and not at all if it flies back in.
fn crossing<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    grid: &Grid<S, D>,
    me: &Body<S, D>,
) -> Option<(S, u32)> {
    let mut first = None::<(S, u32)>;
    let motion = me.position.iter().zip(me.velocity.iter()).zip(scene.gravity.iter());
    for (axis, ((&x, &v), &g)) in motion.enumerate() {
        let [low, high] = grid.faces(me.cell, axis, x);
        let down = low.and_then(|gap| root::plane(gap, v, g)).map(|t| (t, false));
        let up = high.and_then(|gap| root::plane(gap, -v, -g)).map(|t| (t, true));
        for (span, up) in [down, up].into_iter().flatten() {
            if first.is_none_or(|(least, _)| span < least) {
                first = Some((span, Stride { axis, up }.code()));
            }
        }
    }
    first
}

/// When the grain has flown to the end of its leash along a periodic axis.
fn leash<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Option<S> {
    let mut first = None::<S>;
    for (axis, periodic) in scene.boundary.periodic_axes() {
        let far = Boundary::<S, D>::leash(&periodic, scene.largest_radius);
        let (v, g) = (me.velocity.get(axis), scene.gravity.get(axis));
        let span = v.zip(g).and_then(|(&v, &g)| root::leaving(far, v, g));
        first = match (first, span) {
            (Some(a), Some(b)) => Some(a.smaller(b)),
            (a, b) => a.or(b),
        };
    }
    first
}

fn release<S: Scalar, const D: usize>(me: &Body<S, D>) -> Slot<S> {
    if me.in_contact() { Slot::alone(me.release_at, Kind::Release) } else { Slot::EMPTY }
}

/// The first instant at which a third body may end the contact that a body is in.
///
/// Without it two contacts could end each other for ever at one instant, and soft grains in a corner
/// would collapse as hard ones do.
fn not_before<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    if body.in_contact() { body.unbroken_until } else { S::zero() }
}

fn meeting<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    span: S,
    from: S,
    partner: Partner,
) -> Slot<S> {
    let stamp = partner.as_grain().and_then(|k| scene.body(k)).map_or(0, |body| body.stamp);
    Slot { time: (scene.now + span).larger(from), kind: Kind::Meet, partner, stamp }
}

/// Keeps the earlier of two; at equal times a contact's end, then the lower partner, so that the order
/// in which neighbours are visited does not matter. NaN and infinity never win.
fn earlier<S: Scalar>(slot: &mut Slot<S>, candidate: Slot<S>) {
    let tie = candidate.time == slot.time
        && slot.kind == Kind::Meet
        && candidate.kind == Kind::Meet
        && candidate.partner.word() < slot.partner.word();
    if candidate.time < slot.time || tie {
        *slot = candidate;
    }
}
