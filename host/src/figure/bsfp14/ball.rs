//! Does a bouncing ball come to rest, and on how many plates? Drops it by naive and by stable detection; writes how that ended (BSFP14 Fig. 7).
//!
//! The ball of diameter σ = 1 falls from r = r_plate + 1, so by 1/2, with ε = 0.5; the paper does not
//! say what g is, here it is 9.81. In exact arithmetic it hits the plate first at t_1 = √(1/9.81) and comes
//! to rest, after infinitely many impacts, at t_final = t_1 (1 + ε)/(1 − ε), wherever the plate is.

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::progress::Progress;
use anyhow::Result;
use carom::detect::root;
use carom::law::HardSphere;
use carom::{Enduring, Error, Grain, Memory, World};
use rayon::prelude::*;

const SIGMA: f64 = 1.0;
const GRAVITY: f64 = -9.81;
const RESTITUTION: f64 = 0.5;
/// A naive simulation with so many impacts does not halt any more.
const ENOUGH: u32 = 200;

/// The closed form of the time at which the ball comes to rest.
pub fn t_final() -> f64 {
    (2.0 * (1.0 - SIGMA / 2.0) / -GRAVITY).sqrt() * (1.0 + RESTITUTION) / (1.0 - RESTITUTION)
}

/// How the overlap function is written: three variants that differ by rounding only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// f = r − r_p − σ/2, as in Eq. (11).
    InTurn,
    /// f = r − (r_p + σ/2).
    Summed,
    /// f = r − σ/2 − r_p.
    Lowest,
}

/// How the flight is written: two variants that differ by rounding only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flight {
    /// r + Δt v + Δt²/2 g, as in Eq. (11).
    InTurn,
    /// r + Δt (v + Δt/2 g).
    Nested,
}

/// How the next impact is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// By BSFP14's rule, Algorithm 2; otherwise by the quadratic formula, Eq. (12).
    pub stable: bool,
    /// How the overlap function is written.
    pub form: Form,
    /// How the flight is written.
    pub flight: Flight,
}

impl Variant {
    /// All of them: naive first.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for stable in [false, true] {
            for flight in [Flight::InTurn, Flight::Nested] {
                for form in [Form::InTurn, Form::Summed, Form::Lowest] {
                    all.push(Self { stable, form, flight });
                }
            }
        }
        all
    }

    /// By which rule the next impact is found.
    pub fn method(self) -> &'static str {
        if self.stable { "stable" } else { "naive" }
    }

    /// f in letters.
    pub fn form(self) -> &'static str {
        match self.form {
            Form::InTurn => "r − r_p − σ/2",
            Form::Summed => "r − (r_p + σ/2)",
            Form::Lowest => "r − σ/2 − r_p",
        }
    }

    /// The flight in letters.
    pub fn flight(self) -> &'static str {
        match self.flight {
            Flight::InTurn => "r + Δt v + Δt²/2 g",
            Flight::Nested => "r + Δt (v + Δt/2 g)",
        }
    }

    /// The overlap function at Δt = 0.
    fn gap(self, r: f64, plate: f64) -> f64 {
        match self.form {
            Form::InTurn => r - plate - SIGMA / 2.0,
            Form::Summed => r - (plate + SIGMA / 2.0),
            Form::Lowest => r - SIGMA / 2.0 - plate,
        }
    }

    fn fly(self, r: f64, v: f64, dt: f64) -> f64 {
        match self.flight {
            Flight::InTurn => r + dt * v + dt * dt / 2.0 * GRAVITY,
            Flight::Nested => r + dt * (v + 0.5 * dt * GRAVITY),
        }
    }

    /// The time until the next impact; none if the simulation must be halted.
    fn next(self, gap: f64, v: f64) -> Option<f64> {
        if self.stable {
            return root::plane(gap, v, GRAVITY);
        }
        let discriminant = v * v - 2.0 * GRAVITY * gap;
        (discriminant >= 0.0).then(|| -(v + discriminant.sqrt()) / GRAVITY)
    }
}

/// How one simulation ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// The discriminant became negative: no next impact could be computed.
    pub halted: bool,
    /// When.
    pub time: f64,
    /// After how many impacts.
    pub impacts: u32,
}

/// Drops the ball on a plate. It is at rest when it will not rise by as much as the last place of its position.
pub fn drop_on(plate: f64, variant: Variant) -> End {
    let (mut r, mut v, mut time) = (plate + 1.0, 0.0, 0.0);
    let mut rest = None;
    for impacts in 0..ENOUGH {
        let Some(dt) = variant.next(variant.gap(r, plate), v) else {
            return End { halted: true, time, impacts };
        };
        r = variant.fly(r, v, dt);
        v = -RESTITUTION * (v + dt * GRAVITY);
        time += dt;
        if rest.is_none() && r - v * v / (2.0 * GRAVITY) == r {
            rest = Some(End { halted: false, time, impacts: impacts + 1 });
        }
        if rest.is_some() && variant.stable {
            break;
        }
    }
    rest.unwrap_or(End { halted: true, time, impacts: ENOUGH })
}

/// Drops the ball on a plate in a world of its own, until the engine lays it down.
///
/// # Errors
/// An error of the engine.
pub fn drop_in_world(plate: f64) -> Result<End, Error> {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .hard_walls([[plate, plate + 10.0]], RESTITUTION)
        .gravity([GRAVITY])
        .rule(HardSphere { restitution: RESTITUTION })
        .grain(Grain::with_mass(SIGMA / 2.0, 1.0).at([plate + 1.0]))?
        .start()?;
    let mut impacts = 0;
    while !world.view().is_at_rest(0) && impacts < ENOUGH && world.step()?.is_some() {
        impacts += 1;
    }
    Ok(End { halted: !world.view().is_at_rest(0), time: world.now().as_f64(), impacts })
}

