//! Do materials of grains and walls have their laws and densities? Reads scenarios as text; writes nothing.

use super::{TWO_MATERIALS, refused, started};
use carom_host::method;
use carom_host::scenario::{MethodName, Placed, Scenario, Start};
use std::f64::consts::PI;

/// Two equal grains part with ε (v₁ − v₂), ε being that of the pair's materials.
#[test]
fn each_pair_of_materials_has_its_own_law() {
    for (a, b, restitution) in [
        ("steel", "steel", 0.9),
        ("steel", "clay", 0.5),
        ("clay", "steel", 0.5),
        ("clay", "clay", 0.1),
    ] {
        let text =
            TWO_MATERIALS.replace("\"A\"", &format!("{a:?}")).replace("\"B\"", &format!("{b:?}"));
        let scenario = Scenario::parse(&text).expect("a good scenario");
        let start = Start::new(&scenario).expect("two grains");
        let parting = method::with(MethodName::Emd, &scenario, &start, |method| {
            method.advance_to(1.0)?;
            let grains = method.grains();
            Ok(grains[1].velocity[0] - grains[0].velocity[0])
        });
        let parting = parting.expect("a run");
        assert!((parting - restitution).abs() < 1e-12, "{a} on {b}: {parting}");
    }
}

/// L94's laws: a linear one parts with ε = exp(−π μ/√(ω² − μ²)) after π/√(ω² − μ²) (L94, Eqs. 6, 7; ω² = K/m_eff, μ = D
/// for a pair, D/2 at a wall), and of a pair of spheres the exact MD says what the other methods must find.
#[test]
fn grains_follow_the_laws_of_l94() {
    let text = |law: &str, methods: &str| {
        format!(
            "dimension = 1\nduration = 1.0\nsample = 0.5\nmethods = [{methods}]\n\
            [[material]]\nname = \"bead\"\ndensity = 2000.0\nlaw = {{ kind = \"l94\", {law} }}\n\
            [box]\nx = {{ kind = \"walls\", from = -1.0, to = 2.0 }}\n\
            [[grain]]\nradius = 0.1\nat = [0.0]\nmoving = [1.0]\n\
            [[grain]]\nradius = 0.05\nat = [0.5]\n"
        )
    };
    let after = |law: &str, name: MethodName, time: f64| {
        let scenario = Scenario::parse(&text(law, "")).unwrap().with_method(name).unwrap();
        let start = Start::new(&scenario).unwrap();
        let end = method::with(name, &scenario, &start, |method| {
            method.advance_to(time)?;
            Ok(method.grains())
        });
        end.unwrap()
    };
    let all = [MethodName::Md, MethodName::Exact, MethodName::Emd, MethodName::EmdStar];
    let part = |grains: &[Placed]| grains[1].velocity[0] - grains[0].velocity[0];
    let [heavy, light] = [0.1_f64, 0.05].map(|r| 4.0 / 3.0 * PI * r.powi(3) * 2000.0);
    let (k, d) = (1e6, 100.0);
    let reduced = heavy * light / (heavy + light);
    let restitution = |mass: f64, mu: f64| (-PI * mu / (k / mass - mu * mu).sqrt()).exp();
    let linear = format!("stiffness = {k:?}, damping = {d:?}");
    for name in all {
        let found = part(&after(&linear, name, 0.4)) / restitution(reduced, d);
        // Steps are a 32nd of a contact and shorter.
        assert!((found - 1.0).abs() < 3e-3, "{name:?}: {found}");
    }
    // The light one is the first at a wall.
    let before = after(&linear, MethodName::Emd, 0.5)[1].velocity[0];
    let time = 0.4 + 1.5 / before;
    for name in [MethodName::Emd, MethodName::EmdStar, MethodName::Exact] {
        let found = -after(&linear, name, time)[1].velocity[0] / before;
        let wanted = restitution(light, 0.5 * d);
        assert!((found / wanted - 1.0).abs() < 3e-3, "{name:?}: {found} {wanted}");
    }
    let sphere = "stiffness = 1e8, beta = 0.5, damping = 2e3, gamma = 0.5";
    let exact = part(&after(sphere, MethodName::Exact, 0.4));
    assert!(0.1 < exact && exact < 0.99, "{exact}");
    for name in all {
        let found = part(&after(sphere, name, 0.4)) / exact;
        assert!((found - 1.0).abs() < 3e-3, "{name:?}: {found}");
    }
    let said = format!(
        "{:#}",
        Scenario::parse(&text("stiffness = 1.0, damping = 0.0, gamma = 2.0", "")).unwrap_err()
    );
    assert!(said.contains("law.gamma is 2, must be from 0 to 1 + beta"), "{said}");
}

