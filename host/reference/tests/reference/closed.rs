//! Does the reference agree with closed forms? Reads formulas; writes nothing.

use std::f64::consts::PI;

use carom_reference::{Boundary, Collision, End, Exact, ForceLaw, Grain, System, collide};
use proptest::prelude::*;

/// A central impact of two grains, scaled: ω0 = 1 s⁻¹ for the spring, v_n = 1 m/s.
fn central(law: ForceLaw, end: End) -> Collision<1> {
    let grain = |x, v| Grain { radius: 50.0, mass: 2.0, position: [x], velocity: [v] };
    collide([grain(50.0, -0.5), grain(-50.0, 0.5)], law, end, &[]).expect("integrates")
}

/// ẍ + 2 μ ẋ + x = 0 with m_eff = 1.
fn dashpot(mu: f64) -> ForceLaw {
    ForceLaw::LinearDashpot { stiffness: 1.0, damping: 2.0 * mu }
}

#[test]
fn dashpot_until_the_overlap_vanishes() {
    // L94 Eqs. (6), (7).
    for mu in [0.0, 1e-6, 0.01, 0.3, 0.9, 0.99] {
        let hit = central(dashpot(mu), End::Overlap);
        let duration = PI / (1.0 - mu * mu).sqrt();
        assert!((hit.duration / duration - 1.0).abs() < 1e-13, "mu {mu}");
        assert!((hit.eps_rdot + (-mu * duration).exp()).abs() < 1e-13, "mu {mu}");
        assert!((hit.eps_r - 1.0).abs() < 1e-14);
    }
}

#[test]
fn dashpot_until_the_force_vanishes() {
    // ẍ(t) = 0, solved for t by hand; ε = exp(−μ t) below and above critical damping.
    for mu in [1e-6, 0.01, 0.3, 0.7, 0.9, 0.999_f64] {
        let w = (1.0 - mu * mu).sqrt();
        let duration = (PI - (2.0 * mu * w).atan2(w * w - mu * mu)) / w;
        let hit = central(dashpot(mu), End::Force);
        assert!((hit.duration / duration - 1.0).abs() < 1e-12, "mu {mu}");
        assert!((hit.eps_rdot + (-mu * duration).exp()).abs() < 1e-13, "mu {mu}");
    }
    for mu in [1.01, 2.0, 5.0, 25.0, 500.0_f64] {
        let w = (mu * mu - 1.0).sqrt();
        // ln((μ + w)/(μ − w)), with μ − w = 1/(μ + w).
        let duration = 2.0 * (mu + w).ln() / w;
        let hit = central(dashpot(mu), End::Force);
        assert!((hit.duration / duration - 1.0).abs() < 1e-12, "mu {mu}: {}", hit.duration);
        let eps = (-mu * duration).exp();
        assert!((hit.eps_rdot / -eps - 1.0).abs() < 1e-9, "mu {mu}: {}", hit.eps_rdot);
    }
}

#[test]
fn hertz_central() {
    // L94 Eq. (A2) at β = 1/2, whose integral is 2.943275…: τ = 3.218066 (m/ρ)^{2/5} v^{−1/5}.
    let young = 1.5 / 25.0_f64.sqrt();
    let law = ForceLaw::Viscoelastic { young, poisson: 0.0, dissipation: 0.0 };
    for end in [End::Force, End::Overlap] {
        let hit = central(law, end);
        let duration = 2.943_275_184_324_704_3 * 1.25_f64.powf(0.4);
        assert!((hit.duration / duration - 1.0).abs() < 1e-13, "{}", hit.duration / duration);
        assert!((hit.eps_rdot + 1.0).abs() < 1e-13);
    }
}

/// A ball on a soft floor under gravity.
fn ball(law: ForceLaw, height: f64) -> Exact<2> {
    let grain =
        Grain { radius: 0.1, mass: 2.0, position: [0.0, 0.1 + height], velocity: [0.3, 0.0] };
    let floor = Boundary::Walls { lo: 0.0, hi: 100.0 };
    let system = System::new(vec![grain], [Boundary::Open, floor], [0.0, -10.0]).expect("valid");
    Exact::new(system, law, End::Force).expect("valid")
}

