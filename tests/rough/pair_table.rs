//! Is a table of one's own law what the force-based reference integrates? Tables made here, against single impacts of the reference; what has no table.

use crate::pair::seeded;
use carom::law::{
    Adhesive, Cohesive, ContactLaw, Dmt, Impact, Outside, PairTabulated, PowerLaw, WaltonBraun,
};
use carom::{Grain, Memory, World};
use carom_reference::{Friction, GeneralLaw, RoughGrain, RoughImpact, collide_general};
use carom_tables::read::PairTable;
use carom_tables::recipe::PairRecipe;
use rand::RngExt;

const RADII: [f64; 2] = [0.1, 0.07];
const MASSES: [f64; 2] = [1.0, 0.5];

/// The pair, in what a law may depend on.
fn pair() -> Impact<f64> {
    let reduced = |[a, b]: [f64; 2]| a * b / (a + b);
    Impact {
        contact_distance: RADII[0] + RADII[1],
        effective_radius: reduced(RADII),
        reduced_mass: reduced(MASSES),
        normal_speed: 0.0,
        tangential_speed: 0.0,
        acceleration: 0.0,
        materials: [0; 2],
    }
}

fn recipe<L: ContactLaw<f64>>(law: L) -> PairRecipe<impl Fn(f64, f64, &mut [f64; 2]) -> f64> {
    let Impact { contact_distance, reduced_mass, .. } = pair();
    let force = move |x, rate, memory: &mut [f64; 2]| law.force(&pair(), x, rate, memory);
    PairRecipe::new([contact_distance, reduced_mass], force)
}

/// L94's Appendix: powers between Hertz's and others, softer than most.
const LAW: PowerLaw<f64> =
    PowerLaw { stiffness: 2e7, exponent: 1.75, damping: 5e3, damping_exponent: 0.6 };

fn table() -> PairTable {
    recipe(LAW).speeds(0.05, 2.0).across(2.0).tolerance(1e-5).points(300).generate().unwrap()
}

/// By the reference; the first moves.
fn judged([normal, tangential]: [f64; 2]) -> RoughImpact {
    let PowerLaw { stiffness, exponent, damping, damping_exponent } = LAW;
    let law = GeneralLaw::Power { stiffness, exponent, damping, damping_exponent };
    let smooth = Friction { mu: 0.0, stiffness: 1.0, damping: 0.0, inertia: 0.4 };
    let grain = |k: usize, x, velocity| RoughGrain {
        radius: RADII[k],
        mass: MASSES[k],
        position: [x, 0.0, 0.0],
        velocity,
        rotation: [0.0; 3],
    };
    let first = grain(0, RADII[0] + RADII[1], [-normal, tangential, 0.0]);
    let grains = [first, grain(1, 0.0, [0.0; 3])];
    collide_general(grains, (law, 0.0), smooth).unwrap().unwrap()
}

#[test]
fn a_table_keeps_its_certificate_beside_the_reference() {
    let table = table();
    let c = &table.certificate;
    println!("{} bytes, pieces {:?}, largest {:?}", c.bytes, table.pieces, c.largest);
    assert!(c.largest.iter().all(|&x| x < 2e-5) && c.bytes < 20_000);
    let mut rng = seeded(3);
    for _ in 0..300 {
        let normal = 0.05 * 40_f64.powf(rng.random());
        let tangential = 2.0 * rng.random::<f64>();
        let hit = judged([normal, tangential]);
        let [a, b] = hit.after;
        let r = [0, 1].map(|k| a.position[k] - b.position[k]);
        let v = [0, 1].map(|k| a.velocity[k] - b.velocity[k]);
        let away = (r[0] * v[0] + r[1] * v[1]) / r[0].hypot(r[1]);
        let found = table.read([normal, tangential]).unwrap();
        let off = [
            found.duration / hit.duration - 1.0,
            found.restitution - away / normal,
            found.angle - r[1].atan2(r[0]),
        ];
        for (off, most) in off.into_iter().zip(c.largest) {
            // The reference's own error is next to nothing beside it.
            assert!(off.abs() <= most + 1e-8, "{normal} {tangential}: {off:e}, {most:e}");
        }
    }
    let within = table.read([1.0, 1.0]).is_some();
    let outside = [[0.04, 0.0], [2.1, 0.0], [1.0, 2.1], [f64::NAN, 0.0], [1.0, -0.1]];
    assert!(within && outside.iter().all(|&speeds| table.read(speeds).is_none()));
}

