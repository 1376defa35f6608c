//! How do shaken disks flow? Runs a layer in two dimensions by MD and event by event; writes mean velocity fields.

use anyhow::{Context, Result};
use carom::law::HardSphere;
use carom::space::{Plane, Surface, Vibration};
use carom::{HeapMemory, World};
use carom_reference::{Boundary, End, ForceLaw, Grain, Plate, System, Verlet, VerletOptions};
use carom_tables::contact;
use carom_tables::read::{self, Groups, Law};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::{PI, TAU};

/// Places of the field, across and upwards.
pub const PLACES: [usize; 2] = [24, 10];
/// Their size (d).
pub const PLACE: [f64; 2] = [2.0, 1.6];
/// Instants in each cycle at which the field is looked at.
pub const PHASES: usize = 4;

/// A layer of disks between side walls, on a plate z_0(t) = A_0 sin(2π f t); all of one force law.
///
/// # Units
///
/// Diameters d, their mass, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disks {
    /// Beside each other and above each other at the start.
    pub grains: [usize; 2],
    /// Γ = A_0 (2π f)²/g.
    pub agitation: f64,
    /// f √(d/g).
    pub frequency: f64,
    /// t_c √(g/d) of two disks in MD.
    pub contact_time: f64,
    /// γ in units of √(k m/2): what c_dis of two disks is.
    pub c_dis: f64,
    /// Of the velocities at the start.
    pub seed: u64,
}

/// Mean velocities, relative to the mean of all disks, and how many disks were there, place by place from the
/// lowest row on.
#[derive(Clone, Debug)]
pub struct Field {
    /// Sums of velocities.
    sums: Vec<[f64; 2]>,
    /// Disks.
    counts: Vec<f64>,
    /// Instants.
    instants: f64,
}

/// The fields of even and odd cycles, at each phase.
pub type Flow = Vec<[Field; 2]>;

impl Field {
    fn empty() -> Self {
        let places = PLACES[0] * PLACES[1];
        Self { sums: vec![[0.0; 2]; places], counts: vec![0.0; places], instants: 0.0 }
    }

    /// Adds one instant: places over the plate and velocities.
    fn add(&mut self, disks: &[[[f64; 2]; 2]]) {
        self.instants += 1.0;
        let mean = |axis: usize| {
            disks.iter().map(|[_, velocity]| velocity[axis]).sum::<f64>() / disks.len() as f64
        };
        let mean = [mean(0), mean(1)];
        for [place, velocity] in disks {
            self.add_one(*place, [velocity[0] - mean[0], velocity[1] - mean[1]]);
        }
    }

    fn add_one(&mut self, place: [f64; 2], velocity: [f64; 2]) {
        let [x, z] = [0, 1].map(|axis| (place[axis] / PLACE[axis]).max(0.0) as usize);
        if x < PLACES[0] && z < PLACES[1] {
            let k = x + PLACES[0] * z;
            self.counts[k] += 1.0;
            (0..2).for_each(|axis| self.sums[k][axis] += velocity[axis]);
        }
    }

    /// The mean velocity in place k, none where next to no disk was.
    pub fn velocity(&self, k: usize) -> Option<[f64; 2]> {
        let enough = self.counts[k] >= 0.25 * self.instants;
        enough.then(|| self.sums[k].map(|sum| sum / self.counts[k]))
    }

    /// The mean horizontal velocity of all disks in each column.
    pub fn across(&self) -> Vec<f64> {
        let column = |x: usize| (0..PLACES[1]).map(move |z| x + PLACES[0] * z);
        let sum = |x: usize| column(x).map(|k| self.sums[k][0]).sum::<f64>();
        let count = |x: usize| column(x).map(|k| self.counts[k]).sum::<f64>();
        (0..PLACES[0]).map(|x| sum(x) / count(x).max(1.0)).collect()
    }
}

impl Disks {
    /// Box width.
    pub const fn width() -> f64 {
        PLACES[0] as f64 * PLACE[0]
    }

    fn amplitude(&self) -> f64 {
        self.agitation / (TAU * self.frequency).powi(2)
    }

    /// k and γ.
    fn spring(&self) -> [f64; 2] {
        // π/ω without damping; two disks have m/2.
        let stiffness = 0.5 * (PI / self.contact_time).powi(2);
        [stiffness, self.c_dis * (0.5 * stiffness).sqrt()]
    }

