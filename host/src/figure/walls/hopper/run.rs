//! How much runs out of a hopper in a time? Runs rough disks; those that have left it fall in again at the top.

use crate::any_rule::AnyRule;
use crate::figure::fit;
use anyhow::{Result, ensure};
use carom::law::{LinearDashpot, Outside, Rough, Soft, Tangential};
use carom::space::{Facet, Surface};
use carom::world::{Rotating, WithContacts, WithObstacles};
use carom::{Error, Grain, HeapMemory, View};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Width of the hopper (d): two and a half times the widest opening, so that the walls do not matter.
const WIDTH: f64 = 38.0;
/// Its height, and where disks that have left it come in again: above all others.
const HEIGHT: f64 = 60.0;
const INLET: f64 = 45.0;
/// Below this they have left.
const OUTLET: f64 = -2.0;
const DISKS: usize = 1500;
/// Radii are spread evenly by so much about the mean.
const SPREAD: f64 = 0.1;
/// Distance of places at the start, and at the inlet.
const SPACING: f64 = 1.02 * (1.0 + SPREAD);
/// k (m g/d): two overlap by half a hundredth of d under the weight of 20 disks.
const STIFFNESS: f64 = 4000.0;
/// γ over that of a contact without rebound: with it two of mean size part with ε = 1/2.
const DAMPING: f64 = 0.215_45;
const MU: f64 = 0.5;
const STEPS: u32 = 12;
/// How often disks are taken from below to the inlet (√(d/g)), and how fast they come in.
const SLICE: f64 = 0.25;
const INFLOW: f64 = 4.0;
/// Blocks of the mean.
const BLOCKS: usize = 20;

/// A hopper with a flat floor that has an opening in the middle, full of disks.
///
/// # Units
/// Mean diameters d, the mass m of a disk of that size, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hopper {
    /// D.
    pub opening: f64,
    /// Of the radii.
    pub seed: u64,
}

/// What runs out of a hopper.
///
/// # Units
/// d; m √(g/d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// D.
    pub opening: f64,
    /// Mass per time.
    pub mean: f64,
    /// Its standard error, from blocks in time.
    pub error: f64,
}

type World<'m> = carom::World<'m, f64, 2, AnyRule<'m>>;

/// Places in a row across the hopper.
fn row() -> impl Iterator<Item = f64> + Clone {
    let places = ((WIDTH - SPACING) / SPACING) as i32;
    (0..=places).map(move |k| SPACING * (f64::from(k) - 0.5 * f64::from(places)))
}

/// Springs and dashpots along and across the line of centres; the latter are held to μ times the normal force.
fn rule() -> AnyRule<'static> {
    let damping = DAMPING * (2.0 * STIFFNESS).sqrt();
    let normal = LinearDashpot { stiffness: STIFFNESS, damping };
    let across = Tangential::Spring { mu: MU, stiffness: 0.5 * STIFFNESS, damping: 0.5 * damping };
    Box::new(Rough::disks(Soft::linear_dashpot(normal, Outside::HardSphere), across))
}

