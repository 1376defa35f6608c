//! When is a grain's next event? Reads the scene; writes nothing, returns the earliest slot.

use super::bracket::Found;
use super::glance::Eye;
use super::queue::{Kind, Slot};
use super::root;
use super::scene::Scene;
use super::{order, touch, wander};
use crate::matter::cells::{self, CROWD, Crowd};
use crate::matter::grid::Stride;
use crate::matter::{Body, Partner, flight};
use crate::number::{Scalar, Vector};

/// The earliest event of this grain.
///
/// Meetings of grains that nothing holds depend on the two alone, not on when one asks: whatever
/// finds neighbours, the same events come at the same bits.
pub(crate) fn next<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, grain: usize) -> Slot<S> {
    let Some(me) = scene.body(grain) else { return Slot::EMPTY };
    let look = Look::from(scene, grain, me);
    let mut slot = Slot::EMPTY;
    scene.cells.crowds(&look.at, look.filler(), &mut |crowd| look.crowd(&mut slot, crowd));
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
    let Some(me) = scene.body(grain) else { return Slot::EMPTY };
    let look = Look::from(scene, grain, me);
    let stride = Stride::from_code(slot.face);
    let mut slot = slot.only_meeting();
    scene.cells.ahead(&look.at, stride, look.filler(), &mut |crowd| look.crowd(&mut slot, crowd));
    if scene.boundary.planes().iter().any(|plane| plane.vibration.is_some()) {
        // The search for a plate goes no further than to the next cell.
        look.planes(&mut slot);
    }
    look.earliest(slot)
}

/// So many bytes of bodies are held by the cache next to a processor.
const CACHE: usize = 2 << 20;

/// A look around from one grain.
struct Look<'a, S: Scalar, const D: usize> {
    scene: &'a Scene<'a, S, D>,
    grain: usize,
    /// The grain at its own clock.
    me: &'a Body<S, D>,
    /// Its cell's numbers along the axes.
    at: [u32; D],
    /// Where it is now and how it flies, if nothing holds it.
    here: Vector<S, D>,
    velocity: Vector<S, D>,
    /// What it does by itself.
    own: Slot<S>,
    /// When it gets out of reach of the neighbours.
    wander: Slot<S>,
}

impl<'a, S: Scalar, const D: usize> Look<'a, S, D> {
    #[inline]
    fn from(scene: &'a Scene<'_, S, D>, grain: usize, me: &'a Body<S, D>) -> Self {
        let (here, velocity) = flight::free(me, scene.field(), scene.now);
        let at = scene.cells.coordinates(me.cell);
        let wander = wander::away(scene, me, &at, [&here, &velocity]);
        Self { scene, grain, me, at, here, velocity, own: own(scene, me), wander }
    }

    /// How far a search needs to look.
    fn limit(&self, slot: &Slot<S>) -> S {
        self.own.time.smaller(self.wander.time).smaller(slot.meeting) - self.scene.now
    }

    /// Itself: what a crowd is filled up with.
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
    fn filler(&self) -> u32 {
        self.grain as u32
    }

    /// Takes the meetings with a crowd into account, in the images that are nearest now.
    #[inline]
    fn crowd(&self, slot: &mut Slot<S>, crowd: &Crowd) {
        let straight = crowd.straight || self.scene.boundary.is_open();
        match self.scene.held {
            0 if S::RANGE.is_none() => self.fly(slot, crowd, straight),
            _ => self.closely(slot, crowd, straight),
        }
    }

    /// The same if something may hold some of them, or in fixed point: there the squares of squares may not
    /// fit, and a glance costs what a close look does.
    #[inline(never)]
    fn closely(&self, slot: &mut Slot<S>, crowd: &Crowd, straight: bool) {
        let now = (self.scene.held > 0).then(|| self.scene.present(self.grain));
        let free = crowd.only(self.filler(), |k| match (self.scene.body(k as usize), &now) {
            (Some(other), Some(now)) if now.is_held() || other.is_held() => {
                self.held(slot, k as usize, (now, other));
                false
            }
            _ => true,
        });
        match S::RANGE {
            None => self.fly(slot, &free, straight),
            Some(_) => free.all().iter().for_each(|&k| self.candidate(slot, k as usize, straight)),
        }
    }

    /// The same if nothing holds any of them. Most pairs never meet, which a glance tells: at all of them
    /// first, without a branch, and then at the others closely.
    #[inline(never)]
    fn fly(&self, slot: &mut Slot<S>, crowd: &Crowd, straight: bool) {
        let (scene, me) = (self.scene, self.filler());
        let eye = Eye::new(scene, [&self.here, &self.velocity], self.me.radius);
        if size_of_val(scene.bodies) > CACHE {
            self.fetch(crowd);
        }
        let (mut kept, mut count) = ([0; CROWD], 0);
        for some in crowd.groups() {
            let others = some.map(|k| scene.body(k as usize).unwrap_or(self.me));
            let may = eye.may_meet(scene, others, straight);
            for (i, &k) in some.iter().enumerate() {
                cells::put(&mut kept, count, k);
                count += usize::from((may >> i & 1 == 1) & (k != me));
            }
        }
        for &k in kept.iter().take(count) {
            self.candidate(slot, k as usize, straight);
        }
    }

