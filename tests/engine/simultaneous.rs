//! Which of several collisions at one instant comes first? Rows of grains that all touch at once; compares LRV.

use carom::law::{Answer, HardSphere, Impact, Outcome, Response, Rule};
use carom::space::{Plane, Surface};
use carom::world::EventKind;
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

/// A grain that touches a wall and a neighbour at one instant: the wall first if it is hit faster.
#[test]
fn a_wall_is_hit_first_if_it_is_hit_fastest() {
    for (velocities, wall_first) in [([-3.0, -4.0], true), ([-1.0, -4.0], false)] {
        let [v, w] = velocities;
        let mut memory = Memory::<f64, 1, 2>::new();
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([1.0], 0.0, Surface::Hard(0.5)))
            .rule(HardSphere { restitution: 0.5 })
            .grain(Grain::with_mass(0.5, 1.0).at([0.5 - v]).moving([v]))
            .unwrap()
            .grain(Grain::with_mass(0.5, 1.0).at([1.5 - w]).moving([w]))
            .unwrap()
            .start()
            .unwrap();
        let event = world.step().unwrap().unwrap();
        assert_eq!(event.at.as_f64(), 1.0);
        assert_eq!(event.partner.as_plane().is_some(), wall_first, "{velocities:?}");
    }
}

/// Grains that hit a wall at one instant, each by itself: the fastest first, of equals the lowest number.
#[test]
fn grains_that_hit_a_wall_at_one_instant_do_so_by_speed_then_by_number() {
    let order = |speeds: &[f64]| -> Vec<usize> {
        let mut memory = Memory::<f64, 2, 8>::new();
        let at = |(i, v): (u32, &f64)| {
            Grain::with_mass(0.5, 1.0).at([f64::from(2 * i), 0.5 + v]).moving([0.0, -v])
        };
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([0.0, 1.0], 0.0, Surface::Hard(1.0)))
            .rule(HardSphere { restitution: 1.0 })
            .grains((0..).zip(speeds).map(at))
            .unwrap()
            .start()
            .unwrap();
        let mut next = || loop {
            let event = world.step().unwrap().unwrap();
            if event.kind == EventKind::Collision {
                assert_eq!(event.at.as_f64(), 1.0);
                return event.grain;
            }
        };
        speeds.iter().map(|_| next()).collect()
    };
    assert_eq!(order(&[1.0, 2.0]), [1, 0]);
    assert_eq!(order(&[1.0, 4.0, 2.0, 8.0, 0.5]), [3, 1, 2, 0, 4]);
    for n in 2..=8 {
        assert_eq!(order(&[1.0; 8][..n]), (0..n).collect::<Vec<_>>());
    }
}

/// A contact of half a unit of time, as elastic as can be.
struct Half;

impl Rule<f64> for Half {
    fn collide(&self, _: &Impact<f64>) -> Answer<f64> {
        let (restitution, separation) = (1.0, 1.0);
        let outcome = Outcome { duration: 0.5, restitution, separation, angle: 0.0 };
        Answer::exact(Response::Lasting(outcome))
    }
}

/// A contact that ends at the instant at which another begins ends first, whatever the numbers.
#[test]
fn a_contact_ends_before_others_begin_at_that_instant() {
    let pair = |at: f64, speed: f64| {
        [-1.0, 1.0].map(|side| Grain::with_mass(0.5, 1.0).at([at + side]).moving([-side * speed]))
    };
    // A gap of 1 closes at 1.5 with speeds of 1/3 each, at 1 with 1/2.
    for (first, second) in [(1.0 / 3.0, 0.5), (0.5, 1.0 / 3.0)] {
        let mut memory = Memory::<f64, 1, 4>::new();
        let mut world = World::builder(&mut memory)
            .rule(Half)
            .grains(pair(0.0, first).into_iter().chain(pair(64.0, second)))
            .unwrap()
            .start()
            .unwrap();
        let kinds = [(); 4].map(|()| {
            let event = world.step().unwrap().unwrap();
            (event.at.as_f64(), event.kind)
        });
        let expected = [
            (1.0, EventKind::Collision),
            (1.5, EventKind::ContactEnd),
            (1.5, EventKind::Collision),
            (2.0, EventKind::ContactEnd),
        ];
        assert_eq!(kinds, expected);
    }
}

