//! Are there Faraday waves on a layer of grains? Shakes hard spheres of ε = 0.7; writes the surface in two cycles, the waves' amplitude and wavelength.
//!
//! As Faraday's waves on a liquid these have half of the plate's frequency. Bizon et al. (Phys. Rev. Lett. 80, 57, 1998)
//! found those of the experiment in event-driven runs; Umbanhowar and Swinney (Physica A 288, 344, 2000) measured λ.
//! They repeat after two cycles and are upside down after one. So their profile is the mean of the layer's profile with
//! alternating sign: what is the same in every cycle cancels, and what is random becomes small.

use super::modes::Mode;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, PlotStyle, Scale};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom::law::HardSphere;
use carom::space::{Plane, Surface as Material, Vibration};
use carom::{Grain, HeapMemory, View, World};
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

/// λ/h by the fit ascribed to Umbanhowar and Swinney, which we have not seen at its source.
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

/// Mean heights of the grains over the plate, in places along the box.
pub type Profile = Vec<f64>;

/// A layer's profile at each phase of a cycle.
pub type Cycle = [Profile; PHASES];

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

    /// Shakes it for so many cycles and returns those from `before` on.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn run(&self, [before, cycles]: [usize; 2]) -> Result<Vec<Cycle>> {
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
        let mut seen = Vec::with_capacity(cycles.saturating_sub(before));
        for cycle in before..cycles {
            let mut profiles = Cycle::default();
            for (phase, profile) in profiles.iter_mut().enumerate() {
                let turns = cycle as f64 + phase as f64 / PHASES as f64;
                world.advance_to(turns / Self::frequency())?;
                *profile = self.profile(&world.view(), self.amplitude() * libm::sin(TAU * turns));
            }
            seen.push(profiles);
        }
        Ok(seen)
    }

    /// Mean height of the grains in each place, over a plate at this height.
    fn profile(&self, view: &View<'_, f64, 3>, plate: f64) -> Profile {
        let places = (self.size[0] / PLACE).round() as usize;
        let mut sums = vec![[0.0_f64; 2]; places];
        let grains = (0..view.len()).filter_map(|i| view.grain(i));
        for at in grains.map(|grain| grain.position) {
            let k = (at[0] / self.size[0]).rem_euclid(1.0) * places as f64;
            let [sum, count] = &mut sums[(k as usize).min(places - 1)];
            *sum += at[2] - plate;
            *count += 1.0;
        }
        sums.into_iter().map(|[sum, count]| sum / count.max(1.0)).collect()
    }
}

/// The waves of a layer.
#[derive(Clone, Debug)]
pub struct Waves {
    /// The phase at which they are highest.
    pub phase: usize,
    /// Wavelengths in the box.
    pub number: usize,
    /// Of the strongest mode of what changes sign in every cycle, from trough to crest, in d.
    pub amplitude: f64,
    /// The same of what changes sign in every second cycle: no waves, only noise.
    pub noise: f64,
    /// Between one cycle's wave and the next one's, from −1 to 1, on average.
    pub correlation: f64,
}

/// Signs of a wave of half the plate's frequency; and of a quarter.
const HALF: [f64; 4] = [1.0, -1.0, 1.0, -1.0];
const QUARTER: [f64; 4] = [1.0, 1.0, -1.0, -1.0];

/// The mean of the profiles at this phase, each with its cycle's sign.
fn signed_mean(cycles: &[Cycle], phase: usize, signs: [f64; 4]) -> Profile {
    let mut mean = vec![0.0; cycles.first().map_or(0, |cycle| cycle[phase].len())];
    for (cycle, sign) in cycles.iter().zip(signs.iter().cycle()) {
        for (sum, height) in mean.iter_mut().zip(&cycle[phase]) {
            *sum += sign * height / cycles.len() as f64;
        }
    }
    mean
}

/// The waves of a layer, from its profiles in one cycle after the other, four or a multiple of that: then whatever is
/// the same in each of them cancels.
pub fn waves(cycles: &[Cycle]) -> Waves {
    let strongest = |phase, signs| Mode::strongest(&signed_mean(cycles, phase, signs));
    let height = |phase, signs| 2.0 * strongest(phase, signs).amplitude();
    let phases = (0..PHASES).map(|phase| (phase, height(phase, HALF)));
    let highest = phases.max_by(|(_, a), (_, b)| a.total_cmp(b));
    let (phase, amplitude) = highest.unwrap_or_default();
    let number = strongest(phase, HALF).number;
    let modes: Vec<Mode> = cycles.iter().map(|cycle| Mode::of(&cycle[phase], number)).collect();
    let pairs = modes.windows(2).map(|two| two[0].correlation(&two[1]));
    let correlation = pairs.sum::<f64>() / (cycles.len() as f64 - 1.0);
    Waves { phase, number, amplitude, noise: height(phase, QUARTER), correlation }
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
        let cycles = layer.run([BEFORE, CYCLES]);
        progress.add(1);
        cycles
    };
    let courses: Vec<Vec<Cycle>> = LAYERS.par_iter().map(one).collect::<Result<_>>()?;
    let mut figure = Figure::new("faraday", ["place along the layer (d)", "mean height (d)"]);
    for (layer, cycles) in LAYERS.iter().zip(&courses).take(2) {
        for series in layer.curves(cycles).context("no cycle")? {
            figure = figure.with(series);
        }
    }
    let picture = picture(&figure);
    let notes =
        LAYERS.iter().zip(&courses).flat_map(|(layer, cycles)| notes(layer, &waves(cycles)));
    let notes = notes.collect();
    Ok(Made { figure, picture, notes })
}

impl Layer {
    /// Its mean heights in the last two cycles, at the phase at which waves are highest.
    fn curves(&self, cycles: &[Cycle]) -> Option<[Series; 2]> {
        let phase = waves(cycles).phase;
        let last = cycles.len().checked_sub(2)?;
        let curve = |later: usize| {
            let cycle = CYCLES - 2 + later;
            let mut series = Series::new(format!("Γ = {}, cycle {cycle}", self.agitation));
            series = series.param("gamma", self.agitation).param("cycle", cycle as f64);
            let heights = &cycles[last + later][phase];
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

fn notes(layer: &Layer, waves: &Waves) -> Vec<Note> {
    let Layer { size: [length, width], agitation, .. } = layer;
    let what = |of: &str| format!("Γ = {agitation}, box {length} d by {width} d: {of}");
    let is_flat = *agitation < 2.3;
    let says = if is_flat { "flat" } else { "stripes" };
    let amplitude = format!("{:.2} d (noise: {:.2} d)", waves.amplitude, waves.noise);
    let correlation = format!("{:+.3}", waves.correlation);
    let mut notes = vec![Note::new(what("amplitude"), says, amplitude)];
    if !is_flat {
        let expected = wavelength(FREQUENCY);
        let ours = length / waves.number as f64 / FILLING;
        let ours = format!("{ours:.2} h ({:+.0} %)", 100.0 * (ours / expected - 1.0));
        notes.push(Note::new(what("wavelength"), format!("{expected:.2} h"), ours));
    }
    let says = if is_flat { "not given" } else { "−1 (f/2)" };
    notes.push(Note::new(what("one cycle against the next"), says, correlation));
    notes
}
