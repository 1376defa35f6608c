//! How do ten beads move, at a wall and on a plate? Reads gaps and contact times; writes trajectories by MD, ED and eMD* (L94 Fig. 1), and with clusters (Fig. 5).

use super::column::Column;
use super::hard::{self, Variant};
use super::loss::METHODS;
use super::panels::{Diagram, draw_panels};
use super::shaken::Shaken;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::number::fixed;
use crate::progress::Progress;
use anyhow::{Result, ensure};
use carom::world::Statistics;
use carom_reference::ForceLaw;

const BEADS: usize = 10;
const SPEED: f64 = 0.2;
const CONTACT_TIME: f64 = 0.7e-5;
/// s_0 of Figs. 1(a)–(c), and (d)–(f).
const GAPS: [f64; 3] = [0.0, 1e-6, 1e-5];
const SAMPLES: usize = 60;

/// The times shown: two and a half times as long as the impact lasts.
fn times(gap: f64) -> Vec<f64> {
    let end = 2.5 * BEADS as f64 * (CONTACT_TIME + gap / SPEED);
    (0..=SAMPLES).map(|k| end * k as f64 / SAMPLES as f64).collect()
}

/// Heights of all beads at all times, in the paper's reduced form (Eq. 9, with i for N).
fn reduced(method: &str, gap: f64) -> Result<Vec<Vec<f64>>> {
    let law = ForceLaw::spring_of(1.0, CONTACT_TIME, 0.9)?;
    let column = Column::new(BEADS, SPEED, gap);
    let mut heights = match method {
        "ED" => hard::heights(&column, &law, Variant::Instant, &times(gap))?,
        "eMD*" => hard::heights(&column, &law, Variant::Lasting, &times(gap))?,
        _ => column.heights_at(law, &times(gap))?,
    };
    for row in &mut heights {
        for (k, z) in row.iter_mut().enumerate() {
            *z -= (k as f64 + 0.5) * column.diameter;
        }
    }
    Ok(heights)
}

/// Makes the figure.
///
/// # Errors
/// An error of a method.
pub fn at_a_wall(_: &Options) -> Result<Made> {
    let mut figure = Figure::new("l94-1", ["t (s)", "z_i = h_i - (i - 1) d - d/2 (m)"]);
    let (mut diagrams, mut notes) = (Vec::new(), Vec::new());
    for method in METHODS {
        for gap in GAPS {
            let (times, heights) = (times(gap), reduced(method, gap)?);
            let mut curves = Vec::new();
            for bead in 0..BEADS {
                let mut series = Series::new(format!("{method}, s0 = {gap:e}, bead {}", bead + 1))
                    .param("method", method)
                    .param("s0", gap)
                    .param("bead", bead as f64 + 1.0);
                times.iter().zip(&heights).for_each(|(t, row)| series.push(*t, row[bead]));
                curves.push(in_micro(&series));
                figure = figure.with(series);
            }
            notes.push(note_wall(method, gap, &times, &heights));
            let title = format!("{}, *s*_{{0}} = {} μm", method.replace('*', "∗"), gap * 1e6);
            let x = [0.0, 1e6 * times[SAMPLES]];
            diagrams.push(Diagram { title, curves, x });
        }
    }
    let title = "Ten beads at a wall, ε = 0.9, *t*_{c} = 7 μs, *v*_{0} = 0.2 m/s (L94 Fig. 1)";
    let picture = draw_panels(title, &diagrams, GAPS.len(), ["*t* [μs]", "*z*_{i} [μm]"]);
    Ok(Made { figure, picture, notes })
}

fn in_micro(series: &Series) -> Vec<[f64; 2]> {
    series.x.iter().zip(&series.y).map(|(t, z)| [1e6 * t, 1e6 * z]).collect()
}

/// The velocity of the centre of mass and the spread at the end.
fn note_wall(method: &str, gap: f64, times: &[f64], heights: &[Vec<f64>]) -> Note {
    let centre = |k: usize| heights[k].iter().sum::<f64>() / BEADS as f64;
    let last = times.len() - 1;
    let speed = (centre(last) - centre(last - 4)) / (times[last] - times[last - 4]) / SPEED;
    let said = match (method, gap > 5e-6) {
        ("eMD*", _) => "not given",
        ("MD", false) => "larger than in ED",
        ("MD", true) => "similar to ED",
        _ => "the same for all s0",
    };
    let what = format!("{method}, s0 = {} μm: final v_cm/v0", gap * 1e6);
    Note::new(what, said, format!("{speed:.3}"))
}

