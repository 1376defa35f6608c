//! What does one state add to the sums? Reads grains; writes sums over them.

use super::layout::{Layout, State};
use crate::scenario::{Placed, present};

/// Adds a state: moments of the velocities of each species, and the stress of motion.
///
/// In a sheared box velocities count from the flow's. Along axes that are not between two walls they count from the mean one; what that takes from
/// a species of N_s grains of mass m_s is made up for: the sum counts for N_s (1 − m_s/M).
pub fn add(sums: &mut [f64], layout: &Layout, grains: &[Placed]) {
    let (mean, d) = (mean_velocity(layout, grains), layout.dimension);
    sums[layout.states()] += 1.0;
    let mut species = vec![[0.0; State::COUNT]; layout.names.len()];
    let mut stress = [[0.0; 3]; 3];
    for (number, grain) in present(grains) {
        let which = layout.species.get(number).copied().map_or(0, usize::from);
        let own = peculiar(layout, grain);
        let v: [f64; 3] = std::array::from_fn(|a| own[a] - mean[a]);
        for (row, v_a) in stress.iter_mut().zip(&v) {
            row.iter_mut().zip(&v).for_each(|(sum, v_b)| *sum += grain.mass * v_a * v_b);
        }
        let square: f64 = v.iter().map(|v| v * v).sum();
        let [x, y, z] = v.map(|v| grain.mass * v * v);
        let more = [1.0, x, y, z, square, square * square];
        species[which].iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }
    for (which, more) in species.iter().enumerate() {
        let at = layout.state(which, State::Count);
        sums[at..at + State::COUNT].iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }
    for (a, row) in stress.iter().enumerate().take(d) {
        row.iter().enumerate().take(d).for_each(|(b, more)| sums[layout.stress(a, b)] += more);
    }
}

/// The velocity of a grain against the flow.
fn peculiar(layout: &Layout, grain: &Placed) -> [f64; 3] {
    let mut velocity = grain.velocity;
    if let Some(flow) = &layout.flow {
        velocity[flow.along] -= flow.speed(&grain.position);
    }
    velocity
}

/// The velocity of the centre of mass against the flow, along the axes where it counts.
fn mean_velocity(layout: &Layout, grains: &[Placed]) -> [f64; 3] {
    let there = present(grains).map(|(_, grain)| grain);
    let mass: f64 = there.clone().map(|grain| grain.mass).sum();
    std::array::from_fn(|a| {
        if a >= layout.dimension || !layout.is_drifting(a) || grains.len() < 2 {
            return 0.0;
        }
        there.clone().map(|grain| grain.mass * peculiar(layout, grain)[a]).sum::<f64>() / mass
    })
}
