//! What becomes of the same column event by event? Reads a column; writes velocities after the impact, by ED, by eMD* and with clusters.

use super::column::{Column, Outcome};
use crate::any_rule::smooth;
use crate::integrated::Integrated;
use anyhow::{Context, Result, bail};
use carom::HeapMemory;
use carom::law::{HardSphere, LinearDashpot, Rule};
use carom::space::{Plane, Surface};
use carom::world::Statistics;
use carom::{Enduring, Error, Grain, World};
use carom_reference::ForceLaw;
use carom_tables::read::End;

/// More events than a column on a plate should need, in all and for each sample.
const MAX_EVENTS: [u64; 2] = [2_000_000, 2_000];

/// More events than any impact on a wall needs.
const LONGEST: u64 = 20_000_000;
/// The number of events is looked at so often, but no more than 64 times between two samples.
const CHECKS: usize = 16_384;

/// Steps a contact, if nothing else is said.
pub const DEFAULT_STEPS: u32 = 32;

/// How contacts are dealt with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// Instantaneous collisions with ε between beads and ε_wall at the wall (L94 Sec. II B).
    Instant,
    /// Contacts that last as long as the force law says (MP13), until the overlap vanishes.
    Lasting,
    /// The engine's default: the same, but contacts that crowd are integrated.
    Clusters {
        /// How a contact of two ends. In a crowd no dashpot pulls, whatever this says.
        end: End,
        /// Steps a contact; 32 is the default.
        steps: u32,
    },
}

impl Variant {
    /// The engine's default, its contacts of two as those of [`Variant::Lasting`].
    pub const CLUSTERS: Self = Self::Clusters { end: End::Overlap, steps: DEFAULT_STEPS };

    const fn mode(self) -> Enduring {
        match self {
            Self::Instant | Self::Lasting => Enduring::Paper,
            Self::Clusters { .. } => Enduring::Integrated,
        }
    }

    const fn steps(self) -> u32 {
        match self {
            Self::Clusters { steps, .. } => steps,
            _ => DEFAULT_STEPS,
        }
    }

    const fn end(self) -> End {
        match self {
            Self::Clusters { end, .. } => end,
            _ => End::Overlap,
        }
    }
}

/// Spring and dashpot of a [`ForceLaw::PowerLaw`] with β = γ = 0, for beads of mass 1.
///
/// # Errors
/// For any other law.
pub fn dashpot(law: &ForceLaw) -> Result<LinearDashpot<f64>> {
    match *law {
        ForceLaw::PowerLaw { stiffness, beta: 0.0, damping, gamma: 0.0, .. } => {
            Ok(LinearDashpot { stiffness, damping })
        }
        _ => bail!("the event-driven columns know spring and dashpot only"),
    }
}

/// ε of a pair, and at the wall: L94 Eq. (7), with μ = D_n and D_n/2.
pub fn restitution(law: &LinearDashpot<f64>) -> [f64; 2] {
    [0.5, 1.0].map(|mass| {
        let mu = 0.5 * law.damping / mass;
        libm::exp(-mu * std::f64::consts::PI / (law.stiffness / mass - mu * mu).sqrt())
    })
}

/// Lets the column hit the wall, event by event.
///
/// # Errors
/// An error of the engine, or a column that does not come apart.
pub fn collide(column: &Column, law: &ForceLaw, variant: Variant) -> Result<Outcome> {
    let law = dashpot(law)?;
    let [pair, wall] = restitution(&law);
    let surfaces = [Surface::Hard(wall), Surface::Rule];
    match variant {
        Variant::Instant => run(column, HardSphere { restitution: pair }, (surfaces[0], variant)),
        _ => {
            let rule = smooth(Integrated::new(law).ending(variant.end()));
            run(column, rule, (surfaces[1], variant))
        }
    }
}

