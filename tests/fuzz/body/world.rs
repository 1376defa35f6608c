//! Which world do these bytes describe? Reads bytes; writes nothing, panics if the world breaks a promise.

use super::draw::Draw;
use super::judge::Judge;
use super::play::play;
use super::rule::{self, Drawn};
use carom::law::Rule;
use carom::space::{Plane, Surface, Vibration};
use carom::world::{NoRule, WorldBuilder};
use carom::{Error, Grain, Memory, Release, Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// As many grains as a fuzzed world can hold, and as many cells.
pub const MOST: usize = 40;

/// Everything a fuzzed world is made of.
pub type Store<S, const D: usize> = Memory<S, D, MOST>;

/// Builds a world, steps it, and judges it on the way.
///
/// # Errors
/// The fault with which it refused, for whoever wants to know.
pub fn run(bytes: &[u8]) -> Result<(), Error> {
    let mut draw = Draw::new(bytes);
    match draw.below(6) {
        0 => of::<f64, 1>(&mut draw),
        1 => of::<f64, 2>(&mut draw),
        2 => of::<f64, 3>(&mut draw),
        3 => of::<f32, 1>(&mut draw),
        4 => of::<f32, 2>(&mut draw),
        _ => of::<f32, 3>(&mut draw),
    }
}

fn of<S, const D: usize>(draw: &mut Draw<'_>) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    let Drawn { rule, gain } = rule::rule::<S>(draw);
    let sites = Sites::new(draw);
    let mut memory = Box::new(Store::<S, D>::new());
    let mut setup = World::builder(&mut *memory);
    for axis in 0..D {
        setup = side(setup, draw, axis, &sites);
    }
    let gravity =
        std::array::from_fn(|_| if draw.below(2) == 0 { S::zero() } else { draw.number() });
    let setup = tilted(setup, draw).gravity(gravity).release(release(draw));
    let setup = if draw.below(8) == 7 { setup.tc(draw.number()) } else { setup };
    let grains: Vec<Grain<S, D>> =
        (0..draw.below(MOST as u8 + 1)).map(|i| grain(draw, i.into(), &sites)).collect();
    let setup = setup.rule(&*rule as &dyn Rule<S>).grains(grains)?;
    let world = setup.start()?;
    let judge = Judge::new(&world, gain);
    play(world, &*rule, draw, judge, 0)
}

/// Lattice sites on which the grains start, so that most worlds do.
struct Sites {
    spacing: f64,
    side: usize,
}

impl Sites {
    fn new(draw: &mut Draw<'_>) -> Self {
        Self { spacing: draw.size(), side: 1 + usize::from(draw.below(6)) }
    }

    fn length(&self) -> f64 {
        self.spacing * self.side as f64
    }
}

/// One axis: open, periodic, soft walls or hard ones, tight or with some room, at rest or shaken.
fn side<'m, S: Scalar, const D: usize>(
    setup: WorldBuilder<'m, S, D, NoRule>,
    draw: &mut Draw<'_>,
    axis: usize,
    sites: &Sites,
) -> WorldBuilder<'m, S, D, NoRule> {
    let kind = draw.below(8);
    let slack = if draw.below(2) == 0 { 0.0 } else { draw.size() };
    let (low, high) = (S::zero(), S::from_f64(sites.length() + slack));
    let surface = match kind {
        0 => return setup,
        1..=3 => return setup.periodic_axis(axis, [low, high]),
        4 => return setup.periodic_axis(axis, [draw.number(), draw.number()]),
        5 => Surface::Rule,
        _ => Surface::Hard(draw.fraction()),
    };
    let shaken = vibration(draw);
    let plane = |at: S, facing: f64| {
        let mut normal = [S::zero(); D];
        normal[axis] = S::from_f64(facing);
        let plane = Plane::new(normal, at * S::from_f64(facing), surface);
        Plane { vibration: shaken, ..plane }
    };
    setup.plane(plane(low, 1.0)).plane(plane(high, -1.0))
}

/// How a plate moves: not at all, tamely, or by numbers that may be anything.
fn vibration<S: Scalar>(draw: &mut Draw<'_>) -> Option<Vibration<S>> {
    let (amplitude, frequency) = match draw.below(8) {
        0..=3 => return None,
        4..=6 => (draw.fraction(), S::from_f64(draw.size())),
        _ => (draw.number(), draw.number()),
    };
    Some(Vibration::new(amplitude, frequency).starting_at(draw.fraction()))
}

/// Sometimes a plane that stands across no axis, or is not one.
fn tilted<'m, S: Scalar, const D: usize>(
    setup: WorldBuilder<'m, S, D, NoRule>,
    draw: &mut Draw<'_>,
) -> WorldBuilder<'m, S, D, NoRule> {
    let kind = draw.below(16);
    if kind < 12 {
        return setup;
    }
    let mut normal: [S; D] = std::array::from_fn(|axis| S::from_f64([0.6, 0.8, 0.0][axis]));
    if kind == 15 {
        normal = std::array::from_fn(|_| draw.number());
    }
    let offset = draw.number();
    let surface = if draw.below(2) == 0 { Surface::Rule } else { Surface::Hard(draw.fraction()) };
    setup.plane(Plane { vibration: vibration(draw), ..Plane::new(normal, offset, surface) })
}

fn release(draw: &mut Draw<'_>) -> Release {
    if draw.below(4) == 0 { Release::Independent } else { Release::Paired }
}

/// A grain on its site, up to touching its neighbours; now and then anywhere.
fn grain<S: Scalar, const D: usize>(draw: &mut Draw<'_>, i: usize, sites: &Sites) -> Grain<S, D> {
    let (shape, wild) = (draw.byte(), draw.below(32) == 31);
    // Half of all grains fill their site exactly: then everything happens at once.
    let share = if shape < 128 { 1.0 } else { f64::from(shape) / 256.0 };
    let radius = S::from_f64(sites.spacing * 0.5 * share);
    let free = sites.spacing * (1.0 - share);
    let at = std::array::from_fn(|axis| {
        if wild {
            return draw.number();
        }
        let site = (i / sites.side.pow(axis as u32)) % sites.side;
        let off = if share < 1.0 { f64::from(draw.byte()) / 255.0 - 0.5 } else { 0.0 };
        S::from_f64(sites.spacing * (site as f64 + 0.5) + free * off)
    });
    let mass = match draw.below(16) {
        0..=9 => S::one(),
        10..=14 => S::from_f64(draw.size()),
        _ => draw.number(),
    };
    let moving = std::array::from_fn(|_| draw.number());
    Grain::with_mass(radius, mass).at(at).moving(moving).of_material(draw.below(3))
}