impl Hopper {
    fn disks(&self) -> impl Iterator<Item = Grain<f64, 2>> + use<> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let rows = (0..).map(|k| SPACING * (f64::from(k) + 0.6));
        let places = rows.flat_map(|y| row().map(move |x| [x, y]));
        places.take(DISKS).map(move |at| {
            let radius = 0.5 * rng.random_range(1.0 - SPREAD..1.0 + SPREAD);
            let velocity = [rng.random_range(-0.1..0.1), 0.0];
            Grain::with_mass(radius, 4.0 * radius * radius).at(at).moving(velocity)
        })
    }

    fn walls(&self) -> [Facet<f64, 2>; 4] {
        let (wide, open) = (0.5 * WIDTH, 0.5 * self.opening);
        let facet = |from, to| Facet::new([from, to], Surface::Rule);
        [
            facet([-wide, HEIGHT], [-wide, 0.0]),
            facet([-wide, 0.0], [-open, 0.0]),
            facet([open, 0.0], [wide, 0.0]),
            facet([wide, 0.0], [wide, HEIGHT]),
        ]
    }

    /// Lets disks out: so many before it is looked at, so many while it is.
    ///
    /// # Errors
    /// An error of the engine; a hopper that no disk leaves any longer.
    pub fn run(&self, [before, counted]: [usize; 2]) -> Result<Rate> {
        let lists = vec![Default::default(); 8192];
        let places = HeapMemory::<f64, 2>::with_capacity(DISKS);
        let spins = Rotating::new(places, [(); 3].map(|()| vec![0.0; DISKS]));
        let contacts = WithContacts::new(spins, vec![Default::default(); 8 * DISKS]);
        let mut memory = WithObstacles::new(contacts, self.walls().to_vec(), lists);
        let world = carom::World::builder(&mut memory)
            .gravity([0.0, -1.0])
            .steps_per_contact(STEPS)
            .rule(rule())
            .grains(self.disks())?
            .start()?;
        let mut flow = Flow { world, waiting: Vec::new(), turn: 0, slices: 0 };
        flow.let_out(before)?;
        let masses = flow.let_out(counted)?;
        let blocks = masses.chunks_exact(masses.len() / BLOCKS);
        let rates: Vec<f64> =
            blocks.map(|block| block.iter().sum::<f64>() / (block.len() as f64 * SLICE)).collect();
        let [mean, error] = fit::mean(&rates);
        Ok(Rate { opening: self.opening, mean, error })
    }
}

/// A hopper that runs.
struct Flow<'m> {
    world: World<'m>,
    /// Disks that have left and are not in again.
    waiting: Vec<Grain<f64, 2>>,
    /// At which place of the row the next one comes in.
    turn: usize,
    /// How many have passed.
    slices: u32,
}

impl Flow<'_> {
    /// The masses that leave in one slice after the other, until so many disks have left.
    fn let_out(&mut self, count: usize) -> Result<Vec<f64>> {
        let (mut masses, mut left, mut idle) = (Vec::new(), 0, 0);
        while left < count {
            self.slices += 1;
            self.world.advance_to(f64::from(self.slices) * SLICE)?;
            let gone = self.take_out()?;
            idle = if gone.is_empty() { idle + 1 } else { 0 };
            ensure!(
                idle < 400,
                "the opening is blocked: no disk has left it for {}",
                400.0 * SLICE
            );
            masses.push(gone.iter().map(|disk| disk.mass).sum());
            left += gone.len();
            self.waiting.extend(gone);
            self.fill()?;
        }
        Ok(masses)
    }

    fn take_out(&mut self) -> Result<Vec<Grain<f64, 2>>> {
        let below = |view: &View<'_, f64, 2>, i: usize| {
            view.grain(i).is_some_and(|disk| disk.position[1] < OUTLET)
        };
        let view = self.world.view();
        let gone: Vec<usize> = (0..view.len()).filter(|&i| below(&view, i)).collect();
        Ok(gone.into_iter().map(|i| self.world.remove(i)).collect::<Result<_, _>>()?)
    }

    /// Disks that wait come in where there is room.
    fn fill(&mut self) -> Result<()> {
        let places: Vec<f64> = row().collect();
        for k in 0..places.len() {
            let Some(&disk) = self.waiting.last() else { break };
            let x = places[(self.turn + k) % places.len()];
            match self.world.add(disk.at([x, INLET]).moving([0.0, -INFLOW])) {
                Ok(_) => self.waiting.truncate(self.waiting.len() - 1),
                Err(Error::Overlap { .. }) => {}
                Err(error) => return Err(error.into()),
            }
        }
        // The next ones come in elsewhere.
        self.turn = (self.turn + 17) % places.len();
        Ok(())
    }
}
