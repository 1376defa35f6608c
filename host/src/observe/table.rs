//! How is what was measured written down? Reads columns of numbers with units; writes CSV and Parquet, whole or not at all.

use crate::columns::{Cell, Column, Kind, write_parquet};
use crate::output::Draft;
use anyhow::Result;
use std::io::Write;
use std::path::Path;

/// Columns, whose heads have units, and rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// What it is, as part of a file's name.
    pub name: &'static str,
    /// The columns.
    pub columns: Vec<Column>,
    /// A cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// No rows under these heads, the first `words` columns of words and the others of numbers.
    pub fn new<H: Into<String>>(name: &'static str, words: usize, heads: Vec<H>) -> Self {
        let column = |(k, head): (usize, H)| {
            let kind = if k < words { Kind::Text } else { Kind::Number };
            Column { name: head.into(), kind }
        };
        Self {
            name,
            columns: heads.into_iter().enumerate().map(column).collect(),
            rows: Vec::new(),
        }
    }

    /// Writes STEM-NAME.csv and STEM-NAME.parquet; returns their names.
    ///
    /// # Errors
    /// When one cannot be written.
    pub fn write(&self, folder: &Path, stem: &str) -> Result<[String; 2]> {
        let names = ["csv", "parquet"].map(|end| format!("{stem}-{}.{end}", self.name));
        let mut rows = csv::Writer::from_writer(Draft::new(&folder.join(&names[0]))?);
        rows.write_record(self.columns.iter().map(|column| &column.name))?;
        for row in &self.rows {
            rows.write_record(row.iter().map(text))?;
        }
        rows.flush()?;
        let draft = rows.into_inner().map_err(|error| error.into_error())?;
        draft.finish()?;
        let draft = Draft::new(&folder.join(&names[1]))?;
        let mut draft = write_parquet(draft, self.name, Vec::new(), &self.columns, &self.rows)?;
        draft.flush()?;
        draft.finish()?;
        Ok(names)
    }
}

/// A number; nothing if there is none.
pub fn number(value: f64) -> Cell {
    if value.is_finite() { Cell::Number(value) } else { Cell::Nothing }
}

/// All digits, and no more.
fn text(cell: &Cell) -> String {
    match cell {
        Cell::Nothing => String::new(),
        Cell::Flag(flag) => flag.to_string(),
        Cell::Whole(number) => number.to_string(),
        Cell::Number(number) => format!("{number:?}"),
        Cell::Text(text) => text.clone(),
    }
}
