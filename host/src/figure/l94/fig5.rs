//! Does a column on a plate stay together? Reads two contact times; writes trajectories by MD, ED and eMD* (L94 Fig. 5).

use super::panels::{self, Diagram};
use super::shaken::Shaken;
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use anyhow::{Result, ensure};
use carom::event::Counters;

const BEADS: usize = 10;
const DIAMETER: f64 = 1e-3;
const FREQUENCY: f64 = 20.0;
/// t_c of Figs. 5(a) and 5(b).
const CONTACT_TIMES: [f64; 2] = [0.7e-3, 0.7e-5];
const SAMPLES_PER_PERIOD: usize = 24;

fn column(contact_time: f64) -> Shaken {
    Shaken {
        beads: BEADS,
        diameter: DIAMETER,
        restitution: 0.6,
        contact_time,
        amplitude: 1.24 * DIAMETER,
        frequency: FREQUENCY,
        gap: 1e-3 * DIAMETER,
    }
}

/// Makes the figure.
///
/// # Errors
/// What a method says.
pub fn make(options: &Options) -> Result<Made> {
    let periods = if options.full { 40 } else { 10 };
    let sample = 1.0 / (FREQUENCY * SAMPLES_PER_PERIOD as f64);
    let times: Vec<f64> = (0..=periods * SAMPLES_PER_PERIOD).map(|k| sample * k as f64).collect();
    let progress = Progress::new("l94-5", 6);
    let mut figure = Figure::new("l94-5", ["t (s)", "z_i = h_i - (i - 1) d - d/2 (m)"]);
    let (mut diagrams, mut notes) = (Vec::new(), Vec::new());
    for method in ["MD", "ED", "eMD*"] {
        for contact_time in CONTACT_TIMES {
            let (heights, events) = match method {
                "ED" => column(contact_time).by_ed(&times)?,
                "eMD*" => column(contact_time).by_star(&times)?,
                _ => (column(contact_time).by_md(&times, 50.0)?, Counters::default()),
            };
            ensure!(!heights.is_empty(), "{method}: too many events before the first sample");
            notes.push(note(method, contact_time, &heights));
            if method != "MD" {
                notes.push(told(method, contact_time, &events, times[heights.len() - 1]));
            }
            let mut curves = Vec::new();
            for bead in 0..BEADS {
                let series = series(method, contact_time, bead, &times, &heights);
                curves.push(series.x.iter().zip(&series.y).map(|(t, z)| [*t, 1e3 * z]).collect());
                figure = figure.with(series);
            }
            let title =
                format!("{}, *t*_{{c}} = {} ms", method.replace('*', "∗"), 1e3 * contact_time);
            let x = [0.0, times[times.len() - 1]];
            diagrams.push(Diagram { title, curves, x, y: None });
            progress.add(1);
        }
    }
    let title =
        "Ten beads, ε = 0.6, on a plate: *A*_{0} = 1.24 *d*, *f* = 20 Hz, α = 2 (L94 Fig. 5)";
    let picture = panels::draw(title, &diagrams, CONTACT_TIMES.len(), ["*t* [s]", "*z*_{i} [mm]"]);
    Ok(Made { figure, picture, notes })
}

fn series(method: &str, t_c: f64, bead: usize, times: &[f64], heights: &[Vec<f64>]) -> Series {
    let mut series = Series::new(format!("{method}, t_c = {t_c:e}, bead {}", bead + 1))
        .param("method", method)
        .param("t_c", t_c)
        .param("bead", bead as f64 + 1.0);
    for (t, row) in times.iter().zip(heights) {
        series.push(*t, row[bead] - (bead as f64 + 0.5) * DIAMETER);
    }
    series
}

/// What the engine counted until it ended.
fn told(method: &str, contact_time: f64, counters: &Counters, end: f64) -> Note {
    let Counters { collisions, plane_collisions, rests, collapses, interrupted, .. } = counters;
    let ours = format!(
        "{collisions} collisions, {plane_collisions} with the plate, {interrupted} interrupted, \
         {rests} rests, {collapses} ends of a collapse, until {end:.3} s"
    );
    Note::new(format!("{method}, t_c = {contact_time:e} s: events"), "not given", ours)
}

/// How far the column is stretched: the gaps' sum, in diameters, on average and at most.
fn note(method: &str, contact_time: f64, heights: &[Vec<f64>]) -> Note {
    let stretch = |row: &Vec<f64>| (row[BEADS - 1] - row[0]) / DIAMETER - (BEADS - 1) as f64;
    let later = &heights[heights.len() / 5..];
    let mean = later.iter().map(stretch).sum::<f64>() / later.len() as f64;
    let most = later.iter().map(stretch).fold(0.0, f64::max);
    let said = match (method, contact_time > 1e-4) {
        ("MD", true) => "large separations all the time",
        ("MD", false) => "clustered and separated in turn",
        ("ED", _) => "always clustered",
        _ => "not given",
    };
    let what = format!("{method}, t_c = {contact_time:e} s: sum of gaps / d");
    Note::new(what, said, format!("{mean:.4} on average, {most:.3} at most"))
}
