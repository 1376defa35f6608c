//! How fast do disks run out of a hopper? Lets them out of openings of several widths; writes rates beside Beverloo's law.

mod beverloo;
mod run;

pub use beverloo::{Beverloo, fit};
pub use run::{Hopper, Rate};

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, PlotStyle, Scale};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use rayon::prelude::*;

/// The openings of the figure (d). Narrower than five diameters, disks with friction block them sooner or later.
const OPENINGS: [f64; 4] = [6.0, 8.0, 11.0, 15.0];
/// Disks that leave before it is looked at, and while it is.
const BEFORE: usize = 300;
const COUNTED: usize = 3000;

/// Makes the figure.
///
/// # Errors
/// An error of the engine; a hopper that no disk leaves any longer.
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("hopper", OPENINGS.len() as u64);
    let one = |&opening: &f64| {
        let rate = Hopper { opening, seed: 1 }.run([BEFORE, COUNTED]);
        progress.add(1);
        rate
    };
    let rates: Vec<Rate> = OPENINGS.par_iter().map(one).collect::<Result<_>>()?;
    let law = fit(&rates, Some(1.5)).context("no fit")?;
    let free = fit(&rates, None).context("no fit")?;
    let figure = figure(&rates, &law);
    let picture = picture(&figure);
    Ok(Made { figure, picture, notes: notes(&rates, &law, &free) })
}

fn figure(rates: &[Rate], law: &Beverloo) -> Figure {
    let mut series = Series::new("rough disks");
    for rate in rates {
        series.push_with_error(rate.opening, rate.mean, rate.error);
    }
    let mut curve = Series::new("Beverloo's law").param("k", law.k).param("C", law.c);
    for opening in (0..=100).map(|i| law.k + (16.0 - law.k) * f64::from(i) / 100.0) {
        curve.push(opening, law.rate(opening));
    }
    Figure::new("hopper", ["D/d", "mass per time (m √(g/d))"]).with(series).with(curve)
}

fn picture(figure: &Figure) -> Scene {
    let style = PlotStyle::new("Rough disks run out of a hopper")
        .labels("*D*/*d*", "mass per time (*m* √(*g*/*d*))")
        .scales(Scale::LINEAR.from(0.0, 16.0), Scale::LINEAR.from(0.0, 70.0))
        .kinds(&[Kind::Dots, Kind::Line]);
    draw::draw(figure, &style)
}

fn notes(rates: &[Rate], law: &Beverloo, free: &Beverloo) -> Vec<Note> {
    let far = |rate: &Rate| (rate.mean / law.rate(rate.opening) - 1.0) * 100.0;
    let single = rates.iter().map(|rate| {
        let measured = format!("{:.2} ± {:.2} ({:+.1} %)", rate.mean, rate.error, far(rate));
        let what = format!("D = {} d: mass per time (beside the law)", rate.opening);
        Note::new(what, format!("{:.2}", law.rate(rate.opening)), measured)
    });
    let fitted = format!("{:.3} ± {:.3} (k = {:.2})", free.exponent, free.error, free.k);
    let constants = format!("C = {:.3}, k = {:.2}", law.c, law.k);
    let more = [
        Note::new("exponent, where it is fitted with C and k", "3/2", fitted),
        Note::new("constants, where the exponent is 3/2", "not given", constants),
    ];
    single.chain(more).collect()
}
