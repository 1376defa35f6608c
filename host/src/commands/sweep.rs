//! `carom sweep`, `carom merge`: what do many runs come to? Reads a sweep file or its shards; writes a Parquet file with a row for each run.

use crate::sweep::{self, Plan};
use anyhow::{Context, Result};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom sweep`.
#[derive(Args, Debug)]
pub struct SweepOptions {
    /// The sweep (TOML); examples/sweep has one that is explained.
    sweep: PathBuf,
    /// The result; SWEEP.parquet beside the sweep if left out. A shard adds its number.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Only the i-th of n parts, as `carom merge` puts them together.
    #[arg(long, value_name = "I/N", default_value = "1/1", value_parser = sweep::shard)]
    shard: [usize; 2],
    /// How many runs at a time; one on each core if left out.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

/// Does all runs that are not done yet.
///
/// # Errors
/// A sweep that cannot be read or run, a file that cannot be written.
pub fn sweep(options: &SweepOptions) -> Result<()> {
    let plan = Plan::read(&options.sweep)?;
    let out = options.out.clone().unwrap_or_else(|| options.sweep.with_extension("parquet"));
    let threads = options.threads.map_or(0, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.context("cannot start the threads")?;
    let report = pool.install(|| sweep::sweep(&plan, options.shard, &out))?;
    let sweep::Report { file, runs, fresh, failed } = report;
    let before = runs - fresh;
    let mut sink = std::io::stdout().lock();
    writeln!(sink, "{}: {runs} runs, {before} of them done before", file.display())?;
    if failed > 0 {
        writeln!(sink, "{failed} of them failed: column error says why")?;
    }
    Ok(())
}

/// The options of `carom merge`.
#[derive(Args, Debug)]
pub struct MergeOptions {
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
pub fn merge(options: &MergeOptions) -> Result<()> {
    let rows = sweep::merge(&options.shards)?;
    rows.write(&options.out)?;
    let (file, count) = (options.out.display(), rows.rows.len());
    Ok(writeln!(std::io::stdout().lock(), "{file}: {count} runs")?)
}
