//! Does anything leak? Balls of random size, speed and loss in closed rooms, over many bounces.

use super::shapes::{Draw, ball, circle, icosphere, ring, room, tetrahedron};
use carom::law::HardSphere;
use carom::scalar::{I32F32, Real};
use carom::space::{Facet, Surface};
use carom::world::{Motion, WithObstacles};
use carom::{Grain, HeapMemory, Scalar, World};

/// How far a point is inside a convex room about the origin: the smallest distance to the planes through its facets.
fn depth<const D: usize>(facets: &[Facet<f64, D>], at: &[f64; D]) -> f64 {
    let inside = |facet: &Facet<f64, D>| -> f64 {
        let normal: [f64; D] = (*facet.normal()).into();
        let corner: [f64; D] = facet.corners()[0].into();
        let along = |point: &[f64; D]| -> f64 {
            normal.iter().zip(point).zip(&corner).map(|((n, x), c)| n * (x - c)).sum()
        };
        along(at) * along(&[0.0; D]).signum()
    };
    facets.iter().map(inside).fold(f64::INFINITY, f64::min)
}

/// So many bounces in a convex room about the origin, of balls that differ; energy is given back when it is lost.
fn bounce<const D: usize>(
    facets: &dyn Fn(Surface<f64>) -> Vec<Facet<f64, D>>,
    (bounces, gravity): (u64, [f64; D]),
    seed: u64,
) {
    let mut draw = Draw(seed);
    let mut left = bounces;
    while left > 0 {
        let restitution = if draw.next() < 0.3 { 1.0 } else { draw.between(0.2, 1.0) };
        let walls = facets(Surface::Hard(restitution));
        let radius = 0.3 * 10.0_f64.powf(draw.between(-3.0, 0.0));
        let speed = 10.0_f64.powf(draw.between(-2.0, 2.0));
        let velocity = draw.direction().map(|x| x * speed);
        let mut memory = room(1, walls.clone());
        let mut world = World::builder(&mut memory)
            .gravity(gravity)
            .rule(HardSphere { restitution })
            .grain(ball(radius, velocity))
            .unwrap()
            .start()
            .unwrap();
        let most = left.min(1000);
        let mut done = 0;
        while done < most {
            if world.step().unwrap().is_none() {
                // Nothing will ever happen: that must be since it lies still, not since it is gone.
                assert_eq!(world.view().motion(0), Some(Motion::Rest), "after {done}");
                break;
            }
            let now = world.statistics().plane_collisions;
            if now == done {
                // Those that lie still have nothing left to do.
                if world.statistics().steps > 200 {
                    break;
                }
                continue;
            }
            done = now;
            let at: [f64; D] = world.grain(0).unwrap().position.into();
            let gap = depth(&walls, &at) - radius;
            // The present is rounded: positions are, times the speed. What lies, or is wedged in, sinks in.
            let depth = if world.statistics().steps > 0 { 0.5 * radius } else { 1e-10 };
            assert!(gap > -depth, "radius {radius}, ε {restitution}: {gap} after {done}");
            if world.grain(0).unwrap().velocity.norm() < 1e-3 * speed {
                world.set_velocity(0, draw.direction().map(|x| x * speed)).unwrap();
            }
        }
        left -= most;
    }
}

fn hexagon(surface: Surface<f64>) -> Vec<Facet<f64, 2>> {
    ring(&circle([0.0, 0.0], 1.0, 6), surface)
}

fn round_room(surface: Surface<f64>) -> Vec<Facet<f64, 2>> {
    ring(&circle([0.0, 0.0], 1.0, 200), surface)
}

/// A wedge of one degree, closed at its wide end, and a chain that is almost straight.
fn wedge(surface: Surface<f64>) -> Vec<Facet<f64, 2>> {
    let half = 0.5_f64.to_radians().tan();
    ring(&[[-60.0, 0.0], [20.0, -80.0 * half], [20.1, 0.0], [20.0, 80.0 * half]], surface)
}

#[test]
fn nothing_leaks_in_two_dimensions() {
    bounce(&hexagon, (8_000, [0.0, 0.0]), 1);
    bounce(&hexagon, (8_000, [0.3, -1.0]), 2);
    bounce(&round_room, (8_000, [0.0, -1.0]), 3);
    bounce(&wedge, (8_000, [0.0, 0.0]), 4);
    bounce(&wedge, (4_000, [-1.0, 0.0]), 5);
}

#[test]
fn nothing_leaks_in_three_dimensions() {
    bounce(&tetrahedron, (4_000, [0.0; 3]), 6);
    bounce(&tetrahedron, (4_000, [0.1, 0.2, -1.0]), 7);
    bounce(&|surface| icosphere(1.0, 2, surface), (2_000, [0.0; 3]), 8);
    bounce(&|surface| icosphere(1.0, 2, surface), (2_000, [0.0, 0.0, -1.0]), 9);
}

#[test]
#[ignore = "minutes in release"]
fn ten_million_bounces_in_two_dimensions_and_a_million_in_three() {
    let (flat, deep) = ([0.1, -1.0], [0.1, 0.2, -1.0]);
    for (n, gravity) in [[0.0; 2], flat].into_iter().enumerate() {
        bounce(&hexagon, (1_800_000, gravity), 10 + n as u64);
        bounce(&round_room, (1_800_000, gravity), 20 + n as u64);
        bounce(&wedge, (1_400_000, gravity), 30 + n as u64);
    }
    for (n, gravity) in [[0.0; 3], deep].into_iter().enumerate() {
        bounce(&tetrahedron, (200_000, gravity), 40 + n as u64);
        bounce(&|surface| icosphere(1.0, 3, surface), (300_000, gravity), 50 + n as u64);
    }
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
