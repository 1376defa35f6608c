//! Where does a world of any size live on a workstation? Owns vectors on the heap; the engine borrows them.

use carom::particle::Body;
use carom::scalar::Vector;
use carom::space::{Link, MAX_PLANES, Plane, Surface};
use carom::world::{Buffers, ScheduledEvent};
use carom::{Scalar, Storage};

/// A world's memory as vectors, for a number of grains that is known at run time only.
///
/// [`carom::Memory`] is the same with a capacity that is known at compile time; the engine is the same
/// over both.
///
/// ```
/// use carom::{Grain, World, law::HardSphere};
/// use carom_host::heap_memory::HeapMemory;
/// let mut memory = HeapMemory::<f64, 3>::new(1000);
/// let grains = (0..1000).map(|i| Grain::with_mass(0.1, 1.0).at([f64::from(i), 0.0, 0.0]));
/// let world = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grains(grains)?
///     .start()?;
/// assert_eq!(world.view().len(), 1000);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct HeapMemory<S: Scalar, const D: usize> {
    bodies: Vec<Body<S, D>>,
    events: Vec<ScheduledEvent<S>>,
    tree: Vec<u32>,
    links: Vec<Link>,
    heads: Vec<u32>,
    planes: Vec<Plane<S, D>>,
    accelerations: Vec<Vector<S, D>>,
}

impl<S: Scalar, const D: usize> HeapMemory<S, D> {
    /// Memory for this many grains.
    #[must_use]
    pub fn new(grains: usize) -> Self {
        Self {
            bodies: vec![Body::default(); grains],
            events: vec![ScheduledEvent::default(); grains],
            tree: vec![0; grains],
            links: vec![Link::default(); grains],
            heads: vec![0; 2 * grains],
            planes: vec![Plane::new([S::zero(); D], S::zero(), Surface::Rule); MAX_PLANES],
            accelerations: vec![Vector::zeros(); grains],
        }
    }
}

impl<S: Scalar, const D: usize> Storage<S, D> for HeapMemory<S, D> {
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