const SHAKEN_BEADS: usize = 10;
const DIAMETER: f64 = 1e-3;
const FREQUENCY: f64 = 20.0;
/// t_c of Figs. 5(a) and 5(b).
const CONTACT_TIMES: [f64; 2] = [0.7e-3, 0.7e-5];
const SAMPLES_PER_PERIOD: usize = 24;

fn column(contact_time: f64) -> Shaken {
    Shaken {
        beads: SHAKEN_BEADS,
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
/// An error of a method.
pub fn on_a_plate(options: &Options) -> Result<Made> {
    let periods = if options.full { 40 } else { 10 };
    let sample = 1.0 / (FREQUENCY * SAMPLES_PER_PERIOD as f64);
    let times: Vec<f64> = (0..=periods * SAMPLES_PER_PERIOD).map(|k| sample * k as f64).collect();
    let progress = Progress::new("l94-5", 8);
    let mut figure = Figure::new("l94-5", ["t (s)", "z_i = h_i - (i - 1) d - d/2 (m)"]);
    let (mut diagrams, mut notes) = (Vec::new(), Vec::new());
    for method in ["MD", "ED", "eMD*", "clusters"] {
        for contact_time in CONTACT_TIMES {
            let (heights, events) = match method {
                "ED" => column(contact_time).by_ed(&times)?,
                "eMD*" => column(contact_time).by_star(&times)?,
                "clusters" => column(contact_time).by_clusters(&times)?,
                _ => (column(contact_time).by_md(&times, 50.0)?, Statistics::default()),
            };
            ensure!(!heights.is_empty(), "{method}: too many events before the first sample");
            notes.push(note_plate(method, contact_time, &heights));
            if method != "MD" {
                notes.push(note(method, contact_time, &events, times[heights.len() - 1]));
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
            diagrams.push(Diagram { title, curves, x });
            progress.add(1);
        }
    }
    let title =
        "Ten beads, ε = 0.6, on a plate: *A*_{0} = 1.24 *d*, *f* = 20 Hz, α = 2 (L94 Fig. 5)";
    let picture = draw_panels(title, &diagrams, CONTACT_TIMES.len(), ["*t* [s]", "*z*_{i} [mm]"]);
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
fn note(method: &str, contact_time: f64, statistics: &Statistics, end: f64) -> Note {
    let Statistics { collisions, plane_collisions, rests, collapses, interrupted, .. } = statistics;
    let further = match method {
        "clusters" => format!("{} became clusters, {} steps", statistics.joins, statistics.steps),
        _ => format!("{interrupted} interrupted, {rests} rests, {collapses} ends of a collapse"),
    };
    let ours = format!(
        "{collisions} collisions, {plane_collisions} with the plate, {further}, until {end:.3} s"
    );
    Note::new(format!("{method}, t_c = {contact_time:e} s: events"), "not given", ours)
}

/// How far the column is stretched: the gaps' sum, in diameters, on average, at least and at most.
fn note_plate(method: &str, contact_time: f64, heights: &[Vec<f64>]) -> Note {
    let stretch =
        |row: &Vec<f64>| (row[SHAKEN_BEADS - 1] - row[0]) / DIAMETER - (SHAKEN_BEADS - 1) as f64;
    let later = &heights[heights.len() / 5..];
    let mean = later.iter().map(stretch).sum::<f64>() / later.len() as f64;
    let most = later.iter().map(stretch).fold(0.0, f64::max);
    let least = later.iter().map(stretch).fold(0.0, f64::min);
    let said = match (method, contact_time > 1e-4) {
        ("MD", true) => "large separations all the time",
        ("MD", false) => "clustered and separated in turn",
        ("ED", _) => "always clustered",
        _ => "not given",
    };
    let what = format!("{method}, t_c = {contact_time:e} s: sum of gaps / d");
    let ours = format!("{} on average, {} to {most:.2}", fixed(mean, 3), fixed(least, 2));
    Note::new(what, said, ours)
}
