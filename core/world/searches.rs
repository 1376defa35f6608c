//! How are neighbours and the next event found? Reads what the memory had room for; writes nothing.

use super::state::World;
use crate::scalar::Scalar;

/// What a world uses to find things. It changes how fast a world is, and none of its bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Searches {
    /// In how many cells space is cut; 0 if all pairs of grains are compared: there are few of them, the memory has
    /// no room for cells, or a periodic box is shorter than four of them.
    pub cells: usize,
    /// In how many levels of cells grains are listed: more than one where sizes differ much (feature `alloc`).
    pub levels: usize,
    /// Whether the next event comes from a calendar (feature `alloc`), or from the tournament tree: there are few
    /// grains, the memory has no room, or their events are too uneven.
    pub calendar: bool,
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// How neighbours and the next event are found.
    ///
    /// ```
    /// use carom::{Grain, HeapMemory, World, law::HardSphere};
    /// let site = |i: u32| [i % 10, i / 10 % 10, i / 100].map(f64::from);
    /// let mut memory = HeapMemory::<f64, 3>::with_capacity(1000);
    /// let world = World::builder(&mut memory)
    ///     .periodic([[0.0, 10.0]; 3])
    ///     .rule(HardSphere { restitution: 1.0 })
    ///     .grains((0..1000).map(|i| Grain::with_mass(0.3, 1.0).at(site(i))))?
    ///     .start()?;
    /// let searches = world.searches();
    /// assert_eq!((searches.cells, searches.levels), (1728, 1));
    /// # Ok::<(), carom::Error>(())
    /// ```
    #[must_use]
    pub fn searches(&self) -> Searches {
        let cells = &self.particles.cells;
        Searches {
            cells: cells.grid.as_ref().map_or(0, |grid| grid.cells()),
            levels: if cells.grid.is_some() { cells.levels.len() } else { 0 },
            calendar: self.queue.has_calendar(),
        }
    }
}
