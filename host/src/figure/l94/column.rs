//! What becomes of a column of beads that hits a wall? Reads beads, gaps and ε; writes velocities after the impact, by MD (L94 Sec. IV).

use carom_reference::{
    Boundary, ContactRecord, End, Exact, ForceLaw, Gear, Grain, Plate, Quiet, ReferenceError, Stop,
    System, VerletOptions,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A column of equal beads above a wall at 0, without gravity, all with velocity −v_0.
///
/// # Units
///
/// SI; the beads' mass is 1 kg, for only K/m and D_n matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// N.
    pub beads: usize,
    /// d.
    pub diameter: f64,
    /// v_0 > 0.
    pub speed: f64,
    /// s_0, between neighbours, and between the lowest bead and the wall.
    pub gap: f64,
    /// Bead i is shifted by a random part of ± s_0/2 if there is a seed (L94 Sec. IV).
    pub jitter: Option<u64>,
}

impl Column {
    /// L94's usual column: d = 1 mm.
    pub const fn new(beads: usize, speed: f64, gap: f64) -> Self {
        Self { beads, diameter: 1e-3, speed, gap, jitter: None }
    }

    /// Where the centres are: bead i (from 1) is i s_0 higher than if all touched.
    pub fn heights(&self) -> Vec<f64> {
        let mut rng = self.jitter.map(Pcg64::seed_from_u64);
        let mut shift = || rng.as_mut().map_or(0.0, |rng| self.gap * rng.random_range(-0.5..0.5));
        let at = |k: usize| (k as f64 + 0.5) * self.diameter + (k + 1) as f64 * self.gap;
        (0..self.beads).map(|k| at(k) + shift()).collect()
    }

    /// The beads as the reference MD takes them.
    pub fn grains(&self) -> Vec<Grain<1>> {
        let bead = |z: f64| Grain {
            radius: 0.5 * self.diameter,
            mass: 1.0,
            position: [z],
            velocity: [-self.speed],
        };
        self.heights().into_iter().map(bead).collect()
    }

    /// Lets it hit the wall, by exact MD; contacts end when the overlap does, as in L94.
    ///
    /// # Errors
    /// As [`Exact::next_event`], and for a column that does not come to an end.
    pub fn collide(&self, law: ForceLaw) -> Result<Outcome, ReferenceError> {
        self.collide_until(law, End::Overlap)
    }

    /// The same with either end of a contact: with [`End::Force`] no dashpot pulls.
    ///
    /// # Errors
    /// As [`Column::collide`].
    pub fn collide_until(&self, law: ForceLaw, end: End) -> Result<Outcome, ReferenceError> {
        let mut run = self.start(law, end)?;
        let mut stop = Stop::Limit;
        for attempt in 0..ATTEMPTS {
            stop = run.advance_until_quiet(self.until(&law, attempt))?;
            let outcome = self.outcome(&run.grains());
            if stop == Stop::Separated || (run.contacts() == 0 && outcome.pending() < PENDING) {
                let of = |instant: fn(&ContactRecord) -> f64| run.records().iter().map(instant);
                let begin = of(|record| record.begin).fold(f64::INFINITY, f64::min);
                let end = of(|record| record.end.unwrap_or(0.0)).fold(0.0, f64::max);
                return Ok(Outcome { lasted: end - begin, ..outcome });
            }
        }
        Err(not_over(stop, run.now()))
    }

    /// The same with L94's integrator in so many steps per contact, for columns that are too long
    /// for exact MD.
    ///
    /// # Errors
    /// As [`Gear::advance_to`], and for a column that does not come to an end.
    pub fn collide_in_steps(&self, law: ForceLaw, steps: f64) -> Result<Outcome, ReferenceError> {
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Gear::new(&self.system()?, law, End::Overlap, options)?;
        let mut stop = Stop::Limit;
        for attempt in 0..ATTEMPTS {
            stop = run.advance_until_quiet(self.until(&law, attempt))?;
            let outcome = self.outcome(&run.grains());
            if stop == Stop::Separated || (!run.in_contact() && outcome.pending() < PENDING) {
                return Ok(outcome);
            }
        }
        Err(not_over(stop, run.now()))
    }

    fn system(&self) -> Result<System<1>, ReferenceError> {
        System::new(self.grains(), [Boundary::Plate(Plate::fixed(0.0))], [0.0])
    }

