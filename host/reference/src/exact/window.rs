//! Does a grain in contact touch another one? Reads the known motion up to an instant; begins the first such contact.

use super::flight::Shifts;
use super::run::{Event, Exact, Target};
use crate::cluster::Side;
use crate::contact_law::End;
use crate::roots::{bracketed, largest};
use crate::vector::{Vector, length, minus};

/// Samples of a window in which two grains are close.
const SAMPLES: usize = 24;

/// A contact found ahead.
#[derive(Clone, Copy)]
struct Hit<const D: usize> {
    time: f64,
    grain: usize,
    target: Target<D>,
    overlapped: bool,
}

/// Where a grain is at the beginning of a window, and how far its surface may come within it.
struct Envelope<const D: usize> {
    position: Vector<D>,
    range: f64,
}

impl<const D: usize> Exact<D> {
    /// Looks for contacts that begin before `until` and involve a grain that is in contact; the
    /// first of them is begun.
    pub(super) fn contact_in_window(&mut self, until: f64) -> Option<Event> {
        if until <= self.now {
            return None;
        }
        let mut first: Option<Hit<D>> = None;
        let envelopes: Vec<Envelope<D>> =
            (0..self.grains.len()).map(|i| self.envelope(i, until)).collect();
        for &grain in self.clusters.iter().flat_map(|cluster| &cluster.grains) {
            for target in self.reachable(grain, until, &envelopes) {
                let hit = self.search(grain, target, until);
                let sooner = |h: &Hit<D>| first.is_none_or(|f| h.time < f.time);
                first = hit.filter(sooner).or(first);
            }
        }
        let hit = first?;
        self.now = hit.time.max(self.now);
        Some(self.begin(hit.grain, hit.target, hit.overlapped))
    }

    fn envelope(&self, i: usize, until: f64) -> Envelope<D> {
        let travel = (until - self.now) * self.speed_bound(i, until);
        Envelope { position: self.position(i), range: self.grains[i].radius + travel }
    }

    /// What a grain in contact may come to touch in the window, beyond what it touches.
    fn reachable(&self, i: usize, until: f64, envelopes: &[Envelope<D>]) -> Vec<Target<D>> {
        let (me, period) = (&envelopes[i], self.periods());
        let mut found = self.walls();
        found.retain(|target| {
            let Target::Wall { axis, upper } = *target else { return true };
            let risen = (until - self.now) * self.wall(axis, upper).1.fastest();
            self.approach(i, *target)[0] + me.range + risen >= self.grains[i].radius
        });
        for (j, other) in envelopes.iter().enumerate() {
            let d = minus(&me.position, &other.position);
            let range = me.range + other.range;
            if j == i || surely_separate(&d, range, &period) {
                continue;
            }
            for shift in Shifts::near(&d, range, period) {
                if length(&minus(&d, &shift)) <= range {
                    found.push(Target::Grain { other: j, shift });
                }
            }
        }
        found.retain(|target| !self.linked(i, *target));
        found
    }

    fn speed_bound(&self, i: usize, until: f64) -> f64 {
        let cluster = self.owner[i].map(|k| &self.clusters[k]);
        if let Some((cluster, local)) = cluster.and_then(|c| Some((c, c.local(i)?))) {
            return cluster.speed_bound(local);
        }
        let [a, b] = [self.now, until].map(|t| length(&self.state(i, t).1));
        a.max(b)
    }

    fn linked(&self, i: usize, target: Target<D>) -> bool {
        let Some(k) = self.owner[i] else { return false };
        let cluster = &self.clusters[k];
        let same = |a, b| (cluster.local(a), cluster.local(b));
        cluster.links.iter().any(|link| match (target, link.side) {
            (Target::Wall { axis, upper }, Side::Wall { axis: other, facing, .. }) => {
                cluster.local(i) == Some(link.first) && axis == other && upper == (facing < 0.0)
            }
            (Target::Grain { other, shift }, Side::Member { local, shift: image }) => {
                let pair = same(i, other);
                let flipped = shift.map(|s| -s);
                (pair == (Some(link.first), Some(local)) && near(&shift, &image))
                    || (pair == (Some(local), Some(link.first)) && near(&flipped, &image))
            }
            _ => false,
        })
    }

    fn search(&self, grain: usize, target: Target<D>, until: f64) -> Option<Hit<D>> {
        let at = |k: usize| self.now + (until - self.now) * (k as f64 / SAMPLES as f64);
        let x = |t: f64| self.approach_at(grain, target, t)[0];
        let w = |t: f64| self.push(grain, target, t);
        let sampled: Vec<[f64; 2]> = (0..=SAMPLES).map(|k| [x(at(k)), w(at(k))]).collect();
        let hit = |time, overlapped| Some(Hit { time, grain, target, overlapped });
        if sampled[0][0] >= 0.0 && sampled[0][1] > 0.0 && sampled[1][1] > 0.0 {
            return hit(self.now, sampled[0][0] > 1e-9 * self.grains[grain].radius);
        }
        for k in 0..SAMPLES {
            let [[x0, w0], [x1, w1]] = [sampled[k], sampled[k + 1]];
            if x0 < 0.0 && x1 >= 0.0 {
                return hit(bracketed(x, at(k), at(k + 1)), false);
            }
            if x0 >= 0.0 && w0 <= 0.0 && x1 >= 0.0 && w1 > 0.0 {
                return hit(bracketed(w, at(k), at(k + 1)), true);
            }
            if k > 0 && x0 < 0.0 && x0 > sampled[k - 1][0] && x0 > x1 {
                let top = largest(x, at(k - 1), at(k + 1));
                if x(top) > 0.0 {
                    return hit(bracketed(x, at(k - 1), top), false);
                }
            }
        }
        None
    }

    /// Positive where two overlapping grains out of contact would push again: w = x^s + θ ẋ, or ẋ.
    fn push(&self, grain: usize, target: Target<D>, time: f64) -> f64 {
        let [x, u] = self.approach_at(grain, target, time);
        match self.end {
            End::Force => self.contact_law(grain, target).push(x, u),
            End::Overlap => u,
        }
    }
}

/// A cheap test that rules out most pairs: too far along some axis, in the nearest image too.
fn surely_separate<const D: usize>(d: &Vector<D>, range: f64, period: &Vector<D>) -> bool {
    d.iter().zip(period).any(|(d, period)| {
        let d = d.abs();
        d > range && (*period == 0.0 || (d < *period - range))
    })
}

fn near<const D: usize>(a: &[f64; D], b: &[f64; D]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * (a.abs() + b.abs()))
}
