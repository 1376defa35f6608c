//! Which of several collisions at one instant comes first? Rows of grains that all touch at once; compares LRV.

use carom::law::HardSphere;
use carom::{Grain, Memory, World};

/// The two that collide first of a row of grains with these velocities, all of which touch at t = 1.
fn first<const N: usize>(velocities: [f64; N]) -> [usize; 2] {
    let mut memory = Memory::<f64, 1, N>::new();
    let at = |(i, v): (u32, f64)| Grain::with_mass(0.5, 1.0).at([f64::from(i) - v]).moving([v]);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 0.5 })
        .grains((0..).zip(velocities).map(at))
        .unwrap()
        .start()
        .unwrap();
    let event = world.step().unwrap().unwrap();
    assert_eq!(event.at.as_f64(), 1.0);
    let mut pair = [event.grain, event.partner.as_grain().unwrap()];
    pair.sort_unstable();
    pair
}

/// Largest relative velocity first (Clément et al. 1993; L94 §II.B): the numbers of the grains decide nothing.
#[test]
fn of_simultaneous_collisions_the_fastest_comes_first() {
    assert_eq!(first([2.0, 0.0, -1.0]), [0, 1]);
    assert_eq!(first([1.0, 0.0, -2.0]), [1, 2]);
    // The fastest pair in the middle: both have a slower collision at the same instant, too.
    assert_eq!(first([2.0, 1.0, -1.0, -2.0]), [1, 2]);
    assert_eq!(first([1.0, 0.5, -0.5, -3.0]), [2, 3]);
    assert_eq!(first([3.0, 0.5, -0.5, -1.0]), [0, 1]);
}
