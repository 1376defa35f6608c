//! Who owns the arrays? The only types with a capacity, in place or on the heap; reads nothing, lends buffers.

use crate::detect::ScheduledEvent;
use crate::particle::{Body, Index};
use crate::scalar::{Scalar, Vector, vector};
use crate::space::{ContactState, Link, MAX_PLANES, ObstacleBuffers, Plane, RotationBuffers};
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// What a world borrows. The shortest of the slices that have a place for each grain says how many fit; those of the
/// calendar do not count.
pub struct Buffers<'m, S: Scalar, const D: usize> {
    /// One body for each grain.
    pub bodies: &'m mut [Body<S, D>],
    /// One scheduled event for each grain.
    pub events: &'m mut [ScheduledEvent<S>],
    /// The tournament tree: one word for each grain.
    pub tree: &'m mut [Index],
    /// One link for each grain, for the lists of grains in cells.
    pub links: &'m mut [Link],
    /// One word for each cell: as many as grains are enough, with fewer the cells are larger.
    pub heads: &'m mut [Index],
    /// One place for each plane; eight are enough.
    pub planes: &'m mut [Plane<S, D>],
    /// One vector for each grain: its acceleration in the last step, where contacts last or crowd. None where the
    /// world is in the papers' mode.
    pub accelerations: &'m mut [Vector<S, D>],
    /// With the feature `alloc`, the calendar of events: two words for each grain, for each of as many days at least,
    /// of which a power of two is used, and one more. With fewer, or none, the tree does the calendar's work.
    pub calendar: &'m mut [[u32; 2]],
    /// What grains with rough surfaces take beside, see [`Rotating`](super::Rotating); empty for smooth ones.
    pub rotation: RotationBuffers<'m, S>,
    /// Contacts that last and remember, as many as there can be at once, see [`WithContacts`](super::WithContacts);
    /// empty for smooth grains under the laws that have tables.
    pub contacts: &'m mut [ContactState<S>],
    /// Obstacles, and the lists in which they are found, see [`WithObstacles`](super::WithObstacles); empty for an empty
    /// box.
    pub obstacles: ObstacleBuffers<'m, S, D>,
}

impl<S: Scalar, const D: usize> Buffers<'_, S, D> {
    /// How many grains fit.
    #[must_use]
    pub fn capacity(&self) -> usize {
        let lengths = [self.events.len(), self.tree.len(), self.links.len()];
        lengths.into_iter().fold(self.bodies.len(), usize::min)
    }

    /// The same memory, lent for a while.
    pub(super) fn lent(&mut self) -> Buffers<'_, S, D> {
        Buffers {
            bodies: self.bodies,
            events: self.events,
            tree: self.tree,
            links: self.links,
            heads: self.heads,
            planes: self.planes,
            accelerations: self.accelerations,
            calendar: self.calendar,
            rotation: self.rotation.lent(),
            contacts: self.contacts,
            obstacles: self.obstacles.lent(),
        }
    }
}

/// Something a world can live in: [`Memory`], with the feature `alloc` `HeapMemory`, or your own arrays.
pub trait Storage<S: Scalar, const D: usize> {
    /// Lends everything it has.
    fn buffers(&mut self) -> Buffers<'_, S, D>;
}

/// The arrays behind [`Buffers`], of whatever type.
#[derive(Clone, Debug, Default)]
struct Arrays<B, E, W, L, H, P, V, C> {
    bodies: B,
    events: E,
    tree: W,
    links: L,
    heads: H,
    planes: P,
    accelerations: V,
    calendar: C,
}

