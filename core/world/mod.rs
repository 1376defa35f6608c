//! How does a user hold a world? Memory, setup, steps, observation, snapshots; reads and writes everything below.

mod check;
mod clock;
mod digest;
mod memory;
mod saved;
mod setup;
mod step;
mod watch;

pub use memory::{Lend, Memory, Room};
pub use saved::Saved;
pub use setup::{NoRule, Setup};
pub use watch::{Happening, View, Watch};

use crate::event::queue::Queue;
use crate::event::scene::Scene;
use crate::number::{Instant, Scalar};

/// Grains, what they are about to do, and the rule they obey.
///
/// A world borrows its memory: a [`Memory`] of fixed size on a microcontroller, vectors on a host.
/// It allocates nothing. The work per event is O(log N) with cells, O(N) without (few grains), and
/// once every few events per grain O(N) for the clocks.
///
/// Time is kept as an [`crate::Instant`] plus a small scalar, which is set back to almost zero every
/// few events per grain ([`Scalar::EVENTS_PER_EPOCH`]): precision does not depend on how long it has run,
/// only on how long nothing happened.
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere};
/// let mut memory = Memory::<f64, 1, 2>::new();
/// let mut world = World::setup(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.5, 1.0).moving([1.0]))?
///     .grain(Grain::with_mass(0.5, 1.0).at([3.0]))?
///     .start()?;
/// world.advance_to(3.0)?;
/// assert_eq!(world.grain(0).unwrap().position[0], 2.0);
/// assert_eq!(world.grain(1).unwrap().velocity[0], 1.0);
/// # Ok::<(), carom::Fault>(())
/// ```
pub struct World<'m, S: Scalar, const D: usize, R> {
    pub(crate) scene: Scene<'m, S, D>,
    pub(crate) queue: Queue<'m, S>,
    pub(crate) rule: R,
    /// Events since the clock was set back.
    pub(crate) since_epoch: u32,
    pub(crate) wanders: u32,
    /// Events since the mark.
    pub(crate) at_once: u32,
    /// The last instant at which time had visibly moved on.
    pub(crate) mark: Instant,
}
