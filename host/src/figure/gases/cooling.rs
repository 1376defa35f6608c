//! How does a gas of viscoelastic grains cool? Runs it by eMD*, and one of constant ε beside it; writes T(t) and its exponent, with theory.
//!
//! Schwager and Pöschel (Phys. Rev. E 57, 650, 1998): collisions of viscoelastic spheres grow more elastic as
//! they grow slower, 1 − ε ~ v^(1/5), so that T ~ t^(−5/3) and not Haff's t^(−2).

use super::theory::Theory;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::figure::mp13::gas::{RADIUS, SPEED, SoftGas, mass};
use crate::figure::number::{fixed, measured, significant};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom::law::{HardSphere, Impact, Response, Rule};
use carom::{Grain, HeapMemory, Statistics, World};
use rayon::prelude::*;
use std::f64::consts::PI;

/// MP13's gas, but denser, in a box of three free paths, and with ε = 0.8 at the start.
pub const GAS: SoftGas =
    SoftGas { grains: 1_000, packing: 0.01, young: 1e9, dissipation: 8e-5, seed: 1 };
/// The constant ε of the other gas.
const CONSTANT: f64 = 0.9;
const SEEDS: u64 = 4;
/// Times in every power of ten.
const A_DECADE: usize = 8;
/// The first time, in units of τ.
const FIRST: f64 = 0.1;
/// Powers of ten of the figure, from the first time on.
const DECADES: usize = 9;
/// From where to where exponents are fitted, in units of τ.
pub const LATE: [f64; 2] = [1e2, 1e8];

/// What a gas did.
#[derive(Clone, Debug)]
pub struct Course {
    /// T/T_0 at the [`times`].
    pub temperatures: Vec<f64>,
    /// The energy of the longest waves of its flow at the end, in units of what a gas in equilibrium has.
    pub waves: f64,
    /// By the engine.
    pub statistics: Statistics,
}

/// Times in units of τ.
pub fn times(decades: usize) -> Vec<f64> {
    let time = |k| FIRST * 10f64.powf(k as f64 / A_DECADE as f64);
    (0..=decades * A_DECADE).map(time).collect()
}

/// The exponent of T(t) between two times in units of τ.
pub fn exponent(times: &[f64], temperatures: &[f64], [from, to]: [f64; 2]) -> f64 {
    let inside = |t: f64| t > 0.99 * from && t < 1.01 * to;
    let some = times.iter().zip(temperatures).filter(|(t, _)| inside(**t));
    let (x, y): (Vec<f64>, Vec<f64>) = some.unzip();
    fit::slope(&x, &y)
}

/// Runs a gas with this rule; times are in units of `unit`.
///
/// # Errors
/// An error of the engine.
pub fn run(gas: &SoftGas, rule: impl Rule<f64>, unit: f64, times: &[f64]) -> Result<Course> {
    let half = 0.5 * gas.edge();
    let mut storage = HeapMemory::<f64, 3>::with_capacity(gas.grains);
    let builder = World::builder(&mut storage).periodic([[-half, half]; 3]).rule(rule);
    let mut world = builder.grains(gas.start()?)?.start()?;
    let first = world.view().kinetic_energy();
    let mut temperatures = Vec::new();
    for t in times {
        world.advance_to(t * unit)?;
        temperatures.push(world.view().kinetic_energy() / first);
    }
    let all = (0..gas.grains).map(|i| world.grain(i));
    let grains = all.collect::<Option<Vec<_>>>().context("a grain")?;
    Ok(Course { temperatures, waves: waves(&grains, gas.edge()), statistics: *world.statistics() })
}

/// The energy of the six longest shear waves, for each of them and in units of a thermal one: 1 when there is no flow.
fn waves(grains: &[Grain<f64, 3>], edge: f64) -> f64 {
    let square: f64 = grains.iter().map(|grain| grain.velocity.norm_squared()).sum();
    let mut sum = 0.0;
    for (along, across) in [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)] {
        let phase = |grain: &Grain<f64, 3>| 2.0 * PI * grain.position[along] / edge;
        let part = |of: fn(f64) -> f64| -> f64 {
            grains.iter().map(|grain| grain.velocity[across] * of(phase(grain))).sum()
        };
        sum += part(libm::cos).powi(2) + part(libm::sin).powi(2);
    }
    0.5 * sum / square
}

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let (theory, times) = (Theory::new(&GAS), times(DECADES));
    let progress = Progress::new("cooling", 2 * SEEDS);
    let one = |k: u64| -> Result<Course> {
        let gas = SoftGas { seed: 1 + k / 2, ..GAS };
        let course = match k % 2 {
            0 => run(&gas, gas.rule(), theory.unit(), &times),
            _ => run(&gas, HardSphere { restitution: CONSTANT }, theory.unit(), &times),
        };
        progress.add(1);
        course
    };
    let all: Vec<Course> = (0..2 * SEEDS).into_par_iter().map(one).collect::<Result<_>>()?;
    let (soft, hard): (Vec<Course>, Vec<Course>) =
        all.chunks_exact(2).map(|two| (two[0].clone(), two[1].clone())).unzip();
    let expected = [theory.temperatures(&times), theory.haff(CONSTANT, &times)];
    let figure = Figure::new("cooling", ["t/τ", "T/T_0"])
        .with(series("viscoelastic, eMD*", "eMD*", &times, &soft))
        .with(series("ε = 0.9, hard spheres", "ED", &times, &hard));
    let picture = picture(&figure, &times, &expected);
    let figure = figure.with(listed("theory, viscoelastic", &times, &expected[0])).with(listed(
        "Haff's law, ε = 0.9",
        &times,
        &expected[1],
    ));
    let notes = notes(&theory, &times, [&soft, &hard], &expected);
    Ok(Made { figure, picture, notes })
}

