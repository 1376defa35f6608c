//! Does the engine run in fixed point as in floats? Runs in I32F32 and I16F16; compares with f64 and conservation laws.

use carom::detect::root;
use carom::law::embedded::{Standard, TableSet};
use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft, Viscoelastic};
use carom::scalar::{I16F16, I32F32, Real, TimeSpan, Vector};
use carom::space::{Plane, Surface, Vibration};
use carom::{Enduring, Grain, Memory, Scalar, View, World};
use proptest::prelude::*;

/// Half a step of I32F32.
const HALF: f64 = 1.0 / 8_589_934_592.0;

pub(crate) fn n<S: Scalar>(x: f64) -> S {
    S::from_f64(x)
}

/// Rubber balls in millimetres, milligrams and milliseconds: Y = 5 MPa, A = 0.02 ms.
pub(crate) fn rubber<S: Scalar>() -> Viscoelastic<S> {
    Viscoelastic { young: n(5000.0), poisson: n(0.4), dissipation: n(0.02) }
}

fn spring<S: Scalar>(damping: f64) -> LinearDashpot<S> {
    LinearDashpot { stiffness: n(200.0), damping: n(damping) }
}

/// A number in −1..1 that depends on three others.
fn spread(i: usize, a: usize, seed: usize) -> f64 {
    ((i * 37 + a * 17 + seed * 29 + i * i * 5) % 101) as f64 / 50.0 - 1.0
}

/// Grains of radius about 1 on a square lattice, moving at `speed`.
fn lattice<S: Scalar, const D: usize>(count: usize, side: usize, speed: f64) -> Vec<Grain<S, D>> {
    let grain = |i: usize| {
        let at = core::array::from_fn(|a| n(1.6 + 3.2 * (i / side.pow(a as u32) % side) as f64));
        let moving = core::array::from_fn(|a| n(speed * spread(i, a, 1)));
        let size = 1.0 + 0.05 * spread(i, 0, 2);
        Grain::with_mass(n(size), n(10.0 * size * size * size)).at(at).moving(moving)
    };
    (0..count).map(grain).collect()
}

/// Kinetic and potential energy, in f64.
fn energy<S: Scalar, const D: usize>(view: View<'_, S, D>) -> f64 {
    let g = view.gravity().map(|g| g.to_f64());
    (0..view.len()).filter_map(|i| view.released(i)).fold(0.0, |sum, grain| {
        let (v, x) = (grain.velocity.map(|v| v.to_f64()), grain.position.map(|x| x.to_f64()));
        sum + grain.mass.to_f64() * (0.5 * v.dot(&v) - g.dot(&x))
    })
}

/// Momentum, in f64.
fn momentum<S: Scalar, const D: usize>(view: View<'_, S, D>) -> [f64; D] {
    core::array::from_fn(|a| {
        let grains = (0..view.len()).filter_map(|i| view.released(i));
        grains.map(|grain| grain.mass.to_f64() * grain.velocity[a].to_f64()).sum()
    })
}

/// A periodic gas of 27 after so many events: the change of energy (relative) and of momentum (largest).
fn gas<S: Scalar>(rule: impl Rule<S>, events: u32) -> (f64, f64) {
    let mut memory = Memory::<S, 3, 27>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .periodic([[n(0.0), n(9.6)]; 3])
        .rule(rule)
        .grains(lattice(27, 3, 0.5))
        .unwrap()
        .start()
        .unwrap();
    let (e, p) = (energy(world.view()), momentum(world.view()));
    for _ in 0..events {
        world.step().unwrap().unwrap();
    }
    assert!(world.statistics().collisions > u64::from(events / 16), "{:?}", world.statistics());
    let after = momentum(world.view());
    let drift = p.iter().zip(after).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    (energy(world.view()) / e - 1.0, drift)
}

#[test]
fn a_hard_elastic_gas_keeps_energy_and_momentum_to_the_steps_of_the_number() {
    // A collision rounds two velocities, each by half a step in each component, of masses around 10:
    // momentum changes by 20 half steps at most, energy by about 20 v half steps of 27 · 10 v²/2.
    let events = 8_000;
    let (e, p) = gas::<I32F32>(HardSphere { restitution: n(1.0) }, events);
    let worst = f64::from(events) * HALF * 23.2;
    assert!(p < worst, "momentum changed by {p:e}, {worst:e} is the most rounding can do");
    assert!(e.abs() < worst / 10.0, "energy changed by {e:e}");
}

