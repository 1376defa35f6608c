//! How does a running world look from outside? Reads a world; writes what JavaScript sees.

use crate::lent::{D, MAX_GRAINS, WorldRule};
use crate::rule::INTEGRATED;
use carom::World;
use carom::world::{Motion, Statistics};
use core::sync::atomic::Ordering;

/// The names of [`ViewBuffers::statistics`], in their order.
pub const STATISTICS: &str = "collisions,planeCollisions,releases,rotationRefused,interrupted,deferred,\
clamped,hardSphere,rests,takeOffs,withinTc,collapses,supportedCollisions,reordered,stale,cellCrossings,\
rechecks,epochs,joins,steps,crushed,integrated";
/// How many there are.
const COUNT: usize = 22;

/// What JavaScript reads in place.
pub struct ViewBuffers {
    /// `D` numbers for each grain.
    pub positions: [f64; D * MAX_GRAINS],
    /// `D` numbers for each grain.
    pub velocities: [f64; D * MAX_GRAINS],
    /// A number for each grain.
    #[cfg(feature = "rough")]
    pub rotations: [f64; MAX_GRAINS],
    /// For each grain 0: in flight, 1: in a contact of two, 2: at rest, 3: in a cluster.
    pub states: [u8; MAX_GRAINS],
    /// How often everything happened.
    pub statistics: [f64; COUNT],
    /// The present; before when nothing happens (infinite if nothing ever will); kinetic energy.
    pub clock: [f64; 3],
}

impl ViewBuffers {
    /// Nothing yet.
    pub const fn new() -> Self {
        Self {
            positions: [0.0; D * MAX_GRAINS],
            velocities: [0.0; D * MAX_GRAINS],
            #[cfg(feature = "rough")]
            rotations: [0.0; MAX_GRAINS],
            states: [0; MAX_GRAINS],
            statistics: [0.0; COUNT],
            clock: [0.0; 3],
        }
    }
}

impl ViewBuffers {
    /// Writes what can be seen.
    pub fn write(&mut self, world: &World<'_, f64, D, WorldRule>) {
        let view = world.view();
        let places = self.positions.chunks_exact_mut(D).zip(self.velocities.chunks_exact_mut(D));
        for (i, ((position, velocity), state)) in places.zip(&mut self.states).enumerate() {
            let Some(grain) = view.grain(i) else { break };
            position.copy_from_slice(grain.position.as_slice());
            velocity.copy_from_slice(grain.velocity.as_slice());
            *state = view.motion(i).map_or(0, number);
        }
        #[cfg(feature = "rough")]
        for (i, rotation) in self.rotations.iter_mut().enumerate() {
            let Some([_, _, z]) = view.angular_velocity(i) else { break };
            *rotation = z;
        }
        self.statistics = numbers(world.statistics());
        let next = world.next_event_time().map_or(f64::INFINITY, |next| next.as_f64());
        self.clock = [world.now().as_f64(), next, view.kinetic_energy()];
    }
}

/// See [`ViewBuffers::states`].
fn number(motion: Motion) -> u8 {
    match motion {
        Motion::Contact => 1,
        Motion::Rest => 2,
        Motion::Cluster => 3,
        _ => 0,
    }
}

fn numbers(c: &Statistics) -> [f64; COUNT] {
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
        c.rechecks,
        c.epochs,
        c.joins,
        c.steps,
        c.crushed,
        integrated,
    ]
    .map(|count| count as f64)
}
