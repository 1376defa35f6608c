//! How is the rotation of grains saved? Plain data; reads and writes nothing.

use crate::space::ContactState;

/// How the grains of a [`Snapshot`](super::Snapshot) rotate: D (D − 1)/2 numbers for each grain, in slices or in what
/// owns them; empty for smooth grains.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SavedRotation<V, C> {
    /// Angular velocities.
    pub velocities: V,
    /// Angular accelerations in the last step of clustered grains.
    pub accelerations: V,
    /// Contacts that last.
    pub contacts: C,
}

/// The rotation of smooth grains: nothing.
pub type NoRotation<S> = SavedRotation<heapless::Vec<S, 0>, heapless::Vec<ContactState<S>, 0>>;
