//! How does a file of a run grow, and go on where a checkpoint left it? Reads nothing but its length; writes a file that is not whole yet.

use crate::output::naming;
use anyhow::{Context, Result};
use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file that grows; what can go wrong with it names it.
#[derive(Debug)]
pub struct Growing {
    file: BufWriter<File>,
    path: PathBuf,
}

impl Growing {
    /// An empty file.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn new(path: &Path) -> Result<Self> {
        Self::from_length(path, 0)
    }

    /// The file as it was when it had so many bytes; what came later is cut off.
    ///
    /// # Errors
    /// When it is shorter, or cannot be opened.
    pub fn from_length(path: &Path, length: u64) -> Result<Self> {
        let open = || -> io::Result<File> {
            let create = length == 0;
            let mut file =
                OpenOptions::new().write(true).create(create).truncate(false).open(path)?;
            let there = file.metadata()?.len();
            if there < length {
                return Err(io::Error::other(format!("it has {there} bytes, must have {length}")));
            }
            file.set_len(length)?;
            file.seek(SeekFrom::Start(length))?;
            Ok(file)
        };
        let file = open().with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self { file: BufWriter::new(file), path: path.to_owned() })
    }

    /// How long the file is, what is not flushed left out. So much is on the disk then, and stays there if
    /// the power fails.
    ///
    /// # Errors
    /// When something cannot be written.
    pub fn secured(&self) -> Result<u64> {
        let mut file = self.file.get_ref();
        let secured = file.sync_data().and_then(|()| file.stream_position());
        Ok(secured.map_err(|why| naming(&self.path, &why))?)
    }
}

impl Write for Growing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|why| naming(&self.path, &why))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|why| naming(&self.path, &why))
    }
}
