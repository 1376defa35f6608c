//! What does a world of this module borrow, and which rule has it? Smooth grains, or rough ones among obstacles; reads and writes nothing.

use crate::rule::ChosenRule;
use carom::Memory;

/// The dimension of this module's worlds.
pub const D: usize = if cfg!(feature = "line") {
    1
} else if cfg!(feature = "space") {
    3
} else {
    2
};
/// The most grains of a world.
pub const MAX_GRAINS: usize = 500;

/// Memory of a world of smooth grains.
#[cfg(not(feature = "rough"))]
pub type Lent = Memory<f64, D, MAX_GRAINS>;

/// The rule of smooth grains.
#[cfg(not(feature = "rough"))]
pub type WorldRule = ChosenRule;

#[cfg(feature = "rough")]
pub use rough::{Lent, MAX_FACETS, WorldRule, lent};

/// Memory for nobody yet.
#[cfg(not(feature = "rough"))]
pub const fn lent(_: &Facets) -> Lent {
    Memory::new()
}

/// The facets of obstacles.
#[cfg(feature = "rough")]
pub type Facets = heapless::Vec<carom::space::Facet<f64, D>, MAX_FACETS>;
/// There are none.
#[cfg(not(feature = "rough"))]
pub type Facets = ();

#[cfg(feature = "rough")]
mod rough {
    use super::{ChosenRule, D, Facets, MAX_GRAINS, Memory};
    use carom::law::Rough;
    use carom::particle::Index;
    use carom::space::ContactState;
    use carom::world::{Rotating, WithContacts, WithObstacles};

    /// The most segments of obstacles.
    pub const MAX_FACETS: usize = 100;
    /// Places in the lists of facets.
    const PLACES: usize = 16 * MAX_FACETS;
    /// Contacts at one time: grains in a plane have three each, and some touch walls.
    const CONTACTS: usize = 4 * MAX_GRAINS;

    type Obstructed = WithObstacles<Memory<f64, D, MAX_GRAINS>, Facets, [Index; PLACES]>;
    /// Memory of a world of rough grains among obstacles.
    pub type Lent =
        Rotating<WithContacts<Obstructed, [ContactState<f64>; CONTACTS]>, [f64; MAX_GRAINS]>;

    /// The rule of rough grains.
    pub type WorldRule = Rough<ChosenRule, f64>;

    /// Memory for nobody yet, among these facets.
    pub fn lent(facets: &Facets) -> Lent {
        let memory = WithObstacles::new(Memory::new(), facets.clone(), [Index::default(); PLACES]);
        let memory = WithContacts::new(memory, [ContactState::VACANT; CONTACTS]);
        Rotating::new(memory, [[0.0; MAX_GRAINS]; 3])
    }
}
