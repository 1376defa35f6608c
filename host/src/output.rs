//! How does a result reach its file whole or not at all? Reads nothing; writes a file under a temporary name and renames it.

use anyhow::{Context, Result};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, SystemTime};
use tempfile::{NamedTempFile, TempPath};

/// Temporary files that exist now, so that an interrupt can remove them.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

const PREFIX: &str = ".carom-";
const SUFFIX: &str = ".part";

/// A draft that nobody has open and that is older than this was left by a program that was killed.
const ABANDONED: Duration = Duration::from_secs(60);

/// A file that appears under its name only when it is complete.
///
/// Until [`Draft::finish`] it has a temporary name in the same directory; dropping it removes it. A
/// name that is a symbolic link stays one: the file that it leads to is written. A name that is no
/// file (a pipe, `/dev/null`) is written as it is.
#[derive(Debug)]
pub struct Draft {
    file: BufWriter<File>,
    /// None if the target is no file.
    temporary: Option<TempPath>,
    target: PathBuf,
}

impl Draft {
    /// Opens a draft of the file `target`; its directory is made if need be, and drafts that killed
    /// programs left there are removed.
    ///
    /// # Errors
    /// When the directory or the temporary file cannot be made; the message names `target`.
    pub fn new(target: &Path) -> Result<Self> {
        Self::open(target).with_context(|| cannot(target))
    }

    fn open(target: &Path) -> io::Result<Self> {
        let target = destination(target)?;
        if fs::metadata(&target).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
            let file = BufWriter::new(File::options().write(true).open(&target)?);
            return Ok(Self { file, temporary: None, target });
        }
        let folder = folder(&target);
        fs::create_dir_all(folder)?;
        remove_abandoned(folder);
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX);
        // Readable by others, as far as the umask allows, like any file that a program makes.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let (file, temporary) = NamedTempFile::into_parts(builder.tempfile_in(folder)?);
        remember(&temporary);
        // Says that somebody is at it. Not every file system can; then nobody removes it either.
        let _ = file.try_lock();
        Ok(Self { file: BufWriter::new(file), temporary: Some(temporary), target })
    }

    /// Renames the draft to its name, replacing an older file of that name in one step.
    ///
    /// # Errors
    /// When the last bytes cannot be written or the rename is refused.
    pub fn finish(mut self) -> Result<()> {
        self.flush()?;
        let Self { file, temporary, target } = self;
        drop(file);
        let Some(temporary) = temporary else { return Ok(()) };
        let name = temporary.to_path_buf();
        let renamed = temporary.persist(&target).map_err(|failed| failed.error);
        renamed.with_context(|| cannot(&target))?;
        forget(&name);
        Ok(())
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|why| naming(&self.target, &why))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|why| naming(&self.target, &why))
    }
}

/// The same error with the file's name.
pub(crate) fn naming(file: &Path, why: &io::Error) -> io::Error {
    io::Error::new(why.kind(), format!("{}: {why}", cannot(file)))
}

fn cannot(file: &Path) -> String {
    format!("cannot write {}", file.display())
}

/// More links than this lead in a circle.
const LINKS: usize = 40;

/// The file that a name leads to, by symbolic links that need not end in a file.
fn destination(name: &Path) -> io::Result<PathBuf> {
    let mut path = name.to_owned();
    for _ in 0..LINKS {
        match fs::read_link(&path) {
            Ok(next) => path = folder(&path).join(next),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("its symbolic links lead in a circle"))
}

/// Moves a whole file to its name, replacing an older file in one step; a symbolic link of that name
/// stays one.
///
/// # Errors
/// When it cannot be moved; the message names `target`.
pub(crate) fn publish(file: &Path, target: &Path) -> Result<()> {
    let moved = || -> io::Result<()> {
        let to = destination(target)?;
        match fs::rename(file, &to) {
            // The link leads to another file system.
            Err(why) if why.kind() == io::ErrorKind::CrossesDevices => copy(file, &to),
            other => other,
        }
    };
    moved().with_context(|| cannot(target))
}

fn copy(file: &Path, target: &Path) -> io::Result<()> {
    let mut draft = Draft::open(target)?;
    io::copy(&mut File::open(file)?, &mut draft)?;
    draft.finish().map_err(io::Error::other)?;
    fs::remove_file(file)
}

/// Writes a whole file in one call.
///
/// # Errors
/// As [`Draft::new`] and [`Draft::finish`].
pub fn write_file(target: &Path, bytes: &[u8]) -> Result<()> {
    let mut draft = Draft::new(target)?;
    draft.write_all(bytes)?;
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

/// Removes the drafts of programs that are no more.
fn remove_abandoned(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let is_draft = |name: &str| name.starts_with(PREFIX) && name.ends_with(SUFFIX);
        if name.to_str().is_some_and(is_draft) && is_abandoned(&entry.path()).unwrap_or(false) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_abandoned(draft: &Path) -> io::Result<bool> {
    let file = File::open(draft)?;
    let age = SystemTime::now().duration_since(file.metadata()?.modified()?);
    Ok(age.is_ok_and(|age| age > ABANDONED) && file.try_lock().is_ok())
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
