//! What becomes of a layer of grains in two dimensions that hits a wall? Reads gaps and heights; writes ε_eff by MD (L94 Sec. IV C, Figs. 4a, 4b).

use super::column::Column;
use super::loss::{self, STEPS};
use super::separation;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::progress::Progress;
use anyhow::Result;
use carom_reference::{
    Boundary, End, Exact, ForceLaw, Gear, Grain, Plate, Quiet, ReferenceError, System,
    VerletOptions,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

/// Grains side by side in the periodic direction.
pub const ACROSS: usize = 13;

/// A layer on a triangular lattice of constant d + s_0, periodic across, above a wall at 0.
///
/// # Units
///
/// SI; the grains' mass is 1 kg, for only K/m, D_n and D_t matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Rows, h; N = 13 h.
    pub rows: usize,
    /// d.
    pub diameter: f64,
    /// v_0, towards the wall.
    pub speed: f64,
    /// s_0.
    pub gap: f64,
    /// ε of a central impact of two grains.
    pub restitution: f64,
    /// Its contact time t_c.
    pub contact_time: f64,
    /// D_t in units of D_n.
    pub tangential: f64,
    /// Each grain is shifted at random by up to s_0/2 along both axes.
    pub seed: u64,
}

impl Layer {
    fn spacing(&self) -> f64 {
        self.diameter + self.gap
    }

    fn width(&self) -> f64 {
        ACROSS as f64 * self.spacing()
    }

    fn law(&self) -> Result<ForceLaw, ReferenceError> {
        let law = ForceLaw::spring_of(1.0, self.contact_time, self.restitution)?;
        match law {
            ForceLaw::PowerLaw { stiffness, beta, damping, gamma, .. } => {
                let tangential = self.tangential * damping;
                Ok(ForceLaw::PowerLaw { stiffness, beta, damping, gamma, tangential })
            }
            other => Ok(other),
        }
    }

    /// Places without overlaps, row by row.
    pub fn places(&self) -> Vec<[f64; 2]> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let (a, rise) = (self.spacing(), 0.5 * 3.0_f64.sqrt() * self.spacing());
        let mut places: Vec<[f64; 2]> = Vec::new();
        for k in 0..self.rows * ACROSS {
            let (row, column) = (k / ACROSS, k % ACROSS);
            let x = a * (column as f64 + 0.25 + 0.5 * (row % 2) as f64);
            let y = 0.5 * self.diameter + self.gap + rise * row as f64;
            let mut shift = || self.gap * rng.random_range(-0.5..0.5);
            let found =
                (0..10_000).map(|_| [x + shift(), y + shift()]).find(|p| self.free(p, &places));
            places.push(found.unwrap_or([x, y]));
        }
        places
    }

    /// Whether a grain at p overlaps none of the last two rows.
    fn free(&self, p: &[f64; 2], places: &[[f64; 2]]) -> bool {
        let width = self.width();
        let near = places.len().saturating_sub(2 * ACROSS);
        self.gap == 0.0
            || places[near..].iter().all(|q| {
                let dx = p[0] - q[0];
                let dx = dx - width * (dx / width).round();
                dx.hypot(p[1] - q[1]) > self.diameter
            })
    }

    /// Lets the layer hit the wall and returns ε_eff = √(E_f/E_0), by L94's integrator in so many
    /// steps per contact.
    ///
    /// It is over when there has been no contact for `patience` times the time in which a grain
    /// passes one gap (or one contact time, where that is longer), or after `longest` times that
    /// for each row: grains side by side in a periodic box never cease to touch. The paper has
    /// a patience of 2N, and no longest time.
    ///
    /// # Errors
    /// As [`Gear::advance_to`].
    pub fn collide(&self, steps: f64, patience: [f64; 2]) -> Result<f64, ReferenceError> {
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Gear::new(&self.system()?, self.law()?, End::Overlap, options)?;
        run.advance_until_quiet(self.quiet(patience))?;
        Ok(self.restitution_left(&run.grains()))
    }

    /// The same by MD that is exact to about 12 digits, contact by contact: cheaper where grains fly
    /// for longer than they touch.
    ///
    /// # Errors
    /// As [`Exact::advance_to`].
    pub fn collide_exactly(&self, patience: [f64; 2]) -> Result<f64, ReferenceError> {
        let mut run = Exact::new(self.system()?, self.law()?, End::Overlap)?;
        run.advance_until_quiet(self.quiet(patience))?;
        Ok(self.restitution_left(&run.grains()))
    }

    fn system(&self) -> Result<System<2>, ReferenceError> {
        let grain = |position: [f64; 2]| Grain {
            radius: 0.5 * self.diameter,
            mass: 1.0,
            position,
            velocity: [0.0, -self.speed],
        };
        let boundary =
            [Boundary::Periodic { lo: 0.0, hi: self.width() }, Boundary::Plate(Plate::fixed(0.0))];
        System::new(self.places().into_iter().map(grain).collect(), boundary, [0.0; 2])
    }

    fn quiet(&self, [patience, longest]: [f64; 2]) -> Quiet {
        let flight = (self.gap / self.speed).max(self.contact_time);
        Quiet { interval: patience * flight, limit: longest * self.rows as f64 * flight }
    }

    fn restitution_left(&self, grains: &[Grain<2>]) -> f64 {
        let energy: f64 =
            grains.iter().map(|g| g.velocity.iter().map(|v| v * v).sum::<f64>()).sum();
        (energy / grains.len() as f64).sqrt() / self.speed
    }
}

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
const MIN_SEPARATED: f64 = 2.0;

