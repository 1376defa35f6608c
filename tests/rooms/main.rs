//! Does every file look down only? Reads the imports of all crates of the workspace; writes nothing.
//!
//! Direction is checked, not form: no circle between the files of a crate, no room of the core that
//! imports from a room above it, and a judge that shares nothing with what it judges.

mod imports;

use imports::Graph;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The rooms of the core, from the lowest to the highest.
const ROOMS: [&str; 10] = [
    "scalar", "particle", "error", "space", "law", "detect", "schedule", "cluster", "resolve",
    "world",
];

/// Where the crates' sources are.
const SOURCES: [&str; 9] = [
    "core",
    "tables/src",
    "host/src",
    "host/reference/src",
    "examples/c/src",
    "examples/python/src",
    "examples/scenes/src",
    "examples/tilt-box/scene/src",
    "examples/web/src",
];

fn graph(source: &str) -> Graph {
    imports::of(&Path::new(env!("CARGO_MANIFEST_DIR")).join(source))
}

/// Files that import each other in a circle, if there are any.
fn circle(graph: &Graph) -> Option<Vec<PathBuf>> {
    let mut done = BTreeSet::new();
    graph.keys().find_map(|file| circle_from(graph, file, &mut Vec::new(), &mut done))
}

fn circle_from(
    graph: &Graph,
    file: &PathBuf,
    way: &mut Vec<PathBuf>,
    done: &mut BTreeSet<PathBuf>,
) -> Option<Vec<PathBuf>> {
    if let Some(start) = way.iter().position(|before| before == file) {
        return Some(way[start..].to_vec());
    }
    if done.contains(file) {
        return None;
    }
    way.push(file.clone());
    let found = graph.get(file)?.iter().find_map(|next| circle_from(graph, next, way, done));
    way.pop();
    done.insert(file.clone());
    found
}

/// The room that a file of the core stands in; none for `lib.rs`.
fn height(file: &Path) -> Option<usize> {
    let room = file.iter().next()?.to_str()?.trim_end_matches(".rs");
    ROOMS.iter().position(|&name| name == room)
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    for source in SOURCES {
        let graph = graph(source);
        assert!(graph.values().any(|imports| !imports.is_empty()), "{source}: nothing was read");
        assert_eq!(circle(&graph), None, "{source}: these files import each other in a circle");
    }
}

#[test]
fn every_room_of_the_core_imports_from_below_only() {
    let graph = graph("core");
    let heights: BTreeSet<_> = graph.keys().filter_map(|file| height(file)).collect();
    assert_eq!(heights.len(), ROOMS.len(), "a room has no files");
    for (file, imports) in &graph {
        let Some(here) = height(file) else { continue };
        for import in imports {
            let there = height(import);
            assert!(there.is_some_and(|there| there <= here), "{file:?} imports {import:?}");
        }
    }
}

#[test]
fn the_judge_depends_on_nothing_that_it_judges() {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("host/reference/Cargo.toml");
    let text = std::fs::read_to_string(manifest).unwrap();
    let dependencies = text.split("[dependencies]").nth(1).unwrap().split("[dev-").next().unwrap();
    for crate_name in ["carom", "carom-tables", "carom-host"] {
        let named = |line: &str| line.split(['.', ' ', '=']).next() == Some(crate_name);
        assert!(!dependencies.lines().any(named), "the judge depends on {crate_name}");
    }
}

#[test]
fn a_circle_is_found() {
    let files = ["a.rs", "b.rs", "c.rs"].map(PathBuf::from);
    let [a, b, c] = files.clone();
    let of = |file: &PathBuf| BTreeSet::from([file.clone()]);
    let round = Graph::from([(a.clone(), of(&b)), (b.clone(), of(&c)), (c.clone(), of(&a))]);
    assert_eq!(circle(&round), Some(files.to_vec()));
    let straight = Graph::from([(a, of(&b)), (b, of(&c)), (c, BTreeSet::new())]);
    assert_eq!(circle(&straight), None);
}
