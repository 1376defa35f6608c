//! Which tables does carom itself embed? Reads the law; writes a recipe.

use super::bisections;
use super::builder::Recipe;
use super::number_type::NumberType;
use crate::read::domain::Domain;
use crate::read::law::{End, Law};

impl Recipe {
    /// The smallest table: `l~ cos(alpha) >= 5`, `c_dis <= 1`, any eccentricity, to about 2e-4.
    #[must_use]
    pub fn compact(law: Law) -> Self {
        Recipe {
            tolerance: 1e-4,
            points: 10_000,
            terms_max: 110,
            bisection: None,
            ..Self::standard(law)
        }
    }

    /// The default table: `l~ cos(alpha) >= 5`, `c_dis <= 1`, any eccentricity, to about 1e-6.
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
                c_dis_softness_max: 0.25,
            },
            wide: false,
            tolerance: 5e-7,
            tolerance_atypical: 5e-7,
            terms_max: 160,
            points: 8_000,
            bytes_max: None,
            number_type: NumberType::F32,
            reader_path: "::carom_tables::read".into(),
            mp13_ranges: false,
            bisection: Some(match law {
                Law::LinearDashpot => bisections::STANDARD_LINEAR,
                Law::Viscoelastic => bisections::STANDARD_VISCOELASTIC,
            }),
        }
    }

    /// All of MP13's Table I (linear) or Table II (viscoelastic), and more grazing collisions.
    #[must_use]
    pub fn wide(law: Law) -> Self {
        let (tolerance, tolerance_atypical, bisection) = match law {
            Law::LinearDashpot => (9e-4, 8e-3, bisections::WIDE_LINEAR),
            Law::Viscoelastic => (2e-4, 1.5e-3, bisections::WIDE_VISCOELASTIC),
        };
        Recipe {
            domain: ranges(law),
            wide: true,
            tolerance,
            tolerance_atypical,
            terms_max: 300,
            points: 30_000,
            mp13_ranges: true,
            bisection: Some(bisection),
            ..Self::standard(law)
        }
    }

    /// As [`wide`](Self::wide), where 99.9 % of the collisions are within 1e-4 (linear, 256 KiB) or 3e-5
    /// (viscoelastic, 60 KB): for hosts, not for firmware.
    #[must_use]
    pub fn fine(law: Law) -> Self {
        let (tolerance, terms_max, bisection) = match law {
            Law::LinearDashpot => (1.1e-4, 800, bisections::FINE_LINEAR),
            Law::Viscoelastic => (1e-5, 600, bisections::FINE_VISCOELASTIC),
        };
        let wide = Self::wide(law).tolerance(tolerance);
        Recipe { terms_max, bisection: Some(bisection), ..wide }
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
            c_dis_softness_max: 16.0,
        },
        Law::Viscoelastic => Domain {
            softness_max: 0.7,
            c_dis_max: 5e6,
            cos_min: 0.02,
            sin_min: 0.0,
            c_dis_softness_max: 18_800.0,
        },
    }
}
