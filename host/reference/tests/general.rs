//! Does the reference know laws that hold, and that remember? Restitution, loss and capture against closed forms, momentum and angular momentum kept.

use carom_reference::{
    ForceLaw, Friction, GeneralLaw, HardImpact, RoughGrain, RoughImpact, Sticky, collide_general,
    collide_hard, collide_rough,
};

const SMOOTH: Friction = Friction { mu: 0.0, stiffness: 1.0, damping: 0.0, inertia: 0.4 };

/// Two of radii 1 and 0.5 and masses 2 and 1 that touch along x; the first moves.
fn grains(velocity: [f64; 3], spin: f64) -> [RoughGrain; 2] {
    let at = |radius, mass, x, velocity, spin| RoughGrain {
        radius,
        mass,
        position: [x, 0.0, 0.0],
        velocity,
        rotation: [0.0, 0.0, spin],
    };
    [at(1.0, 2.0, 0.0, velocity, spin), at(0.5, 1.0, 1.5, [0.0; 3], 0.0)]
}

fn head_on(law: GeneralLaw, cohesion: f64, speed: f64) -> Option<f64> {
    let hit = collide_general(grains([speed, 0.0, 0.0], 0.0), (law, cohesion), SMOOTH).unwrap();
    hit.map(|hit| (hit.after[1].velocity[0] - hit.after[0].velocity[0]) / speed)
}

#[test]
fn hysteretic_springs_have_one_restitution_at_every_speed() {
    for (unloading, wanted) in [(4e6, 0.5), (1e6, 1.0)] {
        let law = GeneralLaw::WaltonBraun { loading: 1e6, unloading };
        for speed in [1e-3, 1.0, 50.0] {
            let found = head_on(law, 0.0, speed).unwrap();
            assert!((found - wanted).abs() < 1e-8, "{speed}: {found}");
        }
    }
    // With what holds, too: m v² = k₁ x² − 2 c x at the deepest x.
    let (law, cohesion, mass) =
        (GeneralLaw::WaltonBraun { loading: 1e6, unloading: 4e6 }, 100.0, 2.0 / 3.0);
    let deepest = |v: f64| {
        let (k, c): (f64, f64) = (1e6, cohesion);
        (c + (c * c + k * mass * v * v).sqrt()) / k
    };
    let speed = 1.0;
    let x = deepest(speed);
    // From the deepest back to zero overlap: the spring gives k₁² x²/(2 k₂), the hold takes c x.
    let left = 1e12 * x * x / 4e6 - 2.0 * cohesion * x;
    let found = head_on(law, cohesion, speed).unwrap();
    let wanted = (left / mass).sqrt();
    assert!((found - wanted).abs() < 1e-8, "{found} {wanted}");
    assert_eq!(head_on(law, cohesion, 1e-4), None);
}

#[test]
fn powers_are_the_known_laws_where_these_are_powers() {
    let radius = 1.0 / 3.0_f64;
    let rho = 2.0 * 1e9 * radius.sqrt() / (3.0 * (1.0 - 0.09));
    let hertz = ForceLaw::Viscoelastic { young: 1e9, poisson: 0.3, dissipation: 1e-5 };
    let linear = ForceLaw::LinearDashpot { stiffness: 1e6, damping: 60.0 };
    for (known, stiffness, exponent, damping, damping_exponent) in
        [(linear, 1e6, 1.0, 60.0, 0.0), (hertz, rho, 1.5, 1.5e-5 * rho, 0.5)]
    {
        let law = GeneralLaw::Power { stiffness, exponent, damping, damping_exponent };
        let rub = Friction { mu: 0.3, stiffness: 3e5, ..SMOOTH };
        let start = grains([1.0, 0.4, 0.0], 0.7);
        let wanted = collide_rough(start, known, rub).unwrap();
        let found = collide_general(start, (law, 0.0), rub).unwrap().unwrap();
        for (a, b) in wanted.after.iter().zip(&found.after) {
            for k in 0..3 {
                assert!((a.velocity[k] - b.velocity[k]).abs() < 1e-9, "{a:?} {b:?}");
                assert!((a.rotation[k] - b.rotation[k]).abs() < 1e-8, "{a:?} {b:?}");
            }
        }
    }
}

const STICKY: Sticky = Sticky { young: 1e6, poisson: 0.3, dissipation: 0.0, work: 10.0 };

#[test]
fn an_elastic_contact_of_jkr_costs_what_theory_says() {
    // 7.09 (w⁵ R⁴/E*²)^(1/3) (Thornton & Ning, Powder Technol. 99, 154, 1998).
    let (modulus, radius): (f64, f64) = (1e6 / (2.0 * 0.91), 1.0 / 3.0);
    let cost = 7.09 * (1e5 * radius.powi(4) / (modulus * modulus)).cbrt();
    let capture = (2.0 * cost / (2.0 / 3.0)).sqrt();
    assert!(head_on(GeneralLaw::Jkr(STICKY), 0.0, 0.99 * capture).is_none());
    for times in [1.01_f64, 2.0, 20.0] {
        let found = head_on(GeneralLaw::Jkr(STICKY), 0.0, times * capture).unwrap();
        let wanted = (1.0 - 1.0 / (times * times)).sqrt();
        assert!((found * found - wanted * wanted).abs() < 1e-3, "{times}: {found} {wanted}");
    }
    // DMT's force is the same both ways.
    let found = head_on(GeneralLaw::Dmt(STICKY), 0.0, 0.1 * capture).unwrap();
    assert!((found - 1.0).abs() < 1e-9, "{found}");
    let damped = Sticky { dissipation: 1e-3, ..STICKY };
    assert!(head_on(GeneralLaw::Dmt(damped), 0.0, 0.01 * capture).is_none());
}

