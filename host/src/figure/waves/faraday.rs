//! Are there Faraday waves on a layer of grains? Shakes hard spheres of ε = 0.7; writes the surface in two cycles, its amplitude and wavelength.
//!
//! As Faraday's waves on a liquid these have half of the plate's frequency. Bizon et al. (Phys. Rev. Lett. 80, 57, 1998)
//! found those of the experiment in event-driven runs; Umbanhowar and Swinney (Physica A 288, 344, 2000) measured λ.

use super::modes::Mode;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, PlotStyle, Scale};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom::law::HardSphere;
use carom::space::{Plane, Surface as Material, Vibration};
use carom::{Grain, HeapMemory, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// The filling h, in diameters d: 6 grains on a square of d by d, as Bizon et al. count it.
pub const FILLING: f64 = 5.4;
/// f* = f √(h/g).
pub const FREQUENCY: f64 = 0.4174;
const RESTITUTION: f64 = 0.7;
/// Distance of the places at the start, across and upwards.
const SPACING: [f64; 2] = [1.02, 1.05];
/// How long contacts last that are integrated, in √(d/g), and in how many steps. Grains at rest overlap by
/// (1 + Γ) (0.1/π)² < 0.004 d. By default it is 0.024 and 32: eight times as many steps.
const CONTACT_TIME: f64 = 0.1;
const STEPS: u32 = 16;
/// Instants in each cycle at which the surface is looked at.
const PHASES: usize = 8;
/// Cycles before that, and with it.
const BEFORE: usize = 24;
const CYCLES: usize = 32;
/// Of the surface's places along the box.
const PLACE: f64 = 2.0;

/// λ/h by Umbanhowar and Swinney's fit to their measurements.
pub fn wavelength(frequency: f64) -> f64 {
    1.0 + 1.1 * libm::pow(frequency, -1.32)
}

/// A layer of spheres on a plate z_0(t) = A_0 sin(2π f t), periodic along it.
///
/// # Units
///
/// Diameters d, their mass, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Box length and width.
    pub size: [f64; 2],
    /// Γ = A_0 (2π f)²/g.
    pub agitation: f64,
    /// Of the velocities at the start.
    pub seed: u64,
}

/// Heights over the plate, in places along the box.
pub type Profile = Vec<f64>;

/// What a layer did: its profile in every cycle that was looked at, at each phase.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// The mean height of the grains in each place.
    pub means: Vec<[Profile; PHASES]>,
    /// The highest point of the grains in each place.
    pub tops: Vec<[Profile; PHASES]>,
}

impl Layer {
    fn frequency() -> f64 {
        FREQUENCY / FILLING.sqrt()
    }

    fn amplitude(&self) -> f64 {
        self.agitation / (TAU * Self::frequency()).powi(2)
    }

    /// How many grains.
    pub fn grains(&self) -> usize {
        (6.0 * self.size[0] * self.size[1]).round() as usize
    }

    fn start(&self) -> impl Iterator<Item = Grain<f64, 3>> + use<> {
        let across = self.size.map(|size| (size / SPACING[0]).floor() as usize);
        let step = [0, 1].map(|axis| self.size[axis] / across[axis] as f64);
        let mut rng = Pcg64::seed_from_u64(self.seed);
        (0..self.grains()).map(move |k| {
            let (x, y, row) = (k % across[0], k / across[0] % across[1], k / across[0] / across[1]);
            let at = |n: usize, step: f64| (n as f64 + 0.5) * step;
            let height = 0.6 + SPACING[1] * row as f64;
            let velocity = std::array::from_fn(|_| rng.random_range(-0.1..0.1));
            Grain::with_mass(0.5, 1.0).at([at(x, step[0]), at(y, step[1]), height]).moving(velocity)
        })
    }

    /// Shakes it for so many cycles and looks at it in those from `before` on.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn run(&self, [before, cycles]: [usize; 2]) -> Result<Course> {
        let mut storage = HeapMemory::<f64, 3>::with_capacity(self.grains());
        let plate = Plane::new([0.0, 0.0, 1.0], 0.0, Material::Hard(RESTITUTION))
            .vibrating(Vibration::new(self.amplitude(), Self::frequency()));
        let mut world = World::builder(&mut storage)
            .periodic_axis(0, [0.0, self.size[0]])
            .periodic_axis(1, [0.0, self.size[1]])
            .plane(plate)
            .gravity([0.0, 0.0, -1.0])
            .contact_time(CONTACT_TIME)
            .steps_per_contact(STEPS)
            .rule(HardSphere { restitution: RESTITUTION })
            .grains(self.start())?
            .start()?;
        let mut course = Course::default();
        for cycle in before..cycles {
            let [mut means, mut tops]: [[Profile; PHASES]; 2] = Default::default();
            for phase in 0..PHASES {
                let turns = cycle as f64 + phase as f64 / PHASES as f64;
                world.advance_to(turns / Self::frequency())?;
                let plate = self.amplitude() * libm::sin(TAU * turns);
                let view = world.view();
                let all = (0..view.len()).map(|i| view.grain(i).map(|grain| grain.position));
                let heights = all.flatten().map(|at| [at[0], at[2] - plate]);
                [means[phase], tops[phase]] = self.profiles(heights);
            }
            course.means.push(means);
            course.tops.push(tops);
        }
        Ok(course)
    }

    /// Mean height and highest point of the grains in each place, from their places and heights.
    fn profiles(&self, grains: impl Iterator<Item = [f64; 2]>) -> [Profile; 2] {
        let places = (self.size[0] / PLACE).round() as usize;
        let mut sums = vec![[0.0_f64; 2]; places];
        let mut tops = vec![0.0_f64; places];
        for [x, z] in grains {
            let k = (x / self.size[0]).rem_euclid(1.0) * places as f64;
            let k = (k as usize).min(places - 1);
            sums[k] = [sums[k][0] + z, sums[k][1] + 1.0];
            tops[k] = tops[k].max(z + 0.5);
        }
        [sums.into_iter().map(|[sum, count]| sum / count.max(1.0)).collect(), tops]
    }
}