/// The mean of ln T over all gases, with its error.
fn mean_log(all: &[Course], k: usize) -> [f64; 2] {
    fit::mean(&all.iter().map(|course| libm::log(course.temperatures[k])).collect::<Vec<_>>())
}

fn series(name: &str, method: &str, times: &[f64], all: &[Course]) -> Series {
    let mut series = Series::new(name).param("method", method);
    for (k, t) in times.iter().enumerate() {
        let [log, error] = mean_log(all, k);
        series.push_with_error(*t, libm::exp(log), libm::exp(log) * error);
    }
    series
}

fn listed(name: &str, times: &[f64], temperatures: &[f64]) -> Series {
    let series = Series::new(name).param("method", "theory");
    times.iter().zip(temperatures).fold(series, |series, (t, y)| series.point(*t, *y))
}

fn picture(figure: &Figure, times: &[f64], expected: &[Vec<f64>; 2]) -> Scene {
    let curve = |all: &[f64]| times.iter().zip(all).map(|(t, y)| [*t, *y]).collect();
    let style = PlotStyle::new("A gas of viscoelastic grains cools (*N* = 1,000, η = 0.01)")
        .labels("*t*/τ", "*T*/*T*_{0}")
        .scales(Scale::LOG, Scale::LOG)
        .kinds(&[Kind::Dots])
        .mark(Mark::Curve(curve(&expected[0]), "theory, to *t*^{−5/3}".to_owned()))
        .mark(Mark::Curve(curve(&expected[1]), "Haff’s law, to *t*^{−2}".to_owned()));
    draw::draw(figure, &style)
}

fn notes(
    theory: &Theory,
    times: &[f64],
    [soft, hard]: [&[Course]; 2],
    expected: &[Vec<f64>; 2],
) -> Vec<Note> {
    let range = "ln T over ln t, 10² to 10⁸ τ";
    let fitted = |all: &[Course], range: [f64; 2]| {
        let one = |course: &Course| exponent(times, &course.temperatures, range);
        fit::mean(&all.iter().map(one).collect::<Vec<_>>())
    };
    let slope = |all: &[Course]| {
        let [value, error] = fitted(all, LATE);
        measured(value, error)
    };
    let formula = |k: usize| fixed(exponent(times, &expected[k], LATE), 4);
    let decades = (2..8).map(|k| fitted(soft, [10f64.powi(k), 10f64.powi(k + 1)])[0]);
    let decades: Vec<String> = decades.map(|slope| fixed(slope, 3)).collect();
    vec![
        Note::new(format!("viscoelastic: {range}"), "-5/3 = -1.6667", slope(soft))
            .theory(formula(0)),
        Note::new("the same in each power of ten", "-1.667", decades.join(", ")),
        Note::new(format!("ε = 0.9: {range}"), "-2 (Haff)", slope(hard)).theory(formula(1)),
        reached("viscoelastic", soft, &expected[0]),
        reached("ε = 0.9", hard, &expected[1]),
        losses(theory, soft),
        counts("viscoelastic", soft),
        counts("ε = 0.9", hard),
    ]
}

/// How far T fell.
fn reached(what: &str, all: &[Course], expected: &[f64]) -> Note {
    let last = expected.len() - 1;
    let [log, error] = mean_log(all, last);
    let more = 100.0 * (libm::exp(log) / expected[last] - 1.0);
    let error = 100.0 * error;
    let says = format!(
        "{} ({} ± {} % from theory)",
        significant(libm::exp(log), 4),
        fixed(more, 1),
        fixed(error, 1)
    );
    Note::new(format!("{what}: T/T_0 at the end"), "not given", says)
        .theory(significant(expected[last], 4))
}

/// 1 − ε of a central collision at the thermal velocity, by the table and by the theory's two terms.
fn losses(theory: &Theory, soft: &[Course]) -> Note {
    let last = libm::exp(mean_log(soft, soft[0].temperatures.len() - 1)[0]);
    let shown = |[first, last]: [f64; 2]| format!("{}, {}", fixed(first, 3), fixed(last, 4));
    let of_table = |temperature: f64| {
        let answer = GAS.rule().collide(&Impact {
            contact_distance: 2.0 * RADIUS,
            effective_radius: RADIUS / 2.0,
            reduced_mass: mass() / 2.0,
            normal_speed: (2.0 * temperature).sqrt() * SPEED,
            tangential_speed: 0.0,
            acceleration: 0.0,
            materials: [0, 0],
        });
        match answer.response {
            Response::Lasting(found) => 1.0 - found.restitution,
            _ => f64::NAN,
        }
    };
    Note::new("1 − ε at √(2 kT/m), first and last", "not given", shown([1.0, last].map(of_table)))
        .theory(shown([1.0, last].map(|t| theory.typical_loss(t))))
}

/// What the engine counted, and whether the gas is still the same everywhere.
fn counts(what: &str, all: &[Course]) -> Note {
    let sum = |of: fn(&Statistics) -> u64| all.iter().map(|one| of(&one.statistics)).sum::<u64>();
    let each = 2 * sum(|of| of.collisions) / (all.len() as u64 * GAS.grains as u64);
    let [waves, error] = fit::mean(&all.iter().map(|one| one.waves).collect::<Vec<_>>());
    let says = format!(
        "{each} collisions a grain, {} outside the table, {} clustered; energy of the longest shear waves {} kT",
        sum(|of| of.hard_sphere),
        sum(|of| of.joins),
        measured(waves, error)
    );
    Note::new(format!("{what}: counted"), "not given", says)
}