impl<B, E, W: AsMut<[Index]>, L: AsMut<[Link]>, H: AsMut<[Index]>, P, V, C>
    Arrays<B, E, W, L, H, P, V, C>
{
    fn buffers<S: Scalar, const D: usize>(&mut self) -> Buffers<'_, S, D>
    where
        B: AsMut<[Body<S, D>]>,
        E: AsMut<[ScheduledEvent<S>]>,
        P: AsMut<[Plane<S, D>]>,
        V: AsMut<[Vector<S, D>]>,
        C: AsMut<[[u32; 2]]>,
    {
        Buffers {
            bodies: self.bodies.as_mut(),
            events: self.events.as_mut(),
            tree: self.tree.as_mut(),
            links: self.links.as_mut(),
            heads: self.heads.as_mut(),
            planes: self.planes.as_mut(),
            accelerations: self.accelerations.as_mut(),
            calendar: self.calendar.as_mut(),
            rotation: RotationBuffers::default(),
            contacts: &mut [],
            obstacles: ObstacleBuffers::default(),
        }
    }
}

type InPlace<S, const D: usize, const N: usize, const P: usize, const C: usize, const H: usize> =
    Arrays<
        [Body<S, D>; N],
        [ScheduledEvent<S>; N],
        [Index; N],
        [Link; N],
        [Index; H],
        [Plane<S, D>; P],
        [Vector<S, D>; C],
        [[u32; 2]; 0],
    >;

/// Memory for at most `N` grains and `P` planes, owned in place: no allocator. `C` grains can be in contacts that are
/// integrated: all of them, or 0 for the papers' mode. `H` cells can be used, where the grains' density asks for so
/// many: finer cells, fewer neighbours to look at. It changes no bit of a trajectory.
///
/// A box in two dimensions has four planes, one in three has six; there can be eight, and a world
/// that needs fewer can save their places:
///
/// ```
/// use carom::Memory;
/// // Four places of 40 bytes less; on 64-bit machines, where bodies begin with a cache line, about that.
/// assert!(size_of::<Memory<f32, 2, 32, 4>>() <= size_of::<Memory<f32, 2, 32>>() - 2 * 64);
/// ```
/// A world in [the papers' mode](crate::law::PaperMode) saves a vector for each grain:
///
/// ```
/// use carom::{Grain, Memory, World, law::{HardSphere, PaperMode}};
/// assert_eq!(size_of::<Memory<f32, 2, 32, 8>>() - size_of::<Memory<f32, 2, 32, 8, 0>>(), 32 * 8);
/// let rule = HardSphere { restitution: 0.9 };
/// let mut memory = Memory::<f32, 2, 32, 8, 0>::new();
/// assert!(World::builder(&mut memory).rule(PaperMode(rule)).grain(Grain::with_mass(0.5, 1.0))?.start().is_ok());
/// let mut memory = Memory::<f32, 2, 32, 8, 0>::new();
/// assert!(World::builder(&mut memory).rule(rule).grain(Grain::with_mass(0.5, 1.0))?.start().is_err());
/// # Ok::<(), carom::Error>(())
/// ```
/// Twice as many cells as grains are enough for any density; without the feature `alloc` each takes two bytes:
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere};
/// let grain = |k: u32| Grain::with_mass(0.5, 1.0).at([k % 8, k / 8].map(|x| 0.5 + 3.0 * f64::from(x)));
/// let (mut few, mut many) = (Memory::<f64, 2, 32>::new(), Memory::<f64, 2, 32, 8, 32, 64>::new());
/// macro_rules! cells {
///     ($memory:ident) => {
///         World::builder(&mut $memory)
///             .walls([[0.0, 24.0], [0.0, 12.0]])
///             .rule(HardSphere { restitution: 1.0 })
///             .grains((0..32).map(grain))?
///             .start()?
///             .searches()
///             .cells
///     };
/// }
/// assert!(cells!(few) <= 32 && cells!(many) > 32);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Memory<
    S: Scalar,
    const D: usize,
    const N: usize,
    const P: usize = MAX_PLANES,
    const C: usize = N,
    const H: usize = N,
>(InPlace<S, D, N, P, C, H>);

