//! Which facet does a grain touch first? Reads the lists of facets along its path; writes the earliest collision found so far.

use super::among_moving::body_and_moving_facet;
use super::bracketed_root::Found;
use super::facet_collision::{Face, body_and_face, body_and_facet};
use super::predictor::Predictor;
use super::root;
use super::scheduled_event::{EventKind, ScheduledEvent};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, component};
use crate::space::{CellFace, Domain, Facet, Grid, Obstacles, flight};

/// So many cells of the obstacles are looked into at a time.
const MOST_CELLS: usize = 64;

/// So many facets wait until faces have been asked.
const MOST_EDGES: usize = 48;

impl<S: Scalar, const D: usize> Predictor<'_, S, D> {
    /// Takes the collisions with obstacles into account, in all their cells on the way to what is known to come first.
    /// Up to when it has looked, if not that far.
    #[inline(never)]
    pub fn obstacles(
        &self,
        first: &mut ScheduledEvent<S>,
        obstacles: &Obstacles<'_, S, D>,
    ) -> Option<S> {
        let mut path = Path {
            state: [self.here, self.velocity, *self.domain.gravity()],
            grid: &obstacles.grid,
            at: obstacles.grid.coordinates(obstacles.grid.locate(&self.here)),
            span: S::zero(),
        };
        for _ in 0..MOST_CELLS {
            let (cell, from) = (path.grid.number(&path.at), path.span);
            let left = path.leave_cell();
            // What is met in a later cell is found there.
            let until = left.map_or(S::NEVER, |()| self.now + path.span);
            if obstacles.list(cell).next().is_some() {
                let to = until.min(self.limit(first)) - self.now;
                let around = path.around([from, to], self.me.radius);
                self.facets(first, (cell, obstacles), (&around, until));
            }
            left?;
            if until >= self.limit(first) {
                return None;
            }
        }
        Some(self.now + path.span)
    }

    /// The same with those that are seen from one cell, up to a time, if they are not outside the box around its way there.
    /// Faces first, which a closed form finds: mostly what comes of edges then is too late to be searched for.
    fn facets(
        &self,
        first: &mut ScheduledEvent<S>,
        (cell, obstacles): (u32, &Obstacles<'_, S, D>),
        (around, until): (&[Vector<S, D>; 2], S),
    ) {
        let mut edges = heapless::Vec::<(usize, S), MOST_EDGES>::new();
        let seen = obstacles.list(cell);
        // On small machines there are few, and their number counts less than the code's size.
        let is_near = |k: &usize| {
            let is_outside = |facet: &Facet<S, D>| facet.is_outside(around);
            !cfg!(feature = "alloc") || !obstacles.facet(*k).is_some_and(is_outside)
        };
        for k in seen.filter(is_near) {
            let Some(time) = self.face(first, (k, obstacles), until) else { continue };
            if edges.push((k, time)).is_err() {
                self.facet(first, (k, obstacles), until);
            }
        }
        for &(k, time) in &edges {
            if !(time > self.limit(first)) {
                self.facet(first, (k, obstacles), until);
            }
        }
    }

    /// The same with the face of one; from when on its edges must be asked, too, if they must.
    fn face(
        &self,
        first: &mut ScheduledEvent<S>,
        (k, obstacles): (usize, &Obstacles<'_, S, D>),
        until: S,
    ) -> Option<S> {
        let facet = obstacles.facet(k)?;
        let limit = self.limit(first).min(until);
        let start = self.me.clock;
        match body_and_face(self.domain, self.me, (facet, limit - start)) {
            Face::Missed => None,
            Face::Touched(span) if start == self.now || start + span > self.now => {
                let from = self.me.uninterruptible_until();
                self.found(first, Found::Event(start + span), from, Partner::facet(k));
                None
            }
            // What is past was put off: as of edges, the search says what follows.
            Face::Touched(span) => Some(start + span),
            Face::EdgesPerhaps { after, .. } => Some(start + after),
        }
    }

    /// The same with one facet, up to a time.
    fn facet(
        &self,
        first: &mut ScheduledEvent<S>,
        (k, obstacles): (usize, &Obstacles<'_, S, D>),
        until: S,
    ) {
        let Some(facet) = obstacles.facet(k) else { return };
        let limit = self.limit(first).min(until);
        let found = self.search(self.me.clock, |start| {
            let body = self.at(self.me, start);
            body_and_facet(self.domain, &body, (facet, limit - start))
        });
        self.found(first, found, self.me.uninterruptible_until(), Partner::facet(k));
    }

    /// The event, or a look at what comes after the time up to which has been looked.
    pub fn or_looks_on(event: ScheduledEvent<S>, looked: Option<S>) -> ScheduledEvent<S> {
        match looked.filter(|&time| time < event.time) {
            None => event,
            Some(time) => {
                let face = ScheduledEvent::<S>::NO_FACE;
                ScheduledEvent { time, kind: EventKind::Recheck, face, ..event }
            }
        }
    }
}

/// The way of a grain through the cells of the obstacles.
struct Path<'a, S: Scalar, const D: usize> {
    /// Position, velocity and acceleration at its beginning.
    state: [Vector<S, D>; 3],
    grid: &'a Grid<S, D>,
    /// The coordinates of the cell in which it is after this span.
    at: [u32; D],
    span: S,
}

impl<S: Scalar, const D: usize> Path<'_, S, D> {
    /// The box around a body of this radius on its way from one span to another.
    fn around(&self, [from, to]: [S; 2], radius: S) -> [Vector<S, D>; 2] {
        let [x, v, a] = self.state;
        let at = |t: S| x + (v + a * (t * S::half())) * t;
        let slack = S::from_f32(1.0 + 1.0 / 64.0);
        let begin = at(from);
        let way = (at(to) - begin) * slack;
        // A parabola is off its chord by no more than a t²/8.
        let off = a * ((to - from) * S::from_f32(0.125)) * (to - from);
        let reach = off.map(|off| radius * slack + off.abs());
        // A way that is no number, as of what is too far in fixed point, bounds nothing: it stays what it is.
        let (down, up) = (way.map(|way| way.min(S::zero())), way.map(|way| way.max(S::zero())));
        [begin + down - reach, begin + up + reach]
    }

    /// It comes into the next cell; none if it stays in this one for ever.
    fn leave_cell(&mut self) -> Option<()> {
        let [x, v, a] = self.state;
        let t = self.span;
        let (position, velocity) = (x + (v + a * (t * S::half())) * t, v + a * t);
        let mut first = None::<(S, CellFace)>;
        for axis in 0..D {
            let [x, v, a] = [&position, &velocity, &a].map(|v| component(v, axis));
            let [low, high] = self.grid.faces(&self.at, axis, x);
            for (gap, v, a, up) in [(low, v, a, false), (high, -v, -a, true)] {
                let Some(span) = gap.and_then(|gap| root::plane(gap, v, a)) else { continue };
                if first.is_none_or(|(least, _)| span < least) {
                    first = Some((span, CellFace { axis, up }));
                }
            }
        }
        let (span, face) = first?;
        self.at = self.grid.beside(&self.at, face)?;
        self.span += span;
        Some(())
    }
}

/// At what time, not after the limit, a body that flies freely touches a facet; none if it does not.
pub(crate) fn facet_collision<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    (k, limit): (usize, S),
) -> Option<S> {
    let here = flight::at(me, domain, now);
    let obstacles = domain.boundary.obstacles()?;
    let facet = obstacles.facet(k)?;
    let found = match obstacles.motion_of(facet) {
        None => body_and_facet(domain, &here, (facet, limit - now)),
        Some(motion) => body_and_moving_facet(domain, &here, (facet, motion), (now, limit - now)),
    };
    match found {
        Found::Event(span) => Some(now + span),
        Found::NotBefore(_) | Found::Nothing => None,
    }
}
