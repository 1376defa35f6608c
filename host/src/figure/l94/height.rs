//! How high does a strongly shaken column stand? Reads beads, ε and α; writes h_cm, by MD, ED, eMD* and with clusters (L94 Fig. 7).

use super::shaken::{GRAVITY, Shaken};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Result, ensure};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// N of the paper.
pub const BEADS: usize = 10;
/// More of them, at the same X: what Eq. (10) is for.
pub const MANY: usize = 40;
/// X = N (1 − ε), of N = 10 beads with ε = 0.92.
const DISSIPATION: f64 = 0.8;
const DIAMETER: f64 = 1e-3;
const FREQUENCY: f64 = 20.0;
const CONTACT_TIME: f64 = 1e-4;
/// Reduced accelerations.
pub const AGITATIONS: [f64; 7] = [5.0, 7.5, 10.0, 15.0, 20.0, 30.0, 40.0];
/// From here on (h_cm − h_cm0)/(A_0 ω)² depends on α no more: the strong agitation that Eq. (10) is for.
pub const STRONG: f64 = 20.0;
/// Harmonics of the plate's motion up to the third cancel.
const SAMPLES_PER_PERIOD: usize = 4;
/// Columns that start with other gaps, and so are independent of each other.
const COLUMNS: usize = 10;
/// How long a column takes to come to its height from rest, in units of α periods; within 1 % it has
/// done so after five.
const TRANSIENT: f64 = 6.0;

/// The paper's column at a reduced acceleration α, or one of more beads at the same X.
pub fn column(agitation: f64, beads: usize) -> Shaken {
    Shaken {
        beads,
        diameter: DIAMETER,
        restitution: 1.0 - DISSIPATION / beads as f64,
        contact_time: CONTACT_TIME,
        amplitude: Shaken::amplitude_for(FREQUENCY, agitation),
        frequency: FREQUENCY,
        gap: 0.1 * DIAMETER,
    }
}

/// h_cm − h_cm0 after L94 Eq. (10).
pub fn theory(agitation: f64) -> f64 {
    let x = DISSIPATION;
    let phi = 1.0 - 0.098 * x - 0.073 * x * x;
    let speed = Shaken::amplitude_for(FREQUENCY, agitation) * TAU * FREQUENCY;
    4.0 / 3.0 * speed * speed / GRAVITY * phi / x
}

/// For how many periods columns are measured, in all: a flight takes about α/2 of them, and events are what costs.
pub fn periods(method: &str, beads: usize, agitation: f64, full: bool) -> usize {
    let per_agitation = match (method, beads) {
        ("MD", _) => 180.0,
        ("eMD*", _) => 800.0,
        (_, BEADS) => 2_500.0,
        _ => 100.0,
    };
    (agitation * per_agitation * if full { 5.0 } else { 1.0 }) as usize
}

/// Mean and standard error of h_cm − h_cm0 over so many periods, shared out among ten columns: the
/// error is that of ten independent means.
///
/// # Errors
/// An error of the method.
pub fn mean_rise(method: &str, beads: usize, agitation: f64, periods: usize) -> Result<[f64; 2]> {
    let one = |k: usize| of_one(method, beads, agitation, (periods.div_ceil(COLUMNS), k));
    let means: Vec<f64> = (0..COLUMNS).into_par_iter().map(one).collect::<Result<_>>()?;
    Ok(fit::mean(&means))
}

/// The mean of column `number` over so many periods.
fn of_one(
    method: &str,
    beads: usize,
    agitation: f64,
    (periods, number): (usize, usize),
) -> Result<f64> {
    let usual = column(agitation, beads);
    let column = Shaken { gap: (1.0 + 0.1 * number as f64) * usual.gap, ..usual };
    let transient = (TRANSIENT * agitation) as usize;
    let samples = (transient + periods) * SAMPLES_PER_PERIOD;
    let sample = 1.0 / (FREQUENCY * SAMPLES_PER_PERIOD as f64);
    let times: Vec<f64> = (1..=samples).map(|k| sample * k as f64).collect();
    let heights = match method {
        "ED" => column.by_ed(&times)?.0,
        "eMD*" => column.by_star(&times)?.0,
        "clusters" => column.by_clusters(&times)?.0,
        _ => column.by_exact_md(&times)?,
    };
    ensure!(heights.len() == samples, "{method}: too many events at α = {agitation}");
    let rest = 0.5 * beads as f64 * DIAMETER;
    let centre = |row: &Vec<f64>| row.iter().sum::<f64>() / beads as f64 - rest;
    let all: Vec<f64> = heights[transient * SAMPLES_PER_PERIOD..].iter().map(centre).collect();
    Ok(fit::mean(&all)[0])
}

