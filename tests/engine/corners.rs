//! Do grains rest right where several planes intersect? Reads grooves, troughs, corners and plates; compares energies and gaps.

use carom::law::HardSphere;
use carom::space::{Plane, Surface, Vibration};
use carom::world::Snapshot;
use carom::{Enduring, Grain, Memory, World};

const G: f64 = 9.81;

/// A grain in a groove ends at its bottom, where its centre is R / cos(tilt) above the edge.
#[test]
fn a_grain_in_a_groove_comes_to_rest_at_its_bottom() {
    for (degrees, restitution) in [(15.0, 0.5), (30.0, 0.5), (30.0, 0.0), (45.0, 0.9), (60.0, 0.5)]
    {
        let (s, c) = f64::to_radians(degrees).sin_cos();
        let hard = Surface::Hard(restitution);
        let mut memory = Memory::<f64, 2, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .gravity([0.0, -G])
            .plane(Plane::new([-s, c], 0.0, hard))
            .plane(Plane::new([s, c], 0.0, hard))
            .rule(HardSphere { restitution })
            .grain(Grain::with_mass(1e-3, 1e-6).at([0.01, 0.02 + 0.01 * s / c]))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(20.0).unwrap();
        let grain = world.grain(0).unwrap();
        let bottom = 1e-3 / c;
        assert!((grain.position[1] - bottom).abs() < 1e-9, "{degrees}: {grain:?}");
        assert!(grain.position[0].abs() < 1e-9, "{degrees}: {grain:?}");
        assert!(world.view().is_at_rest(0));
    }
}

/// A rider of a vibrating floor that touches a wall has no event with it.
#[test]
fn a_rider_that_touches_a_wall_is_left_alone() {
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .gravity([0.0, -G])
        .plane(
            Plane::new([0.0, 1.0], 0.0, Surface::Hard(0.0)).vibrating(Vibration::new(5e-4, 20.0)),
        )
        .plane(Plane::new([1.0, 0.0], 0.0, Surface::Hard(0.0)))
        .rule(HardSphere { restitution: 0.0 })
        .grain(Grain::with_mass(1e-3, 1e-6).at([1e-3, 1e-3]))
        .unwrap()
        .start()
        .unwrap();
    let events = (0..1000).take_while(|_| world.step().unwrap().is_some()).count();
    assert!(events < 10, "{events}");
    world.advance_to(1000.0).unwrap();
    assert!(world.view().is_at_rest(0));
}

/// In the corner of two plates that shake each its own way a grain passes through neither.
#[test]
fn a_grain_between_two_plates_obeys_both() {
    let (floor, side) = (Vibration::new(1e-4, 15.0), Vibration::new(4e-3, 7.3).starting_at(0.75));
    let hard = Surface::Hard(0.0);
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .gravity([0.0, -G])
        .plane(Plane::new([0.0, 1.0], 0.0, hard).vibrating(floor))
        .plane(Plane::new([1.0, 0.0], 0.0, hard).vibrating(side))
        .rule(HardSphere { restitution: 0.0 })
        .grain(Grain::with_mass(1e-3, 1e-6).at([1e-3 - 0.995 * 4e-3, 1e-3]))
        .unwrap()
        .start()
        .unwrap();
    for i in 1..2000 {
        let t = 1e-3 * f64::from(i);
        world.advance_to(t).unwrap();
        let at = world.grain(0).unwrap().position;
        let place = |v: Vibration<f64>| {
            v.amplitude * (std::f64::consts::TAU * (v.frequency * t + v.phase)).sin()
        };
        let gaps = [at[0] - 1e-3 - place(side), at[1] - 1e-3 - place(floor)];
        assert!(gaps.iter().all(|&gap| gap > -1e-12), "{t}: {gaps:?}");
    }
}

/// A plate goes on in its phase when a world is taken up again.
#[test]
fn a_snapshot_keeps_the_phase_of_its_plates() {
    let plane = Plane::new([1.0], 0.0, Surface::Hard(0.8)).vibrating(Vibration::new(1e-3, 21.3));
    let rule = HardSphere { restitution: 0.9 };
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .plane(plane)
        .gravity([-G])
        .rule(rule)
        .grain(Grain::with_mass(1e-3, 1e-6).at([5e-3]))
        .unwrap()
        .start()
        .unwrap();
    while world.statistics().epochs < 3 {
        world.step().unwrap();
    }
    let text = serde_json::to_string(&world.save()).unwrap();
    let saved: Snapshot<f64, 1, Vec<_>, Vec<_>> = serde_json::from_str(&text).unwrap();
    let mut again = Memory::<f64, 1, 1>::new();
    let mut other = World::restore(&mut again, rule, &saved).unwrap();
    for _ in 0..200 {
        assert_eq!(world.digest(), other.digest());
        world.step().unwrap();
        other.step().unwrap();
    }
}

/// A trough along z whose sides are square but for 9e-7, which counts as square: a grain that slides along it
/// goes z = g_z t²/2 and stays at its radius from both sides.
#[test]
fn a_grain_slides_along_an_almost_square_trough_and_keeps_to_both_sides() {
    for lean in [0.0, -9e-7, 9e-7_f64] {
        let sides = [[1.0, 0.0, 0.0], [lean, (1.0 - lean * lean).sqrt(), 0.0]];
        let [a, b] = sides.map(|n| Plane::new(n, 0.0, Surface::Hard(0.0)));
        // Both touch: x = R, and n₂ · r = R.
        let y = (1.0 - lean) / sides[1][1];
        let mut memory = Memory::<f64, 3, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .gravity([-6.0, -8.0, 3.0])
            .plane(a)
            .plane(b)
            .rule(HardSphere { restitution: 0.0 })
            .grain(Grain::with_mass(1.0, 1.0).at([1.0, y, 0.0]))
            .unwrap()
            .start()
            .unwrap();
        for t in [1.0, 3.0, 10.0] {
            world.advance_to(t).unwrap();
            let r = world.grain(0).unwrap().position;
            for n in sides {
                let distance = r[0] * n[0] + r[1] * n[1] + r[2] * n[2];
                assert!((distance - 1.0).abs() < 1e-12, "{lean} {t}: {distance} from {n:?}");
            }
            assert!((r[2] - 1.5 * t * t).abs() < 1e-12 * t * t, "{lean} {t}: {r:?}");
        }
        assert_eq!(world.statistics().rests, 2, "{lean}: {:?}", world.statistics());
    }
}
