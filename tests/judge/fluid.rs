//! Are elastic hard spheres the fluid that is known? Pressure and mean free time against published values.

use carom_host::figure::hard::{Fluid, Mean, Plan, measure, pressure};

/// Within a share of the published value, and measured to a fifth of that: the tolerance is no cover for noise.
fn agrees(what: &str, Mean { value, error }: Mean, published: f64, within: f64) {
    let difference = value / published - 1.0;
    println!(
        "{what}: {value:.5} ± {error:.5}, published {published:.5}: {:+.3} %",
        100.0 * difference
    );
    assert!(error < 0.2 * within * published, "{what}: {error} is too large an error");
    assert!(difference.abs() < within, "{what}: {value} instead of {published}");
}

/// 500 spheres for 240 collisions a grain: statistics leave an error of about 0.4 %, and 3 % is asked for.
#[test]
fn a_small_fluid_has_carnahan_and_starlings_pressure() {
    let plan = Plan { equilibrate: 20, block: 12, blocks: 20 };
    let fluid = Fluid::elastic(500, 0.5);
    let measured = measure::<3>(&fluid, plan, || ()).unwrap();
    let z = pressure::carnahan_starling(pressure::packing_of_spheres(0.5));
    agrees("Z", measured.compressibility, z, 0.03);
    agrees("mean free time", measured.mean_free_time, pressure::LUE, 0.03);
    assert!(measured.energy_drift < 1e-12, "{}", measured.energy_drift);
}

/// Carnahan–Starling within 0.5 % and Lue's mean free time within 1 %.
#[test]
#[ignore = "long; run in release"]
fn spheres_have_the_published_pressure_and_mean_free_time() {
    for (grains, block) in [(1_372, 100), (13_500, 12)] {
        let plan = Plan { equilibrate: 60, block, blocks: 20 };
        let measured = measure::<3>(&Fluid::elastic(grains, 0.5), plan, || ()).unwrap();
        let z = pressure::carnahan_starling(pressure::packing_of_spheres(0.5));
        agrees(&format!("N = {grains}, Z"), measured.compressibility, z, 0.005);
        agrees(
            &format!("N = {grains}, mean free time"),
            measured.mean_free_time,
            pressure::LUE,
            0.01,
        );
    }
}

/// Kolafa and Rottner's hard disks within 0.5 %.
#[test]
#[ignore = "long; run in release"]
fn disks_have_the_published_pressure() {
    let plan = Plan { equilibrate: 100, block: 300, blocks: 20 };
    let fluid = Fluid::elastic(1_024, 0.5 / pressure::packing_of_disks(1.0));
    let measured = measure::<2>(&fluid, plan, || ()).unwrap();
    agrees("disks, Z", measured.compressibility, pressure::kolafa_rottner(0.5), 0.005);
}
