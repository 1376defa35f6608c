//! What are pressure and self-diffusion of an elastic gas of soft spheres? Runs it by eMD, eMD* or MD; writes both.

use super::gas::{POISSON, RADIUS, SPEED, SoftGas, mass};
use crate::figure::hard::pressure;
use anyhow::Result;
use carom::HeapMemory;
use carom::law::{Central, Rule};
use carom::world::Event;
use carom::world::{EventKind, EventOutcome};
use carom::{Enduring, Observer, View, World};
use carom_reference::{Boundary, End, ForceLaw, Grain, System, Verlet, VerletOptions};
use std::f64::consts::PI;

/// How contacts are dealt with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// As instantaneous collisions.
    Emd,
    /// With the matrix of restitution.
    EmdStar,
    /// By the force, velocity Verlet.
    Md,
}

impl Variant {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Emd, Self::EmdStar, Self::Md];

    /// As the figures call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Emd => "eMD",
            Self::EmdStar => "eMD*",
            Self::Md => "MD",
        }
    }
}

/// How long a gas runs, in mean free times of hard spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Before measuring.
    pub settle: f64,
    /// While measuring.
    pub measure: f64,
    /// Steps of MD per contact.
    pub steps: f64,
}

/// Samples of the positions in a mean free time.
const SAMPLES: usize = 2;
/// Between these ages, in mean free times, the spread of the grains is taken to grow steadily.
const AGES: [usize; 2] = [6, 16];

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// D (m²/s).
    pub diffusion: f64,
    /// P V/(2 E/3) with the energy E of the gas: P V/(N k T) where no energy is in contacts.
    pub pressure: f64,
    /// Exceptions of eMD*, of both kinds, per collision.
    pub exceptions: f64,
}

/// Mean free time of hard spheres with this packing fraction, and Enskog's coefficient of
/// self-diffusion in the first Sonine approximation times 1.019 (Chapman and Cowling's fourth).
pub fn enskog(packing: f64) -> [f64; 2] {
    let density = 6.0 * packing / PI;
    let z = pressure::carnahan_starling(packing);
    let chi = (z - 1.0) / (4.0 * packing);
    let free = pressure::mean_free_time(density, z) * 2.0 * RADIUS / SPEED;
    let diffusion = 1.019 * 3.0 / 8.0 / (density * chi * PI.sqrt()) * 2.0 * RADIUS * SPEED;
    [free, diffusion]
}

/// Times at which a gas is sampled.
struct Clock {
    settle: f64,
    /// Between two points, in none of which a grain flies through half the box.
    spacing: f64,
    points: usize,
    samples: usize,
}

impl Clock {
    fn new(gas: &SoftGas, effort: Effort) -> Self {
        let [free, _] = enskog(gas.packing);
        let interval = free / SAMPLES as f64;
        let points = (interval * 16.0 * SPEED / gas.edge()).ceil().max(1.0);
        let samples = (effort.measure * SAMPLES as f64) as usize;
        let [settle, spacing] = [effort.settle * free, interval / points];
        Self { settle, spacing, points: points as usize, samples }
    }

    /// Runs through all points; `advance` goes to a time and returns where the grains are then.
    fn run(
        &self,
        edge: f64,
        mut advance: impl FnMut(f64) -> Result<Vec<[f64; 3]>>,
    ) -> Result<Tracks> {
        let mut tracks = Tracks::new(edge, advance(self.settle)?);
        for point in 1..=self.samples * self.points {
            tracks.follow(advance(self.settle + point as f64 * self.spacing)?);
            if point % self.points == 0 {
                tracks.keep();
            }
        }
        Ok(tracks)
    }

    fn measured(&self) -> f64 {
        (self.samples * self.points) as f64 * self.spacing
    }

    fn diffusion(&self, tracks: &Tracks) -> f64 {
        tracks.diffusion(AGES.map(|age| age * SAMPLES), self.points as f64 * self.spacing)
    }
}

/// Measures an elastic gas.
///
/// # Errors
/// An error of the engine or the reference.
pub fn measure(gas: &SoftGas, variant: Variant, effort: Effort) -> Result<Measured> {
    let gas = SoftGas { dissipation: 0.0, ..*gas };
    match variant {
        Variant::Emd => by_events(&gas, Central(gas.rule()), effort),
        Variant::EmdStar => by_events(&gas, gas.rule(), effort),
        Variant::Md => by_force(&gas, effort),
    }
}

