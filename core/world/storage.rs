//! Who owns the arrays? The only type with a capacity; reads nothing, lends buffers.

use crate::detect::ScheduledEvent;
use crate::particle::Body;
use crate::scalar::Scalar;
use crate::space::{Link, MAX_PLANES, Plane, Surface};

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
}

impl<S: Scalar, const D: usize> Buffers<'_, S, D> {
    /// How many grains fit.
    #[must_use]
    pub fn capacity(&self) -> usize {
        let lengths = [self.events.len(), self.tree.len(), self.links.len()];
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
}

impl<S: Scalar, const D: usize, const N: usize> Memory<S, D, N> {
    /// Empty memory with places for all planes there can be.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize> Default for Memory<S, D, N, P> {
    /// Empty memory.
    fn default() -> Self {
        Self {
            bodies: [Body::default(); N],
            events: [ScheduledEvent::NONE; N],
            tree: [0; N],
            links: [Link::default(); N],
            heads: [0; N],
            planes: [Plane::new([S::zero(); D], S::zero(), Surface::Rule); P],
        }
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
        }
    }
}
