//! Do the laws that are integrated do what their authors say? Restitution, durations, pull-off and capture, against closed forms.

use carom::law::{
    Adhesive, Cohesive, ContactLaw, Dmt, Impact, Integrated, Jkr, Memory as Remembered, PowerLaw,
    WaltonBraun,
};
use carom::space::ContactState;
use carom::world::WithContacts;
use carom::{Error, Grain, Memory, World};

const STEPS: u32 = 256;

/// Two alike meet head-on with this relative speed; with which they part, when, if they do by then.
fn collide<L: ContactLaw<f64>>(law: L, speed: f64, time: f64) -> Option<(f64, f64)> {
    let mut memory =
        WithContacts::new(Memory::<f64, 1, 2>::new(), [ContactState::<f64>::VACANT; 1]);
    let apart = 2.0 + 2.0 * law.reach(&pair());
    let mut world = World::builder(&mut memory)
        .rule(Integrated(law))
        .steps_per_contact(STEPS)
        .grains([
            Grain::with_mass(1.0, 2.0).moving([speed / 2.0]),
            Grain::with_mass(1.0, 2.0).at([2.0]).moving([-speed / 2.0]),
        ])
        .unwrap()
        .start()
        .unwrap();
    while world.now().as_f64() < time {
        if world.step().unwrap().is_none() {
            world.advance_to(time).unwrap();
        }
        let [a, b] = [0, 1].map(|i| world.grain(i).unwrap());
        if b.position.x - a.position.x > apart && b.velocity.x > a.velocity.x {
            return Some((b.velocity.x - a.velocity.x, world.now().as_f64()));
        }
    }
    None
}

#[test]
fn hysteretic_springs_have_one_restitution_at_every_speed() {
    let law = WaltonBraun { loading: 1.0e6, unloading: 4.0e6 };
    for speed in [1e-3, 1.0, 50.0] {
        let (away, _) = collide(law, speed, 1.0).unwrap();
        assert!((away / speed - 0.5).abs() < 2e-3, "{speed}: {}", away / speed);
    }
}

#[test]
fn powers_of_the_overlap_scale_as_theory_says() {
    // L94, Appendix: t_c ~ v^((1 − β)/(1 + β)), 1 − ε ~ v^((2 (γ′ + 1) − (β + 1))/(β + 1)).
    for (exponent, damping_exponent) in
        [(1.0, 0.0), (1.5, 0.0), (1.5, 0.5), (1.5, 0.25), (2.0, 1.0)]
    {
        // Little is lost, in all of them.
        let damping = 0.5 * 1e4_f64.powf(damping_exponent);
        let law = PowerLaw { stiffness: 1.0e7, exponent, damping, damping_exponent };
        let [(slow, long), (fast, short)] = [0.01, 0.1].map(|v| {
            let (away, time) = collide(law, v, 1.0).unwrap();
            (1.0 - away / v, time)
        });
        let of = |a: f64, b: f64| (b / a).ln() / 10_f64.ln();
        let duration = (1.0 - exponent) / (1.0 + exponent);
        let loss = (2.0 * (damping_exponent + 1.0) - (exponent + 1.0)) / (exponent + 1.0);
        assert!((of(long, short) - duration).abs() < 0.02, "{exponent}: {}", of(long, short));
        assert!((of(slow, fast) - loss).abs() < 0.05, "{exponent}: {} {loss}", of(slow, fast));
    }
}

const STICKY: Adhesive<f64> = Adhesive { young: 1.0e6, poisson: 0.3, dissipation: 0.0, work: 10.0 };

fn pair() -> Impact<f64> {
    Impact {
        contact_distance: 2.0,
        effective_radius: 0.5,
        reduced_mass: 1.0,
        normal_speed: 0.0,
        tangential_speed: 0.0,
        acceleration: 0.0,
        materials: [0; 2],
    }
}

/// The strongest pull of a law, from the pull-off to a small overlap.
fn strongest(law: &impl ContactLaw<f64>, to: f64) -> f64 {
    let from = -law.reach(&pair());
    let pull = |k: u32| {
        let x = from + (to - from) * f64::from(k) / 1e4;
        -law.force(&pair(), x, 0.0, &mut [0.0; 2])
    };
    (0..=10_000).map(pull).fold(0.0, f64::max)
}

