//! What becomes of a layer of grains in two dimensions that hits a wall? Reads rows and gaps; writes ε_eff, by MD (L94 Sec. IV C).

use carom_reference::{
    Boundary, End, Exact, ForceLaw, Gear, Grain, Plate, Quiet, ReferenceError, System,
    VerletOptions,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Grains side by side in the periodic direction.
pub const ACROSS: usize = 13;

/// A layer on a triangular lattice of constant d + s_0, periodic across, above a wall at 0.
///
/// # Units
///
/// SI; the grains' mass is 1 kg, for only K/m, D_n and D_t matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Rows, h; N = 13 h.
    pub rows: usize,
    /// d.
    pub diameter: f64,
    /// v_0, towards the wall.
    pub speed: f64,
    /// s_0.
    pub gap: f64,
    /// ε of a central impact of two grains.
    pub restitution: f64,
    /// Its contact time t_c.
    pub contact_time: f64,
    /// D_t in units of D_n.
    pub tangential: f64,
    /// Each grain is shifted at random by up to s_0/2 along both axes.
    pub seed: u64,
}

impl Layer {
    fn spacing(&self) -> f64 {
        self.diameter + self.gap
    }

    fn width(&self) -> f64 {
        ACROSS as f64 * self.spacing()
    }

    fn law(&self) -> Result<ForceLaw, ReferenceError> {
        let law = ForceLaw::spring_of(1.0, self.contact_time, self.restitution)?;
        match law {
            ForceLaw::PowerLaw { stiffness, beta, damping, gamma, .. } => {
                let tangential = self.tangential * damping;
                Ok(ForceLaw::PowerLaw { stiffness, beta, damping, gamma, tangential })
            }
            other => Ok(other),
        }
    }

    /// Places without overlaps, row by row.
    pub fn places(&self) -> Vec<[f64; 2]> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let (a, rise) = (self.spacing(), 0.5 * 3.0_f64.sqrt() * self.spacing());
        let mut places: Vec<[f64; 2]> = Vec::new();
        for k in 0..self.rows * ACROSS {
            let (row, column) = (k / ACROSS, k % ACROSS);
            let x = a * (column as f64 + 0.25 + 0.5 * (row % 2) as f64);
            let y = 0.5 * self.diameter + self.gap + rise * row as f64;
            let mut shift = || self.gap * rng.random_range(-0.5..0.5);
            let found =
                (0..10_000).map(|_| [x + shift(), y + shift()]).find(|p| self.free(p, &places));
            places.push(found.unwrap_or([x, y]));
        }
        places
    }

    /// Whether a grain at p overlaps none of the last two rows.
    fn free(&self, p: &[f64; 2], places: &[[f64; 2]]) -> bool {
        let width = self.width();
        let near = places.len().saturating_sub(2 * ACROSS);
        self.gap == 0.0
            || places[near..].iter().all(|q| {
                let dx = p[0] - q[0];
                let dx = dx - width * (dx / width).round();
                dx.hypot(p[1] - q[1]) > self.diameter
            })
    }

    /// Lets the layer hit the wall and returns ε_eff = √(E_f/E_0), by L94's integrator in so many
    /// steps per contact.
    ///
    /// It is over when there has been no contact for `patience` times the time in which a grain
    /// passes one gap (or one contact time, where that is longer), or after `longest` times that
    /// for each row: grains side by side in a periodic box never cease to touch. The paper has
    /// a patience of 2N, and no longest time.
    ///
    /// # Errors
    /// As [`Gear::advance_to`].
    pub fn collide(&self, steps: f64, patience: [f64; 2]) -> Result<f64, ReferenceError> {
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Gear::new(&self.system()?, self.law()?, End::Overlap, options)?;
        run.advance_until_quiet(self.quiet(patience))?;
        Ok(self.restitution_left(&run.grains()))
    }

    /// The same by MD that is exact to about 12 digits, contact by contact: cheaper where grains fly
    /// for longer than they touch.
    ///
    /// # Errors
    /// As [`Exact::advance_to`].
    pub fn collide_exactly(&self, patience: [f64; 2]) -> Result<f64, ReferenceError> {
        let mut run = Exact::new(self.system()?, self.law()?, End::Overlap)?;
        run.advance_until_quiet(self.quiet(patience))?;
        Ok(self.restitution_left(&run.grains()))
    }

    fn system(&self) -> Result<System<2>, ReferenceError> {
        let grain = |position: [f64; 2]| Grain {
            radius: 0.5 * self.diameter,
            mass: 1.0,
            position,
            velocity: [0.0, -self.speed],
        };
        let boundary =
            [Boundary::Periodic { lo: 0.0, hi: self.width() }, Boundary::Plate(Plate::fixed(0.0))];
        System::new(self.places().into_iter().map(grain).collect(), boundary, [0.0; 2])
    }

    fn quiet(&self, [patience, longest]: [f64; 2]) -> Quiet {
        let flight = (self.gap / self.speed).max(self.contact_time);
        Quiet { interval: patience * flight, limit: longest * self.rows as f64 * flight }
    }

    fn restitution_left(&self, grains: &[Grain<2>]) -> f64 {
        let energy: f64 =
            grains.iter().map(|g| g.velocity.iter().map(|v| v * v).sum::<f64>()).sum();
        (energy / grains.len() as f64).sqrt() / self.speed
    }
}