    /// Reads something of every grain: all that are in no cache come at the same time.
    #[inline]
    fn fetch(&self, crowd: &Crowd) {
        let bodies = crowd.all().iter().filter_map(|&k| self.scene.body(k as usize));
        core::hint::black_box(bodies.fold(0, |sum, body| sum ^ body.clock.bits()));
    }

    /// Takes the meeting with grain `k` into account.
    #[inline]
    fn candidate(&self, slot: &mut Slot<S>, k: usize, straight: bool) {
        let (scene, me) = (self.scene, self.me);
        let Some(other) = scene.body(k) else { return };
        let image = match straight {
            true => Vector::zeros(),
            false => touch::near_image(scene, &self.here, other),
        };
        let time = touch::flying(scene, [me, other], &image).filter(|&time| time <= slot.meeting);
        let Some(time) = time.filter(|_| !self.is_bound(k, other)) else { return };
        let time = time.larger(not_before(me)).larger(not_before(other));
        if time < scene.now {
            return self.missed(slot, k);
        }
        self.meet(slot, time, Partner::grain(k), other.stamp);
    }

    /// Whether it is the grain itself, or they are in contact with each other.
    fn is_bound(&self, k: usize, other: &Body<S, D>) -> bool {
        let me = (self.me.partner, Partner::grain(self.grain));
        k == self.grain || me == (Partner::grain(k), other.partner)
    }

    /// The same if one of the two is held.
    #[inline(never)]
    fn held(&self, slot: &mut Slot<S>, k: usize, (now, other): (&Body<S, D>, &Body<S, D>)) {
        let scene = self.scene;
        if self.is_bound(k, other) {
            return;
        }
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
            self.meet(slot, self.scene.now + span, Partner::grain(k), other.stamp);
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
                self.meet(slot, time, Partner::plane(p), 0);
            }
        }
    }

    /// Takes what a search found into account: not before `from`, and a look again where it paused.
    fn found(&self, slot: &mut Slot<S>, found: Found<S>, from: S, partner: Partner) {
        let stamp = partner.as_grain().and_then(|k| self.scene.body(k)).map_or(0, |b| b.stamp);
        let now = self.scene.now;
        match found {
            Found::Event(span) => self.meet(slot, (now + span).larger(from), partner, stamp),
            Found::NotBefore(span) => self.meet(slot, now + span, Partner::NOTHING, 0),
            Found::Nothing => {}
        }
    }

    /// Keeps the earlier meeting, of equal ones the faster. NaN and infinity never win, nor what lies
    /// beyond the instants that there are.
    ///
    /// With nothing it is no meeting but a look again.
    #[inline]
    fn meet(&self, slot: &mut Slot<S>, time: S, partner: Partner, stamp: u32) {
        let sooner = time < slot.meeting || time == slot.meeting && self.is_first(slot, partner);
        if sooner && time <= S::LAST {
            let kind = if partner == Partner::NOTHING { Kind::Wander } else { Kind::Meet };
            let face = Slot::<S>::NO_FACE;
            *slot = Slot { time, meeting: time, partner, stamp, kind, face };
        }
    }

    /// Whether of two meetings at one instant that with this partner is the faster, or of equals that with
    /// the lower number: in which order neighbours are visited does not matter.
    #[cold]
    fn is_first(&self, slot: &Slot<S>, partner: Partner) -> bool {
        let speed = |with| order::closing_speed(self.scene, (self.grain, with), slot.meeting);
        if partner == Partner::NOTHING || slot.partner == Partner::NOTHING {
            return partner.word() < slot.partner.word();
        }
        let [new, old] = [partner, slot.partner].map(speed);
        new > old || new == old && partner.word() < slot.partner.word()
    }

    /// The first of the meeting, what the grain does by itself, and its way out of reach.
    #[inline]
    fn earliest(&self, meeting: Slot<S>) -> Slot<S> {
        let mut slot = meeting;
        if self.own.time <= slot.time && self.own.kind != Kind::Nothing {
            slot = self.own;
        }
        if self.wander.time < slot.time && self.wander.time <= S::LAST {
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

/// Whether a predicted event is void because the partner's trajectory has changed since.
pub(crate) fn is_stale<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, slot: &Slot<S>) -> bool {
    let partner = slot.with().as_grain().and_then(|k| scene.body(k));
    partner.is_some_and(|body| body.stamp != slot.stamp)
}

/// The first instant at which a third body may end the contact that a body is in.
///
/// Without it two contacts could end each other for ever at one instant, and soft grains in a corner
/// would collapse as hard ones do.
fn not_before<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    if body.in_contact() { body.moment } else { S::zero() }
}
