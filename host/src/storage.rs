//! Where does a world of any size live on a workstation? Owns vectors; lends them to the engine.

use carom::event::Slot;
use carom::matter::boundary::MOST_PLANES;
use carom::matter::cells::Link;
use carom::matter::{Body, Plane, Surface};
use carom::world::Room;
use carom::{Lend, Scalar};

/// Memory for a number of grains that is known at run time only. The engine is the same.
///
/// ```
/// use carom::{Grain, World, law::HardSphere};
/// use carom_host::storage::Storage;
/// let mut storage = Storage::<f64, 3>::new(1000);
/// let grains = (0..1000).map(|i| Grain::with_mass(0.1, 1.0).at([f64::from(i), 0.0, 0.0]));
/// let world = World::setup(&mut storage)
///     .rule(HardSphere { restitution: 1.0 })
///     .grains(grains)?
///     .start()?;
/// assert_eq!(world.view().len(), 1000);
/// # Ok::<(), carom::Fault>(())
/// ```
#[derive(Clone, Debug)]
pub struct Storage<S: Scalar, const D: usize> {
    bodies: Vec<Body<S, D>>,
    slots: Vec<Slot<S>>,
    tree: Vec<u32>,
    links: Vec<Link>,
    heads: Vec<u32>,
    planes: Vec<Plane<S, D>>,
}

impl<S: Scalar, const D: usize> Storage<S, D> {
    /// Room for this many grains.
    #[must_use]
    pub fn new(grains: usize) -> Self {
        Self {
            bodies: vec![Body::default(); grains],
            slots: vec![Slot::default(); grains],
            tree: vec![0; grains],
            links: vec![Link::default(); grains],
            heads: vec![0; 2 * grains],
            planes: vec![Plane::new([S::zero(); D], S::zero(), Surface::Rule); MOST_PLANES],
        }
    }
}

impl<S: Scalar, const D: usize> Lend<S, D> for Storage<S, D> {
    fn lend(&mut self) -> Room<'_, S, D> {
        Room {
            bodies: &mut self.bodies,
            slots: &mut self.slots,
            tree: &mut self.tree,
            links: &mut self.links,
            heads: &mut self.heads,
            planes: &mut self.planes,
        }
    }
}
