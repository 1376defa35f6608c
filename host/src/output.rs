//! How does a result reach its file whole or not at all? Reads nothing; writes a file under a temporary name and renames it.

use anyhow::{Context, Result};
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use tempfile::{NamedTempFile, TempPath};

/// Temporary files that exist now, so that an interrupt can remove them.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A file that appears under its name only when it is complete.
///
/// Until [`Draft::finish`] it has a temporary name in the same directory; dropping it removes it.
#[derive(Debug)]
pub struct Draft {
    file: BufWriter<fs::File>,
    temporary: TempPath,
    target: PathBuf,
}

impl Draft {
    /// Opens a draft of the file `target`; its directory is made if need be.
    ///
    /// # Errors
    /// When the directory or the temporary file cannot be made; the message names `target`.
    pub fn new(target: &Path) -> Result<Self> {
        let cannot = || format!("cannot write {}", target.display());
        let folder = folder(target);
        fs::create_dir_all(folder).with_context(cannot)?;
        let mut builder = tempfile::Builder::new();
        builder.prefix(".carom-").suffix(".part");
        // Readable by others, as far as the umask allows, like any file that a program makes.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let temporary = builder.tempfile_in(folder);
        let (file, temporary) = NamedTempFile::into_parts(temporary.with_context(cannot)?);
        remember(&temporary);
        Ok(Self { file: BufWriter::new(file), temporary, target: target.to_owned() })
    }

    /// Renames the draft to its name, replacing an older file of that name in one step.
    ///
    /// # Errors
    /// When the last bytes cannot be written or the rename is refused.
    pub fn finish(self) -> Result<()> {
        let Self { mut file, temporary, target } = self;
        let cannot = || format!("cannot write {}", target.display());
        file.flush().with_context(cannot)?;
        drop(file);
        let name = temporary.to_path_buf();
        temporary.persist(&target).map_err(|failed| failed.error).with_context(cannot)?;
        forget(&name);
        Ok(())
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a whole file in one call.
///
/// # Errors
/// As [`Draft::new`] and [`Draft::finish`].
pub fn write_file(target: &Path, bytes: &[u8]) -> Result<()> {
    let mut draft = Draft::new(target)?;
    draft.write_all(bytes).with_context(|| format!("cannot write {}", target.display()))?;
    draft.finish()
}

/// Removes every draft that is not finished; for the handler of an interrupt.
pub fn discard_drafts() {
    if let Ok(pending) = PENDING.lock() {
        for path in pending.iter() {
            let _ = fs::remove_file(path);
        }
    }
}

fn folder(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

fn remember(path: &Path) {
    if let Ok(mut pending) = PENDING.lock() {
        pending.push(path.to_owned());
    }
}

fn forget(path: &Path) {
    if let Ok(mut pending) = PENDING.lock() {
        pending.retain(|other| other != path);
    }
}

/// True if the error is only that the reader of standard output has gone (`carom … | head`).
pub fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        let direct = cause.downcast_ref::<io::Error>();
        let from_csv = || match cause.downcast_ref::<csv::Error>()?.kind() {
            csv::ErrorKind::Io(error) => Some(error),
            _ => None,
        };
        direct.or_else(from_csv).is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe)
    })
}
