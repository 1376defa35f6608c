//! Does a bouncing ball come to rest? Drops it on plates at a million heights; writes how many impacts each way of detection makes (BSFP14 Fig. 7).
//!
//! The ball of diameter σ = 1 falls from r = r_plate + 1 with g = −1 and ε = 0.5. In exact arithmetic it
//! meets the plate at t = 1 and comes to rest, after infinitely many impacts, at
//! t_final = (1 + ε)/(1 − ε) = 3, wherever the plate is.

use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use anyhow::Result;
use carom::event::root;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const SIGMA: f64 = 1.0;
const GRAVITY: f64 = -1.0;
const RESTITUTION: f64 = 0.5;
/// The closed form.
const T_FINAL: f64 = (1.0 + RESTITUTION) / (1.0 - RESTITUTION);
/// A naive simulation with so many impacts has not halted.
const ENOUGH: u32 = 200;
/// Numbers of impacts that the histogram tells apart.
const MOST: usize = 80;

/// How the next impact is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The quadratic formula, Eq. (12), with f = (r − r_p) − σ/2.
    NaiveInTurn,
    /// The same with f = r − (r_p + σ/2).
    NaiveSummed,
    /// BSFP14's rule, Algorithm 2, with f = (r − r_p) − σ/2.
    StableInTurn,
    /// The same with f = r − (r_p + σ/2).
    StableSummed,
}

impl Way {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::NaiveInTurn, Self::NaiveSummed, Self::StableInTurn, Self::StableSummed];

    /// Whether it obeys BSFP14's rule.
    pub fn is_stable(self) -> bool {
        matches!(self, Self::StableInTurn | Self::StableSummed)
    }

    fn form(self) -> &'static str {
        match self {
            Self::NaiveInTurn | Self::StableInTurn => "r − r_p − σ/2",
            Self::NaiveSummed | Self::StableSummed => "r − (r_p + σ/2)",
        }
    }

    fn method(self) -> &'static str {
        if self.is_stable() { "stable" } else { "naive" }
    }

    /// The overlap function at Δt = 0.
    fn gap(self, r: f64, plate: f64) -> f64 {
        match self {
            Self::NaiveInTurn | Self::StableInTurn => r - plate - SIGMA / 2.0,
            Self::NaiveSummed | Self::StableSummed => r - (plate + SIGMA / 2.0),
        }
    }

    /// The time until the next impact; none if the simulation must be halted.
    fn next(self, gap: f64, v: f64) -> Option<f64> {
        if self.is_stable() {
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
pub fn drop_on(plate: f64, way: Way) -> End {
    let (mut r, mut v, mut time) = (plate + 1.0, 0.0, 0.0);
    let mut rest = None;
    for impacts in 0..ENOUGH {
        let Some(dt) = way.next(way.gap(r, plate), v) else {
            return End { halted: true, time, impacts };
        };
        r += dt * (v + 0.5 * dt * GRAVITY);
        v = -RESTITUTION * (v + dt * GRAVITY);
        time += dt;
        if rest.is_none() && r - v * v / (2.0 * GRAVITY) == r {
            rest = Some(End { halted: false, time, impacts: impacts + 1 });
        }
        if rest.is_some() && way.is_stable() {
            break;
        }
    }
    rest.unwrap_or(End { halted: true, time, impacts: ENOUGH })
}

/// What many plates gave.
struct Sum {
    halted: u64,
    /// Impacts before the halt, or until rest, and how often.
    impacts: Vec<u64>,
    /// The largest |t_end − t_final| of the balls that came to rest.
    late: f64,
}

impl Sum {
    fn of(plates: &[f64], way: Way) -> Self {
        let none = || Self { halted: 0, impacts: vec![0; MOST], late: 0.0 };
        let add = |mut sum: Self, plate: &f64| {
            let end = drop_on(*plate, way);
            sum.halted += u64::from(end.halted);
            if end.halted || way.is_stable() {
                sum.impacts[(end.impacts as usize).min(MOST - 1)] += 1;
            }
            if !end.halted {
                sum.late = sum.late.max((end.time - T_FINAL).abs());
            }
            sum
        };
        plates.par_iter().fold(none, add).reduce(none, |mut a, b| {
            a.impacts.iter_mut().zip(&b.impacts).for_each(|(a, b)| *a += b);
            Self { halted: a.halted + b.halted, late: a.late.max(b.late), ..a }
        })
    }

    fn mean(&self) -> f64 {
        let total: u64 = self.impacts.iter().sum();
        let sum: u64 = (0..).zip(&self.impacts).map(|(k, n)| k * n).sum();
        sum as f64 / total.max(1) as f64
    }
}

/// Plates at heights uniform in [0, 1].
pub fn plates(count: usize) -> Vec<f64> {
    let mut rng = Pcg64::seed_from_u64(7);
    (0..count).map(|_| rng.random::<f64>()).collect()
}

/// Makes the figure: on how many plates a simulation ended after so many impacts.
pub fn make(options: &Options) -> Result<Made> {
    let plates = plates(if options.full { 10_000_000 } else { 1_000_000 });
    let progress = Progress::new("bsfp14-7", Way::ALL.len() as u64);
    let mut figure =
        Figure::new("bsfp14-7", ["impacts until the simulation ends", "share of plate positions"]);
    let mut notes = Vec::new();
    for way in Way::ALL {
        let sum = Sum::of(&plates, way);
        figure = figure.with(series(way, &sum, plates.len()));
        notes.push(note(way, &sum, plates.len()));
        progress.add(1);
    }
    let look = Look::new("A bouncing ball on 10^{6} plates: when does detection end?")
        .scales(Scale::LINEAR, Scale::LOG)
        .kinds(&[Kind::Both])
        .mark(Mark::Place(30.0, "paper: ≈ 30 impacts".to_owned()));
    let picture = draw::draw(&figure, &look);
    Ok(Made { figure, picture, notes })
}

fn series(way: Way, sum: &Sum, plates: usize) -> Series {
    let verb = if way.is_stable() { "rests" } else { "halts" };
    let mut series = Series::new(format!("{} {verb}: f = {}", way.method(), way.form()))
        .param("method", way.method())
        .param("overlap_function", way.form())
        .param("plates", plates as f64)
        .param("halted", sum.halted as f64 / plates as f64)
        .param("mean_impacts", sum.mean())
        .param("t_final", T_FINAL)
        .param("largest_error_of_t_final", sum.late);
    for (impacts, count) in sum.impacts.iter().enumerate().filter(|(_, count)| **count > 0) {
        series.push(impacts as f64, *count as f64 / plates as f64);
    }
    series
}

fn note(way: Way, sum: &Sum, plates: usize) -> Note {
    let what = format!("{}, f = {}", way.method(), way.form());
    if way.is_stable() {
        let ours = format!(
            "{} of {plates} at rest, |t − 3| ≤ {:.1e}, {:.1} impacts on average",
            plates as u64 - sum.halted,
            sum.late,
            sum.mean()
        );
        return Note::new(what, "rest at t_final", ours);
    }
    let share = 100.0 * sum.halted as f64 / plates as f64;
    let ours = format!("{share:.1} % halted, after {:.1} impacts on average", sum.mean());
    Note::new(what, "≈ 50 % halted, after ≈ 30 impacts on average", ours)
}
