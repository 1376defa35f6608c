//! What is in the rough tilt box? The disks of the tilt box, hard and with friction, in the default mode; reads nothing, builds a world.

use carom::law::{HardSphere, IntegratedMode, Rough, Tangential};
use carom::space::ContactState;
use carom::world::{Rotating, WithContacts};
use carom::{Error, Memory, Scalar, Storage, World};

use crate::heap::{CONTACT_TIME, STEPS};
use crate::scene::{Number, Rough16, n};
use crate::tilt::{GRAINS, SIDE, accelerometer, site};

/// Places for contacts: of 32 disks and four walls no more than 102 can touch at once.
const CONTACTS: usize = 112;

/// The memory of this box: its disks, their rotation, their contacts and four walls.
pub type RoughBox32<S> =
    Rotating<WithContacts<Memory<S, 2, GRAINS, 4>, [ContactState<S>; CONTACTS]>, [S; GRAINS]>;

/// That memory, empty.
#[inline(never)]
#[must_use]
pub fn memory<S: Scalar>() -> RoughBox32<S> {
    let memory = WithContacts::new(Memory::new(), [ContactState::VACANT; CONTACTS]);
    Rotating::new(memory, [[S::zero(); GRAINS]; 3])
}

/// The rough tilt box: μ = 0.5, ε and contacts as in [`heap`](crate::heap).
///
/// Not inlined: the stack that building needs is free again before the first event.
///
/// # Errors
/// None unless the memory is too small.
#[inline(never)]
pub fn rough_box<S: Number>(
    memory: &mut impl Storage<S, 2>,
) -> Result<World<'_, S, 2, Rough16<S>>, Error> {
    let tangential = Tangential::Walton { mu: n(0.5), beta_0: n(0.3) };
    let normal = HardSphere { restitution: n(0.8) };
    World::builder(memory)
        .walls([[S::zero(), S::from_count(SIDE)]; 2])
        .gravity(accelerometer(0))
        .contact_time(n(CONTACT_TIME))
        .steps_per_contact(STEPS)
        .rule(IntegratedMode(Rough::disks(normal, tangential)))
        .grains((0..GRAINS as u32).map(site))?
        .start()
}
