//! Where are rotations kept? Reads a start; writes memory that worlds borrow.

use crate::scenario::Start;
use carom::space::ContactState;
use carom::world::RotationBuffers;

/// The memory for the rotation of all grains, empty where they are smooth, and for what contacts remember.
pub struct Spins {
    rows: [Vec<f64>; 3],
    contacts: Vec<ContactState<f64>>,
}

/// So many contacts a grain can have at once, on average: many more than disks or spheres of one size.
const CONTACTS: usize = 16;

impl Spins {
    /// Memory for these grains, rotating as they do at the start.
    pub fn new<const D: usize>(start: &Start) -> Self {
        // One number in the plane, the last of three.
        let axes = if D == 3 { 0..3 } else { 2..3 };
        let first: Vec<f64> =
            start.rotations.iter().flat_map(|w| w[axes.clone()].to_vec()).collect();
        let (second, third) = (first.clone(), first.clone());
        let has_contacts = start.laws.are_integrated() || !start.rotations.is_empty();
        let count = if has_contacts { start.grains.len() } else { 0 };
        let contacts = vec![ContactState::VACANT; CONTACTS * count];
        Self { rows: [first, second, third], contacts }
    }

    /// Lends it.
    pub fn buffers(&mut self) -> (RotationBuffers<'_, f64>, &mut [ContactState<f64>]) {
        let [velocities, accelerations, sums] = self.rows.each_mut().map(|row| &mut row[..]);
        accelerations.fill(0.0);
        (RotationBuffers { velocities, accelerations, sums }, &mut self.contacts)
    }
}
