//! Does a shaken column of aluminium beads stay together? Runs L94's experiment by MD, ED and eMD*; writes beads against phase and time (Figs. 6a, 6b).

use super::panels::{Diagram, draw_panels};
use super::shaken::{GRAVITY, Shaken};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, PlotStyle, Scale};
use crate::figure::fit;
use crate::figure::number::significant;
use crate::progress::Progress;
use anyhow::{Result, ensure};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

const BEADS: usize = 10;
const DIAMETER: f64 = 3e-3;
const FREQUENCY: f64 = 10.0;
const AGITATION: f64 = 2.0;
const CONTACT_TIME: f64 = 3.6e-6;
const SAMPLES_PER_PERIOD: usize = 48;
/// Periods after which the start is forgotten.
const TRANSIENT: usize = 2;
/// The bead that the paper's picture marks, from 0.
const SEVENTH: usize = 6;

fn column() -> Shaken {
    Shaken {
        beads: BEADS,
        diameter: DIAMETER,
        restitution: 0.6,
        contact_time: CONTACT_TIME,
        amplitude: Shaken::amplitude_for(FREQUENCY, AGITATION),
        frequency: FREQUENCY,
        gap: 1e-3 * DIAMETER,
    }
}

/// A way to run the column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Method {
    /// L94's predictor-corrector in so many steps per contact.
    Md(f64),
    Ed,
    Star,
}

const METHODS: [Method; 4] = [Method::Md(50.0), Method::Md(100.0), Method::Ed, Method::Star];

impl Method {
    fn name(self) -> String {
        match self {
            Self::Md(steps) => format!("MD, t_c/{steps}"),
            Self::Ed => "ED".to_owned(),
            Self::Star => "eMD*".to_owned(),
        }
    }

    /// Reduced heights z_i = h_i − (i − 1) d − d/2 of all beads, in units of d.
    fn run(self, times: &[f64]) -> Result<Vec<Vec<f64>>> {
        let mut heights = match self {
            Self::Md(steps) => column().by_md(times, steps)?,
            Self::Ed => column().by_ed(times)?.0,
            Self::Star => column().by_star(times)?.0,
        };
        ensure!(heights.len() == times.len(), "{}: too many events", self.name());
        for row in &mut heights {
            (0..).zip(row).for_each(|(k, z)| *z = *z / DIAMETER - (f64::from(k) + 0.5));
        }
        Ok(heights)
    }
}

fn times(periods: usize) -> Vec<f64> {
    let sample = 1.0 / (FREQUENCY * SAMPLES_PER_PERIOD as f64);
    (0..=periods * SAMPLES_PER_PERIOD).map(|k| sample * k as f64).collect()
}

/// The heights by these methods, several at once.
fn all(id: &str, methods: &[Method], times: &[f64]) -> Result<Vec<Vec<Vec<f64>>>> {
    let progress = Progress::new(id, methods.len() as u64);
    let one = |method: &Method| {
        let found = method.run(times);
        progress.add(1);
        found
    };
    methods.par_iter().map(one).collect()
}

fn periods(options: &Options) -> usize {
    if options.full { 42 } else { 12 }
}

/// z of a bead that keeps nothing of its energy, in units of d: it rides, takes off where the plate falls away faster than g, and rides again where it lands.
fn inelastic(phase: f64) -> f64 {
    let amplitude = column().amplitude / DIAMETER;
    let plate = |phase: f64| amplitude * (TAU * phase).sin();
    let take_off = (1.0 / AGITATION).asin() / TAU;
    let since = (phase - take_off).rem_euclid(1.0) / FREQUENCY;
    let speed = amplitude * TAU * FREQUENCY * (TAU * take_off).cos();
    let flying = |t: f64| plate(take_off) + speed * t - 0.5 * GRAVITY / DIAMETER * t * t;
    let under = |k: u32| {
        let t = since * f64::from(k) / 1000.0;
        k > 10 && flying(t) < plate(take_off + FREQUENCY * t)
    };
    if (0..=1000).any(under) { plate(phase) } else { flying(since) }
}

/// L94 Fig. 6(a): the seventh bead against the phase.
///
/// # Errors
/// An error of a method.
pub fn make_a(options: &Options) -> Result<Made> {
    let methods = [Method::Md(50.0), Method::Ed, Method::Star];
    let found = all("l94-6a", &methods, &times(periods(options)))?;
    let mut figure = Figure::new("l94-6a", ["phase of the plate (periods)", "z_7 (d)"]);
    let mut notes = Vec::new();
    for (method, heights) in methods.iter().zip(&found) {
        let name = method.name();
        let mut series = Series::new(name.clone()).param("method", &*name);
        let later = heights.iter().enumerate().skip(TRANSIENT * SAMPLES_PER_PERIOD);
        for (k, row) in later {
            series.push(phase(k), row[SEVENTH]);
        }
        notes.push(note_a(*method, &series));
        figure = figure.with(series);
    }
    let line = |name: &str, of: &dyn Fn(f64) -> f64| {
        let mut series = Series::new(name);
        (0..=96).map(|k| f64::from(k) / 96.0).for_each(|phase| series.push(phase, of(phase)));
        series
    };
    let amplitude = column().amplitude / DIAMETER;
    let figure = figure
        .with(line("one inelastic bead", &inelastic))
        .with(line("plate", &|phase| amplitude * (2.0 * PI * phase).sin()));
    let style = PlotStyle::new("The seventh of ten beads at α = 2, *f* = 10 Hz (L94 Fig. 6a)")
        .labels("phase of the plate [periods]", "*z*_{7} [*d*]")
        .scales(Scale::LINEAR.from(0.0, 1.0), Scale::LINEAR)
        .kinds(&[Kind::Dots, Kind::Dots, Kind::Dots, Kind::Line]);
    let picture = draw::draw(&figure, &style);
    Ok(Made { figure, picture, notes })
}

