//! Does a scenario drive its grains as it says? Runs scenarios with `[[drive]]`; compares with closed forms, and after a restart.

use carom_host::method;
use carom_host::scenario::{MethodName, Placed, Scenario, Start};

/// A box of 60 elastic disks between hard walls, and what drives them.
fn boxed(drive: &str) -> String {
    format!(
        "dimension = 2\nduration = 10.0\nsample = 1.0\nmethods = [\"emd\"]\n\
        [box]\nx = {{ kind = \"periodic\", from = 0.0, to = 10.0 }}\n\
        y = {{ kind = \"walls\", from = 0.0, to = 10.0, surface = \"hard\", restitution = 1.0 }}\n\
        [[material]]\nname = \"steel\"\ndensity = 1.0\nrestitution = 1.0\n\
        [[species]]\ncount = 60\nradius = 0.3\ntemperature = 0.01\n{drive}"
    )
}

/// The grains at a time; the state is saved and restored on the way if that is said.
fn grains_at(text: &str, time: f64, restart: Option<f64>) -> Vec<Placed> {
    let scenario = Scenario::parse(text).expect("a good scenario");
    let start = Start::new(&scenario).expect("a place for every grain");
    let saved = restart.map(|before| {
        let save = method::with(MethodName::Emd, &scenario, &start, |method| {
            method.advance_to(before)?;
            method.save()
        });
        save.unwrap().expect("event-driven methods can be saved")
    });
    let end = method::with_state(MethodName::Emd, &scenario, &start, saved.as_deref(), |method| {
        method.advance_to(time)?;
        Ok(method.grains())
    });
    end.unwrap()
}

fn temperature(grains: &[Placed]) -> f64 {
    let square =
        |grain: &Placed| grain.mass * (grain.velocity[0].powi(2) + grain.velocity[1].powi(2));
    grains.iter().map(square).sum::<f64>() / (2.0 * grains.len() as f64)
}

/// A cold gas between a wall of k T = 1 and one that only reflects takes that temperature.
#[test]
fn a_thermal_wall_heats_a_gas_to_its_temperature() {
    let text = boxed(
        "[[drive]]\nkind = \"thermal-wall\"\naxis = \"y\"\nside = \"high\"\ntemperature = 1.0\n",
    );
    let times = (0..100).map(|k| 500.0 + 40.0 * f64::from(k));
    let scenario = Scenario::parse(&text).unwrap();
    let start = Start::new(&scenario).unwrap();
    let mean = method::with(MethodName::Emd, &scenario, &start, |method| {
        let mut sum = 0.0;
        for time in times {
            method.advance_to(time)?;
            sum += temperature(&method.grains());
        }
        Ok(sum / 100.0)
    });
    // 100 values, each with a deviation of √(2/120): a standard error of 1.3 % if they were independent.
    assert!((mean.as_ref().unwrap() - 1.0).abs() < 0.05, "{mean:?}");
}

/// A run that was saved and restored goes on with the same bits, whatever drives it.
#[test]
fn a_driven_scenario_goes_on_with_the_same_bits() {
    let all = "[[drive]]\nkind = \"thermal-wall\"\naxis = \"y\"\ntemperature = 1.0\n\
        [[drive]]\nkind = \"andersen\"\ntemperature = 0.5\nrate = 0.1\n\
        [[drive]]\nkind = \"white-noise\"\nstrength = 0.1\ninterval = 0.5\n\
        [[drive]]\nkind = \"turning-gravity\"\nmagnitude = 0.1\naxes = [\"x\", \"y\"]\nperiod = 7.0\nsteps = 20\n\
        [[drive]]\nkind = \"kick\"\ntime = 6.1\ngrain = 3\nby = [1.0, 0.5]\n";
    let text = boxed(all);
    let whole = grains_at(&text, 10.0, None);
    assert_eq!(grains_at(&text, 10.0, Some(5.3)), whole);
    assert!(temperature(&whole) > 0.1, "{}", temperature(&whole));
}

