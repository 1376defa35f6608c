//! Is what obstacles feel what grains lose? Runs grains in drums and cups; compares momentum, angular momentum and weight.

use carom_host::observe::Recorder;
use carom_host::scenario::{MethodName, Scenario, Start};
use carom_host::{measure, method};

const DURATION: f64 = 3.0;
/// I/(m R²).
const INERTIA: f64 = 0.5;
const RADIUS: f64 = 0.1;
const CENTRE: [f64; 2] = [0.3, -0.2];

/// Hard disks under Walton's rule, and soft ones with springs across.
const RULES: [&str; 2] = [
    "[law]\nkind = \"constant\"\nrestitution = 0.8\n[friction]\nkind = \"walton\"\nmu = 0.5\nbeta_0 = 0.3\n",
    "[law]\nkind = \"lsd\"\nstiffness = 1e4\ndamping = 2.0\n\
     [friction]\nkind = \"spring\"\nmu = 0.5\nstiffness = 4e3\n",
];

/// Disks in a drum of eight sides that turns.
fn drum(rule: &str, disks: u32) -> String {
    let corner = |k: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 8.0).sin_cos();
        format!("[{}, {}]", CENTRE[0] + cos, CENTRE[1] + sin)
    };
    let corners: Vec<String> = (0..8).map(corner).collect();
    let mut text = format!(
        "dimension = 2\nduration = {DURATION}\nsample = 0.1\ninertia = {INERTIA}\n{rule}[observe]\n\
         [[obstacle]]\npolygon = [{}]\nrotation = {{ centre = {CENTRE:?}, angular_velocity = [1.5] }}\n",
        corners.join(", ")
    );
    for k in 0..disks {
        let (sin, cos) = f64::from(k).sin_cos();
        let at = [CENTRE[0] + 0.5 * cos, CENTRE[1] + 0.5 * sin];
        text.push_str(&format!(
            "[[grain]]\nradius = {RADIUS}\nmass = 1.5\nat = {at:?}\nmoving = [{sin}, 0.4]\nrotating = [{cos}]\n"
        ));
    }
    text
}

/// What was measured; and momentum, angular momentum about the centre and energy, as they were and as they are in the end.
struct Measured {
    recorder: Recorder,
    momenta: [[f64; 3]; 2],
    energies: [f64; 2],
}

fn momenta(method: &dyn method::Method) -> [f64; 3] {
    let spins = method.rotations().into_iter().chain(std::iter::repeat([0.0; 3]));
    method.grains().iter().zip(spins).fold([0.0; 3], |[x, y, turn], (grain, spin)| {
        let [u, v] = [0, 1].map(|k| grain.mass * grain.velocity[k]);
        let arm = [0, 1].map(|k| grain.position[k] - CENTRE[k]);
        let own = INERTIA * grain.mass * grain.radius * grain.radius * spin[2];
        [x + u, y + v, turn + arm[0] * v - arm[1] * u + own]
    })
}

fn energy(method: &dyn method::Method) -> f64 {
    method.kinetic_energy() + method.rotational_energy()
}

impl Measured {
    fn of(text: &str) -> Self {
        let scenario = Scenario::parse(text).unwrap();
        let start = Start::new(&scenario).unwrap();
        let name = if text.contains("lsd") { MethodName::EmdStar } else { MethodName::Emd };
        method::with(name, &scenario, &start, |method| {
            let (before, energy) = (momenta(method), energy(method));
            let recorder = measure::attend(method, &scenario, &start)?;
            let energies = [energy, self::energy(method)];
            Ok(Self { recorder, momenta: [before, momenta(method)], energies })
        })
        .unwrap()
    }

    fn value(&self, name: &str, of: &str) -> f64 {
        let means = self.recorder.means();
        let found = means.iter().find(|(quantity, _)| quantity.name == name && quantity.of == of);
        found.unwrap_or_else(|| panic!("no {name} of {of}")).1.value
    }
}

#[test]
fn a_drum_gets_what_grains_lose() {
    // What two soft grains do to each other is tabulated: as a pair they turn by what the table says, within its error.
    for (rule, disks) in RULES.into_iter().zip([6, 1]) {
        let found = Measured::of(&drum(rule, disks));
        let [before, after] = found.momenta;
        let kinds = ["force x", "force y", "torque"];
        for ((name, before), after) in kinds.into_iter().zip(before).zip(after) {
            let given = found.value(name, "obstacle 0") * DURATION;
            assert!((before - after).abs() > 0.01, "{rule}{name}: nothing happened");
            assert!(
                (given - (before - after)).abs() < 1e-9,
                "{rule}{name}: {given} of {}",
                before - after
            );
        }
        assert!(found.value("contacts", "obstacle 0") > 0.0);
    }
}

/// Of hard disks energy goes in collisions with each other and with the drum, which gives some.
#[test]
fn what_energy_is_lost_is_told() {
    for (rule, disks) in RULES.into_iter().zip([6, 1]) {
        let found = Measured::of(&drum(rule, disks));
        let [before, after] = found.energies;
        let pairs = if disks == 1 { 0.0 } else { found.value("energy lost in contacts", "all") };
        let lost = (pairs + found.value("energy lost in contacts", "obstacle 0")) * DURATION;
        let tolerance = if disks == 1 { 1e-3 } else { 1e-9 };
        assert!((lost - (before - after)).abs() < tolerance, "{rule}{lost} of {}", before - after);
    }
}

/// A hard bar in the middle of the drum: of two obstacles each has its own.
#[test]
fn a_bar_in_a_drum_has_a_force_and_no_torque() {
    for rule in RULES {
        let bar = "[[obstacle]]\nchain = [[0.2, -0.2], [0.4, -0.2]]\nsurface = \"hard\"\nrestitution = 0.7\n";
        let found = Measured::of(&(drum(rule, 6) + bar));
        let [before, after] = found.momenta;
        for (axis, name) in ["force x", "force y"].into_iter().enumerate() {
            let forces = ["obstacle 0", "obstacle 1"].map(|of| found.value(name, of) * DURATION);
            let [drum, bar] = forces;
            let off = drum + bar - (before[axis] - after[axis]);
            assert!(off.abs() < 1e-9, "{rule}{name}: {drum} and {bar}");
        }
        assert!(found.value("contacts", "obstacle 1") > 0.0);
        assert!(
            !found.recorder.means().iter().any(|(q, _)| q.name == "torque" && q.of == "obstacle 1")
        );
    }
}

/// Disks that lie in a cup and sleep: it bears their weight.
#[test]
fn a_cup_bears_what_lies_in_it() {
    let cup = "dimension = 2\ngravity = [0.0, -10.0]\nduration = 40.0\nsample = 1.0\n[observe]\nfrom = 30.0\n\
        [[obstacle]]\nchain = [[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]]\n";
    for rule in RULES {
        let mut text = format!("{cup}{rule}");
        for at in [[-0.2, 0.5], [0.05, 0.8], [0.2, 0.45]] {
            text.push_str(&format!("[[grain]]\nradius = {RADIUS}\nmass = 1.5\nat = {at:?}\n"));
        }
        let found = Measured::of(&text);
        let weight = found.value("force y", "obstacle 0") / (-3.0 * 1.5 * 10.0);
        assert!((weight - 1.0).abs() < 1e-3, "{rule}{weight}");
        assert!(found.value("force x", "obstacle 0").abs() < 0.05, "{rule}");
    }
}
