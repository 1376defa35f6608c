//! How do ten beads leave a wall? Reads gaps; writes their trajectories by MD, ED and eMD* (L94 Fig. 1).

use super::column::Column;
use super::fig2::METHODS;
use super::hard::{self, Way};
use super::panels::{self, Diagram};
use crate::figure::{Figure, Made, Note, Options, Series};
use anyhow::Result;
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
        "ED" => hard::heights(&column, &law, Way::Instant, &times(gap))?,
        "eMD*" => hard::heights(&column, &law, Way::Lasting, &times(gap))?,
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
/// What a method says.
pub fn make(_: &Options) -> Result<Made> {
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
            notes.push(note(method, gap, &times, &heights));
            let title = format!("{}, *s*_{{0}} = {} μm", method.replace('*', "∗"), gap * 1e6);
            let x = [0.0, 1e6 * times[SAMPLES]];
            diagrams.push(Diagram { title, curves, x, y: None });
        }
    }
    let title = "Ten beads at a wall, ε = 0.9, *t*_{c} = 7 μs, *v*_{0} = 0.2 m/s (L94 Fig. 1)";
    let picture = panels::draw(title, &diagrams, GAPS.len(), ["*t* [μs]", "*z*_{i} [μm]"]);
    Ok(Made { figure, picture, notes })
}

fn in_micro(series: &Series) -> Vec<[f64; 2]> {
    series.x.iter().zip(&series.y).map(|(t, z)| [1e6 * t, 1e6 * z]).collect()
}

/// The velocity of the centre of mass and the spread at the end.
fn note(method: &str, gap: f64, times: &[f64], heights: &[Vec<f64>]) -> Note {
    let centre = |k: usize| heights[k].iter().sum::<f64>() / BEADS as f64;
    let last = times.len() - 1;
    let speed = (centre(last) - centre(last - 4)) / (times[last] - times[last - 4]) / SPEED;
    let said = match (method, gap > 5e-6) {
        ("eMD*", _) => "not given",
        ("MD", false) => "larger than in ED",
        ("MD", true) => "similar to ED",
        _ => "the same for all s0",
    };
    let what = format!("{method}, s0 = {gap:e}: final v_cm/v0");
    Note::new(what, said, format!("{speed:.3}"))
}