/// Makes the figure.
///
/// # Errors
/// An error of a method.
pub fn make(options: &Options) -> Result<Made> {
    let methods = ["MD", "ED", "eMD*", "clusters"].map(|method| (method, BEADS));
    let curves: Vec<_> = methods.into_iter().chain([("ED", MANY)]).collect();
    let progress = Progress::new("l94-7", (curves.len() * AGITATIONS.len()) as u64);
    let mut figure = Figure::new("l94-7", ["α = A0 ω²/g", "h_cm - h_cm0 (m)"]);
    for (method, beads) in curves {
        let one = |&agitation: &f64| {
            let periods = periods(method, beads, agitation, options.full);
            let found = mean_rise(method, beads, agitation, periods);
            progress.add(1);
            found
        };
        let found: Vec<[f64; 2]> = AGITATIONS.par_iter().map(one).collect::<Result<_>>()?;
        let mut series = Series::new(format!("{method}, N = {beads}"))
            .param("method", method)
            .param("beads", beads as f64)
            .param("eps", 1.0 - DISSIPATION / beads as f64);
        AGITATIONS.iter().zip(found).for_each(|(a, [y, e])| series.push_with_error(*a, y, e));
        figure = figure.with(series);
    }
    let mut notes: Vec<Note> = (0..AGITATIONS.len()).map(|k| note(&figure, k)).collect();
    notes.push(against_md(&figure));
    let picture = picture(&figure);
    let mut formula = Series::new("Eq. (10)").param("method", "theory");
    AGITATIONS.iter().for_each(|a| formula.push(*a, theory(*a)));
    let figure = figure.with(formula);
    Ok(Made { figure, picture, notes })
}

/// The paper's picture, and beside it the same in units in which Eq. (10) is level.
fn picture(figure: &Figure) -> Scene {
    let labels = ["α = *A*_{0}ω^{2}/*g*", "*h*_{cm} − *h*_{cm0} [m]"];
    let curve = (0..=84).map(|k| 0.5 * f64::from(k)).map(|a| [a, theory(a)]).collect();
    let plain = PlotStyle::new("Shaken columns, *N* (1 − ε) = 0.8, *f* = 20 Hz (L94 Fig. 7)")
        .labels(labels[0], labels[1])
        .scales(Scale::LINEAR.from(0.0, 42.0), Scale::LINEAR)
        .kinds(&[Kind::Dots])
        .mark(Mark::Curve(curve, "paper: Eq. (10)".to_owned()));
    let mut level = figure.clone();
    for Series { x, y, yerr, .. } in &mut level.series {
        x.iter().zip(y).for_each(|(x, y)| *y /= theory(*x));
        x.iter().zip(yerr).for_each(|(x, e)| *e /= theory(*x));
    }
    let relative = PlotStyle::new("The same, in units of Eq. (10)")
        .labels(labels[0], "(*h*_{cm} − *h*_{cm0}) / Eq. (10)")
        .scales(Scale::LINEAR.from(0.0, 42.0), Scale::LINEAR.from(0.85, 1.08))
        .mark(Mark::Level(1.0, "paper: Eq. (10)".to_owned()))
        .mark(Mark::Level(0.95, "5 % below".to_owned()));
    draw::beside(draw::draw(figure, &plain), draw::draw(&level, &relative))
}

fn note(figure: &Figure, k: usize) -> Note {
    let theory = theory(AGITATIONS[k]);
    let value = |s: &Series| {
        let [y, e] = [s.y[k], s.yerr[k]].map(|y| 100.0 * y / theory);
        format!("{}: {:+.1} ± {e:.1} %", s.name, y - 100.0)
    };
    let ours: Vec<String> = figure.series.iter().map(value).collect();
    let says = format!("Eq. (10): {theory:.5} m");
    let what = format!("h_cm - h_cm0 at α = {}, against Eq. (10)", AGITATIONS[k]);
    Note::new(what, says, ours.join("; "))
}

/// How far the engine's default is from MD, in units of the error of their difference.
fn against_md(figure: &Figure) -> Note {
    let of = |name: &str| figure.series.iter().find(|s| s.name == format!("{name}, N = {BEADS}"));
    let ours = match (of("clusters"), of("MD")) {
        (Some(a), Some(b)) => {
            let apart = |k: usize| (a.y[k] - b.y[k]) / a.yerr[k].hypot(b.yerr[k]);
            let all: Vec<String> = (0..a.y.len()).map(|k| format!("{:+.1}", apart(k))).collect();
            all.join(", ")
        }
        _ => String::new(),
    };
    Note::new("clusters less MD, in standard errors, for each α", "not given", ours)
}
