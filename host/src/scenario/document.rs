//! Is this TOML, and where does a field stand in it? Reads text; writes nothing, returns its tree and finds lines and columns.

use super::problem::Problem;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A text and what it says, each part with its place.
pub struct Document<'t> {
    text: &'t str,
    root: Spanned<DeTable<'t>>,
}

impl<'t> Document<'t> {
    /// Reads a text as far as it can be read, and lists all that is no TOML.
    pub fn parse(text: &'t str) -> (Self, Vec<Problem>) {
        let (root, errors) = DeTable::parse_recoverable(text);
        let problems = errors.iter().map(|error| {
            let span = error.span();
            let message = said(text, error.message(), span.clone());
            Problem { path: String::new(), offset: span.map(|span| span.start), message }
        });
        let problems = problems.collect();
        (Self { text, root }, problems)
    }

    /// The outermost table.
    pub fn root(&self) -> &DeTable<'t> {
        self.root.get_ref()
    }

    /// Line and column of a problem, both from 1.
    pub fn position(&self, problem: &Problem) -> (usize, usize) {
        let offset = problem.offset.unwrap_or_else(|| self.offset(&problem.path));
        position(self.text, offset)
    }

    /// Where the deepest part of the path begins that there is.
    fn offset(&self, path: &str) -> usize {
        let mut offset = 0;
        let mut table = Some(self.root());
        let mut list: Option<&[Spanned<DeValue<'t>>]> = None;
        for key in path.split('.') {
            let value = if let Some((name, value)) = table.and_then(|t| t.get_key_value(key)) {
                offset = name.span().start;
                value
            } else if let Some(value) = key.parse().ok().and_then(|k: usize| list?.get(k)) {
                offset = value.span().start;
                value
            } else {
                return offset;
            };
            table = value.get_ref().as_table();
            list = value.get_ref().as_array().map(|array| &array[..]);
        }
        offset
    }
}

/// Line and column of a byte, both from 1; columns count letters.
pub fn position(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line = 1 + before.matches('\n').count();
    let begin = before.rfind('\n').map_or(0, |at| at + 1);
    (line, 1 + before[begin..].chars().count())
}

/// A message of the TOML reader in one line; a key that is there twice is named.
pub fn said(text: &str, message: &str, span: Option<Range<usize>>) -> String {
    let message = message.trim().replace('\n', ", ");
    match span.and_then(|span| text.get(span)) {
        Some(key) if message == "duplicate key" => {
            format!("duplicate key `{}`", key.trim().replace('\n', " "))
        }
        _ => message,
    }
}
