//! How does a column's loss at a wall depend on the gaps? Reads σ; writes ε_eff, by MD, ED, eMD* and with clusters (L94 Fig. 2a).
//!
//! L94's dashpot pulls at the end of a contact, until the overlap vanishes. In the engine's clusters nothing pulls
//! (MP13). So clusters are compared with two kinds of MD: the paper's, and one with the same K and D_n whose
//! contacts end when the force does. The second says how well contacts are integrated, the first what the
//! difference of the laws adds.

use super::column::Column;
use super::hard::{self, DEFAULT_STEPS, Variant};
use super::loss::{METHODS, impact};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::Result;
use carom_reference::{End, ForceLaw};
use carom_tables::read;
use rayon::prelude::*;

/// The abscissae of Fig. 2a, half a decade apart.
pub fn separations() -> impl Iterator<Item = f64> {
    (-6..=6).map(|k| libm::pow(10.0, 0.5 * f64::from(k)))
}

/// Columns of Fig. 2a: N = 10, ε = 0.9; only σ = s_0/(v_0 t_c) matters.
const TEN: usize = 10;
const SPEED: f64 = 0.2;
const CONTACT_TIME: f64 = 1e-5;

/// Beyond the paper: the engine's default under the rule of eMD*, and a pair of methods without pull.
const FURTHER: [&str; 3] = ["clusters", "MD, no pull", "clusters, no pull"];
/// What is compared: who, with whom, and its name in the right picture.
const PAIRS: [[&str; 3]; 4] = [
    ["eMD*", "MD", "eMD* − MD"],
    ["clusters", "MD", "clusters − MD"],
    ["MD, no pull", "MD", "MD, no pull − MD"],
    ["clusters, no pull", "MD, no pull", "clusters − MD, both no pull"],
];

/// ε_eff of N = 10, ε = 0.9 at a separation σ.
///
/// # Errors
/// As [`impact`].
pub fn ten(method: &str, sigma: f64, speed: f64, jitter: Option<u64>) -> Result<f64> {
    let law = ForceLaw::spring_of(1.0, CONTACT_TIME, 0.9)?;
    let gap = sigma * speed * CONTACT_TIME;
    let column = Column { jitter, ..Column::new(TEN, speed, gap) };
    let outcome = match method {
        "MD, no pull" => column.collide_until(law, End::Force)?,
        "clusters, no pull" => hard::collide(&column, &law, no_pull(DEFAULT_STEPS))?,
        "clusters, no pull, 64 steps" => hard::collide(&column, &law, no_pull(64))?,
        _ => impact(method, &column, &law, true)?,
    };
    Ok(outcome.restitution())
}

const fn no_pull(steps: u32) -> Variant {
    Variant::Clusters { end: read::End::Force, steps }
}

/// L94 Fig. 2a: ε_eff against σ.
///
/// # Errors
/// As [`impact`].
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("l94-2a", (METHODS.len() + FURTHER.len()) as u64);
    let mut figure = Figure::new("l94-2a", ["σ = s0/(v0 t_c)", "ε_eff"]);
    for method in METHODS.into_iter().chain(FURTHER) {
        let mut series = Series::new(method).param("method", method).param("eps", 0.9);
        for sigma in separations() {
            series.push(sigma, ten(method, sigma, SPEED, None)?);
        }
        figure = figure.with(series.param("N", TEN as f64));
        progress.add(1);
    }
    let notes = notes(&figure)?;
    Ok(Made { picture: picture(&figure), figure, notes })
}

/// The paper's picture, and beside it how far some are from each other.
fn picture(figure: &Figure) -> Scene {
    let x = Scale::LOG.from(5e-4, 2e3);
    let label = "σ = *s*_{0}/(*v*_{0} *t*_{c})";
    let mut all = figure.clone();
    all.series.truncate(METHODS.len() + 1);
    let style = PlotStyle::new("A column of 10 beads at a wall, ε = 0.9 (L94 Fig. 2a)")
        .labels(label, "ε_{eff}")
        .scales(x, Scale::LINEAR.from(0.0, 1.05))
        .kinds(&[Kind::Both, Kind::Line, Kind::Dots])
        .mark(Mark::Level(0.341, "paper: ED, 0.341".to_owned()));
    let mut apart = Figure::new("l94-2a", ["", ""]);
    for [who, whom, name] in PAIRS {
        let mut series = Series::new(name);
        let all = separations().zip(differences(figure, who, whom));
        all.filter(|(_, y)| *y > 0.0).for_each(|(x, y)| series.push(x, y));
        apart = apart.with(series);
    }
    let beside = PlotStyle::new("How far is one from the other?")
        .labels(label, "|difference of ε_{eff}|")
        .scales(x, Scale::LOG.from(1e-6, 1.0))
        .mark(Mark::Level(1e-3, "0.001".to_owned()));
    draw::beside(draw::draw(&all, &style), draw::draw(&apart, &beside))
}

