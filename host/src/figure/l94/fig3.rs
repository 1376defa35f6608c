//! Does the force law matter to beads in contact? Reads exponents; writes ε_eff against N (L94 Fig. 3).

use super::column::Column;
use super::fig2::impact;
use crate::figure::draw::{self, Look, Scale};
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use anyhow::Result;
use carom_reference::ForceLaw;
use rayon::prelude::*;

/// N of the figure.
pub const BEADS: [usize; 8] = [1, 2, 5, 10, 20, 50, 100, 200];
const SPEED: f64 = 0.05;

/// Name, β, γ, K/m (1/(s² m^β)) and D_n (1/(s m^γ)), as the paper gives them.
pub const LAWS: [(&str, [f64; 4]); 3] = [
    ("Hooke", [0.0, 0.0, 2e9, 3.17e3]),
    ("Hertz", [0.5, 0.0, 2e12, 2e3]),
    ("Hertz–Kuwabara–Kono", [0.5, 0.5, 2e12, 1e5]),
];

/// One of them, for beads of mass 1: the paper's m is the reduced mass (Sec. III A).
pub fn law([beta, gamma, per_mass, damping]: [f64; 4]) -> ForceLaw {
    ForceLaw::PowerLaw { stiffness: 0.5 * per_mass, beta, damping, gamma, tangential: 0.0 }
}

/// Makes the figure.
///
/// # Errors
/// What a method says.
pub fn make(options: &Options) -> Result<Made> {
    let runs = LAWS.map(|(name, numbers)| ("MD", name, numbers)).into_iter();
    let hooke = LAWS[0];
    let runs = runs.chain(["ED", "eMD*"].map(|method| (method, hooke.0, hooke.1)));
    let runs: Vec<(&str, &str, [f64; 4])> = runs.collect();
    let progress = Progress::new("l94-3", (runs.len() * BEADS.len()) as u64);
    let one = |&(method, name, numbers): &(&str, &str, [f64; 4])| -> Result<Series> {
        let beads = |&n: &usize| {
            let outcome = impact(method, &Column::new(n, SPEED, 0.0), &law(numbers), options.full);
            progress.add(1);
            outcome.map(|outcome| outcome.restitution())
        };
        let y: Vec<f64> = BEADS.par_iter().map(beads).collect::<Result<_>>()?;
        let mut series = Series::new(format!("{method}, {name}"))
            .param("method", method)
            .param("beta", numbers[0])
            .param("gamma", numbers[1]);
        BEADS.iter().zip(y).for_each(|(n, y)| series.push(*n as f64, y));
        Ok(series)
    };
    let series = runs.par_iter().map(one).collect::<Result<Vec<_>>>()?;
    let figure =
        series.into_iter().fold(Figure::new("l94-3", ["N", "ε_eff"]), |f, series| f.with(series));
    let look = Look::new("Beads in contact, three force laws (L94 Fig. 3)")
        .labels("*N*", "ε_{eff}")
        .scales(Scale::LOG, Scale::LINEAR.from(-0.02, 1.05));
    let picture = draw::draw(&figure, &look);
    let notes = figure.series.iter().map(note).collect();
    Ok(Made { figure, picture, notes })
}

fn note(series: &Series) -> Note {
    let said = match series.name.as_str() {
        "MD, Hooke" => "increases with N",
        "ED, Hooke" => "close to 0 for large N(1 − ε)",
        "eMD*, Hooke" => "not given",
        _ => "varies little with N",
    };
    let span = |from: usize| format!("{:.4} (N = {})", series.y[from], series.x[from]);
    let ours = format!("{} to {}", span(1), span(series.y.len() - 1));
    Note::new(series.name.clone(), said, ours)
}
