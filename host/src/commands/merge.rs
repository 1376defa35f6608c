//! `carom merge`: which file would one process have made? Reads the shards of a sweep; writes one Parquet file.

use crate::sweep;
use anyhow::Result;
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom merge`.
#[derive(Args, Debug)]
pub struct Options {
    /// The Parquet files of all shards, in any order.
    #[arg(required = true)]
    shards: Vec<PathBuf>,
    /// The merged file: the same bytes that one process writes.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Puts the shards together.
///
/// # Errors
/// Shards of different sweeps, runs that are missing or there twice, a file that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let rows = sweep::merge(&options.shards)?;
    rows.write(&options.out)?;
    let (file, count) = (options.out.display(), rows.rows.len());
    Ok(writeln!(std::io::stdout().lock(), "{file}: {count} runs")?)
}
