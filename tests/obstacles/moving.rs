//! Do grains meet obstacles that move where they must? Groups of facets that vibrate, go on steadily or turn.

use super::shapes::{Draw, Room, circle, cube, icosphere, ring, room};
use carom::law::HardSphere;
use carom::scalar::{I32F32, Scalar, Vector};
use carom::space::{Drift, Facet, Plane, RigidMotion, Surface, Vibration};
use carom::world::{NoMotion, WithObstacles};
use carom::{Grain, HeapMemory, Storage, World};

const ELASTIC: HardSphere<f64> = HardSphere { restitution: 1.0 };
const WALL: Surface<f64> = Surface::Hard(1.0);

/// A room whose facets move so.
type Moved<S, const D: usize> = WithObstacles<
    HeapMemory<S, D>,
    Vec<Facet<S, D>>,
    Vec<carom::particle::Index>,
    [RigidMotion<S, D>; 1],
>;

fn moved<S: Scalar, const D: usize>(room: Room<S, D>, motion: RigidMotion<S, D>) -> Moved<S, D> {
    let facets = room.facets.into_iter().map(|facet| facet.moving(0)).collect();
    WithObstacles::new(room.memory, facets, room.lists).moving([motion])
}

fn square(half: f64) -> Vec<Facet<f64, 2>> {
    ring(&[[-half, -half], [half, -half], [half, half], [-half, half]], WALL)
}

/// What a ball in a box that turns keeps: its energy less ω times its angular momentum about the axis (Jacobi's integral).
fn jacobi<const D: usize>(grain: &Grain<f64, D>, centre: [f64; D], omega: [f64; 3]) -> f64 {
    let at = |v: &Vector<f64, D>, k: usize| v.get(k).copied().unwrap_or(0.0);
    let r = grain.position - Vector::from(centre);
    let v = grain.velocity;
    let l = [
        at(&r, 1) * at(&v, 2) - at(&r, 2) * at(&v, 1),
        at(&r, 2) * at(&v, 0) - at(&r, 0) * at(&v, 2),
        at(&r, 0) * at(&v, 1) - at(&r, 1) * at(&v, 0),
    ];
    v.norm_squared() / 2.0 - omega.iter().zip(l).map(|(w, l)| w * l).sum::<f64>()
}

#[test]
fn a_box_that_turns_keeps_jacobi_s_integral() {
    let shapes = [square(1.0), ring(&circle([0.3, -0.2], 1.0, 7), WALL)];
    for (facets, omega) in shapes.into_iter().zip([0.7, -2.5]) {
        let mut memory = moved(room(1, facets), RigidMotion::<f64, 2>::turning([0.2, 0.1], omega));
        let grain = Grain::with_mass(0.1, 1.0).at([0.1, 0.05]).moving([0.8, 0.55]);
        let mut world =
            World::builder(&mut memory).rule(ELASTIC).grain(grain).unwrap().start().unwrap();
        let now = |world: &World<'_, f64, 2, _>| {
            jacobi(&world.grain(0).unwrap(), [0.2, 0.1], [0.0, 0.0, omega])
        };
        let before = now(&world);
        while world.statistics().plane_collisions < 20_000 {
            world.step().unwrap();
        }
        assert!((now(&world) - before).abs() < 1e-9, "{}", now(&world) - before);
    }
}

#[test]
fn so_does_one_in_space_about_a_slanted_axis() {
    let omega = [0.4, -0.9, 0.3];
    for facets in [cube(WALL), icosphere(1.0, 1, WALL)] {
        let mut memory =
            moved(room(1, facets), RigidMotion::<f64, 3>::turning([0.4, 0.5, 0.45], omega));
        let grain = Grain::with_mass(0.1, 1.0).at([0.45, 0.4, 0.35]).moving([0.8, 0.55, -0.3]);
        let mut world =
            World::builder(&mut memory).rule(ELASTIC).grain(grain).unwrap().start().unwrap();
        let now = |world: &World<'_, f64, 3, _>| {
            jacobi(&world.grain(0).unwrap(), [0.4, 0.5, 0.45], omega)
        };
        let before = now(&world);
        while world.statistics().plane_collisions < 5_000 {
            world.step().unwrap();
        }
        assert!((now(&world) - before).abs() < 1e-9, "{}", now(&world) - before);
    }
}

