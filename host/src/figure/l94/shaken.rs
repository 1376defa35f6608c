//! How does a column of beads move on a vibrating plate? Reads beads, ε and the plate; writes heights, by MD, ED, eMD* and with clusters (L94 Sec. V).

use super::hard;
use crate::any_rule::smooth;
use crate::integrated::Integrated;
use anyhow::Result;
use carom::HeapMemory;
use carom::law::{HardSphere, Rule};
use carom::space::{Plane, Surface, Vibration};
use carom::world::Statistics;
use carom::world::WorldBuilder;
use carom::{Enduring, Error, World};
use carom_reference::{Boundary, End, Exact, ForceLaw, Gear, Grain, Plate, System, VerletOptions};
use std::f64::consts::TAU;

/// Gravity (m/s²).
pub const GRAVITY: f64 = 9.81;

/// A column of equal beads under gravity on a plate z_0(t) = A_0 sin(2π f t) (L94 Eq. 1).
///
/// # Units
///
/// SI; the beads' mass is 1 kg, for only K/m and D_n matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaken {
    /// N.
    pub beads: usize,
    /// d.
    pub diameter: f64,
    /// ε of two beads.
    pub restitution: f64,
    /// Their contact time t_c; for ED it only tells K, and with it ε at the plate.
    pub contact_time: f64,
    /// A_0.
    pub amplitude: f64,
    /// f.
    pub frequency: f64,
    /// Between neighbours at the start, where nothing moves but the plate.
    pub gap: f64,
}

impl Shaken {
    /// α = A_0 ω²/g.
    pub fn agitation(&self) -> f64 {
        self.amplitude * (TAU * self.frequency).powi(2) / GRAVITY
    }

    /// The amplitude at which α has this value.
    pub fn amplitude_for(frequency: f64, agitation: f64) -> f64 {
        agitation * GRAVITY / (TAU * frequency).powi(2)
    }

    fn places(&self) -> impl Iterator<Item = f64> + use<> {
        let Self { diameter, gap, .. } = *self;
        (0..self.beads).map(move |k| (k as f64 + 0.5) * diameter + (k + 1) as f64 * gap)
    }

    fn law(&self) -> Result<ForceLaw> {
        Ok(ForceLaw::spring_of(1.0, self.contact_time, self.restitution)?)
    }

    fn system(&self) -> Result<System<1>> {
        let plate =
            Plate { amplitude: self.amplitude, frequency: self.frequency, ..Plate::fixed(0.0) };
        let bead = |z: f64| Grain {
            radius: 0.5 * self.diameter,
            mass: 1.0,
            position: [z],
            velocity: [0.0],
        };
        let grains = self.places().map(bead).collect();
        Ok(System::new(grains, [Boundary::Plate(plate)], [-GRAVITY])?)
    }

    /// Heights of all beads at given times by MD, with L94's integrator in so many steps per contact.
    ///
    /// # Errors
    /// As [`Gear::advance_to`].
    pub fn by_md(&self, times: &[f64], steps: f64) -> Result<Vec<Vec<f64>>> {
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Gear::new(&self.system()?, self.law()?, End::Overlap, options)?;
        let at = |t: &f64| {
            run.advance_to(*t)?;
            Ok((0..self.beads).map(|i| run.position(i)[0]).collect())
        };
        times.iter().map(at).collect()
    }

    /// The same by MD that is exact to about 12 digits, contact by contact: cheaper where contacts are few.
    ///
    /// # Errors
    /// As [`Exact::advance_to`].
    pub fn by_exact_md(&self, times: &[f64]) -> Result<Vec<Vec<f64>>> {
        let mut run = Exact::new(self.system()?, self.law()?, End::Overlap)?;
        let at = |t: &f64| {
            run.advance_to(*t)?;
            Ok((0..self.beads).map(|i| run.position(i)[0]).collect())
        };
        times.iter().map(at).collect()
    }

    /// The same by ED, and what the engine counted.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn by_ed(&self, times: &[f64]) -> Result<(Vec<Vec<f64>>, Statistics)> {
        let [pair, wall] = hard::restitution(&hard::dashpot(&self.law()?)?);
        let mut storage = HeapMemory::<f64, 1>::with_capacity(self.beads);
        let rule = HardSphere { restitution: pair };
        let world = self.on(
            World::builder(&mut storage).enduring(Enduring::Paper).rule(rule),
            Surface::Hard(wall),
        )?;
        hard::counted(world, times)
    }

    /// The same by eMD*.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn by_star(&self, times: &[f64]) -> Result<(Vec<Vec<f64>>, Statistics)> {
        self.lasting(times, Enduring::Paper)
    }

    /// The same by the engine's default: contacts that crowd are integrated. No dashpot pulls then.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn by_clusters(&self, times: &[f64]) -> Result<(Vec<Vec<f64>>, Statistics)> {
        self.lasting(times, Enduring::Integrated)
    }

    fn lasting(&self, times: &[f64], mode: Enduring) -> Result<(Vec<Vec<f64>>, Statistics)> {
        let law = hard::dashpot(&self.law()?)?;
        let mut storage = HeapMemory::<f64, 1>::with_capacity(self.beads);
        let rule = smooth(Integrated::new(law).ending(carom_tables::read::End::Overlap));
        let builder = World::builder(&mut storage).enduring(mode).rule(rule);
        hard::counted(self.on(builder, Surface::Rule)?, times)
    }

    fn on<'m, R: Rule<f64>>(
        &self,
        builder: WorldBuilder<'m, f64, 1, R>,
        surface: Surface<f64>,
    ) -> Result<World<'m, f64, 1, R>, Error> {
        let vibration = Vibration::new(self.amplitude, self.frequency);
        let bead = |z: f64| carom::Grain::with_mass(0.5 * self.diameter, 1.0).at([z]);
        builder
            .plane(Plane::new([1.0], 0.0, surface).vibrating(vibration))
            .gravity([-GRAVITY])
            .grains(self.places().map(bead))?
            .start()
    }
}
