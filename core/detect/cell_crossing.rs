//! When does a grain get out of reach of the neighbours that were looked at? Reads body and cells; writes nothing.

use super::bracketed_root::{Found, Search};
use super::scheduled_event::{EventKind, ScheduledEvent};
use super::{number_range, plate_acceleration, root};
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, component};
use crate::space::{Boundary, CellFace, Domain, Grid, Particles, flight};

/// When the body gets out of reach of the neighbours that were looked at: it crosses into another cell,
/// or, without cells, has flown so far that another image may be the nearest. Where that is visibly after a limit
/// it may say nothing.
#[cfg_attr(feature = "alloc", inline)]
#[cfg_attr(not(feature = "alloc"), inline(never))]
pub(super) fn out_of_reach<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    (now, limit): (S, S),
    me: &Body<S, D>,
    (at, free): (&[u32; D], [&Vector<S, D>; 2]),
) -> ScheduledEvent<S> {
    let first = match &particles.cells.grid {
        Some(grid) => crossing(domain, (now, limit), (grid, at), me, free),
        None => {
            let span = boundary_sentinel(domain, now, me, particles.largest_radius);
            span.map(|span| (span, EventKind::BoundarySentinel, ScheduledEvent::<S>::NO_FACE))
        }
    };
    let Some((span, kind, face)) = number_range::within(domain, now, me, first) else {
        return ScheduledEvent::NONE;
    };
    ScheduledEvent { face, ..ScheduledEvent::alone(now + span, kind) }
}

/// When the grain leaves its cell, and through which face.
///
/// The faces obey the rule for planes: a grain that rounding has put just outside its cell crosses
/// at once if it flies outwards, and not at all if it flies back in.
#[inline]
fn crossing<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    (now, limit): (S, S),
    (grid, at): (&Grid<S, D>, &[u32; D]),
    body: &Body<S, D>,
    [position, velocity]: [&Vector<S, D>; 2],
) -> Option<(S, EventKind, u8)> {
    if body.is_supported() {
        return supported_crossing(domain, now, grid, &flight::at(body, domain, now));
    }
    let mut first = (S::NEVER, ScheduledEvent::<S>::NO_FACE);
    let margin = body.radius * S::from_f32(1.0 / 256.0);
    for axis in 0..D {
        let [x, v, a] = [position, velocity, domain.gravity()].map(|v| component(v, axis));
        if a == S::zero() {
            let face = CellFace { axis, up: v > S::zero() };
            let (place, is_open) = grid.face_ahead(at, face);
            let span = ((place - x) / v).max(S::zero());
            keep_sooner(&mut first, span, face, is_open & (v != S::zero()));
            continue;
        }
        let [low, high] = grid.faces(at, axis, x);
        for (gap, v, a, up) in [(low, v, a, false), (high, -v, -a, true)] {
            let near = |gap: &S| !root::stays_above(margin, [*gap, v, a], limit - now);
            if let Some(span) = gap.filter(near).and_then(|gap| root::plane(gap, v, a)) {
                keep_sooner(&mut first, span, CellFace { axis, up }, true);
            }
        }
    }
    let is_found = first.1 != ScheduledEvent::<S>::NO_FACE;
    is_found.then_some((first.0, EventKind::CellCrossing, first.1))
}

/// Keeps the face that is crossed first, if it can be crossed: without a branch, for nobody can guess.
#[inline(always)]
fn keep_sooner<S: Scalar>(first: &mut (S, u8), span: S, face: CellFace, is_open: bool) {
    // Whether it is open can be guessed, which is sooner cannot: a minimum is one instruction.
    let span = if is_open { span } else { S::NEVER };
    first.1 = if span < first.0 { face.code() } else { first.1 };
    first.0 = first.0.min(span);
}

/// The same for a body that something supports, as it is now.
fn supported_crossing<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    grid: &Grid<S, D>,
    me: &Body<S, D>,
) -> Option<(S, EventKind, u8)> {
    let mut first = None::<(S, EventKind, u8)>;
    let acceleration = flight::acceleration(me, domain);
    let at = grid.coordinates(me.cell);
    let motion = me.position.iter().zip(me.velocity.iter()).zip(acceleration.iter());
    for (axis, ((&x, &v), &a)) in motion.enumerate() {
        let [low, high] = grid.faces(&at, axis, x);
        let shaken = plate_acceleration::is_shaken(domain, me, axis);
        for (gap, up) in [(low, false), (high, true)] {
            let Some(gap) = gap else { continue };
            let (v, a) = if up { (-v, -a) } else { (v, a) };
            let face = CellFace { axis, up };
            let found = match shaken {
                true => shaken_crossing(domain, now, me, (face, gap)),
                false => root::plane(gap, v, a).map_or(Found::Nothing, Found::Event),
            };
            let next = match found {
                Found::Event(span) => (span, EventKind::CellCrossing, face.code()),
                Found::NotBefore(span) => (span, EventKind::Recheck, ScheduledEvent::<S>::NO_FACE),
                Found::Nothing => continue,
            };
            if first.is_none_or(|least| next.0 < least.0) {
                first = Some(next);
            }
        }
    }
    first
}

/// When a body that a plate carries crosses a face of its cell, now at this distance.
fn shaken_crossing<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    (CellFace { axis, up }, gap): (CellFace, S),
) -> Found<S> {
    let along = |v: &Vector<S, D>| {
        let x = v.get(axis).copied().unwrap_or(S::zero());
        if up { -x } else { x }
    };
    let (start, a) = (along(&me.position), along(&flight::acceleration(me, domain)).abs());
    let bound = a + plate_acceleration::peak_acceleration(domain, me);
    let bound = bound.max(S::negligible_acceleration(me.radius));
    Search::new([bound; 2], me.radius, S::NEVER).first(|t| {
        let there = flight::at(me, domain, now + t);
        (gap + (along(&there.position) - start), along(&there.velocity))
    })
}

/// When the grain has flown so far along a periodic axis that another image may be the nearest. No plate
/// moves along one.
fn boundary_sentinel<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    body: &Body<S, D>,
    largest_radius: S,
) -> Option<S> {
    let mut first = None::<S>;
    let me = flight::at(body, domain, now);
    let acceleration = flight::acceleration(&me, domain);
    let at_rest = |axis| domain.boundary.at_rest(axis).map(|periodic| (axis, periodic));
    for (axis, periodic) in (0..D).filter_map(at_rest) {
        let far = Boundary::<S, D>::max_displacement(&periodic, largest_radius);
        let (v, a) = (me.velocity.get(axis), acceleration.get(axis));
        let span = v.zip(a).and_then(|(&v, &a)| root::leaving(far, v, a));
        first = match (first, span) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
    }
    first
}
