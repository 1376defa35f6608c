//! Is it over? Reads grains that fly freely; writes whether any of them will ever touch again.

use crate::roots::quadratic;
use crate::system::{Boundary, Grain};
use crate::vector::{dot, minus};

/// When a run that has nothing more to do may stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quiet {
    /// After this time without any contact (L94 Sec. IV C takes 2 N s_0/v_0); infinite for never.
    pub interval: f64,
    /// At this time at the latest.
    pub limit: f64,
}

/// Why a run stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// No contact exists and none can come: all have separated for good.
    Separated,
    /// No contact has existed for the interval asked for.
    Quiet,
    /// The limit was reached.
    Limit,
}

/// Whether grains out of contact will never touch each other or a wall, by their free flight.
///
/// In periodic boxes and under gravity, where that hardly ever happens, the answer is no.
pub(crate) fn all_separated<const D: usize>(
    grains: &[Grain<D>],
    boundary: &[Boundary; D],
    gravity: &[f64; D],
) -> bool {
    if gravity.iter().any(|g| *g != 0.0) {
        return false;
    }
    let leaves = |grain: &Grain<D>| (0..D).all(|axis| clear(grain, axis, &boundary[axis]));
    let miss = |(i, a): (usize, &Grain<D>)| grains[i + 1..].iter().all(|b| misses(a, b));
    grains.iter().all(leaves) && grains.iter().enumerate().all(miss)
}

fn clear<const D: usize>(grain: &Grain<D>, axis: usize, bound: &Boundary) -> bool {
    match *bound {
        Boundary::Open => true,
        Boundary::Periodic { .. } => false,
        Boundary::Walls { .. } => grain.velocity[axis] == 0.0,
        Boundary::Plate(plate) => {
            let gap = grain.position[axis] - grain.radius - plate.at;
            match plate.moves() {
                true => grain.velocity[axis] >= 0.0 && gap > plate.amplitude,
                false => grain.velocity[axis] >= 0.0,
            }
        }
    }
}

fn misses<const D: usize>(a: &Grain<D>, b: &Grain<D>) -> bool {
    let (d, v) = (minus(&a.position, &b.position), minus(&a.velocity, &b.velocity));
    let (contact_distance, approach) = (a.radius + b.radius, dot(&d, &v));
    approach >= 0.0
        || quadratic(dot(&v, &v), 2.0 * approach, dot(&d, &d) - contact_distance * contact_distance)
            [0]
        .is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(velocities: [f64; 3]) -> Vec<Grain<1>> {
        let bead = |(k, v): (usize, f64)| Grain {
            radius: 0.5,
            mass: 1.0,
            position: [0.6 + 1.1 * k as f64],
            velocity: [v],
        };
        velocities.into_iter().enumerate().map(bead).collect()
    }

    #[test]
    fn a_column_is_separated_when_its_velocities_are_in_order() {
        let floor = [Boundary::Plate(crate::plate::Plate::fixed(0.0))];
        let separated = |v| all_separated(&column(v), &floor, &[0.0]);
        assert!(separated([0.0, 0.1, 0.2]));
        assert!(separated([0.1, 0.1, 0.1]));
        assert!(!separated([0.2, 0.1, 0.3]));
        assert!(!separated([0.1, 0.3, 0.2]));
        assert!(!separated([-0.1, 0.1, 0.2]));
        assert!(!all_separated(&column([0.0, 0.1, 0.2]), &floor, &[-1.0]));
    }
}
