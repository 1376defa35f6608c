//! When is a grain's next event? Reads the scene; writes nothing, returns the earliest slot.

use super::bracket::Found;
use super::queue::{Kind, Slot};
use super::root;
use super::scene::Scene;
use super::{range, touch};
use crate::matter::grid::{Grid, Stride};
use crate::matter::{Body, Boundary, Partner, flight};
use crate::number::{Scalar, Vector};

/// The earliest event of this grain.
///
/// Meetings of grains that nothing holds depend on the two alone, not on when one asks: whatever
/// finds neighbours, the same events come at the same bits.
pub(crate) fn next<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, grain: usize) -> Slot<S> {
    let Some(look) = Look::from(scene, grain) else { return Slot::EMPTY };
    let mut slot = Slot::EMPTY;
    scene.cells.near(look.me.cell, |k, image| look.pair(&mut slot, k, image));
    look.planes(&mut slot);
    look.earliest(slot)
}

/// The earliest event of a grain that has just come into a cell: its meeting is kept, and only the
/// grains ahead are new.
pub(crate) fn ahead<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    grain: usize,
    slot: Slot<S>,
) -> Slot<S> {
    if scene.held > 0 || slot.face == Slot::<S>::NO_FACE {
        return next(scene, grain);
    }
    let Some(look) = Look::from(scene, grain) else { return Slot::EMPTY };
    let stride = Stride::from_code(slot.face);
    let mut slot = slot.only_meeting();
    scene.cells.ahead(look.me.cell, stride, |k, image| look.pair(&mut slot, k, image));
    if scene.boundary.planes().iter().any(|plane| plane.vibration.is_some()) {
        // The search for a plate goes no further than to the next cell.
        look.planes(&mut slot);
    }
    look.earliest(slot)
}

/// A look around from one grain.
struct Look<'a, S: Scalar, const D: usize> {
    scene: &'a Scene<'a, S, D>,
    grain: usize,
    /// The grain at its own clock.
    me: &'a Body<S, D>,
    /// The grain now; only where some are held.
    now: Option<Body<S, D>>,
    /// What it does by itself.
    own: Slot<S>,
    /// When it gets out of reach of the neighbours.
    wander: Slot<S>,
}

impl<'a, S: Scalar, const D: usize> Look<'a, S, D> {
    #[inline]
    fn from(scene: &'a Scene<'_, S, D>, grain: usize) -> Option<Self> {
        let me = scene.body(grain)?;
        let now = (scene.held > 0).then(|| scene.present(grain));
        Some(Self { scene, grain, me, own: own(scene, me), wander: wander(scene, me), now })
    }

    /// How far a search needs to look.
    fn limit(&self, slot: &Slot<S>) -> S {
        self.own.time.smaller(self.wander.time).smaller(slot.meeting) - self.scene.now
    }

    /// Takes the meeting with grain `k` into account.
    #[inline]
    fn pair(&self, slot: &mut Slot<S>, k: usize, image: Option<&Vector<S, D>>) {
        let (scene, me) = (self.scene, self.me);
        let Some(other) = scene.body(k).filter(|_| k != self.grain) else { return };
        if me.partner == Partner::grain(k) && other.partner == Partner::grain(self.grain) {
            return;
        }
        if let Some(now) = &self.now
            && (now.is_held() || other.is_held())
        {
            return self.held(slot, k, [now, other]);
        }
        if let Some(time) = touch::flying(scene, [me, other], image)
            && time <= slot.meeting
        {
            let from = not_before(me).larger(not_before(other));
            if time.larger(from) < scene.now {
                return self.missed(slot, k);
            }
            meet(slot, time.larger(from), Partner::grain(k), other.stamp);
        }
    }

    /// The same if one of the two is held.
    #[inline(never)]
    fn held(&self, slot: &mut Slot<S>, k: usize, [now, other]: [&Body<S, D>; 2]) {
        let scene = self.scene;
        let found = touch::held(scene, now, &scene.present(k), self.limit(slot));
        let from = not_before(self.me).larger(not_before(other));
        self.found(slot, found, from, Partner::grain(k));
    }

    /// A meeting with grain `k` was put off, and now they have passed each other, or approach still.
    #[cold]
    fn missed(&self, slot: &mut Slot<S>, k: usize) {
        let [me, other] = [self.grain, k].map(|i| self.scene.present(i));
        let apart = self.scene.separation(&me, &other);
        let reach = me.radius + other.radius;
        if let Some(span) = root::spheres(&apart, &(me.velocity - other.velocity), reach) {
            meet(slot, self.scene.now + span, Partner::grain(k), other.stamp);
        }
    }

    /// Takes the meetings with planes into account.
    #[inline]
    fn planes(&self, slot: &mut Slot<S>) {
        let (scene, me) = (self.scene, self.me);
        for (p, plane) in scene.boundary.planes().iter().enumerate() {
            if me.partner == Partner::plane(p) || me.rests_on(p) {
                continue;
            }
            if me.is_held() || plane.vibration.is_some() {
                let now = scene.present(self.grain);
                let found = touch::plane(scene, &now, plane, self.limit(slot));
                self.found(slot, found, not_before(me), Partner::plane(p));
            } else if let Some(time) = touch::wall(scene, me, plane) {
                let time = time.larger(scene.now).larger(not_before(me));
                meet(slot, time, Partner::plane(p), 0);
            }
        }
    }

