//! Is a box of segments or triangles the same as one of planes?

use super::shapes::{cube, ring, room};
use carom::law::HardSphere;
use carom::scalar::{I32F32, Real};
use carom::space::{Facet, Surface};
use carom::world::WithObstacles;
use carom::{Grain, HeapMemory, Scalar, Storage, World};

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

/// A disk that nothing else concerns, so that a look has no end in time, in a room away from the origin.
fn lone_disk_stays<S: Scalar>(to: fn(f64) -> S, places: usize) {
    for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let corners = [[3.0, 3.0], [4.0, 3.0], [4.0, 4.0], [3.0, 4.0]];
        let corners = corners.map(|[a, b]| [to(a * x), to(b * y)]);
        let side = |k: usize| Facet::new([corners[k], corners[(k + 1) % 4]], Surface::Rule);
        let facets: Vec<Facet<S, 2>> = (0..4).map(side).collect();
        let lists = vec![Default::default(); places];
        let places = HeapMemory::<S, 2>::with_capacity(1);
        let mut memory = WithObstacles::new(places, facets, lists);
        for velocity in [[0.5, 0.0], [-0.5, 0.0], [0.0, 0.5], [0.0, -0.5], [0.3, -0.4]] {
            let disk = Grain::with_mass(to(0.1), S::one());
            let disk = disk.at([to(3.4 * x), to(3.4 * y)]).moving(velocity.map(to));
            let mut world = World::builder(&mut memory)
                .rule(HardSphere { restitution: S::one() })
                .grain(disk)
                .unwrap()
                .start()
                .unwrap();
            world.advance_to(100.0).unwrap();
            let at: [f64; 2] = world.grain(0).unwrap().position.map(S::to_f64).into();
            assert!(at.iter().all(|x| (3.0..4.0).contains(&x.abs())), "{velocity:?}: {at:?}");
            assert!(world.statistics().plane_collisions >= 50);
        }
    }
}

#[test]
fn a_lone_disk_stays_in_a_room_away_from_the_origin() {
    for places in [6, 200] {
        lone_disk_stays::<f64>(|x| x, places);
        lone_disk_stays::<f32>(|x| x as f32, places);
        lone_disk_stays::<I32F32>(I32F32::from_f64, places);
    }
}