/// Gravity by a table, and one grain that gets a velocity: v = Σ g Δt.
#[test]
fn a_grain_flies_as_its_scenario_says() {
    let text = "dimension = 2\nduration = 4.0\nsample = 1.0\nmethods = [\"emd\"]\n\
        [law]\nkind = \"constant\"\nrestitution = 1.0\n\
        [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0, 0.0]\n\
        [[drive]]\nkind = \"gravity-table\"\nrows = [[0.0, 0.0, -1.0], [2.0, 2.0, 0.0]]\n\
        [[drive]]\nkind = \"set-velocity\"\ntime = 1.0\ngrain = 0\nto = [0.5, 0.0]\n";
    let grain = grains_at(text, 4.0, None)[0];
    assert!((grain.velocity[0] - 4.5).abs() < 1e-13 && (grain.velocity[1] + 1.0).abs() < 1e-13);
    assert!((grain.position[0] - (0.5 * 3.0 + 4.0)).abs() < 1e-13, "{grain:?}");
    assert!((grain.position[1] - (-0.5 - 0.5 - 2.0)).abs() < 1e-13, "{grain:?}");
}

#[test]
fn what_cannot_drive_is_refused_and_named() {
    let said = |drive: &str| format!("{:#}", Scenario::parse(&boxed(drive)).unwrap_err());
    let drive = |rest: &str| said(&format!("[[drive]]\n{rest}"));
    for (rest, wanted) in [
        ("kind = \"thermal-wall\"\naxis = \"x\"\ntemperature = 1.0", "box.x has no lower wall"),
        ("kind = \"thermal-wall\"\naxis = \"z\"\ntemperature = 1.0", "box.z has no lower wall"),
        ("kind = \"thermal-wall\"\naxis = \"y\"\ntemperature = 0.0", "drive 0: temperature is 0"),
        ("kind = \"andersen\"\ntemperature = 1.0\nrate = -1.0", "drive 0: rate is -1"),
        ("kind = \"white-noise\"\nstrength = 1.0\ninterval = 0.0", "drive 0: interval is 0"),
        (
            "kind = \"gravity-table\"\nrows = [[1.0, 2.0]]",
            "drive 0: rows has a row of 2, must have 3",
        ),
        ("kind = \"gravity-table\"\nrows = []", "drive 0: rows must have times that grow"),
        ("kind = \"kick\"\ntime = 1.0\ngrain = 0\nby = [1.0]", "drive 0: by has 1 numbers"),
        (
            "kind = \"turning-gravity\"\nmagnitude = 1.0\naxes = [\"x\", \"z\"]\nperiod = 1.0",
            "drive 0: axes must be two of the 2 axes",
        ),
        ("kind = \"thermal\"", "thermal"),
    ] {
        assert!(drive(rest).contains(wanted), "{:?} for {wanted:?}", drive(rest));
    }
    let soft = boxed("[[drive]]\nkind = \"thermal-wall\"\naxis = \"y\"\ntemperature = 1.0\n")
        .replace("\"hard\", restitution = 1.0", "\"soft\"");
    let said = format!("{:#}", Scenario::parse(&soft).unwrap_err());
    assert!(said.contains("a thermal one must be hard"), "{said}");
    let md = boxed("[[drive]]\nkind = \"andersen\"\ntemperature = 1.0\nrate = 1.0\n")
        .replace("methods = [\"emd\"]", "methods = [\"md\"]")
        .replace(
            "restitution = 1.0\n[[species]]",
            "law = { kind = \"lsd\", stiffness = 1e3, damping = 0.0 }\n[[species]]",
        )
        .replace("\"hard\", restitution = 1.0", "\"soft\"");
    let said = format!("{:#}", Scenario::parse(&md).unwrap_err());
    assert!(said.contains("nothing drives"), "{said}");
    // Who there is, is known when all have been placed.
    let nobody = boxed("[[drive]]\nkind = \"kick\"\ntime = 1.0\ngrain = 60\nby = [1.0, 0.0]\n");
    let scenario = Scenario::parse(&nobody).unwrap();
    let start = Start::new(&scenario).unwrap();
    let said = method::with(MethodName::Emd, &scenario, &start, |_| Ok(())).unwrap_err();
    assert!(format!("{said:#}").contains("there is no grain 60"), "{said:#}");
}