/// Momentum, and angular momentum about the origin with spins.
fn kept(grains: &[RoughGrain; 2]) -> [f64; 3] {
    let sum = |of: &dyn Fn(&RoughGrain) -> f64| grains.iter().map(of).sum();
    [
        sum(&|g| g.mass * g.velocity[0]),
        sum(&|g| g.mass * g.velocity[1]),
        sum(&|g| {
            let [x, y, _] = g.position;
            g.mass * (x * g.velocity[1] - y * g.velocity[0])
                + 0.4 * g.mass * g.radius * g.radius * g.rotation[2]
        }),
    ]
}

#[test]
fn what_the_two_have_is_kept_and_energy_never_grows() {
    let energy = |grains: &[RoughGrain; 2]| -> f64 {
        let one = |g: &RoughGrain| {
            let square = |x: &[f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
            g.mass * (square(&g.velocity) + 0.4 * g.radius * g.radius * square(&g.rotation))
        };
        grains.iter().map(one).sum()
    };
    let laws = [
        GeneralLaw::Power { stiffness: 1e7, exponent: 2.0, damping: 3e4, damping_exponent: 1.0 },
        GeneralLaw::WaltonBraun { loading: 1e6, unloading: 3e6 },
        GeneralLaw::Dmt(Sticky { dissipation: 1e-4, ..STICKY }),
        GeneralLaw::Jkr(STICKY),
    ];
    for law in laws {
        for damping in [0.0, 100.0] {
            let rub = Friction { mu: 0.3, stiffness: 3e5, damping, inertia: 0.4 };
            let start = grains([1.0, 0.7, 0.0], -0.9);
            let hit: RoughImpact = collide_general(start, (law, 5.0), rub).unwrap().unwrap();
            for (a, b) in kept(&start).iter().zip(kept(&hit.after)) {
                assert!((a - b).abs() < 1e-9, "{law:?}: {a} {b}");
            }
            assert!(energy(&hit.after) < energy(&start));
            assert!(hit.after[1].rotation[2] != 0.0);
        }
    }
}

#[test]
fn bad_parameters_are_named() {
    let start = grains([1.0, 0.0, 0.0], 0.0);
    let said = |law, cohesion, friction| {
        collide_general(start, (law, cohesion), friction).unwrap_err().to_string()
    };
    let good = GeneralLaw::WaltonBraun { loading: 1.0, unloading: 2.0 };
    let weak = GeneralLaw::WaltonBraun { loading: 2.0, unloading: 1.0 };
    assert!(said(weak, 0.0, SMOOTH).contains("unloading = 1"));
    assert!(said(good, -1.0, SMOOTH).contains("cohesion = -1"));
    assert!(said(good, 0.0, Friction { damping: -1.0, ..SMOOTH }).contains("tangential damping"));
    let flat =
        GeneralLaw::Power { stiffness: 1.0, exponent: 0.5, damping: 0.0, damping_exponent: 0.0 };
    assert!(said(flat, 0.0, SMOOTH).contains("exponent = 0.5"));
    let rubber = Sticky { poisson: 0.7, ..STICKY };
    assert!(said(GeneralLaw::Jkr(rubber), 0.0, SMOOTH).contains("poisson = 0.7"));
}

/// The limit of a stiff contact: a spring that swings many times faster than the normal force and loses nothing parts
/// surfaces as a hard impact that slides does, where both slide throughout.
#[test]
fn hard_impacts_are_those_of_stiff_contacts_that_slide() {
    let start = grains([1.0, 2.0, 0.0], -3.0);
    let linear = ForceLaw::LinearDashpot { stiffness: 1e12, damping: 0.0 };
    let rub = Friction { mu: 0.05, stiffness: 1e12, damping: 0.0, inertia: 0.4 };
    let soft = collide_rough(start, linear, rub).unwrap().after;
    let hard = HardImpact { restitution: 1.0, beta_0: 1.0, mu: Some(0.05), inertia: 0.4 };
    let hard = collide_hard(start, hard).unwrap();
    for (a, b) in soft.iter().zip(&hard) {
        for k in 0..3 {
            assert!((a.velocity[k] - b.velocity[k]).abs() < 1e-5, "{a:?} {b:?}");
            assert!((a.rotation[k] - b.rotation[k]).abs() < 1e-5, "{a:?} {b:?}");
        }
    }
    for (a, b) in kept(&start).iter().zip(kept(&hard)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}
