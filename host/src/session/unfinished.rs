//! Where does a run grow until it is whole? Reads and writes the folder `unfinished` beside its results; then moves what is in it there.

use crate::output;
use anyhow::{Context, Result, bail};
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

/// The folder in which the files of one run grow, for one process at a time.
#[derive(Debug)]
pub struct Unfinished {
    results: PathBuf,
    folder: PathBuf,
    /// Held as long as somebody is at it.
    _lock: File,
}

/// Says by its lock that somebody is at the folder.
const LOCK: &str = "lock";

impl Unfinished {
    /// The folder beside the results in this one; both are made if need be.
    ///
    /// # Errors
    /// When it cannot be made, or another process is at it.
    pub fn new(results: &Path) -> Result<Self> {
        let folder = results.join("unfinished");
        let cannot = || format!("cannot write {}", folder.display());
        fs::create_dir_all(&folder).with_context(cannot)?;
        let lock = File::create(folder.join(LOCK)).with_context(cannot)?;
        if let Err(TryLockError::WouldBlock) = lock.try_lock() {
            bail!("{}: another process is at this run; choose another --out", folder.display());
        }
        Ok(Self { results: results.to_owned(), folder, _lock: lock })
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// Removes what an earlier run left here.
    ///
    /// # Errors
    /// When it cannot be removed.
    pub fn clear(&self) -> Result<()> {
        let cannot = || format!("cannot clear {}", self.folder.display());
        for entry in fs::read_dir(&self.folder).with_context(cannot)? {
            let entry = entry.with_context(cannot)?;
            if entry.file_name() != LOCK && entry.path().is_file() {
                fs::remove_file(entry.path()).with_context(cannot)?;
            }
        }
        Ok(())
    }

    /// Moves whole files to the results, in this order, those that are there already left out; then the
    /// folder goes.
    ///
    /// # Errors
    /// When one cannot be moved.
    pub fn publish(self, names: &[String]) -> Result<Vec<PathBuf>> {
        let mut published = Vec::new();
        for name in names {
            let (from, to) = (self.folder.join(name), self.results.join(name));
            if from.exists() || !to.exists() {
                output::publish(&from, &to)?;
            }
            published.push(to);
        }
        self.clear()?;
        // Whoever put something of their own in here finds it here.
        let _ = fs::remove_file(self.folder.join(LOCK));
        let _ = fs::remove_dir(&self.folder);
        Ok(published)
    }
}
