//! Does the contact equation give what the Cartesian two-sphere equations give? Reads the reference collisions; writes nothing.
use carom_tables::{End, Groups, Law, contact::integrate};

#[test]
fn integrate_gives_the_reference_collisions() {
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/data/collisions.csv"
    ))
    .unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let at = |name: &str| head.iter().position(|h| *h == name).unwrap();
    let mut worst = [0.0_f64; 4];
    for line in lines {
        let cell: Vec<&str> = line.split(',').collect();
        let number = |name: &str| cell[at(name)].parse::<f64>().unwrap();
        let law = if cell[1] == "lsd" { Law::LinearDashpot } else { Law::Viscoelastic };
        let e = number("e");
        let g = Groups {
            sin: e,
            cos: ((1.0 - e) * (1.0 + e)).sqrt(),
            eta: 1.0 / number("ltil"),
            c_dis: number("cdis"),
        };
        let s = integrate(law, End::Force, &g);
        let errors = [
            (s.tau / number("eps_t") - 1.0).abs(),
            (1.0 - s.separation - number("one_minus_eps_r")).abs(),
            (-s.speed - number("eps_rdot")).abs(),
            (s.angle - number("eps_phi")).abs(),
        ];
        if errors.iter().any(|e| !(*e < 1e-10)) {
            println!("{} {:?} {errors:?}", cell[0], g);
        }
        for (w, e) in worst.iter_mut().zip(errors) {
            *w = w.max(e);
        }
    }
    println!("{worst:?}");
    assert!(worst.iter().all(|w| *w < 1e-9));
}
