//! Does a scenario drive its grains as it says? Runs scenarios with `[[drive]]`; compares with closed forms, and after a restart.

use carom_host::columns::Cell;
use carom_host::observe::Recorder;
use carom_host::scenario::{MethodName, Placed, Scenario, Start, present};
use carom_host::{measure, method};

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

/// A grain that is taken out is gone for the others and for whoever measures; the rest keep their numbers.
#[test]
fn who_is_taken_out_is_gone_and_nobody_else_is() {
    let removed = |grain: usize, time: f64| {
        format!("[[drive]]\nkind = \"remove\"\ntime = {time:?}\ngrain = {grain}\n")
    };
    let text = boxed(&format!("{}{}", removed(7, 2.5), removed(50, 4.0)));
    let (before, after) = (grains_at(&text, 2.4, None), grains_at(&text, 9.0, None));
    assert_eq!(present(&before).count(), 60);
    let gone: Vec<usize> = (0..60).filter(|k| !after[*k].is_there()).collect();
    assert_eq!(gone, [7, 50]);
    let others = |k: &usize| !gone.contains(k);
    assert!((0..60).filter(others).all(|k| before[k].radius == after[k].radius));
    // In an elastic gas nobody else loses what they take with them.
    let energy = |grains: &[Placed]| {
        let square = |grain: &Placed| grain.velocity.iter().map(|v| v * v).sum::<f64>();
        present(grains).map(|(_, grain)| 0.5 * grain.mass * square(grain)).sum::<f64>()
    };
    let [one, two] = [(7, 2.5), (50, 4.0)].map(|(k, time)| {
        let at = grains_at(&text, time - 1e-9, None);
        energy(&at) - energy(&[&at[..k], &at[k + 1..]].concat())
    });
    assert!(((energy(&before) - one - two) / energy(&after) - 1.0).abs() < 1e-12);
    assert_eq!(grains_at(&text, 9.0, Some(3.1))[8], after[8]);
}

/// What is measured of a scenario.
fn measured(text: &str) -> Recorder {
    let scenario = Scenario::parse(text).unwrap();
    let start = Start::new(&scenario).unwrap();
    measure::run(MethodName::Emd, &scenario, &start).unwrap()
}

/// Between a hot wall and a cold one both bear the same force, and what one gives the other takes, but for what the gas
/// itself has gained, which falls as 1/t. Had grains been reflected, the cold wall would bear more, and neither take anything.
#[test]
fn thermal_walls_bear_what_their_grains_leave_with() {
    let wall = |side: &str, temperature: f64| {
        format!(
            "[[drive]]\nkind = \"thermal-wall\"\naxis = \"y\"\nside = \"{side}\"\ntemperature = {temperature:?}\n"
        )
    };
    let text = boxed(&format!(
        "{}{}[observe]\nfrom = 100.0\nevery = 1.0\n",
        wall("low", 9.0),
        wall("high", 1.0)
    ))
    .replace("duration = 10.0", "duration = 800.0");
    let recorder = measured(&text);
    let value = |name: &str, end: &str| {
        let of = format!("wall y {end}");
        let means = recorder.means();
        means
            .iter()
            .find(|(q, _)| q.name == name && q.of == of)
            .map(|(_, mean)| mean.value)
            .unwrap()
    };
    let [hot, cold] = ["from", "to"].map(|end| value("force", end));
    assert!((hot / cold - 1.0).abs() < 0.02, "{hot} and {cold}");
    let [given, taken] = ["from", "to"].map(|end| value("energy lost in contacts", end));
    assert!(given < -1.0 && (given / taken + 1.0).abs() < 0.03, "{given} and {taken}");
}

