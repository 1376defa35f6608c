//! Which tables does this program need? Reads materials and speeds; writes the tables into OUT_DIR.

use std::{env, error::Error, path::PathBuf};

use carom_tables::recipe::{PairRecipe, Recipe};
use carom_tables::{collision::EqualSpheres, read::Law};

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
    // Any law without a state, of one pair: F = k x^β + γ x^γ′ ẋ (Luding et al. 1994, Appendix), never an attraction.
    let balls = |x: f64, rate: f64, _: &mut [f64; 2]| {
        (2e7 * x.powf(1.75) + 5e3 * x.powf(0.6) * rate).max(0.0)
    };
    // R₁ + R₂ = 0.2 m and m₁ m₂/(m₁ + m₂) = 0.5 kg.
    PairRecipe::new([0.2, 0.5], balls)
        .speeds(0.5, 2.0)
        .across(2.0)
        .tolerance(1e-5)
        .points(500)
        .write(out.join("balls.rs"), "BALLS", "::carom::law::embedded::read")?;
    Ok(())
}
