//! Does the detachment effect show in two dimensions? Reads gaps and heights; writes ε_eff of layers (L94 Figs. 4a, 4b).

use super::column::Column;
use super::fig2::{self, STEPS};
use super::fit;
use super::layer::Layer;
use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use anyhow::Result;
use carom_reference::{ForceLaw, ReferenceError};
use rayon::prelude::*;

/// D_t in units of D_n; the paper does not give it.
pub const TANGENTIAL: [f64; 2] = [0.0, 1.0];

/// The layer of Fig. 4a: N = 130, d = 1 mm, ε = 0.9.
pub const fn wide(sigma: f64, tangential: f64, seed: u64) -> Layer {
    let (speed, contact_time) = (0.1, 1e-5);
    let gap = sigma * speed * contact_time;
    Layer { rows: 10, diameter: 1e-3, speed, gap, restitution: 0.9, contact_time, tangential, seed }
}

/// From this σ on layers are dealt with contact by contact: in steps, nearly all of them would be in
/// free flight.
const APART: f64 = 2.0;

/// ε_eff of a wide layer: in steps where it is dense, contact by contact where it is not.
fn hit(sigma: f64, tangential: f64, seed: u64, patience: [f64; 2]) -> Result<f64, ReferenceError> {
    let layer = wide(sigma, tangential, seed);
    match sigma < APART {
        true => layer.collide(50.0, patience),
        false => layer.collide_exactly(patience),
    }
}

/// L94 Fig. 4a: ε_eff against σ.
///
/// # Errors
/// What a run says.
pub fn make_a(options: &Options) -> Result<Made> {
    let (last, seeds, patience) =
        if options.full { (6, 10, [260.0, 100.0]) } else { (4, 3, [40.0, 20.0]) };
    let sigmas: Vec<f64> = (-6..=last).map(|k| 10f64.powf(0.5 * f64::from(k))).collect();
    let progress = Progress::new("l94-4a", (TANGENTIAL.len() * sigmas.len()) as u64 * seeds);
    let mut figure = Figure::new("l94-4a", ["σ = s0/(v0 t_c)", "ε_eff"]);
    for tangential in TANGENTIAL {
        let one = |&sigma: &f64| -> Result<[f64; 2]> {
            let run = |seed| {
                let eps = hit(sigma, tangential, seed, patience);
                progress.add(1);
                eps
            };
            let all: Vec<f64> = (0..seeds).into_par_iter().map(run).collect::<Result<_, _>>()?;
            Ok(fit::mean(&all))
        };
        let means: Vec<[f64; 2]> = sigmas.par_iter().map(one).collect::<Result<_>>()?;
        let mut series = Series::new(format!("MD in 2D, D_t = {tangential} D_n"))
            .param("method", "MD")
            .param("dimension", 2.0)
            .param("dt_over_dn", tangential);
        sigmas.iter().zip(means).for_each(|(s, [y, e])| series.push_with_error(*s, y, e));
        figure = figure.with(series);
    }
    let mut column = Series::new("MD in 1D, N = 10").param("method", "MD").param("dimension", 1.0);
    for sigma in &sigmas {
        column.push(*sigma, fig2::ten("MD", *sigma, 0.2, None)?);
    }
    let figure = figure.with(column);
    let look = Look::new("A layer of 130 grains at a wall, ε = 0.9 (L94 Fig. 4a)")
        .labels("σ = *s*_{0}/(*v*_{0} *t*_{c})", "ε_{eff}")
        .scales(Scale::LOG, Scale::LINEAR.from(0.0, 1.05))
        .mark(Mark::Place(0.1, "paper: falls from here".to_owned()))
        .mark(Mark::Place(10.0, "to here".to_owned()));
    let picture = draw::draw(&figure, &look);
    let notes = notes_a(&figure);
    Ok(Made { figure, picture, notes })
}