/// The angle's table keeps energy by construction. Only a pair that an interrupted contact left overlapping
/// loses some, when it collides again and is put where its contact's end belongs: angular momentum is kept.
#[test]
fn elastic_contacts_keep_energy_but_for_pairs_that_overlap() {
    let mut memory = Memory::<I32F32, 3, 27>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .periodic([[n(0.0), n(9.6)]; 3])
        .rule(Soft::linear_dashpot(spring(0.0), Outside::HardSphere))
        .grains(lattice(27, 3, 0.5))
        .unwrap()
        .start()
        .unwrap();
    let (start, mut rounding, mut losses) = (energy(world.view()), 0.0_f64, 0);
    let mut last = start;
    for _ in 0..6_000 {
        world.step().unwrap().unwrap();
        let now = energy(world.view());
        match (now - last) / start {
            loss if loss < -1e-7 => losses += 1,
            change => rounding += change,
        }
        last = now;
    }
    let interrupted = world.statistics().interrupted;
    assert!(rounding.abs() < 1e-6, "{rounding:e}");
    assert!(losses <= interrupted / 10, "{losses} losses, {interrupted} interrupted contacts");
}

#[test]
fn soft_gases_run_and_keep_momentum() {
    // The masses' shares of a pair have an error of half a step each, times the velocity of about 1.
    let events = 6_000;
    let worst = f64::from(events) * HALF * 100.0;
    let (e, p) = gas::<I32F32>(Soft::linear_dashpot(spring(0.0), Outside::HardSphere), events);
    assert!(e < 1e-6 && p < worst, "elastic spring: {e:e}, {p:e} of {worst:e}");
    let (e, p) = gas::<I32F32>(Soft::linear_dashpot(spring(1.0), Outside::HardSphere), events);
    assert!(e < -0.5 && p < worst, "spring with a dashpot: {e:e}, {p:e} of {worst:e}");
    let (e, p) = gas::<I32F32>(Soft::viscoelastic(rubber(), Outside::HardSphere), events);
    assert!(e < -0.2 && p < worst, "viscoelastic: {e:e}, {p:e} of {worst:e}");
}

/// Sixteen grains in a box under gravity; the largest energy that any of `events` events has added.
fn boxed<S: Scalar>(rule: impl Rule<S>, events: u32) -> (f64, f64, u64) {
    let mut memory = Memory::<S, 2, 16>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .walls([[n(0.0), n(13.0)]; 2])
        .gravity([n(0.001), n(-0.00981)])
        .rule(rule)
        .grains(lattice(16, 4, 0.3))
        .unwrap()
        .start()
        .unwrap();
    let start = energy(world.view());
    for _ in 0..events {
        world.step().unwrap().unwrap();
    }
    for i in 0..16 {
        let grain = world.grain(i).unwrap();
        let (r, x) = (grain.radius.to_f64(), grain.position.map(|x| x.to_f64()));
        assert!(x.iter().all(|&x| x > 0.9 * r && x < 13.0 - 0.9 * r), "grain {i} is at {x}");
    }
    let depth = world.statistics().clamped + world.statistics().hard_sphere;
    assert!(depth < u64::from(events), "{:?}", world.statistics());
    (start, energy(world.view()), world.digest())
}

#[test]
fn a_box_under_gravity_runs_for_thousands_of_events_and_repeats_itself() {
    let run = || boxed::<I32F32>(Soft::viscoelastic(rubber(), Outside::HardSphere), 5_000);
    let (before, after, digest) = run();
    assert!(after < before, "{before} {after}");
    assert_eq!(digest, run().2);
}

#[test]
fn an_elastic_box_under_gravity_keeps_its_energy() {
    // The speeds are around 0.3, and a step of time or velocity is 2.3e-10: each event may change the
    // energy of a grain, 0.5 of all of 16, by some 1e-9 of itself. They add up at random.
    let (before, after, _) = boxed::<I32F32>(HardSphere { restitution: n(1.0) }, 5_000);
    assert!((after / before - 1.0).abs() < 1e-6, "{before} {after}");
}

#[test]
fn sixteen_bits_run_in_suitable_units() {
    let (before, after, _) =
        boxed::<I16F16>(Soft::viscoelastic(rubber(), Outside::HardSphere), 3_000);
    assert!(after < before, "{before} {after}");
    let (before, after, _) =
        boxed::<I16F16>(Soft::linear_dashpot(spring(1.0), Outside::HardSphere), 3_000);
    assert!(after < before, "{before} {after}");
    let (e, p) = gas::<I16F16>(HardSphere { restitution: n(1.0) }, 3_000);
    // Half a step is 7.6e-6 here, 2¹⁶ times as much as above.
    let worst = 3_000.0 * HALF * 65_536.0 * 23.2;
    assert!(p < worst && e.abs() < worst / 10.0, "{e:e} {p:e} of {worst:e}");
}