fn phase(sample: usize) -> f64 {
    (sample % SAMPLES_PER_PERIOD) as f64 / SAMPLES_PER_PERIOD as f64
}

/// How far the bead is from a completely inelastic one, and how much its place differs from period to period.
fn note_a(method: Method, series: &Series) -> Note {
    let points = || series.x.iter().zip(&series.y);
    let off = points().map(|(phase, z)| (z - inelastic(*phase)).abs()).fold(0.0, f64::max);
    let deviation = |k: usize| {
        let some: Vec<f64> = series.y.iter().skip(k).step_by(SAMPLES_PER_PERIOD).copied().collect();
        fit::mean(&some)[1] * (some.len() as f64).sqrt()
    };
    let most = (0..SAMPLES_PER_PERIOD).map(deviation).fold(0.0, f64::max);
    let says = match method {
        Method::Md(_) => "separations",
        Method::Ed => "clustered, as the experiment",
        Method::Star => "not given",
    };
    let ours = format!(
        "differs by up to {} d (standard deviation) from period to period; at most {} d from one inelastic bead",
        significant(most, 2),
        significant(off, 2)
    );
    Note::new(method.name(), says, ours)
}

/// L94 Fig. 6(b): all beads against time.
///
/// # Errors
/// An error of a method.
pub fn make_b(options: &Options) -> Result<Made> {
    let times = times(periods(options));
    let found = all("l94-6b", &METHODS, &times)?;
    let mut figure = Figure::new("l94-6b", ["t (s)", "z_i = h_i - (i - 1) d - d/2 (d)"]);
    let (mut diagrams, mut notes) = (Vec::new(), Vec::new());
    for (method, heights) in METHODS.iter().zip(&found) {
        let mut curves = Vec::new();
        for bead in 0..BEADS {
            let name = format!("{}, bead {}", method.name(), bead + 1);
            let mut series =
                Series::new(name).param("method", &*method.name()).param("bead", bead as f64 + 1.0);
            times.iter().zip(heights).for_each(|(t, row)| series.push(*t, row[bead]));
            curves.push(series.x.iter().zip(&series.y).map(|(t, z)| [*t, *z]).collect());
            figure = figure.with(series);
        }
        notes.push(note_b(*method, heights, &found[0]));
        let title = method.name().replace('*', "∗").replace("t_c", "*t*_{c}");
        diagrams.push(Diagram { title, curves, x: [0.0, times[times.len() - 1]] });
    }
    let title = "Ten beads, ε = 0.6, *t*_{c} = 3.6 μs: α = 2, *f* = 10 Hz (L94 Fig. 6b)";
    let picture = draw_panels(title, &diagrams, 2, ["*t* [s]", "*z*_{i} [*d*]"]);
    Ok(Made { figure, picture, notes })
}

/// The sum of all gaps, and when the centre of mass has gone another way than with the paper's step.
fn note_b(method: Method, heights: &[Vec<f64>], first: &[Vec<f64>]) -> Note {
    let stretch = |row: &Vec<f64>| row[BEADS - 1] - row[0];
    let later = &heights[TRANSIENT * SAMPLES_PER_PERIOD..];
    let mean = later.iter().map(stretch).sum::<f64>() / later.len() as f64;
    let most = later.iter().map(stretch).fold(0.0, f64::max);
    let centre = |row: &Vec<f64>| row.iter().sum::<f64>() / BEADS as f64;
    let apart = |(a, b): (&Vec<f64>, &Vec<f64>)| (centre(a) - centre(b)).abs() > 0.1;
    let when = heights.iter().zip(first).position(apart);
    let way =
        when.map_or("never".to_owned(), |k| format!("from {:.3} s on", times(1)[1] * k as f64));
    let says = match method {
        Method::Md(_) => "may lead to large separations",
        Method::Ed => "clustered",
        Method::Star => "not given",
    };
    let ours = format!(
        "gaps add up to {} d on average, {} d at most; centre of mass more than d/10 from the first row's: {way}",
        significant(mean, 2),
        significant(most, 2)
    );
    Note::new(method.name(), says, ours)
}
