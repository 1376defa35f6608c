//! Does a scenario's friction do what it says, and is it written down, kept and refused? Scenarios as text, against closed forms.

use carom_host::method;
use carom_host::report::write_frame;
use carom_host::run::Sample;
use carom_host::scenario::{MethodName, Scenario, Start};

const BALL: &str = "
dimension = 2
gravity = [0.0, -9.81]
duration = 1.0
sample = 0.1
inertia = 0.4
[box]
x = { kind = \"open\" }
y = { kind = \"plate\", at = 0.0, amplitude = 0.0, frequency = 1.0, surface = \"soft\" }
[law]
kind = \"constant\"
restitution = 0.5
[friction]
kind = \"walton\"
mu = 0.3
beta_0 = 0.2
[[grain]]
radius = 0.01
mass = 1.0
at = [0.0, 0.01]
moving = [1.0, 0.0]
rotating = [5.0]
";

fn scenario(text: &str) -> (Scenario, Start) {
    let scenario = Scenario::parse(text).unwrap();
    let start = Start::new(&scenario).unwrap();
    (scenario, start)
}

#[test]
fn a_ball_slides_then_rolls() {
    let (scenario, start) = scenario(BALL);
    assert_eq!(scenario.chosen_methods(), [MethodName::Emd]);
    let (speed, spin, energy) = method::with(MethodName::Emd, &scenario, &start, |method| {
        assert_eq!(method.rotations(), [[0.0, 0.0, 5.0]]);
        method.advance_to(1.0)?;
        let spin = method.rotations()[0][2];
        Ok((method.grains()[0].velocity[0], spin, method.rotational_energy()))
    })
    .unwrap();
    // v₀ = 1, ω₀ R = 0.05 the wrong way round: (5 v₀ − 2 ω₀ R)/7.
    assert!((speed - (5.0 - 2.0 * 0.05) / 7.0).abs() < 1e-3, "{speed}");
    assert!((spin * 0.01 + speed).abs() < 1e-3, "{spin}");
    assert!((energy / (0.2 * 1e-4 * spin * spin) - 1.0).abs() < 1e-12);
}

#[test]
fn a_saved_run_goes_on_with_the_same_bits() {
    let (scenario, start) = scenario(BALL);
    let name = MethodName::Emd;
    let (saved, whole) = method::with(name, &scenario, &start, |method| {
        method.advance_to(0.05)?;
        let saved = method.save()?.unwrap();
        method.advance_to(0.3)?;
        Ok((saved, (method.grains(), method.rotations())))
    })
    .unwrap();
    let again = method::with_state(name, &scenario, &start, Some(&saved), |method| {
        method.advance_to(0.3)?;
        Ok((method.grains(), method.rotations()))
    })
    .unwrap();
    assert_eq!(whole, again);
}

#[test]
fn frames_carry_angular_velocities_where_grains_rotate() {
    let text = |scenario_text: &str| {
        let (scenario, start) = scenario(scenario_text);
        method::with(MethodName::Emd, &scenario, &start, |method| {
            let mut frame = Vec::new();
            write_frame(&mut frame, &start, &Sample::take(method, 0.0))?;
            Ok(String::from_utf8(frame).unwrap())
        })
        .unwrap()
    };
    let rough = text(BALL);
    assert!(rough.contains("mass:R:1:angular_velocity:R:3 Time"), "{rough}");
    assert!(rough.ends_with(" 0.01 1.0 0.0 0.0 5.0\n"), "{rough}");
    let smooth = BALL
        .replace("rotating = [5.0]", "")
        .replace("[friction]\nkind = \"walton\"\nmu = 0.3\nbeta_0 = 0.2\n", "");
    assert!(!text(&smooth).contains("angular_velocity"));
}

#[test]
fn bad_friction_is_refused_by_name() {
    for (from, to, said) in [
        ("mu = 0.3", "mu = -0.3", "friction.mu is -0.3, must be between 0 and 16"),
        ("beta_0 = 0.2", "beta_0 = 1.5", "friction.beta_0 is 1.5, must be between -1 and 1"),
        ("inertia = 0.4", "inertia = 2.0", "inertia is 2, must be above 0 and at most 1"),
        ("rotating = [5.0]", "rotating = [1.0, 2.0]", "must have 1"),
        ("sample = 0.1", "sample = 0.1\nmethods = [\"md\"]", "MD needs"),
    ] {
        let text = BALL.replace(from, to);
        assert_ne!(text, BALL);
        let error = Scenario::parse(&text).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
    let spins_only = BALL.replace("[friction]\nkind = \"walton\"\nmu = 0.3\nbeta_0 = 0.2\n", "");
    let error = Scenario::parse(&spins_only).unwrap_err().to_string();
    assert!(error.contains("nothing has friction"), "{error}");
}

#[test]
fn measured_materials_are_shipped_as_scenarios_and_the_rough_lie_on_a_slope() {
    let acetate = include_str!("../scenarios/acetate.toml");
    assert!(Scenario::parse(include_str!("../scenarios/glass.toml")).is_ok());
    // Fewer beads, and for less long, than in the file.
    let text =
        acetate.replace("count = 200", "count = 60").replace("duration = 2.0", "duration = 0.8");
    let slope = |text: &str| {
        let (scenario, start) = scenario(text);
        let grains = method::with(MethodName::Emd, &scenario, &start, |method| {
            method.advance_to(0.8)?;
            Ok(method.grains())
        })
        .unwrap();
        let mean = grains.iter().map(|grain| grain.position[0]).sum::<f64>() / 60.0;
        let highest = grains.iter().map(|grain| grain.position[1]).fold(0.0, f64::max);
        (mean, highest)
    };
    let rough = slope(&text);
    let smooth = slope(&text.replace("friction = {", "# friction = {"));
    // Smooth beads spread over the floor.
    assert!(rough.0 < smooth.0 - 0.005 && rough.1 > smooth.1, "{rough:?} {smooth:?}");
}