/// Where all grains of a mirror-symmetric rack are, hit by one on the axis.
fn rack(restitution: f64, end: f64) -> Vec<[f64; 2]> {
    let mut memory = Memory::<f64, 2, 16>::new();
    let ball = Grain::with_mass(1.0, 1.0);
    // Not in touch, so that rows are hit one after the other, each at one instant.
    let (dx, dy) = (1.74, 1.0005);
    let sites = (0..5)
        .flat_map(|row| (0..=row).map(move |k| [dx * f64::from(row), dy * f64::from(2 * k - row)]));
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution })
        .grain(ball.at([-10.0, 0.0]).moving([1.0, 0.0]))
        .unwrap()
        .grains(sites.map(|at| ball.at(at)))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(end).unwrap();
    let momentum = world.view().momentum();
    assert!((momentum[0] - 1.0).abs() < 1e-13 && momentum[1].abs() < 1e-13, "{momentum}");
    if restitution == 1.0 {
        assert!((world.view().kinetic_energy() - 0.5).abs() < 1e-13);
    }
    (0..16).map(|i| world.grain(i).unwrap().position.into()).collect()
}

/// Collisions at one instant that share a grain have no order: what is symmetric stays so.
#[test]
fn a_rack_that_is_hit_on_its_axis_stays_symmetric() {
    // Until all have parted; what loses much energy stays together, and rounding grows with each of its collisions.
    for (restitution, end) in [(1.0, 60.0), (0.9, 60.0), (0.5, 8.4)] {
        let places = rack(restitution, end);
        for [x, y] in &places {
            let mirrored = |[u, v]: &[f64; 2]| (x - u).abs() + (y + v).abs();
            let nearest = places.iter().map(mirrored).fold(f64::MAX, f64::min);
            assert!(nearest < 1e-11, "{restitution}: {x} {y} {nearest:e}");
        }
    }
}

/// Three, four or six equal ones that hit one from all sides at one instant leave it at rest and go back with ε.
#[test]
fn hard_ones_that_hit_one_from_all_sides_leave_it_at_rest() {
    for (count, restitution) in [(3, 1.0), (3, 0.5), (4, 1.0), (6, 1.0), (6, 0.3)] {
        for turn in [0.0, 0.1, 0.37, 1.0] {
            let mut memory = Memory::<f64, 2, 7>::new();
            let around = (0..count).map(|i| {
                let angle = turn + f64::from(i) * std::f64::consts::TAU / f64::from(count);
                let (sin, cos) = angle.sin_cos();
                Grain::with_mass(1.0, 1.0).at([5.0 * cos, 5.0 * sin]).moving([-cos, -sin])
            });
            let mut world = World::builder(&mut memory)
                .rule(HardSphere { restitution })
                .grain(Grain::with_mass(1.0, 1.0))
                .unwrap()
                .grains(around)
                .unwrap()
                .start()
                .unwrap();
            world.advance_to(5.0).unwrap();
            let speed = |i| world.grain(i).unwrap().velocity.norm();
            assert!(speed(0) < 1e-14, "{count} {turn}: {}", speed(0));
            for i in 1..=count as usize {
                assert!((speed(i) - restitution).abs() < 1e-14, "{count} {turn}: {}", speed(i));
            }
        }
    }
}

/// In a cradle pairs near each other one after the other: k come in, k go out, and the others stay.
#[test]
fn a_cradle_of_hard_balls_stays_exact() {
    for coming in 1..5 {
        let mut memory = Memory::<f64, 1, 5>::new();
        let at = |i: usize| if i < coming { -10.0 + 2.0 * i as f64 } else { 2.0 * i as f64 };
        let speed = |i: usize| if i < coming { 1.0 } else { 0.0 };
        let mut world = World::builder(&mut memory)
            .rule(HardSphere { restitution: 1.0 })
            .grains((0..5).map(|i| Grain::with_mass(1.0, 1.0).at([at(i)]).moving([speed(i)])))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(30.0).unwrap();
        for i in 0..5 {
            let right = if i >= 5 - coming { 1.0 } else { 0.0 };
            let is = world.grain(i).unwrap().velocity[0];
            assert!((is - right).abs() < 1e-12, "{coming} in: {i} has {is}");
        }
    }
}