#[test]
fn a_room_that_goes_on_steadily_is_one_that_stands() {
    let u = [0.3, -0.7];
    let begin = |moving: bool| {
        let room = room(4, ring(&circle([0.0, 0.0], 1.0, 24), Surface::Hard(0.9)));
        let motion = RigidMotion::drifting(if moving { u } else { [0.0, 0.0] });
        (moved(room, motion), if moving { u } else { [0.0, 0.0] })
    };
    let run = |(mut memory, u): (_, [f64; 2])| {
        let mut builder = World::builder(&mut memory).rule(HardSphere { restitution: 0.9 });
        for (k, at) in [[0.3, 0.1], [-0.4, 0.2], [0.1, -0.5], [0.0, 0.6]].into_iter().enumerate() {
            let k = k as f64;
            let grain = Grain::with_mass(0.1 + 0.02 * k, 1.0).at(at);
            builder = builder.grain(grain.moving([1.0 - k + u[0], 0.3 * k + u[1]])).unwrap();
        }
        let mut world = builder.start().unwrap();
        world.advance_to(5.0).unwrap();
        let shift = Vector::from(u) * 5.0;
        let places = (0..4).map(|i| world.grain(i).unwrap().position - shift);
        (places.collect::<Vec<_>>(), world.statistics().plane_collisions)
    };
    let ((moving, many), (standing, as_many)) = (run(begin(true)), run(begin(false)));
    assert!(many == as_many && many > 10, "{many} {as_many}");
    for (a, b) in moving.iter().zip(&standing) {
        assert!((a - b).norm() < 1e-9, "{}", (a - b).norm());
    }
}

/// A ball on a floor that is a segment or a plane, and moves.
fn heights<M: Storage<f64, 2>>(
    memory: &mut M,
    floor: Option<Plane<f64, 2>>,
    gravity: f64,
) -> Vec<f64> {
    let mut builder =
        World::builder(memory).gravity([0.0, -gravity]).rule(HardSphere { restitution: 0.6 });
    if let Some(floor) = floor {
        builder = builder.plane(floor);
    }
    let grain = Grain::with_mass(0.1, 1.0).at([0.0, 1.0]).moving([0.01, -1.0]);
    let mut world = builder.grain(grain).unwrap().start().unwrap();
    (1..=60)
        .map(|k| {
            world.advance_to(f64::from(k) * 0.05).unwrap();
            world.grain(0).unwrap().position[1]
        })
        .collect()
}

