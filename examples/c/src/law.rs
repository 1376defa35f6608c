//! Which laws can C choose? Reads their parameters; answers as the engine's own rules do.

use crate::error::carom_error;
use carom::error::Subject;
use carom::law::embedded::read::Table;
use carom::law::embedded::{Compact, TableSet};
use carom::law::{
    Answer, ContactForce, Enduring, ForceLaw, HardSphere, Impact, LinearDashpot, Outside, Response,
    Rule, Soft, Viscoelastic,
};
use carom::{Error, Scalar};

/// The compact tables: about 2 KB a law, errors up to 1.5e-4.
pub const CAROM_TABLE_COMPACT: i32 = 0;
/// The standard tables: about 20 KB a law, errors up to 1.1e-6. The library has them if it was built with them.
pub const CAROM_TABLE_STANDARD: i32 = 1;

/// What grains do when they touch. Impacts outside a table's domain are answered by the hard-sphere rule.
#[derive(Clone, Copy, Debug)]
pub enum Law<S: Scalar> {
    /// Nobody has chosen.
    Missing,
    /// Hard spheres with a constant coefficient of restitution.
    Hard(HardSphere<S>),
    /// The linear spring-dashpot.
    Linear(Soft<LinearDashpot<S>>),
    /// Viscoelastic spheres.
    Viscoelastic(Soft<Viscoelastic<S>>),
}

/// The default: contacts that last or crowd are integrated.
pub const CAROM_MODE_INTEGRATED: i32 = 0;
/// The papers' mode: one contact of two after the other, grains at rest by rules. The library has it if it was built with
/// it (feature paper): 30 KB of flash more.
pub const CAROM_MODE_PAPER: i32 = 1;

/// What becomes of contacts that last or crowd.
#[derive(Clone, Copy, Debug)]
pub enum Mode {
    /// They are integrated.
    Integrated,
    /// The papers' way.
    #[cfg(feature = "paper")]
    Paper,
}

impl Mode {
    /// The mode of this number.
    ///
    /// # Errors
    /// [`carom_error::CAROM_ERROR_MODE`].
    pub fn of(number: i32) -> Result<Self, carom_error> {
        match number {
            CAROM_MODE_INTEGRATED => Ok(Self::Integrated),
            #[cfg(feature = "paper")]
            CAROM_MODE_PAPER => Ok(Self::Paper),
            _ => Err(carom_error::CAROM_ERROR_MODE),
        }
    }
}

/// The rule of every world.
#[derive(Clone, Copy, Debug)]
pub struct AnyRule<S: Scalar> {
    /// What happens when two touch.
    pub law: Law<S>,
    /// What becomes of contacts that last or crowd.
    pub mode: Mode,
}

impl<S: Scalar> AnyRule<S> {
    /// Nobody has chosen a law.
    pub const EMPTY: Self = Self { law: Law::Missing, mode: Mode::Integrated };
}

impl<S: Scalar> Rule<S> for AnyRule<S> {
    // Inlined: where there is one mode only, there is no code for the other.
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        Some(match self.mode {
            Mode::Integrated => Enduring::Integrated,
            #[cfg(feature = "paper")]
            Mode::Paper => Enduring::Paper,
        })
    }

    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        self.law.collide(impact)
    }

    fn check(&self) -> Result<(), Error> {
        self.law.check()
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        self.law.force(impact, overlap)
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        self.law.contact_time(impact, overlap)
    }
}

/// A number type that has tables, in `f32`.
pub trait Number: Scalar {
    /// The table of a law in one of the sets.
    ///
    /// # Errors
    /// [`carom_error::CAROM_ERROR_TABLE`] if the library has no such set.
    fn table<L: ForceLaw<Self>>(set: i32) -> Result<&'static Table<f32>, carom_error>;
}

impl<S: Scalar> Number for S
where
    Compact: TableSet<S, Stored = f32>,
    Largest: TableSet<S, Stored = f32>,
{
    fn table<L: ForceLaw<Self>>(set: i32) -> Result<&'static Table<f32>, carom_error> {
        match set {
            CAROM_TABLE_COMPACT => Ok(Compact::table(L::LAW)),
            CAROM_TABLE_STANDARD if cfg!(feature = "standard") => Ok(Largest::table(L::LAW)),
            _ => Err(carom_error::CAROM_ERROR_TABLE),
        }
    }
}

#[cfg(not(feature = "standard"))]
use Compact as Largest;
#[cfg(feature = "standard")]
use carom::law::embedded::Standard as Largest;

/// A law read from this table.
pub fn soft<S: Number, L: ForceLaw<S>>(law: L, set: i32) -> Result<Soft<L>, carom_error> {
    Ok(Soft::with_table(law, S::table::<L>(set)?, Outside::HardSphere))
}

impl<S: Scalar> Rule<S> for Law<S> {
    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        match self {
            // Such a world does not start.
            Self::Missing => Answer::exact(Response::Instantaneous(S::one())),
            Self::Hard(rule) => rule.collide(impact),
            Self::Linear(rule) => rule.collide(impact),
            Self::Viscoelastic(rule) => rule.collide(impact),
        }
    }

    fn check(&self) -> Result<(), Error> {
        match self {
            Self::Missing => Err(Error::Input {
                subject: Subject::Rule,
                field: "number of laws",
                value: 0.0,
                wanted: "1: set a restitution, a linear spring-dashpot or viscoelastic grains",
            }),
            Self::Hard(rule) => Rule::<S>::check(rule),
            Self::Linear(rule) => rule.check(),
            Self::Viscoelastic(rule) => rule.check(),
        }
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        match self {
            Self::Missing | Self::Hard(_) => None,
            Self::Linear(rule) => rule.force(impact, overlap),
            Self::Viscoelastic(rule) => rule.force(impact, overlap),
        }
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        match self {
            Self::Missing | Self::Hard(_) => None,
            Self::Linear(rule) => rule.contact_time(impact, overlap),
            Self::Viscoelastic(rule) => rule.contact_time(impact, overlap),
        }
    }
}
