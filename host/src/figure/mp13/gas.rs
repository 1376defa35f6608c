//! Where can eMD* be trusted? Runs MP13's gas of soft spheres; writes how often it makes exceptions (MP13 Sec. VI B 6, Fig. 7).

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Mark, PlotStyle, Scale};
use crate::figure::hard::Fluid;
use crate::plot::{Colour, Scene};
use crate::progress::Progress;
use crate::tables::{Size, embedded};
use anyhow::{Context, Result};
use carom::HeapMemory;
use carom::law::{Outside, Soft, Viscoelastic};
use carom::{Enduring, Grain, Release, Statistics, World};
use carom_tables::read::Law;
use rayon::prelude::*;
use std::f64::consts::{PI, SQRT_2};

/// R.
pub const RADIUS: f64 = 0.1;
const MATERIAL_DENSITY: f64 = 1140.0;
/// ν.
pub const POISSON: f64 = 0.4;
/// Of each component of the velocity: a thermal velocity √(2 kT/m) of 2 m/s.
pub const SPEED: f64 = SQRT_2;
/// Elastic collisions of each grain, as hard spheres, before the gas is made soft.
const EQUILIBRATION: u64 = 4;

/// The paper's gas of viscoelastic spheres in a periodic box.
///
/// # Units
/// SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftGas {
    /// N.
    pub grains: usize,
    /// Packing fraction η (MP13 Eq. 66).
    pub packing: f64,
    /// Young's modulus Y.
    pub young: f64,
    /// Dissipative parameter A.
    pub dissipation: f64,
    /// Of the velocities at the start.
    pub seed: u64,
}

/// What becomes of a contact that a third grain disturbs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// MP13's exceptions as printed: (b) releases only the grain that is hit.
    Printed,
    /// (b) releases both: what `Enduring::Paper` does unless told otherwise, as it keeps angular momentum.
    Paired,
    /// The engine's default: no exceptions; the contact is integrated with whatever else touches.
    Clusters,
}

impl Reading {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Printed, Self::Paired, Self::Clusters];

    /// As the figure calls it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Paired => "paired",
            Self::Clusters => "clusters",
        }
    }

    const fn mode(self) -> (Enduring, Release) {
        match self {
            Self::Printed => (Enduring::Paper, Release::Independent),
            Self::Paired => (Enduring::Paper, Release::Paired),
            Self::Clusters => (Enduring::Integrated, Release::Paired),
        }
    }
}

/// What was counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    /// By the engine.
    pub statistics: Statistics,
    /// The thermal velocity at the end, √(2 kT/m).
    pub thermal_velocity: f64,
}

impl Counted {
    /// Of every thousand collisions, how many were such, with Poisson's error; that of one where none was.
    pub fn per_thousand(&self, exceptions: u64) -> [f64; 2] {
        let thousands = self.statistics.collisions.max(1) as f64 / 1000.0;
        [exceptions as f64 / thousands, (exceptions.max(1) as f64).sqrt() / thousands]
    }
}

/// The mass of a grain.
pub fn mass() -> f64 {
    MATERIAL_DENSITY * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

impl SoftGas {
    fn fluid(&self) -> Fluid {
        let fluid = Fluid::elastic(self.grains, 6.0 * self.packing / PI);
        Fluid { seed: self.seed, ..fluid }
    }

    /// The edge of the box, which is centred at 0.
    pub fn edge(&self) -> f64 {
        2.0 * RADIUS * self.fluid().length::<3>()
    }

    /// The force law.
    pub const fn law(&self) -> Viscoelastic<f64> {
        let Self { young, dissipation, .. } = *self;
        Viscoelastic { young, poisson: POISSON, dissipation }
    }

    /// What grains do by eMD*: the wide table, and hard spheres outside of it.
    pub fn rule(&self) -> Soft<Viscoelastic<f64>> {
        let table = embedded(Size::Wide, Law::Viscoelastic);
        Soft::with_table(self.law(), table, Outside::HardSphere)
    }

    /// Grains in equilibrium, as hard spheres.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn start(&self) -> Result<Vec<Grain<f64, 3>>> {
        let soft = |grain: &Grain<f64, 3>| {
            let (at, v) = (grain.position * (2.0 * RADIUS), grain.velocity * SPEED);
            Grain::with_mass(RADIUS, mass()).at([at[0], at[1], at[2]]).moving([v[0], v[1], v[2]])
        };
        Ok(self.fluid().equilibrium::<3>(EQUILIBRATION)?.iter().map(soft).collect())
    }

    /// Counts the exceptions in so many collisions.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn count(&self, collisions: u64, reading: Reading) -> Result<Counted> {
        let (mode, release) = reading.mode();
        let half = 0.5 * self.edge();
        let mut storage = HeapMemory::<f64, 3>::with_capacity(self.grains);
        let builder = World::builder(&mut storage)
            .enduring(mode)
            .release(release)
            .periodic([[-half, half]; 3])
            .rule(self.rule());
        let mut world = builder.grains(self.start()?)?.start()?;
        while world.statistics().collisions < collisions {
            world.step()?.context("no grain will ever collide")?;
        }
        let energy = world.view().kinetic_energy() / (self.grains as f64 * mass());
        Ok(Counted {
            statistics: *world.statistics(),
            thermal_velocity: (4.0 / 3.0 * energy).sqrt(),
        })
    }
}

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

