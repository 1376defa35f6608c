//! How does a heap come to rest? Drops soft disks into a box; writes their kinetic energy against time, by the engine's default and by MD.
//!
//! Both start alike and have the same force law. A heap is chaotic, so after some contacts the two are different
//! heaps, and only what many boxes have in common can be compared.

use super::data::{Figure, Made, Note, Options, Series};
use super::draw::{self, Kind, Mark, PlotStyle, Scale};
use super::fit;
use super::number::significant;
use crate::any_rule::smooth;
use crate::integrated::Integrated;
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom::law::LinearDashpot;
use carom::space::{Plane, Surface};
use carom::{HeapMemory, World};
use carom_reference::{Boundary, End, ForceLaw, Plate, System, Verlet, VerletOptions};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const RADIUS: f64 = 5e-3;
const MASS: f64 = 1e-3;
const GRAVITY: f64 = 9.81;
/// k and γ: a contact of two lasts 1 ms, ε = 0.53. The lowest of ten is pressed by 0.4 % of R.
const STIFFNESS: f64 = 5_000.0;
const DAMPING: f64 = 0.7;
/// Of the places at the start, in radii: across and upwards.
const SPACING: [f64; 2] = [2.46, 2.6];
/// Times at which energies are taken (s).
const SAMPLE: f64 = 0.01;
const SAMPLES: usize = 400;
/// Steps a contact of MD.
const STEPS: f64 = 50.0;
/// Boxes of the figure.
const BOXES: u64 = 6;

/// Disks that fall into a box.
///
/// # Units
/// SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heap {
    /// Beside each other at the start; the box is little wider than that.
    pub across: usize,
    /// Above each other at the start.
    pub rows: usize,
    /// Of places and velocities.
    pub seed: u64,
}

/// What a heap does.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// Kinetic energies in units of m g R, from 0 in steps of 10 ms.
    pub energies: Vec<f64>,
    /// Mean heights of the centres in units of R, at the same times.
    pub heights: Vec<f64>,
    /// The first of these times (s) at which nothing will ever happen any more; MD has none.
    pub asleep: Option<f64>,
}

/// A place and a velocity.
type Start = [[f64; 2]; 2];

impl Heap {
    fn starts(&self) -> Vec<Start> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let [dx, dy] = SPACING.map(|x| x * RADIUS);
        let mut draw = |most: f64| std::array::from_fn(|_| rng.random_range(-most..most));
        let mut one = |k: usize| {
            let (column, row) = (k % self.across, k / self.across);
            let [x, y]: [f64; 2] = draw(0.2 * RADIUS);
            let at = [(column as f64 + 0.5) * dx + x, (row as f64 + 0.6) * dy + y];
            [at, draw(0.3)]
        };
        (0..self.across * self.rows).map(&mut one).collect()
    }

    fn width(&self) -> f64 {
        self.across as f64 * SPACING[0] * RADIUS
    }

    /// By the engine's default.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn by_clusters(&self, samples: usize) -> Result<Course> {
        let starts = self.starts();
        let mut storage = HeapMemory::<f64, 2>::with_capacity(starts.len());
        let law = LinearDashpot { stiffness: STIFFNESS, damping: DAMPING };
        let disk = |[at, v]: &Start| carom::Grain::with_mass(RADIUS, MASS).at(*at).moving(*v);
        let mut world = World::builder(&mut storage)
            .plane(Plane::new([1.0, 0.0], 0.0, Surface::Rule))
            .plane(Plane::new([-1.0, 0.0], -self.width(), Surface::Rule))
            .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
            .gravity([0.0, -GRAVITY])
            .rule(smooth(Integrated::new(law)))
            .grains(starts.iter().map(disk))?
            .start()?;
        let mut course = Course::default();
        for k in 0..=samples {
            let t = SAMPLE * k as f64;
            world.advance_to(t)?;
            let view = world.view();
            let height = |i: usize| view.grain(i).map(|grain| grain.position[1]);
            let all: Option<Vec<f64>> = (0..view.len()).map(height).collect();
            course.push(view.kinetic_energy(), &all.context("a disk")?);
            if course.asleep.is_none() && world.next_event_time().is_none() {
                course.asleep = Some(t);
            }
        }
        Ok(course)
    }

    /// By velocity Verlet in so many steps a contact.
    ///
    /// # Errors
    /// As [`Verlet::advance_to`].
    pub fn by_md(&self, samples: usize, steps: f64) -> Result<Course> {
        let disk = |[position, velocity]: Start| carom_reference::Grain {
            radius: RADIUS,
            mass: MASS,
            position,
            velocity,
        };
        let grains = self.starts().into_iter().map(disk).collect();
        let walls = Boundary::Walls { lo: 0.0, hi: self.width() };
        let floor = Boundary::Plate(Plate::fixed(0.0));
        let system = System::new(grains, [walls, floor], [0.0, -GRAVITY])?;
        let law = ForceLaw::LinearDashpot { stiffness: STIFFNESS, damping: DAMPING };
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut run = Verlet::new(&system, law, End::Force, options)?;
        let mut course = Course::default();
        for k in 0..=samples {
            run.advance_to(SAMPLE * k as f64)?;
            let grains = run.grains();
            let square = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
            let energy = grains.iter().map(|grain| 0.5 * MASS * square(grain.velocity)).sum();
            let heights: Vec<f64> = grains.iter().map(|grain| grain.position[1]).collect();
            course.push(energy, &heights);
        }
        Ok(course)
    }
}

