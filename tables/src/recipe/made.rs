//! What has the generator made? Reads a fit; writes a table that is certified but not yet text.

use super::certify;
use crate::fit::{Ask, Cube, Fit};
#[cfg(feature = "fixed")]
use crate::form::Quanta;
use crate::form::{Body, Branch, Certificate, Domain, Frame, Leaf, Row, Stored};
#[cfg(feature = "fixed")]
use crate::number::QUANTUM;

/// The number in which a table is stored, and read when it is certified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// `f32`.
    F32,
    /// `f64`.
    F64,
    /// Steps of 2^−28, read in `I32F32`.
    #[cfg(feature = "fixed")]
    I32F32,
    /// Steps of 2^−28, read in `I16F16`.
    #[cfg(feature = "fixed")]
    I16F16,
}

/// A number that a generated table can be stored in.
pub trait Store: Stored + std::fmt::Debug {
    /// Its name in Rust.
    const NAME: &'static str;
    /// Is the fit worth more than 1e-10?
    const PRECISE: bool;
    /// The number for which it is meant.
    const NUMBER: Number;
    /// The largest value that it can have.
    const MOST: f64;
    /// The nearest value of this type.
    fn nearest(value: f64) -> Self;
    /// The value.
    fn value(self) -> f64;
    /// The next larger value.
    fn above(self) -> Self;
    /// The bits, lowest byte first.
    fn bytes(self) -> Vec<u8>;
}

impl Store for f32 {
    const NAME: &'static str = "f32";
    const PRECISE: bool = false;
    const NUMBER: Number = Number::F32;
    const MOST: f64 = f32::MAX as f64;
    fn nearest(value: f64) -> Self {
        value as f32
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
    fn above(self) -> Self {
        self.next_up()
    }
    fn bytes(self) -> Vec<u8> {
        self.to_bits().to_le_bytes().to_vec()
    }
}

impl Store for f64 {
    const NAME: &'static str = "f64";
    const PRECISE: bool = true;
    const NUMBER: Number = Number::F64;
    const MOST: f64 = f64::MAX;
    fn nearest(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn above(self) -> Self {
        self.next_up()
    }
    fn bytes(self) -> Vec<u8> {
        self.to_bits().to_le_bytes().to_vec()
    }
}

#[cfg(feature = "fixed")]
impl Store for Quanta {
    const NAME: &'static str = "Quanta";
    const PRECISE: bool = false;
    const NUMBER: Number = Number::I32F32;
    const MOST: f64 = 8.0 - QUANTUM;
    fn nearest(value: f64) -> Self {
        // A cast saturates; what does not fit is refused before it comes to that.
        Quanta(libm::round(value / QUANTUM) as i32)
    }
    fn value(self) -> f64 {
        f64::from(self.0) * QUANTUM
    }
    fn above(self) -> Self {
        Quanta(self.0.saturating_add(1))
    }
    fn bytes(self) -> Vec<u8> {
        self.0.to_le_bytes().to_vec()
    }
}

/// A table before it becomes text.
#[derive(Clone, Debug)]
pub struct Made<C> {
    /// What the table promises.
    pub certificate: Certificate,
    domain: Domain<C>,
    frame: Frame<C>,
    branches: Vec<Branch>,
    leaves: Vec<Leaf>,
    rows: Vec<Row>,
    coefficients: Vec<C>,
    pub(super) cubes: Vec<Cube>,
    plan: String,
}

impl<C: Store> Made<C> {
    pub(super) fn new(ask: &Ask, fit: Fit) -> Self {
        Made {
            certificate: certify::blank(ask, &fit),
            domain: stored(&ask.domain),
            frame: Frame {
                law: ask.frame.law,
                end: ask.frame.end,
                wide: ask.frame.wide,
                kappa_scale: C::nearest(ask.frame.kappa_scale),
                softness: C::nearest(ask.frame.softness),
                c_dis: C::nearest(ask.frame.c_dis),
                bend: C::nearest(ask.frame.bend),
            },
            branches: fit.branches,
            leaves: fit.leaves,
            rows: fit.rows,
            coefficients: fit.coefficients.into_iter().map(C::nearest).collect(),
            cubes: fit.cubes,
            plan: fit.plan,
        }
    }

    pub(super) fn certified(mut self, ask: &Ask, points: usize) -> Self {
        self.certificate = certify::certify(ask, &self, points);
        self
    }

    /// The bisection, as the presets keep it.
    pub fn plan(&self) -> &str {
        &self.plan
    }

    /// The data, to read from.
    pub fn body(&self) -> Body<'_, C> {
        Body {
            domain: self.domain,
            frame: self.frame,
            branches: &self.branches,
            leaves: &self.leaves,
            rows: &self.rows,
            coefficients: &self.coefficients,
        }
    }
}

fn stored<C: Store>(d: &Domain) -> Domain<C> {
    Domain {
        softness_max: C::nearest(d.softness_max),
        c_dis_max: C::nearest(d.c_dis_max),
        cos_min: C::nearest(d.cos_min),
        sin_min: C::nearest(d.sin_min),
        stick_max: C::nearest(d.stick_max),
    }
}

/// The limits as they are stored, never narrower than asked.
pub(super) fn outward<C: Store>(d: &Domain) -> Domain {
    let up = |value: f64| {
        let near = C::nearest(value);
        (if near.value() < value { near.above() } else { near }).value()
    };
    Domain {
        softness_max: up(d.softness_max),
        c_dis_max: up(d.c_dis_max),
        cos_min: -up(-d.cos_min),
        sin_min: -up(-d.sin_min),
        stick_max: up(d.stick_max),
    }
}
