//! What is a world? Everything that an event may read or change; reads and writes nothing itself.

use super::statistics::Statistics;
use crate::cluster::Clusters;
use crate::resolve::Parameters;
use crate::scalar::{Clock, Scalar};
use crate::schedule::EventQueue;
use crate::space::{Domain, Particles};

/// Grains, what they are about to do, and the rule they obey.
///
/// A world borrows its memory: a [`crate::Memory`] of fixed size on a microcontroller, vectors on a host.
/// It allocates nothing. The work per event is O(log N) with cells, O(N) without (few grains), and
/// once every few events per grain O(N) for the clocks.
///
/// Time is kept as an [`crate::Instant`] plus a small scalar, which is set back to almost zero every
/// few events per grain ([`crate::scalar::Timekeeping::EVENTS_PER_EPOCH`]): precision does not depend on how long it has run,
/// only on how long nothing happened.
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere};
/// let mut memory = Memory::<f64, 1, 2>::new();
/// let mut world = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.5, 1.0).moving([1.0]))?
///     .grain(Grain::with_mass(0.5, 1.0).at([3.0]))?
///     .start()?;
/// world.advance_to(3.0)?;
/// assert_eq!(world.grain(0).unwrap().position[0], 2.0);
/// assert_eq!(world.grain(1).unwrap().velocity[0], 1.0);
/// # Ok::<(), carom::Error>(())
/// ```
pub struct World<'m, S: Scalar, const D: usize, R> {
    pub(super) particles: Particles<'m, S, D>,
    pub(super) domain: Domain<'m, S, D>,
    pub(super) clock: Clock<S>,
    pub(super) parameters: Parameters<S, D>,
    pub(super) clusters: Clusters<S>,
    pub(super) queue: EventQueue<'m, S>,
    pub(super) rule: R,
    pub(super) statistics: Statistics,
    pub(super) progress: Progress,
}

/// How far time has come on, by the count of events.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Progress {
    /// Events since the clock was set back.
    pub since_epoch: u32,
    /// Events since then that only renewed a prediction.
    pub bookkeeping: u32,
    /// Events since time was last seen to have moved on visibly, and such as only renewed a prediction.
    pub at_once: [u32; 2],
}

impl Progress {
    /// Nothing has happened yet.
    pub const START: Self = Self { since_epoch: 0, bookkeeping: 0, at_once: [0; 2] };
}
