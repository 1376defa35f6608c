//! When is a grain's next event? Reads the scene; writes nothing, returns the earliest slot.

use super::bracket::Found;
use super::queue::{Kind, Slot};
use super::root;
use super::scene::Scene;
use super::touch;
use crate::matter::grid::{Grid, Stride};
use crate::matter::{Body, Boundary, Partner, flight};
use crate::number::{Scalar, largest};

/// The earliest event of this grain.
pub(crate) fn next<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, grain: usize) -> Slot<S> {
    let me = scene.present(grain);
    let mut slot = own(scene, &me);
    let wander = wander(scene, &me);
    let least = |slot: &Slot<S>| slot.time.smaller(wander.time) - scene.now;
    for k in scene.cells.near(me.cell) {
        let Some(other) = scene.body(k).filter(|_| k != grain) else { continue };
        if me.partner == Partner::grain(k) && other.partner == Partner::grain(grain) {
            continue;
        }
        let found = touch::pair(scene, &me, other, least(&slot));
        let from = not_before(&me).larger(not_before(other));
        meeting(scene, &mut slot, found, from, Partner::grain(k));
    }
    for (p, plane) in scene.boundary.planes().iter().enumerate() {
        if me.partner != Partner::plane(p) && !me.rests_on(p) {
            let found = touch::plane(scene, &me, plane, least(&slot));
            meeting(scene, &mut slot, found, not_before(&me), Partner::plane(p));
        }
    }
    earlier(&mut slot, wander);
    if let Some(span) = S::horizon(largest(&me.velocity), largest(&scene.gravity)) {
        earlier(&mut slot, look_again(scene, span));
    }
    slot
}

/// The stamp of a look around that crosses no face.
const NO_FACE: u32 = u32::MAX;

/// What happens to a body by itself: its contact ends, or its plate falls away.
fn own<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Slot<S> {
    if me.in_contact() {
        return Slot::alone(me.release_at, Kind::Release);
    }
    match touch::take_off(scene, me) {
        Found::Event(span) => Slot::alone(scene.now + span, Kind::TakeOff),
        Found::NotBefore(span) => look_again(scene, span),
        Found::Nothing => Slot::EMPTY,
    }
}

fn look_again<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, span: S) -> Slot<S> {
    Slot { stamp: NO_FACE, ..Slot::alone(scene.now + span, Kind::Wander) }
}

/// When the body gets out of reach of the neighbours that were looked at.
fn wander<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Slot<S> {
    let first = match &scene.cells.grid {
        Some(grid) => crossing(scene, grid, me),
        None => leash(scene, me).map(|span| (span, NO_FACE)),
    };
    first.map_or(Slot::EMPTY, |(span, stamp)| Slot {
        stamp,
        ..Slot::alone(scene.now + span, Kind::Wander)
    })
}

/// Whether a predicted event is void because the partner's trajectory has changed since.
pub(crate) fn is_stale<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, slot: &Slot<S>) -> bool {
    let partner = slot.partner.as_grain().and_then(|k| scene.body(k));
    partner.is_some_and(|body| body.stamp != slot.stamp)
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
    let acceleration = flight::acceleration(me, scene.field());
    let motion = me.position.iter().zip(me.velocity.iter()).zip(acceleration.iter());
    for (axis, ((&x, &v), &a)) in motion.enumerate() {
        let [low, high] = grid.faces(me.cell, axis, x);
        let shaken = touch::is_shaken(scene, me, axis);
        for (gap, up) in [(low, false), (high, true)] {
            let Some(gap) = gap else { continue };
            let (v, a) = if up { (-v, -a) } else { (v, a) };
            let code = Stride { axis, up }.code();
            let found = match shaken {
                true => touch::shaken_face(scene, me, axis, gap, up),
                false => root::plane(gap, v, a).map_or(Found::Nothing, Found::Event),
            };
            let (span, code) = match found {
                Found::Event(span) => (span, code),
                Found::NotBefore(span) => (span, NO_FACE),
                Found::Nothing => continue,
            };
            if first.is_none_or(|(least, _)| span < least) {
                first = Some((span, code));
            }
        }
    }
    first
}

/// When the grain has flown to the end of its leash along a periodic axis. No plate moves along one.
fn leash<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Option<S> {
    let mut first = None::<S>;
    let acceleration = flight::acceleration(me, scene.field());
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

/// The first instant at which a third body may end the contact that a body is in.
///
/// Without it two contacts could end each other for ever at one instant, and soft grains in a corner
/// would collapse as hard ones do.
fn not_before<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    if body.in_contact() { body.moment } else { S::zero() }
}

/// Takes the meeting into account: not before `from`, and a look again where the search paused.
fn meeting<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    slot: &mut Slot<S>,
    found: Found<S>,
    from: S,
    partner: Partner,
) {
    match found {
        Found::Event(span) => {
            let stamp = partner.as_grain().and_then(|k| scene.body(k)).map_or(0, |b| b.stamp);
            let time = (scene.now + span).larger(from);
            earlier(slot, Slot { time, kind: Kind::Meet, partner, stamp });
        }
        Found::NotBefore(span) => earlier(slot, look_again(scene, span)),
        Found::Nothing => {}
    }
}

/// Keeps the earlier of two; at equal times a contact's end, then the lower partner, so that the order
/// in which neighbours are visited does not matter. NaN and infinity never win, nor what lies beyond
/// the instants that there are.
fn earlier<S: Scalar>(slot: &mut Slot<S>, candidate: Slot<S>) {
    if candidate.time > S::LAST {
        return;
    }
    let tie = candidate.time == slot.time
        && slot.kind == Kind::Meet
        && candidate.kind == Kind::Meet
        && candidate.partner.word() < slot.partner.word();
    if candidate.time < slot.time || tie {
        *slot = candidate;
    }
}