fn notes_a(figure: &Figure) -> Vec<Note> {
    let says = ["as in 1D", "falls for 0.1 < σ < 10", "as in 1D"];
    let place = |series: &Series, wanted: f64| {
        let far = |x: &f64| (x.ln() - wanted.ln()).abs();
        (0..series.x.len()).min_by(|a, b| far(&series.x[*a]).total_cmp(&far(&series.x[*b])))
    };
    let at = |sigma: f64| {
        let value = |s: &Series| place(s, sigma).map_or(f64::NAN, |k| s.y[k]);
        let all: Vec<String> = figure.series.iter().map(|s| format!("{:.3}", value(s))).collect();
        all.join(", ")
    };
    let what = |sigma: f64| format!("σ = {sigma}: D_t = 0, D_t = D_n, 1D");
    [1e-3, 1.0, 100.0]
        .into_iter()
        .zip(says)
        .map(|(s, says)| Note::new(what(s), says, at(s)))
        .collect()
}

/// The layer of Fig. 4b: grains in contact, v_0 = 0.05 m/s, t_c = 2e-5 s.
pub const fn touching(rows: usize, restitution: f64, tangential: f64) -> Layer {
    let (speed, contact_time) = (0.05, 2e-5);
    Layer { rows, diameter: 1e-3, speed, gap: 0.0, restitution, contact_time, tangential, seed: 0 }
}

/// L94 Fig. 4b: 1 − ε_eff against the height.
///
/// # Errors
/// What a run says.
pub fn make_b(options: &Options) -> Result<Made> {
    let heights: Vec<usize> = (2..=21).collect();
    let steps = if options.full { STEPS } else { 100.0 };
    let runs =
        [0.6, 0.9].into_iter().flat_map(|eps| TANGENTIAL.map(|tangential| (eps, tangential)));
    let progress = Progress::new("l94-4b", 4 * heights.len() as u64);
    let mut figure = Figure::new("l94-4b", ["h (rows)", "1 - ε_eff"]);
    for (eps, tangential) in runs {
        let one = |&rows: &usize| {
            let found = touching(rows, eps, tangential).collide(steps, [2.0, 20.0]);
            progress.add(1);
            found
        };
        let y: Vec<f64> = heights.par_iter().map(one).collect::<Result<_, _>>()?;
        let mut series = Series::new(format!("2D, ε = {eps}, D_t = {tangential} D_n"))
            .param("method", "MD")
            .param("dimension", 2.0)
            .param("eps", eps)
            .param("dt_over_dn", tangential);
        heights.iter().zip(y).for_each(|(h, y)| series.push(*h as f64, 1.0 - y));
        figure = figure.with(series);
    }
    for eps in [0.6, 0.9] {
        let law = ForceLaw::spring_of(1.0, 2e-5, eps)?;
        let mut series = Series::new(format!("1D, ε = {eps}"))
            .param("method", "MD")
            .param("dimension", 1.0)
            .param("eps", eps);
        for n in [2, 5, 10, 20] {
            let outcome = fig2::impact("MD", &Column::new(n, 0.05, 0.0), &law, true)?;
            series.push(n as f64, 1.0 - outcome.restitution());
        }
        figure = figure.with(series);
    }
    let look = Look::new("Grains in contact hit a wall, in 2D and 1D (L94 Fig. 4b)")
        .labels("*h*", "1 − ε_{eff}")
        .scales(Scale::LOG.from(1.8, 24.0), Scale::LOG)
        .kinds(&[Kind::Both, Kind::Both, Kind::Both, Kind::Both, Kind::Dots, Kind::Dots]);
    let picture = draw::draw(&figure, &look);
    let notes = [0.6, 0.9].into_iter().map(|eps| note_b(&figure, eps)).collect();
    Ok(Made { figure, picture, notes })
}

/// Ten rows in two dimensions against ten beads in one.
fn note_b(figure: &Figure, eps: f64) -> Note {
    let at = |more: &[(&str, crate::figure::Value)]| {
        let mut params = vec![("eps", eps.into())];
        params.extend_from_slice(more);
        let ten = |s: &Series| s.x.iter().position(|h| *h == 10.0).map(|k| s.y[k]);
        figure.find(&params).and_then(ten).unwrap_or(f64::NAN)
    };
    let two = |ratio: f64| at(&[("dimension", 2.0.into()), ("dt_over_dn", ratio.into())]);
    let ours = format!(
        "{:.4} (D_t = 0), {:.4} (D_t = D_n), {:.4} (1D)",
        two(0.0),
        two(1.0),
        at(&[("dimension", 1.0.into())])
    );
    Note::new(format!("1 - ε_eff, h = 10, ε = {eps}"), "2D and 1D alike", ours)
}