/// What is measured of a gas that loses half of its grains is what is measured of the half that stays.
#[test]
fn what_is_measured_counts_those_who_are_there() {
    let gone: String = (0..30)
        .map(|k| format!("[[drive]]\nkind = \"remove\"\ntime = 0.0\ngrain = {}\n", 2 * k))
        .collect();
    let observe = "[observe]\nfrom = 5.0\nevery = 0.5\n[observe.pair_distribution]\nto = 2.0\nbins = 1\none_in = 1\n";
    let text = boxed(&format!("{gone}{observe}"))
        .replace(
            "walls\", from = 0.0, to = 10.0, surface = \"hard\", restitution = 1.0",
            "periodic\", from = 0.0, to = 10.0",
        )
        .replace("duration = 10.0", "duration = 2000.0");
    let recorder = measured(&text);
    let mean = |name: &str| {
        let means = recorder.means();
        means.iter().find(|(q, _)| q.name == name).map(|(_, mean)| mean.value).unwrap()
    };
    // Thirty disks fill 0.085 of the box: Z = (1 + η²/8)/(1 − η)² (Henderson, Mol. Phys. 30, 971, 1975), less 1/N.
    let packing: f64 = 30.0 * std::f64::consts::PI * 0.09 / 100.0;
    let z = 1.0 + ((1.0 + packing * packing / 8.0) / (1.0 - packing).powi(2) - 1.0) * (29.0 / 30.0);
    assert!(
        (mean("compressibility factor") / z - 1.0).abs() < 0.02,
        "{}",
        mean("compressibility factor")
    );
    let tables = recorder.tables();
    let pairs = tables.iter().find(|table| table.name == "pair-distribution").unwrap();
    let Cell::Number(g) = pairs.rows[0][1] else { panic!("no g(r)") };
    // No pair within a diameter of 0.6, nearly as many as by chance beyond.
    assert!((g / (1.0 - 0.09) - 1.0).abs() < 0.1, "{g}");
}

/// A piston that comes on steadily: each hit gives a ball twice its speed, and slow compression heats a gas of
/// disks by V^(-2/D), as Boltzmann's does.
#[test]
fn walls_that_go_on_do_work() {
    let text = "dimension = 1\nduration = 1.0\nsample = 1.0\nmethods = [\"emd\"]\n\
        [law]\nkind = \"constant\"\nrestitution = 1.0\n\
        [box]\nx = { kind = \"walls\", from = 0.0, to = 9.0, restitution = 1.0, moving = [1.0, -0.5] }\n\
        [[grain]]\nradius = 0.5\nmass = 1.0\nat = [1.5]\n";
    // Hit at t = 1, it meets the other wall at 8.5 − t/2 = 1.5 + 2 (t − 1), t = 3.6, and flies back at 2 + 1.
    let grain =
        |time: f64| grains_at(&text.replace("duration = 1.0", "duration = 5.0"), time, None)[0];
    assert_eq!(grain(1.5).velocity[0], 2.0);
    assert_eq!(grain(4.0).velocity[0], -3.0);
    let gas = boxed("")
        .replace(
            "to = 10.0, surface = \"hard\", restitution = 1.0",
            "to = 10.0, restitution = 1.0, moving = [0.0, -0.001]",
        )
        .replace("radius = 0.3", "radius = 0.02")
        .replace("duration = 10.0", "duration = 5000.0");
    let heated =
        temperature(&grains_at(&gas, 5000.0, None)) / temperature(&grains_at(&gas, 0.0, None));
    // Half of the volume: T doubles in two dimensions; the disks' own size adds 1 %.
    assert!((heated / 2.0 - 1.0).abs() < 0.1, "{heated}");
    let said = |more: &str, less: &str| {
        format!("{:#}", Scenario::parse(&text.replace(more, less)).unwrap_err())
    };
    assert!(
        said("1.0, -0.5] }", "1.0, -9.0] }")
            .contains("the walls meet at t = 0.9 s, before duration")
    );
    assert!(
        said("-0.5] }", "-0.5], amplitude = 0.1, frequency = 1.0 }")
            .contains("and so is amplitude")
    );
    let md = text
        .replace("\"emd\"", "\"md\"")
        .replace("\"constant\"\nrestitution = 1.0", "\"lsd\"\nstiffness = 1e3\ndamping = 0.0");
    assert!(
        format!("{:#}", Scenario::parse(&md).unwrap_err()).contains("needs soft walls at rest")
    );
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
        (
            "kind = \"remove\"\ntime = 1.0\ngrain = 5\n[[drive]]\nkind = \"kick\"\ntime = 2.0\ngrain = 5\nby = [1.0, 0.0]",
            "drive 1: grain is 5, which is taken out before",
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