fn by_events(gas: &SoftGas, rule: impl Rule<f64>, effort: Effort) -> Result<Measured> {
    let (half, clock) = (0.5 * gas.edge(), Clock::new(gas, effort));
    let mut storage = HeapMemory::<f64, 3>::with_capacity(gas.grains);
    let builder = World::builder(&mut storage)
        .enduring(Enduring::Paper)
        .periodic([[-half, half]; 3])
        .rule(rule);
    let mut world = builder.grains(gas.start()?)?.start()?;
    let energy = world.view().kinetic_energy();
    let mut flux = Flux::default();
    let tracks = clock.run(gas.edge(), |t| {
        if t <= clock.settle {
            world.advance_to(t)?;
        } else {
            world.advance_observed(t, &mut flux)?;
        }
        let view = world.view();
        let all = (0..view.len()).filter_map(|i| view.grain(i));
        Ok(all.map(|grain| grain.position.into()).collect())
    })?;
    let statistics = world.statistics();
    let exceptions = (statistics.rotation_refused + statistics.interrupted) as f64;
    Ok(Measured {
        diffusion: clock.diffusion(&tracks),
        pressure: 1.0 + flux.sum() / (2.0 * energy * clock.measured()),
        exceptions: exceptions / statistics.collisions.max(1) as f64,
    })
}

fn by_force(gas: &SoftGas, effort: Effort) -> Result<Measured> {
    let (half, clock) = (0.5 * gas.edge(), Clock::new(gas, effort));
    let soft = |grain: &carom::Grain<f64, 3>| Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: grain.position.into(),
        velocity: grain.velocity.into(),
    };
    let grains: Vec<Grain<3>> = gas.start()?.iter().map(soft).collect();
    let energy = kinetic(grains.iter().map(|grain| grain.velocity));
    let system = System::new(grains, [Boundary::Periodic { lo: -half, hi: half }; 3], [0.0; 3])?;
    let law = ForceLaw::Viscoelastic { young: gas.young, poisson: POISSON, dissipation: 0.0 };
    let options = VerletOptions { steps_per_contact: effort.steps, ..VerletOptions::default() };
    let mut run = Verlet::new(&system, law, End::Force, options)?;
    let (mut moving, mut before) = (0.0, 0.0);
    let tracks = clock.run(gas.edge(), |t| {
        run.advance_to(t)?;
        if t <= clock.settle {
            before = run.virial();
        } else {
            moving += clock.spacing * kinetic((0..gas.grains).map(|i| run.velocity(i)));
        }
        Ok((0..gas.grains).map(|i| run.position(i)).collect())
    })?;
    Ok(Measured {
        diffusion: clock.diffusion(&tracks),
        pressure: (2.0 * moving + run.virial() - before) / (2.0 * energy * clock.measured()),
        exceptions: 0.0,
    })
}

fn kinetic(velocities: impl Iterator<Item = [f64; 3]>) -> f64 {
    velocities.flatten().map(|v| 0.5 * mass() * v * v).sum()
}

/// Sums what the contacts of an elastic gas add to D P V t.
///
/// D P V t = ∫ (Σ m v² + Σ r·F) dt. For a pair with reduced mass μ that is left alone, the part of its
/// relative motion is d(μ r·v)/dt; so a contact that turns r, v into r', v' adds μ (r'·v' − r·v),
/// whatever its force and duration were, and an instantaneous collision the same. While a contact of eMD*
/// lasts its two grains have the velocity of their centre, which misses μ v'² of Σ m v².
#[derive(Clone, Copy, Debug, Default)]
pub struct Flux {
    sum: f64,
    /// μ r·v of the two that are about to collide.
    before: f64,
    /// μ v'² times what is left of the contacts of the two, in case they are ended now.
    left: f64,
}

impl Flux {
    /// D P V t − 2 E t, with the energy E of the gas, over the time that was measured.
    pub const fn sum(&self) -> f64 {
        self.sum
    }
}

fn reduced(a: f64, b: f64) -> f64 {
    a / (a + b) * b
}

/// μ r·v and μ v² of two grains, as if they were released now.
fn moments<const D: usize>(view: &View<'_, f64, D>, i: usize, k: usize) -> Option<[f64; 2]> {
    let (a, b) = (view.released(i)?, view.released(k)?);
    let (r, v, mu) = (view.separation(i, k)?, a.velocity - b.velocity, reduced(a.mass, b.mass));
    Some([mu * r.dot(&v), mu * v.dot(&v)])
}

