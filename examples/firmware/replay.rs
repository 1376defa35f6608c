//! Which digests does this board get? Reads the command line over semihosting; writes lines.
//!
//! Without arguments each thousandth event of every scene, `scene scalar events digest`; with
//! `scene first last` each event of that range.

use carom_scenes::replay::{self, Run, Told};
use carom_scenes::{Event, Number, Scene};
use semihosting::experimental::env;
use semihosting::println;

/// How many events are replayed.
const LAST: u32 = 10_000;

/// Replays in one number type; returns the exit code.
#[must_use]
pub fn main<S: Number>() -> i32 {
    let scalar = S::NAME;
    let (only, told) = asked().unwrap_or((None, Told::thousandths(LAST)));
    for (scene, run) in scenes::<S>() {
        if only.is_some_and(|only| only != scene) {
            continue;
        }
        let mut tell = |Event { number, digest }: Event| {
            println!("{} {scalar} {number} {digest:016x}", scene.name());
        };
        if let Err(fault) = run(told, &mut tell) {
            println!("{} {scalar} fault: {fault}", scene.name());
            return 1;
        }
    }
    0
}

/// What this image can replay. Fig. 6 has a table of its own, and the flash of a small board does not
/// hold all.
fn scenes<S: Number>() -> impl Iterator<Item = (Scene, Run)> {
    let fig6: &[(Scene, Run)] =
        if cfg!(feature = "fig6") { &[(Scene::Fig6, replay::fig6::<S>)] } else { &[] };
    let others: &[(Scene, Run)] = if cfg!(feature = "others") {
        &[
            (Scene::Box16, replay::box16::<S>),
            (Scene::Gas32, replay::gas32::<S>),
            (Scene::Column10, replay::column10::<S>),
        ]
    } else {
        &[]
    };
    fig6.iter().chain(others).copied()
}

/// The scene and the events that the command line asks for.
fn asked() -> Option<(Option<Scene>, Told)> {
    let words = env::args::<128>().ok()?;
    let mut words = (&words).into_iter().filter_map(Result::ok).skip(1);
    let (name, from, last) = (words.next()?, words.next()?, words.next()?);
    let scene = Scene::ALL.into_iter().find(|scene| scene.name() == name)?;
    Some((Some(scene), Told::each(from.parse().ok()?, last.parse().ok()?)))
}
