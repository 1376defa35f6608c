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

mod gas {
    use carom_host::reference::{Boundary, End, ForceLaw, Grain, System, Verlet, VerletOptions};

    pub struct Random(u64);

    impl Random {
        pub fn new(seed: u64) -> Self {
            Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
        }

        /// Uniform in [0, 1): splitmix64.
        pub fn uniform(&mut self) -> f64 {
            self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
        }

        pub fn normal(&mut self) -> f64 {
            let (a, b) = (self.uniform(), self.uniform());
            (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
        }
    }

    /// N spheres of MP13 Sec. VI B 6 on a lattice in a periodic box, root mean square speed 2 m/s.
    pub fn periodic(side: usize, packing: f64, seed: u64) -> System<3> {
        let (radius, n) = (0.1_f64, side.pow(3));
        let volume = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let width = (n as f64 * volume / packing).cbrt();
        let mut random = Random::new(seed);
        let cell = width / side as f64;
        let grain = |k: usize| Grain {
            radius,
            mass: 1140.0 * volume,
            position: [k % side, k / side % side, k / side / side].map(|i| (i as f64 + 0.5) * cell),
            velocity: std::array::from_fn(|_| random.normal() * 2.0 / 3.0_f64.sqrt()),
        };
        let grains = (0..n).map(grain).collect();
        let bound = Boundary::Periodic { lo: 0.0, hi: width };
        System::new(grains, [bound; 3], [0.0; 3]).expect("a valid gas")
    }

    pub const LAW: ForceLaw = ForceLaw::Viscoelastic { young: 1e9, poisson: 0.4, dissipation: 0.0 };

    #[test]
    #[ignore = "a measurement: run with --release --nocapture"]
    fn speed_of_verlet() {
        let system = periodic(10, 0.01, 1);
        for skin in [Some(0.003), None, Some(0.2), Some(0.3)] {
            let options = VerletOptions { skin, ..VerletOptions::default() };
            let mut run = Verlet::new(&system, LAW, End::Force, options).expect("valid");
            let start = std::time::Instant::now();
            run.advance_to(1.0).expect("goes on");
            let wall = start.elapsed().as_secs_f64();
            let c = run.counters();
            println!(
                "skin {:?} -> {:.3}: {:.3} s wall, {:.0} steps/s, {} listed, {c:?} dt {:.2e}, energy {:.2e}",
                skin,
                run.skin(),
                wall,
                c.steps as f64 / wall,
                run.listed(),
                run.time_step(),
                {
                    let s = run.system().unwrap();
                    (s.kinetic_energy() + s.elastic_energy(&LAW)) / system.kinetic_energy() - 1.0
                }
            );
        }
    }
}
