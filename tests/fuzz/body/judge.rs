//! Does the world keep its promises? Reads a world after each event; writes nothing, panics if it does not.

use super::draw::Draw;
use super::play::Any;
use carom::world::Happening;
use carom::{Fault, Instant, Scalar};

/// What was true before.
pub struct Judge {
    /// Steps taken.
    pub steps: u32,
    now: Instant,
    gain: f64,
    gravity: bool,
    energy: f64,
    collisions: u64,
}

impl Judge {
    pub fn new<S: Scalar, const D: usize>(world: &Any<'_, '_, S, D>, gain: f64) -> Self {
        let energy = world.view().kinetic_energy().to_f64();
        let gravity = world.view().gravity().iter().any(|&g| g != S::zero());
        Self { steps: 0, now: world.now(), gain, gravity, energy, collisions: 0 }
    }

    /// From now on energy is not kept.
    pub const fn saw_gravity(&mut self) {
        self.gravity = true;
    }

    /// Time never goes back.
    pub fn clock(&mut self, now: Instant) {
        assert!(now >= self.now, "time went back from {} to {now}", self.now);
        self.now = now;
    }

    /// A fault must be one that the input explains.
    pub fn look<T>(&self, result: Result<T, Fault>, draw: &Draw<'_>) -> Result<T, Fault> {
        if let Err(fault @ (Fault::NotFinite { .. } | Fault::BadRule { .. })) = &result {
            assert!(!draw.tame, "tame numbers, and yet: {fault}");
        }
        result
    }

    /// What an event touched can still be computed with, and did not happen before.
    pub fn happened<S: Scalar, const D: usize>(
        &self,
        world: &Any<'_, '_, S, D>,
        happening: &Happening<S>,
        draw: &Draw<'_>,
    ) {
        let count = world.view().len();
        assert!(happening.grain < count, "grain {} of {count}", happening.grain);
        if draw.tame {
            let grain = world.grain(happening.grain).unwrap();
            let numbers = grain.position.iter().chain(grain.velocity.iter());
            assert!(numbers.copied().all(S::is_number), "{grain:?}");
        }
    }

    /// Every grain is somewhere, in front of the walls, and no faster than the input explains.
    pub fn inspect<S: Scalar, const D: usize>(
        &mut self,
        world: &Any<'_, '_, S, D>,
        draw: &Draw<'_>,
    ) {
        self.clock(world.now());
        if !draw.tame {
            return;
        }
        self.walls(world);
        self.energies(world);
    }

    /// No centre is behind a plane: the contact law keeps a grain at a distance above 0.
    fn walls<S: Scalar, const D: usize>(&self, world: &Any<'_, '_, S, D>) {
        let view = world.view();
        for (i, grain) in (0..view.len()).filter_map(|i| Some((i, view.grain(i)?))) {
            let size = grain.position.iter().fold(S::one(), |far, x| far.larger(x.magnitude()));
            let rounding = size.to_f64() * S::RESOLUTION.to_f64() * 1e3;
            for plane in view.boundary().planes() {
                let height = (plane.normal.dot(&grain.position) - plane.offset).to_f64();
                let margin = 1e-3 * grain.radius.to_f64() + rounding;
                assert!(height > -margin, "grain {i} is {height} behind a plane: {grain:?}");
            }
        }
    }

    /// Without gravity, and inside the tables, kinetic energy never grows.
    fn energies<S: Scalar, const D: usize>(&mut self, world: &Any<'_, '_, S, D>) {
        let counters = world.counters();
        let energy = world.view().kinetic_energy().to_f64();
        let collisions = counters.collisions + counters.plane_collisions;
        let more = (collisions - self.collisions) as f64;
        if !self.gravity && counters.clamped == 0 {
            let allowed = self.energy * (1.0 + self.gain).powf(more) + f64::from(f32::MIN_POSITIVE);
            assert!(energy <= allowed, "{more} collisions brought {} to {energy}", self.energy);
        }
        (self.energy, self.collisions) = (energy, collisions);
    }
}