impl<S: Scalar, const D: usize, const N: usize, const P: usize, const C: usize, const H: usize>
    Memory<S, D, N, P, C, H>
{
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
        Self::EMPTY
    }

    /// A constant, so that nothing is put together at run time: there the parts and the whole would be on the
    /// stack at once, which is too much for 16 KiB of RAM.
    const EMPTY: Self = Self(Arrays {
        bodies: [Body::VACANT; N],
        events: [ScheduledEvent::VACANT; N],
        tree: [Index::ZERO; N],
        links: [Link::VACANT; N],
        heads: [Index::ZERO; H],
        planes: [Plane::VACANT; P],
        accelerations: [vector([S::ZERO; D]); C],
        calendar: [],
    });
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize, const C: usize, const H: usize>
    Default for Memory<S, D, N, P, C, H>
{
    /// Empty memory.
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const N: usize, const P: usize, const C: usize, const H: usize>
    Storage<S, D> for Memory<S, D, N, P, C, H>
{
    fn buffers(&mut self) -> Buffers<'_, S, D> {
        self.0.buffers()
    }
}

#[cfg(feature = "alloc")]
type OnHeap<S, const D: usize> = Arrays<
    Vec<Body<S, D>>,
    Vec<ScheduledEvent<S>>,
    Vec<Index>,
    Vec<Link>,
    Vec<Index>,
    Vec<Plane<S, D>>,
    Vec<Vector<S, D>>,
    Vec<[u32; 2]>,
>;

/// Memory on the heap, for a number of grains that is known at run time only (feature `alloc`).
///
/// The engine over it is the same as over [`Memory`] and allocates nothing itself. Between two worlds it
/// can grow.
///
/// ```
/// use carom::{Grain, HeapMemory, World, law::HardSphere};
/// let mut memory = HeapMemory::<f64, 3>::with_capacity(1000);
/// let grains = (0..1000).map(|i| Grain::with_mass(0.1, 1.0).at([f64::from(i), 0.0, 0.0]));
/// let world = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grains(grains)?
///     .start()?;
/// assert_eq!(world.view().len(), 1000);
///
/// memory.reserve(500);
/// assert_eq!(memory.capacity(), 1500);
/// # Ok::<(), carom::Error>(())
/// ```
#[cfg(feature = "alloc")]
#[derive(Clone, Debug)]
pub struct HeapMemory<S: Scalar, const D: usize>(OnHeap<S, D>);

#[cfg(feature = "alloc")]
impl<S: Scalar, const D: usize> HeapMemory<S, D> {
    /// Memory for this many grains, twice as many cells, and all the planes that there can be.
    #[must_use]
    pub fn with_capacity(grains: usize) -> Self {
        let mut memory = Self(Arrays {
            bodies: Vec::new(),
            events: Vec::new(),
            tree: Vec::new(),
            links: Vec::new(),
            heads: Vec::new(),
            planes: alloc::vec![Plane::VACANT; MAX_PLANES],
            accelerations: Vec::new(),
            calendar: Vec::new(),
        });
        memory.reserve(grains);
        memory
    }

    /// Room for this many more grains, and twice as many more cells. Worlds in it before are gone: they borrowed it.
    pub fn reserve(&mut self, additional: usize) {
        let grains = self.capacity() + additional;
        let arrays = &mut self.0;
        arrays.bodies.resize(grains, Body::VACANT);
        arrays.events.resize(grains, ScheduledEvent::VACANT);
        arrays.tree.resize(grains, Index::ZERO);
        arrays.links.resize(grains, Link::VACANT);
        arrays.accelerations.resize(grains, vector([S::ZERO; D]));
        arrays.calendar.resize(grains + (2 * grains).next_power_of_two() + 1, [0; 2]);
        // Twice as many: a grid cannot use just any number of cells.
        arrays.heads.resize(arrays.heads.len() + 2 * additional, Index::ZERO);
    }

    /// The same with room for this many cells, now; with none, all pairs are neighbours.
    #[must_use]
    pub fn with_cells(mut self, cells: usize) -> Self {
        self.0.heads.resize(cells, Index::ZERO);
        self
    }

    /// How many grains fit.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.0.bodies.len()
    }
}

#[cfg(feature = "alloc")]
impl<S: Scalar, const D: usize> Storage<S, D> for HeapMemory<S, D> {
    fn buffers(&mut self) -> Buffers<'_, S, D> {
        self.0.buffers()
    }
}
