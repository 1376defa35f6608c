//! How far are eMD and eMD* from MD, for two soft grains? Runs the scenario of MP13 Fig. 6 by each; writes paths and distances.

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::number::significant;
use crate::method;
use crate::plot::methods;
use crate::scenario::{MatrixSpec, MethodName, Placed, Scenario, Start};
use crate::tables::Size;
use anyhow::{Context, Result};

/// The scenario, as shipped.
pub const SCENARIO: &str = include_str!("../../../scenarios/fig6.toml");
/// Steps of a path between two of the scenario's samples.
const FINE: u32 = 8;
/// l.
const CONTACT_DISTANCE: f64 = 0.2;
/// Samples from touch to end.
const DOTS: u32 = 7;
/// The sample at which the grains touch.
const TOUCH: u32 = 4;

/// One way to follow the grains.
struct Variant {
    name: &'static str,
    method: MethodName,
    /// None to integrate the contact equation.
    table: Option<Size>,
}

const VARIANTS: [Variant; 5] = [
    Variant { name: "MD, exact", method: MethodName::Exact, table: None },
    Variant { name: "eMD", method: MethodName::Emd, table: None },
    Variant { name: "eMD*", method: MethodName::EmdStar, table: None },
    Variant { name: "eMD*, table fine", method: MethodName::EmdStar, table: Some(Size::Fine) },
    Variant { name: "eMD*, table wide", method: MethodName::EmdStar, table: Some(Size::Wide) },
];

impl Variant {
    /// The two grains at all steps; just after each sample, so that rounding does not decide whether a contact has ended.
    fn follow(&self, scenario: &Scenario) -> Result<Vec<[Placed; 2]>> {
        let mut scenario = scenario.clone();
        if let Some(table) = self.table {
            (scenario.options.matrix, scenario.options.table) = (MatrixSpec::Table, table);
        }
        let start = Start::new(&scenario)?;
        method::with(self.method, &scenario, &start, |method| {
            let step = |k: u32| {
                method.advance_to(time(&scenario, k) + 1e-6 * scenario.sample)?;
                let grains = method.grains();
                <[Placed; 2]>::try_from(grains).ok().context("two grains")
            };
            (0..=last(&scenario)).map(step).collect()
        })
    }
}

fn last(scenario: &Scenario) -> u32 {
    FINE * (scenario.duration.unwrap_or(0.0) / scenario.sample).round() as u32
}

fn time(scenario: &Scenario, step: u32) -> f64 {
    f64::from(step) * scenario.sample / f64::from(FINE)
}

/// Makes the figure.
///
/// # Errors
/// An error of a method.
pub fn make(_: &Options) -> Result<Made> {
    let scenario = Scenario::parse(SCENARIO).context("fig6.toml")?;
    let paths: Vec<Vec<[Placed; 2]>> =
        VARIANTS.iter().map(|variant| variant.follow(&scenario)).collect::<Result<_>>()?;
    let mut figure = Figure::new("mp13-6", ["x (m)", "y (m)"]);
    for (variant, path) in VARIANTS.iter().zip(&paths) {
        for grain in [0, 1] {
            let mut series = Series::new(format!("{}, grain {}", variant.name, grain + 1))
                .param("method", variant.name)
                .param("grain", grain as f64 + 1.0)
                .param("time_step", time(&scenario, 1));
            path.iter().for_each(|at| series.push(at[grain].position[0], at[grain].position[1]));
            figure = figure.with(series);
        }
    }
    let picture = methods::fig6(&scenario)?;
    Ok(Made { figure, picture, notes: notes(&scenario, &paths) })
}

fn notes(scenario: &Scenario, paths: &[Vec<[Placed; 2]>]) -> Vec<Note> {
    let tau = f64::from(DOTS) * scenario.sample;
    let mut notes =
        vec![Note::new("duration τ of the contact", "not given", format!("{tau:.6} s"))];
    for (variant, path) in VARIANTS.iter().zip(paths).skip(1) {
        let [during, after] = distances(&paths[0], path);
        let says = match variant.method {
            MethodName::Emd => "differ significantly",
            _ => "turned at the touch, with MD from the end of the contact on",
        };
        let ours = format!(
            "up to {} l during the contact, {} l after it; leave {:.2}° from MD's direction",
            significant(during, 2),
            significant(after, 2),
            angle(&paths[0], path)
        );
        notes.push(Note::new(format!("{} against MD", variant.name), says, ours));
    }
    notes
}

/// The largest distances from MD in units of l, during the contact and after it.
fn distances(md: &[[Placed; 2]], path: &[[Placed; 2]]) -> [f64; 2] {
    let off = |k: usize| {
        let one = |grain: usize| {
            let [a, b] = [md, path].map(|path| path[k][grain].position);
            (a[0] - b[0]).hypot(a[1] - b[1]) / CONTACT_DISTANCE
        };
        one(0).max(one(1))
    };
    let [touch, end] = [TOUCH, TOUCH + DOTS].map(|sample| (sample * FINE) as usize);
    let most = |steps: std::ops::Range<usize>| steps.map(off).fold(0.0, f64::max);
    [most(touch..end), most(end..md.len())]
}

/// Between the relative velocities at the end, in degrees.
fn angle(md: &[[Placed; 2]], path: &[[Placed; 2]]) -> f64 {
    let relative = |path: &[[Placed; 2]]| {
        let [a, b] = path[path.len() - 1];
        [a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]]
    };
    let ([ax, ay], [bx, by]) = (relative(md), relative(path));
    libm::atan2(ax * by - ay * bx, ax * bx + ay * by).abs().to_degrees()
}