/// What is counted, of which reading: (a) hardly depends on the reading.
const CURVES: [(Reading, &str); 4] = [
    (Reading::Printed, "a"),
    (Reading::Printed, "b"),
    (Reading::Paired, "b"),
    (Reading::Clusters, "clustered"),
];

/// One gas, by all readings.
struct Point {
    x: f64,
    counted: [Counted; 3],
}

/// Makes the figure: frequencies of both exceptions along both scans, elastic and dissipative.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 300_000 } else { 30_000 };
    let points = (PACKINGS.len() + MODULI.len()) * DISSIPATIONS.len();
    let progress = Progress::new("mp13-7", points as u64);
    let axes = ["packing fraction η, or Y (Pa)", "exceptions per 1000 collisions"];
    let mut figure = Figure::new("mp13-7", axes);
    let mut notes = Vec::new();
    for scan in SCANS {
        for dissipation in DISSIPATIONS {
            let one = |(x, gas): &(f64, SoftGas)| -> Result<Point> {
                let [a, b, c] = Reading::ALL.map(|reading| gas.count(collisions, reading));
                progress.add(1);
                Ok(Point { x: *x, counted: [a?, b?, c?] })
            };
            let points: Vec<Point> =
                gases(scan, dissipation).par_iter().map(one).collect::<Result<_>>()?;
            for curve in CURVES {
                figure = figure.with(series(scan, dissipation, curve, &points));
            }
            notes.extend(points.iter().map(|point| note(scan, dissipation, point)));
        }
    }
    let picture = picture(&figure);
    Ok(Made { figure, picture, notes })
}

fn frequency(what: &str, counted: &Counted) -> [f64; 2] {
    counted.per_thousand(match what {
        "a" => counted.statistics.rotation_refused,
        "b" => counted.statistics.interrupted,
        _ => counted.statistics.joins,
    })
}

fn kind(dissipation: f64) -> &'static str {
    if dissipation == 0.0 { "elastic" } else { "dissipative" }
}

fn series(scan: &str, dissipation: f64, (reading, what): (Reading, &str), all: &[Point]) -> Series {
    let name = match reading {
        Reading::Clusters => "clustered (default)".to_owned(),
        _ => format!("({what}) {}", reading.name()),
    };
    let mut series = Series::new(format!("{name}, {}", kind(dissipation)))
        .param("method", "eMD*")
        .param("reading", reading.name())
        .param("against", scan)
        .param("exception", what)
        .param("dissipation", dissipation);
    for Point { x, counted } in all {
        let [y, error] = frequency(what, &counted[reading as usize]);
        series.push_with_error(*x, y, error);
    }
    series
}

fn note(scan: &str, dissipation: f64, Point { x, counted }: &Point) -> Note {
    let [printed, paired, clusters] = counted;
    let shown = |what: &str, counted: &Counted| {
        let [y, error] = frequency(what, counted);
        format!("{y:.3} ± {error:.3}")
    };
    let ours = format!(
        "printed: (a) {}, (b) {}; paired: (a) {}, (b) {}; clustered {}; {} outside the table; {:.2} m/s at the end",
        shown("a", printed),
        shown("b", printed),
        shown("a", paired),
        shown("b", paired),
        shown("clustered", clusters),
        paired.statistics.hard_sphere,
        paired.thermal_velocity,
    );
    let says = match dissipation == 0.0 && (scan == "young" || *x <= 0.01) {
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
        let style =
            PlotStyle::new(format!("Exceptions of eMD∗, *N* = 10,000, {title} (MP13 Fig. 7)"))
                .labels(label, "*f*_{e} [1/1000]")
                .scales(Scale::LOG.from(range[0], range[1]), Scale::LOG.from(1e-3, 1e3))
                .mark(Mark::Level(1.0, "paper: “about 0.1 %”".to_owned()));
        draw::draw(&part, &PlotStyle { colours: colours(), ..style })
    });
    draw::beside(left, right)
}

/// One colour a curve, paler with dissipation.
fn colours() -> Vec<Colour> {
    let hues = [Colour::BLUE, Colour::EMD, Colour::EMD_STAR, Colour::INK];
    [1.0, 0.4].into_iter().flat_map(|opacity| hues.map(|hue| hue.with_opacity(opacity))).collect()
}
