//! What did one run come to, and which are done already? Runs it; writes a line in a journal, which a kill may cut short.

use super::plan::Run;
use super::table::Source;
use crate::columns::{Cell, Column, Kind};
use crate::method::{self, Method};
use crate::observe::Recorder;
use crate::run::{self, Attendant, Plan, Position};
use crate::scenario::Start;
use anyhow::{Context, Result, anyhow, bail};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A run that is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// Its number.
    pub run: usize,
    /// A cell for each of [`columns`].
    pub cells: Vec<Cell>,
    /// How often everything happened.
    pub statistics: Vec<(String, u64)>,
    /// What was measured, with errors, those left out that are not known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub measured: Vec<(String, f64)>,
}

/// The columns of a result; statistics follow.
pub fn columns() -> Vec<Column> {
    let named = [
        ("grains", Kind::Whole),
        ("time", Kind::Number),
        ("contacts", Kind::Whole),
        ("kinetic_energy_start", Kind::Number),
        ("kinetic_energy", Kind::Number),
        ("error", Kind::Text),
    ];
    named.map(|(name, kind)| Column { name: name.to_owned(), kind }).to_vec()
}

/// The names of all statistics of all runs, in alphabetical order.
pub fn statistics(all: &[Done]) -> BTreeSet<&str> {
    all.iter().flat_map(|done| done.statistics.iter().map(|(name, _)| name.as_str())).collect()
}

/// The heads of everything that was measured in some run, in alphabetical order.
pub fn measured(all: &[Done]) -> BTreeSet<&str> {
    all.iter().flat_map(|done| done.measured.iter().map(|(name, _)| name.as_str())).collect()
}

/// Runs one run to its end. A run that fails is done as well: its row says why.
pub fn execute(number: usize, run: &Run) -> Done {
    match finish(number, run) {
        Ok(done) => done,
        Err(error) => {
            let mut cells = vec![Cell::Nothing; columns().len() - 1];
            cells.push(Cell::Text(format!("{error:#}")));
            Done { run: number, cells, statistics: Vec::new(), measured: Vec::new() }
        }
    }
}

fn finish(number: usize, asked: &Run) -> Result<Done> {
    let start = Start::new(&asked.scenario)?;
    method::with(asked.method, &asked.scenario, &start, |method| {
        let before = method.kinetic_energy();
        let (plan, mut position) = (Plan::new(&asked.scenario), Position::default());
        let mut alone = Alone(Recorder::new(&asked.scenario, &start, None)?);
        run::attend(method, &plan, &mut position, &mut alone)?.whole()?;
        let whole = |count: u64| Cell::Whole(i64::try_from(count).unwrap_or(i64::MAX));
        let cells = vec![
            whole(start.grains.len() as u64),
            number_cell(method.time()),
            whole(method.collisions()),
            number_cell(before),
            number_cell(method.kinetic_energy()),
            Cell::Nothing,
        ];
        let statistics = method.statistics().into_iter();
        let statistics = statistics.map(|(name, count)| (name.to_owned(), count)).collect();
        Ok(Done { run: number, cells, statistics, measured: alone.measured() })
    })
}

/// Nobody looks on, but for what is measured.
struct Alone(Option<Recorder>);

impl Attendant for Alone {
    fn sample(&mut self, _: &mut dyn Method, _: f64) -> Result<()> {
        Ok(())
    }

    fn look(&mut self, method: &mut dyn Method, time: f64) {
        let tally = method.take_tally();
        if let Some(recorder) = &mut self.0 {
            recorder.look(time, &tally, &method.grains());
        }
    }
}

impl Alone {
    /// Every mean, and its error where there is one.
    fn measured(&self) -> Vec<(String, f64)> {
        let means = self.0.iter().flat_map(Recorder::means);
        let both = means.flat_map(|(quantity, mean)| {
            [(quantity.head(""), mean.value), (quantity.head(" error"), mean.error)]
        });
        both.filter(|(_, value)| value.is_finite()).collect()
    }
}

fn number_cell(number: f64) -> Cell {
    if number.is_finite() { Cell::Number(number) } else { Cell::Nothing }
}

/// The first line.
#[derive(PartialEq, Eq, Serialize, Deserialize)]
struct Head {
    source: Source,
    shard: [usize; 2],
}

/// A file that grows by one line with each run; the line is written in one piece.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
}

impl Journal {
    /// Opens the journal of a sweep, or begins it; returns what is done. A last line that was cut
    /// short is cut off: its run will be done again.
    ///
    /// # Errors
    /// When it belongs to another sweep, or another process is at it.
    pub fn open(path: &Path, source: &Source, shard: [usize; 2]) -> Result<(Self, Vec<Done>)> {
        let name = path.display();
        let cannot = || format!("cannot write {name}");
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(path).with_context(cannot)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => bail!("{name}: another process is at this sweep"),
            Err(TryLockError::Error(why)) => return Err(why).with_context(cannot),
        }
        let mut text = Vec::new();
        file.read_to_end(&mut text).with_context(|| format!("cannot read {name}"))?;
        let head = Head { source: source.clone(), shard };
        let (done, length) = read(&text, &head).ok_or_else(|| {
            anyhow!("{name} is of another sweep; remove it or choose another --out")
        })?;
        file.set_len(length as u64).with_context(cannot)?;
        file.seek(SeekFrom::End(0)).with_context(cannot)?;
        let mut journal = Self { file, path: path.to_owned() };
        if length == 0 {
            journal.line(&head)?;
        }
        Ok((journal, done))
    }

    /// One more run is done.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, done: &Done) -> Result<()> {
        self.line(done)
    }

    fn line(&mut self, line: &impl Serialize) -> Result<()> {
        let mut text = serde_json::to_vec(line)?;
        text.push(b'\n');
        self.file.write_all(&text).with_context(|| format!("cannot write {}", self.path.display()))
    }

    /// The sweep is done and its result written: the journal goes.
    ///
    /// # Errors
    /// When it cannot be removed.
    pub fn remove(self) -> Result<()> {
        std::fs::remove_file(&self.path)
            .with_context(|| format!("cannot remove {}", self.path.display()))
    }
}

/// The runs, and up to where the text is whole; none if it is of another sweep.
fn read(text: &[u8], head: &Head) -> Option<(Vec<Done>, usize)> {
    let mut done = Vec::new();
    let mut length = 0;
    for line in text.split_inclusive(|&byte| byte == b'\n').filter(|line| line.ends_with(b"\n")) {
        if length == 0 {
            let first: Head = serde_json::from_slice(line).ok()?;
            if first != *head {
                return None;
            }
        } else {
            let Ok(run) = serde_json::from_slice(line) else { break };
            done.push(run);
        }
        length += line.len();
    }
    Some((done, length))
}
