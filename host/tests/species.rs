//! Are materials, species and their placement what a scenario says? Reads scenarios as text; writes nothing.

use carom_host::report::write_frame;
use carom_host::scenario::{MethodName, Placed, Scenario, Side, Start, examine, touching};
use carom_host::{method, run};
use std::f64::consts::PI;
use std::path::Path;

fn started(text: &str) -> Start {
    let scenario = Scenario::parse(text).expect("a good scenario");
    Start::new(&scenario).expect("a place for every grain")
}

fn refused(text: &str) -> String {
    let scenario = match Scenario::parse(text) {
        Err(error) => return format!("{error:#}"),
        Ok(scenario) => scenario,
    };
    format!("{:#}", Start::new(&scenario).expect_err("it cannot be placed"))
}

/// The smallest gap of any two grains and of any grain and wall, over the radius: each pair is looked at.
fn smallest_gap(start: &Start) -> f64 {
    let mut smallest = f64::INFINITY;
    for (i, a) in start.grains.iter().enumerate() {
        for b in &start.grains[..i] {
            let apart = start.nearest(&a.position, &b.position);
            let distance = apart.iter().map(|x| x * x).sum::<f64>().sqrt();
            smallest = smallest.min((distance - a.radius - b.radius) / a.radius);
        }
        for (side, x) in start.sides.iter().zip(a.position) {
            let gap = match *side {
                Side::Walls([from, to], ..) => (x - from).min(to - x),
                Side::Plate(plate, _) => x - plate.at - plate.amplitude,
                _ => continue,
            };
            smallest = smallest.min(gap / a.radius - 1.0);
        }
    }
    smallest
}

fn packing(start: &Start) -> f64 {
    let d = start.dimension;
    let volume: f64 =
        start.sides[..d].iter().filter_map(Side::range).map(|[from, to]| to - from).product();
    let filled = |grain: &Placed| match d {
        1 => 2.0 * grain.radius,
        2 => PI * grain.radius.powi(2),
        _ => 4.0 / 3.0 * PI * grain.radius.powi(3),
    };
    start.grains.iter().map(filled).sum::<f64>() / volume
}

/// T = ⟨m v²⟩/D of the grains of a species.
fn temperature(start: &Start, species: u16) -> f64 {
    let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
    let squares: Vec<f64> =
        of.map(|(g, _)| g.mass * g.velocity.iter().map(|v| v * v).sum::<f64>()).collect();
    squares.iter().sum::<f64>() / (squares.len() * start.dimension) as f64
}

const PERIODIC: [&str; 3] = [
    "dimension = 1\n[box]\nx = { kind = \"periodic\" }\n",
    "dimension = 2\n[box]\nx = { kind = \"periodic\" }\ny = { kind = \"periodic\" }\n",
    "dimension = 3\n[box]\nx = { kind = \"periodic\" }\ny = { kind = \"periodic\" }\nz = { kind = \"periodic\" }\n",
];

/// A periodic box of one species at a packing fraction.
fn filled_box(dimension: usize, packing: f64, species: &str) -> String {
    format!(
        "duration = 1.0\nsample = 0.1\n{}packing_fraction = {packing}\n\
         [law]\nkind = \"constant\"\nrestitution = 1.0\n[[species]]\ndensity = 1.0\n{species}\n",
        PERIODIC[dimension - 1]
    )
}

