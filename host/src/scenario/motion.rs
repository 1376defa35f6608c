//! How does an obstacle move? Reads what a scenario says of it; writes nothing, returns where its points are at a time.

use super::obstacle::{ObstacleSpec, RotationSpec, VibrationSpec};
use std::f64::consts::TAU;

/// How an obstacle moves, its vectors with zeros beyond the dimension; in SI units and radians.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Steadily, with this velocity.
    Drift([f64; 3]),
    /// A₀ sin(2π (f t + φ)).
    Vibration {
        /// A₀.
        amplitude: [f64; 3],
        /// f.
        frequency: f64,
        /// φ, in turns.
        phase: f64,
    },
    /// About an axis through a point.
    Rotation {
        /// The point.
        centre: [f64; 3],
        /// ω.
        angular_velocity: [f64; 3],
    },
}

impl Motion {
    /// What an obstacle says; none if it stands.
    #[must_use]
    pub fn of(obstacle: &ObstacleSpec) -> Option<Self> {
        if let Some(velocity) = &obstacle.velocity {
            return Some(Self::Drift(padded(velocity)));
        }
        if let Some(VibrationSpec { amplitude, frequency, phase }) = &obstacle.vibration {
            let (frequency, phase) = (*frequency, *phase);
            return Some(Self::Vibration { amplitude: padded(amplitude), frequency, phase });
        }
        let RotationSpec { centre, angular_velocity } = obstacle.rotation.as_ref()?;
        let angular_velocity = match angular_velocity[..] {
            [flat] => [0.0, 0.0, flat],
            ref all => padded(all),
        };
        Some(Self::Rotation { centre: padded(centre), angular_velocity })
    }

    /// Where a point of the obstacle, that is here in the scenario, is at a time.
    #[must_use]
    pub fn carried(&self, point: [f64; 3], time: f64) -> [f64; 3] {
        let shifted = |way: &[f64; 3], by: f64| std::array::from_fn(|k| point[k] + way[k] * by);
        match self {
            Self::Drift(velocity) => shifted(velocity, time),
            Self::Vibration { amplitude, frequency, phase } => {
                shifted(amplitude, (TAU * (frequency * time + phase)).sin())
            }
            Self::Rotation { centre, angular_velocity } => {
                let from = std::array::from_fn(|k| point[k] - centre[k]);
                let turned = turned(from, *angular_velocity, time);
                std::array::from_fn(|k| centre[k] + turned[k])
            }
        }
    }
}

/// Rodrigues' rotation of a vector by ω t.
fn turned(r: [f64; 3], omega: [f64; 3], time: f64) -> [f64; 3] {
    let rate = omega.iter().map(|w| w * w).sum::<f64>().sqrt();
    let a = omega.map(|w| w / rate);
    let (sin, cos) = (rate * time).sin_cos();
    let across = [a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]];
    let along: f64 = (0..3).map(|k| a[k] * r[k]).sum();
    std::array::from_fn(|k| r[k] * cos + across[k] * sin + a[k] * along * (1.0 - cos))
}

fn padded(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_leads_from_x_to_y() {
        let motion =
            Motion::Rotation { centre: [1.0, 0.0, 0.0], angular_velocity: [0.0, 0.0, TAU] };
        let [x, y, z] = motion.carried([3.0, 0.0, 5.0], 0.25);
        assert!((x - 1.0).abs() < 1e-12 && (y - 2.0).abs() < 1e-12 && (z - 5.0).abs() < 1e-12);
    }
}
