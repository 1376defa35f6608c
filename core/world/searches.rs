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
    /// let site = |i: u32, by| [f64::from(i % 10), f64::from(i / 10 % 10), f64::from(i / 100)].map(|x| x + by);
    /// let small = (0..1000).map(|i| Grain::with_mass(0.05, 1.0).at(site(i, 0.0)));
    /// let large = (0..30).map(|i| Grain::with_mass(0.5, 1000.0).at(site(3 * i, 0.5)));
    /// let mut memory = HeapMemory::<f64, 3>::with_capacity(1030);
    /// let world = World::builder(&mut memory)
    ///     .periodic([[0.0, 10.0]; 3])
    ///     .rule(HardSphere { restitution: 1.0 })
    ///     .grains(small)?
    ///     .grains(large)?
    ///     .start()?;
    /// assert_eq!(world.searches().levels, 2);
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
