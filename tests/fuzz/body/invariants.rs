//! Do the invariants hold? Reads a world after each event; writes nothing, panics if they do not.

use super::input::Input;
use super::run::DynWorld;
use carom::space::{Plane, Surface};
use carom::world::Event;
use carom::{Error, Instant, Scalar};

/// The state before, to compare with.
pub struct Invariants {
    /// Steps taken.
    pub steps: u32,
    now: Instant,
    energy_gain: f64,
    /// Gravity or a plate brings energy in.
    driven: bool,
    energy: f64,
    collisions: u64,
}

impl Invariants {
    pub fn new<S: Scalar, const D: usize>(
        world: &DynWorld<'_, '_, S, D>,
        energy_gain: f64,
    ) -> Self {
        let energy = world.view().kinetic_energy().to_f64();
        let view = world.view();
        let gravity = view.gravity().iter().any(|&g| g != S::zero());
        let shaken = view.boundary().planes().iter().any(|plane| plane.vibration.is_some());
        let driven = gravity || shaken;
        Self { steps: 0, now: world.now(), energy_gain, driven, energy, collisions: 0 }
    }

    /// From now on energy is not kept.
    pub const fn gravity_changed(&mut self) {
        self.driven = true;
    }

    /// Time never goes back.
    pub fn check_time(&mut self, now: Instant) {
        assert!(now >= self.now, "time went back from {} to {now}", self.now);
        self.now = now;
    }

    /// An error must be one that the input explains.
    pub fn check_error<T>(&self, result: Result<T, Error>, input: &Input<'_>) -> Result<T, Error> {
        if let Err(error @ (Error::NotFinite { .. } | Error::InvalidOutcome { .. })) = &result {
            assert!(!input.moderate, "moderate numbers, and yet: {error}");
        }
        result
    }

    /// What an event touched can still be computed with, and did not happen before.
    pub fn check_event<S: Scalar, const D: usize>(
        &self,
        world: &DynWorld<'_, '_, S, D>,
        event: &Event<S>,
        input: &Input<'_>,
    ) {
        let count = world.view().len();
        assert!(event.grain < count, "grain {} of {count}", event.grain);
        if input.moderate {
            let grain = world.grain(event.grain).unwrap();
            let numbers = grain.position.iter().chain(grain.velocity.iter());
            assert!(numbers.copied().all(S::is_finite), "{grain:?}");
        }
    }

    /// Every grain is somewhere, in front of the walls, and no faster than the input explains.
    pub fn check_state<S: Scalar, const D: usize>(
        &mut self,
        world: &DynWorld<'_, '_, S, D>,
        input: &Input<'_>,
    ) {
        self.check_time(world.now());
        if !input.moderate {
            return;
        }
        self.check_walls(world);
        self.check_energy(world);
    }

    /// No centre is behind a plane: the contact law keeps a grain at a distance above 0. While it is in
    /// another contact that cannot be ended yet it may sink in by a 64th of its radius.
    fn check_walls<S: Scalar, const D: usize>(&self, world: &DynWorld<'_, '_, S, D>) {
        let view = world.view();
        for (i, grain) in (0..view.len()).filter_map(|i| Some((i, view.grain(i)?))) {
            let size = grain.position.iter().fold(S::one(), |far, x| far.max(x.abs()));
            let rounding = size.to_f64() * S::RESOLUTION.to_f64() * 1e3;
            for plane in view.boundary().planes().iter().filter(|plane| is_checked(plane)) {
                let (place, blur) = place(plane, view.now());
                let height = (plane.normal.dot(&grain.position) - plane.offset).to_f64() - place;
                let margin = (1.0 / 64.0 + 1e-3) * grain.radius.to_f64() + rounding + blur;
                assert!(height > -margin, "grain {i} is {height} behind a plane: {grain:?}");
            }
        }
    }

    /// Without gravity, and inside the tables, kinetic energy never grows.
    fn check_energy<S: Scalar, const D: usize>(&mut self, world: &DynWorld<'_, '_, S, D>) {
        let statistics = world.statistics();
        let energy = world.view().kinetic_energy().to_f64();
        let collisions = statistics.collisions + statistics.plane_collisions;
        let more = (collisions - self.collisions) as f64;
        if !self.driven && statistics.clamped == 0 {
            let allowed =
                self.energy * (1.0 + self.energy_gain).powf(more) + f64::from(f32::MIN_POSITIVE);
            assert!(energy <= allowed, "{more} collisions brought {} to {energy}", self.energy);
        }
        (self.energy, self.collisions) = (energy, collisions);
    }
}

/// Soft contacts with a moving plate take no account of how far it moves meanwhile.
fn is_checked<S: Scalar, const D: usize>(plane: &Plane<S, D>) -> bool {
    plane.vibration.is_none() || plane.surface != Surface::Rule
}

/// Where a plate is, and how well a world of this number type can know it.
fn place<S: Scalar, const D: usize>(plane: &Plane<S, D>, now: Instant) -> (f64, f64) {
    let Some(v) = plane.vibration else { return (0.0, 0.0) };
    let [amplitude, frequency, phase] = [v.amplitude, v.frequency, v.phase].map(|x: S| x.to_f64());
    let turns = frequency * now.as_f64() + phase;
    let blur = amplitude.abs() * S::RESOLUTION.to_f64() * 1e2 * (1.0 + turns);
    (amplitude * (std::f64::consts::TAU * turns).sin(), blur)
}
