//! Who owns the arrays? The only type with a capacity; reads nothing, lends buffers.

use crate::detect::ScheduledEvent;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, vector};
use crate::space::{Link, MAX_PLANES, Plane};

/// What a world borrows. The shortest slice but `heads` says how many grains fit.
pub struct Buffers<'m, S: Scalar, const D: usize> {
    /// One body for each grain.
    pub bodies: &'m mut [Body<S, D>],
    /// One scheduled event for each grain.
    pub events: &'m mut [ScheduledEvent<S>],
    /// The tournament tree: one word for each grain.
    pub tree: &'m mut [u32],
    /// One link for each grain, for the lists of grains in cells.
    pub links: &'m mut [Link],
    /// One word for each cell: as many as grains are enough, with fewer the cells are larger.
    pub heads: &'m mut [u32],
    /// One place for each plane; eight are enough.
    pub planes: &'m mut [Plane<S, D>],
    /// One vector for each grain: its acceleration in the last step, where contacts last or crowd.
    pub accelerations: &'m mut [Vector<S, D>],
}

impl<S: Scalar, const D: usize> Buffers<'_, S, D> {
    /// How many grains fit.
    #[must_use]
    pub fn capacity(&self) -> usize {
        let lengths =
            [self.events.len(), self.tree.len(), self.links.len(), self.accelerations.len()];
        lengths.into_iter().fold(self.bodies.len(), usize::min)
    }
}

/// Something a world can live in.
///
/// [`Memory`] is one; a host implements it for its vectors.
pub trait Storage<S: Scalar, const D: usize> {
    /// Lends everything it has.
    fn buffers(&mut self) -> Buffers<'_, S, D>;
}

/// Memory for at most `N` grains and `P` planes, owned in place: no allocator.
///
/// A box in two dimensions has four planes, one in three has six; there can be eight, and a world
/// that needs fewer can save their places:
///
/// ```
/// use carom::Memory;
/// // Four places of 40 bytes less; on 64-bit machines, where bodies begin with a cache line, about that.
/// assert!(size_of::<Memory<f32, 2, 32, 4>>() <= size_of::<Memory<f32, 2, 32>>() - 2 * 64);
/// ```
#[derive(Clone, Debug)]
pub struct Memory<S: Scalar, const D: usize, const N: usize, const P: usize = MAX_PLANES> {
    bodies: [Body<S, D>; N],
    events: [ScheduledEvent<S>; N],
    tree: [u32; N],
    links: [Link; N],
    heads: [u32; N],
    planes: [Plane<S, D>; P],
    accelerations: [Vector<S, D>; N],
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize> Memory<S, D, N, P> {
    /// Empty memory, also in a `static`: all its bits are zero, so it takes no flash.
    ///
    /// ```
    /// use carom::{Grain, Memory, World, law::HardSphere};
    /// use std::sync::Mutex; // on a microcontroller: critical_section::Mutex, or a StaticCell without a lock
    ///
    /// static MEMORY: Mutex<Memory<f32, 2, 16, 4>> = Mutex::new(Memory::new());
    ///
    /// let mut memory = MEMORY.lock().unwrap();
    /// let world = World::builder(&mut *memory)
    ///     .walls([[0.0, 0.05]; 2])
    ///     .rule(HardSphere { restitution: 0.9 })
    ///     .grain(Grain::sphere(1.0e-3, 2500.0).at([0.01, 0.02]))?
    ///     .start()?;
    /// assert_eq!(world.view().len(), 1);
    /// # Ok::<(), carom::Error>(())
    /// ```
    #[must_use]
    pub const fn new() -> Self {
        Self {
            bodies: [Body::VACANT; N],
            events: [ScheduledEvent::VACANT; N],
            tree: [0; N],
            links: [Link::VACANT; N],
            heads: [0; N],
            planes: [Plane::VACANT; P],
            accelerations: [vector([S::ZERO; D]); N],
        }
    }
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize> Default for Memory<S, D, N, P> {
    /// Empty memory.
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize> Storage<S, D>
    for Memory<S, D, N, P>
{
    fn buffers(&mut self) -> Buffers<'_, S, D> {
        Buffers {
            bodies: &mut self.bodies,
            events: &mut self.events,
            tree: &mut self.tree,
            links: &mut self.links,
            heads: &mut self.heads,
            planes: &mut self.planes,
            accelerations: &mut self.accelerations,
        }
    }
}
