//! Does the reference know impacts under friction? Against an independent program's, within three times their error.

use carom_reference::{
    ForceLaw, Friction, RoughGrain, RoughImpact, collide_rough, collide_rough_with_plane,
};

type Row<'a> = Vec<(&'a str, &'a str)>;

fn get(row: &Row<'_>, name: &str) -> f64 {
    row.iter().find(|(column, _)| *column == name).unwrap().1.parse().unwrap()
}

fn impact(row: &Row<'_>) -> RoughImpact {
    let at = |name: &str| get(row, name);
    let law = match row.contains(&("law", "lsd")) {
        true => ForceLaw::LinearDashpot {
            stiffness: at("stiffness_or_young"),
            damping: at("damping_or_A"),
        },
        false => ForceLaw::Viscoelastic {
            young: at("stiffness_or_young"),
            poisson: at("poisson"),
            dissipation: at("damping_or_A"),
        },
    };
    let friction = Friction {
        mu: at("mu"),
        stiffness: at("tangential_stiffness"),
        damping: 0.0,
        inertia: 0.4,
    };
    let n = [at("nx"), at("ny"), 0.0];
    let grain = |radius, mass, position, velocity, spin| RoughGrain {
        radius,
        mass,
        position,
        velocity,
        rotation: [0.0, 0.0, spin],
    };
    let [r, s] = [at("r1"), at("r2")];
    let first = |position| grain(r, at("m1"), position, [at("vx1"), at("vy1"), 0.0], at("w1"));
    if at("wall") == 1.0 {
        let plane = ([0.0; 3], [0.0, 1.0, 0.0]);
        return collide_rough_with_plane(first([0.0, r, 0.0]), plane, law, friction).unwrap();
    }
    let second = grain(s, at("m2"), [0.0; 3], [at("vx2"), at("vy2"), 0.0], at("w2"));
    collide_rough([first(n.map(|x| x * (r + s))), second], law, friction).unwrap()
}

#[test]
fn oblique_impacts_are_those_of_an_independent_program() {
    let text = include_str!("../../../tests/data/oblique.csv");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut count = 0;
    for line in lines {
        let row: Row<'_> = names.iter().copied().zip(line.split(',')).collect();
        let hit = impact(&row);
        let at = |name: &str| get(&row, name);
        let [r, s] = [at("r1"), at("r2")];
        let is_wall = at("wall") == 1.0;
        let n = [at("nx"), at("ny")];
        let speed = match is_wall {
            true => -at("vy1"),
            false => {
                -(0..2).map(|k| n[k] * (at(["vx1", "vy1"][k]) - at(["vx2", "vy2"][k]))).sum::<f64>()
            }
        };
        // What is held was measured against half as many steps: their own error may be as large.
        let most = 3.0 * at("error") + 1e-11;
        for (i, grain) in hit.after.iter().enumerate().take(if is_wall { 1 } else { 2 }) {
            let of = |name: &str| at(&format!("{name}{}", i + 1));
            let lengths = [grain.position[0] - of("x"), grain.position[1] - of("y")];
            let speeds = [grain.velocity[0] - of("out_vx"), grain.velocity[1] - of("out_vy")];
            let spin = (grain.rotation[2] - of("out_w")) * grain.radius / speed;
            let worst = lengths.iter().map(|x| x / (r + s)).chain(speeds.iter().map(|v| v / speed));
            let worst = worst.chain([spin]).fold(0.0, |a: f64, b: f64| a.max(b.abs()));
            assert!(worst < most, "row {}: {worst:e}, {most:e}", at("id"));
        }
        count += 1;
    }
    assert_eq!(count, 78);
}
