//! What is in the box that heaps up? Hard disks in the default mode, with contacts as long as a microcontroller wants them; reads nothing, builds a world.

use carom::law::{HardSphere, IntegratedMode};
use carom::{Error, Memory, Storage, World};

use crate::scene::{GRAVITY, Number, n, sixteen, v};

/// How many grains, where nothing else is said.
pub const GRAINS: usize = 16;
/// How long a slow contact lasts, in milliseconds: a quarter of (R/g)^½, four times as long as carom would choose. Grains
/// at rest overlap by 0.6 % of their radius for each that lies on them. Longer ones save nothing: what is pressed
/// deeper than R/32 is stiffer, and takes shorter steps for it.
pub const CONTACT_TIME: f64 = 2.0;
/// Steps in such a contact: as few as carom takes.
pub const STEPS: u32 = 8;

/// The memory of this box: its grains and its four walls.
pub type Heap<S, const N: usize> = Memory<S, 2, N, 4>;

/// So many disks, let go, in a box as high as they need: 12 mm for 16.
///
/// Not inlined: the stack that building needs is free again before the first event.
///
/// # Errors
/// None unless the memory is too small.
#[inline(never)]
pub fn heap<S: Number>(
    memory: &mut impl Storage<S, 2>,
    disks: u32,
) -> Result<World<'_, S, 2, IntegratedMode<HardSphere<S>>>, Error> {
    let height = S::from_count(3 * disks.div_ceil(4));
    World::builder(memory)
        .hard_walls([v([0.0, 12.0]), [n(0.0), height]], n(0.8))
        .gravity(v([0.0, -GRAVITY]))
        .contact_time(n(CONTACT_TIME))
        .steps_per_contact(STEPS)
        .rule(IntegratedMode(HardSphere { restitution: n(0.8) }))
        .grains((0..disks).map(sixteen))?
        .start()
}
