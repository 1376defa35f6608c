//! Does this machine compute the same bits as every other? Replays scenes; compares digests with the golden file.
//!
//! `golden.txt` holds `scene scalar events digest` after each thousand events. It is made by
//! `cargo run --release --manifest-path examples/scenes/Cargo.toml --example replay -- 100000 > tests/bits/golden.txt`
//! and every target (`examples/check.sh`) is held against it. A change of the engine that changes
//! trajectories changes it; a change of compiler, optimisation or target must not.

use carom::scalar::I32F32;
use carom_scenes::replay::{Selection, replay};
use carom_scenes::{EventDigest, Number, Scene};

const GOLDEN: &str = include_str!("golden.txt");

/// The golden digests of one scene in one number type, in order.
fn golden(scene: Scene, scalar: &str) -> impl Iterator<Item = EventDigest> {
    let prefix = format!("{} {scalar} ", scene.name());
    GOLDEN.lines().filter_map(move |line| {
        let (event, digest) = line.strip_prefix(&prefix)?.split_once(' ')?;
        let digest = u64::from_str_radix(digest, 16).unwrap();
        Some(EventDigest { event: event.parse().unwrap(), digest })
    })
}

/// Runs a scene and compares; the first block that differs is named, and how to find its event.
fn same<S: Number>(scene: Scene, last: u32) {
    let scalar = S::NAME;
    let mut wanted = golden(scene, scalar);
    let mut good = 0;
    let mut compare = |found: EventDigest| {
        let name = scene.name();
        assert_eq!(
            wanted.next(),
            Some(found),
            "{name} in {scalar} differs first between events {good} and {0}. Run `cargo run --release \
             --manifest-path examples/scenes/Cargo.toml --example replay -- {name} {scalar} {good} {0}` here \
             and with the older program, and compare: the first line that differs names the event",
            found.event
        );
        good = found.event;
    };
    replay::<S>(scene)(Selection::every_thousandth(last), &mut compare).unwrap();
    assert_eq!(good, last);
}

fn all(scene: Scene, last: u32) {
    same::<f32>(scene, last);
    same::<f64>(scene, last);
    same::<I32F32>(scene, last);
}

#[test]
fn fig6() {
    all(Scene::Fig6, 10_000);
}

#[test]
fn box16() {
    all(Scene::Box16, 10_000);
}

#[test]
fn gas32() {
    all(Scene::Gas32, 10_000);
}

#[test]
fn column10() {
    all(Scene::Column10, 10_000);
}

#[test]
fn hourglass16() {
    all(Scene::Hourglass16, 10_000);
}

#[test]
#[ignore = "a while in a debug build: run with --release"]
fn a_hundred_thousand_events() {
    for scene in Scene::ALL {
        all(scene, 100_000);
    }
}