/// What is left of the contact of grain i, in μ v'² times time.
fn left<const D: usize>(view: &View<'_, f64, D>, i: usize) -> f64 {
    let of = |(partner, end): (carom::particle::Partner, carom::Instant)| {
        let [_, square] = moments(view, i, partner.as_grain()?)?;
        Some(square * end.since::<f64>(view.now()))
    };
    view.contact(i).and_then(of).unwrap_or(0.0)
}

impl<const D: usize> Observer<f64, D> for Flux {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        let (EventKind::Collision, Some(k)) = (event.kind, event.partner.as_grain()) else {
            return;
        };
        self.before = moments(&view, event.grain, k).map_or(0.0, |[radial, _]| radial);
        self.left = left(&view, event.grain) + left(&view, k);
    }

    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        let (EventKind::Collision, Some(k)) = (event.kind, event.partner.as_grain()) else {
            return;
        };
        let duration = match event.outcome {
            Some(EventOutcome::ContactInterrupted) => {
                self.sum += self.left;
                return;
            }
            Some(EventOutcome::Collision { .. }) => 0.0,
            Some(EventOutcome::ContactBegan(outcome)) => outcome.duration,
            _ => return,
        };
        if let Some([radial, square]) = moments(&view, event.grain, k) {
            self.sum += radial - self.before - square * duration;
        }
    }
}

/// Positions in a periodic box at equal intervals, put together to paths.
#[derive(Clone, Debug)]
struct Tracks {
    edge: f64,
    /// Where each grain is, not wrapped.
    now: Vec<[f64; 3]>,
    kept: Vec<Vec<[f64; 3]>>,
}

impl Tracks {
    /// Begins here.
    pub fn new(edge: f64, start: Vec<[f64; 3]>) -> Self {
        Self { edge, now: start, kept: Vec::new() }
    }

    /// Follows the grains to where they are now; none may have flown half the box since.
    pub fn follow(&mut self, positions: impl IntoIterator<Item = [f64; 3]>) {
        for (at, new) in self.now.iter_mut().zip(positions) {
            for (x, new) in at.iter_mut().zip(new) {
                let step = new - *x;
                *x += step - self.edge * (step / self.edge).round();
            }
        }
    }

    /// Keeps where the grains are.
    pub fn keep(&mut self) {
        self.kept.push(self.now.clone());
    }

    /// The mean square displacement over so many of the intervals, over all grains and beginnings.
    pub fn spread(&self, intervals: usize) -> f64 {
        let pairs = self.kept.iter().zip(self.kept.iter().skip(intervals));
        let square = |(a, b): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>()
        };
        let of = |(early, late): (&Vec<[f64; 3]>, &Vec<[f64; 3]>)| {
            early.iter().zip(late).map(square).sum::<f64>()
        };
        let beginnings = self.kept.len().saturating_sub(intervals).max(1);
        pairs.map(of).sum::<f64>() / (beginnings * self.now.len()) as f64
    }

    /// The coefficient of self-diffusion from how the spread grows between two ages, in intervals of
    /// this length: Einstein's relation after the memory of the velocities is gone.
    pub fn diffusion(&self, [young, old]: [usize; 2], interval: f64) -> f64 {
        (self.spread(old) - self.spread(young)) / (6.0 * (old - young) as f64 * interval)
    }
}

#[cfg(test)]
mod tests {
    use super::Tracks;

    /// Two grains that fly apart at speed 1 through a box of 2, looked at every 0.25.
    #[test]
    fn paths_go_on_through_the_faces_of_the_box() {
        let mut tracks = Tracks::new(2.0, vec![[0.0; 3]; 2]);
        for k in 0..40 {
            let x = 0.25 * f64::from(k);
            let wrapped = |x: f64| x - 2.0 * (x / 2.0).round();
            tracks.follow([[wrapped(x), 0.0, 0.0], [wrapped(-x), 0.0, 0.0]]);
            tracks.keep();
        }
        assert!((tracks.spread(8) - 4.0).abs() < 1e-12);
        // (8² − 4²) 0.25² = 3 over 6 · 4 · 0.25.
        assert!((tracks.diffusion([4, 8], 0.25) - 0.5).abs() < 1e-12);
    }
}
