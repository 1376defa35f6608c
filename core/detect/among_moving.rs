//! Which facet that moves does a grain touch first? Reads the lists of facets on its way through their own frame; writes the earliest collision found so far.
//!
//! In the frame of obstacles that move the facets stand, and the grain flies a curve whose acceleration is bounded. It is
//! followed in stretches, each as long as the grain surely touches nothing but what is seen from its beginning; in each
//! the bracketed search finds the first event, and steps over none.

use super::bracketed_root::{Found, Search};
use super::predictor::Predictor;
use super::scheduled_event::ScheduledEvent;
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct, norm};
use crate::space::{Domain, Facet, Obstacles, RigidMotion};
use core::cell::Cell;

/// So many stretches are looked into at a time.
const MOST_STRETCHES: usize = 64;

/// So often a search goes on where it paused.
const ROUNDS: usize = 16;

impl<S: Scalar, const D: usize> Predictor<'_, S, D> {
    /// Takes the collisions with obstacles that move into account.
    #[inline(never)]
    pub fn moving_obstacles(&self, first: &mut ScheduledEvent<S>, obstacles: &Obstacles<'_, S, D>) {
        for motion in obstacles.motions() {
            let (limit, met) = (self.limit(first), Cell::new(0));
            let found = self.search(self.me.clock, |start| {
                let me = self.at(self.me, start);
                let ride = Ride { me: &me, start, gravity: self.domain.gravity(), motion };
                let (found, facet) = ride.first(obstacles, limit - start);
                met.set(facet);
                found
            });
            let with = Partner::facet(met.get());
            self.found(first, found, self.me.uninterruptible_until(), with);
        }
    }
}

/// How long after its clock a body that flies freely touches a facet that moves so.
pub(super) fn body_and_moving_facet<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    (facet, motion): (&Facet<S, D>, &RigidMotion<S, D>),
    (start, limit): (S, S),
) -> Found<S> {
    let ride = Ride { me, start, gravity: domain.gravity(), motion };
    let stretch = ride.stretch(&ride.at(S::zero()), limit);
    let stretch = Stretch { way: S::NEVER, span: limit, ..stretch };
    ride.search(facet, S::zero(), &stretch)
}

/// A body that flies freely, seen from obstacles that move.
struct Ride<'a, S: Scalar, const D: usize> {
    me: &'a Body<S, D>,
    /// When it is as it is: the time since the epoch.
    start: S,
    gravity: &'a Vector<S, D>,
    motion: &'a RigidMotion<S, D>,
}

/// Where it is after a span, and how it moves there.
struct There<S: Scalar, const D: usize> {
    /// In the world.
    outside: [Vector<S, D>; 2],
    /// In the obstacles' frame.
    inside: [Vector<S, D>; 2],
}

/// For how long what is seen from somewhere is all that can be touched.
struct Stretch<S> {
    span: S,
    /// The most that the body goes in it, in the obstacles' frame.
    way: S,
    /// The largest acceleration there.
    acceleration: S,
    /// Whether nothing can be touched.
    is_clear: bool,
}

