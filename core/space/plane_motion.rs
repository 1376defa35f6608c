//! Where is a plane that moves? Holds it; reads and writes nothing else.

/// Where a plate is along its normal, how fast it moves, and its acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PlaneMotion<S> {
    /// z₀.
    pub place: S,
    /// ż₀.
    pub speed: S,
    /// z̈₀.
    pub acceleration: S,
}
