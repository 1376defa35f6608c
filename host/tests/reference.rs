//! Is the reference right? Reads data and closed forms made outside it; writes nothing, fails where it is not.

use carom_host::reference::{Collision, End, ForceLaw, Grain, collide};

fn data(name: &str) -> String {
    let path = format!("{}/../tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

struct Row {
    fields: std::collections::HashMap<String, String>,
}

impl Row {
    fn text(&self, name: &str) -> &str {
        &self.fields[name]
    }

    fn number(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap_or_else(|_| panic!("{name}: {}", self.text(name)))
    }

    fn law(&self) -> ForceLaw {
        if self.text("law") == "lsd" {
            let (stiffness, damping) = (self.number("k"), self.number("gamma"));
            return ForceLaw::LinearDashpot { stiffness, damping };
        }
        let (young, poisson) = (self.number("Y"), self.number("nu"));
        ForceLaw::Viscoelastic { young, poisson, dissipation: self.number("A") }
    }

    /// The impact in three dimensions, along axes that are nobody's favourites.
    fn grains(&self) -> [Grain<3>; 2] {
        let [r1, r2] = [self.number("R1"), self.number("R2")];
        let (v, e) = (self.number("v"), self.number("e"));
        let along = [0.36, 0.48, 0.8];
        let across = [0.8, -0.6, 0.0];
        let l = r1 + r2;
        let c = ((1.0 - e) * (1.0 + e)).sqrt();
        let r: [f64; 3] = std::array::from_fn(|k| l * (c * along[k] + e * across[k]));
        let grain = |radius, mass, at: f64, speed: f64| Grain {
            radius,
            mass,
            position: r.map(|x| at * x),
            velocity: along.map(|x| speed * x),
        };
        [grain(r1, self.number("m1"), 0.5, -0.5 * v), grain(r2, self.number("m2"), -0.5, 0.5 * v)]
    }

    fn worst(&self, hit: &Collision<3>) -> [f64; 4] {
        [
            hit.duration / self.number("tau") - 1.0,
            (1.0 - hit.eps_r) - self.number("one_minus_eps_r"),
            hit.eps_rdot - self.number("eps_rdot"),
            hit.eps_phi - self.number("eps_phi"),
        ]
        .map(f64::abs)
    }
}

fn rows() -> Vec<Row> {
    let text = data("collisions.csv");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap_or("").split(',').collect();
    let row = |line: &str| {
        let pairs = names.iter().zip(line.split(','));
        Row { fields: pairs.map(|(n, f)| (n.to_string(), f.to_string())).collect() }
    };
    lines.map(row).collect()
}

#[test]
#[ignore = "all rows: run with --release"]
fn all_collisions() {
    for row in rows() {
        let start = std::time::Instant::now();
        match collide(row.grains(), row.law(), End::Force, &[]) {
            Ok(hit) => {
                let w = row.worst(&hit);
                println!(
                    "{} c={} {:9.1e} {:9.1e} {:9.1e} {:9.1e} {:?}",
                    row.text("id"),
                    row.text("cdis"),
                    w[0],
                    w[1],
                    w[2],
                    w[3],
                    start.elapsed()
                );
            }
            Err(e) => println!("{} {e}", row.text("id")),
        }
    }
}
