//! Which figures of the papers can be made? Reads an id; writes nothing, returns the figure, its picture and the comparison.
//!
//! A figure is made by a function of [`Options`] that is listed in its paper's `FIGURES`. Its data are
//! a [`Figure`], whose serde form is what `carom figure ID --json` prints; its picture is a
//! [`Scene`], in most cases drawn by [`draw::draw`] from the data; and [`Note`]s set the paper's numbers beside ours.

pub mod bsfp14;
mod data;
pub mod draw;
pub mod hard;
pub mod l94;
pub mod mp13;
mod progress;
pub mod table;

pub use data::{Axes, Figure, Series, Value};
pub use progress::Progress;

use crate::plot::Scene;
use anyhow::{Result, bail};

/// How a figure is to be made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// With the paper's statistics, however long that takes; otherwise in under two minutes.
    pub full: bool,
}

/// What the paper says and what we get.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Of what.
    pub what: String,
    /// What the paper says, or "not given".
    pub paper: String,
    /// What we get.
    pub ours: String,
}

impl Note {
    /// One line of the comparison.
    pub fn new(what: impl Into<String>, paper: impl Into<String>, ours: impl Into<String>) -> Self {
        Self { what: what.into(), paper: paper.into(), ours: ours.into() }
    }
}

/// A figure that was made.
#[derive(Clone, Debug)]
pub struct Made {
    /// Its data.
    pub figure: Figure,
    /// Its picture.
    pub picture: Scene,
    /// The comparison with the paper.
    pub notes: Vec<Note>,
}

/// A figure that can be made.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name: paper and number.
    pub id: &'static str,
    /// What it shows, in one line.
    pub what: &'static str,
    /// Makes it.
    pub make: fn(&Options) -> Result<Made>,
}

/// All figures, in the order in which they are listed.
pub fn all() -> impl Iterator<Item = &'static Entry> {
    bsfp14::FIGURES.iter().chain(l94::FIGURES).chain(mp13::FIGURES)
}

/// The figure with this id.
///
/// # Errors
/// When there is none; the message lists those that there are.
///
/// ```
/// use carom_host::figure;
/// assert!(figure::find("bsfp14-7").is_ok());
/// assert!(figure::find("fig7").unwrap_err().to_string().contains("bsfp14-7"));
/// ```
pub fn find(id: &str) -> Result<&'static Entry> {
    if let Some(entry) = all().find(|entry| entry.id == id) {
        return Ok(entry);
    }
    let ids: Vec<_> = all().map(|entry| entry.id).collect();
    bail!("figure {id:?} is not known; there are {}", ids.join(", "))
}
