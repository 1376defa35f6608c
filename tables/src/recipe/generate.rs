//! How does a recipe become a table? Reads a recipe; writes a certified table, its Rust text, or a file of it.

use std::path::Path;

use super::builder::Recipe;
use super::certify::certify;
use super::emit;
use super::error::Error;
use super::generated::{GeneratedTable, outward};
use super::number_type::{EncodeNumber, NumberType};
use crate::collision::typical_points;
use crate::fit::options::FitOptions;
use crate::fit::search::fit;
use crate::read::coordinates::CoordinateMap;
use crate::read::domain::Domain;
use crate::read::law::{End, Law};
#[cfg(feature = "fixed")]
use crate::read::stored::Quantised;

impl Recipe {
    /// Fits the table and measures its certificate; `C` is the stored number, `f32`, `f64` or [`Quantised`](crate::read::Quantised).
    ///
    /// It takes from a fraction of a second (a preset) to minutes (a wide domain without a known bisection).
    ///
    /// # Errors
    /// Names the field that is out of range, its value and what would be right.
    pub fn generate<C: EncodeNumber>(&self) -> Result<GeneratedTable<C>, Error> {
        self.check()?;
        let limits = self.limits();
        self.fits::<C>(&[limits.softness_max, limits.c_dis_max, limits.c_dis_softness_max])?;
        let mut tolerance = self.tolerance;
        while tolerance < 0.2 {
            let options = self.fit_options::<C>(tolerance);
            let tree = fit(&options);
            self.fits::<C>(&tree.coefficients)?;
            let mut table = GeneratedTable::<C>::new(&options, tree);
            if self.bytes_max.is_none_or(|most| table.data().bytes() <= most) {
                table.certificate = certify(&options, self.read_in::<C>(), &table, self.points);
                return Ok(table);
            }
            tolerance *= 1.6;
        }
        let bytes = self.bytes_max.unwrap_or_default();
        Err(Error::field("bytes_max", bytes, "room for a table of this domain"))
    }

    /// The table as Rust text: `pub static NAME: Table<f32> = ...;`.
    ///
    /// # Errors
    /// Names the field that is out of range, its value and what would be right.
    pub fn emit(&self, name: &str) -> Result<String, Error> {
        if !emit::is_name(name) {
            return Err(Error::field("name", name, "a Rust name such as MY_TABLE"));
        }
        Ok(match self.number_type {
            NumberType::F32 => emit::text(&self.generate::<f32>()?, name, &self.reader_path),
            NumberType::F64 => emit::text(&self.generate::<f64>()?, name, &self.reader_path),
            #[cfg(feature = "fixed")]
            NumberType::I32F32 | NumberType::I16F16 => {
                emit::text(&self.generate::<Quantised>()?, name, &self.reader_path)
            }
        })
    }

    /// Writes the table as Rust text into a file, whole or not at all.
    ///
    /// # Errors
    /// Names the field that is out of range, or the file that could not be written.
    pub fn write(&self, path: impl AsRef<Path>, name: &str) -> Result<(), Error> {
        emit::write(path.as_ref(), &self.emit(name)?)
    }

    /// Whether the stored number type can hold these values.
    fn fits<C: EncodeNumber>(&self, numbers: &[f64]) -> Result<(), Error> {
        if numbers.iter().all(|a| a.abs() <= C::MAX_VALUE) {
            return Ok(());
        }
        let wanted = "f32 or f64: the table has a number too large for steps of 2^-28";
        Err(Error::field("number_type", format!("{:?}", self.read_in::<C>()), wanted))
    }

    /// The number type in which the table is certified.
    fn read_in<C: EncodeNumber>(&self) -> NumberType {
        #[cfg(feature = "fixed")]
        if C::NUMBER_TYPE == NumberType::I32F32 && self.number_type == NumberType::I16F16 {
            return self.number_type;
        }
        C::NUMBER_TYPE
    }

    fn fit_options<C: EncodeNumber>(&self, tolerance: f64) -> FitOptions {
        let wide = self.is_wide();
        let coordinates = self.coordinates::<C>(wide);
        let domain = outward::<C>(&self.limits());
        let typical = if self.mp13_ranges { typical_points(&coordinates) } else { Vec::new() };
        FitOptions {
            law: self.law,
            end: self.end,
            coordinates,
            domain,
            tolerance,
            tolerance_atypical: self.tolerance_atypical * tolerance / self.tolerance,
            terms_max: self.terms_max,
            first_nodes: if wide { [6, 4, 6] } else { [10, 4, 10] },
            bisect_above: if wide { 40.0 } else { 1e5 },
            precise: tolerance < 1e-8,
            typical,
            checked_domain: Domain {
                cos_min: domain.cos_min * if wide { 0.5 } else { 1.0 },
                ..domain
            },
            bisection: self.bisection,
        }
    }

    /// The coordinates, their constants as they will be stored.
    fn coordinates<C: EncodeNumber>(&self, wide: bool) -> CoordinateMap<f64> {
        let round = |value: f64| C::nearest(value).value();
        let coupling = match (self.end, wide, self.law) {
            (End::Overlap, ..) | (End::Force, true, Law::Viscoelastic) => 0.0,
            (End::Force, true, Law::LinearDashpot) => 0.2,
            (End::Force, false, _) => 0.5,
        };
        CoordinateMap {
            law: self.law,
            end: self.end,
            wide,
            kappa_scale: if wide { 1.0 } else { 0.5 },
            softness_max: round(self.domain.softness_max),
            c_dis_max: round(self.domain.c_dis_max),
            coupling,
        }
    }
}
