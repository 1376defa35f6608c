//! How far is eMD* from force-based MD in a gas of ten grains? Reads the study of the host; checks its errors.

use carom_host::divergence::{Errors, Variant, study};

fn max(errors: &Errors, collision: usize) -> f64 {
    errors.max(collision).unwrap_or(0.0)
}

fn median(errors: &Errors, collision: usize) -> f64 {
    errors.median(collision).unwrap_or(0.0)
}

/// The study of all seeds, and the errors of clusters in those gases only in which no three have touched so far:
/// the others, which pairs cannot follow, are the most sensitive ones.
fn study_each(seeds: std::ops::Range<u64>) -> (Vec<Errors>, Errors) {
    let mut all = study(0..0, 10).unwrap();
    let mut alike = all[0].clone();
    for seed in seeds {
        let one = study(seed..seed + 1, 10).unwrap();
        for (sum, errors) in all.iter_mut().zip(&one) {
            for (list, more) in sum.by_collision.iter_mut().zip(&errors.by_collision) {
                list.extend(more);
            }
        }
        for (k, list) in alike.by_collision.iter_mut().enumerate() {
            list.extend(&one[0].by_collision[k][..one[1].by_collision[k].len()]);
        }
    }
    (all, alike)
}

fn check(seeds: std::ops::Range<u64>) {
    let runs = (seeds.end - seeds.start) as usize;
    let (all, alike) = study_each(seeds);
    let [clusters, integrated, table, hard] = &all[..] else { panic!() };
    assert_eq!(
        (clusters.variant, integrated.variant, table.variant, hard.variant),
        (Variant::Clusters, Variant::Integrated, Variant::Table, Variant::HardSphere)
    );
    for k in 0..10 {
        println!(
            "{:2} clusters {:.1e}, {:3} runs: clusters {:.1e}, integrated {:.1e} (largest {:.1e}), table {:.1e}, eMD {:.1e}",
            k + 1,
            median(clusters, k),
            integrated.by_collision[k].len(),
            median(&alike, k),
            median(integrated, k),
            max(integrated, k),
            median(table, k),
            median(hard, k)
        );
        assert!(max(integrated, k) < 1e-6, "collision {}: {:e}", k + 1, max(integrated, k));
    }
    assert!(integrated.by_collision[0].len() > runs * 3 / 4);
    // None ends where three touch. By the tenth collision they have in half of all gases.
    assert!(clusters.by_collision.iter().all(|list| list.len() == runs));
    assert!(max(clusters, 0) < 1e-4, "{:e}", max(clusters, 0));
    // In the same gases clusters are nearly as good as integrated pairs: what could be disturbed but is not costs
    // the error of its steps. (Over 100 gases: 5.2 times at the tenth, less than twice before.)
    for k in 0..10 {
        let [clusters, pairs] = [median(&alike, k), median(integrated, k)];
        let most = if k < 9 { 3.0 } else { 6.0 };
        assert!(
            runs < 100 || clusters < most * pairs,
            "collision {}: {clusters:e} against {pairs:e}",
            k + 1
        );
    }
    assert!(runs < 100 || median(clusters, 9) < 1e-9, "{:e}", median(clusters, 9));
    // The table starts at its certificate: an angle wrong by the certified error, carried to the sample
    // just after the contact, displaces by no more than the same fraction of l, and so does the rest.
    let certificate = carom::law::embedded::standard::VISCOELASTIC.certificate.largest;
    let promised = certificate.angle + certificate.separation + certificate.speed + certificate.tau;
    assert!(max(table, 0) < promised, "{:e} against {promised:e}", max(table, 0));
    assert!(median(hard, 0) > 100.0 * max(table, 0).max(1e-9));
}

#[test]
fn a_few_gases_follow_force_based_md() {
    check(0..6);
}

/// `cargo test --release --test judge -- --ignored hundred --nocapture`
#[test]
#[ignore = "minutes in release"]
fn a_hundred_gases_follow_force_based_md() {
    check(0..100);
}
