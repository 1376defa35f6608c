//! What does L94's own integrator give? Reads a system and a law; writes its motion by a predictor-corrector.

use super::verlet::{Statistics, Verlet, VerletOptions};
use crate::contact_law::End;
use crate::error::ReferenceError;
use crate::law::ForceLaw;
use crate::system::{Grain, System};
use crate::vector::{Vector, length, plus};

/// Gear's corrector for r̈ = f(r, ṙ) with six values (Allen & Tildesley, Computer Simulation of
/// Liquids, App. E): what is added to r, h ṙ, h² r̈/2 … for each unit of error in h² r̈/2.
const CORRECTOR: [f64; 6] = [3.0 / 16.0, 251.0 / 360.0, 1.0, 11.0 / 18.0, 1.0 / 6.0, 1.0 / 60.0];

/// Force-based molecular dynamics as in L94: Gear's fifth-order predictor-corrector in fixed steps.
///
/// Each step predicts position and five derivatives by Taylor's series, computes the forces there
/// once, and corrects all six in proportion to the error of the acceleration. Step, pair list,
/// contacts and statistics are those of [`Verlet`]. Within a contact the scheme is of fifth order; at
/// its two ends, where the force or a derivative jumps, of first (damped) or second order.
///
/// # Examples
///
/// ```
/// use carom_reference::{Boundary, End, ForceLaw, Gear, Grain, System, VerletOptions};
/// let grain = |x: f64, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x], velocity: [v] };
/// let system = System::new(vec![grain(0.0, 1.0), grain(1.0, -1.0)], [Boundary::Open], [0.0])?;
/// let law = ForceLaw::LinearDashpot { stiffness: 1e4, damping: 0.0 };
/// let mut run = Gear::new(&system, law, End::Overlap, VerletOptions::default())?;
/// run.advance_to(1.0)?;
/// assert!((run.velocity(0)[0] + 1.0).abs() < 1e-2);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Gear<const D: usize> {
    /// Positions, velocities, pair list and forces.
    pub(super) state: Verlet<D>,
    /// h² r̈/2 and the three derivatives that follow, each scaled by h^k/k!.
    higher: Vec<[Vector<D>; 4]>,
    /// The step the derivatives are scaled for.
    scaled: f64,
}

impl<const D: usize> Gear<D> {
    /// Starts at time 0.
    ///
    /// # Errors
    ///
    /// As [`Verlet::new`].
    pub fn new(
        system: &System<D>,
        law: ForceLaw,
        end: End,
        options: VerletOptions,
    ) -> Result<Self, ReferenceError> {
        let state = Verlet::new(system, law, end, options)?;
        let half = 0.5 * state.step * state.step;
        let higher = (0..state.positions.len())
            .map(|i| {
                let a = plus(&state.gravity, 1.0, &state.accelerations[i]);
                [a.map(|a| half * a), [0.0; D], [0.0; D], [0.0; D]]
            })
            .collect();
        let scaled = state.step;
        Ok(Self { state, higher, scaled })
    }

    /// The time the run stands at.
    pub fn now(&self) -> f64 {
        self.state.now
    }

    /// The largest step taken (s).
    pub fn time_step(&self) -> f64 {
        self.state.step
    }

    /// What the run has cost so far.
    pub fn statistics(&self) -> Statistics {
        self.state.statistics
    }

    /// Where grain i is; in a periodic box, some image of it near the box.
    pub fn position(&self, i: usize) -> [f64; D] {
        self.state.positions[i]
    }

    /// How grain i moves.
    pub fn velocity(&self, i: usize) -> [f64; D] {
        self.state.velocities[i]
    }

    /// All grains as they are now.
    pub fn grains(&self) -> Vec<Grain<D>> {
        self.state.grains()
    }
}

impl<const D: usize> Gear<D> {
    /// Up to `count` steps of length h, from and to a full step; fewer if the step must shrink.
    pub(super) fn take_steps(&mut self, count: u64, h: f64) -> u64 {
        self.rescale(h);
        for done in 1..=count {
            self.predict(h);
            let shrunk = self.state.used > self.state.skin && self.state.prepare();
            self.state.push_all(0.0);
            self.correct(h);
            self.state.statistics.steps += 1;
            if shrunk || !self.state.fastest.is_finite() {
                return done;
            }
        }
        count
    }

    /// Takes the derivatives to another step. One that is much longer or shorter would carry their
    /// errors along as a high power of the ratio: there the history is dropped instead.
    fn rescale(&mut self, h: f64) {
        let ratio = h / self.scaled;
        self.scaled = h;
        if (0.5..=2.0).contains(&ratio) {
            for (k, term) in self.higher.iter_mut().flat_map(|higher| higher.iter_mut().enumerate())
            {
                *term = term.map(|x| ratio.powi(k as i32 + 2) * x);
            }
            return;
        }
        let state = &self.state;
        for (higher, contact) in self.higher.iter_mut().zip(&state.accelerations) {
            let a = plus(&state.gravity, 1.0, contact);
            *higher = [a.map(|a| 0.5 * h * h * a), [0.0; D], [0.0; D], [0.0; D]];
        }
    }

    fn predict(&mut self, h: f64) {
        let state = &mut self.state;
        let moving = state.positions.iter_mut().zip(&mut state.velocities);
        for ((r, v), higher) in moving.zip(&mut self.higher) {
            let [a, b, c, d] = higher;
            for k in 0..D {
                let (x2, x3, x4, x5) = (a[k], b[k], c[k], d[k]);
                r[k] += h * v[k] + x2 + x3 + x4 + x5;
                v[k] += (2.0 * x2 + 3.0 * x3 + 4.0 * x4 + 5.0 * x5) / h;
                a[k] = x2 + 3.0 * x3 + 6.0 * x4 + 10.0 * x5;
                b[k] = x3 + 4.0 * x4 + 10.0 * x5;
                c[k] = x4 + 5.0 * x5;
            }
        }
        state.clock += h;
        state.used += 2.0 * h * state.fastest.max(state.fastest_plate);
    }

    fn correct(&mut self, h: f64) {
        let (state, half) = (&mut self.state, 0.5 * h * h);
        let mut fastest = 0.0_f64;
        for (i, higher) in self.higher.iter_mut().enumerate() {
            let (r, v) = (&mut state.positions[i], &mut state.velocities[i]);
            for k in 0..D {
                let wrong = half * (state.accelerations[i][k] + state.gravity[k]) - higher[0][k];
                r[k] += CORRECTOR[0] * wrong;
                v[k] += CORRECTOR[1] * wrong / h;
                for (term, weight) in higher.iter_mut().zip(&CORRECTOR[2..]) {
                    term[k] += weight * wrong;
                }
            }
            let speed = length(v);
            fastest = if speed <= fastest { fastest } else { speed };
        }
        state.fastest = fastest;
    }
}
