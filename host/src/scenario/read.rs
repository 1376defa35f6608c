//! How does a file become a scenario? Reads TOML; writes nothing, returns a checked scenario or names what is wrong.

use super::check::check;
use super::document::{Document, said};
use super::problem::Problem;
use super::schema::schema;
use super::shape::Shape;
use super::spec::{MethodName, Scenario};
use super::start::Start;
use anyhow::{Context, Result, anyhow, bail};
use std::path::Path;

/// Everything that is wrong with a text, each with its line and column.
pub type Found = Vec<((usize, usize), Problem)>;

impl Scenario {
    /// Reads a scenario file.
    ///
    /// # Errors
    /// One line that names file, line and field.
    pub fn read(file: &Path) -> Result<Self> {
        let name = file.display();
        let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
        Self::parse_in(&text, folder(file)).with_context(|| format!("{name}"))
    }

    /// Reads a scenario from text; files that it names are looked for in the working directory.
    ///
    /// # Errors
    /// One line that names line or field.
    ///
    /// ```
    /// use carom_host::scenario::Scenario;
    /// let text = "dimension = 1\nduration = 1.0\nsample = 0.1\n\
    ///     [law]\nkind = \"constant\"\nrestitution = 1.5\n\
    ///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]";
    /// let error = Scenario::parse(text).unwrap_err().to_string();
    /// assert_eq!(error, "line 6: law.restitution is 1.5, must be from 0 to 1");
    /// ```
    pub fn parse(text: &str) -> Result<Self> {
        Self::parse_in(text, Path::new(""))
    }

    /// The same, with files looked for in a folder.
    ///
    /// # Errors
    /// As [`Scenario::parse`].
    pub fn parse_in(text: &str, folder: &Path) -> Result<Self> {
        let (scenario, found) = examine(text, folder);
        match (found.first(), scenario) {
            (None, Some(scenario)) => Ok(scenario),
            (Some(((line, _), problem)), _) => {
                let more = match found.len() - 1 {
                    0 => String::new(),
                    more => format!(" ({more} more: carom scenario check)"),
                };
                bail!("line {line}: {problem}{more}")
            }
            (None, None) => bail!("this is no scenario"),
        }
    }

    /// The same scenario, run by this method only.
    ///
    /// # Errors
    /// When the law or the box does not allow it.
    pub fn with_method(self, method: MethodName) -> Result<Self> {
        let scenario = Self { methods: vec![method], ..self };
        match check(&scenario).0.first() {
            Some(problem) => Err(anyhow!("{problem}")),
            None => Ok(scenario),
        }
    }
}

fn folder(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
}

/// Line and column of a problem in a text, both from 1.
pub fn place_of(text: &str, problem: &Problem) -> (usize, usize) {
    Document::parse(text).0.position(problem)
}

/// Reads a text and finds everything that is wrong with it at once: what is no TOML, or else what is
/// no field, or else what cannot be. The scenario is there if nothing is wrong.
pub fn examine(text: &str, folder: &Path) -> (Option<Scenario>, Found) {
    let (document, mut problems) = Document::parse(text);
    let mut scenario = None;
    if problems.is_empty() {
        problems = Shape::check(schema(), document.root());
    }
    if problems.is_empty() {
        match toml::from_str::<Scenario>(text) {
            Ok(read) => {
                problems = check(&read).0;
                scenario = Some(Scenario { folder: folder.to_owned(), ..read });
            }
            Err(error) => {
                let span = error.span();
                let message = said(text, error.message(), span.clone());
                let offset = span.map(|span| span.start);
                problems.push(Problem { path: String::new(), offset, message });
            }
        }
    }
    let place = |problem: Problem| (document.position(&problem), problem);
    let mut found: Found = problems.into_iter().map(place).collect();
    found.sort_by_key(|(place, _)| *place);
    (scenario.filter(|_| found.is_empty()), found)
}

/// As [`examine`], and places the grains too, if nothing else is wrong.
///
/// # Errors
/// When the file cannot be read.
pub fn examine_file(file: &Path) -> Result<(Option<Start>, Found)> {
    let name = file.display();
    let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
    let (scenario, mut found) = examine(&text, folder(file));
    let start = match scenario.as_ref().map(Start::new) {
        Some(Err(error)) => {
            let message = || format!("{error:#}");
            let nowhere = || Problem { path: String::new(), offset: None, message: message() };
            let problem = error.downcast_ref::<Problem>().cloned().unwrap_or_else(nowhere);
            found.push((Document::parse(&text).0.position(&problem), problem));
            None
        }
        start => start.and_then(Result::ok),
    };
    Ok((start, found))
}
