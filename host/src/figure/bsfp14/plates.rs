//! On how many plates does a bouncing ball come to rest? Drops it on many; writes how often that ended after so many impacts (BSFP14 Fig. 7).

use super::ball::{End, Flight, Variant, drop_in_world, drop_on, t_final};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::progress::Progress;
use anyhow::Result;
use rayon::prelude::*;

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
