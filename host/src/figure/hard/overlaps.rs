//! Which grains overlap, and does that get worse? Reads each collision just before and after; writes nothing, keeps a list of pairs.
//!
//! Two grains come to overlap only where they collide (BSFP14 §3), so the pairs that a grain overlaps
//! are among those it collided with. They are checked whenever one of the two has an event.

use carom::scalar::Vector;
use carom::world::{Event, EventKind};
use carom::{Observer, View};

/// A pair just before it collides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// |r| − σ in units of the last place: of numbers just above σ where it is positive, just
    /// below where it is negative, so that it counts floating-point numbers.
    pub excess: f64,
    /// Whether it overlaps.
    pub overlapping: bool,
    /// Whether one of the two overlaps a third grain as well.
    pub three_body: bool,
}

/// The overlapping pairs of grains of diameter 1.
#[derive(Clone, Debug, Default)]
pub struct Overlaps {
    /// For each grain: whom it overlapped when last checked, and f = r² − σ² then.
    open: Vec<Vec<(usize, f64)>>,
    /// The impact that is due.
    pub impact: Option<Impact>,
    /// Impacts so far.
    pub impacts: u64,
    /// Impacts of overlapping pairs.
    pub overlapping: u64,
    /// Impacts with a third grain overlapped.
    pub three_body: u64,
    /// The least |r| − σ seen.
    pub deepest: f64,
    /// The largest decrease of an overlap function from one check to the next while it was negative,
    /// as a length: Δf/(2σ).
    pub decrease: f64,
    /// Pairs that overlapped and still approached after an event of one of them.
    pub approaching: u64,
    /// The fastest of them, as −r·v/(σ |v|).
    pub fastest: f64,
}

impl Overlaps {
    /// No pair of so many grains overlaps.
    pub fn new(grains: usize) -> Self {
        Self { open: vec![Vec::new(); grains], ..Self::default() }
    }

    /// Adds what another observer has counted.
    pub fn add(&mut self, other: &Self) {
        self.impacts += other.impacts;
        self.overlapping += other.overlapping;
        self.three_body += other.three_body;
        self.deepest = self.deepest.min(other.deepest);
        self.decrease = self.decrease.max(other.decrease);
        self.approaching += other.approaching;
        self.fastest = self.fastest.max(other.fastest);
    }

    /// Updates the pairs in which a grain overlapped, and drops those that do no more.
    fn update<const D: usize>(&mut self, i: usize, view: &View<'_, f64, D>) {
        let mut pairs = std::mem::take(&mut self.open[i]);
        pairs.retain_mut(|(m, before)| {
            let Some((r, _)) = pair(view, i, *m) else { return false };
            let now = overlap(&r);
            self.decrease = self.decrease.max((*before - now) / 2.0);
            *before = now;
            let gone = now >= 0.0;
            self.note(*m, i, (!gone).then_some(now));
            !gone
        });
        self.open[i] = pairs;
    }

    /// Writes down for grain `i` that it overlaps `m` so much, or not any more.
    fn note(&mut self, i: usize, m: usize, overlap: Option<f64>) {
        let list = &mut self.open[i];
        let place = list.iter().position(|(other, _)| *other == m);
        match (place, overlap) {
            (Some(place), Some(f)) => list[place].1 = f,
            (Some(place), None) => {
                list.swap_remove(place);
            }
            (None, Some(f)) => list.push((m, f)),
            (None, None) => {}
        }
    }

    /// The pair that is about to collide.
    fn impact<const D: usize>(&self, i: usize, k: usize, r: &Vector<f64, D>) -> Impact {
        let distance = r.dot(r).sqrt();
        let gap = distance - 1.0;
        let place = if gap < 0.0 { f64::EPSILON / 2.0 } else { f64::EPSILON };
        let overlapping = overlap(r) < 0.0;
        let third = |a: usize, b: usize| self.open[a].iter().any(|(m, _)| *m != b);
        Impact {
            excess: gap / place,
            overlapping,
            three_body: overlapping && (third(i, k) || third(k, i)),
        }
    }

    fn count(&mut self, impact: Impact, r2: f64) {
        self.impact = Some(impact);
        self.impacts += 1;
        self.overlapping += u64::from(impact.overlapping);
        self.three_body += u64::from(impact.three_body);
        self.deepest = self.deepest.min(r2.sqrt() - 1.0);
    }

    /// After an event: do overlapping pairs part, or at least not approach?
    fn check<const D: usize>(&mut self, i: usize, view: &View<'_, f64, D>) {
        for (m, _) in &self.open[i] {
            let Some((r, v)) = pair(view, i, *m) else { continue };
            let approach = -r.dot(&v);
            if approach > 0.0 && overlap(&r) < 0.0 {
                self.approaching += 1;
                self.fastest = self.fastest.max(approach / v.dot(&v).sqrt());
            }
        }
    }
}

impl<const D: usize> Observer<f64, D> for Overlaps {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        self.impact = None;
        let (EventKind::Collision, Some(k)) = (event.kind, event.partner.as_grain()) else {
            return;
        };
        let i = event.grain;
        self.update(i, &view);
        self.update(k, &view);
        let Some((r, _)) = pair(&view, i, k) else { return };
        let impact = self.impact(i, k, &r);
        self.count(impact, r.dot(&r));
        let f = overlap(&r);
        for (a, b) in [(i, k), (k, i)] {
            self.note(a, b, (f < 0.0).then_some(f));
        }
    }

    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        let (EventKind::Collision, Some(k)) = (event.kind, event.partner.as_grain()) else {
            return;
        };
        self.check(event.grain, &view);
        self.check(k, &view);
    }
}

/// Separation and relative velocity.
fn pair<const D: usize>(
    view: &View<'_, f64, D>,
    i: usize,
    k: usize,
) -> Option<(Vector<f64, D>, Vector<f64, D>)> {
    let (a, b) = (view.grain(i)?, view.grain(k)?);
    Some((view.boundary().nearest(a.position - b.position), a.velocity - b.velocity))
}

/// f = r² − σ², BSFP14 Eq. (8).
fn overlap<const D: usize>(r: &Vector<f64, D>) -> f64 {
    r.dot(r) - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::law::HardSphere;
    use carom::{Grain, Memory, World};

    /// Updates two grains at this distance.
    fn update_at(overlaps: &mut Overlaps, distance: f64) {
        let mut memory = Memory::<f64, 1, 2>::new();
        let builder = World::builder(&mut memory).rule(HardSphere { restitution: 1.0 });
        let grain = |x| Grain::with_mass(0.5, 1.0).at([x]);
        let world = builder.grains([grain(0.0), grain(distance)]).unwrap().start().unwrap();
        overlaps.update(0, &world.view());
    }

    #[test]
    fn an_overlap_that_gets_deeper_is_noticed_and_one_that_ends_is_forgotten() {
        let mut overlaps = Overlaps::new(2);
        overlaps.note(0, 1, Some(-4e-16));
        overlaps.note(1, 0, Some(-4e-16));
        update_at(&mut overlaps, 1.0 - f64::EPSILON / 2.0);
        assert_eq!(overlaps.decrease, 0.0);
        update_at(&mut overlaps, 1.0 - 2.0 * f64::EPSILON);
        assert_eq!(overlaps.decrease, 1.5 * f64::EPSILON);
        assert_eq!(overlaps.open[1].len(), 1);
        update_at(&mut overlaps, 1.0);
        assert!(overlaps.open.iter().all(Vec::is_empty));
    }
}