/// ε_eff of a wide layer: in steps where it is dense, contact by contact where it is not.
fn hit(sigma: f64, tangential: f64, seed: u64, patience: [f64; 2]) -> Result<f64, ReferenceError> {
    let layer = wide(sigma, tangential, seed);
    match sigma < MIN_SEPARATED {
        true => layer.collide(50.0, patience),
        false => layer.collide_exactly(patience),
    }
}

/// L94 Fig. 4a: ε_eff against σ.
///
/// # Errors
/// An error of a run.
pub fn make_a(options: &Options) -> Result<Made> {
    let (last, seeds, patience) =
        if options.full { (6, 10, [260.0, 100.0]) } else { (4, 3, [40.0, 20.0]) };
    let sigmas: Vec<f64> = (-6..=last).map(|k| libm::pow(10.0, 0.5 * f64::from(k))).collect();
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
        column.push(*sigma, separation::ten("MD", *sigma, 0.2, None)?);
    }
    let figure = figure.with(column);
    let style = PlotStyle::new("A layer of 130 grains at a wall, ε = 0.9 (L94 Fig. 4a)")
        .labels("σ = *s*_{0}/(*v*_{0} *t*_{c})", "ε_{eff}")
        .scales(Scale::LOG, Scale::LINEAR.from(0.0, 1.05))
        .mark(Mark::Place(0.1, "paper: falls from here".to_owned()))
        .mark(Mark::Place(10.0, "to here".to_owned()));
    let picture = draw::draw(&figure, &style);
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
/// An error of a run.
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
            let outcome = loss::impact("MD", &Column::new(n, 0.05, 0.0), &law, true)?;
            series.push(n as f64, 1.0 - outcome.restitution());
        }
        figure = figure.with(series);
    }
    let style = PlotStyle::new("Grains in contact hit a wall, in 2D and 1D (L94 Fig. 4b)")
        .labels("*h*", "1 − ε_{eff}")
        .scales(Scale::LOG.from(1.8, 24.0), Scale::LOG)
        .kinds(&[Kind::Both, Kind::Both, Kind::Both, Kind::Both, Kind::Dots, Kind::Dots]);
    let picture = draw::draw(&figure, &style);
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
