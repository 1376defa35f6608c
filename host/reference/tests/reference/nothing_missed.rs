//! Is every contact found, in any box, under any law, however many touch? Reads random systems; writes nothing.

use carom_reference::{Boundary, End, EventKind, Exact, ForceLaw, Grain, Partner, System};
use proptest::prelude::*;

use super::gas::Random;

const SIDE: f64 = 1.0;

fn system(seed: u64, boundary: [Boundary; 2], gravity: f64) -> System<2> {
    let mut random = Random(seed);
    let mut grain = |k: usize| {
        let radius = 0.08 + 0.06 * random.uniform();
        Grain {
            radius,
            mass: 100.0 * radius * radius,
            position: [0.17 + 0.33 * (k % 3) as f64, 0.17 + 0.33 * (k / 3) as f64],
            velocity: [random.normal(), random.normal()],
        }
    };
    System::new((0..8).map(&mut grain).collect(), boundary, [0.0, -gravity]).expect("valid")
}

/// Overlap and rate of every pair in every image, and of every grain and wall.
fn gaps(run: &Exact<2>, boundary: [Boundary; 2]) -> Vec<(usize, Partner, [f64; 2])> {
    let grains = run.grains();
    let mut all = Vec::new();
    for (i, a) in grains.iter().enumerate() {
        for (axis, bound) in boundary.iter().enumerate() {
            let Boundary::Walls { lo, hi } = *bound else { continue };
            let (r, v) = (a.position[axis], a.velocity[axis]);
            let wall = |upper| Partner::Wall { axis, upper };
            all.push((i, wall(false), [a.radius - (r - lo), -v]));
            all.push((i, wall(true), [a.radius - (hi - r), v]));
        }
        for (j, b) in grains.iter().enumerate().skip(i + 1) {
            let mut d = [0, 1].map(|k| a.position[k] - b.position[k]);
            for (d, bound) in d.iter_mut().zip(&boundary) {
                if matches!(bound, Boundary::Periodic { .. }) {
                    *d -= SIDE * (*d / SIDE).round();
                }
            }
            let distance = d[0].hypot(d[1]);
            let v = [0, 1].map(|k| a.velocity[k] - b.velocity[k]);
            let rate = -(d[0] * v[0] + d[1] * v[1]) / distance;
            all.push((i, Partner::Grain(j), [a.radius + b.radius - distance, rate]));
        }
    }
    all
}

fn law(kind: usize) -> (ForceLaw, f64) {
    let spheres = |dissipation| ForceLaw::Viscoelastic { young: 3e4, poisson: 0.3, dissipation };
    let spring = |damping| ForceLaw::LinearDashpot { stiffness: 3e3, damping };
    match kind {
        0 => (spheres(0.0), 0.0),
        1 => (spheres(0.01), 0.015),
        2 => (spring(0.0), 0.0),
        3 => (spring(10.0), 10.0 / 3e3),
        4 => (spring(200.0), 200.0 / 3e3),
        _ => (spheres(0.2), 0.3),
    }
}

/// Runs until `contacts` have begun; at every event, whatever overlaps and would push is in
/// contact, and whatever is in contact overlaps.
fn check(seed: u64, kind: usize, end: End, boundary: [Boundary; 2], gravity: f64, contacts: usize) {
    let (law, theta) = law(kind);
    let start = system(seed, boundary, gravity);
    let total =
        |s: &System<2>| s.kinetic_energy() + s.gravitational_energy() + s.elastic_energy(&law);
    let mut run = Exact::new(start.clone(), law, end).expect("valid");
    while run.records().len() < contacts && run.now() < 5.0 {
        let Some(event) = run.next_event(5.0).expect("integrates") else { break };
        let open = |i: usize, with: Partner| {
            run.records().iter().any(|r| r.grain == i && r.partner == with && r.end.is_none())
        };
        for (i, partner, [x, u]) in gaps(&run, boundary) {
            let just = run.records()[event.record];
            if event.kind == EventKind::End && (just.grain, just.partner) == (i, partner) {
                continue;
            }
            let pushes = if end == End::Force { x + theta * u } else { x };
            let what = format!(
                "seed {seed} kind {kind} {end:?}: {i} {partner:?} x {x:e} u {u:e} {event:?}"
            );
            if open(i, partner) {
                assert!(x > -1e-9, "open but apart: {what}");
            } else {
                assert!(x < 1e-9 || pushes < 1e-9, "missed: {what}");
            }
        }
    }
    // Soft enough, a centre may pass a wall; that is no system to start from, but no error of the run.
    let Ok(after) = run.system() else { return };
    if theta == 0.0 && gravity == 0.0 {
        let drift = total(&after) / total(&start) - 1.0;
        assert!(drift.abs() < 1e-11, "seed {seed} kind {kind}: {drift:e}");
    }
}

const WALLS: Boundary = Boundary::Walls { lo: 0.0, hi: SIDE };
const PERIODIC: Boundary = Boundary::Periodic { lo: 0.0, hi: SIDE };

fn case(seed: u64, kind: usize, overlap: bool, axes: usize, gravity: f64, contacts: usize) {
    let end = if overlap { End::Overlap } else { End::Force };
    let boundary = [[PERIODIC; 2], [PERIODIC, WALLS], [WALLS; 2]][axes];
    check(seed, kind, end, boundary, gravity, contacts);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn in_any_crowd(
        seed: u64,
        kind in 0..5_usize,
        overlap: bool,
        axes in 0..3_usize,
        gravity in prop_oneof![Just(0.0), Just(10.0)],
    ) {
        case(seed, kind, overlap, axes, gravity, 30);
    }
}

/// Overdamped grains that lie still: the error of a step is that of rounding there, which no shorter step makes
/// smaller. Steps became shorter and shorter until time stood still.
#[test]
fn in_a_heap_at_rest() {
    case(15_522_005_432_079_637_809, 4, true, 1, 10.0, 30);
    case(382_003_864_487_505_734, 4, true, 0, 10.0, 30);
}

#[test]
#[ignore = "many clusters: run with --release"]
fn in_many_dense_boxes() {
    for seed in 0..50 {
        for kind in 0..6 {
            let axes = (seed % 3) as usize;
            let gravity = if seed % 2 == 0 { 0.0 } else { 10.0 };
            case(seed, kind, seed % 5 < 2 && kind < 4, axes, gravity, 60);
        }
    }
}
