//! Which facet does a grain touch first? Reads the lists of facets along its path; writes the earliest collision found so far.

use super::among_moving::body_and_moving_facet;
use super::bracketed_root::Found;
use super::facet_collision::{Face, body_and_face, body_and_facet};
use super::predictor::Predictor;
use super::root;
use super::scheduled_event::{EventKind, ScheduledEvent};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, component};
use crate::space::{CellFace, Domain, Grid, Obstacles, flight};

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
            cell: obstacles.grid.locate(&self.here),
            span: S::zero(),
        };
        for _ in 0..MOST_CELLS {
            let cell = path.cell;
            let left = path.leave_cell();
            // What is met in a later cell is found there.
            let until = left.map_or(S::NEVER, |()| self.now + path.span);
            self.facets(first, (cell, obstacles), until);
            left?;
            if until >= self.limit(first) {
                return None;
            }
        }
        Some(self.now + path.span)
    }

    /// The same with those that are seen from one cell, up to a time. Faces first, which a closed form finds: mostly what
    /// comes of edges then is too late to be searched for.
    fn facets(
        &self,
        first: &mut ScheduledEvent<S>,
        (cell, obstacles): (u32, &Obstacles<'_, S, D>),
        until: S,
    ) {
        let mut edges = heapless::Vec::<usize, MOST_EDGES>::new();
        for k in obstacles.list(cell) {
            if self.face(first, (k, obstacles), until) {
                if let Err(k) = edges.push(k) {
                    self.facet(first, (k, obstacles), until);
                }
            }
        }
        for k in edges {
            self.facet(first, (k, obstacles), until);
        }
    }

    /// The same with the face of one; whether its edges must be asked, too.
    fn face(
        &self,
        first: &mut ScheduledEvent<S>,
        (k, obstacles): (usize, &Obstacles<'_, S, D>),
        until: S,
    ) -> bool {
        let Some(facet) = obstacles.facet(k) else { return false };
        let limit = self.limit(first).min(until);
        let start = self.me.clock;
        match body_and_face(self.domain, self.me, (facet, limit - start)) {
            Face::Missed => false,
            Face::Touched(span) if start == self.now || start + span > self.now => {
                let from = self.me.uninterruptible_until();
                self.found(first, Found::Event(start + span), from, Partner::facet(k));
                false
            }
            // What is past was put off: as of edges, the search says what follows.
            Face::Touched(_) | Face::PerhapsAfter(_) => true,
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
    /// Where it is after this span.
    cell: u32,
    span: S,
}

impl<S: Scalar, const D: usize> Path<'_, S, D> {
    /// It comes into the next cell; none if it stays in this one for ever.
    fn leave_cell(&mut self) -> Option<()> {
        let [x, v, a] = self.state;
        let (t, at) = (self.span, self.grid.coordinates(self.cell));
        let (position, velocity) = (x + (v + a * (t * S::half())) * t, v + a * t);
        let mut first = None::<(S, CellFace)>;
        for axis in 0..D {
            let [x, v, a] = [&position, &velocity, &a].map(|v| component(v, axis));
            let [low, high] = self.grid.faces(&at, axis, x);
            for (gap, v, a, up) in [(low, v, a, false), (high, -v, -a, true)] {
                let Some(span) = gap.and_then(|gap| root::plane(gap, v, a)) else { continue };
                if first.is_none_or(|(least, _)| span < least) {
                    first = Some((span, CellFace { axis, up }));
                }
            }
        }
        let (span, face) = first?;
        (self.cell, _) = self.grid.across(self.cell, face)?;
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
