//! How do grains become as large as they should be? Reads and writes their state, event by event; returns where they are.

use super::state::{Body, Growth, MARGIN, Run};
use rand_pcg::Pcg64;

/// The grains jammed when they were this part of what they should be.
#[derive(Clone, Copy, Debug)]
pub struct Jammed(pub f64);

/// Growth of the mean radius, in units of a velocity's standard deviation. Equal spheres that grow as
/// fast as this do not crystallise, and pass 0.62.
const RATES: [f64; 2] = [0.02, 0.004];

/// Collisions a grain after the growth: they come off each other.
const RELAXATION: usize = 10;

/// Collisions a grain after which a grain that still has to grow counts as jammed.
const PATIENCE: f64 = 20_000.0;

/// Lets the grains grow to their size.
///
/// # Errors
/// When they jam before.
pub fn grow(
    growth: &Growth<'_>,
    start: Vec<[f64; 3]>,
    rng: &mut Pcg64,
) -> Result<Vec<[f64; 3]>, Jammed> {
    let mut jammed = Jammed(0.0);
    for rate in RATES {
        let mut run = Run::new(growth, &start, rate, rng);
        match run.grow_up() {
            Ok(()) => {
                run.relax();
                return Ok(run.positions(start.len()));
            }
            Err(found) => jammed = Jammed(jammed.0.max(found.0)),
        }
    }
    Err(jammed)
}

impl Run {
    /// Until the scale is 1.
    fn grow_up(&mut self) -> Result<(), Jammed> {
        let end = (1.0 + MARGIN - self.scale) / self.rate;
        let window = 10 * self.moving.max(1);
        let (mut next_look, mut before) = (window, self.now);
        while self.step(end) {
            if self.collisions < next_look {
                continue;
            }
            let gained = self.now - before;
            let per_grain = 2.0 * window as f64 / self.moving as f64;
            if (end - self.now) * per_grain > PATIENCE * gained {
                return Err(Jammed(self.scale + self.rate * self.now));
            }
            (next_look, before) = (self.collisions + window, self.now);
            self.cool();
        }
        self.now = end;
        Ok(())
    }

    /// A few collisions more at full size.
    fn relax(&mut self) {
        for i in 0..self.moving {
            self.advance(i);
        }
        (self.scale, self.rate) = (1.0 + MARGIN, 0.0);
        self.renew();
        let enough = self.collisions + RELAXATION * self.moving / 2;
        // In this time a grain alone flies as far as a few dozen radii.
        let end = self.now + 20.0;
        while self.collisions < enough && self.step(end) {}
    }

    /// Where the first grains are now, inside the region.
    fn positions(&mut self, count: usize) -> Vec<[f64; 3]> {
        (0..count)
            .map(|i| {
                self.advance(i);
                let mut place = self.bodies[i].position;
                for (axis, x) in place.iter_mut().enumerate() {
                    let ([low, high], length) = (self.region.axes[axis], self.region.length(axis));
                    if self.region.periodic[axis] && !(low..high).contains(x) {
                        *x = low + (*x - low).rem_euclid(length);
                    }
                }
                place
            })
            .collect()
    }

    /// Growth makes grains faster: back to the speed of the start, with new predictions for all.
    fn cool(&mut self) {
        let square = |body: &Body| body.velocity.iter().map(|v| v * v).sum::<f64>();
        let moving = &self.bodies[..self.moving];
        let mean = moving.iter().map(|body| body.growing).sum::<f64>() / self.moving as f64;
        let now: f64 = moving.iter().map(square).sum::<f64>() / self.moving as f64;
        let factor = mean * (self.region.dimension as f64 / now).sqrt();
        if !(factor.is_finite() && factor < 0.9) {
            return;
        }
        for i in 0..self.moving {
            self.advance(i);
            self.bodies[i].velocity = self.bodies[i].velocity.map(|v| factor * v);
        }
        self.renew();
    }
}
