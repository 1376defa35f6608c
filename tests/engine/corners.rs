//! Do grains rest right where several planes intersect? Reads grooves, troughs, corners and plates; compares energies and gaps.

use carom::law::HardSphere;
use carom::space::{Plane, Surface, Vibration};
use carom::world::Snapshot;
use carom::{Enduring, Grain, Memory, World};

const G: f64 = 9.81;

/// How deep a grain at rest is pressed into a hard plane, in units of its radius: nothing in the papers' mode, x =
/// F/(m ω²) with ω² = 256 π² g/R by default, F in units of its weight.
fn depth(enduring: Enduring, force: f64) -> f64 {
    match enduring {
        Enduring::Integrated => force / (256.0 * std::f64::consts::PI.powi(2)),
        _ => 0.0,
    }
}

const MODES: [Enduring; 2] = [Enduring::Paper, Enduring::Integrated];

/// A grain in a groove ends at its bottom, where its centre is R / cos(tilt) above the edge.
#[test]
fn a_grain_in_a_groove_comes_to_rest_at_its_bottom() {
    let grooves = [(15.0, 0.5), (30.0, 0.5), (30.0, 0.0), (45.0, 0.9), (60.0, 0.5)];
    for ((degrees, restitution), enduring) in
        grooves.into_iter().flat_map(|groove| MODES.map(|mode| (groove, mode)))
    {
        let (s, c) = f64::to_radians(degrees).sin_cos();
        let hard = Surface::Hard(restitution);
        let mut memory = Memory::<f64, 2, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(enduring)
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
        // Each side carries m g/(2 cos).
        let bottom = 1e-3 / c * (1.0 - depth(enduring, 0.5 / c));
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
    between_two_plates(Enduring::Paper, 1e-12);
    // A slow impact reaches R/200, and the side pushes with (0.75 + 0.86) g.
    between_two_plates(Enduring::Integrated, 5e-6);
}

fn between_two_plates(enduring: Enduring, deepest: f64) {
    let (floor, side) = (Vibration::new(1e-4, 15.0), Vibration::new(4e-3, 7.3).starting_at(0.75));
    let hard = Surface::Hard(0.0);
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(enduring)
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
        assert!(gaps.iter().all(|&gap| gap > -deepest), "{t}: {gaps:?}");
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
    let leans = [0.0, -9e-7, 9e-7_f64];
    for (lean, enduring) in leans.into_iter().flat_map(|lean| MODES.map(|mode| (lean, mode))) {
        let sides = [[1.0, 0.0, 0.0], [lean, (1.0 - lean * lean).sqrt(), 0.0]];
        let [a, b] = sides.map(|n| Plane::new(n, 0.0, Surface::Hard(0.0)));
        // Both touch: x = R, and n₂ · r = R.
        let y = (1.0 - lean) / sides[1][1];
        let mut memory = Memory::<f64, 3, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(enduring)
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
            for (n, load) in sides.into_iter().zip([6.0, 8.0]) {
                let distance = r[0] * n[0] + r[1] * n[1] + r[2] * n[2];
                let pressed = depth(enduring, load / 109.0_f64.sqrt());
                let off = (distance - (1.0 - pressed)).abs();
                // Two at right angles but for 9e-7 press each other by as much.
                assert!(off < 1e-12 + 1e-5 * pressed, "{lean} {t}: {distance} from {n:?}");
            }
            assert!((r[2] - 1.5 * t * t).abs() < 1e-12 * t * t, "{lean} {t}: {r:?}");
        }
        let rests = if enduring == Enduring::Paper { 2 } else { 0 };
        assert_eq!(world.statistics().rests, rests, "{lean}: {:?}", world.statistics());
    }
}
