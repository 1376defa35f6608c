//! Which world do these bytes describe? Reads bytes; writes nothing, panics if the world breaks an invariant.

use super::input::Input;
use super::invariants::Invariants;
use super::rule::{self, DrawnRule};
use super::run::run_world;
use carom::law::Rule;
use carom::space::{Plane, Surface, Vibration};
use carom::world::{NoRule, WorldBuilder};
use carom::{Enduring, Error, Grain, Memory, Release, Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// As many grains as a fuzzed world can hold, and as many cells.
pub const MAX_GRAINS: usize = 40;

/// Everything a fuzzed world is made of.
pub type FuzzMemory<S, const D: usize> = Memory<S, D, MAX_GRAINS>;

/// Builds a world, steps it, and checks the invariants on the way.
///
/// # Errors
/// The error with which the world refused or stopped.
pub fn run(bytes: &[u8]) -> Result<(), Error> {
    let mut input = Input::new(bytes);
    match input.below(6) {
        0 => run_as::<f64, 1>(&mut input),
        1 => run_as::<f64, 2>(&mut input),
        2 => run_as::<f64, 3>(&mut input),
        3 => run_as::<f32, 1>(&mut input),
        4 => run_as::<f32, 2>(&mut input),
        _ => run_as::<f32, 3>(&mut input),
    }
}

fn run_as<S, const D: usize>(input: &mut Input<'_>) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    let DrawnRule { rule, energy_gain } = rule::rule::<S>(input);
    let sites = Sites::new(input);
    let mut memory = Box::new(FuzzMemory::<S, D>::new());
    // What is checked holds there to rounding; `carom soak --heaps` checks the default.
    let mut builder = World::builder(&mut *memory).enduring(Enduring::Paper);
    for axis in 0..D {
        builder = side(builder, input, axis, &sites);
    }
    let gravity =
        std::array::from_fn(|_| if input.below(2) == 0 { S::zero() } else { input.number() });
    let builder = tilted(builder, input).gravity(gravity).release(release(input));
    let builder = if input.below(8) == 7 { builder.tc(input.number()) } else { builder };
    let grains: Vec<Grain<S, D>> =
        (0..input.below(MAX_GRAINS as u8 + 1)).map(|i| grain(input, i.into(), &sites)).collect();
    let builder = builder.rule(&*rule as &dyn Rule<S>).grains(grains)?;
    let world = builder.start()?;
    let invariants = Invariants::new(&world, energy_gain);
    run_world(world, &*rule, input, invariants, 0)
}

/// Lattice sites on which the grains start, so that most worlds do.
struct Sites {
    spacing: f64,
    side: usize,
}

impl Sites {
    fn new(input: &mut Input<'_>) -> Self {
        Self { spacing: input.size(), side: 1 + usize::from(input.below(6)) }
    }

    fn length(&self) -> f64 {
        self.spacing * self.side as f64
    }
}

/// One axis: open, periodic, soft walls or hard ones, tight or with some room, at rest or shaken.
fn side<'m, S: Scalar, const D: usize>(
    builder: WorldBuilder<'m, S, D, NoRule>,
    input: &mut Input<'_>,
    axis: usize,
    sites: &Sites,
) -> WorldBuilder<'m, S, D, NoRule> {
    let kind = input.below(8);
    let slack = if input.below(2) == 0 { 0.0 } else { input.size() };
    let (low, high) = (S::zero(), S::from_f64(sites.length() + slack));
    let surface = match kind {
        0 => return builder,
        1..=3 => return builder.periodic_axis(axis, [low, high]),
        4 => return builder.periodic_axis(axis, [input.number(), input.number()]),
        5 => Surface::Rule,
        _ => Surface::Hard(input.fraction()),
    };
    let shaken = vibration(input);
    let plane = |at: S, facing: f64| {
        let mut normal = [S::zero(); D];
        normal[axis] = S::from_f64(facing);
        let plane = Plane::new(normal, at * S::from_f64(facing), surface);
        Plane { vibration: shaken, ..plane }
    };
    builder.plane(plane(low, 1.0)).plane(plane(high, -1.0))
}

/// How a plate moves: not at all, moderately, or by numbers that may be anything.
fn vibration<S: Scalar>(input: &mut Input<'_>) -> Option<Vibration<S>> {
    let (amplitude, frequency) = match input.below(8) {
        0..=3 => return None,
        4..=6 => (input.fraction(), S::from_f64(input.size())),
        _ => (input.number(), input.number()),
    };
    Some(Vibration::new(amplitude, frequency).starting_at(input.fraction()))
}

/// Sometimes a plane that stands across no axis, or is not one.
fn tilted<'m, S: Scalar, const D: usize>(
    builder: WorldBuilder<'m, S, D, NoRule>,
    input: &mut Input<'_>,
) -> WorldBuilder<'m, S, D, NoRule> {
    let kind = input.below(16);
    if kind < 12 {
        return builder;
    }
    let mut normal: [S; D] = std::array::from_fn(|axis| S::from_f64([0.6, 0.8, 0.0][axis]));
    if kind == 15 {
        normal = std::array::from_fn(|_| input.number());
    }
    let offset = input.number();
    let surface = if input.below(2) == 0 { Surface::Rule } else { Surface::Hard(input.fraction()) };
    builder.plane(Plane { vibration: vibration(input), ..Plane::new(normal, offset, surface) })
}

fn release(input: &mut Input<'_>) -> Release {
    if input.below(4) == 0 { Release::Independent } else { Release::Paired }
}

/// A grain on its site, up to touching its neighbours; now and then anywhere.
fn grain<S: Scalar, const D: usize>(input: &mut Input<'_>, i: usize, sites: &Sites) -> Grain<S, D> {
    let (shape, extreme) = (input.byte(), input.below(32) == 31);
    // Half of all grains fill their site exactly: then everything happens at once.
    let share = if shape < 128 { 1.0 } else { f64::from(shape) / 256.0 };
    let radius = S::from_f64(sites.spacing * 0.5 * share);
    let free = sites.spacing * (1.0 - share);
    let at = std::array::from_fn(|axis| {
        if extreme {
            return input.number();
        }
        let site = (i / sites.side.pow(axis as u32)) % sites.side;
        let off = if share < 1.0 { f64::from(input.byte()) / 255.0 - 0.5 } else { 0.0 };
        S::from_f64(sites.spacing * (site as f64 + 0.5) + free * off)
    });
    let mass = match input.below(16) {
        0..=9 => S::one(),
        10..=14 => S::from_f64(input.size()),
        _ => input.number(),
    };
    let moving = std::array::from_fn(|_| input.number());
    Grain::with_mass(radius, mass).at(at).moving(moving).of_material(input.below(3))
}
