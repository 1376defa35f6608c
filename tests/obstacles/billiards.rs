//! Do billiards keep their energy? A stadium and Sinai's billiard.

use super::shapes::{Draw, circle, ring, room};
use carom::Grain;
use carom::World;
use carom::law::HardSphere;
use carom::space::{Facet, Surface};

/// Two half circles and two straight sides.
fn stadium() -> Vec<Facet<f64, 2>> {
    let half = |centre: f64, from: f64| {
        (0..=64).map(move |k| {
            let angle = from + std::f64::consts::PI * f64::from(k) / 64.0;
            [centre + angle.cos(), angle.sin()]
        })
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    ring(&half(1.0, -quarter).chain(half(-1.0, quarter)).collect::<Vec<_>>(), Surface::Hard(1.0))
}

/// A square with a disk in its middle.
fn sinai() -> Vec<Facet<f64, 2>> {
    let mut facets =
        ring(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], Surface::Hard(1.0));
    facets.extend(ring(&circle([0.0, 0.0], 0.4, 128), Surface::Hard(1.0)));
    facets
}

/// By how much the energy of a ball has changed after so many bounces.
fn lost(facets: Vec<Facet<f64, 2>>, at: [f64; 2], bounces: u64) -> f64 {
    let velocity = Draw(7).direction();
    let mut memory = room(1, facets);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 1.0 })
        .grain(Grain::with_mass(0.05, 2.0).at(at).moving(velocity))
        .unwrap()
        .start()
        .unwrap();
    while world.statistics().plane_collisions < bounces {
        world.step().unwrap();
    }
    (world.view().kinetic_energy() - 1.0).abs()
}

#[test]
fn billiards_keep_their_energy() {
    for (facets, at) in [(stadium(), [0.1, 0.2]), (sinai(), [0.7, 0.2])] {
        let lost = lost(facets, at, 5_000);
        assert!(lost < 1e-12, "{lost}");
    }
}

#[test]
#[ignore = "seconds in release"]
fn billiards_keep_their_energy_over_a_million_bounces() {
    for (facets, at) in [(stadium(), [0.1, 0.2]), (sinai(), [0.7, 0.2])] {
        let lost = lost(facets, at, 1_000_000);
        assert!(lost < 1e-12, "{lost}");
    }
}
