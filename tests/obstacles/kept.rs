//! Does friction hold over joints? What a contact remembers goes on from facet to facet.

use super::shapes::room;
use carom::law::{LinearDashpot, Outside, Rough, Soft, Tangential};
use carom::space::{ContactState, Facet, Surface, chain};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, World};

const RADIUS: f64 = 0.1;
const SPRING: LinearDashpot<f64> = LinearDashpot { stiffness: 1.0e4, damping: 5.0 };
/// Of two of these grains that touch.
const CONTACT_TIME: f64 = 0.016;

/// A straight floor of pieces this long, turned by an angle about the origin.
fn slope(angle: f64, length: f64, places: [f64; 2]) -> Vec<Facet<f64, 2>> {
    let [from, to] = places;
    let count = ((to - from) / length).round().max(1.0) as u32;
    let at = |k: u32| from + (to - from) * f64::from(k) / f64::from(count);
    let points: Vec<_> = (0..=count).map(at).map(|s| [s * angle.cos(), -s * angle.sin()]).collect();
    chain(&points, Surface::Rule).collect()
}

/// Where grains are, along the slope and above it, after so long.
fn after(
    time: f64,
    (angle, facets): (f64, Vec<Facet<f64, 2>>),
    grains: &[[f64; 2]],
    law: Tangential<f64>,
) -> Vec<[f64; 2]> {
    let rows = [(); 3].map(|()| vec![0.0; grains.len()]);
    let memory = Rotating::new(room(grains.len(), facets), rows);
    let mut memory = WithContacts::new(memory, vec![ContactState::VACANT; 64]);
    let turned =
        |[s, h]: [f64; 2]| [s * angle.cos() + h * angle.sin(), -s * angle.sin() + h * angle.cos()];
    let rule = Rough::disks(Soft::linear_dashpot(SPRING, Outside::HardSphere), law);
    let grains = grains.iter().map(|place| Grain::with_mass(RADIUS, 0.5).at(turned(*place)));
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -10.0])
        .rule(rule)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(time).unwrap();
    let back = |k: usize| {
        let [x, y]: [f64; 2] = world.grain(k).unwrap().position.into();
        [x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos()]
    };
    (0..world.view().len()).map(back).collect()
}

const HOLDING: Tangential<f64> = Tangential::Spring { mu: 0.6, stiffness: 4.0e3, damping: 2.0 };

/// Two that touch and one on them: friction alone keeps them from rolling apart. (A lone disk on a slope rolls: nothing
/// resists that.)
fn pile() -> [[f64; 2]; 3] {
    let top = RADIUS * (1.0 + 3.0_f64.sqrt());
    [[-RADIUS, RADIUS], [RADIUS, RADIUS], [0.0, top]].map(|[s, h]| [s, h + 1e-9])
}

#[test]
fn a_pile_stays_whatever_the_floor_is_made_of() {
    let time = 1000.0 * CONTACT_TIME;
    let stays = |length: f64, shift: f64| {
        let floor = |time| {
            after(time, (0.0, slope(0.0, length, [-0.5 - shift, 0.5 - shift])), &pile(), HOLDING)
        };
        let (rests, later) = (floor(time), floor(2.0 * time));
        assert_eq!(rests, later, "{length}, {shift}");
        rests
    };
    let whole = stays(1.0, 0.0);
    // While its springs are stretched a lower one rolls outwards, over a joint that is so far away.
    let rolled = whole[1][0] - RADIUS;
    assert!(rolled > 1e-5, "{rolled}");
    for part in [0.1, 0.5, 0.9, 1.1] {
        for length in [0.1, 0.02] {
            let pieces = stays(length, -part * rolled);
            let far = |k: usize, axis: usize| (pieces[k][axis] - whole[k][axis]).abs();
            let off = (0..3).map(|k| far(k, 0).max(far(k, 1))).fold(0.0, f64::max);
            assert!(off < 1e-12, "{length}, {part}: {off}");
        }
    }
}

#[test]
fn a_disk_rolls_over_joints_as_over_one_facet() {
    let angle = 0.2;
    for law in [HOLDING, Tangential::Walton { mu: 0.3, beta_0: 0.0 }] {
        let end = |length: f64| {
            after(1.2, (angle, slope(angle, length, [-1.0, 7.0])), &[[0.0, RADIUS + 1e-9]], law)[0]
        };
        let whole = end(8.0);
        for length in [0.5, 0.02] {
            let pieces = end(length);
            assert!(
                (pieces[0] - whole[0]).abs() < 1e-7 && (pieces[1] - whole[1]).abs() < 1e-9,
                "{length}: {pieces:?}, {whole:?}"
            );
        }
    }
}
