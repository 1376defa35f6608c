//! Which tables does carom itself carry? Reads the law; writes a recipe.

use super::{Number, Recipe, plan};
use crate::form::{Domain, End, Law};

impl Recipe {
    /// The smallest table: `l~ cos(alpha) >= 5`, `c_dis <= 1`, any eccentricity, to about 2e-4.
    #[must_use]
    pub fn compact(law: Law) -> Self {
        Recipe { tolerance: 1e-4, points: 10_000, limit: 110, plan: None, ..Self::standard(law) }
    }

    /// The usual table: `l~ cos(alpha) >= 5`, `c_dis <= 1`, any eccentricity, to about 1e-6.
    #[must_use]
    pub fn standard(law: Law) -> Self {
        Recipe {
            law,
            end: End::Force,
            domain: Domain {
                softness_max: 0.2,
                c_dis_max: 1.0,
                cos_min: 1e-6,
                sin_min: 0.0,
                stick_max: 0.25,
            },
            wide: false,
            tolerance: 5e-7,
            loose: 5e-7,
            limit: 160,
            points: 8_000,
            bytes_max: None,
            number: Number::F32,
            form: "::carom_tables::form".into(),
            tables: false,
            plan: Some(match law {
                Law::LinearDashpot => plan::STANDARD_LINEAR,
                Law::Viscoelastic => plan::STANDARD_VISCOELASTIC,
            }),
        }
    }

    /// All of MP13's Table I (linear) or Table II (viscoelastic), and more grazing collisions.
    #[must_use]
    pub fn wide(law: Law) -> Self {
        let (tolerance, loose, plan) = match law {
            Law::LinearDashpot => (9e-4, 8e-3, plan::WIDE_LINEAR),
            Law::Viscoelastic => (2e-4, 1.5e-3, plan::WIDE_VISCOELASTIC),
        };
        Recipe {
            domain: ranges(law),
            wide: true,
            tolerance,
            loose,
            limit: 300,
            points: 30_000,
            tables: true,
            plan: Some(plan),
            ..Self::standard(law)
        }
    }
}

/// The groups that MP13's Table I or II can give.
fn ranges(law: Law) -> Domain {
    match law {
        Law::LinearDashpot => Domain {
            softness_max: 10.32,
            c_dis_max: 56.0,
            cos_min: 0.02,
            sin_min: 0.0099,
            stick_max: 16.0,
        },
        Law::Viscoelastic => Domain {
            softness_max: 0.7,
            c_dis_max: 5e6,
            cos_min: 0.02,
            sin_min: 0.0,
            stick_max: 18_800.0,
        },
    }
}
