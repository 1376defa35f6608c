//! How does gravity change with time? Reads a time; writes nothing, returns gravity then and when it changes next.

use anyhow::{Result, bail};
use serde::{Deserialize, Serialize};

/// Gravity over time.
///
/// # Units
/// s; m/s².
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "", rename_all = "snake_case")]
pub enum Gravity<const D: usize> {
    /// From each time on as the table says.
    Table(Vec<(f64, Vector<D>)>),
    /// It turns in the plane of two axes, from the first to the second, in steps.
    Rotating {
        /// g.
        magnitude: f64,
        /// In which plane.
        axes: [usize; 2],
        /// How long a turn takes (s).
        period: f64,
        /// In how many steps.
        steps: u32,
    },
}

/// Components along the axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "Vec<f64>", try_from = "Vec<f64>")]
pub struct Vector<const D: usize>(pub [f64; D]);

impl<const D: usize> From<Vector<D>> for Vec<f64> {
    fn from(vector: Vector<D>) -> Self {
        vector.0.to_vec()
    }
}

impl<const D: usize> TryFrom<Vec<f64>> for Vector<D> {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, String> {
        let given = numbers.len();
        numbers.try_into().map(Self).map_err(|_| format!("{given} components, must be {D}"))
    }
}

impl<const D: usize> Gravity<D> {
    /// What makes no sense in it.
    pub(super) fn check(&self) -> Result<()> {
        match self {
            Self::Table(rows) => {
                let ordered = rows.windows(2).all(|pair| pair[0].0 < pair[1].0);
                let finite = rows.iter().all(|(time, g)| {
                    *time >= 0.0 && time.is_finite() && g.0.iter().all(|x| x.is_finite())
                });
                if rows.is_empty() || !ordered || !finite {
                    bail!(
                        "a table of gravity needs times that grow from at least 0, and finite components"
                    );
                }
            }
            &Self::Rotating { magnitude, axes: [a, b], period, steps } => {
                if a == b || a >= D || b >= D {
                    bail!(
                        "gravity turns in the plane of axes {a} and {b}, must be two of 0 to {}",
                        D - 1
                    );
                }
                if !(magnitude.is_finite() && period > 0.0 && period.is_finite()) || steps < 3 {
                    bail!(
                        "turning gravity needs a finite magnitude, a period above 0 and at least 3 steps"
                    );
                }
            }
        }
        Ok(())
    }

    /// When it changes first.
    pub(super) fn first_time(&self) -> Option<f64> {
        match self {
            Self::Table(rows) => rows.first().map(|row| row.0),
            Self::Rotating { .. } => Some(0.0),
        }
    }

    /// When it changes after this time.
    pub(super) fn time_after(&self, now: f64) -> Option<f64> {
        match self {
            Self::Table(rows) => rows.iter().map(|row| row.0).find(|time| *time > now),
            &Self::Rotating { period, steps, .. } => {
                // By the number of the step: nothing adds up.
                let step = period / f64::from(steps);
                Some(((now / step).round() + 1.0) * step)
            }
        }
    }

    /// Gravity from this time on.
    pub(super) fn at(&self, now: f64) -> [f64; D] {
        match self {
            Self::Table(rows) => {
                let before = rows.iter().rev().find(|(time, _)| *time <= now);
                before.or(rows.first()).map_or([0.0; D], |(_, g)| g.0)
            }
            &Self::Rotating { magnitude, axes, period, steps } => {
                let step = (now / period * f64::from(steps)).round() % f64::from(steps);
                let (sin, cos) = (std::f64::consts::TAU * step / f64::from(steps)).sin_cos();
                let mut g = [0.0; D];
                (g[axes[0]], g[axes[1]]) = (magnitude * cos, magnitude * sin);
                g
            }
        }
    }
}
