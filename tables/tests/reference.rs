//! Does the contact equation give what the Cartesian two-sphere equations give? Reads the reference collisions; writes nothing.

use carom_tables::contact::integrate;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use carom_tables::recipe::Recipe;

struct Row {
    id: String,
    law: Law,
    groups: Groups<f64>,
    tau: f64,
    shortfall: f64,
    rdot: f64,
    angle: f64,
}

fn rows() -> Vec<Row> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/collisions.csv");
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |name: &str| cells[head.iter().position(|h| *h == name).unwrap()];
        let number = |name: &str| cell(name).parse::<f64>().unwrap();
        let e = number("e");
        let cos = ((1.0 - e) * (1.0 + e)).sqrt();
        Row {
            id: cell("id").into(),
            law: if cell("law") == "lsd" { Law::LinearDashpot } else { Law::Viscoelastic },
            groups: Groups { sin: e, cos, eta: 1.0 / number("ltil"), c_dis: number("cdis") },
            tau: number("eps_t"),
            shortfall: number("one_minus_eps_r"),
            rdot: number("eps_rdot"),
            angle: number("eps_phi"),
        }
    };
    lines.map(row).collect()
}

fn errors(row: &Row, s: &ScaledRestitution<f64>) -> [f64; 4] {
    [
        (s.tau / row.tau - 1.0).abs(),
        (s.speed + row.rdot).abs(),
        (s.angle - row.angle).abs(),
        (1.0 - s.separation - row.shortfall).abs(),
    ]
}

#[test]
fn integrate_gives_every_reference_collision() {
    let rows = rows();
    assert_eq!(rows.len(), 176);
    for row in rows {
        let s = integrate(row.law, End::Force, &row.groups);
        // The reference's elastic rows are good to 2e-11, the others to all their digits.
        for e in errors(&row, &s) {
            assert!(e < 1e-10, "{}: {:?} {s:?}", row.id, errors(&row, &s));
        }
    }
}

#[test]
fn tables_give_every_reference_collision_within_their_certificate() {
    for law in [Law::LinearDashpot, Law::Viscoelastic] {
        for recipe in [Recipe::compact(law), Recipe::standard(law)] {
            let table = recipe.points(2_000).generate::<f32>().unwrap();
            let c = &table.certificate;
            let mut inside = 0;
            for row in rows().iter().filter(|row| row.law == law) {
                let Some(s) = table.data().read(&row.groups) else { continue };
                inside += 1;
                let promised =
                    [c.largest.tau, c.largest.speed, c.largest.angle, c.largest.separation];
                for (e, p) in errors(row, &s).into_iter().zip(promised) {
                    assert!(e <= p, "{}: {:?} against {promised:?}", row.id, errors(row, &s));
                }
            }
            assert!(inside > 20, "only {inside} rows inside");
        }
    }
}
