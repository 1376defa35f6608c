//! What does one row say, and which columns are there? Reads and writes Parquet files, always the same bytes for the same rows.

use crate::columns::{Cell, Column, read_parquet, write_parquet};
use crate::output::Draft;
use anyhow::{Context, Result, anyhow};
use parquet::file::metadata::KeyValue;
use parquet::file::reader::{FileReader, SerializedFileReader};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Where a sweep comes from: two results belong together only if all of this is the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// The text of the sweep file.
    pub sweep: String,
    /// The text of the scenario file.
    pub scenario: String,
    /// The version of this program.
    pub version: String,
    /// How many runs there are.
    pub runs: usize,
}

/// Rows under columns, and where they come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// The sweep.
    pub source: Source,
    /// Which part of it, if not all: i of n.
    pub shard: Option<[usize; 2]>,
    /// The columns.
    pub columns: Vec<Column>,
    /// A cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

const SOURCE: &str = "carom.sweep";
const SHARD: &str = "carom.shard";

impl Rows {
    /// Writes a Parquet file, whole or not at all.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&self, file: &Path) -> Result<()> {
        let mut notes =
            vec![KeyValue::new(SOURCE.to_owned(), serde_json::to_string(&self.source)?)];
        if let Some([i, n]) = self.shard {
            notes.push(KeyValue::new(SHARD.to_owned(), format!("{i}/{n}")));
        }
        write_parquet(Draft::new(file)?, "sweep", notes, &self.columns, &self.rows)?.finish()
    }

    /// Reads a Parquet file that [`Rows::write`] wrote.
    ///
    /// # Errors
    /// When it cannot be read or is none.
    pub fn read(file: &Path) -> Result<Self> {
        let name = || file.display().to_string();
        let open =
            std::fs::File::open(file).with_context(|| format!("cannot read {}", file.display()))?;
        let reader = SerializedFileReader::new(open).with_context(name)?;
        let metadata = reader.metadata().file_metadata();
        let note = |key: &str| {
            let notes = metadata.key_value_metadata()?;
            notes.iter().find(|note| note.key == key)?.value.clone()
        };
        let source = note(SOURCE)
            .ok_or_else(|| anyhow!("{}: not the result of carom sweep", file.display()))?;
        let source = serde_json::from_str(&source).with_context(name)?;
        let shard = note(SHARD).map(|text| shard(&text)).transpose().map_err(|why| anyhow!(why))?;
        let (columns, rows) = read_parquet(&reader).with_context(name)?;
        Ok(Self { source, shard, columns, rows })
    }
}

/// Reads "i/n", the i-th of n shards.
///
/// # Errors
/// What would be right.
pub fn shard(text: &str) -> Result<[usize; 2], String> {
    let parts = text.split_once('/').and_then(|(i, n)| Some([i.parse().ok()?, n.parse().ok()?]));
    parts
        .filter(|&[i, n]: &[usize; 2]| i >= 1 && i <= n)
        .ok_or_else(|| format!("{text} is no shard, must be i/n with i from 1 to n"))
}
