//! Which digests does WebAssembly get? Reads which events of which scene; writes a list of digests that JavaScript reads.
#![no_std]
#![allow(unsafe_code)] // Exported names are; nothing else here is.

use core::sync::atomic::{AtomicU64, Ordering};

use carom::scalar::I32F32;
use carom_scenes::replay::{Run, Selection, replay};
use carom_scenes::{EventDigest, Scene};

/// How many digests one replay can return.
const MAX_DIGESTS: usize = 1024;

static DIGESTS: [AtomicU64; MAX_DIGESTS] = [const { AtomicU64::new(0) }; MAX_DIGESTS];

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}

/// Replays a scene in a number type (0: `f32`, 1: `f64`, 2: `I32F32`) and keeps the digest of each event after `from` up to `last`
/// whose number is a multiple of `every`. Returns how many digests there are; -1 for an error.
#[unsafe(no_mangle)]
pub extern "C" fn run(scene: usize, scalar: u32, from: u32, last: u32, every: u32) -> i32 {
    let mut count = 0;
    let mut report = |state: EventDigest| {
        if let Some(place) = DIGESTS.get(count) {
            place.store(state.digest, Ordering::Relaxed);
            count += 1;
        }
    };
    let selection = Selection { last, every, from };
    match chosen(scene, scalar).map(|run| run(selection, &mut report)) {
        Some(Ok(())) => count as i32,
        _ => -1,
    }
}

/// The digest with this index of the last replay.
#[unsafe(no_mangle)]
pub extern "C" fn digest(index: usize) -> u64 {
    DIGESTS.get(index).map_or(0, |place| place.load(Ordering::Relaxed))
}

/// The letter with this index of a scene's name; 0 after the last one, and where there is no such scene.
#[unsafe(no_mangle)]
pub extern "C" fn letter(scene: usize, index: usize) -> u8 {
    let name = Scene::ALL.get(scene).map_or("", |scene| scene.name());
    name.as_bytes().get(index).copied().unwrap_or(0)
}

fn chosen(scene: usize, scalar: u32) -> Option<Run> {
    let scene = *Scene::ALL.get(scene)?;
    match scalar {
        0 => Some(replay::<f32>(scene)),
        1 => Some(replay::<f64>(scene)),
        2 => Some(replay::<I32F32>(scene)),
        _ => None,
    }
}