    /// The column before the impact, as an exact MD run.
    fn start(&self, law: ForceLaw, end: End) -> Result<Exact<1>, ReferenceError> {
        Exact::new(self.system()?, law, end)
    }

    /// Where the beads are at given times, by exact MD.
    ///
    /// # Errors
    /// As [`Exact::advance_to`].
    pub fn heights_at(
        &self,
        law: ForceLaw,
        times: &[f64],
    ) -> Result<Vec<Vec<f64>>, ReferenceError> {
        let mut run = self.start(law, End::Overlap)?;
        let at = |t: &f64| {
            run.advance_to(*t)?;
            Ok((0..self.beads).map(|i| run.position(i)[0]).collect())
        };
        times.iter().map(at).collect()
    }

    fn outcome(&self, grains: &[Grain<1>]) -> Outcome {
        Outcome::of(grains.iter().map(|grain| grain.velocity[0]), self.speed)
    }

    /// How far to go before looking whether it is over: half the impact.
    fn until(&self, law: &ForceLaw, attempt: u32) -> Quiet {
        let contact = law.pair([0.5 * self.diameter; 2], [1.0; 2]).contact_time(self.speed);
        let impact = self.beads as f64 * (self.gap / self.speed + contact);
        Quiet { interval: f64::INFINITY, limit: 0.5 * impact * f64::from(attempt + 1) }
    }
}

/// A column is over when what the rest of it can change is this share of its energy.
const PENDING: f64 = 1e-9;
/// How often that is looked at before giving up.
const ATTEMPTS: u32 = 100_000;

fn not_over(stop: Stop, time: f64) -> ReferenceError {
    let why = match stop {
        Stop::Limit => "the column does not come apart",
        _ => "the column stays in contact",
    };
    ReferenceError::Unresolved { time, grain: 0, why }
}

/// What an impact left.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The beads' velocities in units of v_0, from below.
    pub velocities: Vec<f64>,
    /// From the first touch to the last parting (s); 0 where that is not known.
    pub lasted: f64,
}

impl Outcome {
    /// From velocities in m/s.
    pub fn of(velocities: impl Iterator<Item = f64>, speed: f64) -> Self {
        Self { velocities: velocities.map(|v| v / speed).collect(), lasted: 0.0 }
    }

    fn mean(&self, of: impl Fn(f64) -> f64) -> f64 {
        self.velocities.iter().map(|v| of(*v)).sum::<f64>() / self.velocities.len() as f64
    }

    /// ε_eff = √(E_f/E_0).
    pub fn restitution(&self) -> f64 {
        self.mean(|v| v * v).sqrt()
    }

    /// The velocity of the centre of mass over v_0.
    pub fn centre(&self) -> f64 {
        self.mean(|v| v)
    }

    /// The share of the energy that later contacts could still dissipate if all of them were
    /// completely inelastic: beads that would catch up with others, or come back to the wall.
    pub fn pending(&self) -> f64 {
        let mut blocks: Vec<[f64; 2]> = Vec::new();
        for v in &self.velocities {
            let [mut count, mut sum] = [1.0, *v];
            while let Some([n, s]) = blocks.last().filter(|[n, s]| s / n > sum / count) {
                [count, sum] = [count + n, sum + s];
                blocks.pop();
            }
            blocks.push([count, sum]);
        }
        let kept: f64 = blocks.iter().map(|[n, s]| s.max(0.0).powi(2) / n).sum();
        let all: f64 = self.velocities.iter().map(|v| v * v).sum();
        if all > 0.0 { 1.0 - kept / all } else { 0.0 }
    }

    /// E_r/E_f, the share of the energy relative to the centre of mass; none where nothing moves.
    pub fn relative(&self) -> Option<f64> {
        let (centre, energy) = (self.centre(), self.mean(|v| v * v));
        (energy > 1e-20).then(|| self.mean(|v| (v - centre).powi(2)) / energy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_to_lose() {
        let of = |v: &[f64]| Outcome::of(v.iter().copied(), 1.0).pending();
        assert_eq!(of(&[0.0, 0.1, 0.2]), 0.0);
        assert_eq!(of(&[-1.0]), 1.0);
        // 3 and 1 become 2 and 2.
        assert!((of(&[3.0, 1.0, 5.0]) - (1.0 - 33.0 / 35.0)).abs() < 1e-15);
        assert!((of(&[1.0, -1.0, 2.0]) - (1.0 - 4.0 / 6.0)).abs() < 1e-15);
    }
}
