//! Which digests does this board get? Reads the command line over semihosting; writes lines.
//!
//! Without arguments each thousandth event of every scene, `scene scalar events digest`; with
//! `scene scalar first last` each event of that range.

use carom::scalar::I32F32;
use carom_scenes::replay::{Selection, replay};
use carom_scenes::{EventDigest, Number, Scene};
use semihosting::experimental::env;
use semihosting::println;

/// How many events are replayed: half as many on a Cortex-M0, which takes the longest by far.
const LAST: u32 =
    if cfg!(all(target_arch = "arm", not(target_abi = "eabihf"))) { 5_000 } else { 10_000 };

/// Replays what the command line selects; returns the exit code.
#[must_use]
pub fn main() -> i32 {
    let Some((scene, scalar, selection)) = arguments() else {
        let all = |scene| {
            let selection = Selection::every_thousandth(LAST);
            replay_one::<f32>(scene, selection)
                && replay_one::<f64>(scene, selection)
                && replay_one::<I32F32>(scene, selection)
        };
        return i32::from(!Scene::ALL.into_iter().all(all));
    };
    i32::from(!match scalar {
        Scalar::F32 => replay_one::<f32>(scene, selection),
        Scalar::F64 => replay_one::<f64>(scene, selection),
        Scalar::Fixed => replay_one::<I32F32>(scene, selection),
    })
}

enum Scalar {
    F32,
    F64,
    Fixed,
}

/// Replays one scene in one number type; whether it came to its end.
fn replay_one<S: Number>(scene: Scene, selection: Selection) -> bool {
    let (name, scalar) = (scene.name(), S::NAME);
    let mut report = |EventDigest { event, digest }: EventDigest| {
        println!("{name} {scalar} {event} {digest:016x}")
    };
    let run = replay::<S>(scene)(selection, &mut report);
    if let Err(error) = run {
        println!("{name} {scalar} error: {error}");
    }
    run.is_ok()
}

/// Scene, number type and events from the command line.
fn arguments() -> Option<(Scene, Scalar, Selection)> {
    let words = env::args::<128>().ok()?;
    let mut words = (&words).into_iter().filter_map(Result::ok).skip(1);
    let (name, scalar) = (words.next()?, words.next()?);
    let scene = Scene::ALL.into_iter().find(|scene| scene.name() == name)?;
    let scalar = match scalar {
        "f32" => Scalar::F32,
        "f64" => Scalar::F64,
        "I32F32" => Scalar::Fixed,
        _ => return None,
    };
    Some((scene, scalar, Selection::each(words.next()?.parse().ok()?, words.next()?.parse().ok()?)))
}
