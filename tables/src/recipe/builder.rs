//! Which table is wanted? Reads law, domain and tolerance from the caller; writes a recipe, whose fields are checked.

use super::error::Error;
use super::number_type::NumberType;
use crate::read::domain::{Domain, SOFT_ETA};
use crate::read::groups::Groups;
use crate::read::law::{End, Law};

/// The tolerance of tables for `I16F16`: half a step.
#[cfg(feature = "fixed")]
const HALF_STEP_I16F16: f64 = 1.0 / 131_072.0;

/// A recipe for a table: force law, end of the contact, domain and tolerance.
///
/// Begin with [`compact`](Self::compact), [`standard`](Self::standard) or [`wide`](Self::wide),
/// change what should be different, then [`write`](Self::write) the table.
///
/// In a `build.rs`:
/// ```
/// use carom_tables::{read::Law, recipe::Recipe};
/// # let out = std::env::temp_dir().join("carom-doc-recipe.rs");
/// Recipe::compact(Law::LinearDashpot).c_dis_max(0.3).write(&out, "GLASS")?;
/// # std::fs::remove_file(out).ok();
/// # Ok::<(), carom_tables::recipe::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    pub(super) law: Law,
    pub(super) end: End,
    pub(super) domain: Domain,
    pub(super) wide: bool,
    pub(super) tolerance: f64,
    /// The tolerance where no typical collision falls.
    pub(super) tolerance_atypical: f64,
    pub(super) terms_max: usize,
    pub(super) points: usize,
    pub(super) bytes_max: Option<usize>,
    pub(super) number_type: NumberType,
    pub(super) reader_path: String,
    /// Whether the domain is that of MP13's Table I or II.
    pub(super) mp13_ranges: bool,
    /// How the unit cube is bisected, if that is known from an earlier search.
    pub(super) bisection: Option<&'static str>,
}

impl Recipe {
    /// When the contact ends; [`End::Force`] unless said.
    #[must_use]
    pub fn end(mut self, end: End) -> Self {
        self.bisection = None;
        self.end = end;
        self
    }

    /// Largest softness `eta / cos(alpha)`: one over the smallest `l~ cos(alpha)`.
    #[must_use]
    pub fn softness_max(mut self, softness_max: f64) -> Self {
        self.bisection = None;
        self.mp13_ranges = false;
        self.domain.softness_max = softness_max;
        self
    }

    /// Largest scaled damping `c_dis` (MP13 Eqs. 43, 54).
    #[must_use]
    pub fn c_dis_max(mut self, c_dis_max: f64) -> Self {
        self.bisection = None;
        self.mp13_ranges = false;
        self.domain.c_dis_max = c_dis_max;
        self
    }

    /// Sets `softness_max` and `c_dis_max` so that these collisions are inside.
    ///
    /// For one material give the fastest: softness and damping grow with the speed. A viscoelastic
    /// pair is softest, `eta / cos(alpha) ~ cos^(-1/5)`, where it grazes: give such a collision too.
    ///
    /// ```
    /// use carom_tables::{collision::EqualSpheres, read::Law, recipe::Recipe};
    /// let fastest = EqualSpheres { radius: 5e-3, density: 1200.0, speed: 1.0, eccentricity: 0.0 };
    /// let grazing = EqualSpheres { eccentricity: 0.999, ..fastest };
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
        self.bisection = None;
        self.domain.cos_min = cos_min;
        self
    }

    /// The error that the fit aims at: relative for the duration, absolute for speed and angle.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.bisection = None;
        self.tolerance_atypical *= tolerance / self.tolerance;
        self.tolerance = tolerance;
        self
    }

    /// Raise the tolerance until the table has at most this many bytes.
    #[must_use]
    pub fn bytes_max(mut self, bytes: usize) -> Self {
        self.bisection = None;
        self.bytes_max = Some(bytes);
        self
    }

    /// Largest number of coefficients that one reading may use (all three columns).
    ///
    /// Fewer make the reading faster and the table larger.
    #[must_use]
    pub fn terms_max(mut self, terms: usize) -> Self {
        self.bisection = None;
        self.terms_max = terms;
        self
    }

    /// Number of collisions at which the errors of the table are measured for its certificate.
    #[must_use]
    pub fn points(mut self, points: usize) -> Self {
        self.points = points;
        self
    }

    /// The number type of the table; `f32` unless said.
    ///
    /// The tolerance of a table for `I16F16` is at least half a step of that type, 7.6e-6.
    ///
    /// A quantised table cannot hold numbers above 8, so it cannot be a wide one.
    #[must_use]
    pub fn number_type(mut self, number_type: NumberType) -> Self {
        self.number_type = number_type;
        #[cfg(feature = "fixed")]
        if number_type == NumberType::I16F16 && self.tolerance < HALF_STEP_I16F16 {
            return self.tolerance(HALF_STEP_I16F16);
        }
        self
    }

    /// The path under which the emitted text finds the module [`read`](crate::read);
    /// `::carom_tables::read` unless said, `::carom::law::embedded::read` in a program that uses carom.
    #[must_use]
    pub fn reader_path(mut self, path: &str) -> Self {
        self.reader_path = path.into();
        self
    }

    /// Forget the bisection that came with a preset and search for one.
    #[must_use]
    pub fn search(mut self) -> Self {
        self.bisection = None;
        self
    }

    /// Whether every field is in its range.
    pub(super) fn check(&self) -> Result<(), Error> {
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
        if self.terms_max < 10 {
            return Err(Error::field("terms_max", self.terms_max, "at least 10"));
        }
        Ok(())
    }

    /// Outside the stiff, weakly damped corner the wide coordinates are needed.
    pub(super) fn is_wide(&self) -> bool {
        self.wide || self.domain.softness_max > 0.3 || self.domain.c_dis_max > 2.0
    }

    /// The domain; its last two limits follow from the others unless MP13's tables set them.
    pub(super) fn limits(&self) -> Domain {
        let d = self.domain;
        if self.mp13_ranges {
            return d;
        }
        let soft = d.softness_max > f64::from(SOFT_ETA);
        let c_dis_softness_max = 1.01 * d.softness_max * d.c_dis_max;
        Domain { c_dis_softness_max, sin_min: if soft { 0.0099 } else { 0.0 }, ..d }
    }
}
