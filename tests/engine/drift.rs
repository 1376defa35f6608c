//! Do planes that go on steadily do what closed forms say? Runs pistons, moving boxes and rising floors.

use crate::gas::{damped_spring, gas};
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::particle::Body;
use carom::space::{Drift, Plane, Surface};
use carom::world::{ScheduledEvent, Snapshot};
use carom::{Enduring, Grain, HeapMemory, World};

/// A plane across an axis that goes on at this speed along it.
fn wall<const D: usize>(
    axis: usize,
    at: f64,
    up: bool,
    [speed, restitution]: [f64; 2],
) -> Plane<f64, D> {
    let sign = if up { 1.0 } else { -1.0 };
    let mut normal = [0.0; D];
    normal[axis] = sign;
    Plane::new(normal, sign * at, Surface::Hard(restitution)).drifting(Drift::new(sign * speed))
}

/// Elastic, between a wall at 0 and a piston that comes from L₀ at speed u: after the nth hit of the piston the ball
/// has the speed v₀ + 2 n u, and two hits at times t and t' = t + 2 L / (v + u), where L is the piston's place at t.
#[test]
fn a_ball_before_a_piston_is_as_fast_as_it_must_be() {
    let (radius, length, piston, start) = (0.01, 1.0, 1e-3, 0.7);
    let mut memory = HeapMemory::with_capacity(1);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([1.0], -radius, Surface::Hard(1.0)))
        .plane(wall(0, length + radius, false, [-piston, 1.0]))
        .rule(HardSphere { restitution: 1.0 })
        .grain(Grain::with_mass(radius, 1.0).moving([start]))
        .unwrap()
        .start()
        .unwrap();
    let (mut time, mut speed) = (length / (start + piston), start);
    for hit in 1..=200 {
        world.advance_to(time * (1.0 - 1e-12)).unwrap();
        assert!(world.grain(0).unwrap().velocity[0] > 0.0, "hit {hit}");
        world.advance_to(time * (1.0 + 1e-12)).unwrap();
        speed += 2.0 * piston;
        let found = world.grain(0).unwrap().velocity[0];
        assert!((found / -speed - 1.0).abs() < 1e-12, "hit {hit}: {found}");
        time += 2.0 * (length - piston * time) / (speed + piston);
    }
    assert!(world.statistics().epochs > 3, "times were never set back");
}

/// A gas in a box that moves is that gas in a box at rest, seen by somebody who moves.
fn seen_moving<R: Rule<f64> + Copy>(rule: R, enduring: Enduring, restitution: f64, until: f64) {
    let side = 6.0;
    let run = |speed: f64| {
        let mut memory = HeapMemory::with_capacity(25);
        let mut builder = World::builder(&mut memory).rule(rule).enduring(enduring);
        for axis in 0..2 {
            let along = if axis == 0 { speed } else { 0.0 };
            builder = builder.plane(wall(axis, 0.0, true, [along, restitution]));
            builder = builder.plane(wall(axis, side, false, [along, restitution]));
        }
        let grains = gas::<f64, 2>(25, 4, side, [0.2, 0.4]);
        let moved = grains.into_iter().map(|grain| {
            let v = grain.velocity;
            grain.moving([v[0] + speed, v[1]])
        });
        let mut world = builder.grains(moved).unwrap().start().unwrap();
        world.advance_to(until).unwrap();
        let collisions = world.statistics().collisions;
        let grains: Vec<_> = (0..25).map(|i| world.grain(i).unwrap()).collect();
        (collisions, grains)
    };
    let ((count, rest), (same, moving)) = (run(0.0), run(0.25));
    assert!(count > 20 && count == same, "{count} and {same}");
    for (a, b) in rest.iter().zip(&moving) {
        let apart = [b.position[0] - 0.25 * until - a.position[0], b.position[1] - a.position[1]];
        assert!(apart.iter().all(|x| x.abs() < 1e-8), "{apart:?}");
    }
}

#[test]
fn a_box_that_moves_is_one_at_rest() {
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        seen_moving(HardSphere { restitution: 0.9 }, enduring, 0.8, 6.0);
        let soft = Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere);
        seen_moving(soft, enduring, 0.8, 4.0);
    }
}

/// Grains that lie on a floor which rises steadily rise with it, and a run that is saved goes on with the same bits.
#[test]
fn what_lies_on_a_rising_floor_rises() {
    let rule = HardSphere { restitution: 0.5 };
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        let mut memory = HeapMemory::with_capacity(3);
        let mut world = World::builder(&mut memory)
            .enduring(enduring)
            .gravity([0.0, -1.0])
            .plane(wall(1, 0.0, true, [0.1, 0.5]))
            .rule(rule)
            .grains((0..3).map(|i| Grain::with_mass(0.5, 1.0).at([2.0 * f64::from(i), 1.0])))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(40.0).unwrap();
        let text = serde_json::to_string(&world.save()).unwrap();
        let saved: Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>> =
            serde_json::from_str(&text).unwrap();
        let mut other = HeapMemory::with_capacity(3);
        let mut again = World::restore(&mut other, rule, &saved).unwrap();
        world.advance_to(80.0).unwrap();
        again.advance_to(80.0).unwrap();
        assert_eq!(world.digest(), again.digest(), "{enduring:?}");
        for i in 0..3 {
            let grain = world.grain(i).unwrap();
            assert!((grain.position[1] - 8.5).abs() < 0.01, "{enduring:?}: {grain:?}");
        }
    }
}
