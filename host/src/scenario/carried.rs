//! Where has an obstacle that moves come to? Reads its motion and a time; writes nothing, returns points.

use super::start::Start;
use super::walls::Motion;
use std::f64::consts::TAU;

impl Motion {
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

impl Start {
    /// The same with obstacles that move where they are at a time.
    #[must_use]
    pub fn at(mut self, time: f64) -> Self {
        for wall in &mut self.walls {
            let motion = wall.motion.and_then(|number| self.motions.get(usize::from(number)));
            if let Some(motion) = motion {
                wall.corners.iter_mut().for_each(|corner| *corner = motion.carried(*corner, time));
            }
        }
        self
    }
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