/// Where the beads are at given times.
///
/// # Errors
/// An error of the engine.
pub fn heights(
    column: &Column,
    law: &ForceLaw,
    variant: Variant,
    times: &[f64],
) -> Result<Vec<Vec<f64>>> {
    let law = dashpot(law)?;
    let [pair, wall] = restitution(&law);
    let mut storage = HeapMemory::<f64, 1>::with_capacity(column.beads);
    match variant {
        Variant::Instant => {
            let rule = HardSphere { restitution: pair };
            let how = (Surface::Hard(wall), variant);
            sampled(&mut start(column, &mut storage, rule, how)?, times)
        }
        _ => {
            let rule = smooth(Integrated::new(law).ending(variant.end()));
            sampled(&mut start(column, &mut storage, rule, (Surface::Rule, variant))?, times)
        }
    }
}

/// Where the grains of a world are at given times, and what was counted until the last of them.
///
/// The list ends early where the engine needs more than two million events, and more than two thousand a sample.
///
/// # Errors
/// An error of the engine.
pub fn counted<R: Rule<f64>>(
    mut world: World<'_, f64, 1, R>,
    times: &[f64],
) -> Result<(Vec<Vec<f64>>, Statistics)> {
    let heights = sampled(&mut world, times)?;
    Ok((heights, *world.statistics()))
}

fn sampled<R: Rule<f64>>(world: &mut World<'_, f64, 1, R>, times: &[f64]) -> Result<Vec<Vec<f64>>> {
    let (mut rows, mut before) = (Vec::new(), 0.0);
    let slices = (CHECKS / times.len().max(1)).clamp(1, 64);
    let most = MAX_EVENTS[0].max(MAX_EVENTS[1] * times.len() as u64);
    for t in times {
        for slice in 1..=slices {
            let part = slice as f64 / slices as f64;
            world.advance_to(if slice == slices { *t } else { before + (t - before) * part })?;
            let Statistics { collisions, plane_collisions, interrupted, .. } = *world.statistics();
            if collisions + plane_collisions + interrupted > most {
                return Ok(rows);
            }
        }
        before = *t;
        let view = world.view();
        let height = |i: usize| view.grain(i).map(|grain| grain.position[0]);
        let row: Option<Vec<f64>> = (0..view.len()).map(height).collect();
        rows.push(row.context("a bead")?);
    }
    Ok(rows)
}

fn run<R: Rule<f64>>(column: &Column, rule: R, how: (Surface<f64>, Variant)) -> Result<Outcome> {
    let mut storage = HeapMemory::<f64, 1>::with_capacity(column.beads);
    let mut world = start(column, &mut storage, rule, how)?;
    for event in 0..LONGEST {
        let over = world.step()?.is_none();
        if over || event % 64 == 63 {
            let velocity = |i: usize| world.grain(i).map(|grain| grain.velocity[0]);
            let all: Option<Vec<f64>> = (0..column.beads).map(velocity).collect();
            let outcome = Outcome::of(all.context("a bead")?.into_iter(), column.speed);
            if over || settled(&outcome) {
                return Ok(outcome);
            }
        }
    }
    bail!("{column:?}: not over after {LONGEST} events")
}

/// The column as a world of the engine.
fn start<'m, R: Rule<f64>>(
    column: &Column,
    storage: &'m mut HeapMemory<f64, 1>,
    rule: R,
    (surface, variant): (Surface<f64>, Variant),
) -> Result<World<'m, f64, 1, R>, Error> {
    let radius = 0.5 * column.diameter;
    let bead = |z: f64| Grain::with_mass(radius, 1.0).at([z]).moving([-column.speed]);
    World::builder(storage)
        .enduring(variant.mode())
        .steps_per_contact(variant.steps())
        .plane(Plane::new([1.0], 0.0, surface))
        .rule(rule)
        .grains(column.heights().into_iter().map(bead))?
        .start()
}

/// Whether what may still happen cannot change the outcome: nothing moves (a collapse at the wall),
/// or all beads leave the wall together (a collapse in flight).
fn settled(outcome: &Outcome) -> bool {
    outcome.restitution() < 1e-7
        || (outcome.velocities.iter().all(|v| *v > 0.0)
            && outcome.relative().is_some_and(|share| share < 1e-12))
}
