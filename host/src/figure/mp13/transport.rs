//! Do eMD and eMD* have the pressure and self-diffusion of MD? Reads nothing; writes both at a few packings and stiffnesses.
//!
//! MP13 leaves this open (Sec. VII). All three start from the same hard spheres in equilibrium, so the
//! energy is the same; what differs is what contacts do.

use super::gas::SoftGas;
use super::measure::{Effort, Measured, Variant, measure};
use crate::figure::data::{Figure, Made, Note, Options, Series, Value};
use crate::figure::draw::{self, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::plot::{Colour, Scene};
use crate::progress::Progress;
use anyhow::Result;
use rayon::prelude::*;

const GRAINS: usize = 1_000;
const PACKINGS: [f64; 4] = [0.01, 0.03, 0.1, 0.3];
const MODULI: [f64; 2] = [1e7, 1e9];
const QUANTITIES: [&str; 2] = ["self-diffusion", "pressure"];
/// Their units.
const UNITS: [&str; 2] = ["m²/s", "2 E/(3 V)"];

/// One gas, by one method, with one seed.
type Job = (SoftGas, Variant);

/// What is known of one gas by one method: mean and standard error of both quantities, over seeds.
#[derive(Clone, Copy)]
struct Point {
    packing: f64,
    young: f64,
    variant: Variant,
    found: [[f64; 2]; 2],
    exceptions: f64,
}

/// Makes the figure.
///
/// # Errors
/// An error of a method.
pub fn make(options: &Options) -> Result<Made> {
    let (seeds, measure) = if options.full { (16, 100.0) } else { (4, 50.0) };
    let effort = Effort { settle: 10.0, measure, steps: 50.0 };
    let points = points(seeds, effort)?;
    let axes = ["packing fraction η", "D (m²/s), or P V/(2 E/3)"];
    let mut figure = Figure::new("mp13-7-transport", axes);
    for (k, quantity) in QUANTITIES.into_iter().enumerate() {
        for young in MODULI {
            for variant in Variant::ALL {
                figure = figure.with(series((k, quantity), young, variant, &points));
            }
        }
    }
    let picture = draw::beside(panel(&figure, QUANTITIES[0]), panel(&figure, QUANTITIES[1]));
    let notes = points.iter().map(|point| note(point, &points)).collect();
    Ok(Made { figure, picture, notes })
}

fn points(seeds: u64, effort: Effort) -> Result<Vec<Point>> {
    let gases = MODULI.iter().flat_map(|young| PACKINGS.map(|packing| (*young, packing)));
    let kinds: Vec<(f64, f64, Variant)> = gases
        .flat_map(|(young, packing)| Variant::ALL.map(|variant| (young, packing, variant)))
        .collect();
    let job = |(young, packing, variant): &(f64, f64, Variant), seed| {
        let (young, packing) = (*young, *packing);
        (SoftGas { grains: GRAINS, packing, young, dissipation: 0.0, seed }, *variant)
    };
    let jobs: Vec<Job> =
        kinds.iter().flat_map(|kind| (1..=seeds).map(move |seed| job(kind, seed))).collect();
    let progress = Progress::new("mp13-7-transport", jobs.len() as u64);
    let one = |(gas, variant): &Job| {
        let found = measure(gas, *variant, effort);
        progress.add(1);
        found
    };
    let all: Vec<Measured> = jobs.par_iter().map(one).collect::<Result<_>>()?;
    let runs = all.chunks(seeds as usize);
    Ok(kinds.iter().zip(runs).map(|(kind, runs)| point(*kind, runs)).collect())
}

fn point((young, packing, variant): (f64, f64, Variant), runs: &[Measured]) -> Point {
    let mean = |of: fn(&Measured) -> f64| fit::mean(&runs.iter().map(of).collect::<Vec<_>>());
    let found = [mean(|run| run.diffusion), mean(|run| run.pressure)];
    Point { packing, young, variant, found, exceptions: mean(|run| run.exceptions)[0] }
}

fn series((k, quantity): (usize, &str), young: f64, variant: Variant, points: &[Point]) -> Series {
    let mut series = Series::new(format!("{}, Y = {young:e} Pa", variant.name()))
        .param("method", variant.name())
        .param("quantity", quantity)
        .param("young", young);
    for point in points.iter().filter(|point| point.variant == variant && point.young == young) {
        let [y, error] = point.found[k];
        series.push_with_error(point.packing, y, error);
    }
    series
}

/// By how much a value differs from another, in per cent, with its error.
fn difference([value, error]: [f64; 2], [other, of_other]: [f64; 2]) -> [f64; 2] {
    let ratio = value / other;
    [100.0 * (ratio - 1.0), 100.0 * ratio * (error / value).hypot(of_other / other)]
}

fn note(point: &Point, all: &[Point]) -> Note {
    let same = |p: &&Point| p.packing == point.packing && p.young == point.young;
    let md = all.iter().filter(same).find(|p| p.variant == Variant::Md).unwrap_or(point);
    let text = |k: usize| {
        let [value, error] = point.found[k];
        let [more, of_more] = difference(point.found[k], md.found[k]);
        let than = match point.variant {
            Variant::Md => String::new(),
            _ => format!(" ({more:+.2} ± {of_more:.2} % from MD)"),
        };
        format!("{} {value:.5} ± {error:.5} {}{than}", QUANTITIES[k], UNITS[k])
    };
    let exceptions = match point.variant {
        Variant::EmdStar => format!("; {:.2} exceptions per 1000", 1000.0 * point.exceptions),
        _ => String::new(),
    };
    let what = format!("η = {}, Y = {:e} Pa, {}", point.packing, point.young, point.variant.name());
    Note::new(what, "left open", format!("{}, {}{exceptions}", text(0), text(1)))
}

/// One quantity of eMD and eMD*, as a difference from MD.
fn panel(figure: &Figure, quantity: &str) -> Scene {
    let mut part = Figure { series: Vec::new(), ..figure.clone() };
    let find = |method: &str, young: f64| {
        let wanted = [("method", method), ("quantity", quantity)].map(|(k, v)| (k, v.into()));
        figure.find(&[wanted.to_vec(), vec![("young", Value::Number(young))]].concat())
    };
    for (young, gpa) in MODULI.into_iter().zip(["0.01 GPa", "1 GPa"]) {
        for method in ["eMD", "eMD*"] {
            let (Some(found), Some(md)) = (find(method, young), find("MD", young)) else {
                continue;
            };
            let mut series = Series::new(format!("{method}, Y = {gpa}"));
            for i in 0..found.x.len() {
                let of = |s: &Series| [s.y[i], s.yerr[i]];
                let [y, error] = difference(of(found), of(md));
                series.push_with_error(found.x[i], y, error);
            }
            part = part.with(series);
        }
    }
    let style = PlotStyle::new(format!("{quantity}: difference from MD (*N* = 1,000, elastic)"))
        .labels("packing fraction η", "difference [%]")
        .scales(Scale::LOG.from(7e-3, 0.45), Scale::LINEAR)
        .mark(Mark::Level(0.0, "MD".to_owned()));
    draw::draw(&part, &PlotStyle { colours: colours(), ..style })
}

/// One colour a method, paler for the soft grains.
fn colours() -> Vec<Colour> {
    let hues = [Colour::EMD, Colour::EMD_STAR];
    [0.4, 1.0].into_iter().flat_map(|opacity| hues.map(|hue| hue.with_opacity(opacity))).collect()
}
