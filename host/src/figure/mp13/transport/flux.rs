//! What do contacts add to the pressure of an elastic gas? Reads each event as it happens; writes nothing, sums the virial.

use carom::event::{Deed, Kind};
use carom::world::Happening;
use carom::{View, Watch};

/// Sums what the contacts of an elastic gas add to D P V t.
///
/// D P V t = ∫ (Σ m v² + Σ r·F) dt. For a pair with reduced mass μ that is left alone, the part of its
/// relative motion is d(μ r·v)/dt; so a contact that turns r, v into r', v' adds μ (r'·v' − r·v),
/// whatever its force and duration were, and an instantaneous collision the same. While a contact of eMD*
/// lasts its two grains have the velocity of their centre, which misses μ v'² of Σ m v².
#[derive(Clone, Copy, Debug, Default)]
pub struct Flux {
    sum: f64,
    /// μ r·v of the two that are about to meet.
    before: f64,
    /// μ v'² times what is left of the contacts of the two, in case they are ended now.
    left: f64,
}

impl Flux {
    /// D P V t − 2 E t, with the energy E of the gas, over the time that was watched.
    pub const fn sum(&self) -> f64 {
        self.sum
    }
}

fn reduced(a: f64, b: f64) -> f64 {
    a / (a + b) * b
}

/// μ r·v and μ v² of two grains, as if they were released now.
fn moments<const D: usize>(view: &View<'_, f64, D>, i: usize, k: usize) -> Option<[f64; 2]> {
    let (a, b) = (view.released(i)?, view.released(k)?);
    let (r, v, mu) = (view.separation(i, k)?, a.velocity - b.velocity, reduced(a.mass, b.mass));
    Some([mu * r.dot(&v), mu * v.dot(&v)])
}

/// What is left of the contact of grain i, in μ v'² times time.
fn left<const D: usize>(view: &View<'_, f64, D>, i: usize) -> f64 {
    let of = |(partner, end): (carom::matter::Partner, carom::Instant)| {
        let [_, square] = moments(view, i, partner.as_grain()?)?;
        Some(square * end.since::<f64>(view.now()))
    };
    view.contact(i).and_then(of).unwrap_or(0.0)
}

impl<const D: usize> Watch<f64, D> for Flux {
    fn before(&mut self, happening: &Happening<f64>, view: View<'_, f64, D>) {
        let (Kind::Meet, Some(k)) = (happening.kind, happening.partner.as_grain()) else { return };
        self.before = moments(&view, happening.grain, k).map_or(0.0, |[radial, _]| radial);
        self.left = left(&view, happening.grain) + left(&view, k);
    }

    fn after(&mut self, happening: &Happening<f64>, view: View<'_, f64, D>) {
        let (Kind::Meet, Some(k)) = (happening.kind, happening.partner.as_grain()) else { return };
        let duration = match happening.deed {
            Some(Deed::Interruption) => {
                self.sum += self.left;
                return;
            }
            Some(Deed::Collision { .. }) => 0.0,
            Some(Deed::Contact(outcome)) => outcome.duration,
            _ => return,
        };
        if let Some([radial, square]) = moments(&view, happening.grain, k) {
            self.sum += radial - self.before - square * duration;
        }
    }
}
