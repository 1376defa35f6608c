//! Do columns of beads come out as in L94 (Luding et al., Phys. Rev. E 50, 4113, 1994)? MD, ED and eMD* against reference data, the paper and Eq. (10).

use carom_host::figure::fit;
use carom_host::figure::l94::column::Column;
use carom_host::figure::l94::layer;
use carom_host::figure::l94::loss::{self, impact};
use carom_host::figure::l94::separation::{every_ed, separations, ten};
use carom_host::figure::l94::table1::{ROWS, measured, theory};
use carom_reference::ForceLaw;

/// Column `name` of a table of the reference data, as numbers.
fn table(text: &str, names: [&str; 4]) -> Vec<[f64; 4]> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let at = names.map(|name| header.iter().position(|h| *h == name).unwrap());
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        at.map(|k| cells[k].parse().unwrap())
    };
    lines.map(row).collect()
}

/// Fig. 2a: the decades are in the table; the half-decades between them have to fall between.
#[test]
fn md_against_the_separation() {
    let text = include_str!("../data/luding-eps-eff-vs-sigma.csv");
    let md: Vec<f64> = separations().map(|s| ten("MD", s, 0.2, None).unwrap()).collect();
    let rows = table(text, ["sigma", "eps_eff", "N", "eps"]);
    assert_eq!(rows.len(), 7);
    for [sigma, wanted, ..] in rows {
        let k = separations().position(|s| (s / sigma - 1.0).abs() < 1e-9).unwrap();
        assert!((md[k] - wanted).abs() < 1e-6, "σ = {sigma}: {} {wanted}", md[k]);
    }
    assert!(md.windows(2).all(|two| two[1] <= two[0] + 1e-9), "{md:?}");
}

/// Fig. 2a, the dashed line: 0.341 ± 0.002 for every s_0 and v_0, and with gaps at random.
#[test]
fn ed_does_not_know_the_separation() {
    let [low, high] = every_ed().unwrap();
    assert!((low - 0.3415).abs() < 5e-4 && (high - 0.3415).abs() < 5e-4, "{low} {high}");
}

/// eMD* ends a contact when a third bead comes, as if it had been completed: the energy of ED.
#[test]
fn emd_star_loses_what_ed_loses() {
    for sigma in separations() {
        let [star, ed] = ["eMD*", "ED"].map(|method| ten(method, sigma, 0.2, None).unwrap());
        assert!((star - ed).abs() < 1e-4, "σ = {sigma}: {star} {ed}");
    }
}

/// Figs. 2b and 2c: beads in contact; and E_r/E_f = 0.035 in the paper, for N = 10 and ε = 0.9.
#[test]
fn md_of_beads_in_contact() {
    let text = include_str!("../data/luding-loss-vs-n.csv");
    for [n, eps, loss, share] in table(text, ["N", "eps", "one_minus_eps_eff", "Er_over_Ef"]) {
        let law = ForceLaw::spring_of(1.0, 2e-5, eps).unwrap();
        let got = impact("MD", &Column::new(n as usize, 0.05, 0.0), &law, true).unwrap();
        let [got_loss, got_share] = [1.0 - got.restitution(), got.relative().unwrap()];
        assert!((got_loss - loss).abs() < 1e-6, "N = {n}, ε = {eps}: {got_loss} {loss}");
        assert!((got_share - share).abs() < 1e-6, "N = {n}, ε = {eps}: {got_share} {share}");
        if n == 10.0 && eps == 0.9 {
            assert!((got_share - 0.034).abs() < 5e-4, "{got_share}");
        }
    }
}

/// L94's integrator gives what exact MD gives.
#[test]
fn the_papers_integrator_agrees() {
    for (beads, eps) in [(5, 0.6), (10, 0.9)] {
        let law = ForceLaw::spring_of(1.0, 2e-5, eps).unwrap();
        let column = Column::new(beads, 0.05, 0.0);
        let exact = column.collide(law).unwrap().restitution();
        let steps = column.collide_in_steps(law, loss::STEPS).unwrap().restitution();
        assert!((steps - exact).abs() < 2e-4, "N = {beads}, ε = {eps}: {steps} {exact}");
    }
}

/// The inelastic collapse of ED: N = 10 and ε = 0.6 stay a cluster, ε_eff ≈ 0 (Sec. V A).
#[test]
fn ed_collapses_where_md_does_not() {
    let law = ForceLaw::spring_of(1.0, 2e-5, 0.6).unwrap();
    let column = Column::new(10, 0.05, 0.0);
    let of = |method: &str| impact(method, &column, &law, true).unwrap().restitution();
    assert!(of("ED") < 0.01, "{}", of("ED"));
    assert!(of("MD") > 0.89, "{}", of("MD"));
}

/// Table I, with its two misprints put right.
#[test]
fn exponents_of_the_impact_speed() {
    for row in ROWS {
        let (found, right) = (measured(row).unwrap(), theory(row));
        for k in 0..3 {
            assert!((found[k] - right[k]).abs() < 1e-3, "{row:?}: {found:?} {right:?}");
        }
    }
    assert_eq!(theory([0.5, 0.0]), [0.8, -0.2, -0.2]);
    assert_eq!(theory([0.5, 0.5]), [0.8, -0.2, 0.2]);
}

/// Fig. 4a: contact by contact, a layer is left with the energy that L94's integrator leaves it.
#[test]
#[ignore = "a minute: run with --release"]
fn layers_by_both_integrators() {
    let (patience, seeds) = ([40.0, 20.0], 0..6);
    let mean = |exact: bool| {
        let eps = |seed| match exact {
            true => layer::wide(3.0, 0.0, seed).collide_exactly(patience),
            false => layer::wide(3.0, 0.0, seed).collide(50.0, patience),
        };
        fit::mean(&seeds.clone().map(|seed| eps(seed).unwrap()).collect::<Vec<f64>>())
    };
    let (exact, steps) = (mean(true), mean(false));
    println!("{exact:?} {steps:?}");
    assert!((exact[0] - steps[0]).abs() < 2.0 * exact[1].hypot(steps[1]));
}