/// Both ways of filling, in all dimensions: the packing fraction is what was asked, and nothing overlaps.
#[test]
fn a_box_is_filled_to_its_packing_fraction_without_overlap() {
    for (dimension, phi) in
        [(1, 0.4), (1, 0.9), (2, 0.4), (2, 0.6), (2, 0.8), (3, 0.25), (3, 0.5), (3, 0.6)]
    {
        let start = started(&filled_box(dimension, phi, "count = 300\nradius = 0.01"));
        assert_eq!(start.grains.len(), 300);
        assert!((packing(&start) - phi).abs() < 1e-9, "{dimension} D: {}", packing(&start));
        let gap = smallest_gap(&start);
        assert!(gap >= 0.0, "{dimension} D at {phi}: {gap}");
        // At random, not on a lattice: x of the grains takes no value twice.
        let mut x: Vec<f64> = start.grains.iter().map(|grain| grain.position[0]).collect();
        x.sort_by(f64::total_cmp);
        assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

/// Sizes that differ by ten, walls all round, and a grain in the middle that stays where it was put.
#[test]
fn grains_of_two_sizes_are_pressed_between_walls_around_another() {
    let wall = "{ kind = \"walls\", from = 0.0, to = 1.0, surface = \"soft\" }";
    let text = format!(
        "dimension = 2\nduration = 1.0\nsample = 0.1\n[box]\nx = {wall}\ny = {wall}\n\
         [law]\nkind = \"lsd\"\nstiffness = 1e4\ndamping = 0.0\n\
         [[grain]]\nradius = 0.1\ndensity = 1.0\nat = [0.5, 0.5]\n\
         [[species]]\nname = \"large\"\npacking_fraction = 0.3\nradius = 0.05\ndensity = 1.0\n\
         [[species]]\nname = \"small\"\npacking_fraction = 0.4\nradius = {{ uniform = [0.01, 0.02] }}\ndensity = 1.0\n"
    );
    let start = started(&text);
    assert!(smallest_gap(&start) >= 0.0, "{}", smallest_gap(&start));
    assert_eq!(start.grains[0].position, [0.5, 0.5, 0.0]);
    assert_eq!(start.species_names, ["grain", "large", "small"]);
    for (species, wanted, radius) in [(1, 0.3, 0.05), (2, 0.4, 0.02)] {
        let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
        let area: f64 = of.map(|(grain, _)| PI * grain.radius.powi(2)).sum();
        assert!((area - wanted).abs() <= PI * radius * radius, "species {species} fills {area}");
    }
}

/// The mean of a Gaussian is met within four standard errors, a list is kept in its proportions.
#[test]
fn radii_are_distributed_as_said() {
    let start =
        started(&filled_box(3, 0.1, "count = 2000\nradius = { mean = 0.01, deviation = 0.001 }"));
    let radii: Vec<f64> = start.grains.iter().map(|grain| grain.radius).collect();
    let mean = radii.iter().sum::<f64>() / 2000.0;
    let variance = radii.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / 2000.0;
    assert!((mean - 0.01).abs() < 4.0 * 0.001 / 2000f64.sqrt(), "mean {mean}");
    // A normal variable cut at three standard deviations has 0.9733 of the variance.
    assert!((variance / 0.9733e-6 - 1.0).abs() < 4.0 * (2f64 / 2000.0).sqrt(), "{variance}");
    assert!(radii.iter().all(|r| (0.007..=0.013).contains(r)));

    let start = started(&filled_box(2, 0.1, "count = 9\nradius = { list = [0.01, 0.02, 0.03] }"));
    for wanted in [0.01, 0.02, 0.03] {
        assert_eq!(start.grains.iter().filter(|grain| grain.radius == wanted).count(), 3);
    }
}

/// T, drift and momentum are exact, by species, whatever the masses are.
#[test]
fn temperatures_are_exact() {
    let text = filled_box(
        3,
        0.1,
        "count = 50\nradius = { uniform = [0.01, 0.02] }\ntemperature = 3.5\nmoving = [1.0, 0.0, 0.0]\n\
         [[species]]\ncount = 40\nradius = 0.01\ndensity = 7.0\nthermal_speed = 2.0\n\
         [[species]]\ncount = 3\nradius = 0.01\ndensity = 7.0",
    );
    let mut start = started(&text);
    for grain in &mut start.grains[..50] {
        grain.velocity[0] -= 1.0;
    }
    assert!((temperature(&start, 0) / 3.5 - 1.0).abs() < 1e-12);
    let mass = start.grains[50].mass;
    assert!((temperature(&start, 1) / (0.5 * mass * 4.0) - 1.0).abs() < 1e-12);
    assert_eq!(temperature(&start, 2), 0.0);
    for range in [0..50, 50..90] {
        for axis in 0..3 {
            let momentum: f64 =
                start.grains[range.clone()].iter().map(|g| g.mass * g.velocity[axis]).sum();
            assert!(momentum.abs() < 1e-12, "momentum {momentum}");
        }
    }
}

/// A plate leaves the height open: the grains lie between it and where the packing fraction says.
#[test]
fn a_gas_over_a_plate_has_a_place() {
    let text = |packing: &str| {
        format!(
            "dimension = 2\ngravity = [0.0, -9.81]\nduration = 1.0\nsample = 0.1\n[box]\n\
             x = {{ kind = \"periodic\", from = 0.0, to = 1.0 }}\n\
             y = {{ kind = \"plate\", at = 0.5, amplitude = 0.1, frequency = 1.0, surface = \"soft\" }}\n\
             [law]\nkind = \"constant\"\nrestitution = 0.9\n\
             [gas]\ncount = 100\nradius = 0.01\ndensity = 1.0\nthermal_speed = 1.0\nseed = 1\n{packing}\n"
        )
    };
    for (packing, phi) in [("", 0.2), ("packing_fraction = 0.05", 0.05)] {
        let start = started(&text(packing));
        assert!(smallest_gap(&start) >= 0.0);
        let top = 0.6 + 100.0 * PI * 1e-4 / phi;
        assert!(start.grains.iter().all(|grain| grain.position[1] + 0.01 <= top));
        // Of 100 grains one is in the uppermost tenth but for one case in 37,000.
        assert!(start.grains.iter().any(|grain| grain.position[1] > 0.6 + 0.9 * (top - 0.6)));
    }
}

const TWO_MATERIALS: &str = "dimension = 1\nduration = 1.0\nsample = 1.0\nmethods = [\"emd\"]\n\
    [[material]]\nname = \"steel\"\ndensity = 7800.0\nrestitution = 0.9\n\
    [[material]]\nname = \"clay\"\ndensity = 2000.0\nrestitution = 0.1\n\
    [[pair]]\nbetween = [\"clay\", \"steel\"]\nrestitution = 0.5\n\
    [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\nmoving = [1.0]\nmaterial = \"A\"\n\
    [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5]\nmaterial = \"B\"\n";

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

#[test]
fn what_cannot_be_is_named() {
    let materials = |from: &str, to: &str| {
        TWO_MATERIALS
            .replace("\"A\"", "\"steel\"")
            .replace("\"B\"", "\"clay\"")
            .replacen(from, to, 1)
    };
    let species = |from: &str, to: &str| {
        filled_box(3, 0.5, "count = 50\nradius = 0.01").replacen(from, to, 1)
    };
    for (text, wanted) in [
        (
            materials("material = \"clay\"", "material = \"glass\""),
            "grain 1: material is \"glass\", which no [[material]] defines",
        ),
        (
            materials("[\"clay\", \"steel\"]", "[\"clay\", \"steal\"]"),
            "pair 0: between is \"steal\", which no [[material]] defines; the nearest is `steel`",
        ),
        (
            materials("[[pair]]\nbetween = [\"clay\", \"steel\"]\nrestitution = 0.5\n", ""),
            "\"steel\" and \"clay\" can touch, but have no law",
        ),
        (materials("density = 2000.0\nrestitution = 0.1", ""), "material \"clay\" has no law"),
        (
            materials("restitution = 0.9", "restitution = 1.9"),
            "line 8: material 0: restitution is 1.9, must be from 0 to 1",
        ),
        (
            materials("name = \"clay\"", "name = \"steel\""),
            "material 1: name is \"steel\", which another material is called too",
        ),
        (
            materials("material = \"clay\"", ""),
            "grain 1: material is missing, must be steel or clay",
        ),
        (
            species("packing_fraction = 0.5", "packing_fraction = 0.75"),
            "species 0: a packing fraction of 0.7500 cannot be reached, at most 0.7405",
        ),
        (
            species("packing_fraction = 0.5", "packing_fraction = 0.71"),
            "cannot be reached: compressed at random, these grains jam at 0.6",
        ),
        (
            species("count = 50", "count = 3000000000"),
            "species 0: count is 3000000000: so many grains need",
        ),
        (
            species("count = 50", "cuont = 50"),
            "species 0: unknown field `cuont`; the nearest is `count`",
        ),
        (
            species("radius = 0.01", "radius = { mean = 0.01, deviation = 0.004 }"),
            "species 0: radius.deviation is 0.004, must be at least 0 and less than a third of mean",
        ),
        (species("radius = 0.01", "radius = { list = [0.01, -1.0] }"), "radius.list 1 is -1"),
        (species("density = 1.0", ""), "species 0: density is missing, and its material has none"),
        (
            species("count = 50", "count = 50\npacking_fraction = 0.2"),
            "species 0: packing_fraction is given, and so is count",
        ),
        (
            species("restitution = 1.0", "restitution = 1.0\nrestitution = 1.0"),
            "duplicate key `restitution`",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(wanted), "{wanted:?}: {error:?}");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}

/// Everything at once, each with line and column.
#[test]
fn all_that_is_wrong_is_said_at_once() {
    let text = "dimension = 2\nduration = 1.0\nsample = -1.0\ngravity = [0.0]\n\
                [law]\nkind = \"lsd\"\nstiffness = 0.0\ndamping = nan\n\
                [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0, inf]\n";
    let (scenario, found) = examine(text, Path::new(""));
    assert!(scenario.is_none());
    let places: Vec<(usize, usize)> = found.iter().map(|(place, _)| *place).collect();
    assert_eq!(places, [(3, 1), (4, 1), (7, 1), (8, 1), (12, 1)], "{found:?}");
    let (_, found) = examine("a = 1\nb = \nc = 3\na = 2\n", Path::new(""));
    assert!(
        found
            .iter()
            .any(|((line, _), problem)| *line == 4 && problem.message == "duplicate key `a`"),
        "{found:?}"
    );
    assert!(found.iter().any(|((line, _), _)| *line == 2), "{found:?}");
}

/// 10,000 equal spheres at 0.62. In release under a minute on one core:
/// `cargo test --release -p carom-host --test species -- --ignored`
#[test]
#[ignore = "takes a minute without optimisation"]
fn ten_thousand_spheres_are_packed_to_0_62() {
    let start = started(&filled_box(3, 0.62, "count = 10000\nradius = 0.01"));
    assert!((packing(&start) - 0.62).abs() < 1e-9);
    assert!(!touching(&start, &start.grains).contains(&true));
}

const BOX_ON_A_FLOOR: &str = "dimension = 2\ngravity = [0.0, -9.81]\nduration = 1.0\nsample = 0.1\n[box]\n\
    x = { kind = \"walls\", from = 0.0, to = 1.0, surface = \"soft\" }\n\
    y = { kind = \"plate\", at = 0.0, surface = \"soft\" }\n\
    [law]\nkind = \"constant\"\nrestitution = 0.9\n";

/// As many sites as grains, all different, as far apart as the lattice is: a closed form for each.
#[test]
fn lattices_have_the_spacing_of_their_density() {
    // Cells of the close lattices hold 2 and 4; so many fill the box exactly.
    for (dimension, kind, count, spacing) in [
        (1, "close", 10, 0.1),
        (2, "cubic", 100, 0.1),
        (3, "cubic", 125, 0.2),
        (3, "close", 108, 1.0 / 3.0 / 2f64.sqrt()),
    ] {
        let side = "{ kind = \"periodic\", from = 0.0, to = 1.0 }";
        let axes: String =
            ["x", "y", "z"][..dimension].iter().map(|x| format!("{x} = {side}\n")).collect();
        let text = format!(
            "dimension = {dimension}\nduration = 1.0\nsample = 0.1\n[box]\n{axes}\
             [law]\nkind = \"constant\"\nrestitution = 1.0\n[[species]]\ndensity = 1.0\ncount = {count}\n\
             radius = 0.01\nplace = {{ kind = \"lattice\", lattice = \"{kind}\" }}\n"
        );
        let start = started(&text);
        assert_eq!(start.grains.len(), count);
        for a in &start.grains {
            let mut apart: Vec<f64> = start
                .grains
                .iter()
                .map(|b| {
                    start
                        .nearest(&a.position, &b.position)
                        .iter()
                        .map(|x| x * x)
                        .sum::<f64>()
                        .sqrt()
                })
                .collect();
            apart.sort_by(f64::total_cmp);
            assert!((apart[1] / spacing - 1.0).abs() < 1e-9, "{dimension} D {kind}: {}", apart[1]);
        }
        // One grain less leaves one site empty, and the others where they are.
        let one_less =
            started(&text.replace(&format!("count = {count}"), &format!("count = {}", count - 1)));
        assert_eq!(one_less.grains.len(), count - 1);
        assert!(smallest_gap(&one_less) >= 0.0);
    }
}

/// Rows from the floor up, mixed, none overlapping, all within the walls; what was there is left in peace.
#[test]
fn a_layer_lies_on_its_floor() {
    let text = format!(
        "{BOX_ON_A_FLOOR}[[grain]]\nradius = 0.1\ndensity = 1.0\nat = [0.5, 0.1]\n\
         [[species]]\nname = \"large\"\ndensity = 1.0\ncount = 150\nradius = 0.01\nplace = {{ kind = \"layer\" }}\n\
         [[species]]\nname = \"small\"\ndensity = 1.0\ncount = 150\nradius = 0.006\nplace = {{ kind = \"layer\" }}\n"
    );
    let start = started(&text);
    assert_eq!(start.grains.len(), 301);
    assert!(smallest_gap(&start) >= 0.0, "{}", smallest_gap(&start));
    let height = |species: u16| {
        let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
        let heights: Vec<f64> = of.map(|(grain, _)| grain.position[1]).collect();
        heights.iter().sum::<f64>() / heights.len() as f64
    };
    // Mixed: both lie equally high on average, within four standard errors of places drawn without order.
    let spread = start.grains.iter().map(|g| g.position[1]).fold(0.0, f64::max) / 12f64.sqrt();
    assert!((height(1) - height(2)).abs() < 4.0 * spread * (2.0 / 150f64).sqrt());
    let lowest = start.grains[1..].iter().map(|g| g.position[1]).fold(f64::INFINITY, f64::min);
    assert!(lowest < 0.011, "the lowest is at {lowest}");
}

/// A heap of touching grains on the floor: its middle is where it should be, and its height that of its rows.
#[test]
fn a_pile_is_a_heap_on_the_floor() {
    let text = format!(
        "{BOX_ON_A_FLOOR}[[species]]\ndensity = 1.0\ncount = 55\nradius = 0.01\nplace = {{ kind = \"pile\", at = [0.3, 0.0] }}\n"
    );
    let start = started(&text);
    let top = start.grains.iter().map(|g| g.position[1]).fold(0.0, f64::max);
    assert!((top - (0.01 + 9.0 * 0.01 * 3f64.sqrt())).abs() < 1e-8, "{top}");
    let middle = start.grains.iter().map(|g| g.position[0]).sum::<f64>() / 55.0;
    assert!((middle - 0.3).abs() < 1e-12, "{middle}");
    let gap = smallest_gap(&start);
    assert!((0.0..1e-8).contains(&gap), "{gap}");
    let wide = refused(&text.replace("count = 55", "count = 5000"));
    assert!(wide.contains("do not fit along x"), "{wide}");
}

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
