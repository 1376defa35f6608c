//! What do `demo/tilt_box.c` and the Arduino sketch show, from Rust? Reads nothing; writes the digests that they must write.
//!
//! Only the engine is used, by safe code: none of the library that C has.

use carom::law::embedded::Compact;
use carom::law::{Outside, Soft, Viscoelastic};
use carom::{Error, Grain, Memory, World};

/// Gravity turns once in eight readings.
const READINGS: [[f32; 2]; 8] = [
    [0.0, -9.81],
    [6.94, -6.94],
    [9.81, 0.0],
    [6.94, 6.94],
    [0.0, 9.81],
    [-6.94, 6.94],
    [-9.81, 0.0],
    [-6.94, -6.94],
];

/// One of sixteen on a lattice. All numbers but the mass are exact.
fn grain(k: u16) -> Grain<f32, 2> {
    let radius = f32::from(8 + k % 4) / 2048.0;
    Grain::with_mass(radius, radius * radius * radius * 10_000.0)
        .at([k % 4, k / 4].map(|place| f32::from(2 * place + 1) / 128.0))
        .moving([k * 5 % 16, k * 3 % 16].map(|speed| (f32::from(speed) - 7.5) / 16.0))
}

fn main() -> Result<(), Error> {
    let rubber = Viscoelastic { young: 1.0e6, poisson: 0.4, dissipation: 2.0e-4 };
    let mut memory = Memory::<f32, 2, 16, 4>::new();
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 0.0625]; 2])
        .gravity(READINGS[0])
        .rule(Soft::embedded(rubber, Compact, Outside::HardSphere))
        .grains((0..16).map(grain))?
        .start()?;
    for frame in 1..=40_u16 {
        world.set_gravity(READINGS[usize::from(frame / 5 % 8)])?;
        world.advance_to(f64::from(frame) / 40.0)?;
        if frame % 8 == 0 {
            println!("{frame} {:016x}", world.digest());
        }
    }
    Ok(())
}
