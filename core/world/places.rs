//! Which grains does a world begin with, and how many may come later? Reads grains, checks them; writes the memory's places.

use super::builder::WorldBuilder;
use super::check_input;
use crate::error::Error;
use crate::particle::{Body, Grain};
use crate::scalar::Scalar;
use crate::schedule::EventQueue;

impl<S: Scalar, const D: usize, R> WorldBuilder<'_, S, D, R> {
    /// One more grain.
    ///
    /// # Errors
    /// [`Error::Full`] if the memory holds no more, [`Error::Input`] that names the grain and its field.
    pub fn grain(mut self, grain: Grain<S, D>) -> Result<Self, Error> {
        self.add_grain(grain)?;
        Ok(self)
    }

    /// As [`WorldBuilder::grain`], and says its number.
    ///
    /// ```
    /// use carom::{Grain, Memory, World};
    /// let mut memory = Memory::<f32, 2, 8>::new();
    /// let mut beads = World::builder(&mut memory);
    /// assert!(beads.add_grain(Grain::with_mass(f32::NAN, 1.0)).is_err());
    /// assert_eq!(beads.add_grain(Grain::with_mass(0.5, 1.0)), Ok(0)); // the one before is not there
    /// ```
    ///
    /// # Errors
    /// As [`WorldBuilder::grain`]. Nothing has changed then.
    pub fn add_grain(&mut self, grain: Grain<S, D>) -> Result<usize, Error> {
        let number = self.count;
        check_input::grain(&grain, number)?;
        *self.place()? = Body::new(&grain);
        self.count += 1;
        Ok(number)
    }

    /// How many places for grains are taken so far.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Many more grains.
    ///
    /// # Errors
    /// As [`WorldBuilder::grain`].
    pub fn grains(self, grains: impl IntoIterator<Item = Grain<S, D>>) -> Result<Self, Error> {
        grains.into_iter().try_fold(self, Self::grain)
    }

    /// So many empty places for grains that are added later, see [`World::add`](crate::World::add).
    ///
    /// # Errors
    /// [`Error::Full`] if the memory has no places for them.
    pub fn reserve(mut self, places: usize) -> Result<Self, Error> {
        self.add_empty_places(places)?;
        Ok(self)
    }

    /// As [`WorldBuilder::reserve`].
    ///
    /// # Errors
    /// As [`WorldBuilder::reserve`]. There are as many then as the memory had places for.
    pub fn add_empty_places(&mut self, places: usize) -> Result<(), Error> {
        for _ in 0..places {
            *self.place()? = Body::vacant(S::zero(), 0);
            self.count += 1;
        }
        Ok(())
    }

    /// The next place.
    fn place(&mut self) -> Result<&mut Body<S, D>, Error> {
        let (room, most) = (self.buffers.capacity(), EventQueue::<S>::MAX_GRAINS);
        let capacity = room.min(most);
        let knob = match room > most {
            false => "the memory (N of Memory, or the host's vectors)",
            true => "the numbers of grains, which have more bits with the feature alloc,",
        };
        let full = Error::Full { knob, capacity };
        if self.count >= capacity {
            return Err(full);
        }
        self.buffers.bodies.get_mut(self.count).ok_or(full)
    }
}
