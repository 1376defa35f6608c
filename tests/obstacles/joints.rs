//! What happens where facets meet? At joints, corners and edges.

use super::shapes::{cube, ring, room};
use carom::law::HardSphere;
use carom::space::{Facet, Surface, chain};
use carom::{Grain, World};

const ELASTIC: HardSphere<f64> = HardSphere { restitution: 1.0 };

#[test]
fn a_flat_joint_gives_one_bounce() {
    // Straight down onto the joint of two segments, and beside it.
    for x in [0.0, 1e-17, -1e-9, 1e-6, 0.05] {
        for gravity in [0.0, -1.0] {
            let points = [[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]];
            let mut memory = room(1, chain(&points, Surface::Hard(1.0)).collect());
            let grain = Grain::with_mass(0.1, 1.0).at([x, 1.1]).moving([0.0, -1.0]);
            let mut world = World::builder(&mut memory)
                .gravity([0.0, gravity])
                .rule(ELASTIC)
                .grain(grain)
                .unwrap()
                .start()
                .unwrap();
            let flight = if gravity == 0.0 { 1.0 } else { 3.0_f64.sqrt() - 1.0 };
            world.advance_to(1.5 * flight).unwrap();
            assert_eq!(world.statistics().plane_collisions, 1, "{x}, {gravity}");
            let after = world.grain(0).unwrap();
            assert!(after.velocity.x.abs() < 1e-7 && after.velocity.y > 0.5, "{x}, {gravity}");
        }
    }
}

#[test]
fn the_edge_between_the_triangles_of_a_side_gives_one_bounce() {
    // On the diagonal of the lowest side, and along it.
    for velocity in [[0.0, 0.0, -1.0], [0.5, 0.5, -1.0], [0.5, -0.5, -1.0]] {
        let mut memory = room(1, cube(Surface::Hard(1.0)));
        let grain = Grain::with_mass(0.1, 1.0).at([0.5; 3]).moving(velocity);
        let mut world =
            World::builder(&mut memory).rule(ELASTIC).grain(grain).unwrap().start().unwrap();
        world.advance_to(0.5).unwrap();
        assert_eq!(world.statistics().plane_collisions, 1);
        let after = world.grain(0).unwrap().velocity;
        assert!((after.z - 1.0).abs() < 1e-7 && (after.x - velocity[0]).abs() < 1e-7, "{after:?}");
    }
}

#[test]
fn a_corner_reflects_as_a_point_does() {
    // Aimed beside the end of a segment by b: the normal is at sin φ = b/R, the way turns by π − 2φ.
    let (radius, b) = (0.5, 0.2_f64);
    for gravity in [0.0, -1e-12] {
        let mut memory = room(1, vec![Facet::new([[0.0, 0.0], [0.0, -3.0]], Surface::Hard(1.0))]);
        let grain = Grain::with_mass(radius, 1.0).at([b, 3.0]).moving([0.0, -1.0]);
        let mut world = World::builder(&mut memory)
            .gravity([0.0, gravity])
            .rule(ELASTIC)
            .grain(grain)
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(4.0).unwrap();
        let (sin, v) = (b / radius, world.grain(0).unwrap().velocity);
        let turned = [2.0 * sin * (1.0 - sin * sin).sqrt(), 1.0 - 2.0 * sin * sin];
        assert!((v.x - turned[0]).abs() < 1e-10 && (v.y - turned[1]).abs() < 1e-10, "{v:?}");
        let x = world.grain(0).unwrap().position;
        // It touched at a height of (R² − b²)^½.
        let touch = 3.0 - (radius * radius - b * b).sqrt();
        assert!((x.x - (b + turned[0] * (4.0 - touch))).abs() < 1e-9, "{x:?}");
    }
}

#[test]
fn an_edge_reflects_as_a_line_does() {
    let facets =
        vec![Facet::new([[0.0, -5.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, -4.0]], Surface::Hard(1.0))];
    let (radius, b) = (0.5, 0.2_f64);
    let mut memory = room(1, facets);
    let grain = Grain::with_mass(radius, 1.0).at([b, 0.3, 3.0]).moving([0.0, 0.1, -1.0]);
    let mut world =
        World::builder(&mut memory).rule(ELASTIC).grain(grain).unwrap().start().unwrap();
    world.advance_to(4.0).unwrap();
    let (sin, v) = (b / radius, world.grain(0).unwrap().velocity);
    let turned = [2.0 * sin * (1.0 - sin * sin).sqrt(), 0.1, 1.0 - 2.0 * sin * sin];
    for (axis, wanted) in turned.into_iter().enumerate() {
        assert!((v[axis] - wanted).abs() < 1e-12, "{v:?}");
    }
}

#[test]
fn what_flies_over_the_end_of_a_shelf_lands_on_it_from_above() {
    // Thrown up beside the shelf, it comes down on it: the plane of the shelf is crossed twice before.
    let mut memory = room(1, vec![Facet::new([[0.0, 0.0], [2.0, 0.0]], Surface::Hard(1.0))]);
    let grain = Grain::with_mass(0.1, 1.0).at([-0.5, -1.0]).moving([0.5, 2.2]);
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -1.0])
        .rule(ELASTIC)
        .grain(grain)
        .unwrap()
        .start()
        .unwrap();
    let event = world.step_until(10.0).unwrap().unwrap();
    let at = world.grain(0).unwrap().position;
    assert_eq!(event.partner.as_facet(), Some(0));
    assert!((at.y - 0.1).abs() < 1e-12 && at.x > 0.5, "{at:?}");
}

#[test]
fn narrow_corners_hold() {
    // Down into a corner of one degree, where a ball is wedged between two sides at last.
    let half = 0.5_f64.to_radians().tan();
    let corners = [[0.0, 0.0], [10.0 * half, 10.0], [-10.0 * half, 10.0]];
    for restitution in [0.0, 0.5, 0.9, 1.0] {
        let mut memory = room(1, ring(&corners, Surface::Hard(restitution)));
        let mut world = World::builder(&mut memory)
            .gravity([0.0, -1.0])
            .rule(HardSphere { restitution })
            .grain(Grain::with_mass(0.01, 1.0).at([0.0, 9.0]).moving([0.1, 0.0]))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(20.0).unwrap();
        let at = world.grain(0).unwrap().position;
        // As low as it gets the ball touches both sides: it is R/sin ½° from the tip.
        // Its weight presses 57 times as hard on each, and it sinks in by some hundredths of R.
        let lowest = 0.01 / 0.5_f64.to_radians().sin();
        assert!(at.y > 0.96 * lowest && at.x.abs() < 0.01, "{restitution}: {at:?}, {lowest}");
    }
}
