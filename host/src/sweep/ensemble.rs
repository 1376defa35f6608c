//! What do all runs of a sweep give? Reads a sweep or the files of its shards; writes one row for each run, however they are split.

use super::plan::Plan;
use super::run::{self, Done, Journal};
use super::table::Rows;
use crate::columns::{Cell, Column, Kind};
use crate::progress::Progress;
use anyhow::{Context, Result, bail};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// What a call of [`sweep`] came to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The Parquet file.
    pub file: PathBuf,
    /// Runs in it.
    pub runs: usize,
    /// Runs that were done by this call.
    pub fresh: usize,
    /// Runs whose row holds an error.
    pub failed: usize,
}

/// The journal beside a shard's file.
fn journal_of(file: &Path) -> PathBuf {
    let mut path = file.to_owned().into_os_string();
    path.push(".journal");
    path.into()
}

/// Does those runs of a shard that are not done yet, on as many threads as rayon has, and writes its file.
///
/// # Errors
/// When the result or the journal cannot be written or is of another sweep. A run that fails is no
/// error: its row says why.
pub fn sweep(plan: &Plan, shard: [usize; 2], out: &Path) -> Result<Report> {
    let [i, n] = shard;
    let file =
        if n == 1 { out.to_owned() } else { out.with_extension(format!("{i}-of-{n}.parquet")) };
    let mine: Vec<usize> = (i - 1..plan.source.runs).step_by(n).collect();
    if file.exists() {
        return finished(plan, &file, shard);
    }
    if let Some(folder) = file.parent().filter(|folder| *folder != Path::new("")) {
        std::fs::create_dir_all(folder)
            .with_context(|| format!("cannot make {}", folder.display()))?;
    }
    let path = journal_of(&file);
    let (journal, mut done) = Journal::open(&path, &plan.source, shard)?;
    let fresh = finish(plan, &mine, &done, Mutex::new(journal))?;
    let (journal, fresh) = fresh;
    let report = (mine.len(), fresh.len());
    done.extend(fresh);
    done.sort_by_key(|done| done.run);
    if done.iter().map(|done| done.run).ne(mine) {
        bail!("{}: it holds runs twice or of another shard; remove it", path.display());
    }
    let rows = rows(plan, (n > 1).then_some(shard), &done)?;
    rows.write(&file)?;
    journal.remove()?;
    let failed = rows.failed();
    Ok(Report { file, runs: report.0, fresh: report.1, failed })
}

fn finished(plan: &Plan, file: &Path, shard: [usize; 2]) -> Result<Report> {
    let rows = Rows::read(file)?;
    if rows.source != plan.source || rows.shard.unwrap_or([1, 1]) != shard {
        bail!(
            "{} is the result of another sweep; remove it or choose another --out",
            file.display()
        );
    }
    let (runs, failed) = (rows.rows.len(), rows.failed());
    Ok(Report { file: file.to_owned(), runs, fresh: 0, failed })
}

/// Does what is not done.
fn finish(
    plan: &Plan,
    mine: &[usize],
    done: &[Done],
    journal: Mutex<Journal>,
) -> Result<(Journal, Vec<Done>)> {
    let known: std::collections::HashSet<usize> = done.iter().map(|done| done.run).collect();
    let left: Vec<usize> = mine.iter().copied().filter(|run| !known.contains(run)).collect();
    let bar = Progress::of_runs(mine.len() as u64, known.len() as u64);
    let one = |&number: &usize| -> Result<Done> {
        let done = run::execute(number, &plan.run(number)?);
        match journal.lock() {
            Ok(mut journal) => journal.add(&done)?,
            Err(_) => bail!("the journal was left half-written"),
        }
        bar.add(1);
        Ok(done)
    };
    let fresh = left.par_iter().with_max_len(1).map(one).collect::<Result<Vec<Done>>>()?;
    drop(bar);
    let journal = journal.into_inner();
    Ok((journal.map_err(|_| anyhow::anyhow!("the journal was left half-written"))?, fresh))
}

/// One row for each run: its number, what was set, what came out, what was measured, and the statistics of all runs.
fn rows(plan: &Plan, shard: Option<[usize; 2]>, done: &[Done]) -> Result<Rows> {
    let (statistics, measured) = (run::statistics(done), run::measured(done));
    let whole = |name: String| Column { name, kind: Kind::Whole };
    let mut columns = vec![whole("run".to_owned())];
    columns.extend(plan.columns());
    columns.extend(run::columns());
    let number = |name: String| Column { name, kind: Kind::Number };
    columns.extend(measured.iter().map(|name| number(format!("{MEASURED}{name}"))));
    columns.extend(statistics.iter().map(|name| whole(format!("{STATISTIC}{name}"))));
    let row = |done: &Done| -> Result<Vec<Cell>> {
        let mut row = vec![Cell::Whole(i64::try_from(done.run)?)];
        row.extend(plan.run(done.run)?.cells);
        row.extend(done.cells.iter().cloned());
        for name in &measured {
            let found = done.measured.iter().find(|(other, _)| other == name);
            row.push(found.map_or(Cell::Nothing, |(_, value)| Cell::Number(*value)));
        }
        for name in &statistics {
            let found = done.statistics.iter().find(|(other, _)| other == name);
            row.push(found.map_or(Ok(Cell::Nothing), |(_, n)| i64::try_from(*n).map(Cell::Whole))?);
        }
        Ok(row)
    };
    let rows = done.iter().map(row).collect::<Result<_>>()?;
    Ok(Rows { source: plan.source.clone(), shard, columns, rows })
}

impl Rows {
    /// How many rows hold an error.
    pub fn failed(&self) -> usize {
        let error = self.columns.iter().position(|column| column.name == "error");
        let failed = |row: &&Vec<Cell>| error.is_some_and(|e| row.get(e) != Some(&Cell::Nothing));
        self.rows.iter().filter(failed).count()
    }
}

/// Columns of what was measured and of statistics are called so: runs may differ in which they have.
const MEASURED: &str = "observed.";
const STATISTIC: &str = "statistics.";

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

/// Those of the first shard that all runs have, and then the others in alphabetical order.
fn columns(shards: &[Rows]) -> Vec<Column> {
    let may_lack =
        |column: &&Column| [MEASURED, STATISTIC].iter().any(|part| column.name.starts_with(part));
    let fixed = shards.iter().take(1).flat_map(|shard| &shard.columns);
    let others: BTreeMap<&str, &Column> = shards
        .iter()
        .flat_map(|shard| shard.columns.iter().filter(may_lack))
        .map(|column| (column.name.as_str(), column))
        .collect();
    fixed.filter(|column| !may_lack(column)).chain(others.into_values()).cloned().collect()
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
