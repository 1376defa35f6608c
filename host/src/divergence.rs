//! How does an event-driven run leave the force-based one? Runs small gases both ways; writes the error after each collision.
//!
//! A gas of ten grains is a chaotic system: whatever error a method makes in a collision is multiplied
//! by about the mean free path over the grain's size in the next. So the error after the first
//! collision is the method's own, and its growth with the collision number is the gas's.

use crate::any_rule::{SmoothRule, smooth};
use crate::integrated::Integrated;
use carom::HeapMemory;
use carom::law::{Central, IntegratedMode, Outside, PaperMode, Soft, Viscoelastic};
use carom::{Error, Grain, World};
use carom_reference::{
    self, Boundary, End, EventKind, Exact, ForceLaw, Partner, ReferenceError, System,
};
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// Number of grains in each gas.
pub const GRAINS: usize = 10;
/// Radius R in m.
const RADIUS: f64 = 0.1;
/// l = 2R, the unit of the errors.
pub const CONTACT_DISTANCE: f64 = 2.0 * RADIUS;
/// Mass density in kg/m³.
const DENSITY: f64 = 1140.0;
/// Packing fraction: dense enough that ten collisions do not multiply round-off beyond sight.
const PACKING: f64 = 0.02;
/// Thermal speed in m/s.
const SPEED: f64 = 2.0;
/// Soft rubber: l̃ ≈ 30 at thermal speed, so that a contact turns by about a tenth of a radian.
pub const LAW: Viscoelastic<f64> = Viscoelastic { young: 1.0e7, poisson: 0.4, dissipation: 1.0e-4 };

/// How a gas is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// The default: the same, and where three touch, forces.
    Clusters,
    /// eMD*, the matrix of restitution integrated for each contact; until three touch.
    Integrated,
    /// eMD*, the matrix of restitution read from the standard table.
    Table,
    /// eMD: hard spheres with the law's ε(v).
    HardSphere,
}

impl Variant {
    /// All of them, the best first.
    pub const ALL: [Self; 4] = [Self::Clusters, Self::Integrated, Self::Table, Self::HardSphere];

    /// Its name in tables and pictures.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Clusters => "clusters",
            Self::Integrated => "eMD*, integrated",
            Self::Table => "eMD*, standard table",
            Self::HardSphere => "eMD",
        }
    }
}

/// The errors of one variant: `by_collision[k]` holds, for each run that got so far, the largest distance
/// of a free grain from its place in MD after k + 1 collisions, in units of l.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// Which variant.
    pub variant: Variant,
    /// One list for each collision number.
    pub by_collision: Vec<Vec<f64>>,
}

impl Errors {
    /// The median over all runs that got so far; `collision` counts from 0.
    #[must_use]
    pub fn median(&self, collision: usize) -> Option<f64> {
        let mut list = self.by_collision.get(collision)?.clone();
        list.sort_by(f64::total_cmp);
        list.get(list.len() / 2).copied()
    }

    /// The largest over all runs that got so far; `collision` counts from 0.
    #[must_use]
    pub fn max(&self, collision: usize) -> Option<f64> {
        self.by_collision.get(collision)?.iter().copied().max_by(f64::total_cmp)
    }
}

/// The error and where it comes from.
#[derive(Debug, thiserror::Error)]
pub enum DivergenceError {
    /// The reference refused.
    #[error("force-based MD: {0}")]
    Reference(#[from] ReferenceError),
    /// The engine refused.
    #[error("event-driven MD: {0}")]
    Engine(#[from] Error),
}

/// Runs one gas for each seed, through `collisions` collisions; what has pairs only, until three touch.
///
/// # Errors
/// If a method refuses a gas.
pub fn study(
    seeds: impl IntoIterator<Item = u64>,
    collisions: usize,
) -> Result<Vec<Errors>, DivergenceError> {
    let mut all: Vec<Errors> = Variant::ALL
        .into_iter()
        .map(|variant| Errors { variant, by_collision: vec![Vec::new(); collisions] })
        .collect();
    for seed in seeds {
        let grains = gas(seed);
        let (samples, three) = reference_samples(&grains, collisions)?;
        let pairs = samples.iter().take_while(|sample| sample.time < three).count();
        for errors in &mut all {
            let count = if errors.variant == Variant::Clusters { samples.len() } else { pairs };
            let found = compare(errors.variant, &grains, &samples[..count])?;
            for (list, error) in errors.by_collision.iter_mut().zip(found) {
                list.push(error);
            }
        }
    }
    Ok(all)
}

/// The state of the force-based run just after a collision has ended.
struct Sample {
    time: f64,
    /// Position of each grain that is in contact with nothing.
    free: Vec<Option<[f64; 3]>>,
}

/// The edge of the periodic box.
#[must_use]
pub fn edge() -> f64 {
    let volume = 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3) * GRAINS as f64;
    (volume / PACKING).cbrt()
}

/// Ten grains anywhere without overlap, with Maxwellian velocities.
fn gas(seed: u64) -> Vec<Grain<f64, 3>> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let edge = edge();
    let separate = |a: &[f64; 3], b: &[f64; 3]| {
        (0..3).map(|i| nearest(a[i] - b[i]).powi(2)).sum::<f64>()
            > (1.01 * CONTACT_DISTANCE).powi(2)
    };
    let mut places: Vec<[f64; 3]> = Vec::new();
    while places.len() < GRAINS {
        let place = std::array::from_fn(|_| rng.random_range(0.0..edge));
        if places.iter().all(|other| separate(&place, other)) {
            places.push(place);
        }
    }
    let mut speed = || -> f64 {
        SPEED / 3.0_f64.sqrt() * Distribution::<f64>::sample(&StandardNormal, &mut rng)
    };
    places
        .into_iter()
        .map(|at| Grain::sphere(RADIUS, DENSITY).at(at).moving([speed(), speed(), speed()]))
        .collect()
}

