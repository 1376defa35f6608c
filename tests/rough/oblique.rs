//! Does friction in a contact that lasts do what the forces say? Single impacts against an independent program.

use carom::law::{LinearDashpot, Outside, Rough, Rule, Soft, Tangential, Viscoelastic};
use carom::space::{ContactState, Plane, Surface};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, Memory, World};

/// A row of `tests/data/oblique.csv` by the names of its columns.
struct Row<'a>(Vec<(&'a str, &'a str)>);

impl Row<'_> {
    fn text(&self, name: &str) -> &str {
        self.0.iter().find(|(column, _)| *column == name).unwrap().1
    }
    fn get(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap()
    }
    fn tangential(&self) -> Tangential<f64> {
        let (mu, stiffness) = (self.get("mu"), self.get("tangential_stiffness"));
        Tangential::Spring { mu, stiffness, damping: 0.0 }
    }
}

fn rows(text: &str) -> impl Iterator<Item = Row<'_>> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    lines.map(move |line| Row(names.iter().copied().zip(line.split(',')).collect()))
}

/// The largest difference to a row's end: lengths in R₁ + R₂, velocities in the normal speed, spins in that over R.
fn difference(row: &Row<'_>, rule: impl Rule<f64>, steps: u32) -> f64 {
    let is_wall = row.get("wall") == 1.0;
    let [r, s] = [row.get("r1"), row.get("r2")];
    let n = carom::Vector::<f64, 2>::new(row.get("nx"), row.get("ny"));
    let pair = |a: &str, b: &str| [row.get(a), row.get(b)];
    let (v, u) = (pair("vx1", "vy1"), pair("vx2", "vy2"));
    let spins = [row.get("w1"), row.get("w2")];
    let contacts = [ContactState::VACANT; 2];
    let mut memory = Rotating::new(
        WithContacts::new(Memory::<f64, 2, 2>::new(), contacts),
        [spins, [0.0; 2], [0.0; 2]],
    );
    let first = if is_wall { [0.0, r] } else { (n * (r + s)).into() };
    let mut world = World::builder(&mut memory)
        .rule(rule)
        .steps_per_contact(steps)
        .grain(Grain::with_mass(r, row.get("m1")).at(first).moving(v))
        .unwrap();
    world = match is_wall {
        true => world.plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule)),
        false => world.grain(Grain::with_mass(s, row.get("m2")).at([0.0; 2]).moving(u)).unwrap(),
    };
    let mut world = world.start().unwrap();
    world.advance_to(row.get("duration")).unwrap();
    let speed = -(carom::Vector::from(v) - carom::Vector::from(u)).dot(&n);
    let speed = if is_wall { -v[1] } else { speed };
    let mut worst = 0.0_f64;
    for (i, radius) in [r, s].into_iter().enumerate().take(if is_wall { 1 } else { 2 }) {
        let grain = world.grain(i).unwrap();
        let spin = world.view().angular_velocity(i).unwrap()[2];
        let number = i + 1;
        let at = |name: &str| row.get(&format!("{name}{number}"));
        for (k, axis) in ["x", "y"].into_iter().enumerate() {
            worst = worst.max((grain.position[k] - at(axis)).abs() / (r + s));
            worst = worst.max((grain.velocity[k] - at(&format!("out_v{axis}"))).abs() / speed);
        }
        worst = worst.max((spin - at("out_w")).abs() * radius / speed);
    }
    worst
}

/// All contacts are integrated.
fn integrated<R>(normal: R, tangential: Tangential<f64>) -> Rough<R, f64> {
    Rough { eta_max: 0.0, ..Rough::spheres(normal, tangential) }
}

fn all(steps: u32) -> Vec<f64> {
    let text = include_str!("../data/oblique.csv");
    let differences: Vec<f64> = rows(text)
        .map(|row| {
            let damping = row.get("damping_or_A");
            match row.text("law") {
                "lsd" => {
                    let law = LinearDashpot { stiffness: row.get("stiffness_or_young"), damping };
                    let rule = Soft::linear_dashpot(law, Outside::HardSphere);
                    difference(&row, integrated(rule, row.tangential()), steps)
                }
                _ => {
                    let law = Viscoelastic {
                        young: row.get("stiffness_or_young"),
                        poisson: row.get("poisson"),
                        dissipation: damping,
                    };
                    let rule = Soft::viscoelastic(law, Outside::HardSphere);
                    difference(&row, integrated(rule, row.tangential()), steps)
                }
            }
        })
        .collect();
    assert_eq!(differences.len(), 78);
    differences
}

/// The largest of these, and the one in the middle.
fn largest_and_median(mut some: Vec<f64>) -> [f64; 2] {
    some.sort_by(f64::total_cmp);
    [some[some.len() - 1], some[some.len() / 2]]
}

#[test]
fn steps_reach_an_independent_integration_to_second_order() {
    let [coarse, fine, finest] = [32, 256, 2048].map(|steps| largest_and_median(all(steps)));
    for ([most, middle], [largest, median]) in
        [(coarse, [2e-3, 5e-4]), (fine, [4e-5, 8e-6]), (finest, [1.5e-6, 2.5e-7])]
    {
        assert!(most < largest && middle < median, "{most:e} {middle:e}");
    }
    // Eight times as many steps: an error 64 times as small, or better than 40 where it nears that of the data.
    assert!(coarse[1] / fine[1] > 40.0 && fine[1] / finest[1] > 25.0);
}

#[test]
#[ignore = "half a minute: run in release"]
fn in_131_072_steps_an_independent_integration_is_met_to_eight_digits() {
    let [most, median] = largest_and_median(all(131_072));
    println!("{median:e} {most:e}");
    assert!(median < 2e-10 && most < 1e-8, "{median:e} {most:e}");
}
