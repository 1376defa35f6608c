//! How often do three spheres overlap? Runs gases; writes the frequency of doubly overlapped grains (BSFP14 Fig. 5).

use super::gas::{self, Seen};
use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::{Figure, Made, Note, Options, Series};
use anyhow::Result;

const RESTITUTIONS: [f64; 8] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.0];
const DENSITIES: [f64; 3] = [0.1, 0.5, 0.9];
const GRAINS: usize = 1_372;

/// Makes the figure: one curve for each density, over the coefficient of restitution.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 1_000_000_000 } else { 150_000 };
    let seen = gas::all("bsfp14-5", GRAINS, [&DENSITIES, &RESTITUTIONS], collisions)?;
    let axes = ["coefficient of restitution ε", "three-body impacts per impact"];
    let mut figure = Figure::new("bsfp14-5", axes);
    for density in DENSITIES {
        figure = figure.with(series(density, seen.iter().filter(|s| s.density == density)));
    }
    let title = format!("Doubly overlapped grains, *N* = 1,372, {collisions} collisions each");
    let look = Look::new(title)
        .scales(Scale::LINEAR.from(0.0, 1.05), Scale::LOG.from(1e-10, 1.0))
        .kinds(&[Kind::Both])
        .mark(Mark::Points(vec![[1.0, 1e-9]], "paper: elastic, dilute".to_owned()))
        .mark(Mark::Level(1e-6, "paper: inelastic, up to".to_owned()));
    let picture = draw::draw(&figure, &look);
    Ok(Made { figure, picture, notes: notes(&seen) })
}

/// The error is Poisson's, and that of one event where none was seen.
fn series<'a>(density: f64, seen: impl Iterator<Item = &'a Seen>) -> Series {
    let mut series = Series::new(format!("ρ = {density}")).param("density", density);
    for Seen { restitution, overlaps, .. } in seen {
        let (hits, count) = (overlaps.three_body as f64, overlaps.impacts as f64);
        series.push_with_error(*restitution, hits / count, hits.max(1.0).sqrt() / count);
    }
    series
}

fn notes(seen: &[Seen]) -> Vec<Note> {
    let line = |seen: &Seen| {
        let Seen { restitution, density, overlaps, .. } = seen;
        let paper = if *restitution == 1.0 { "≈ 1e-9 (dilute)" } else { "up to ≈ 1e-6" };
        let ours = format!(
            "{} of {} impacts; deepest overlap {:.1e}",
            overlaps.three_body, overlaps.impacts, -overlaps.deepest
        );
        Note::new(format!("ε = {restitution}, ρ = {density}"), paper, ours)
    };
    seen.iter().map(line).collect()
}
