//! Do the quick figures say what the papers, closed forms and outside data say? Makes them; reads tests/data/fig6-path.json.

use carom_host::figure::{self, Made, Options};

fn make(id: &str) -> Made {
    let entry = figure::find(id).unwrap();
    let made = (entry.make)(&Options::default()).unwrap();
    made.figure.check().unwrap();
    made
}

fn series<'a>(made: &'a Made, name: &str) -> &'a figure::Series {
    let found = made.figure.series.iter().find(|series| series.name == name);
    found.unwrap_or_else(|| panic!("no series {name:?}"))
}

/// Elastic stiff grains turn by π c_φ/l~²: the contact lasts half a period.
#[test]
fn mp13_3_stiff_grains_turn_as_hard_ones_do() {
    let made = make("mp13-3");
    let found = series(&made, "integrated, ln l~ = 10");
    let hard = series(&made, "π c_φ/l~², ln l~ = 10");
    assert!(found.x.len() > 20);
    for (found, hard) in found.y.iter().zip(&hard.y) {
        assert!((found / hard - 1.0).abs() < 2e-3, "{found} against {hard}");
    }
}

/// A central pair with a linear dashpot: ε and τ in closed form, with the contact's end where the force vanishes.
#[test]
fn mp13_4_central_stiff_grains_are_the_damped_oscillator() {
    let made = make("mp13-4");
    let at = |what: &str| series(&made, &format!("{what}, ln c_dis = 0, ln(l~/l~^min) = 10")).y[0];
    // x'' + 2β x' + x = 0 with β = 1/2, from touch until x'' = 0: tan ωτ = −2βω/(ω² − β²), ω² = 1 − β².
    let (beta, omega) = (0.5_f64, 0.75_f64.sqrt());
    let tau = (std::f64::consts::PI - (2.0 * beta * omega / (0.75 - 0.25)).atan()) / omega;
    assert!((at("ε_t") - tau).abs() < 1e-3, "{} against {tau}", at("ε_t"));
    let speed = (-beta * tau).exp();
    assert!((at("ε_ṙ") + speed).abs() < 1e-3, "{} against {speed}", at("ε_ṙ"));
}

/// The exit angle against data integrated outside of this project.
#[test]
fn mp13_6_exit_angle() {
    let text = include_str!("../../tests/data/fig6-path.json");
    let all: serde_json::Value = serde_json::from_str(text).unwrap();
    let degrees = all[0]["angle_deg_md_vs_emd"].as_f64().unwrap();
    let made = make("mp13-6");
    let note = made.notes.iter().find(|note| note.what == "eMD against MD").unwrap();
    assert!(
        note.ours.ends_with(&format!("leave {degrees:.2}° from MD's direction")),
        "{}",
        note.ours
    );
    let [md, star] = ["MD, exact", "eMD*"].map(|name| series(&made, &format!("{name}, grain 1")));
    let last = md.x.len() - 1;
    assert!((md.x[last] - star.x[last]).hypot(md.y[last] - star.y[last]) < 1e-10);
}

/// ED at α = 2 is one completely inelastic bead, at every phase.
#[test]
fn l94_6a_hard_spheres_ride_as_one_bead() {
    let made = make("l94-6a");
    let (ed, bead) = (series(&made, "ED"), series(&made, "one inelastic bead"));
    assert!(ed.x.len() >= 10 * 48);
    for (phase, z) in ed.x.iter().zip(&ed.y) {
        let k = bead.x.iter().position(|x| (x - phase).abs() < 1e-9).unwrap();
        assert!((z - bead.y[k]).abs() < 1e-9, "at {phase}: {z} against {}", bead.y[k]);
    }
}