fn nearest(x: f64) -> f64 {
    x - edge() * (x / edge()).round()
}

/// The force-based run at tight tolerance: where the free grains are after each collision, and when three touch first.
fn reference_samples(
    grains: &[Grain<f64, 3>],
    collisions: usize,
) -> Result<(Vec<Sample>, f64), ReferenceError> {
    let start = || -> Result<Exact<3>, ReferenceError> {
        let periodic = Boundary::Periodic { lo: 0.0, hi: edge() };
        let grains = grains.iter().map(for_reference).collect();
        let Viscoelastic { young, poisson, dissipation } = LAW;
        let law = ForceLaw::Viscoelastic { young, poisson, dissipation };
        Exact::new(System::new(grains, [periodic; 3], [0.0; 3])?, law, End::Force)
    };
    let mut run = start()?;
    let mut times = Vec::new();
    while times.len() < collisions
        && let Some(event) = run.next_event(f64::MAX)?
    {
        if event.kind == EventKind::End {
            // A little later, so that a contact that an inexact table ends late is over as well.
            let duration = event.time - run.records()[event.record].begin;
            times.push(event.time + 1e-3 * duration);
        }
    }
    let three = run.first_three_grain_contact().unwrap_or(f64::MAX);
    let mut run = start()?;
    let samples = times.into_iter().map(|time| sample(&mut run, time)).collect::<Result<_, _>>()?;
    Ok((samples, three))
}

fn for_reference(grain: &Grain<f64, 3>) -> carom_reference::Grain<3> {
    carom_reference::Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: grain.position.into(),
        velocity: grain.velocity.into(),
    }
}

fn sample(run: &mut Exact<3>, time: f64) -> Result<Sample, ReferenceError> {
    run.advance_to(time)?;
    let busy: Vec<usize> = run
        .records()
        .iter()
        .filter(|record| record.end.is_none_or(|end| end > time))
        .flat_map(|record| match record.partner {
            Partner::Grain(other) => vec![record.grain, other],
            Partner::Wall { .. } => vec![record.grain],
        })
        .collect();
    let free = (0..GRAINS).map(|i| (!busy.contains(&i)).then(|| run.position(i))).collect();
    Ok(Sample { time, free })
}

/// The error at each sample, as far as the run is comparable: until a contact is interrupted, a turn
/// refused or an impact found outside the table.
fn compare(
    variant: Variant,
    grains: &[Grain<f64, 3>],
    samples: &[Sample],
) -> Result<Vec<f64>, Error> {
    let soft = Soft::viscoelastic(LAW, Outside::HardSphere);
    let integrated = Integrated::new(LAW);
    match variant {
        Variant::Clusters => errors(smooth(IntegratedMode(integrated)), grains, samples),
        Variant::Integrated => errors(smooth(PaperMode(integrated)), grains, samples),
        Variant::Table => errors(smooth(PaperMode(soft)), grains, samples),
        Variant::HardSphere => errors(smooth(PaperMode(Central(integrated))), grains, samples),
    }
}

fn errors(
    rule: SmoothRule<'_>,
    grains: &[Grain<f64, 3>],
    samples: &[Sample],
) -> Result<Vec<f64>, Error> {
    let mut storage = HeapMemory::with_capacity(grains.len());
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, edge()]; 3])
        .rule(rule)
        .grains(grains.iter().copied())?
        .start()?;
    let mut found = Vec::new();
    for sample in samples {
        world.advance_to(sample.time)?;
        let statistics = world.statistics();
        let outside = if statistics.joins > 0 { 0 } else { statistics.hard_sphere };
        if statistics.interrupted + statistics.rotation_refused + outside > 0 {
            break;
        }
        let view = world.view();
        let error = sample.free.iter().enumerate().filter_map(|(i, place)| {
            let grain = view.grain(i).filter(|_| view.contact(i).is_none())?;
            let off = (*place)?
                .iter()
                .zip(grain.position.iter())
                .map(|(a, b)| nearest(a - b).powi(2))
                .sum::<f64>();
            Some(off.sqrt() / CONTACT_DISTANCE)
        });
        found.push(error.fold(0.0, f64::max));
    }
    Ok(found)
}