/// What a layer's profile does.
#[derive(Clone, Debug)]
pub struct Waves {
    /// The phase at which the waves are highest.
    pub phase: usize,
    /// Wavelengths in the box.
    pub number: usize,
    /// Of the strongest mode at that phase, half of the way from trough to crest, averaged over the cycles, in d.
    pub amplitude: f64,
    /// How alike one cycle's wave and the next one's are, from −1 to 1, on average.
    pub likeness: f64,
}

/// The waves of a layer, from its profiles in one cycle after the other.
pub fn waves(cycles: &[[Profile; PHASES]]) -> Waves {
    let modes = |phase: usize| {
        cycles.iter().map(move |phases| Mode::strongest(&phases[phase])).collect::<Vec<_>>()
    };
    let mean = |all: Vec<f64>| all.iter().sum::<f64>() / all.len() as f64;
    let height = |phase: &usize| mean(modes(*phase).iter().map(Mode::amplitude).collect());
    let phase = (0..PHASES).max_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or(0);
    let numbers: Vec<usize> = modes(phase).iter().map(|mode| mode.number).collect();
    let often = |number: &usize| numbers.iter().filter(|n| *n == number).count();
    let number = numbers.iter().copied().max_by_key(often).unwrap_or(0);
    let all: Vec<Mode> = cycles.iter().map(|phases| Mode::of(&phases[phase], number)).collect();
    let likeness = mean(all.windows(2).map(|two| two[0].likeness(&two[1])).collect());
    Waves { phase, number, amplitude: height(&phase), likeness }
}

/// The layers of the figure: below the onset, above it, and above it in another box. No length is a multiple of
/// the fit's λ, 24.2 d. They are 5 d wide, as cells need at least four along a periodic axis: narrower, and all
/// pairs are neighbours.
pub const LAYERS: [Layer; 3] = [
    Layer { size: [64.0, 5.0], agitation: 2.2, seed: 1 },
    Layer { size: [64.0, 5.0], agitation: 2.5, seed: 1 },
    Layer { size: [84.0, 5.0], agitation: 2.5, seed: 2 },
];

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("faraday", LAYERS.len() as u64);
    let one = |layer: &Layer| {
        let course = layer.run([BEFORE, CYCLES]);
        progress.add(1);
        course
    };
    let courses: Vec<Course> = LAYERS.par_iter().map(one).collect::<Result<_>>()?;
    let mut figure = Figure::new("faraday", ["place along the layer (d)", "mean height (d)"]);
    for (layer, course) in LAYERS.iter().zip(&courses).take(2) {
        for series in layer.curves(course).context("no cycle")? {
            figure = figure.with(series);
        }
    }
    let picture = picture(&figure);
    let notes = LAYERS.iter().zip(&courses).flat_map(|(layer, course)| notes(layer, course));
    let notes = notes.collect();
    Ok(Made { figure, picture, notes })
}

impl Layer {
    /// Its mean heights in the last two cycles, at the phase at which waves are highest.
    fn curves(&self, course: &Course) -> Option<[Series; 2]> {
        let phase = waves(&course.means).phase;
        let last = course.means.len().checked_sub(2)?;
        let curve = |later: usize| {
            let cycle = CYCLES - 2 + later;
            let mut series = Series::new(format!("Γ = {}, cycle {cycle}", self.agitation));
            series = series.param("gamma", self.agitation).param("cycle", cycle as f64);
            let heights = &course.means[last + later][phase];
            for (k, height) in heights.iter().enumerate() {
                series.push((k as f64 + 0.5) * self.size[0] / heights.len() as f64, *height);
            }
            series
        };
        Some([curve(0), curve(1)])
    }
}

fn picture(figure: &Figure) -> Scene {
    let style = PlotStyle::new("A shaken layer of spheres, *h* = 5.4 *d*, *f*∗ = 0.4174")
        .labels("place along the layer / *d*", "mean height of the grains over the plate / *d*")
        .scales(Scale::LINEAR.from(0.0, LAYERS[0].size[0]), Scale::LINEAR)
        .kinds(&[Kind::Both]);
    draw::draw(figure, &style)
}

fn notes(layer: &Layer, course: &Course) -> Vec<Note> {
    let [means, tops] = [waves(&course.means), waves(&course.tops)];
    let [length, width] = layer.size;
    let what = |of: &str| format!("Γ = {}, box {length} d by {width} d: {of}", layer.agitation);
    let sizes = format!("{:.2} d; of the highest grains {:.2} d", means.amplitude, tops.amplitude);
    let is_flat = layer.agitation < 2.3;
    let says = if is_flat { "flat" } else { "stripes" };
    let mut notes = vec![Note::new(what("amplitude"), says, sizes)];
    if !is_flat {
        let expected = wavelength(FREQUENCY);
        let ours = length / means.number as f64 / FILLING;
        let off = 100.0 * (ours / expected - 1.0);
        let says = format!("{expected:.2} h");
        notes.push(Note::new(what("wavelength"), says, format!("{ours:.2} h ({off:+.0} %)")));
        let likeness = format!("{:+.3}", means.likeness);
        notes.push(Note::new(what("one cycle against the next"), "−1 (f/2)", likeness));
    }
    notes
}
