//! Which table does this program need? Reads one material and its speeds; writes the table into OUT_DIR.

use std::{env, error::Error, path::PathBuf};

use carom_tables::{collision::EqualSpheres, read::Law, recipe::Recipe};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    // Balls of nitrile rubber, 10 mm across, that collide at up to 1 m/s.
    let fastest = EqualSpheres { radius: 5e-3, density: 1200.0, speed: 1.0, eccentricity: 0.0 };
    let grazing = EqualSpheres { eccentricity: 0.9999, ..fastest };
    let collisions = [fastest, grazing].map(|hit| hit.viscoelastic(5e6, 0.49, 1e-4));
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    Recipe::standard(Law::Viscoelastic)
        .covering(&collisions)
        .tolerance(1e-5)
        .reader_path("::carom::law::embedded::read")
        .write(out.join("rubber.rs"), "RUBBER")?;
    Ok(())
}
