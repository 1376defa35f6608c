//! When is a grain's next event? Reads bodies, cells and boundaries; writes nothing, returns the earliest event.

use super::approach::closing_speed;
use super::bracketed_root::Found;
use super::scheduled_event::{EventKind, ScheduledEvent};
use super::{cell_crossing, collision_time, root, take_off};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector};
use crate::space::{CellFace, Domain, NeighbourBatch, Particles, Plane, flight};

/// The earliest event of this grain.
///
/// Collisions of grains that nothing supports depend on the two alone, not on when one asks: whatever
/// finds neighbours, the same events come at the same bits.
pub(crate) fn next_event<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    grain: usize,
) -> ScheduledEvent<S> {
    predict(particles, domain, now, (grain, Look::Around))
}

/// The same in a contact until whose end nobody else can come near: nobody need be looked at.
#[cfg(not(feature = "alloc"))]
pub(crate) fn next_event_alone<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    grain: usize,
) -> ScheduledEvent<S> {
    predict(particles, domain, now, (grain, Look::Nowhere))
}

/// The earliest event of a grain that has just crossed into a cell: its collision is kept, and only the
/// grains ahead are new.
pub(crate) fn next_event_after_crossing<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    (grain, crossing): (usize, ScheduledEvent<S>),
) -> ScheduledEvent<S> {
    if particles.supported > 0 || crossing.face == ScheduledEvent::<S>::NO_FACE {
        return next_event(particles, domain, now, grain);
    }
    predict(particles, domain, now, (grain, Look::Ahead(&crossing)))
}

/// Which neighbours are looked at.
enum Look<'a, S: Scalar> {
    /// All.
    Around,
    /// Those in the cells ahead, after this crossing.
    Ahead(&'a ScheduledEvent<S>),
    /// None.
    #[cfg(not(feature = "alloc"))]
    Nowhere,
}

/// The same with a look at these neighbours.
// With one caller for each way a function for each is faster; and smaller it is as one.
#[cfg_attr(feature = "alloc", inline(always))]
#[cfg_attr(not(feature = "alloc"), inline(never))]
fn predict<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    (grain, look): (usize, Look<'_, S>),
) -> ScheduledEvent<S> {
    let Some(predictor) = Predictor::new(particles, domain, now, grain) else {
        return ScheduledEvent::NONE;
    };
    let (from, filler) = ((&predictor.at, predictor.me.radius), predictor.filler());
    let mut first = ScheduledEvent::NONE;
    if let Look::Ahead(crossing) = look {
        first = crossing.only_collision();
        let face = CellFace::from_code(crossing.face);
        let visit = &mut |batch: &NeighbourBatch| predictor.batch(&mut first, batch);
        particles.cells.ahead(from, face, filler, visit);
    } else {
        // Walls first: who cannot be met before the earliest collision known need not be looked at closely.
        predictor.walls(&mut first);
    }
    if let Look::Around = look {
        let visit = &mut |batch: &NeighbourBatch| predictor.batch(&mut first, batch);
        particles.cells.batches(from, filler, visit);
    }
    if domain.is_plain() && !predictor.me.is_supported() {
        return predictor.earliest(first);
    }
    predictor.among_what_moves(&first)
}

/// Predicts the events of one grain.
pub(super) struct Predictor<'a, S: Scalar, const D: usize> {
    pub particles: &'a Particles<'a, S, D>,
    pub domain: &'a Domain<'a, S, D>,
    pub now: S,
    grain: usize,
    /// The grain at its own clock.
    pub me: &'a Body<S, D>,
    /// Its cell's numbers along the axes.
    pub at: [u32; D],
    /// Where it is now and how it flies, if nothing supports it.
    pub here: Vector<S, D>,
    pub velocity: Vector<S, D>,
    /// What it does by itself.
    pub own: ScheduledEvent<S>,
    /// When it gets out of reach of the neighbours; nothing where that is asked last.
    out_of_reach: ScheduledEvent<S>,
}

/// Whether a grain is asked last when it leaves its cell: only if nothing happens before. A processor that guesses
/// branches gains nothing by that.
#[inline(always)]
fn asks_cell_last<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
) -> bool {
    !cfg!(feature = "alloc") && particles.supported == 0 && domain.is_plain()
}

impl<'a, S: Scalar, const D: usize> Predictor<'a, S, D> {
    #[inline(always)]
    fn new(
        particles: &'a Particles<'_, S, D>,
        domain: &'a Domain<'_, S, D>,
        now: S,
        grain: usize,
    ) -> Option<Self> {
        let me = particles.body(grain)?;
        let (here, velocity) = flight::free(me, domain, now);
        let at = particles.cells.coordinates(me.cell);
        let own = own_event(domain, now, me);
        // Searches go no further than to the next cell: they must know.
        let out_of_reach = match asks_cell_last(particles, domain) {
            true => ScheduledEvent::NONE,
            false => {
                let of = (&at, [&here, &velocity]);
                cell_crossing::out_of_reach(particles, domain, (now, S::NEVER), me, of)
            }
        };
        Some(Self { particles, domain, now, grain, me, at, here, velocity, own, out_of_reach })
    }

