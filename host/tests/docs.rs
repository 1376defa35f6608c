//! Do the pages in docs/ say what the program says? Reads README.md, tables/README.md and docs/; writes nothing, makes the quick pages and tables again.

use carom_host::figure;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Figures that take seconds, even with little optimisation. The pages of the others carry the day they were made on.
const QUICK: [&str; 9] = [
    "bsfp14-7-path",
    "l94-1",
    "l94-2a",
    "l94-5",
    "l94-table1",
    "mp13-3",
    "mp13-4",
    "mp13-5",
    "mp13-6",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What a command prints, given as `carom table --markdown`.
fn printed(command: &str) -> String {
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    let output = Command::new(env!("CARGO_BIN_EXE_carom")).args(words).output().unwrap();
    assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Fails with the first line that differs.
fn assert_same(file: &str, command: &str, written: &str, printed: &str) {
    if written == printed {
        return;
    }
    let line = |text: &str, k: usize| text.lines().nth(k).unwrap_or("(nothing)").to_owned();
    let mut all = 0..written.lines().count().max(printed.lines().count());
    let k = all.find(|k| line(written, *k) != line(printed, *k)).unwrap_or(0);
    panic!(
        "{file} is not what `{command}` prints.\n  written: {}\n  printed: {}\n\
         If the new text is right: cargo run --release -p carom-host -- {} (and write its output there)",
        line(written, k),
        line(printed, k),
        command.trim_start_matches("carom ")
    );
}

#[test]
fn quick_pages_are_what_the_program_prints() {
    for id in QUICK {
        let (file, command) =
            (format!("docs/figures/{id}.md"), format!("carom figure {id} --markdown"));
        assert_same(&file, &command, &read(&file), &printed(&command));
    }
}

/// The text around the tables must be that of the source; the tables themselves take too long.
#[test]
fn long_pages_carry_their_text_and_the_day_they_were_made_on() {
    for entry in figure::all().filter(|entry| !QUICK.contains(&entry.id)) {
        let file = format!("docs/figures/{}.md", entry.id);
        let page = read(&file);
        let mut rest = page.as_str();
        for piece in entry.text.split_inclusive('\n').filter(|line| !line.starts_with("{{")) {
            let at = rest.find(piece).unwrap_or_else(|| {
                panic!(
                    "{file} lacks a line of host/src/figure/pages/{}.md: {piece}\
                     Where only the text has changed, copy it; else make the page again, by the command at its end",
                    entry.id
                )
            });
            rest = &rest[at + piece.len()..];
        }
        let made = page.lines().last().unwrap_or_default();
        let day = made.strip_prefix("This page was made on ").map(|rest| &rest[..10]);
        let day = day.unwrap_or_else(|| panic!("{file}: on which day was it made? {made:?}"));
        assert!(made.contains(&format!("`carom figure {} ", entry.id)), "{file}: {made}");
        assert!(made.ends_with(&format!("--date {day}`.")), "{file}: {made}");
    }
}

/// Markdown files under a folder.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let is_page = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "md");
    let below = folders.iter().flat_map(|folder| pages(folder));
    files.into_iter().filter(is_page).chain(below).collect()
}

const BEGIN: &str = "<!-- printed by: ";
const END: &str = "<!-- end -->";

/// Commands and what stands between their marks.
fn blocks(text: &str) -> Vec<(&str, &str)> {
    text.split(BEGIN).skip(1).filter_map(block).collect()
}

fn block(part: &str) -> Option<(&str, &str)> {
    let (command, rest) = part.split_once(" -->\n")?;
    Some((command, rest.split_once(END)?.0))
}

#[test]
fn tables_between_marks_are_what_the_program_prints() {
    let mut found = Vec::new();
    let others = ["README.md", "tables/README.md"].map(|name| root().join(name));
    let all = pages(&root().join("docs")).into_iter().chain(others);
    for path in all {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        let marked = blocks(&text);
        assert_eq!(marked.len(), text.matches(BEGIN).count(), "{name}: a mark without its end");
        for (command, written) in marked {
            assert_same(&name, command, written.trim(), printed(command).trim());
            found.push(command.to_owned());
        }
    }
    for command in ["carom table --markdown", "carom figure --markdown"] {
        assert!(found.iter().any(|one| one == command), "no page shows `{command}`");
    }
}

/// Links between pages must lead somewhere.
#[test]
fn links_lead_to_files() {
    let others = ["README.md", "ARCHITECTURE.md", "CHANGELOG.md"].map(|name| root().join(name));
    for path in pages(&root().join("docs")).into_iter().chain(others) {
        let text = fs::read_to_string(&path).unwrap();
        for target in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')) {
            let target = target.0.split('#').next().unwrap_or_default();
            if target.is_empty() || target.starts_with("http") {
                continue;
            }
            let leads = path.parent().unwrap().join(target);
            assert!(leads.exists(), "{}: no {target}", path.display());
        }
    }
}