    /// ε of a pair and of a disk at a wall: what MD's force law gives.
    pub fn restitution(&self) -> [f64; 2] {
        // At a wall the mass is twice that of a pair: c_dis = γ/√(k m).
        [self.c_dis, self.c_dis * 0.5_f64.sqrt()].map(|c_dis| {
            let central = Groups { sin: 0.0, cos: 1.0, eta: 0.0, c_dis };
            contact::integrate(Law::LinearDashpot, read::End::Force, &central).speed
        })
    }

    fn start(&self) -> Vec<[[f64; 2]; 2]> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let [across, rows] = self.grains;
        let step = Self::width() / across as f64;
        let one = |k: usize| {
            let (x, row) = (k % across, k / across);
            let at = [(x as f64 + 0.5) * step, 0.6 + 1.02 * row as f64];
            [at, std::array::from_fn(|_| rng.random_range(-0.1..0.1))]
        };
        (0..across * rows).map(one).collect()
    }

    /// The instants: cycle, phase, time and the plate's height.
    fn instants(
        &self,
        [before, cycles]: [usize; 2],
    ) -> impl Iterator<Item = (usize, usize, f64, f64)> {
        let (frequency, amplitude) = (self.frequency, self.amplitude());
        (before..cycles).flat_map(move |cycle| {
            (0..PHASES).map(move |phase| {
                let turns = cycle as f64 + phase as f64 / PHASES as f64;
                (cycle, phase, turns / frequency, amplitude * libm::sin(TAU * turns))
            })
        })
    }

    /// Event by event: hard disks of the same ε, by the engine's default.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn by_events(&self, cycles: [usize; 2]) -> Result<Flow> {
        let [restitution, wall] = self.restitution();
        let starts = self.start();
        let mut storage = HeapMemory::<f64, 2>::with_capacity(starts.len());
        let disk = |[at, v]: &[[f64; 2]; 2]| carom::Grain::with_mass(0.5, 1.0).at(*at).moving(*v);
        let plate = Plane::new([0.0, 1.0], 0.0, Surface::Hard(wall))
            .vibrating(Vibration::new(self.amplitude(), self.frequency));
        let mut world = World::builder(&mut storage)
            .plane(Plane::new([1.0, 0.0], 0.0, Surface::Hard(wall)))
            .plane(Plane::new([-1.0, 0.0], -Self::width(), Surface::Hard(wall)))
            .plane(plate)
            .gravity([0.0, -1.0])
            .rule(HardSphere { restitution })
            .grains(starts.iter().map(disk))?
            .start()?;
        let mut flow = vec![[Field::empty(), Field::empty()]; PHASES];
        for (cycle, phase, time, plate) in self.instants(cycles) {
            world.advance_to(time)?;
            let disk = |i| {
                let grain = world.grain(i).context("a disk")?;
                let place = [grain.position[0], grain.position[1] - plate];
                Ok([place, [grain.velocity[0], grain.velocity[1]]])
            };
            let disks: Vec<_> = (0..starts.len()).map(disk).collect::<Result<_>>()?;
            flow[phase][cycle % 2].add(&disks);
        }
        Ok(flow)
    }

    /// By MD, velocity Verlet in so many steps a contact.
    ///
    /// # Errors
    /// As [`Verlet::advance_to`].
    pub fn by_md(&self, cycles: [usize; 2], steps: f64) -> Result<Flow> {
        let disk = |[position, velocity]: [[f64; 2]; 2]| Grain {
            radius: 0.5,
            mass: 1.0,
            position,
            velocity,
        };
        let grains = self.start().into_iter().map(disk).collect();
        let walls = Boundary::Walls { lo: 0.0, hi: Self::width() };
        let plate =
            Plate { amplitude: self.amplitude(), frequency: self.frequency, ..Plate::fixed(0.0) };
        let system = System::new(grains, [walls, Boundary::Plate(plate)], [0.0, -1.0])?;
        let [stiffness, damping] = self.spring();
        let law = ForceLaw::LinearDashpot { stiffness, damping };
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Verlet::new(&system, law, End::Force, options)?;
        let mut flow = vec![[Field::empty(), Field::empty()]; PHASES];
        for (cycle, phase, time, plate) in self.instants(cycles) {
            run.advance_to(time)?;
            let disk =
                |grain: &Grain<2>| [[grain.position[0], grain.position[1] - plate], grain.velocity];
            let disks: Vec<_> = run.grains().iter().map(disk).collect();
            flow[phase][cycle % 2].add(&disks);
        }
        Ok(flow)
    }
}
