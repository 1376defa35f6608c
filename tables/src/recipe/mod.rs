//! Which table is wanted? Reads law, limits and tolerance; writes a certified table as Rust text for a `build.rs`.

mod certify;
mod emit;
mod error;
mod made;
mod plan;
mod preset;
pub mod range;
pub mod spread;

use std::path::Path;

use crate::fit::{Ask, fit};
use crate::form::{Domain, End, Frame, Groups, Law, SOFT};
pub use error::Error;
pub use made::{Made, Number};

/// The tolerance of tables for `I16F16`: half a step.
#[cfg(feature = "fixed")]
const COARSE: f64 = 1.0 / 131_072.0;

/// What a table shall hold: a law, an end, a domain, a tolerance.
///
/// In a `build.rs`:
/// ```
/// use carom_tables::{Law, Recipe};
/// # let out = std::env::temp_dir().join("carom-doc-recipe.rs");
/// Recipe::compact(Law::LinearDashpot).c_dis_max(0.3).write(&out, "GLASS")?;
/// # std::fs::remove_file(out).ok();
/// # Ok::<(), carom_tables::recipe::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    law: Law,
    end: End,
    domain: Domain,
    wide: bool,
    tolerance: f64,
    loose: f64,
    limit: usize,
    points: usize,
    bytes_max: Option<usize>,
    number: Number,
    form: String,
    tables: bool,
    plan: Option<&'static str>,
}

impl Recipe {
    /// When the contact ends; [`End::Force`] unless said.
    #[must_use]
    pub fn end(mut self, end: End) -> Self {
        self.plan = None;
        self.end = end;
        self
    }

    /// Largest `eta / cos(alpha)`: one over the smallest `l~ cos(alpha)`.
    #[must_use]
    pub fn softness_max(mut self, softness_max: f64) -> Self {
        self.plan = None;
        self.tables = false;
        self.domain.softness_max = softness_max;
        self
    }

    /// Largest `c_dis`.
    #[must_use]
    pub fn c_dis_max(mut self, c_dis_max: f64) -> Self {
        self.plan = None;
        self.tables = false;
        self.domain.c_dis_max = c_dis_max;
        self
    }

    /// Sets `softness_max` and `c_dis_max` so that these collisions are inside.
    ///
    /// For one material give the fastest: softness and damping grow with the speed. A viscoelastic
    /// pair is softest, `eta / cos(alpha) ~ cos^(-1/5)`, where it grazes: give such a collision too.
    ///
    /// ```
    /// use carom_tables::{Law, Recipe, recipe::range::Equal};
    /// let fastest = Equal { radius: 5e-3, density: 1200.0, speed: 1.0, eccentricity: 0.0 };
    /// let grazing = Equal { eccentricity: 0.999, ..fastest };
    /// let hits = [fastest, grazing].map(|hit| hit.viscoelastic(5e6, 0.49, 1e-4));
    /// let recipe = Recipe::standard(Law::Viscoelastic).covering(&hits);
    /// ```
    #[must_use]
    pub fn covering(self, collisions: &[Groups<f64>]) -> Self {
        let largest = |of: fn(&Groups<f64>) -> f64| collisions.iter().map(of).fold(1e-9, f64::max);
        let softness = largest(|g| g.eta / g.cos);
        let c_dis = largest(|g| g.c_dis);
        self.softness_max(softness).c_dis_max(c_dis)
    }

    /// Smallest `cos(alpha)`; the presets of the stiff domain reach 1e-6.
    #[must_use]
    pub fn cos_min(mut self, cos_min: f64) -> Self {
        self.plan = None;
        self.domain.cos_min = cos_min;
        self
    }

