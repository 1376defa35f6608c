//! How does the reference fare with many grains? Reads random gases; writes nothing, or what it measured.

use std::time::Instant;

use carom_reference::{Boundary, End, Exact, ForceLaw, Grain, System, Verlet, VerletOptions};

/// A small generator of its own (splitmix64), so that the gases here never change.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [0, 1).
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn normal(&mut self) -> f64 {
        let (a, b) = (self.uniform(), self.uniform());
        (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }
}

/// MP13 Sec. VI B 6: R = 0.1 m, 1140 kg/m³, on a lattice in a periodic box, root mean square
/// speed 2 m/s.
pub fn periodic(side: usize, packing: f64, seed: u64) -> System<3> {
    let (radius, n) = (0.1_f64, side.pow(3));
    let volume = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    let width = (n as f64 * volume / packing).cbrt();
    let mut random = Random(seed);
    let cell = width / side as f64;
    let grain = |k: usize| Grain {
        radius,
        mass: 1140.0 * volume,
        position: [k % side, k / side % side, k / side / side].map(|i| (i as f64 + 0.5) * cell),
        velocity: std::array::from_fn(|_| random.normal() * 2.0 / 3.0_f64.sqrt()),
    };
    let grains = (0..n).map(grain).collect();
    let bound = Boundary::Periodic { lo: 0.0, hi: width };
    System::new(grains, [bound; 3], [0.0; 3]).expect("a valid gas")
}

/// Y = 1 GPa, ν = 0.4.
pub fn spheres(dissipation: f64) -> ForceLaw {
    ForceLaw::Viscoelastic { young: 1e9, poisson: 0.4, dissipation }
}

fn energy(system: &System<3>, law: &ForceLaw) -> f64 {
    system.kinetic_energy() + system.elastic_energy(law)
}

/// Dense and soft enough for contacts of many grains at once.
#[test]
fn a_dense_elastic_gas_keeps_energy_and_momentum() {
    let system = periodic(3, 0.2, 5);
    let law = ForceLaw::Viscoelastic { young: 1e7, poisson: 0.4, dissipation: 0.0 };
    let mut run = Exact::new(system.clone(), law, End::Force).expect("valid");
    while run.records().len() < 60 {
        run.next_event(10.0).expect("integrates");
    }
    assert!(run.first_three_grain_contact().is_some_and(|t| t < run.now()));
    let after = run.system().expect("valid");
    let drift = energy(&after, &law) / energy(&system, &law) - 1.0;
    assert!(drift.abs() < 1e-12, "{drift:e}");
    let scale = system.grains()[0].mass * 2.0;
    assert!(super::max_difference(after.momentum(), system.momentum()) < 1e-13 * scale * 27.0);
}

/// Each contact has one end, and none begins before the one before it.
#[test]
fn records_are_in_order() {
    let mut run = Exact::new(periodic(3, 0.1, 2), spheres(1e-4), End::Force).expect("valid");
    run.advance_to(0.4).expect("integrates");
    let records = run.records();
    assert!(records.len() > 20, "{}", records.len());
    assert!(records.windows(2).all(|two| two[0].begin <= two[1].begin));
    assert!(records.iter().all(|r| r.end.is_none_or(|end| end > r.begin && end <= 0.4)));
    assert_eq!(records.iter().filter(|r| r.end.is_none()).count(), run.contacts());
}

/// Looking at the run more often changes nothing, to the last bit.
#[test]
fn sampling_does_not_disturb() {
    let make = || Exact::new(periodic(3, 0.1, 3), spheres(1e-4), End::Force).expect("valid");
    let (mut once, mut often) = (make(), make());
    once.advance_to(0.3).expect("integrates");
    for k in 1..=300 {
        often.advance_to(0.001 * f64::from(k)).expect("integrates");
    }
    often.advance_to(0.3).expect("integrates");
    for i in 0..27 {
        assert_eq!(once.velocity(i), often.velocity(i));
    }
}

/// The gas of the comparison, N = 1,000 at packing fraction 0.01.
#[test]
#[ignore = "a measurement: run with --release --nocapture"]
fn speed_of_verlet() {
    let system = periodic(10, 0.01, 1);
    let law = spheres(0.0);
    for skin in [None, Some(0.002), Some(0.1), Some(0.15), Some(0.2), Some(0.3), Some(0.4)] {
        let options = VerletOptions { skin, ..VerletOptions::default() };
        let mut run = Verlet::new(&system, law, End::Force, options).expect("valid");
        let start = Instant::now();
        run.advance_to(1.0).expect("goes on");
        let (wall, statistics) = (start.elapsed().as_secs_f64(), run.statistics());
        let drift = energy(&run.system().expect("valid"), &law) / energy(&system, &law) - 1.0;
        let rate = statistics.steps as f64 / wall;
        println!("skin {:.3} m: {wall:.3} s, {rate:.0} steps/s, dE {drift:.1e}", run.skin());
        println!("  step {:.3e} s, {} pairs, {statistics:?}", run.time_step(), run.listed());
    }
}

#[test]
#[ignore = "a measurement: run with --release --nocapture"]
fn speed_of_exact() {
    for (side, packing, until) in [(2, 0.01, 100.0), (10, 0.01, 1.0), (10, 0.1, 0.1)] {
        let mut run =
            Exact::new(periodic(side, packing, 1), spheres(1e-4), End::Force).expect("valid");
        let start = Instant::now();
        run.advance_to(until).expect("goes on");
        let (wall, contacts) = (start.elapsed().as_secs_f64(), run.records().len());
        let three = run.first_three_grain_contact();
        let steps = run.steps() as f64 / contacts as f64;
        let each = 1e6 * wall / contacts as f64;
        println!("{} grains: {contacts} contacts, {wall:.3} s", side.pow(3));
        println!("  {each:.0} us and {steps:.1} steps a contact; three grains: {three:?}");
    }
}