/// Two grains collide obliquely; their states after so long, as the second sees the first and the other way.
fn pair<S: Scalar>(turned: bool) -> [Grain<S, 2>; 2]
where
    Standard: TableSet<S>,
{
    let sign = if turned { -1.0 } else { 1.0 };
    let grain = |s: f64| {
        let v = [-0.4 * s, -0.1 * s].map(n);
        Grain::with_mass(n(1.0), n(4.0)).at([n(2.0 * s), n(0.7 * s)]).moving(v)
    };
    let mut memory = Memory::<S, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .rule(Soft::viscoelastic(rubber(), Outside::Reject))
        .grain(grain(sign))
        .unwrap()
        .grain(grain(-sign))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(n::<S>(20.0)).unwrap();
    assert_eq!(world.statistics().releases, 2);
    [0, 1].map(|i| world.view().released(i).unwrap())
}

#[test]
fn a_symmetric_pair_stays_symmetric_to_the_last_bit_and_agrees_with_f64() {
    let [a, b] = pair::<I32F32>(false);
    assert_eq!((a.position, a.velocity), (-b.position, -b.velocity));
    let [c, d] = pair::<I32F32>(true);
    assert_eq!((a.position, b.velocity), (d.position, c.velocity));
    let [double, _] = pair::<f64>(false);
    let off = |x: Vector<I32F32, 2>, y: Vector<f64, 2>| (x.map(|x| x.to_f64()) - y).amax();
    // Both read their tables to 1e-6; 20 units of time at a speed of that error.
    assert!(off(a.velocity, double.velocity) < 2e-6, "{} {}", a.velocity, double.velocity);
    assert!(off(a.position, double.position) < 4e-5, "{} {}", a.position, double.position);
    let [a, b] = pair::<I16F16>(false);
    assert_eq!((a.position, a.velocity), (-b.position, -b.velocity));
    let off = (a.velocity.map(|x| x.to_f64()) - double.velocity).amax();
    assert!(off < 1e-4, "{} {}", a.velocity, double.velocity);
}

#[test]
fn a_column_on_a_vibrating_plate_runs() {
    let mut memory = Memory::<I32F32, 1, 6>::new();
    let plate =
        Plane::new([n(1.0)], n(0.0), Surface::Rule).vibrating(Vibration::new(n(0.5), n(0.05)));
    let grains =
        (0..6).map(|i| Grain::with_mass(n(1.0), n(10.0)).at([n(2.0 + 2.2 * f64::from(i))]));
    let mut world = World::builder(&mut memory)
        .plane(plate)
        .gravity([n(-0.00981)])
        .rule(HardSphere { restitution: n(0.9) })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let mut order = 0.0;
    for _ in 0..3_000 {
        world.step().unwrap().unwrap();
    }
    for i in 0..6 {
        let x = world.grain(i).unwrap().position[0].to_f64();
        assert!(x > order + 0.45, "grain {i} is at {x}");
        order = x;
    }
}

/// A multiple of a step that is a float as well.
fn exact(limit: f64) -> impl Strategy<Value = f64> {
    (-limit..limit).prop_map(|x| (x * 1_048_576.0).round() / 1_048_576.0)
}

proptest! {
    #[test]
    fn spheres_collide_when_they_do_in_f64(
        r in [exact(100.0), exact(100.0), exact(100.0)],
        v in [exact(2.0), exact(2.0), exact(2.0)],
        sigma in exact(50.0),
    ) {
        let sigma = sigma.abs() + 1.0;
        let (a, b) = (Vector::from(r), Vector::from(v));
        let want = root::spheres(&a, &b, sigma);
        let got = root::spheres(&a.map(n::<I32F32>), &b.map(n), n(sigma)).map(TimeSpan::to_ticks);
        match (got, want) {
            (Some(got), Some(want)) => {
                let got = f64::from_ticks(got);
                // Half a step, and what f64 loses near a glancing pass.
                let speed = b.dot(&b).sqrt();
                let closest = (a + b * want).dot(&b).abs() / speed;
                let slack = HALF + 1e-11 * (1.0 + want) * (sigma / closest.max(1e-9));
                prop_assert!((got - want).abs() <= slack, "{} for {}", got, want);
            }
            (got, want) => prop_assert!(got.is_some() == want.is_some() || glancing(&a, &b, sigma)),
        }
    }
}

/// Whether the two pass so near the edge that f64 cannot tell.
fn glancing(r: &Vector<f64, 3>, v: &Vector<f64, 3>, sigma: f64) -> bool {
    let closest = r - v * (r.dot(v) / v.dot(v));
    (closest.dot(&closest).sqrt() / sigma - 1.0).abs() < 1e-10
}
