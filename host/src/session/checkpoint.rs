//! How is a run kept so that it can go on? Reads and writes one file, whole or not at all, which says of what it is.

use super::summary::MethodSummary;
use crate::run::Position;
use anyhow::{Context, Result, bail, ensure};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Of what a run is: a checkpoint of another is refused.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    /// The version of this program: another one may have other bits.
    pub version: String,
    /// The scenario as its file says it, and the methods.
    pub scenario: String,
    /// A checksum of the grains and the box at time 0.
    pub start: u32,
}

impl Identity {
    /// What a scenario, its methods and its start are known by.
    ///
    /// # Errors
    /// When the start cannot be put into bytes.
    pub fn new(scenario: String, start: &impl Serialize) -> Result<Self> {
        let start = crc32fast::hash(&postcard::to_stdvec(start)?);
        Ok(Self { version: env!("CARGO_PKG_VERSION").to_owned(), scenario, start })
    }
}

/// A run, as far as it has come.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The methods that are through.
    pub runs: Vec<MethodSummary>,
    /// The one that is not.
    pub current: Option<State>,
}

/// One method and its files, as far as they have come.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    /// How far it has come.
    pub position: Position,
    /// How long its files are.
    pub lengths: Vec<u64>,
    /// Its last sample.
    pub last: Option<MethodSummary>,
    /// The method's own state.
    pub method: Vec<u8>,
    /// What was measured.
    pub measured: Option<Vec<u8>>,
}

/// The file that holds a checkpoint.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    identity: Identity,
}

const NAME: &str = "checkpoint";
/// The first bytes; the number is that of the format.
const MAGIC: &[u8] = b"carom checkpoint 3\n";

impl Store {
    /// The checkpoint of such a run in this folder.
    pub fn new(folder: &Path, identity: Identity) -> Self {
        Self { folder: folder.to_owned(), identity }
    }

    fn path(&self) -> PathBuf {
        self.folder.join(NAME)
    }

    /// What a summary says of whose it is.
    pub fn known_by(&self) -> String {
        let Identity { version, scenario, start } = &self.identity;
        format!("carom {version} {:08x}{start:08x}", crc32fast::hash(scenario.as_bytes()))
    }

    /// Writes the checkpoint: at any instant there is the one before or this one, whole.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&self, checkpoint: &Checkpoint) -> Result<()> {
        let new = self.folder.join("checkpoint.new");
        let mut bytes = MAGIC.to_vec();
        for part in [postcard::to_stdvec(&self.identity)?, postcard::to_stdvec(checkpoint)?] {
            bytes.extend((part.len() as u64).to_le_bytes());
            bytes.extend(crc32fast::hash(&part).to_le_bytes());
            bytes.extend(part);
        }
        let write = || -> io::Result<()> {
            let mut file = File::create(&new)?;
            file.write_all(&bytes)?;
            file.sync_all()?;
            fs::rename(&new, self.path())
        };
        write().with_context(|| format!("cannot write {}", self.path().display()))
    }

    /// The checkpoint, if there is one.
    ///
    /// # Errors
    /// When it is of another run or version, or damaged.
    pub fn read(&self) -> Result<Option<Checkpoint>> {
        let path = self.path();
        let name = path.display();
        let bytes = match fs::read(&path) {
            Err(why) if why.kind() == io::ErrorKind::NotFound => return Ok(None),
            other => other.with_context(|| format!("cannot read {name}"))?,
        };
        self.parse(&bytes).with_context(|| name.to_string()).map(Some)
    }

    fn parse(&self, bytes: &[u8]) -> Result<Checkpoint> {
        let Some(mut rest) = bytes.strip_prefix(MAGIC) else {
            bail!("not a checkpoint of this version of carom; without --restart it begins anew");
        };
        let identity: Identity = part(&mut rest)?;
        let Identity { version, scenario, start } = &self.identity;
        ensure!(
            identity.version == *version,
            "written by carom {}, and this is {version}: go on with that one, or begin anew without --restart",
            identity.version
        );
        ensure!(
            identity.scenario == *scenario && identity.start == *start,
            "of another scenario (or other methods): go on with that one, or begin anew without --restart"
        );
        part(&mut rest)
    }

    /// A checkpoint is of no use any more.
    ///
    /// # Errors
    /// When it cannot be removed.
    pub fn remove(&self) -> Result<()> {
        match fs::remove_file(self.path()) {
            Err(why) if why.kind() == io::ErrorKind::NotFound => Ok(()),
            other => other.with_context(|| format!("cannot remove {}", self.path().display())),
        }
    }
}

/// The next part: its length, its checksum and itself.
fn part<T: DeserializeOwned>(rest: &mut &[u8]) -> Result<T> {
    let damaged = "damaged; without --restart it begins anew";
    let mut take = |length: usize| -> Result<&[u8]> {
        let (head, tail) = rest.split_at_checked(length).context(damaged)?;
        *rest = tail;
        Ok(head)
    };
    let length = u64::from_le_bytes(take(8)?.try_into()?);
    let checksum = u32::from_le_bytes(take(4)?.try_into()?);
    let part = take(usize::try_from(length)?)?;
    ensure!(crc32fast::hash(part) == checksum, damaged);
    postcard::from_bytes(part).context(damaged)
}
