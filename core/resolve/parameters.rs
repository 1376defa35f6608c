//! What was a world told of contacts, or has learned of them? Reads and writes nothing.

use crate::cluster::Settings;
use crate::scalar::{Scalar, Vector};

/// How a contact ends for its two grains when a third body interrupts it (MP13 §VI.B.5, exception b).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Release {
    /// Both grains are released at once: angular momentum is kept. MP13 names it as possible.
    #[default]
    Paired,
    /// Only the one that is hit is released, as in MP13's own algorithm; its partner goes on until the contact's
    /// own end, where other grains hit it as well.
    Independent,
}

/// What a world was told of contacts, and the one thing that it learns of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameters<S: Scalar, const D: usize> {
    /// The TC rule's contact duration t_c; 0 without the rule.
    pub t_c: S,
    /// Shorter hops on other grains are none: follows from gravity, see [`super::support::min_hop_time`].
    pub min_hop_time: S,
    /// How an interrupted contact ends.
    pub release: Release,
    /// Whether a slow collision that would have lost energy was made elastic: hops on planes may end then.
    pub lossy_hops: bool,
    /// What becomes of contacts that last or crowd.
    pub settings: Settings<S>,
    /// The gravity under which sleeping grains fell asleep.
    pub settled_gravity: Vector<S, D>,
}
