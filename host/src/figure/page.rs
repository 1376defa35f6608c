//! How does a figure's page in docs/figures read? Reads a figure that was made and the text around its tables; writes Markdown.
//!
//! The text is `pages/ID.md`. Three lines of it stand for what the program knows:
//! `{{comparison}}` for the paper's numbers beside ours, `{{data}}` for the curves, a table for those that
//! share their abscissae, and `{{command}}` for the sentence that says how the page was made.

use super::data::{Entry, Figure, Made, Note, Series};
use super::number::{measured, significant};
use std::fmt::Write;

/// The folder of the pages, from the repository's root.
pub const FOLDER: &str = "docs/figures";

/// What a page says about how it was made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// With more statistics.
    pub full: bool,
    /// On which day; pages that take long to make carry it.
    pub date: Option<String>,
}

/// The page of a figure.
///
/// ```
/// use carom_host::figure::{self, page};
/// let entry = figure::find("l94-table1")?;
/// let made = (entry.make)(&figure::Options::default())?;
/// let text = page::page(entry, &made, &page::Origin::default());
/// assert!(text.starts_with("# L94 Table I"));
/// assert!(text.contains("`carom figure l94-table1 --markdown`"));
/// # Ok::<(), anyhow::Error>(())
/// ```
pub fn page(entry: &Entry, made: &Made, origin: &Origin) -> String {
    let mut text = String::new();
    for line in entry.text.lines() {
        match line {
            "{{comparison}}" => text.push_str(&comparison(&made.notes)),
            "{{data}}" => text.push_str(&data(&made.figure)),
            "{{command}}" => text.push_str(&command(entry.id, origin)),
            _ => text.push_str(line),
        }
        text.push('\n');
    }
    text
}

/// The command that makes the page.
pub fn command(id: &str, Origin { full, date }: &Origin) -> String {
    let full = if *full { " --full" } else { "" };
    let (option, day) = match date {
        Some(date) => (format!(" --date {date}"), format!(" on {date}")),
        None => Default::default(),
    };
    format!("This page was made{day} by `carom figure {id}{full} --markdown{option}`.")
}

/// The list of all pages, as docs/figures/README.md has it.
pub fn index<'a>(entries: impl Iterator<Item = &'a Entry>) -> String {
    let mut text = "| figure | what it shows |\n|---|---|\n".to_owned();
    for Entry { id, what, .. } in entries {
        let _ = writeln!(text, "| [{id}]({id}.md) | {} |", cell(what));
    }
    text
}

fn comparison(notes: &[Note]) -> String {
    let with_theory = notes.iter().any(|note| !note.theory.is_empty());
    let row = |[what, paper, theory, ours]: [&str; 4]| match with_theory {
        true => format!("| {what} | {paper} | {theory} | {ours} |"),
        false => format!("| {what} | {paper} | {ours} |"),
    };
    let mut text = row(["", "the paper says", "theory", "carom gets"]).replace("|  |", "| |");
    text.push('\n');
    text.push_str(&row(["---"; 4]).replace(' ', ""));
    for Note { what, paper, theory, ours } in notes {
        let cells = [what, paper, theory, ours].map(|text| cell(text));
        let _ = write!(text, "\n{}", row(cells.each_ref().map(String::as_str)));
    }
    text
}

/// One table for each run of curves with the same abscissae.
fn data(figure: &Figure) -> String {
    let tables: Vec<String> =
        figure.series.chunk_by(|a, b| a.x == b.x).map(|some| table(figure, some)).collect();
    tables.join("\n\n")
}

fn table(figure: &Figure, series: &[Series]) -> String {
    let x = series.first().map_or(&[][..], |first| &first.x);
    let head: Vec<String> = x.iter().map(|x| significant(*x, 3)).collect();
    let mut text = format!("| {} at {} = | ", cell(&figure.axes.y), cell(&figure.axes.x));
    let _ = write!(text, "{} |\n|---|{}", head.join(" | "), "---|".repeat(x.len()));
    for one in series {
        let at = |(k, y): (usize, &f64)| match one.yerr.get(k) {
            Some(error) => measured(*y, *error),
            None => significant(*y, 4),
        };
        let row: Vec<String> = one.y.iter().enumerate().map(at).collect();
        let _ = write!(text, "\n| {} | {} |", cell(&one.name), row.join(" | "));
    }
    text
}

/// Text that is safe in a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('*', "\\*")
}
