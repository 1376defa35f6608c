//! What does one state add to the sums? Reads grains; writes sums over them.

use super::layout::{Layout, State};
use crate::scenario::Placed;

/// Adds a state: moments of the velocities of each species, and the stress of motion.
///
/// Along axes that are not between two walls velocities count from the mean one; what that takes from
/// a species of N_s grains of mass m_s is made up for: the sum counts for N_s (1 − m_s/M).
pub fn add(sums: &mut [f64], layout: &Layout, grains: &[Placed]) {
    let mean = mean_velocity(layout, grains);
    sums[layout.states()] += 1.0;
    for (number, grain) in grains.iter().enumerate() {
        let species = layout.species.get(number).copied().map_or(0, usize::from);
        let at = |what| layout.state(species, what);
        let v: [f64; 3] = std::array::from_fn(|a| grain.velocity[a] - mean[a]);
        let mut square = 0.0;
        for a in 0..layout.dimension {
            square += v[a] * v[a];
            sums[at(State::Square(a))] += grain.mass * v[a] * v[a];
            for b in 0..layout.dimension {
                sums[layout.stress(a, b)] += grain.mass * v[a] * v[b];
            }
        }
        sums[at(State::Count)] += 1.0;
        sums[at(State::Second)] += square;
        sums[at(State::Fourth)] += square * square;
    }
}

/// The velocity of the centre of mass, along the axes where it counts.
fn mean_velocity(layout: &Layout, grains: &[Placed]) -> [f64; 3] {
    let mass: f64 = grains.iter().map(|grain| grain.mass).sum();
    std::array::from_fn(|a| {
        if a >= layout.dimension || !layout.is_drifting(a) || grains.len() < 2 {
            return 0.0;
        }
        grains.iter().map(|grain| grain.mass * grain.velocity[a]).sum::<f64>() / mass
    })
}
