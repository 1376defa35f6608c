//! Are grains read from files as they were written? Writes to temporary folders.

use super::{filled_box, started};
use carom_host::report::write_frame;
use carom_host::scenario::{MethodName, Placed, Scenario, Side, Start};
use carom_host::{method, run};

/// What is written in one of three ways is read as it was: places, velocities, radii, masses, to the last bit.
#[test]
fn grains_are_read_from_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let made = started(&filled_box(
        2,
        0.2,
        "count = 20\nradius = { uniform = [0.01, 0.02] }\ntemperature = 1.0",
    ));
    let row = |g: &Placed, between: &str| {
        let numbers =
            [g.position[0], g.position[1], g.velocity[0], g.velocity[1], g.radius, g.mass];
        numbers.map(|x| format!("{x:?}")).join(between)
    };
    let csv: String = made.grains.iter().map(|g| format!("{},1\n", row(g, ","))).collect();
    let old = "0,0,0,0,1,1,0\n";
    std::fs::write(folder.path().join("a.csv"), format!("x,y,vx,vy,radius,mass,frame\n{old}{csv}"))
        .expect("written");
    let xyz: String = made.grains.iter().map(|g| format!("A {}\n", row(g, " "))).collect();
    let head = "Properties=species:S:1:pos:R:2:velo:R:2:radius:R:1:mass:R:1 Time=1.0";
    std::fs::write(
        folder.path().join("a.xyz"),
        format!("1\n{head}\nB 0 0 0 0 1 1\n20\n{head}\n{xyz}"),
    )
    .expect("written");
    for (file, rest) in [("a.csv", ""), ("a.xyz", ""), ("a.xyz", ", only = \"A\"")] {
        let text = format!(
            "dimension = 2\nduration = 1.0\nsample = 0.1\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
             [[species]]\nplace = {{ kind = \"file\", path = \"{file}\"{rest} }}\n"
        );
        let scenario = Scenario::parse_in(&text, folder.path()).expect("a good scenario");
        let read = Start::new(&scenario).expect("readable");
        assert_eq!(read.grains, made.grains, "{file}");
        let first =
            Scenario::parse_in(&text.replace(" }", ", frame = 0 }"), folder.path()).expect("good");
        match rest {
            "" => assert_eq!(Start::new(&first).expect("readable").grains.len(), 1),
            _ => assert!(
                format!("{:#}", Start::new(&first).expect_err("none"))
                    .contains("there is no grain")
            ),
        }
    }
    for (from, to, wanted) in [
        ("a.csv", "b.csv", "b.csv: "),
        ("a.csv", "a.txt", "its name must end in .xyz, .csv or .parquet"),
        (" }", ", frame = 7 }", "there is no frame 7, the last one is 1"),
    ] {
        let text = "dimension = 2\nduration = 1.0\nsample = 0.1\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
                    [[species]]\nplace = { kind = \"file\", path = \"a.csv\" }\n".replacen(from, to, 1);
        let scenario = Scenario::parse_in(&text, folder.path()).expect("a good scenario");
        let error = format!("{:#}", Start::new(&scenario).expect_err("it cannot be read"));
        assert!(error.contains(wanted) && error.starts_with("species 0: place: "), "{error}");
    }
}

/// What a run writes is read back by species: all grains of both frames, as they were.
#[test]
fn what_a_run_wrote_is_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = filled_box(
        2,
        0.3,
        "name = \"large ones\"\ncount = 10\nradius = 0.02\ntemperature = 1.0\n\
         [[species]]\nname = \"small\"\ndensity = 2.0\ncount = 20\nradius = 0.01\ntemperature = 1.0",
    );
    let scenario = Scenario::parse(&text).expect("a good scenario");
    let start = Start::new(&scenario).expect("a place for all");
    let mut file = Vec::new();
    let mut last = Vec::new();
    method::with(MethodName::Emd, &scenario, &start, |method| {
        let plan = run::Plan::new(&scenario);
        run::drive(method, &plan, |sample| {
            last = sample.grains.clone();
            write_frame(&mut file, &start, sample)
        })
    })
    .expect("a run");
    std::fs::write(folder.path().join("emd.xyz"), file).expect("written");
    let Side::Periodic([from, to]) = start.sides[0] else { panic!("not periodic") };
    let sides: String = ["x", "y"]
        .map(|x| format!("{x} = {{ kind = \"periodic\", from = {from:?}, to = {to:?} }}\n"))
        .concat();
    let species = |name: &str| {
        format!(
            "[[species]]\nname = \"{name}\"\nplace = {{ kind = \"file\", path = \"emd.xyz\", only = \"{name}\" }}\n"
        )
    };
    let again = format!(
        "dimension = 2\nduration = 1.0\nsample = 0.1\n[box]\n{sides}[law]\nkind = \"constant\"\nrestitution = 1.0\n{}{}",
        species("large ones"),
        species("small")
    );
    let scenario = Scenario::parse_in(&again, folder.path()).expect("a good scenario");
    let read = Start::new(&scenario).expect("readable");
    assert_eq!(read.grains, last);
    assert_eq!(read.species_names, start.species_names);
    // It can be run.
    method::with(MethodName::Emd, &scenario, &read, |method| method.advance_to(0.1))
        .expect("a run");
}
