//! Do piles come to rest, hard and soft ones, and fall when their support goes? Reads worlds; compares with lying still.

use crate::rest::at_rest;
use carom::law::{HardSphere, Outside, Soft, Viscoelastic};
use carom::space::{Plane, Surface};
use carom::{Enduring, Grain, Memory, Scalar, World};

const G: f64 = 9.81;

/// A pile of unequal grains between walls: in the end everything lies still, nothing has sunk into
/// anything, and nothing more will happen.
fn pile<const D: usize, const N: usize>(epsilon: f64, row: usize) {
    let mut memory = Memory::<f64, D, N>::new();
    let grains = (0..N).map(|i| {
        let radius = 0.4 + 0.08 * ((7 * i) % 5) as f64 / 5.0;
        let level = i / row.pow(D as u32 - 1);
        let mut at = [0.6 + 1.1 * level as f64; D];
        for (axis, x) in at.iter_mut().enumerate().take(D - 1) {
            let place = i / row.pow(axis as u32) % row;
            *x = 0.6 + place as f64 + 0.1 * (0.7 * (level + axis) as f64).sin();
        }
        Grain::with_mass(radius, radius.powi(D as i32)).at(at)
    });
    let wide = row as f64 + 0.2;
    let mut sides = [[0.0, wide]; D];
    sides[D - 1][1] = 100.0;
    let mut gravity = [0.0; D];
    gravity[D - 1] = -G;
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .hard_walls(sides, epsilon)
        .gravity(gravity)
        .rule(HardSphere { restitution: epsilon })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let mut t = 0.0;
    while at_rest(world.view()) < N {
        t += 0.25;
        world.advance_to(t).unwrap();
        let events = world.statistics().events();
        assert!(events < 400_000, "{t}: {} rest, {:?}", at_rest(world.view()), world.statistics());
    }
    // A grain may still slide on the smooth floor; if none does, nothing happens any more.
    let before = world.statistics().events();
    if world.view().kinetic_energy() < 1e-9 {
        world.advance_to(t + 10.0).unwrap();
        assert_eq!(at_rest(world.view()), N);
        assert!(world.statistics().events() - before < 100, "{:?}", world.statistics());
    }
    for i in 0..N {
        for k in 0..i {
            let (a, b) = (world.grain(i).unwrap(), world.grain(k).unwrap());
            let separation = a.position - b.position;
            let gap = separation.dot(&separation).sqrt() - a.radius - b.radius;
            assert!(gap > -1e-12, "{i} and {k} overlap: {gap:e}");
        }
    }
}

#[test]
fn a_pile_comes_to_rest_as_one() {
    pile::<2, 20>(0.5, 4);
    pile::<2, 12>(0.0, 3);
    pile::<2, 12>(0.9, 3);
    pile::<3, 18>(0.5, 3);
}

/// One grain lies on another, which is shot away from under it. Whenever clocks are set back meanwhile,
/// the upper one must check whether it is still supported: the more elastic the grains, the more bounces before.
fn shot_away<S: Scalar>(cases: u32) {
    const R: f64 = 1.0e-3;
    let s = S::from_f64;
    let mut rested = 0;
    for k in 0..cases {
        let epsilon = s(0.3 + 0.5 * f64::from(k) / f64::from(cases));
        let mut memory = Memory::<S, 2, 3>::new();
        let grain = Grain::sphere(s(R), s(2500.0));
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .gravity([s(0.0), s(-9.81)])
            .plane(Plane::new([s(0.0), s(1.0)], s(0.0), Surface::Hard(epsilon)))
            .rule(HardSphere { restitution: epsilon })
            .grains([grain.at([s(0.0), s(R)]), grain.at([s(0.0), s(3.3 * R)])])
            .unwrap()
            .grain(grain.at([s(-10.0 * R), s(R)]).moving([s(0.02), s(0.0)]))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(s(0.35)).unwrap();
        rested += u32::from(world.view().is_at_rest(1));
        world.advance_to(s(0.6)).unwrap();
        let upper = world.grain(1).unwrap().position[1].to_f64();
        assert!(upper < 2.9 * R, "case {k}: {upper}");
    }
    assert!(rested > cases / 2, "only {rested} lay still before: the test shows nothing");
}

