//! What is the pressure? Reads each collision as it happens; writes nothing, sums the virial.

use carom::event::Kind;
use carom::world::Happening;
use carom::{Instant, View, Watch};

/// Sums what compressibility factor and mean free time are made of.
///
/// Masses are 1 and collisions have coefficient of restitution ε.
#[derive(Clone, Copy, Debug)]
pub struct Gauge {
    restitution: f64,
    begin: Instant,
    virial: f64,
    collisions: u64,
}

impl Gauge {
    /// Begins to measure at this instant.
    pub const fn new(restitution: f64, begin: Instant) -> Self {
        Self { restitution, begin, virial: 0.0, collisions: 0 }
    }

    /// Collisions of two grains so far.
    pub const fn collisions(&self) -> u64 {
        self.collisions
    }

    /// The compressibility factor Z = p V/(N kT) = 1 + Σ r·Δp/(D N kT t), the sum over the collisions of time t.
    pub fn compressibility<const D: usize>(&self, grains: usize, kt: f64, now: Instant) -> f64 {
        let time: f64 = now.since(self.begin);
        1.0 + self.virial / (D as f64 * grains as f64 * kt * time)
    }

    /// The mean time between two collisions of one grain: N t/(2 C) with C collisions of pairs in time t.
    pub fn mean_free_time(&self, grains: usize, now: Instant) -> f64 {
        grains as f64 * now.since::<f64>(self.begin) / (2.0 * self.collisions as f64)
    }
}

impl<const D: usize> Watch<f64, D> for Gauge {
    fn before(&mut self, happening: &Happening<f64>, view: View<'_, f64, D>) {
        let (Kind::Meet, Some(k)) = (happening.kind, happening.partner.as_grain()) else { return };
        let (Some(a), Some(b)) = (view.grain(happening.grain), view.grain(k)) else { return };
        let r = view.boundary().nearest(a.position - b.position);
        let approach = -r.dot(&(a.velocity - b.velocity));
        self.collisions += 1;
        self.virial += 0.5 * (1.0 + self.restitution) * approach;
    }
}