#[test]
fn a_world_reads_it() {
    let table: &PairTable = Box::leak(Box::new(table()));
    let rule = PairTabulated { law: LAW, table, outside: Outside::Reject };
    for speeds in [[1.0, 0.0], [0.7, 1.2], [0.1, 0.02]] {
        let hit = judged(speeds);
        let mut memory = Memory::<f64, 2, 2>::new();
        let mut world = World::builder(&mut memory)
            .rule(rule)
            .grains([
                Grain::with_mass(RADII[0], MASSES[0])
                    .at([RADII[0] + RADII[1], 0.0])
                    .moving([-speeds[0], speeds[1]]),
                Grain::with_mass(RADII[1], MASSES[1]),
            ])
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(hit.duration * 1.001).unwrap();
        for (k, after) in hit.after.iter().enumerate() {
            let velocity = world.grain(k).unwrap().velocity;
            for axis in 0..2 {
                let off = velocity[axis] - after.velocity[axis];
                assert!(off.abs() < 4e-5, "{speeds:?} {k} {axis}: {off:e}");
            }
        }
        assert_eq!(world.statistics().collisions, 1);
        assert_eq!(world.statistics().steps, 0);
    }
    // Too fast, and another pair: outside.
    for (speed, radius) in [(3.0, RADII[1]), (1.0, 0.08)] {
        let start = |outside| {
            let rule = PairTabulated { outside, ..rule };
            let mut memory = Memory::<f64, 2, 2>::new();
            let mut world = World::builder(&mut memory)
                .rule(rule)
                .grains([
                    Grain::with_mass(RADII[0], MASSES[0]).at([0.3, 0.0]).moving([-speed, 0.0]),
                    Grain::with_mass(radius, MASSES[1]),
                ])
                .unwrap()
                .start()
                .unwrap();
            world.advance_to(1.0).map(|()| world.statistics().hard_sphere)
        };
        assert!(start(Outside::Reject).is_err());
        assert_eq!(start(Outside::HardSphere).unwrap(), 1);
    }
}

#[test]
fn what_has_no_table_is_refused() {
    let said =
        |recipe: Result<PairTable, carom_tables::recipe::Error>| recipe.unwrap_err().to_string();
    let clay = WaltonBraun { loading: 1e6, unloading: 4e6 };
    let clay = said(recipe(clay).generate());
    assert!(clay.contains("law is one that remembers") && clay.contains("integrate"), "{clay}");
    let of = Adhesive { young: 1e8, poisson: 0.3, dissipation: 1e-3, work: 1.0 };
    let sticky = said(recipe(Dmt(of)).speeds(1e-4, 0.1).generate());
    assert!(sticky.contains("does not let the two part"), "{sticky}");
    let pulled = Cohesive { law: LAW, cohesion: 1e30 };
    let pulled = said(recipe(pulled).generate());
    assert!(pulled.contains("does not stop the two"), "{pulled}");
    let none = PowerLaw { stiffness: f64::NAN, ..LAW };
    assert!(said(recipe(none).generate()).contains("finite force"));
    for (bad, name) in [
        (recipe(LAW).speeds(0.0, 1.0), "slowest is 0"),
        (recipe(LAW).speeds(1.0, 1.0), "fastest is 1"),
        (recipe(LAW).across(-1.0), "across is -1"),
        (recipe(LAW).tolerance(1e-9), "tolerance is 0.000000001"),
        (recipe(LAW).speeds(1e-3, 1.0).across(50.0).tolerance(1e-6), "more than 64 pieces"),
    ] {
        let said = said(bad.generate());
        assert!(said.contains(name), "{said}");
    }
    assert!(recipe(LAW).emit("9", "x").unwrap_err().to_string().contains("name is 9"));
}
