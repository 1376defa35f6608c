//! What is a generated table before it becomes text? Reads a fit; writes the numbers as they will be stored, to be read and certified.

use super::number_type::EncodeNumber;
use crate::fit::cube::Cube;
use crate::fit::options::FitOptions;
use crate::fit::tree::FittedTree;
use crate::read::certificate::Certificate;
use crate::read::coordinates::CoordinateMap;
use crate::read::domain::Domain;
use crate::read::groups::ScaledRestitution;
use crate::read::layout::{Branch, Leaf, Row, TableData};

const CITATION: &str = "P. Müller and T. Pöschel, Event-driven molecular dynamics of soft particles, \
     Phys. Rev. E 87, 033301 (2013), Eqs. 8, 10, 40, 51";
/// No error at all.
pub(super) const ZERO: ScaledRestitution<f64> =
    ScaledRestitution { tau: 0.0, speed: 0.0, angle: 0.0, separation: 0.0 };

/// A fitted and certified table before it becomes Rust text; `C` is the stored number.
///
/// [`data`](Self::data) reads as the emitted [`Table`](crate::read::Table) will.
#[derive(Clone, Debug)]
pub struct GeneratedTable<C> {
    /// What the table promises.
    pub certificate: Certificate,
    domain: Domain<C>,
    coordinates: CoordinateMap<C>,
    branches: Vec<Branch>,
    leaves: Vec<Leaf>,
    rows: Vec<Row>,
    coefficients: Vec<C>,
    pub(super) cubes: Vec<Cube>,
    bisection: String,
}

impl<C: EncodeNumber> GeneratedTable<C> {
    pub(super) fn new(options: &FitOptions, tree: FittedTree) -> Self {
        GeneratedTable {
            certificate: unmeasured(options, &tree),
            domain: stored(&options.domain),
            coordinates: CoordinateMap {
                law: options.coordinates.law,
                end: options.coordinates.end,
                wide: options.coordinates.wide,
                kappa_scale: C::nearest(options.coordinates.kappa_scale),
                softness_max: C::nearest(options.coordinates.softness_max),
                c_dis_max: C::nearest(options.coordinates.c_dis_max),
                coupling: C::nearest(options.coordinates.coupling),
            },
            branches: tree.branches,
            leaves: tree.leaves,
            rows: tree.rows,
            coefficients: tree.coefficients.into_iter().map(C::nearest).collect(),
            cubes: tree.cubes,
            bisection: tree.bisection,
        }
    }

    /// How the search has bisected the unit cube, as text: the presets keep such texts.
    pub fn bisection(&self) -> &str {
        &self.bisection
    }

    /// The data, to be read with [`TableData::read`].
    pub fn data(&self) -> TableData<'_, C> {
        TableData {
            domain: self.domain,
            coordinates: self.coordinates,
            branches: &self.branches,
            leaves: &self.leaves,
            rows: &self.rows,
            coefficients: &self.coefficients,
        }
    }
}

/// The certificate before anything was measured.
fn unmeasured(options: &FitOptions, tree: &FittedTree) -> Certificate {
    Certificate {
        law: options.law,
        end: options.end,
        domain: options.domain,
        bytes: 0,
        terms: tree.terms,
        largest: ZERO,
        typical: ZERO,
        quantile_999: ZERO,
        points: 0,
        // The errors of a wide table have a long tail in corners that no typical collision sees.
        margin: if options.coordinates.wide { 2.0 } else { 1.5 },
        digest: 0,
        citation: CITATION,
    }
}

/// The limits as they are stored, each the nearest value.
fn stored<C: EncodeNumber>(d: &Domain) -> Domain<C> {
    Domain {
        softness_max: C::nearest(d.softness_max),
        c_dis_max: C::nearest(d.c_dis_max),
        cos_min: C::nearest(d.cos_min),
        sin_min: C::nearest(d.sin_min),
        c_dis_softness_max: C::nearest(d.c_dis_softness_max),
    }
}

/// The limits as they are stored, never narrower than asked.
pub(super) fn outward<C: EncodeNumber>(d: &Domain) -> Domain {
    let up = |value: f64| {
        let near = C::nearest(value);
        (if near.value() < value { near.next_above() } else { near }).value()
    };
    Domain {
        softness_max: up(d.softness_max),
        c_dis_max: up(d.c_dis_max),
        cos_min: -up(-d.cos_min),
        sin_min: -up(-d.sin_min),
        c_dis_softness_max: up(d.c_dis_softness_max),
    }
}
