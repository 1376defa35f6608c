//! Does a run measure what is published? Runs elastic gases for some hundred collisions a grain; compares with simulations and equations of state.
//!
//! `cargo test --release -p carom-host --test observe_values -- --ignored --nocapture` prints what it finds.

use carom_host::figure::hard::pressure::kolafa_rottner;
use carom_host::measure;
use carom_host::observe::{Mean, Recorder};
use carom_host::scenario::{MethodName, Placed, Scenario, Side, Start};
use rand::{RngExt, SeedableRng};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;
use std::f64::consts::PI;

/// Elastic spheres or disks of mass 1, so many along an axis, on a cubic lattice in a periodic box; their
/// diameters follow from their places. No total momentum, kT = 1.
fn lattice(start: &mut Start, side: usize, length: f64, diameter: impl Fn([usize; 3]) -> f64) {
    let d = start.dimension;
    let step = length / side as f64;
    let place = |site: usize| std::array::from_fn(|axis| site / side.pow(axis as u32) % side);
    let mut rng = Pcg64::seed_from_u64(1);
    let mut draw = |axis: usize| if axis < d { rng.sample(StandardNormal) } else { 0.0 };
    let grain = |site: usize| {
        let at: [usize; 3] = place(site);
        let middle = |axis: usize| if axis < d { (at[axis] as f64 + 0.5) * step } else { 0.0 };
        let (position, velocity) = (std::array::from_fn(middle), std::array::from_fn(&mut draw));
        Placed { radius: 0.5 * diameter(at), mass: 1.0, position, velocity }
    };
    start.grains = (0..side.pow(d as u32)).map(grain).collect();
    start.species = vec![0; start.grains.len()];
    start.materials = vec![0; start.grains.len()];
    for axis in 0..d {
        start.sides[axis] = Side::Periodic([0.0, length]);
        let mean = start.grains.iter().map(|g| g.velocity[axis]).sum::<f64>();
        let mean = mean / start.grains.len() as f64;
        start.grains.iter_mut().for_each(|g| g.velocity[axis] -= mean);
    }
    let square: f64 = start.grains.iter().flat_map(|g| g.velocity).map(|v| v * v).sum();
    let scale = ((d * (start.grains.len() - 1)) as f64 / square).sqrt();
    start.grains.iter_mut().flat_map(|g| &mut g.velocity).for_each(|v| *v *= scale);
}

/// Measures from `from` to `duration`.
fn measured(
    dimension: usize,
    [from, every, duration]: [f64; 3],
    fill: impl Fn(&mut Start),
) -> Recorder {
    let text = format!(
        "dimension = {dimension}\nduration = {duration:?}\nsample = {duration:?}\nmethods = [\"emd\"]\n\
         [law]\nkind = \"constant\"\nrestitution = 1.0\n\
         [observe]\nfrom = {from:?}\nevery = {every:?}\n\
         [[grain]]\nradius = 0.5\nmass = 1.0\nat = {:?}",
        vec![0.0; dimension]
    );
    let scenario = Scenario::parse(&text).unwrap();
    let mut start = Start::new(&scenario).unwrap();
    fill(&mut start);
    measure::run(MethodName::Emd, &scenario, &start).unwrap()
}

fn mean(recorder: &Recorder, name: &str) -> Mean {
    let means = recorder.means().into_iter();
    let mut found = means.filter(|(quantity, _)| quantity.name == name && quantity.of == "all");
    found.next().unwrap_or_else(|| panic!("no {name}")).1
}

fn compare(what: &str, Mean { value, error }: Mean, published: f64, tolerance: f64) {
    let difference = value / published - 1.0;
    println!(
        "{what}: {value:.5} ± {error:.5}, published {published} ({:+.2} %)",
        100.0 * difference
    );
    assert!(difference.abs() < tolerance, "{what}: {value} ± {error}, published {published}");
}

/// Density 0.5, N = 1,372 from a close-packed lattice: mean free time (Lue 2005, doi:10.1063/1.1834498) and coefficient of diffusion as
/// DynamO's tests have them (`hardsphere_test.cpp`, to 1 % and 6 %).
#[test]
#[ignore = "minutes without --release"]
fn spheres_of_density_one_half() {
    let text = format!(
        "dimension = 3\nduration = 44.0\nsample = 44.0\nmethods = [\"emd\"]\n\
         law = {{ kind = \"constant\", restitution = 1.0 }}\n\
         [box]\npacking_fraction = {:?}\nx = {{ kind = \"periodic\" }}\ny = {{ kind = \"periodic\" }}\n\
         z = {{ kind = \"periodic\" }}\n\
         [[species]]\ncount = 1372\nradius = 0.5\ndensity = {:?}\ntemperature = 1.0\nplace = {{ kind = \"lattice\" }}\n\
         [observe]\nfrom = 4.0\nevery = 0.1\ncorrelations = {{ to = 4.0, points = 40 }}\n",
        0.5 * PI / 6.0,
        6.0 / PI
    );
    let scenario = Scenario::parse(&text).unwrap();
    let start = Start::new(&scenario).unwrap();
    let found = measure::run(MethodName::Emd, &scenario, &start).unwrap();
    compare("mean free time", mean(&found, "mean free time"), 0.13031, 0.01);
    compare("D", mean(&found, "diffusion coefficient"), 0.247, 0.06);
}

/// Spheres of diameters 2 and 1, as many of both, packing 0.3: the equation of Boublík, Mansoori, Carnahan,
/// Starling and Leland (J. Chem. Phys. 54, 1523, 1971) gives Z = 3.506.
#[test]
#[ignore = "minutes without --release"]
fn a_mixture_of_two_sizes() {
    let length = (1000.0 * PI / 6.0 * 4.5 / 0.3_f64).cbrt();
    let found = measured(3, [20.0, 0.5, 220.0], |start| {
        let size = |at: [usize; 3]| if at.iter().sum::<usize>() % 2 == 0 { 2.0 } else { 1.0 };
        lattice(start, 10, length, size);
    });
    compare("Z of the mixture", mean(&found, "compressibility factor"), 3.506, 0.005);
}

/// Hard disks at packing 0.3, 0.5 and 0.65: Kolafa and Rottner (Mol. Phys. 104, 3435, 2006).
#[test]
#[ignore = "minutes without --release"]
fn disks_of_three_densities() {
    for (packing, duration) in [(0.3_f64, 400.0), (0.5, 150.0), (0.65, 60.0)] {
        let length = (1024.0 * PI / 4.0 / packing).sqrt();
        let span = [0.1 * duration, 0.1, duration];
        let found = measured(2, span, |start| lattice(start, 32, length, |_| 1.0));
        let z = mean(&found, "compressibility factor");
        compare(&format!("Z of disks at {packing}"), z, kolafa_rottner(packing), 0.003);
    }
}
