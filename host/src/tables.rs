//! Which tables does the program look up? Reads the embedded tables, or makes one; writes nothing, returns coefficients.

use crate::collide::Restitution;
use anyhow::{Context, Result};
use carom::law::embedded;
use carom_tables::read::{End, Groups, Law, ScaledRestitution, Table};
use carom_tables::recipe::{GeneratedTable, Recipe};
use schemars::JsonSchema;
use serde::Deserialize;

/// The size of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Size {
    /// For the smallest microcontrollers.
    Compact,
    /// The default.
    Standard,
    /// The whole of MP13's Tables I and II.
    Wide,
    /// The same, ten times as exact.
    Fine,
}

impl Size {
    /// All of them, smallest first.
    pub const ALL: [Self; 4] = [Self::Compact, Self::Standard, Self::Wide, Self::Fine];

    /// As it is written on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Compact => "compact",
            Self::Standard => "standard",
            Self::Wide => "wide",
            Self::Fine => "fine",
        }
    }
}

/// An embedded table; its contacts end when the force vanishes.
pub fn embedded(size: Size, law: Law) -> &'static Table<f32> {
    match (size, law) {
        (Size::Compact, Law::LinearDashpot) => &embedded::compact::LINEAR_DASHPOT,
        (Size::Compact, Law::Viscoelastic) => &embedded::compact::VISCOELASTIC,
        (Size::Standard, Law::LinearDashpot) => &embedded::standard::LINEAR_DASHPOT,
        (Size::Standard, Law::Viscoelastic) => &embedded::standard::VISCOELASTIC,
        (Size::Wide, Law::LinearDashpot) => &embedded::wide::LINEAR_DASHPOT,
        (Size::Wide, Law::Viscoelastic) => &embedded::wide::VISCOELASTIC,
        (Size::Fine, Law::LinearDashpot) => &embedded::fine::LINEAR_DASHPOT,
        (Size::Fine, Law::Viscoelastic) => &embedded::fine::VISCOELASTIC,
    }
}

/// The embedded tables of one size.
#[derive(Clone, Copy, Debug)]
pub struct Embedded(
    /// Which size.
    pub Size,
);

impl Restitution for Embedded {
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>> {
        embedded(self.0, law).read(groups)
    }

    fn clamp(&self, law: Law, groups: &Groups<f64>) -> Groups<f64> {
        embedded(self.0, law).clamp(groups)
    }
}

/// Tables that are made when they are asked for.
#[derive(Clone, Debug)]
pub struct Generated(Vec<(Law, GeneratedTable<f32>)>);

impl Generated {
    /// Makes a table of this size for each of the laws.
    ///
    /// # Errors
    /// When there is no such table.
    pub fn new(size: Size, end: End, laws: &[Law]) -> Result<Self> {
        let recipe = match size {
            Size::Compact => Recipe::compact,
            Size::Standard => Recipe::standard,
            Size::Wide => Recipe::wide,
            Size::Fine => Recipe::fine,
        };
        let make = |law: &Law| {
            let made = recipe(*law).end(end).generate();
            Ok((*law, made.with_context(|| format!("no {} table", size.name()))?))
        };
        Ok(Self(laws.iter().map(make).collect::<Result<_>>()?))
    }

    fn made(&self, law: Law) -> Option<&GeneratedTable<f32>> {
        self.0.iter().find(|(known, _)| *known == law).map(|(_, made)| made)
    }
}

impl Restitution for Generated {
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>> {
        self.made(law)?.data().read(groups)
    }

    fn clamp(&self, law: Law, groups: &Groups<f64>) -> Groups<f64> {
        self.made(law).map_or(*groups, |made| made.data().domain.clamp(groups))
    }
}
