//! Where do obstacles live? Memory of any kind, and beside it theirs; reads nothing, lends buffers.

use super::storage::{Buffers, Storage};
use crate::particle::Index;
use crate::scalar::Scalar;
use crate::space::{Facet, ObstacleBuffers, RigidMotion};

/// Memory for a world with obstacles: any other memory, the obstacles' facets, and places for lists in which grains find
/// those that are near.
///
/// Facets are an array, a slice or a vector; what has no facets is a world without obstacles. In the lists there must
/// be two places more than facets; then each grain looks at all of them. With eight times as many it looks at few: memory
/// of a facet in `f64` is 88 bytes in the plane and 144 in space, of a place in the lists 4 (without the feature `alloc`
/// 2).
///
/// ```
/// use carom::law::HardSphere;
/// use carom::space::{Surface, polygon};
/// use carom::world::WithObstacles;
/// use carom::{Grain, Memory, World};
///
/// let triangle = polygon([[0.0, 0.0], [4.0, 0.0], [2.0, 3.0]], Surface::Hard(1.0));
/// let mut memory = WithObstacles::new(Memory::<f64, 2, 1>::new(), triangle, [Default::default(); 64]);
/// let mut world = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.25, 1.0).at([2.0, 1.0]).moving([0.3, 0.4]))?
///     .start()?;
/// world.advance_to(1000.0)?;
/// assert!(world.statistics().plane_collisions > 100);
/// assert!((world.view().kinetic_energy() - 0.125).abs() < 1e-12);
/// # Ok::<(), carom::Error>(())
/// ```
///
/// Obstacles are in an open world: no axis is periodic, and contacts that last are integrated
/// ([`Enduring::Integrated`](crate::Enduring), the default). A [`Snapshot`](super::Snapshot) does not keep them: who
/// restores a world lends the same again.
#[derive(Clone, Debug)]
pub struct WithObstacles<M, F, L, P = NoMotion> {
    /// The memory for all else.
    pub memory: M,
    /// The facets of all obstacles.
    pub facets: F,
    /// Places for lists: what is in them does not matter.
    pub lists: L,
    /// How groups of facets move.
    pub motions: P,
}

/// No motion: all obstacles stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoMotion;

impl<S: Scalar, const D: usize> AsMut<[RigidMotion<S, D>]> for NoMotion {
    fn as_mut(&mut self) -> &mut [RigidMotion<S, D>] {
        &mut []
    }
}

impl<M, F, L> WithObstacles<M, F, L> {
    /// This memory, these facets and these places. Also in a `static`.
    #[must_use]
    pub const fn new(memory: M, facets: F, lists: L) -> Self {
        Self { memory, facets, lists, motions: NoMotion }
    }

    /// The same, with these [`RigidMotion`](crate::space::RigidMotion)s, an array, a slice or a vector. A facet says which of them is
    /// its own ([`Facet::moving`]). Each takes two places more in the lists.
    #[cfg(feature = "plates")]
    #[must_use]
    pub fn moving<P>(self, motions: P) -> WithObstacles<M, F, L, P> {
        let Self { memory, facets, lists, .. } = self;
        WithObstacles { memory, facets, lists, motions }
    }
}

impl<S, M, F, L, P, const D: usize> Storage<S, D> for WithObstacles<M, F, L, P>
where
    S: Scalar,
    M: Storage<S, D>,
    F: AsRef<[Facet<S, D>]>,
    L: AsMut<[Index]>,
    P: AsMut<[RigidMotion<S, D>]>,
{
    fn buffers(&mut self) -> Buffers<'_, S, D> {
        let obstacles = ObstacleBuffers {
            facets: self.facets.as_ref(),
            lists: self.lists.as_mut(),
            motions: self.motions.as_mut(),
        };
        Buffers { obstacles, ..self.memory.buffers() }
    }
}
