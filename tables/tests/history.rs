//! Do a contact's overlap and force over time keep their closed forms? Reads what carom-tables makes; writes nothing.

use carom_tables::contact::integrate;
use carom_tables::read::{End, Groups, History, Law};
use carom_tables::recipe::emit_history;

/// The history in the text, whose lists have no other brackets.
fn made(law: Law) -> History<f32> {
    let text = emit_history(law, "MADE", "read").unwrap();
    let list = |name: &str| {
        let (_, from) = text.split_once(&format!("{name}: &[")).unwrap();
        let numbers = from.split_once(']').unwrap().0.split(", ").map(|x| x.parse().unwrap());
        &*numbers.collect::<Vec<f32>>().leak()
    };
    let number = |name: &str| {
        let (_, from) = text.split_once(&format!("{name}: ")).unwrap();
        from.split_once(',').unwrap().0.parse::<f64>().unwrap()
    };
    let [duration, overlap, rate] = ["duration", "overlap", "rate"].map(list);
    let [c_dis_max, error] = ["c_dis_max", "error"].map(number);
    History { law, c_dis_max, error, duration, overlap, rate }
}

#[test]
fn overlap_and_force_of_a_linear_contact_are_a_damped_swing() {
    let history = made(Law::LinearDashpot);
    assert!(history.error < 1.5e-6, "{:e}", history.error);
    for c in [0.0_f64, 0.01, 0.3, 0.77, 1.0] {
        let (beta, w) = (c / 2.0, (1.0 - c * c / 4.0).sqrt());
        let contact = history.at::<f64>(c).unwrap();
        for k in 0..=50 {
            let phase = f64::from(k) / 50.0;
            let t = contact.time(phase);
            let x = (-beta * t).exp() * (w * t).sin() / w;
            let v = (-beta * t).exp() * ((w * t).cos() - beta / w * (w * t).sin());
            assert!((contact.overlap(phase) - x).abs() < 2.0 * history.error, "{c} {phase}");
            assert!((contact.rate(phase) - v).abs() < 2.0 * history.error, "{c} {phase}");
            assert!((contact.force(phase) - (x + c * v).max(0.0)).abs() < 4.0 * history.error);
        }
    }
}

#[test]
fn contacts_end_as_the_table_of_restitution_says_and_energy_is_kept_without_loss() {
    for law in [Law::LinearDashpot, Law::Viscoelastic] {
        let history = made(law);
        assert!(history.error < 1.5e-6, "{:e}", history.error);
        for c_dis in [0.0, 0.05, 0.4, 1.0] {
            let groups = Groups { sin: 0.0, cos: 1.0, eta: 0.0, c_dis };
            let end = integrate(law, End::Force, &groups);
            let contact = history.at::<f64>(c_dis).unwrap();
            assert!((contact.duration / end.tau - 1.0).abs() < history.error);
            assert!((contact.rate(1.0) + end.speed).abs() < history.error);
            assert!(contact.force(1.0) < 1e-4);
        }
        let lossless = history.at::<f64>(0.0).unwrap();
        for k in 0..=40 {
            let phase = f64::from(k) / 40.0;
            let (x, v) = (lossless.overlap(phase).max(0.0), lossless.rate(phase));
            let potential = if law == Law::Viscoelastic { 0.8 * x.powf(2.5) } else { x * x };
            assert!((v * v + potential - 1.0).abs() < 4.0 * history.error, "{law:?} {phase}");
        }
    }
}

#[test]
fn outside_its_range_it_says_nothing() {
    let history = made(Law::Viscoelastic);
    for c_dis in [-1e-6, 1.1, f64::NAN, f64::INFINITY] {
        assert!(history.at::<f64>(c_dis).is_none());
    }
}
