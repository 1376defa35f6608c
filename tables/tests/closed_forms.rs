//! Does the contact equation keep its closed forms? Reads nothing; writes nothing.

use carom_tables::contact::integrate;
use carom_tables::read::{End, Groups, Law};
use std::f64::consts::PI;

const LAWS: [Law; 2] = [Law::LinearDashpot, Law::Viscoelastic];

fn central(c_dis: f64) -> Groups<f64> {
    Groups { sin: 0.0, cos: 1.0, eta: 0.01, c_dis }
}

/// A collision with eccentricity `e` in `l~ cos(alpha) = 1/softness`.
fn oblique(e: f64, softness: f64, c_dis: f64) -> Groups<f64> {
    let cos = ((1.0 - e) * (1.0 + e)).sqrt();
    Groups { sin: e, cos, eta: softness * cos, c_dis }
}

fn close(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1.0), "{got:e} is not {want:e}");
}

/// Schwager & Pöschel (2007): the force vanishes at `tan(w tau) = ...` before the overlap does.
#[test]
fn central_linear_contacts_end_where_the_force_vanishes() {
    for c in [1e-6_f64, 0.1, 0.5, 1.0, 1.41, 1.9] {
        let (beta, w) = (c / 2.0, (1.0 - c * c / 4.0).sqrt());
        // x + c x' = 0 for x = exp(-beta t) sin(w t)/w: tan(w t) = -c w/(1 - c beta).
        let tau = (-c * w).atan2(1.0 - c * beta).rem_euclid(PI) / w;
        let speed = -(-beta * tau).exp() * ((w * tau).cos() - beta / w * (w * tau).sin());
        let s = integrate(Law::LinearDashpot, End::Force, &central(c));
        close(s.tau, tau, 1e-12);
        close(s.speed, speed, 1e-12);
        close(s.speed, (-beta * tau).exp(), 1e-12);
        close(s.separation, 1.0 - 0.01 * c * speed, 1e-15);
    }
}

/// Overdamped, `c >= 2`: hyperbolic functions, and `speed -> 1/c^2`.
#[test]
fn central_linear_contacts_end_in_time_when_overdamped() {
    for c in [2.5_f64, 10.0, 50.0, 1e3] {
        let root = (c * c - 4.0).sqrt();
        // Roots of r^2 - c r + 1, without cancellation.
        let fast = (c + root) / 2.0;
        let slow = 1.0 / fast;
        let tau = 4.0 * fast.ln() / root;
        // v = (fast e^{-fast t} - slow e^{-slow t})/root
        let speed = (slow * (-slow * tau).exp() - fast * (-fast * tau).exp()) / root;
        let s = integrate(Law::LinearDashpot, End::Force, &central(c));
        close(s.tau / tau, 1.0, 1e-12);
        close(s.speed, speed, 1e-12);
        close(s.speed / speed, 1.0, 1e-9);
    }
    let s = integrate(Law::Viscoelastic, End::Force, &central(1e6));
    close(s.speed * 1e10 / (1.5_f64.powf(2.0 / 3.0)), 1.0, 1e-3);
}

/// Luding et al. (1994): the dashpot pulls until the overlap is gone.
#[test]
fn overlap_ends_give_the_coefficient_of_luding_1994() {
    for c in [1e-3_f64, 0.2, 1.0, 1.8] {
        let (mu, w) = (c / 2.0, (1.0 - c * c / 4.0).sqrt());
        let s = integrate(Law::LinearDashpot, End::Overlap, &central(c));
        close(s.tau, PI / w, 1e-12);
        close(s.speed, (-PI * mu / w).exp(), 1e-12);
        assert_eq!(s.separation, 1.0);
    }
}

/// `2 integral_0^xm dx / sqrt(1 - (4/5) x^(5/2))` with Gamma functions (MP13's reference [16]).
#[test]
fn elastic_hertz_contacts_last_3_218066() {
    let s = integrate(Law::Viscoelastic, End::Force, &central(0.0));
    let exact = 2.0 * PI.sqrt() * 1.25_f64.powf(0.4) * libm::tgamma(0.4) / libm::tgamma(0.9) * 0.4;
    close(s.tau, exact, 1e-12);
    close(exact, 3.218_066, 1e-6);
}

#[test]
fn no_damping_gives_back_speed_and_distance_exactly() {
    for law in LAWS {
        for end in [End::Force, End::Overlap] {
            for g in [oblique(0.3, 0.2, 0.0), oblique(0.999, 0.2, 0.0), oblique(0.01, 8.0, 0.0)] {
                let s = integrate(law, end, &g);
                assert_eq!((s.speed, s.separation), (1.0, 1.0));
            }
        }
    }
}

#[test]
fn stiff_contacts_do_not_turn() {
    for law in LAWS {
        let s = integrate(law, End::Force, &Groups { eta: 0.0, ..oblique(0.7, 0.1, 0.4) });
        assert_eq!((s.angle, s.separation), (0.0, 1.0));
    }
}

/// A grazing elastic pair flies straight on: the line of centres turns by `2 acos(e)`.
#[test]
fn grazing_elastic_contacts_turn_by_two_acos_e() {
    for law in LAWS {
        let mut last = 1.0;
        for cos in [0.1_f64, 0.01, 0.001] {
            let sin = (1.0 - cos * cos).sqrt();
            let s = integrate(law, End::Force, &Groups { sin, cos, eta: 0.2 * cos, c_dis: 0.0 });
            let off = (s.angle / (2.0 * cos.asin()) - 1.0).abs();
            assert!(off < last * 0.2, "{off} after {last}");
            last = off;
        }
        assert!(last < 1e-4);
    }
}

/// Without force at all (very soft) the centres pass: `tau = 2 cos/(v/l)` and the angle is `pi - 2 alpha`.
#[test]
fn very_soft_pairs_pass_straight_through() {
    for law in LAWS {
        let (alpha, softness) = (0.3_f64, 3e4);
        let g =
            Groups { sin: alpha.sin(), cos: alpha.cos(), eta: softness * alpha.cos(), c_dis: 0.0 };
        let s = integrate(law, End::Force, &g);
        close(s.angle, PI - 2.0 * alpha, 1e-4);
        close(s.tau * g.eta, 2.0 * alpha.cos() * alpha.cos(), 1e-4);
    }
    // Exactly central: no turn before the centre, half a turn behind it.
    let s = integrate(Law::LinearDashpot, End::Force, &Groups { eta: 2.0, ..central(0.0) });
    close(s.angle, PI, 1e-15);
    close(s.tau, 2.0 * 0.5_f64.asin(), 1e-12);
}
