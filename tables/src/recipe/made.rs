//! What has the generator made? Reads a fit; writes a table that is certified but not yet text.

use super::certify;
use crate::fit::{Ask, Cube, Fit};
use crate::form::{Body, Branch, Certificate, Domain, Frame, Leaf, Row, Stored};
use crate::number::Real;

/// The number in which a table is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// `f32`.
    F32,
    /// `f64`.
    F64,
}

/// A number that a generated table can be stored in.
pub trait Store: Stored + Real + std::fmt::Debug {
    /// Its name in Rust.
    const NAME: &'static str;
    /// Is the fit worth more than 1e-10?
    const PRECISE: bool;
    /// The next larger value.
    fn above(self) -> Self;
    /// The bits, lowest byte first.
    fn bytes(self) -> Vec<u8>;
}

impl Store for f32 {
    const NAME: &'static str = "f32";
    const PRECISE: bool = false;
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
    fn above(self) -> Self {
        self.next_up()
    }
    fn bytes(self) -> Vec<u8> {
        self.to_bits().to_le_bytes().to_vec()
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
                kappa_scale: C::from_f64(ask.frame.kappa_scale),
                softness: C::from_f64(ask.frame.softness),
                c_dis: C::from_f64(ask.frame.c_dis),
                bend: C::from_f64(ask.frame.bend),
            },
            branches: fit.branches,
            leaves: fit.leaves,
            rows: fit.rows,
            coefficients: fit.coefficients.into_iter().map(C::from_f64).collect(),
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
        softness_max: C::from_f64(d.softness_max),
        c_dis_max: C::from_f64(d.c_dis_max),
        cos_min: C::from_f64(d.cos_min),
        sin_min: C::from_f64(d.sin_min),
        stick_max: C::from_f64(d.stick_max),
    }
}

/// The limits as they are stored, never narrower than asked.
pub(super) fn outward<C: Store>(d: &Domain) -> Domain {
    let up = |value: f64| {
        let near = C::from_f64(value);
        (if near.to_f64() < value { near.above() } else { near }).to_f64()
    };
    Domain {
        softness_max: up(d.softness_max),
        c_dis_max: up(d.c_dis_max),
        cos_min: -up(-d.cos_min),
        sin_min: -up(-d.sin_min),
        stick_max: up(d.stick_max),
    }
}
