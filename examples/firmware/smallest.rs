//! What is the least that is of use? 16 hard disks that roll to where their box is tilted; reads a script, writes nothing.

use carom::law::{HardSphere, Rule};
use carom::{Error, Grain, Instant, Memory, World};
use carom_scenes::tilt::accelerometer;

/// How many disks.
const DISKS: usize = 16;
/// Events that a frame may take.
const SHARE: u32 = 160;

/// 56 frames of 25 ms. Text and pictures are left to those who add them: where the disks are is only looked at.
///
/// `C` disks can be in contacts that are integrated: all, or none in the papers' mode.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn run<R: Rule<f32>, const C: usize>(rule: impl Fn(HardSphere<f32>) -> R) -> Result<(), Error> {
    let mut memory = Memory::<f32, 2, DISKS, 4, C, { 2 * DISKS }>::new();
    let disk = |k: u32| {
        let at = [k % 4, k / 4].map(|place| 1.5 + 3.0 * place as f32);
        Grain::with_mass(1.0, 1.0).at(at)
    };
    let mut world = World::builder(&mut memory)
        .hard_walls([[0.0, 12.0]; 2], 0.8)
        .gravity(accelerometer(0))
        .rule(rule(HardSphere { restitution: 0.8 }))
        .grains((0..DISKS as u32).map(disk))?
        .start()?;
    for frame in 0..56 {
        world.set_gravity(accelerometer(frame))?;
        world.advance_with_budget(Instant::from(25.0 * (frame + 1) as f32), SHARE)?;
        show(&world);
    }
    Ok(())
}

/// Here a display would be written to.
fn show<R: Rule<f32>>(world: &World<'_, f32, 2, R>) {
    (0..DISKS).filter_map(|k| world.grain(k)).for_each(|disk| {
        core::hint::black_box(disk.position);
    });
}
