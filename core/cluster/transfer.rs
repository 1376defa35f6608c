//! What do clustered bodies give each other in a step? What whoever observes is told; reads and writes nothing itself.

use crate::particle::Partner;
use crate::scalar::{Scalar, Vector};

/// What a grain of a cluster and what it touches gave each other in a step, along the line of centres and across it.
///
/// # Units
/// Of the world: momentum, length, energy, speed, time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Transfer<S: Scalar, const D: usize> {
    /// The grain.
    pub grain: usize,
    /// What it touches: another grain, a plane or a facet.
    pub partner: Partner,
    /// The momentum that the grain was given: force times the step.
    pub impulse: Vector<S, D>,
    /// The grain's centre, in the middle of the step.
    pub position: Vector<S, D>,
    /// From the partner's centre, or the nearest point of the plane or facet, to the grain's, at that instant.
    pub separation: Vector<S, D>,
    /// The kinetic energy of grains that went into the contact: what its spring stores, too, and gives back later (negative).
    /// A plane that moves gives some: then less went, or none.
    pub work: S,
    /// How fast the two near each other, if they came to touch in this step.
    pub approach: Option<S>,
}

/// Who is told.
pub(crate) trait Receiver<S: Scalar, const D: usize> {
    /// The two gave each other this.
    fn receive(&mut self, transfer: &Transfer<S, D>);
}