/// |ε_eff| of one method less that of another, for each σ.
fn differences(figure: &Figure, who: &str, whom: &str) -> Vec<f64> {
    let of = |method: &str| figure.find(&[("method", method.into())]).map(|s| s.y.as_slice());
    let pairs = of(who).unwrap_or_default().iter().zip(of(whom).unwrap_or_default());
    pairs.map(|(a, b)| (a - b).abs()).collect()
}

fn notes(figure: &Figure) -> Result<Vec<Note>> {
    let of = |method: &str, k: usize| {
        figure.find(&[("method", method.into())]).map_or(f64::NAN, |s| s.y[k])
    };
    let [low, high] = every_ed()?;
    let shifted = shifted()?;
    let most = |all: Vec<f64>| all.into_iter().fold(0.0, f64::max);
    let within =
        |who, whom| format!("within {:.1e} at every σ", most(differences(figure, who, whom)));
    let finer = finer(figure)?;
    let ours = |what, ours| Note::new(what, "not given", ours);
    Ok(vec![
        Note::new("ED, every s0 and v0, with jitter", "0.341 ± 0.002", span(low, high)),
        Note::new("MD, σ = 1000", "near ED", format!("{:.5}", of("MD", 12))),
        Note::new("MD, σ = 0.001", "loss very small", format!("{:.5}", of("MD", 0))),
        Note::new("MD drops", "0.1 < σ < 1", format!("{:.3} to {:.3}", of("MD", 4), of("MD", 6))),
        Note::new("MD, gaps at random, σ ≤ 0.1", "same curve", format!("within {:.4}", shifted[0])),
        Note::new("MD, gaps at random, σ ≥ 10", "same curve", format!("within {:.1e}", shifted[1])),
        ours("eMD* against ED", within("eMD*", "ED")),
        ours("clusters against MD, both without pull", within("clusters, no pull", "MD, no pull")),
        ours("the same in 64 steps a contact", format!("within {finer:.1e} at every σ")),
        ours("MD without pull against MD", within("MD, no pull", "MD")),
        ours("clusters against MD", within("clusters", "MD")),
    ])
}

/// How far clusters in 64 steps a contact are from MD, both without pull.
fn finer(figure: &Figure) -> Result<f64> {
    let md = figure.find(&[("method", "MD, no pull".into())]);
    let md = md.map(|s| s.y.as_slice()).unwrap_or_default();
    let one = |(sigma, y): (f64, &f64)| -> Result<f64> {
        Ok((ten("clusters, no pull, 64 steps", sigma, SPEED, None)? - y).abs())
    };
    let all: Result<Vec<f64>> = separations().zip(md).map(one).collect();
    Ok(all?.into_iter().fold(0.0, f64::max))
}

fn span(low: f64, high: f64) -> String {
    format!("{low:.5} to {high:.5}")
}

/// The least and the largest ε_eff of ED, over the paper's gaps and speeds, regular and at random.
///
/// # Errors
/// As [`impact`].
pub fn every_ed() -> Result<[f64; 2]> {
    let law = ForceLaw::spring_of(1.0, CONTACT_TIME, 0.9)?;
    let [mut low, mut high] = [f64::INFINITY, 0.0_f64];
    for gap in [0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        for speed in [0.01, 0.2, 20.0] {
            for jitter in [None, Some(1), Some(2)] {
                let column = Column { jitter, ..Column::new(TEN, speed, gap) };
                let eps = impact("ED", &column, &law, true)?.restitution();
                [low, high] = [low.min(eps), high.max(eps)];
            }
        }
    }
    Ok([low, high])
}

/// How far MD with gaps at random is from MD with equal ones, at small and at large σ.
fn shifted() -> Result<[f64; 2]> {
    let most = |sigmas: [f64; 3]| {
        let one = |(sigma, seed)| -> Result<f64> {
            Ok((ten("MD", sigma, SPEED, Some(seed))? - ten("MD", sigma, SPEED, None)?).abs())
        };
        let runs: Vec<_> = sigmas.into_iter().flat_map(|s| (0..4).map(move |k| (s, k))).collect();
        let all: Result<Vec<f64>> = runs.into_par_iter().map(one).collect();
        Ok::<f64, anyhow::Error>(all?.into_iter().fold(0.0, f64::max))
    };
    Ok([most([1e-3, 1e-2, 1e-1])?, most([10.0, 100.0, 1000.0])?])
}