#[test]
fn adhesive_spheres_pull_as_hard_as_theory_says() {
    use std::f64::consts::PI;
    let dmt = strongest(&Dmt(STICKY), 1e-3);
    assert!((dmt / (2.0 * PI * 10.0 * 0.5) - 1.0).abs() < 1e-12, "{dmt}");
    let jkr = strongest(&Jkr(STICKY), 1e-2);
    assert!((jkr / (1.5 * PI * 10.0 * 0.5) - 1.0).abs() < 1e-6, "{jkr}");
    // At the pull-off it is 5/9 of that.
    let reach = Jkr(STICKY).reach(&pair());
    let last = -Jkr(STICKY).force(&pair(), -reach, 0.0, &mut [0.0; 2]);
    assert!((last / (5.0 / 6.0 * PI * 10.0 * 0.5) - 1.0).abs() < 1e-3, "{last}");
}

#[test]
fn an_adhesive_impact_below_its_capture_speed_sticks() {
    // What a contact of JKR costs: the work from the touch to the pull-off, 7.09 (w⁵ R⁴/E*²)^(1/3)
    // (Thornton & Ning, Powder Technol. 99, 154, 1998).
    let modulus: f64 = 1.0e6 / (2.0 * (1.0 - 0.09));
    let cost = 7.09 * (10_f64.powi(5) * 0.5_f64.powi(4) / modulus.powi(2)).cbrt();
    let capture = (2.0 * cost).sqrt(); // the reduced mass is 1
    assert!(collide(Jkr(STICKY), 0.97 * capture, 3.0).is_none());
    let speed = 2.0 * capture;
    let (away, _) = collide(Jkr(STICKY), speed, 3.0).unwrap();
    // Energy: m_eff (v² − v′²)/2 is that cost. The approach gains nothing before the touch.
    assert!(((speed * speed - away * away) / 2.0 / cost - 1.0).abs() < 0.02, "{away} {speed}");
}

/// Without dissipation what DMT gives on the way in it takes on the way out; JKR without adhesion is Hertz.
#[test]
fn elastic_contacts_that_begin_without_stiffness_lose_nothing() {
    for speed in [0.05, 1.0] {
        let (away, _) = collide(Dmt(STICKY), speed, 3.0).unwrap();
        assert!((away / speed - 1.0).abs() < 1e-3, "{speed}: {away}");
        let (away, time) = collide(Jkr(Adhesive { work: 0.0, ..STICKY }), speed, 3.0).unwrap();
        assert!((away / speed - 1.0).abs() < 1e-3, "{speed}: {away}");
        // Hertz: 3.218 (m/ρ)^(2/5) v^(−1/5), with ρ = 4/3 E* √R.
        let rho = 4.0 / 3.0 * 1e6 / (2.0 * 0.91) * 0.5_f64.sqrt();
        let wanted = 3.218_066 * (1.0 / rho).powf(0.4) * speed.powf(-0.2);
        assert!((time / wanted - 1.0).abs() < 0.1, "{speed}: {time} {wanted}");
    }
}

#[test]
fn cohesion_holds_what_is_slow() {
    let law = |cohesion| Cohesive { law: WaltonBraun { loading: 1e6, unloading: 4e6 }, cohesion };
    let speed = 0.1;
    assert!(collide(law(0.0), speed, 1.0).is_some());
    assert!(collide(law(1.0e3), speed, 1.0).is_none());
}

/// A law that is none.
struct Broken(f64, f64);

impl ContactLaw<f64> for Broken {
    fn force(&self, _: &Impact<f64>, overlap: f64, _: f64, _: &mut Remembered<f64>) -> f64 {
        self.0 * overlap
    }
    fn stiffness(&self, _: &Impact<f64>, _: f64) -> f64 {
        1.0
    }
    fn reach(&self, _: &Impact<f64>) -> f64 {
        self.1
    }
}

#[test]
fn a_law_that_never_pushes_or_never_ends_is_refused() {
    let refused = |law: Broken| -> Error {
        let mut memory = Memory::<f64, 2, 1>::new();
        let world = World::builder(&mut memory).rule(Integrated(law));
        world.grain(Grain::with_mass(1.0, 1.0)).unwrap().start().err().unwrap()
    };
    for (law, name) in [
        (Broken(-1.0, 0.0), "force"),
        (Broken(f64::NAN, 0.0), "overlap"),
        (Broken(1.0, 3.0), "reach"),
        (Broken(1.0, f64::NAN), "reach"),
    ] {
        let said = refused(law).to_string();
        assert!(said.contains(name), "{said}");
    }
    let mut memory = Memory::<f64, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Integrated(WaltonBraun { loading: 1.0, unloading: 2.0 }))
        .grains([Grain::with_mass(1.0, 1.0).moving([1.0]), Grain::with_mass(1.0, 1.0).at([2.5])])
        .unwrap()
        .start()
        .unwrap();
    let full = world.advance_to(10.0).unwrap_err().to_string();
    assert!(full.contains("WithContacts"), "{full}");
}