    /// Takes what a search found into account: not before `from`, and a look again where it paused.
    fn found(&self, slot: &mut Slot<S>, found: Found<S>, from: S, partner: Partner) {
        let stamp = partner.as_grain().and_then(|k| self.scene.body(k)).map_or(0, |b| b.stamp);
        let now = self.scene.now;
        match found {
            Found::Event(span) => meet(slot, (now + span).larger(from), partner, stamp),
            Found::NotBefore(span) => meet(slot, now + span, Partner::NOTHING, 0),
            Found::Nothing => {}
        }
    }

    /// The first of the meeting, what the grain does by itself, and its way out of reach.
    #[inline]
    fn earliest(&self, meeting: Slot<S>) -> Slot<S> {
        let mut slot = meeting;
        if self.own.time <= slot.time && self.own.kind != Kind::Nothing {
            slot = self.own;
        }
        if self.wander.time < slot.time {
            let Slot { time, kind, face, .. } = self.wander;
            slot = Slot { time, kind, face, ..meeting };
        }
        slot
    }
}

/// What happens to a body by itself: its contact ends, or its plate falls away.
#[inline]
fn own<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Slot<S> {
    if me.in_contact() {
        return Slot::alone(me.release_at, Kind::Release);
    }
    if me.planes == 0 {
        return Slot::EMPTY;
    }
    match touch::take_off(scene, me) {
        Found::Event(span) => Slot::alone(scene.now + span, Kind::TakeOff),
        Found::NotBefore(span) => Slot::alone(scene.now + span, Kind::Wander),
        Found::Nothing => Slot::EMPTY,
    }
}

/// When the body gets out of reach of the neighbours that were looked at.
#[inline]
fn wander<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, me: &Body<S, D>) -> Slot<S> {
    let first = match &scene.cells.grid {
        Some(grid) => crossing(scene, grid, me),
        None => leash(scene, me).map(|span| (span, Slot::<S>::NO_FACE)),
    };
    let Some((span, face)) = range::within(scene, me, first) else { return Slot::EMPTY };
    Slot { face, ..Slot::alone(scene.now + span, Kind::Wander) }
}

/// Whether a predicted event is void because the partner's trajectory has changed since.
pub(crate) fn is_stale<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, slot: &Slot<S>) -> bool {
    let partner = slot.with().as_grain().and_then(|k| scene.body(k));
    partner.is_some_and(|body| body.stamp != slot.stamp)
}

/// When the grain leaves its cell, and through which face.
///
/// The faces obey the rule for planes: a grain that rounding has put just outside its cell crosses
/// at once if it flies outwards, and not at all if it flies back in.
#[inline]
fn crossing<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    grid: &Grid<S, D>,
    body: &Body<S, D>,
) -> Option<(S, u8)> {
    let mut first = None::<(S, u8)>;
    if body.is_held() {
        return shaken_crossing(scene, grid, &flight::at(body, scene.field(), scene.now));
    }
    let (position, velocity) = flight::free(body, scene.field(), scene.now);
    let at = grid.coordinates(body.cell);
    let [x, v, a]: [[S; D]; 3] = [position, velocity, scene.gravity].map(Into::into);
    for (axis, ((&x, &v), &a)) in x.iter().zip(&v).zip(&a).enumerate() {
        let [low, high] = grid.faces(&at, axis, x);
        if a == S::zero() {
            let (gap, up) = if v < S::zero() { (low, false) } else { (high, true) };
            let Some(gap) = gap.filter(|_| v != S::zero()) else { continue };
            sooner(&mut first, (gap / v.magnitude()).larger(S::zero()), Stride { axis, up });
            continue;
        }
        for (gap, v, a, up) in [(low, v, a, false), (high, -v, -a, true)] {
            if let Some(span) = gap.and_then(|gap| root::plane(gap, v, a)) {
                sooner(&mut first, span, Stride { axis, up });
            }
        }
    }
    first
}

/// Keeps the face that is crossed first.
#[inline]
fn sooner<S: Scalar>(first: &mut Option<(S, u8)>, span: S, stride: Stride) {
    // What does not fit the number type is not soon.
    if first.map_or(span <= S::NEVER, |(least, _)| span < least) {
        *first = Some((span, stride.code()));
    }
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

/// The first instant at which a third body may end the contact that a body is in.
///
/// Without it two contacts could end each other for ever at one instant, and soft grains in a corner
/// would collapse as hard ones do.
fn not_before<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    if body.in_contact() { body.moment } else { S::zero() }
}

/// Keeps the earlier meeting; of equal ones the lower partner, so that the order in which neighbours are
/// visited does not matter. NaN and infinity never win, nor what lies beyond the instants that there are.
///
/// With nothing it is no meeting but a look again.
#[inline]
fn meet<S: Scalar>(slot: &mut Slot<S>, time: S, partner: Partner, stamp: u32) {
    let tie = time == slot.meeting && partner.word() < slot.partner.word();
    if (time < slot.meeting || tie) && time <= S::LAST {
        let kind = if partner == Partner::NOTHING { Kind::Wander } else { Kind::Meet };
        *slot = Slot { time, meeting: time, partner, stamp, kind, face: Slot::<S>::NO_FACE };
    }
}
