//! Does each room look down only? Reads the `use` lines and paths of core/; writes nothing.

use std::fs;
use std::path::{Path, PathBuf};

/// From the lowest to the highest. `fault` names things of all rooms below `world`.
const ROOMS: [&str; 5] = ["number", "matter", "law", "event", "world"];

fn files(dir: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(dir).unwrap().map(Result::unwrap) {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found
}

fn core() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("core")
}

#[test]
fn every_room_looks_down_only() {
    let mut looked = 0;
    for (height, room) in ROOMS.iter().enumerate() {
        for file in files(&core().join(room)) {
            let text = fs::read_to_string(&file).unwrap();
            let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
            for line in code {
                for above in &ROOMS[height + 1..] {
                    let path = format!("crate::{above}");
                    assert!(!line.contains(&path), "{} looks up: {line}", file.display());
                    looked += 1;
                }
            }
        }
    }
    assert!(looked > 1000);
}

#[test]
fn every_file_has_its_sign_and_is_short() {
    for file in files(&core()) {
        let text = fs::read_to_string(&file).unwrap();
        let sign = text.lines().next().unwrap();
        assert!(sign.starts_with("//! ") && sign.contains('?'), "{}: {sign}", file.display());
        assert!(text.lines().count() <= 320, "{} is too long", file.display());
    }
}
