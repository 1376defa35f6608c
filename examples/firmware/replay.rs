//! Which digests does this board get? Reads the command line over semihosting; writes lines.
//!
//! Without arguments each thousandth event of every scene, `scene scalar events digest`; with
//! `scene first last` each event of that range.

use carom::Scalar;
use carom_scenes::replay::{Told, replay};
use carom_scenes::{Event, Scene};
use semihosting::experimental::env;
use semihosting::println;

/// How many events are replayed.
const LAST: u32 = 10_000;

/// Replays in one number type; returns the exit code.
#[must_use]
pub fn main<S: Scalar>(scalar: &str) -> i32 {
    let (only, told) = asked().unwrap_or((None, Told::thousandths(LAST)));
    for scene in Scene::ALL.into_iter().filter(|scene| only.is_none_or(|only| only == *scene)) {
        let mut tell = |Event { number, digest }: Event| {
            println!("{} {scalar} {number} {digest:016x}", scene.name());
        };
        if let Err(fault) = replay::<S>(scene, told, &mut tell) {
            println!("{} {scalar} fault: {fault}", scene.name());
            return 1;
        }
    }
    0
}

/// The scene and the events that the command line asks for.
fn asked() -> Option<(Option<Scene>, Told)> {
    let words = env::args::<128>().ok()?;
    let mut words = (&words).into_iter().filter_map(Result::ok).skip(1);
    let (name, from, last) = (words.next()?, words.next()?, words.next()?);
    let scene = Scene::ALL.into_iter().find(|scene| scene.name() == name)?;
    Some((Some(scene), Told::each(from.parse().ok()?, last.parse().ok()?)))
}
