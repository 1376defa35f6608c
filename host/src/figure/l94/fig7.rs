//! How high does a strongly shaken column stand? Reads α; writes h_cm by MD, ED and eMD* and by Eq. (10) (L94 Fig. 7).

use super::fit;
use super::shaken::{GRAVITY, Shaken};
use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use anyhow::{Result, ensure};
use rayon::prelude::*;
use std::f64::consts::TAU;

const BEADS: usize = 10;
const DIAMETER: f64 = 1e-3;
const FREQUENCY: f64 = 20.0;
const RESTITUTION: f64 = 0.92;
const CONTACT_TIME: f64 = 1e-4;
/// Reduced accelerations.
pub const AGITATIONS: [f64; 6] = [5.0, 7.5, 10.0, 15.0, 20.0, 30.0];
/// Periods before averaging begins.
const TRANSIENT: usize = 200;
const SAMPLES_PER_PERIOD: usize = 12;
/// Parts of a run that count as independent.
const BLOCKS: usize = 16;

/// The paper's column at a reduced acceleration α.
pub fn column(agitation: f64) -> Shaken {
    Shaken {
        beads: BEADS,
        diameter: DIAMETER,
        restitution: RESTITUTION,
        contact_time: CONTACT_TIME,
        amplitude: Shaken::amplitude_for(FREQUENCY, agitation),
        frequency: FREQUENCY,
        gap: 0.1 * DIAMETER,
    }
}

/// h_cm − h_cm0 after L94 Eq. (10).
pub fn theory(agitation: f64) -> f64 {
    let x = BEADS as f64 * (1.0 - RESTITUTION);
    let phi = 1.0 - 0.098 * x - 0.073 * x * x;
    let speed = Shaken::amplitude_for(FREQUENCY, agitation) * TAU * FREQUENCY;
    4.0 / 3.0 * speed * speed / GRAVITY * phi / x
}

/// Mean and standard error of h_cm − h_cm0 over so many periods.
///
/// # Errors
/// What the method says.
pub fn risen(method: &str, agitation: f64, periods: usize) -> Result<[f64; 2]> {
    let column = column(agitation);
    let samples = (TRANSIENT + periods) * SAMPLES_PER_PERIOD;
    let sample = 1.0 / (FREQUENCY * SAMPLES_PER_PERIOD as f64);
    let times: Vec<f64> = (1..=samples).map(|k| sample * k as f64).collect();
    let heights = match method {
        "ED" => column.by_ed(&times)?.0,
        "eMD*" => column.by_star(&times)?.0,
        _ => column.by_md(&times, 50.0)?,
    };
    ensure!(heights.len() == samples, "{method}: too many events at α = {agitation}");
    let rest = 0.5 * BEADS as f64 * DIAMETER;
    let centre = |row: &Vec<f64>| row.iter().sum::<f64>() / BEADS as f64 - rest;
    let all: Vec<f64> = heights[TRANSIENT * SAMPLES_PER_PERIOD..].iter().map(centre).collect();
    let block = all.len() / BLOCKS;
    let means: Vec<f64> = all.chunks_exact(block).map(|part| fit::mean(part)[0]).collect();
    Ok(fit::mean(&means))
}

/// Makes the figure.
///
/// # Errors
/// What a method says.
pub fn make(options: &Options) -> Result<Made> {
    let periods = if options.full { 20_000 } else { 1_600 };
    let methods = ["MD", "ED", "eMD*"];
    let progress = Progress::new("l94-7", (methods.len() * AGITATIONS.len()) as u64);
    let mut figure = Figure::new("l94-7", ["α = A0 ω²/g", "h_cm - h_cm0 (m)"]);
    for method in methods {
        let one = |&agitation: &f64| {
            let found = risen(method, agitation, periods);
            progress.add(1);
            found
        };
        let found: Vec<[f64; 2]> = AGITATIONS.par_iter().map(one).collect::<Result<_>>()?;
        let mut series = Series::new(method).param("method", method).param("eps", RESTITUTION);
        AGITATIONS.iter().zip(found).for_each(|(a, [y, e])| series.push_with_error(*a, y, e));
        figure = figure.with(series);
    }
    let notes = (0..AGITATIONS.len()).map(|k| note(&figure, k)).collect();
    let curve = (8..=64).map(|k| 0.5 * f64::from(k)).map(|a| [a, theory(a)]).collect();
    let look = Look::new("A shaken column: *N* = 10, ε = 0.92, *f* = 20 Hz (L94 Fig. 7)")
        .labels("α = *A*_{0}ω^{2}/*g*", "*h*_{cm} − *h*_{cm0} [m]")
        .scales(Scale::LINEAR.from(0.0, 32.0), Scale::LINEAR)
        .kinds(&[Kind::Dots])
        .mark(Mark::Curve(curve, "paper: Eq. (10)".to_owned()));
    let picture = draw::draw(&figure, &look);
    Ok(Made { figure, picture, notes })
}

fn note(figure: &Figure, k: usize) -> Note {
    let value = |s: &Series| format!("{} {:.5} ± {:.5}", s.name, s.y[k], s.yerr[k]);
    let ours: Vec<String> = figure.series.iter().map(value).collect();
    let says = format!("Eq. (10): {:.5}", theory(AGITATIONS[k]));
    Note::new(format!("h_cm - h_cm0 at α = {}", AGITATIONS[k]), says, ours.join(", "))
}