impl<S: Scalar, const D: usize> Ride<'_, S, D> {
    fn at(&self, span: S) -> There<S, D> {
        let way = (self.me.velocity + self.gravity * (span * S::half())) * span;
        let position = self.me.position + way;
        let velocity = self.me.velocity + self.gravity * span;
        let pose = self.motion.at(self.start + span);
        let inside = [pose.inside(&position), pose.velocity_inside(&position, &velocity)];
        There { outside: [position, velocity], inside }
    }

    /// The first facet that it touches, up to a limit.
    fn first(&self, obstacles: &Obstacles<'_, S, D>, limit: S) -> (Found<S>, usize) {
        let mut from = S::zero();
        for _ in 0..MOST_STRETCHES {
            let there = self.at(from);
            let stretch = self.stretch(&there, S::NEVER);
            let [position, _] = &there.inside;
            let (mut met, mut looked) = (None::<(S, usize)>, from + stretch.span);
            for k in obstacles.list_inside(self.motion, position).filter(|_| !stretch.is_clear) {
                let Some(facet) = obstacles.facet(k) else { continue };
                match self.search(facet, from, &stretch) {
                    Found::Event(time) if met.is_none_or(|(least, _)| time < least) => {
                        met = Some((time, k));
                    }
                    Found::NotBefore(time) => looked = looked.min(time),
                    Found::Event(_) | Found::Nothing => {}
                }
            }
            match met.filter(|&(time, _)| time <= looked) {
                Some((time, k)) => return (Found::Event(time), k),
                None if looked < from + stretch.span => return (Found::NotBefore(looked), 0),
                None => from = looked,
            }
            // Negated so that what is no number ends it.
            if !(from <= limit) {
                return (Found::Nothing, 0);
            }
        }
        (Found::NotBefore(from), 0)
    }

    /// How long after the body's clock it touches a facet in a stretch that begins after a span.
    fn search(&self, facet: &Facet<S, D>, from: S, stretch: &Stretch<S>) -> Found<S> {
        let radius = self.me.radius;
        let [position, velocity] = self.at(from).inside;
        if facet.nearest(&position).distance - radius > stretch.way {
            return Found::Nothing;
        }
        // Where it passes an edge or a corner the distance grows by v²/r.
        let fast = norm(&velocity) + stretch.acceleration * stretch.span.min(S::one());
        let most = stretch.acceleration + fast.times(fast).divided_by(radius);
        let (mut begin, end) = (from, from + stretch.span);
        for _ in 0..ROUNDS {
            let search = Search::new([stretch.acceleration, most], radius, end - begin);
            let found = search.first(|span| {
                let [position, velocity] = self.at(begin + span).inside;
                facet.nearest(&position).overlap(radius, &velocity)
            });
            match found.from(begin) {
                // Beyond its end nothing is known of the stretch; the next one finds it.
                Found::Event(time) if time <= end => return Found::Event(time),
                Found::NotBefore(time) if time < end => begin = time,
                _ => return Found::Nothing,
            }
        }
        Found::NotBefore(begin)
    }

    /// How long from somewhere on, at most so long, nothing else can be touched than what is seen there.
    fn stretch(&self, there: &There<S, D>, most: S) -> Stretch<S> {
        let [[position, velocity], [inside, relative]] = [&there.outside, &there.inside];
        let (g, v) = (norm(self.gravity), norm(velocity));
        let least = S::negligible_acceleration(self.me.radius);
        let way = self.motion.clearance(inside);
        let (cap, acceleration) = match self.motion.centre() {
            None => {
                let [_, shaken] = self.motion.peaks(S::zero());
                (most, g + shaken)
            }
            Some(centre) => {
                let omega = self.motion.turning_rate();
                let cap = (S::half() / omega).min(most);
                let fast = v + g * cap;
                let far = norm(&(position - centre)) + fast * cap;
                (cap, g + omega * ((fast + omega * far) * S::from_f32(2.0) + omega * far))
            }
        };
        let acceleration = acceleration.max(least);
        let span = span_of(way, norm(relative), acceleration).min(cap);
        let clear = self.clear_span(there, [v, g]);
        if clear > span {
            return Stretch { span: clear.min(most), way, acceleration, is_clear: true };
        }
        Stretch { span, way, acceleration, is_clear: false }
    }

    /// How long it surely touches nothing: it stays beyond where the obstacles ever come.
    fn clear_span(&self, there: &There<S, D>, [v, g]: [S; 2]) -> S {
        let [[position, _], [inside, _]] = [&there.outside, &there.inside];
        let way = match (self.motion.centre(), self.motion.swing()) {
            (Some(centre), _) => norm(&(position - centre)) - self.motion.reach(),
            (None, Some(swing)) => self.motion.beyond(inside) - (swing + swing),
            (None, None) => S::zero(),
        };
        if way > S::zero() { span_of(way, v, g) } else { S::zero() }
    }
}

/// How long something takes at least that goes so far: v t + a t²/2 = w, without cancellation.
fn span_of<S: Scalar>(way: S, v: S, a: S) -> S {
    let root = (v.times(v) + (a + a).times(way)).sqrt();
    if v + root > S::zero() { (way + way) / (v + root) } else { S::NEVER }
}
