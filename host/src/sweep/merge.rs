//! Which file would one process have made of these shards? Reads their Parquet files; writes nothing, returns all rows.

use super::table::{Cell, Column, Rows};
use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Columns of counters are called so: runs may differ in which they have.
pub const COUNTER: &str = "counters.";

/// Puts the shards of one sweep together, in whatever order they are named.
///
/// # Errors
/// When they are of different sweeps, or runs are missing or there twice.
pub fn merge(files: &[PathBuf]) -> Result<Rows> {
    let shards = files.iter().map(|file| Rows::read(file)).collect::<Result<Vec<Rows>>>()?;
    let first = shards.first().context("no files to merge")?;
    for (shard, file) in shards.iter().zip(files) {
        if shard.source != first.source {
            bail!("{} is of another sweep than {}", file.display(), files[0].display());
        }
    }
    let columns = columns(&shards);
    let mut rows: Vec<Vec<Cell>> =
        shards.iter().flat_map(|shard| aligned(shard, &columns)).collect();
    rows.sort_by_key(|row| number(row));
    complete(&rows, first.source.runs)?;
    Ok(Rows { source: first.source.clone(), shard: None, columns, rows })
}

/// Those of the first shard that are not counters, and then all counters in alphabetical order.
fn columns(shards: &[Rows]) -> Vec<Column> {
    let is_counter = |column: &&Column| column.name.starts_with(COUNTER);
    let fixed = shards.iter().take(1).flat_map(|shard| &shard.columns);
    let counters: BTreeMap<&str, &Column> = shards
        .iter()
        .flat_map(|shard| shard.columns.iter().filter(is_counter))
        .map(|column| (column.name.as_str(), column))
        .collect();
    fixed.filter(|column| !is_counter(column)).chain(counters.into_values()).cloned().collect()
}

/// The rows of a shard with a cell for each of these columns.
fn aligned<'r>(shard: &'r Rows, columns: &[Column]) -> impl Iterator<Item = Vec<Cell>> + use<'r> {
    let places: Vec<Option<usize>> = columns
        .iter()
        .map(|column| shard.columns.iter().position(|other| other.name == column.name))
        .collect();
    shard.rows.iter().map(move |row| {
        let cell = |place: &Option<usize>| place.map_or(Cell::Nothing, |place| row[place].clone());
        places.iter().map(cell).collect()
    })
}

/// The number of a row's run.
fn number(row: &[Cell]) -> i64 {
    match row.first() {
        Some(Cell::Whole(number)) => *number,
        _ => -1,
    }
}

fn complete(rows: &[Vec<Cell>], runs: usize) -> Result<()> {
    for (expected, row) in rows.iter().map(|row| number(row)).enumerate() {
        match usize::try_from(row) {
            Ok(run) if run == expected => {}
            Ok(run) if run < expected => bail!("run {run} is there twice; name each shard once"),
            _ => bail!("run {expected} is missing; name all shards"),
        }
    }
    if rows.len() != runs {
        bail!("there are {} runs, must be {runs}; name all shards", rows.len());
    }
    Ok(())
}