/// Numbers of impacts that the histogram tells apart.
const MAX_IMPACTS: usize = 80;

/// What many plates gave.
struct Sum {
    halted: u64,
    /// How often after so many impacts it halted.
    halts: Vec<u64>,
    /// How often after so many impacts it was at rest.
    rests: Vec<u64>,
    /// The largest |t_end − t_final| of the balls that came to rest.
    late: f64,
}

impl Sum {
    fn of(plates: &[f64], end: impl Fn(f64) -> End + Sync) -> Self {
        let none = || Self {
            halted: 0,
            halts: vec![0; MAX_IMPACTS],
            rests: vec![0; MAX_IMPACTS],
            late: 0.0,
        };
        let add = |mut sum: Self, plate: &f64| {
            let end = end(*plate);
            sum.halted += u64::from(end.halted);
            let bin = (end.impacts as usize).min(MAX_IMPACTS - 1);
            if end.halted {
                sum.halts[bin] += 1;
            } else {
                sum.rests[bin] += 1;
                sum.late = sum.late.max((end.time - t_final()).abs());
            }
            sum
        };
        plates.par_iter().fold(none, add).reduce(none, Self::joined)
    }

    fn joined(mut self, other: Self) -> Self {
        self.halts.iter_mut().zip(&other.halts).for_each(|(a, b)| *a += b);
        self.rests.iter_mut().zip(&other.rests).for_each(|(a, b)| *a += b);
        Self { halted: self.halted + other.halted, late: self.late.max(other.late), ..self }
    }
}

/// The mean of a histogram.
fn mean(impacts: &[u64]) -> f64 {
    let total: u64 = impacts.iter().sum();
    let sum: u64 = (0..).zip(impacts).map(|(k, n)| k * n).sum();
    sum as f64 / total.max(1) as f64
}

/// Plates at heights from 0 to 1.
fn plates(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

/// Makes the figure: on how many plates a simulation ended after so many impacts.
pub fn make(options: &Options) -> Result<Made> {
    let plates = plates(if options.full { 10_000_000 } else { 1_000_000 });
    let variants = Variant::all();
    let progress = Progress::new("bsfp14-7", 1 + variants.len() as u64);
    let axes = ["impacts until the simulation ends", "share of plate positions"];
    let mut figure = Figure::new("bsfp14-7", axes);
    let mut notes = Vec::new();
    for variant in variants {
        let sum = Sum::of(&plates, |plate| drop_on(plate, variant));
        let named = [variant.method(), variant.form(), variant.flight()];
        // The picture shows the paper's flight; the notes show both.
        if variant.flight == Flight::InTurn {
            figure = figure.with(series(named, &sum, plates.len()));
        }
        notes.push(note(named, &sum, plates.len()));
        progress.add(1);
    }
    let engine = Sum::of(&plates, |plate| {
        let lost = End { halted: true, time: 0.0, impacts: 0 };
        drop_in_world(plate).unwrap_or(lost)
    });
    let named = ["engine", "the engine's", "the engine's"];
    figure = figure.with(series(named, &engine, plates.len()));
    notes.push(note(named, &engine, plates.len()));
    let style = PlotStyle::new("A bouncing ball on 10^{6} plates: when does detection end?")
        .scales(Scale::LINEAR.from(22.0, 34.0), Scale::LOG.from(1e-6, 2.0))
        .kinds(&[Kind::Both])
        .mark(Mark::Place(30.0, "paper: halts after about 30".to_owned()));
    let picture = draw::draw(&figure, &style);
    Ok(Made { figure, picture, notes })
}

/// What is drawn: halts of a naive variant, rests of the others.
fn series([method, form, flight]: [&str; 3], sum: &Sum, plates: usize) -> Series {
    let naive = method == "naive";
    let (shown, verb) = if naive { (&sum.halts, "halts") } else { (&sum.rests, "rests") };
    let name = match method {
        "engine" => "engine rests".to_owned(),
        _ => format!("{method} {verb}: {form}"),
    };
    let mut series = Series::new(name)
        .param("method", method)
        .param("overlap_function", form)
        .param("flight", flight)
        .param("plates", plates as f64)
        .param("halted", sum.halted as f64 / plates as f64)
        .param("mean_impacts", mean(shown))
        .param("t_final", t_final())
        .param("largest_error_of_t_final", sum.late);
    for (impacts, count) in shown.iter().enumerate().filter(|(_, count)| **count > 0) {
        series.push(impacts as f64, *count as f64 / plates as f64);
    }
    series
}

fn note([method, form, flight]: [&str; 3], sum: &Sum, plates: usize) -> Note {
    let what = match method {
        "engine" => "the engine, a world of one grain".to_owned(),
        _ => format!("{method}, f = {form}, flight {flight}"),
    };
    if method != "naive" {
        let ours = format!(
            "{} of {plates} at rest, |t − t_final| ≤ {:.1e}, {:.1} impacts",
            plates as u64 - sum.halted,
            sum.late,
            mean(&sum.rests)
        );
        return Note::new(what, "all at rest at t_final", ours);
    }
    let share = 100.0 * sum.halted as f64 / plates as f64;
    let ours = match sum.halted {
        0 => "none halted".to_owned(),
        _ => format!("{share:.1} % halted, after {:.1} impacts", mean(&sum.halts)),
    };
    Note::new(what, "≈ 50 % halted, after ≈ 30 impacts", ours)
}
