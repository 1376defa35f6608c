//! Is it the same however facets are found, after a restart, and in other numbers?

use super::shapes::{circle, ring, room};
use carom::law::HardSphere;
use carom::particle::Index;
use carom::scalar::{I32F32, Scalar};
use carom::space::{Facet, Surface};
use carom::world::WithObstacles;
use carom::{Error, Grain, HeapMemory, Storage, World};

const RULE: HardSphere<f64> = HardSphere { restitution: 0.95 };

/// A round room with a square and pegs in it, and grains around that.
fn facets() -> Vec<Facet<f64, 2>> {
    let mut facets = ring(&circle([0.0, 0.0], 2.0, 60), Surface::Hard(0.95));
    for peg in circle([0.0, 0.0], 1.6, 16) {
        facets.extend(ring(&circle(peg, 0.03, 3), Surface::Hard(1.0)));
    }
    facets.extend(ring(&[[-0.4, -0.4], [0.4, -0.4], [0.4, 0.4], [-0.4, 0.4]], Surface::Rule));
    facets
}

fn begin<M: Storage<f64, 2>>(
    memory: &mut M,
    gravity: [f64; 2],
) -> World<'_, f64, 2, HardSphere<f64>> {
    let grains = circle([0.0, 0.0], 1.2, 24).into_iter().enumerate().map(|(k, at)| {
        let v = [0.3 * (k as f64 * 1.7).sin(), 0.3 * (k as f64 * 2.3).cos()];
        Grain::with_mass(0.08, 1.0).at(at).moving(v)
    });
    World::builder(memory).gravity(gravity).rule(RULE).grains(grains).unwrap().start().unwrap()
}

#[test]
fn how_facets_are_listed_changes_no_bit() {
    for gravity in [[0.0, 0.0], [0.1, -1.0]] {
        let digests = [114, 500, 8000].map(|places| {
            let lists = vec![Index::default(); places];
            let mut memory = WithObstacles::new(HeapMemory::with_capacity(24), facets(), lists);
            let mut world = begin(&mut memory, gravity);
            world.advance_to(5.0).unwrap();
            assert!(world.statistics().plane_collisions > 5);
            world.digest()
        });
        assert_eq!(digests[0], digests[1]);
        assert_eq!(digests[0], digests[2]);
    }
}

#[test]
fn a_restored_world_goes_on_among_the_same_obstacles_only() {
    let mut memory = room(24, facets());
    let mut world = begin(&mut memory, [0.1, -1.0]);
    world.advance_to(2.0).unwrap();
    let saved = serde_json::to_string(&world.save()).unwrap();
    world.advance_to(4.0).unwrap();
    let digest = world.digest();
    let saved: carom::world::Snapshot<f64, 2, Vec<_>, Vec<_>> =
        serde_json::from_str(&saved).unwrap();
    let mut other = room(24, facets());
    let mut again = World::restore(&mut other, RULE, &saved).unwrap();
    again.advance_to(4.0).unwrap();
    assert_eq!(again.digest(), digest);
    let mut moved = facets();
    moved[3] = Facet::new([[0.9, 0.9], [1.0, 1.1]], Surface::Rule);
    for wrong in [moved, Vec::new()] {
        let mut memory = room(24, wrong);
        let refused = World::restore(&mut memory, RULE, &saved).err().unwrap();
        assert!(matches!(refused, Error::Input { .. }), "{refused}");
    }
}

/// A ball in a room of six corners, in these numbers.
fn bounces<S: Scalar>(gravity: f64) -> u64 {
    let n = S::from_f64;
    let corners = circle([0.0, 0.0], 8.0, 6).into_iter().map(|corner| corner.map(n));
    let corners: Vec<[S; 2]> = corners.collect();
    let next = corners.iter().cycle().skip(1);
    let sides: Vec<_> = corners
        .iter()
        .zip(next)
        .map(|(&a, &b)| Facet::new([a, b], Surface::Hard(n(0.999))))
        .collect();
    let lists = vec![Index::default(); 100];
    let mut memory = WithObstacles::new(HeapMemory::<S, 2>::with_capacity(1), sides, lists);
    let grain = Grain::with_mass(n(0.5), n(1.0)).moving([n(3.0), n(2.1)]);
    let mut world = World::builder(&mut memory)
        .gravity([n(0.0), n(gravity)])
        .rule(HardSphere { restitution: n(0.999) })
        .grain(grain)
        .unwrap()
        .start()
        .unwrap();
    for t in 1..400 {
        world.advance_to(n(f64::from(t))).unwrap();
        let at = world.grain(0).unwrap().position.map(|x| x.to_f64());
        // The flats are at 8 cos 30°.
        assert!(at.norm() < 8.0 - 0.49 && at.y.abs() < 8.0 * 0.75_f64.sqrt() - 0.499, "{at:?}");
    }
    world.statistics().plane_collisions
}

#[test]
fn floats_and_fixed_point_stay_inside() {
    for gravity in [0.0, -0.5] {
        let counts = [bounces::<f64>(gravity), bounces::<f32>(gravity), bounces::<I32F32>(gravity)];
        assert!(counts.iter().all(|count| *count > 60), "{counts:?}");
        assert!(counts.iter().all(|count| count.abs_diff(counts[0]) < 40), "{counts:?}");
    }
}