#[test]
fn what_lies_on_a_grain_that_is_shot_away_falls() {
    shot_away::<f32>(400);
    shot_away::<f64>(40);
}

/// Soft grains that settle in a heap: their contacts cannot turn there without overlapping a third body
/// (MP13's exception a), and slow ones must not go on for ever as hops of hard spheres do.
#[test]
fn a_heap_of_soft_grains_settles() {
    const N: usize = 30;
    const R: f64 = 2.0e-3;
    let (pitch, row) = (2.5 * R, 6);
    let rubber = Viscoelastic { young: 5.0e6, poisson: 0.4, dissipation: 1.0e-4 };
    let grains = (0..N).map(|i| {
        let size = R * (1.0 - 0.3 * (i * 7 % 11) as f64 / 11.0);
        let at = [i % row, i / row].map(|place| (place as f64 + 0.5) * pitch);
        Grain::sphere(size, 1140.0).at(at).moving([0.02 * ((i * 13 % 7) as f64 - 3.0), 0.0])
    });
    let mut memory = Memory::<f64, 2, N>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .gravity([0.0, -G])
        .rule(Soft::viscoelastic(rubber, Outside::HardSphere))
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .plane(Plane::new([1.0, 0.0], 0.0, Surface::Rule))
        .plane(Plane::new([-1.0, 0.0], -pitch * row as f64, Surface::Rule))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let energy = world.view().kinetic_energy();
    for frame in 1..=40 {
        world.advance_to(0.01 * f64::from(frame)).unwrap();
        let statistics = *world.statistics();
        assert!(statistics.events() < 300_000, "{frame}: {statistics:?}");
    }
    assert!(world.statistics().rotation_refused > 1000, "nothing was in the way: no test");
    assert!(at_rest(world.view()) >= N - 2, "{} lie still", at_rest(world.view()));
    let left = world.view().kinetic_energy();
    assert!(left < 1e-4 * energy, "{left:e} of {energy:e}");
}

/// Grains that lose energy at each other but not at the floor: their hops on it become ever shorter, too,
/// and must end. And where nothing loses energy nowhere a hop may end.
#[test]
fn only_lossy_grains_come_to_rest_on_an_elastic_floor() {
    const N: usize = 24;
    let run = |epsilon: f64| {
        let mut memory = Memory::<f64, 2, N>::new();
        let side = Surface::Hard(epsilon.max(0.5));
        let grains = (0..N).map(|i| {
            let radius = 0.05 + 0.05 * (i * 7 % 11) as f64 / 11.0;
            let at = [0.25 * ((i % 12) as f64 + 0.5), 0.15 + 0.25 * (i / 12) as f64];
            let velocity = [0.3 * ((i * 13 % 7) as f64 - 3.0), 0.2 * ((i * 5 % 7) as f64 - 3.0)];
            Grain::with_mass(radius, radius * radius).at(at).moving(velocity)
        });
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .gravity([0.0, -G])
            .rule(HardSphere { restitution: epsilon })
            .plane(Plane::new([0.0, 1.0], 0.0, Surface::Hard(1.0)))
            .plane(Plane::new([1.0, 0.0], 0.0, side))
            .plane(Plane::new([-1.0, 0.0], -3.1, side))
            .grains(grains)
            .unwrap()
            .start()
            .unwrap();
        for frame in 1..=50 {
            world.advance_to(0.1 * f64::from(frame)).unwrap();
            assert!(world.statistics().events() < 200_000, "{frame}: {:?}", world.statistics());
        }
        (world.view().kinetic_energy(), world.statistics().rests)
    };
    let (left, rests) = run(0.6);
    assert!(left < 1e-3 && rests > 0, "{left:e}");
    let (left, rests) = run(1.0);
    assert!(left > 1e-2 && rests == 0, "{left:e}, {rests}");
}