#[test]
fn a_segment_that_shakes_or_rises_is_a_plane_that_does() {
    let facets = || vec![Facet::new([[-5.0, 0.0], [5.0, 0.0]], WALL)];
    let plane = || Plane::new([0.0, 1.0], 0.0, WALL);
    let shaken = plane().vibrating(Vibration::new(0.05, 3.0).starting_at(0.3));
    let motion = RigidMotion::vibrating([0.0, 0.05], 3.0).starting_at(0.3);
    let rising = plane().drifting(Drift::new(0.4));
    let pairs = [(shaken, motion, 9.81), (rising, RigidMotion::drifting([0.0, 0.4]), 0.0)];
    for (plane, motion, gravity) in pairs {
        let by_segment = heights(&mut moved(room(1, facets()), motion), None, gravity);
        let by_plane = heights(&mut HeapMemory::<f64, 2>::with_capacity(1), Some(plane), gravity);
        for (a, b) in by_segment.iter().zip(&by_plane) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

/// A round room with a cross that turns in it.
fn stirred(seed: u64, epsilon: f64, grains: usize) -> (Vec<Facet<f64, 2>>, Vec<Grain<f64, 2>>) {
    let surface = Surface::Hard(epsilon);
    let mut facets = ring(&circle([0.0, 0.0], 2.0, 40), surface);
    for [x, y] in [[0.9, 0.0], [0.0, 0.9]] {
        facets.push(Facet::new([[-x, -y], [x, y]], surface).moving(0));
    }
    let mut draw = Draw(seed);
    let mut placed: Vec<Grain<f64, 2>> = Vec::new();
    while placed.len() < grains {
        let radius = draw.between(0.03, 0.1);
        let [x, y] = draw.direction::<2>();
        let far = draw.between(1.05, 1.8);
        let grain = Grain::with_mass(radius, radius * radius).at([far * x, far * y]);
        let [u, v] = draw.direction::<2>();
        let grain = grain.moving([u, v]);
        let apart = |other: &Grain<f64, 2>| {
            (other.position - grain.position).norm() > other.radius + grain.radius
        };
        if placed.iter().all(apart) {
            placed.push(grain);
        }
    }
    (facets, placed)
}

#[test]
fn nothing_leaks_through_a_stirrer() {
    for (seed, omega) in [(1, 0.5), (2, -3.0), (3, 12.0)] {
        let (facets, grains) = stirred(seed, 0.8, 30);
        let lists = vec![Default::default(); 3000];
        let mut memory = WithObstacles::new(HeapMemory::with_capacity(30), facets, lists)
            .moving([RigidMotion::<f64, 2>::turning([0.0, 0.0], omega)]);
        let mut builder = World::builder(&mut memory).rule(HardSphere { restitution: 0.8 });
        for grain in grains {
            builder = builder.grain(grain).unwrap();
        }
        let mut world = builder.start().unwrap();
        let mut worst = 0.0_f64;
        for k in 1..200 {
            world.advance_to(f64::from(k) * 0.05).unwrap();
            let view = world.view();
            for i in 0..30 {
                let grain = view.grain(i).unwrap();
                let inside = 2.0 * (std::f64::consts::PI / 40.0).cos() - grain.radius;
                let r = grain.position;
                assert!(r.norm() < inside / (std::f64::consts::PI / 40.0).cos() + 1e-9, "{r:?}");
                for paddle in 40..42 {
                    let facet = view.facet(paddle).unwrap();
                    let [a, b] = *facet.corners();
                    let along = b - a;
                    let t = ((r - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
                    let gap = (r - a - along * t).norm() - grain.radius;
                    worst = worst.min(gap / grain.radius);
                }
            }
        }
        let bounces = world.statistics().plane_collisions;
        assert!(worst > -1e-9 && bounces > 80, "{seed}: {worst} of a radius, {bounces}");
    }
}

#[test]
fn a_saved_stirrer_goes_on_with_the_same_bits() {
    let (facets, grains) = stirred(5, 0.9, 12);
    let lists = vec![Default::default(); 3000];
    let motions = [RigidMotion::<f64, 2>::turning([0.0, 0.0], 2.0)];
    let still = WithObstacles::<_, _, _, NoMotion>::new(
        HeapMemory::<f64, 2>::with_capacity(12),
        facets.clone(),
        lists.clone(),
    );
    let mut memory = still.clone().moving(motions);
    let rule = HardSphere { restitution: 0.9 };
    let mut builder = World::builder(&mut memory).rule(rule);
    for grain in grains {
        builder = builder.grain(grain).unwrap();
    }
    let mut world = builder.start().unwrap();
    world.advance_to(5.0).unwrap();
    let saved = serde_json::to_string(&world.save()).unwrap();
    world.advance_to(9.0).unwrap();
    let digest = world.digest();
    let saved: carom::world::Snapshot<f64, 2, Vec<_>, Vec<_>> =
        serde_json::from_str(&saved).unwrap();
    let mut again = still.clone().moving(motions);
    let mut world = World::restore(&mut again, rule, &saved).unwrap();
    world.advance_to(9.0).unwrap();
    assert_eq!(world.digest(), digest);
    let mut other = still.moving([RigidMotion::<f64, 2>::turning([0.0, 0.0], 2.1)]);
    assert!(World::restore(&mut other, rule, &saved).is_err());
}

#[test]
fn other_numbers_keep_jacobi_s_integral_to_their_rounding() {
    fn lost<S: Scalar>() -> f64 {
        let n = S::from_f64;
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|c| c.map(n));
        let facets = carom::space::polygon(corners, Surface::Hard(n(1.0))).to_vec();
        let mut memory = moved(room(1, facets), RigidMotion::<S, 2>::turning([n(0.0); 2], n(0.5)));
        let grain = Grain::with_mass(n(0.25), n(1.0)).at([n(0.1), n(0.05)]);
        let mut world = World::builder(&mut memory)
            .rule(HardSphere { restitution: n(1.0) })
            .grain(grain.moving([n(0.8), n(0.55)]))
            .unwrap()
            .start()
            .unwrap();
        let now = |world: &World<'_, S, 2, _>| {
            let grain = world.grain(0).unwrap();
            let [r, v] = [grain.position, grain.velocity].map(|v| v.map(|x| x.to_f64()));
            v.norm_squared() / 2.0 - 0.5 * (r[0] * v[1] - r[1] * v[0])
        };
        let before = now(&world);
        while world.statistics().plane_collisions < 100 {
            world.step().unwrap();
        }
        (now(&world) - before).abs()
    }
    assert!(lost::<f64>() < 1e-12);
    assert!(lost::<f32>() < 1e-4, "{}", lost::<f32>());
    assert!(lost::<I32F32>() < 1e-6, "{}", lost::<I32F32>());
}

#[test]
fn what_cannot_move_so_is_refused() {
    let refused = |motions: Vec<RigidMotion<f64, 2>>| {
        let facets = vec![Facet::new([[-1.0, 0.0], [1.0, 0.0]], WALL).moving(0)];
        let lists = vec![Default::default(); 20];
        let mut memory =
            WithObstacles::new(HeapMemory::with_capacity(1), facets, lists).moving(motions);
        let started = World::builder(&mut memory)
            .rule(ELASTIC)
            .grain(Grain::with_mass(0.1, 1.0).at([0.0, 1.0]))
            .unwrap()
            .start();
        started.map(|_| ()).unwrap_err().to_string()
    };
    for (motions, words) in [
        (vec![], "motion"),
        (vec![RigidMotion::vibrating([0.1, f64::NAN], 1.0)], "amplitude"),
        (vec![RigidMotion::vibrating([0.1, 0.0], 0.0)], "frequency"),
        (vec![RigidMotion::<f64, 2>::turning([0.0, 0.0], 0.0)], "angular velocity"),
        (vec![RigidMotion::drifting([f64::INFINITY, 0.0])], "velocity"),
    ] {
        let said = refused(motions);
        assert!(said.contains(words) && said.contains("facet 0"), "{said}");
    }
}

#[test]
fn a_year_of_turns_is_exact() {
    // Nothing meets it for long; then a ball falls onto the bat as if it had just begun.
    let at = |start: f64| {
        let bat = vec![Facet::new([[0.0, 0.0], [-2.0, 0.0]], WALL).moving(0)];
        let lists = vec![Default::default(); 20];
        let omega = std::f64::consts::TAU * 0.25;
        let mut memory = WithObstacles::new(HeapMemory::with_capacity(1), bat, lists)
            .moving([RigidMotion::<f64, 2>::turning([0.0, 0.0], omega)]);
        let far = Grain::with_mass(0.25, 1.0).at([0.0, 50.0 + start]).moving([0.0, -1.0]);
        let mut world =
            World::builder(&mut memory).rule(ELASTIC).grain(far).unwrap().start().unwrap();
        world.advance_to(start + 60.0).unwrap();
        world.grain(0).unwrap().velocity
    };
    let (soon, late) = (at(0.0), at(4.0e6));
    assert!((soon - late).norm() < 1e-6 && soon.norm() > 1.0, "{soon:?} {late:?}");
}