impl Course {
    fn push(&mut self, energy: f64, heights: &[f64]) {
        self.energies.push(energy / (MASS * GRAVITY * RADIUS));
        self.heights.push(heights.iter().sum::<f64>() / (heights.len() as f64 * RADIUS));
    }

    /// Energies against time, without those that are zero.
    fn series(&self, name: &str, method: &str) -> Series {
        let mut series = Series::new(name).param("method", method);
        let points = self.energies.iter().enumerate().filter(|(_, energy)| **energy > 0.0);
        points.for_each(|(k, energy)| series.push(SAMPLE * k as f64, *energy));
        series
    }
}

/// The mean energies of many.
fn mean(all: &[Course]) -> Course {
    let count = all.len().max(1) as f64;
    let at = |k: usize| all.iter().map(|course| course.energies[k]).sum::<f64>() / count;
    Course { energies: (0..=SAMPLES).map(at).collect(), ..Course::default() }
}

/// Makes the figure.
///
/// # Errors
/// An error of a method.
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("rest", 2 * BOXES);
    let one = |k: u64| -> Result<Course> {
        let heap = Heap { across: 10, rows: 10, seed: 1 + k / 2 };
        let course = match k % 2 {
            0 => heap.by_clusters(SAMPLES)?,
            _ => heap.by_md(SAMPLES, STEPS)?,
        };
        progress.add(1);
        Ok(course)
    };
    let all: Vec<Course> = (0..2 * BOXES).into_par_iter().map(one).collect::<Result<_>>()?;
    let (ours, md): (Vec<Course>, Vec<Course>) =
        all.chunks_exact(2).map(|two| (two[0].clone(), two[1].clone())).unzip();
    let figure = Figure::new("rest", ["t (s)", "kinetic energy/(m g R)"])
        .with(md[0].series("MD, box 1", "MD"))
        .with(ours[0].series("clusters, box 1", "clusters"))
        .with(mean(&md).series("MD, mean of all", "MD, mean"))
        .with(mean(&ours).series("clusters, mean of all", "clusters, mean"));
    let picture = picture(&figure, ours[0].asleep);
    Ok(Made { figure, picture, notes: notes(&ours, &md) })
}

fn picture(figure: &Figure, asleep: Option<f64>) -> Scene {
    let style = PlotStyle::new("100 soft disks fall into a box and come to rest")
        .labels("*t* [s]", "kinetic energy / *m g R*")
        .scales(Scale::LINEAR.from(0.0, SAMPLE * SAMPLES as f64), Scale::LOG.from(1e-11, 1e3))
        .kinds(&[Kind::Line]);
    let style = match asleep {
        Some(t) => style.mark(Mark::Place(t, "box 1 is asleep".to_owned())),
        None => style,
    };
    draw::draw(figure, &style)
}

fn notes(ours: &[Course], md: &[Course]) -> Vec<Note> {
    let unit = (RADIUS / GRAVITY).sqrt();
    let mut notes = Vec::new();
    for (k, (one, other)) in ours.iter().zip(md).enumerate() {
        let says = match one.asleep {
            Some(t) => {
                let then = other.energies[(t / SAMPLE).round() as usize];
                format!(
                    "after {t:.2} s = {:.0} (R/g)^½; MD has {} m g R then",
                    t / unit,
                    significant(then, 2)
                )
            }
            None => "not within 4 s".to_owned(),
        };
        notes.push(Note::new(format!("box {}: asleep", k + 1), "not given", says));
    }
    let last = |course: &Course| course.heights.last().copied().unwrap_or(f64::NAN);
    let height = |all: &[Course]| fit::mean(&all.iter().map(last).collect::<Vec<_>>());
    let both = [height(ours), height(md)].map(|[y, e]| format!("{y:.3} ± {e:.3} R"));
    let heights = format!("clusters {}, MD {}", both[0], both[1]);
    notes.push(Note::new("height of the centre of mass after 4 s", "not given", heights));
    for t in [0.05, 0.1, 0.2, 0.5] {
        let at = |all: &[Course]| mean(all).energies[(t / SAMPLE).round() as usize];
        let [a, b] = [at(ours), at(md)].map(|energy| significant(energy, 3));
        let what = format!("mean kinetic energy at {t} s");
        notes.push(Note::new(what, "not given", format!("clusters {a}, MD {b} m g R")));
    }
    notes
}
