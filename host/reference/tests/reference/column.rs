//! Do many contacts at once come out right? Reads L94's columns of beads, made by another MD; writes nothing.

use carom_reference::{Boundary, End, Exact, ForceLaw, Grain, System};

use super::table;

const DIAMETER: f64 = 1e-3;
const SPEED: f64 = 0.2;

struct Outcome {
    eps_eff: f64,
    relative: f64,
    centre: f64,
}

/// A column of beads of mass 1 runs into a wall at x = 0, `sigma` v0 t_c between neighbours
/// (L94 Sec. IV): ε_eff = √(E_f/E_0), E_r/E_f, and the centre of mass's velocity over v0.
fn column(beads: usize, eps: f64, sigma: f64) -> Outcome {
    let contact_time = 1e-5;
    // L94 Eqs. (6), (7) between two beads: m_eff = 1/2, γ = 2 m_eff μ.
    let mu = -eps.ln() / contact_time;
    let square = (std::f64::consts::PI / contact_time).powi(2) + mu * mu;
    let law = ForceLaw::LinearDashpot { stiffness: 0.5 * square, damping: mu };
    let gap = sigma * SPEED * contact_time;
    let bead = |k: usize| Grain {
        radius: 0.5 * DIAMETER,
        mass: 1.0,
        position: [0.5 * DIAMETER + 1e-7 + k as f64 * (DIAMETER + gap)],
        velocity: [-SPEED],
    };
    let floor = Boundary::Walls { lo: 0.0, hi: 10.0 };
    let system = System::new((0..beads).map(bead).collect(), [floor], [0.0]).expect("valid");
    let mut run = Exact::new(system, law, End::Overlap).expect("valid");
    run.advance_to(1.0).expect("integrates");
    assert_eq!(run.contacts(), 0);
    let v: Vec<f64> = (0..beads).map(|i| run.velocity(i)[0]).collect();
    let n = beads as f64;
    let energy = v.iter().map(|v| v * v).sum::<f64>();
    let centre = v.iter().sum::<f64>() / n;
    let relative = v.iter().map(|v| (v - centre).powi(2)).sum::<f64>();
    Outcome {
        eps_eff: (energy / n).sqrt() / SPEED,
        relative: relative / energy,
        centre: centre / SPEED,
    }
}

fn compare(name: &str, tolerance: f64) {
    for row in table(name) {
        let number = |name: &str| row[name].parse::<f64>().expect("a number");
        let got = column(number("N") as usize, number("eps"), number("sigma"));
        let wrong = [
            got.eps_eff - number("eps_eff"),
            got.relative - number("Er_over_Ef"),
            got.centre - number("vcm_over_v0"),
        ];
        assert!(wrong.iter().all(|w| w.abs() < tolerance), "{wrong:?} {row:?}");
    }
}

/// L94 Fig. 2a: N = 10, ε = 0.9.
#[test]
fn effective_restitution_over_separation() {
    compare("luding-eps-eff-vs-sigma.csv", 1e-10);
}

/// L94 Fig. 2b: beads that touch each other from the start.
#[test]
fn loss_of_touching_beads() {
    compare("luding-loss-vs-n.csv", 1e-10);
}
