//! What do obstacles borrow? Slices, or nothing in no memory without the feature `obstacles`; reads and writes nothing.

use super::facet::Facet;
use super::rigid_motion::RigidMotion;
use crate::particle::Index;
use crate::scalar::Scalar;

/// What a world with obstacles borrows beside [`Buffers`](crate::world::Buffers)' other slices. Empty, the default,
/// without obstacles.
#[derive(Debug)]
pub struct ObstacleBuffers<'m, S: Scalar, const D: usize> {
    /// The facets of all obstacles.
    #[cfg(feature = "obstacles")]
    pub facets: &'m [Facet<S, D>],
    /// Places for the lists of facets in cells.
    #[cfg(feature = "obstacles")]
    pub lists: &'m mut [Index],
    /// How groups of them move.
    #[cfg(feature = "obstacles")]
    pub motions: &'m mut [RigidMotion<S, D>],
    #[cfg(not(feature = "obstacles"))]
    never: core::marker::PhantomData<&'m mut [S; D]>,
}

/// Facets, places for their lists, and motions.
type Parts<'m, S, const D: usize> =
    (&'m [Facet<S, D>], &'m mut [Index], &'m mut [RigidMotion<S, D>]);

#[cfg(feature = "obstacles")]
impl<'m, S: Scalar, const D: usize> ObstacleBuffers<'m, S, D> {
    /// The same memory, lent for a while.
    pub(crate) fn lent(&mut self) -> ObstacleBuffers<'_, S, D> {
        ObstacleBuffers { facets: self.facets, lists: self.lists, motions: self.motions }
    }

    /// The facets.
    pub(crate) fn facets(&self) -> &[Facet<S, D>] {
        self.facets
    }

    /// How groups of them move.
    pub(crate) fn motions(&self) -> &[RigidMotion<S, D>] {
        self.motions
    }

    /// Facets, lists and motions.
    pub(crate) fn parts(self) -> Parts<'m, S, D> {
        (self.facets, self.lists, self.motions)
    }
}

#[cfg(not(feature = "obstacles"))]
impl<'m, S: Scalar, const D: usize> ObstacleBuffers<'m, S, D> {
    pub(crate) fn lent(&mut self) -> ObstacleBuffers<'_, S, D> {
        ObstacleBuffers::default()
    }

    pub(crate) fn facets(&self) -> &[Facet<S, D>] {
        &[]
    }

    pub(crate) fn motions(&self) -> &[RigidMotion<S, D>] {
        &[]
    }

    pub(crate) fn parts(self) -> Parts<'m, S, D> {
        (&[], &mut [], &mut [])
    }
}

impl<S: Scalar, const D: usize> Default for ObstacleBuffers<'_, S, D> {
    #[cfg(feature = "obstacles")]
    fn default() -> Self {
        Self { facets: &[], lists: &mut [], motions: &mut [] }
    }

    #[cfg(not(feature = "obstacles"))]
    fn default() -> Self {
        Self { never: core::marker::PhantomData }
    }
}
