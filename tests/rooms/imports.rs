//! Which files does each file of a crate import? Reads Rust source; writes a graph of files.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::visit::{self, Visit};

/// Files by what they import; names are paths from the crate's source folder.
pub type Graph = BTreeMap<PathBuf, BTreeSet<PathBuf>>;

/// A module's name from the crate's root, part by part.
type Module = Vec<String>;

/// The imports of all files below a source folder, between each other.
pub fn of(source: &Path) -> Graph {
    let files: Vec<PathBuf> = rust_files(source);
    let modules: BTreeMap<Module, PathBuf> =
        files.iter().map(|file| (module_of(file), file.clone())).collect();
    files.iter().map(|file| (file.clone(), imports(source, file, &modules))).collect()
}

/// The Rust files below a folder, named from there.
fn rust_files(source: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(source.join(&folder)).unwrap().map(Result::unwrap) {
            let name = folder.join(entry.file_name());
            if entry.path().join("Cargo.toml").exists() {
                continue; // a crate of its own
            } else if entry.path().is_dir() {
                folders.push(name);
            } else if name.extension().is_some_and(|e| e == "rs") {
                found.push(name);
            }
        }
    }
    found
}

/// `a/b.rs` and `a/b/mod.rs` are the module `a::b`; `lib.rs` and `main.rs` are the root.
fn module_of(file: &Path) -> Module {
    let parts = file.with_extension("");
    let parts = parts.iter().map(|part| part.to_str().unwrap().to_owned());
    parts.filter(|part| !matches!(part.as_str(), "mod" | "lib" | "main")).collect()
}

fn imports(source: &Path, file: &Path, modules: &BTreeMap<Module, PathBuf>) -> BTreeSet<PathBuf> {
    let text = fs::read_to_string(source.join(file)).unwrap();
    let mut reader = Reader { module: module_of(file), modules, found: BTreeSet::new() };
    reader.visit_file(&syn::parse_file(&text).unwrap());
    reader.found.remove(file);
    reader.found
}

/// Walks through one file and keeps the files that its paths lead to.
struct Reader<'a> {
    /// The module that the walk is in, inline ones included.
    module: Module,
    modules: &'a BTreeMap<Module, PathBuf>,
    found: BTreeSet<PathBuf>,
}

impl Reader<'_> {
    /// Keeps the file of the longest module that a path names.
    fn keep(&mut self, path: &[String]) {
        let Some(named) = self.absolute(path) else { return };
        let longest = (1..=named.len()).rev().find_map(|n| self.modules.get(&named[..n]));
        let root = || self.modules.get(&[][..]).filter(|_| path[0] == "crate");
        self.found.extend(longest.or_else(root).cloned());
    }

    /// A path from the crate's root; none for what another crate or the file itself names.
    fn absolute(&self, path: &[String]) -> Option<Module> {
        let mut from = self.module.clone();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" => (from, rest) = (Vec::new(), &path[1..]),
            "self" | "super" => {
                while let [first, next @ ..] = rest
                    && matches!(first.as_str(), "self" | "super")
                {
                    if first == "super" {
                        from.pop()?;
                    }
                    rest = next;
                }
            }
            child => {
                let module = [&from[..], &[child.to_owned()]].concat();
                self.modules.get(&module)?;
            }
        }
        Some([&from[..], rest].concat())
    }

    fn keep_tree(&mut self, before: &[String], tree: &syn::UseTree) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            syn::UseTree::Path(path) => self.keep_tree(&with(&path.ident), &path.tree),
            syn::UseTree::Name(name) => self.keep(&with(&name.ident)),
            syn::UseTree::Rename(rename) => self.keep(&with(&rename.ident)),
            syn::UseTree::Glob(_) => self.keep(before),
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.keep_tree(before, tree));
            }
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.keep_tree(&[], &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
        self.keep(&names);
        visit::visit_path(self, path);
    }

    /// `pub(crate)` imports nothing.
    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        self.module.push(item.ident.to_string());
        visit::visit_item_mod(self, item);
        self.module.pop();
    }
}
