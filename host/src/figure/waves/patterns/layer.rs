//! What does the surface of a shaken layer of rough spheres look like? Runs it; writes mean heights over the plate, cycle by cycle.

use super::surface::Surface;
use anyhow::Result;
use carom::law::{Answer, Impact, Response, Rough, Rule, Tangential};
use carom::space::{Plane, Surface as Material, Vibration};
use carom::world::Rotating;
use carom::{Enduring, Grain, HeapMemory, View, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

/// The filling h, in diameters d: 6 grains on a square of d by d, as Bizon et al. count it.
pub const FILLING: f64 = 5.42;
const GRAINS: f64 = 6.0;
/// Distance of the places at the start, across and upwards.
const SPACING: [f64; 2] = [1.02, 1.05];
/// Instants in each cycle at which the surface is looked at.
pub const PHASES: usize = 8;

/// ε(v) = 1 − 0.3 (v/√(g d))^(3/4), at least 0.7 (C. Bizon, M. D. Shattuck, J. B. Swift, W. D. McCormick and
/// H. L. Swinney, Phys. Rev. Lett. 80, 57, 1998).
///
/// # Units
/// d and g are one.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FallingRestitution;

impl Rule<f64> for FallingRestitution {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        let speed = impact.normal_speed.abs().min(1.0);
        Answer::exact(Response::Instantaneous(1.0 - 0.3 * libm::pow(speed, 0.75)))
    }
}

/// A layer of rough spheres on a plate z_0(t) = A_0 sin(2π f t), in a square box that is periodic. All contacts are
/// events, as in the runs of Bizon et al.
///
/// # Units
///
/// Diameters d, their mass, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Side of the box.
    pub side: f64,
    /// f* = f √(h/g).
    pub frequency: f64,
    /// Γ = A_0 (2π f)²/g.
    pub agitation: f64,
    /// Of the velocities at the start.
    pub seed: u64,
}

impl Layer {
    /// Cycles in a time.
    fn rate(&self) -> f64 {
        self.frequency / FILLING.sqrt()
    }

    fn amplitude(&self) -> f64 {
        self.agitation / (TAU * self.rate()).powi(2)
    }

    /// How many grains.
    pub fn grains(&self) -> usize {
        (GRAINS * self.side * self.side).round() as usize
    }

    fn start(&self) -> impl Iterator<Item = Grain<f64, 3>> + use<> {
        let across = (self.side / SPACING[0]).floor() as usize;
        let step = self.side / across as f64;
        let mut rng = Pcg64::seed_from_u64(self.seed);
        (0..self.grains()).map(move |k| {
            let (x, y, row) = (k % across, k / across % across, k / across / across);
            let at = |n: usize| (n as f64 + 0.5) * step;
            let height = 0.6 + SPACING[1] * row as f64;
            let velocity = std::array::from_fn(|_| rng.random_range(-0.1..0.1));
            Grain::with_mass(0.5, 1.0).at([at(x), at(y), height]).moving(velocity)
        })
    }

    /// Shakes it for so many cycles; hands over each cycle's surfaces, one for each phase.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn run(&self, cycles: usize, mut seen: impl FnMut([Surface; PHASES])) -> Result<()> {
        let count = self.grains();
        let places = HeapMemory::<f64, 3>::with_capacity(count);
        let mut memory = Rotating::new(places, [(); 3].map(|()| vec![[0.0; 3]; count]));
        let plate = Plane::new([0.0, 0.0, 1.0], 0.0, Material::Rule)
            .vibrating(Vibration::new(self.amplitude(), self.rate()));
        let law = Tangential::Walton { mu: 0.5, beta_0: 0.35 };
        let mut world = World::builder(&mut memory)
            .periodic_axis(0, [0.0, self.side])
            .periodic_axis(1, [0.0, self.side])
            .plane(plate)
            .gravity([0.0, 0.0, -1.0])
            .enduring(Enduring::Paper)
            .rule(Rough::spheres(FallingRestitution, law))
            .grains(self.start())?
            .start()?;
        for cycle in 0..cycles {
            let mut surfaces = [(); PHASES].map(|()| Surface::default());
            for (phase, surface) in surfaces.iter_mut().enumerate() {
                let turns = cycle as f64 + phase as f64 / PHASES as f64;
                world.advance_to(turns / self.rate())?;
                *surface = self.look(&world.view(), self.amplitude() * libm::sin(TAU * turns));
            }
            seen(surfaces);
        }
        Ok(())
    }

    /// Mean heights of the grains over a plate at this height.
    fn look(&self, view: &View<'_, f64, 3>, plate: f64) -> Surface {
        let grains = (0..view.len()).filter_map(|i| view.grain(i));
        let points = grains.map(|grain| {
            let [x, y, z] = grain.position.into();
            [x / self.side, y / self.side, z - plate]
        });
        Surface::mean((self.side / 2.0).round() as usize, points)
    }
}