    /// The error that the fit aims at: relative for the duration, absolute for speed and angle.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.plan = None;
        self.loose *= tolerance / self.tolerance;
        self.tolerance = tolerance;
        self
    }

    /// Raise the tolerance until the table has at most this many bytes.
    #[must_use]
    pub fn bytes_max(mut self, bytes: usize) -> Self {
        self.plan = None;
        self.bytes_max = Some(bytes);
        self
    }

    /// Most coefficients that one reading may touch (all three columns): bytes against speed.
    #[must_use]
    pub fn terms_max(mut self, terms: usize) -> Self {
        self.plan = None;
        self.limit = terms;
        self
    }

    /// Points at which the table is certified.
    #[must_use]
    pub fn points(mut self, points: usize) -> Self {
        self.points = points;
        self
    }

    /// Stored number; `f32` unless said. A table for `I16F16`, whose steps are 1.5e-5, aims no lower.
    ///
    /// A quantised table cannot hold numbers above 8, so it cannot be a wide one.
    #[must_use]
    pub fn number(mut self, number: Number) -> Self {
        self.number = number;
        #[cfg(feature = "fixed")]
        if number == Number::I16F16 && self.tolerance < COARSE {
            return self.tolerance(COARSE);
        }
        self
    }

    /// The path under which the emitted text finds the module `form` of this crate.
    #[must_use]
    pub fn form_path(mut self, path: &str) -> Self {
        self.form = path.into();
        self
    }

    /// Forget the bisection that came with a preset and search for one.
    #[must_use]
    pub fn search(mut self) -> Self {
        self.plan = None;
        self
    }

    /// Fits and certifies.
    ///
    /// # Errors
    /// Names the field that is out of range, its value and what would be right.
    pub fn generate<C: made::Store>(&self) -> Result<Made<C>, Error> {
        self.check()?;
        let limits = self.limits();
        self.fits::<C>(&[limits.softness_max, limits.c_dis_max, limits.stick_max])?;
        let mut tolerance = self.tolerance;
        while tolerance < 0.2 {
            let ask = self.ask::<C>(tolerance);
            let fit = fit(&ask);
            self.fits::<C>(&fit.coefficients)?;
            let made = Made::<C>::new(&ask, fit);
            if self.bytes_max.is_none_or(|most| made.body().bytes() <= most) {
                return Ok(made.certified(&ask, self.points));
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
        Ok(match self.number {
            Number::F32 => emit::text(&self.generate::<f32>()?, name, &self.form),
            Number::F64 => emit::text(&self.generate::<f64>()?, name, &self.form),
            #[cfg(feature = "fixed")]
            Number::I32F32 | Number::I16F16 => {
                emit::text(&self.generate::<crate::form::Quanta>()?, name, &self.form)
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

    /// Whether the stored number is large enough for these.
    fn fits<C: made::Store>(&self, numbers: &[f64]) -> Result<(), Error> {
        if numbers.iter().all(|a| a.abs() <= C::MOST) {
            return Ok(());
        }
        let wanted = "f32 or f64: the table has a number too large for steps of 2^-28";
        Err(Error::field("number", format!("{:?}", self.read_in::<C>()), wanted))
    }

    /// The number in which the table is certified.
    fn read_in<C: made::Store>(&self) -> Number {
        #[cfg(feature = "fixed")]
        if C::NUMBER == Number::I32F32 && self.number == Number::I16F16 {
            return self.number;
        }
        C::NUMBER
    }

    fn check(&self) -> Result<(), Error> {
        let d = &self.domain;
        let ranges = [
            ("softness_max", d.softness_max, 1e-12, 12.0, "a number in 1e-12..12"),
            ("c_dis_max", d.c_dis_max, 1e-12, 1e7, "a number in 1e-12..1e7"),
            ("cos_min", d.cos_min, 1e-6, 0.9, "a number in 1e-6..0.9"),
            ("tolerance", self.tolerance, 1e-10, 0.1, "a number in 1e-10..0.1"),
        ];
        for (field, value, low, high, wanted) in ranges {
            if !(low..=high).contains(&value) {
                return Err(Error::field(field, value, wanted));
            }
        }
        let overlap = self.end == End::Overlap;
        if overlap && (d.c_dis_max > 1.0 || self.is_wide()) {
            let wanted = "at most 1, and softness_max at most 0.3, when the overlap ends a contact";
            return Err(Error::field("c_dis_max", d.c_dis_max, wanted));
        }
        if self.points < 100 {
            return Err(Error::field("points", self.points, "at least 100"));
        }
        if self.limit < 10 {
            return Err(Error::field("terms_max", self.limit, "at least 10"));
        }
        Ok(())
    }

    /// Outside the stiff, weakly damped corner the wide frame is needed.
    fn is_wide(&self) -> bool {
        self.wide || self.domain.softness_max > 0.3 || self.domain.c_dis_max > 2.0
    }

    fn ask<C: made::Store>(&self, tolerance: f64) -> Ask {
        let wide = self.is_wide();
        let frame = self.frame::<C>(wide);
        let domain = made::outward::<C>(&self.limits());
        let typical = if self.tables { range::coordinates(&frame) } else { Vec::new() };
        Ask {
            law: self.law,
            end: self.end,
            frame,
            domain,
            goal: tolerance,
            loose: self.loose * tolerance / self.tolerance,
            limit: self.limit,
            start: if wide { [6, 4, 6] } else { [10, 4, 10] },
            patience: if wide { 40.0 } else { 1e5 },
            number: self.read_in::<C>(),
            precise: tolerance < 1e-8,
            typical,
            checked: Domain { cos_min: domain.cos_min * if wide { 0.5 } else { 1.0 }, ..domain },
            plan: self.plan,
        }
    }

    /// The coordinates, their constants as they will be stored.
    fn frame<C: made::Store>(&self, wide: bool) -> Frame<f64> {
        let round = |value: f64| C::nearest(value).value();
        let bend = match (self.end, wide, self.law) {
            (End::Overlap, ..) | (End::Force, true, Law::Viscoelastic) => 0.0,
            (End::Force, true, Law::LinearDashpot) => 0.2,
            (End::Force, false, _) => 0.5,
        };
        Frame {
            law: self.law,
            end: self.end,
            wide,
            kappa_scale: if wide { 1.0 } else { 0.5 },
            softness: round(self.domain.softness_max),
            c_dis: round(self.domain.c_dis_max),
            bend,
        }
    }

    /// The domain; its last two limits follow from the others unless MP13's tables set them.
    fn limits(&self) -> Domain {
        let d = self.domain;
        if self.tables {
            return d;
        }
        let soft = d.softness_max > f64::from(SOFT);
        let stick_max = 1.01 * d.softness_max * d.c_dis_max;
        Domain { stick_max, sin_min: if soft { 0.0099 } else { 0.0 }, ..d }
    }
}
