//! Which tables does the program look up? Reads the embedded tables; writes nothing, returns coefficients.

use crate::collide::Restitution;
use anyhow::{Result, bail};
use carom::law::tables as embedded;
use carom_tables::{End, Groups, Law, Scaled, Table};
use clap::ValueEnum;
use serde::Deserialize;

/// The size of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Size {
    /// For the smallest microcontrollers.
    Compact,
    /// The default.
    Standard,
    /// The whole of MP13's Tables I and II.
    Wide,
}

impl Size {
    /// All of them, smallest first.
    pub const ALL: [Self; 3] = [Self::Compact, Self::Standard, Self::Wide];

    /// As it is written on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Compact => "compact",
            Self::Standard => "standard",
            Self::Wide => "wide",
        }
    }
}

/// One table a law.
#[derive(Clone, Copy, Debug)]
pub struct Tables {
    linear: &'static Table<f32>,
    viscoelastic: &'static Table<f32>,
}

impl Tables {
    /// The tables of one size.
    ///
    /// # Errors
    /// When there is no table of that size.
    pub fn new(size: Size, end: End) -> Result<Self> {
        match (size, end) {
            (Size::Standard, End::Force) => Ok(Self {
                linear: &embedded::standard::LINEAR_DASHPOT,
                viscoelastic: &embedded::standard::VISCOELASTIC,
            }),
            _ => bail!("no {} table for this end of contact", size.name()),
        }
    }

    /// The table of one law.
    pub fn table(&self, law: Law) -> &'static Table<f32> {
        match law {
            Law::LinearDashpot => self.linear,
            Law::Viscoelastic => self.viscoelastic,
        }
    }
}

impl Restitution for Tables {
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<Scaled<f64>> {
        self.table(law).read(groups)
    }

    fn clamp(&self, law: Law, groups: &Groups<f64>) -> Groups<f64> {
        self.table(law).clamp(groups)
    }
}