    /// Until when a search needs to look.
    pub fn limit(&self, first: &ScheduledEvent<S>) -> S {
        self.own.time.min(self.out_of_reach.time).min(first.collision_time)
    }

    /// The grain itself: what a batch is filled up with.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn filler(&self) -> u32 {
        self.grain as u32
    }

    /// Takes the collision with grain `k` into account.
    // As a function of its own it would not know of what kind all neighbours are.
    #[cfg_attr(feature = "alloc", inline(always))]
    #[cfg_attr(not(feature = "alloc"), inline)]
    pub fn pair(&self, first: &mut ScheduledEvent<S>, k: usize, same_image: bool) {
        let Some(other) = self.particles.body(k) else { return };
        let image = match same_image {
            true => Vector::zeros(),
            false => collision_time::nearest_image(self.domain, self.now, &self.here, other),
        };
        let time = collision_time::free_pair(self.domain, [self.me, other], &image);
        self.meet(first, (k, other), time);
    }

    /// Takes into account that it would touch grain `k` at a time, if nothing stopped the two.
    #[cfg_attr(feature = "alloc", inline(always))]
    #[cfg_attr(not(feature = "alloc"), inline)]
    pub fn meet(
        &self,
        first: &mut ScheduledEvent<S>,
        (k, other): (usize, &Body<S, D>),
        time: Option<S>,
    ) {
        let time = time.filter(|&time| time <= first.collision_time);
        let Some(time) = time.filter(|_| !self.is_in_contact_with(k, other)) else { return };
        let time = time.max(self.me.uninterruptible_until()).max(other.uninterruptible_until());
        if time < self.now {
            return self.deferred(first, k);
        }
        self.keep_earlier(first, time, Partner::grain(k), other.event_count);
    }

    /// Whether it is the grain itself, or they are in contact with each other.
    fn is_in_contact_with(&self, k: usize, other: &Body<S, D>) -> bool {
        let me = (self.me.partner, Partner::grain(self.grain));
        k == self.grain || me == (Partner::grain(k), other.partner)
    }

    /// The same if one of the two is supported.
    #[inline(never)]
    pub fn supported(&self, first: &mut ScheduledEvent<S>, k: usize, other: &Body<S, D>) {
        if self.is_in_contact_with(k, other) {
            return;
        }
        let limit = self.limit(first);
        let look = |start: S| {
            let [me, other] = [self.me, other].map(|body| self.at(body, start));
            collision_time::supported_pair(self.domain, start, [&me, &other], limit - start)
        };
        let found = self.search(self.me.clock.max(other.clock), look);
        let from = self.me.uninterruptible_until().max(other.uninterruptible_until());
        self.found(first, found, from, Partner::grain(k));
    }

    /// A body at a time, which often is its own.
    pub fn at(&self, body: &Body<S, D>, time: S) -> Body<S, D> {
        if body.clock == time { *body } else { flight::at(body, self.domain, time) }
    }

    /// Searches from where the motions began, so that the event has the same bits whenever one asks; what is past
    /// by now was put off, and only what follows counts.
    pub fn search(&self, start: S, look: impl Fn(S) -> Found<S>) -> Found<S> {
        let found = look(start).from(start);
        if start < self.now && found.time() <= self.now {
            return look(self.now).from(self.now);
        }
        found
    }

    /// A collision with grain `k` was deferred, and now they have passed each other, or approach still.
    #[cold]
    fn deferred(&self, first: &mut ScheduledEvent<S>, k: usize) {
        let [me, other] = [self.grain, k].map(|i| self.particles.present(i, self.domain, self.now));
        let [apart, velocity] = self.domain.relative(&me, &other, self.now);
        let reach = me.radius + other.radius;
        if let Some(span) = root::spheres(&apart, &velocity, reach) {
            self.keep_earlier(first, self.now + span, Partner::grain(k), other.event_count);
        }
    }

    /// Takes the collisions with planes that do not move into account, if nothing supports the grain.
    #[inline]
    fn walls(&self, first: &mut ScheduledEvent<S>) {
        let walls = self.domain.boundary.planes();
        if walls.is_empty() || self.me.is_supported() {
            return;
        }
        let from = self.now.max(self.me.uninterruptible_until());
        for (p, wall) in walls.iter().enumerate() {
            if wall.vibration().is_some() || self.me.partner == Partner::plane(p) {
                continue;
            }
            let limit = (wall, self.own.time.min(first.collision_time));
            if let Some(time) = collision_time::free_body_and_wall(self.domain, self.me, limit) {
                self.keep_earlier(first, time.max(from), Partner::plane(p), 0);
            }
        }
    }

    /// The earliest event where more than grains moves, planes or images, or where there are obstacles; or all planes
    /// count, since something supports the grain.
    #[inline(never)]
    fn among_what_moves(&self, first: &ScheduledEvent<S>) -> ScheduledEvent<S> {
        let mut first = *first;
        match self.domain.boundary.images() {
            Some(images) => self.across(&mut first, images),
            None => {
                self.plates(&mut first);
                let obstacles = self.domain.boundary.obstacles();
                obstacles.into_iter().for_each(|all| self.moving_obstacles(&mut first, all));
                let looked = obstacles.and_then(|all| self.obstacles(&mut first, all));
                Self::or_looks_on(self.earliest(first), looked)
            }
        }
    }

    /// Takes the collisions with vibrating planes into account, or with all if something supports the grain.
    pub fn plates(&self, first: &mut ScheduledEvent<S>) {
        let supported = self.me.is_supported();
        for (p, plane) in self.domain.boundary.planes().iter().enumerate() {
            if supported || plane.vibration().is_some() {
                self.plate(first, (p, plane));
            }
        }
    }

    /// The same with one of them.
    #[inline(never)]
    fn plate(&self, first: &mut ScheduledEvent<S>, (p, plane): (usize, &Plane<S, D>)) {
        let me = self.me;
        if me.partner == Partner::plane(p) || me.rests_on(p) {
            return;
        }
        let limit = self.limit(first);
        let look = |start: S| {
            let body = self.at(me, start);
            collision_time::body_and_plane(self.domain, start, &body, (plane, limit - start))
        };
        let found = self.search(me.clock, look);
        self.found(first, found, me.uninterruptible_until(), Partner::plane(p));
    }

    /// Takes what a search found into account: not before `from`, and a recheck where it paused.
    pub fn found(&self, first: &mut ScheduledEvent<S>, found: Found<S>, from: S, partner: Partner) {
        let other = partner.as_grain().and_then(|k| self.particles.body(k));
        let count = other.map_or(0, |body| body.event_count);
        match found {
            Found::Event(time) => self.keep_earlier(first, time.max(from), partner, count),
            Found::NotBefore(time) => self.keep_earlier(first, time, Partner::NOTHING, 0),
            Found::Nothing => {}
        }
    }

    /// Keeps the earlier collision, of equal ones the faster. NaN and infinity never win, nor what lies
    /// beyond the instants that there are.
    ///
    /// With nothing it is no collision but a recheck.
    #[inline]
    fn keep_earlier(
        &self,
        first: &mut ScheduledEvent<S>,
        time: S,
        partner: Partner,
        partner_event_count: u32,
    ) {
        let sooner = time < first.collision_time
            || time == first.collision_time && self.is_faster(first, partner);
        if sooner && time <= S::LAST {
            let kind = match partner {
                Partner::NOTHING => EventKind::Recheck,
                _ => EventKind::Collision,
            };
            let face = ScheduledEvent::<S>::NO_FACE;
            let collision_time = time;
            *first =
                ScheduledEvent { time, collision_time, partner, partner_event_count, kind, face };
        }
    }

    /// Whether of two collisions at one instant that with this partner is the faster, or of equals that with
    /// the lower number: in which order neighbours are visited does not matter.
    #[cold]
    fn is_faster(&self, first: &ScheduledEvent<S>, partner: Partner) -> bool {
        if partner == Partner::NOTHING || first.partner == Partner::NOTHING {
            return partner.word() < first.partner.word();
        }
        let [new, old] = [partner, first.partner].map(|with| {
            closing_speed(self.particles, self.domain, (self.grain, with), first.collision_time)
        });
        new > old || new == old && partner.word() < first.partner.word()
    }

    /// The first of the collision, what the grain does by itself, and its way out of reach.
    #[inline]
    fn earliest(&self, collision: ScheduledEvent<S>) -> ScheduledEvent<S> {
        self.earliest_of(collision, &self.own)
    }

    /// The same where the grain does this by itself.
    #[inline]
    pub fn earliest_of(
        &self,
        collision: ScheduledEvent<S>,
        own: &ScheduledEvent<S>,
    ) -> ScheduledEvent<S> {
        let mut first = collision;
        if own.time <= first.time && own.kind != EventKind::Nothing {
            first = *own;
        }
        let out_of_reach = match asks_cell_last(self.particles, self.domain) {
            true => {
                let of = (&self.at, [&self.here, &self.velocity]);
                let times = (self.now, first.time);
                cell_crossing::out_of_reach(self.particles, self.domain, times, self.me, of)
            }
            false => self.out_of_reach,
        };
        if out_of_reach.time < first.time && out_of_reach.time <= S::LAST {
            let ScheduledEvent { time, kind, face, .. } = out_of_reach;
            first = ScheduledEvent { time, kind, face, ..collision };
        }
        first
    }
}

/// What happens to a body by itself: its contact ends, or its plate falls away.
#[inline]
fn own_event<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
) -> ScheduledEvent<S> {
    if me.in_contact() {
        return ScheduledEvent::alone(me.contact_end, EventKind::ContactEnd);
    }
    if me.planes == 0 {
        return ScheduledEvent::NONE;
    }
    match take_off::take_off(domain, me).from(me.clock) {
        Found::Event(time) => ScheduledEvent::alone(time.max(now), EventKind::TakeOff),
        Found::NotBefore(time) => ScheduledEvent::paused(time.max(now)),
        Found::Nothing => ScheduledEvent::NONE,
    }
}