/// The density of the material makes the mass.
#[test]
fn materials_have_a_density() {
    let text = TWO_MATERIALS
        .replace("mass = 1.0\n", "")
        .replace("\"A\"", "\"steel\"")
        .replace("\"B\"", "\"clay\"");
    let start = started(&text);
    for (grain, density) in start.grains.iter().zip([7800.0, 2000.0]) {
        assert!((grain.mass / (4.0 / 3.0 * PI * 1e-3 * density) - 1.0).abs() < 1e-12);
    }
}

/// A wall has the law of its material with the grain's, a soft one that of two of the grain's.
#[test]
fn walls_are_of_a_material() {
    let text = |wall: &str| {
        format!(
            "dimension = 1\nduration = 1.0\nsample = 1.0\n[box]\nx = {{ kind = \"walls\", from = 0.0, to = 9.0{wall} }}\n\
             [[material]]\nname = \"steel\"\ndensity = 1.0\nrestitution = 0.9\n\
             [[material]]\nname = \"clay\"\nrestitution = 0.1\n\
             [[pair]]\nbetween = [\"clay\", \"steel\"]\nrestitution = 0.5\n\
             [[grain]]\nradius = 0.1\nat = [0.5]\nmoving = [-1.0]\nmaterial = \"steel\"\n"
        )
    };
    for (wall, restitution) in [
        ("", 0.9),
        (", surface = \"soft\"", 0.9),
        (", restitution = 0.7", 0.7),
        (", material = \"steel\"", 0.9),
        (", material = \"clay\"", 0.5),
    ] {
        let scenario = Scenario::parse(&text(wall)).expect("a good scenario");
        let start = Start::new(&scenario).expect("one grain");
        let speed = method::with(MethodName::Emd, &scenario, &start, |method| {
            method.advance_to(1.0)?;
            Ok(method.grains()[0].velocity[0])
        });
        assert!((speed.expect("a run") - restitution).abs() < 1e-12, "{wall}");
    }
    for (wall, wanted) in [
        (", material = \"glas\"", "box.x.material is \"glas\", which no [[material]] defines"),
        (", material = \"clay\", restitution = 0.5", "box.x.material is given, and so is surface"),
        (", surface = \"hard\"", "box.x.restitution: hard walls need one"),
        (", amplitude = 0.1", "box.x.frequency is 0, must be finite and above 0"),
    ] {
        let error = refused(&text(wall));
        assert!(error.contains(wanted), "{wanted:?}: {error:?}");
    }
}

/// Both walls go up first, by A sin(ωt): each meets a grain at rest a gap g away when A |sin(ωt)| = g, the upper one
/// half a cycle later, and throws it off with twice its own speed.
#[test]
fn two_walls_are_shaken_as_one() {
    let text = "dimension = 1\nduration = 1.0\nsample = 1.0\n[box]\n\
        x = { kind = \"walls\", from = 0.0, to = 1000.0, restitution = 1.0, amplitude = 0.2, frequency = 0.5 }\n\
        [law]\nkind = \"constant\"\nrestitution = 1.0\n\
        [[grain]]\nradius = 1.0\nmass = 1.0\nat = [1.1]\n[[grain]]\nradius = 1.0\nmass = 1.0\nat = [998.9]\n";
    let scenario = Scenario::parse(text).expect("a good scenario");
    let start = Start::new(&scenario).expect("two grains");
    let omega = PI;
    let angle = 0.5f64.asin();
    let thrown = 2.0 * 0.2 * omega * angle.cos();
    let ways = method::with(MethodName::Emd, &scenario, &start, |method| {
        let mut ways = Vec::new();
        for time in [0.5, 1.9] {
            method.advance_to(time)?;
            let grains = method.grains();
            ways.push([
                grains[0].velocity[0],
                grains[1].velocity[0],
                grains[0].position[0],
                grains[1].position[0],
            ]);
        }
        Ok(ways)
    });
    let ways = ways.expect("a run");
    let first = 1.1 + thrown * (0.5 - angle / omega);
    let second = 998.9 - thrown * (1.9 - (PI + angle) / omega);
    for (found, wanted) in [
        (ways[0][0], thrown),
        (ways[0][1], 0.0),
        (ways[0][2], first),
        (ways[1][1], -thrown),
        (ways[1][3], second),
    ] {
        assert!((found - wanted).abs() < 1e-9, "{found} is not {wanted}");
    }
    let why = refused(
        &text.replace("[law]", "[law]\n").replace("duration", "methods = [\"md\"]\nduration"),
    );
    assert!(why.contains("MD needs"), "{why}");
}