#[test]
fn a_ball_bounces_on_a_soft_floor() {
    let (stiffness, height, g) = (5000.0, 1.25, 10.0);
    let mut run = ball(ForceLaw::LinearDashpot { stiffness, damping: 0.0 }, height);
    let (fall, speed, w) = (0.5, 5.0, (stiffness / 2.0_f64).sqrt());
    // x = g/ω² (1 − cos ωt) + v/ω sin ωt vanishes again at tan(ωt/2) = −v ω/g.
    let contact = 2.0 * (PI - (speed * w / g).atan()) / w;
    for bounce in 0..20 {
        let record = run.next_contact(100.0).expect("integrates").expect("falls");
        let begin = fall + f64::from(bounce) * (contact + 2.0 * fall);
        assert!((record.begin - begin).abs() < 1e-12, "bounce {bounce}: {}", record.begin - begin);
        assert!((record.end.expect("over") - begin - contact).abs() < 1e-12, "bounce {bounce}");
        assert!((run.velocity(0)[1] - speed).abs() < 1e-11, "bounce {bounce}");
        assert_eq!(run.velocity(0)[0], 0.3);
    }
    assert_eq!(run.first_three_grain_contact(), None);
}

/// Damped: in the end the ball rests where the spring holds it.
#[test]
fn a_ball_comes_to_rest() {
    for law in [
        ForceLaw::LinearDashpot { stiffness: 5000.0, damping: 40.0 },
        ForceLaw::LinearDashpot { stiffness: 5000.0, damping: 1000.0 },
        ForceLaw::Viscoelastic { young: 1e6, poisson: 0.3, dissipation: 0.01 },
        ForceLaw::Viscoelastic { young: 1e6, poisson: 0.3, dissipation: 0.3 },
    ] {
        let mut run = ball(law, 0.01);
        // The slowest, overdamped, creeps as exp(-3.3 t).
        run.advance_to(4.0).expect("integrates");
        let weight = 2.0 * 10.0;
        let force = law.wall(0.1, 2.0).force(0.1 - run.position(0)[1], -run.velocity(0)[1]);
        assert!((force / weight - 1.0).abs() < 1e-6, "{law:?}: {force}");
        assert!(run.velocity(0)[1].abs() < 1e-6, "{law:?}: {}", run.velocity(0)[1]);
        assert_eq!(run.contacts(), 1);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// For any impact, momentum and angular momentum are kept, energy is kept or lost, and F_n = 0
    /// at the end fixes ε_r: 1 − ε_r = θ |ṙ(τ)| / l.
    #[test]
    fn any_impact_keeps_what_it_must(
        e in 0.05..0.98_f64,
        masses in [0.1..10.0_f64, 0.1..10.0_f64],
        radii in [0.05..0.5_f64, 0.05..0.5_f64],
        speed in 0.1..5.0_f64,
        damping in prop_oneof![Just(0.0), 0.001..3.0_f64],
        hertz: bool,
    ) {
        let l = radii[0] + radii[1];
        let law = match hertz {
            true => ForceLaw::Viscoelastic { young: 1e7, poisson: 0.3, dissipation: 1e-3 * damping },
            false => ForceLaw::LinearDashpot { stiffness: 1e5, damping: 1e2 * damping },
        };
        let c = (1.0 - e * e).sqrt();
        let at = |k: usize, r: [f64; 2], v: [f64; 2]| Grain {
            radius: radii[k], mass: masses[k], position: r, velocity: v,
        };
        let grains = [at(0, [0.0, 0.0], [0.0, 0.0]), at(1, [l * c, l * e], [-speed, 0.0])];
        let hit = collide(grains, law, End::Force, &[]).expect("integrates");
        let system = |g: &[Grain<2>]| System::new(g.to_vec(), [Boundary::Open; 2], [0.0; 2]).expect("valid");
        let (before, after) = (system(&grains), system(&hit.after));
        let scale = masses[1] * speed;
        prop_assert!(super::max_difference(before.momentum(), after.momentum()) < 1e-13 * scale);
        let spin = super::max_difference(before.angular_momentum(), after.angular_momentum());
        prop_assert!(spin < 1e-13 * scale * l);
        let lost = 1.0 - after.kinetic_energy() / before.kinetic_energy();
        let allowed = if damping == 0.0 { -1e-12..1e-12 } else { 1e-9..1.0 };
        prop_assert!(allowed.contains(&lost), "{}", lost);
        let contact = law.pair(radii, masses);
        let [x, u] = [l * (1.0 - hit.eps_r), hit.eps_rdot * speed * c];
        let scale = contact.force(x.max(1e-3 * l), u.abs());
        prop_assert!(contact.force(x, u).abs() < 1e-9 * scale, "{} {}", x, u);
    }
}
