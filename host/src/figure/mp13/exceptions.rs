//! Where can eMD* be trusted? Reads packing fractions and Young's moduli; writes how often it makes exceptions (MP13 Fig. 7).

use super::gas::{Counted, SoftGas};
use crate::figure::draw::{self, Look, Mark, Scale};
use crate::figure::{Figure, Made, Note, Options, Progress, Series};
use crate::plot::{Colour, Scene, colour};
use anyhow::Result;
use rayon::prelude::*;

const PACKINGS: [f64; 6] = [3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1];
const MODULI: [f64; 5] = [1e7, 1e8, 1e9, 1e10, 1e11];
/// The gas that both scans share.
const MIDDLE: SoftGas =
    SoftGas { grains: 10_000, packing: 1e-3, young: 1e9, dissipation: 0.0, seed: 1 };
/// A: none, as in the paper, and so much that ε is about 0.9 at 2 m/s and 1 GPa.
const DISSIPATIONS: [f64; 2] = [0.0, 4e-5];

/// What is varied.
const SCANS: [&str; 2] = ["packing", "young"];

/// The gases of a scan.
fn gases(scan: &str, dissipation: f64) -> Vec<(f64, SoftGas)> {
    let gas = SoftGas { dissipation, ..MIDDLE };
    match scan {
        "packing" => PACKINGS.iter().map(|x| (*x, SoftGas { packing: *x, ..gas })).collect(),
        _ => MODULI.iter().map(|x| (*x, SoftGas { young: *x, ..gas })).collect(),
    }
}

/// Makes the figure: frequencies of both exceptions along both scans, elastic and dissipative.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 1_000_000 } else { 30_000 };
    let points = (PACKINGS.len() + MODULI.len()) * DISSIPATIONS.len();
    let progress = Progress::new("mp13-7", points as u64);
    let axes = ["packing fraction η, or Y (Pa)", "exceptions per 1000 collisions"];
    let mut figure = Figure::new("mp13-7", axes);
    let mut notes = Vec::new();
    for scan in SCANS {
        for dissipation in DISSIPATIONS {
            let one = |(x, gas): &(f64, SoftGas)| {
                let counted = gas.count(collisions);
                progress.add(1);
                counted.map(|counted| (*x, counted))
            };
            let counted: Vec<(f64, Counted)> =
                gases(scan, dissipation).par_iter().map(one).collect::<Result<_>>()?;
            for exception in ["a", "b"] {
                figure = figure.with(series(scan, dissipation, exception, &counted));
            }
            notes.extend(counted.iter().map(|(x, counted)| note(scan, dissipation, *x, counted)));
        }
    }
    let picture = picture(&figure);
    Ok(Made { figure, picture, notes })
}

fn frequency(exception: &str, counted: &Counted) -> [f64; 2] {
    counted.per_thousand(match exception {
        "a" => counted.counters.rotation_refused,
        _ => counted.counters.interrupted,
    })
}

fn kind(dissipation: f64) -> &'static str {
    if dissipation == 0.0 { "elastic" } else { "dissipative" }
}

fn series(scan: &str, dissipation: f64, exception: &str, all: &[(f64, Counted)]) -> Series {
    let mut series = Series::new(format!("({exception}) {}", kind(dissipation)))
        .param("method", "eMD*")
        .param("against", scan)
        .param("exception", exception)
        .param("dissipation", dissipation);
    for (x, counted) in all {
        let [y, error] = frequency(exception, counted);
        series.push_with_error(*x, y, error);
    }
    series
}

fn note(scan: &str, dissipation: f64, x: f64, counted: &Counted) -> Note {
    let Counted { counters, thermal_velocity } = counted;
    let [[a, da], [b, db]] = ["a", "b"].map(|exception| frequency(exception, counted));
    let ours = format!(
        "(a) {a:.3} ± {da:.3}, (b) {b:.3} ± {db:.3}; {} outside the table; {thermal_velocity:.2} m/s at the end",
        counters.hard_sphere
    );
    let says = match dissipation == 0.0 && (scan == "young" || x <= 0.01) {
        true => "about 1 or less; none if hard or dilute",
        false => "not given",
    };
    let name = if scan == "packing" { "η" } else { "Y" };
    Note::new(format!("{}, {name} = {x:e}: in 1/1000", kind(dissipation)), says, ours)
}

/// One diagram for each scan.
fn picture(figure: &Figure) -> Scene {
    let [left, right] = SCANS.map(|scan| {
        let mut part = figure.clone();
        part.series.retain(|series| series.params.get("against") == Some(&scan.into()));
        let (title, label, range) = match scan {
            "packing" => ("*Y* = 1 GPa", "packing fraction η", [2e-4, 0.2]),
            _ => ("η = 0.001", "*Y* [Pa]", [4e6, 3e11]),
        };
        let look = Look::new(format!("Exceptions of eMD∗, *N* = 10,000, {title} (MP13 Fig. 7)"))
            .labels(label, "*f*_{e} [1/1000]")
            .scales(Scale::LOG.from(range[0], range[1]), Scale::LOG.from(1e-3, 1e3))
            .mark(Mark::Level(1.0, "paper: “about 0.1 %”".to_owned()));
        draw::draw(&part, &Look { colours: colours(), ..look })
    });
    draw::beside(left, right)
}

/// One colour an exception, paler with dissipation.
fn colours() -> Vec<Colour> {
    let hues = [colour::BLUE, colour::EMD];
    [1.0, 0.4].into_iter().flat_map(|opacity| hues.map(|hue| hue.with_opacity(opacity))).collect()
}
