//! Which digests does this machine get in f32? Reads the command line; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_scenes::{
    Event, Scene,
    replay::{Told, replay},
};
use cortex_m_rt::entry;
use semihosting::{println, process};

#[entry]
fn main() -> ! {
    for scene in Scene::ALL {
        let mut tell = |Event { number, digest }: Event| {
            println!("{} f32 {number} {digest:016x}", scene.name())
        };
        if let Err(fault) = replay::<f32>(scene, Told::thousandths(10_000), &mut tell) {
            println!("{}: {fault}", scene.name());
        }
    }
    process::exit(0)
}
