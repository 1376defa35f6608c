//! Do the inputs that fuzzing found still run? Reads tests/data/fuzz; writes nothing.
//!
//! The bodies in `body/` are the ones that the targets in `fuzz/` hammer with bytes of their own.

mod body;

use std::fmt::Display;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

/// Every file of one corpus, in the order of their names.
fn corpus(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/fuzz").join(target);
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files.into_iter().map(|file| (file.clone(), std::fs::read(file).unwrap())).collect()
}

/// Runs a body on every file, says how each ended, and names those that break it.
fn replay<E: Display>(target: &str, at_least: usize, body: fn(&[u8]) -> Result<(), E>) {
    let files = corpus(target);
    assert!(files.len() >= at_least, "only {} files for {target}", files.len());
    let mut broken = Vec::new();
    for (file, bytes) in files {
        match catch_unwind(|| body(&bytes)) {
            Ok(Ok(())) => println!("{}: runs", file.display()),
            Ok(Err(why)) => println!("{}: {why:#}", file.display()),
            Err(_) => broken.push(file),
        }
    }
    assert!(broken.is_empty(), "{target} breaks on {broken:?}");
}

#[test]
fn worlds_from_bytes_hold() {
    replay("world", 8, body::world::run);
}

/// No files yet: bytes that look random.
#[test]
fn obstacles_from_bytes_hold() {
    let mut seed = 1_u32;
    for _ in 0..100 {
        let next = |_| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 24) as u8
        };
        let bytes: Vec<u8> = (0..160).map(next).collect();
        let _ = body::mesh::run(&bytes);
    }
}

#[test]
fn scenarios_from_text_hold() {
    replay("scenario", 6, body::scenario::run);
}

/// Found by hand: such a number of grains ended in a panic of the allocator.
#[test]
fn too_many_grains_are_refused() {
    let file = "tests/data/fuzz/scenario/manual-too-many.toml";
    let text = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
    let why = body::scenario::run(&text).unwrap_err().to_string();
    // How much memory there is, is the machine's affair.
    let wanted = "line 12: gas.count is 9000000000000000000: so many grains need 3780000000000.0 GB of memory";
    assert!(why.starts_with(wanted), "{why}");
}
