//! Is a box of segments or triangles the same as one of planes?

use super::shapes::{cube, ring, room};
use carom::law::HardSphere;
use carom::space::{Facet, Surface};
use carom::{Grain, HeapMemory, Storage, World};

/// Positions after each of a hundred bounces.
fn bounces<const D: usize>(
    memory: &mut impl Storage<f64, D>,
    (gravity, restitution): ([f64; D], f64),
    planes: bool,
) -> Vec<[f64; D]> {
    let velocity = std::array::from_fn(|axis| [0.83, 0.61, -0.47][axis]);
    let at = std::array::from_fn(|axis| [0.31, 0.57, 0.43][axis]);
    let mut builder = World::builder(memory).gravity(gravity).rule(HardSphere { restitution });
    if planes {
        builder = builder.hard_walls([[0.0, 1.0]; D], restitution);
    }
    let grain = Grain::with_mass(0.1, 1.0).at(at).moving(velocity);
    let mut world = builder.grain(grain).unwrap().start().unwrap();
    let mut places = Vec::new();
    while places.len() < 100 {
        let before = world.statistics().plane_collisions;
        world.step().unwrap();
        if world.statistics().plane_collisions > before {
            places.push(world.grain(0).unwrap().position.into());
        }
    }
    places
}

fn same<const D: usize>(facets: Vec<Facet<f64, D>>, (gravity, restitution): ([f64; D], f64)) {
    let planes = bounces(&mut HeapMemory::<f64, D>::with_capacity(1), (gravity, restitution), true);
    let among = bounces(&mut room(1, facets), (gravity, restitution), false);
    for (n, (a, b)) in planes.iter().zip(&among).enumerate() {
        for (x, y) in a.iter().zip(b) {
            assert!((x - y).abs() < 1e-9 * 0.2, "bounce {n}: {a:?}, {b:?}");
        }
    }
}

fn square(restitution: f64) -> Vec<Facet<f64, 2>> {
    let corners = [[0.0, 0.0], [0.4, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    ring(&corners, Surface::Hard(restitution))
}

#[test]
fn a_square_of_segments_is_a_box_of_planes() {
    same(square(1.0), ([0.0, 0.0], 1.0));
    same(square(1.0), ([0.0, -0.7], 1.0));
    same(square(0.999), ([0.3, -0.7], 0.999));
}

#[test]
fn a_cube_of_twelve_triangles_is_a_box_of_planes() {
    same(cube(Surface::Hard(1.0)), ([0.0; 3], 1.0));
    same(cube(Surface::Hard(1.0)), ([0.0, 0.1, -0.7], 1.0));
}
