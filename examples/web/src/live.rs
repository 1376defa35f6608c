//! How does a running world look from outside? Reads a world; writes what JavaScript sees.

use crate::plan::{D, MAX_GRAINS};
use crate::rule::{Chosen, INTEGRATED};
use carom::World;
use carom::world::Statistics;
use core::sync::atomic::Ordering;

/// The names of [`Shown::statistics`], in their order.
pub const COUNTERS: &str = "collisions,planeCollisions,releases,rotationRefused,interrupted,putOff,\
clamped,hardSphere,rests,takeOffs,withinTc,collapses,supported_collisions,reordered,stale,cell_crossings,epochs,integrated";

/// What JavaScript reads in place.
pub struct Shown {
    /// `D` numbers for each grain.
    pub positions: [f64; D * MAX_GRAINS],
    /// `D` numbers for each grain.
    pub velocities: [f64; D * MAX_GRAINS],
    /// For each grain 0: in flight, 1: in a lasting contact, 2: at rest.
    pub states: [u8; MAX_GRAINS],
    /// How often everything happened.
    pub statistics: [f64; 18],
    /// The present; before when nothing happens (infinite if nothing ever will); kinetic energy.
    pub clock: [f64; 3],
}

impl Shown {
    /// Nothing yet.
    pub const fn new() -> Self {
        Self {
            positions: [0.0; D * MAX_GRAINS],
            velocities: [0.0; D * MAX_GRAINS],
            states: [0; MAX_GRAINS],
            statistics: [0.0; 18],
            clock: [0.0; 3],
        }
    }
}

impl Shown {
    /// Writes what can be seen.
    pub fn write(&mut self, world: &World<'_, f64, D, Chosen>) {
        let view = world.view();
        let places = self.positions.chunks_exact_mut(D).zip(self.velocities.chunks_exact_mut(D));
        for (i, ((position, velocity), state)) in places.zip(&mut self.states).enumerate() {
            let Some(grain) = view.grain(i) else { break };
            position.copy_from_slice(grain.position.as_slice());
            velocity.copy_from_slice(grain.velocity.as_slice());
            *state = if view.is_at_rest(i) { 2 } else { u8::from(view.contact(i).is_some()) };
        }
        self.statistics = numbers(world.statistics());
        let next = world.next_event_time().map_or(f64::INFINITY, |next| next.as_f64());
        self.clock = [world.now().as_f64(), next, view.kinetic_energy()];
    }
}

fn numbers(c: &Statistics) -> [f64; 18] {
    let integrated = INTEGRATED.load(Ordering::Relaxed);
    [
        c.collisions,
        c.plane_collisions,
        c.releases,
        c.rotation_refused,
        c.interrupted,
        c.deferred,
        c.clamped,
        c.hard_sphere,
        c.rests,
        c.take_offs,
        c.within_tc,
        c.collapses,
        c.supported_collisions,
        c.reordered,
        c.stale,
        c.cell_crossings,
        c.epochs,
        integrated,
    ]
    .map(|count| count as f64)
}
