//! Which tables does this build carry? Reads the cargo features; writes the tables as Rust text into OUT_DIR.

use std::path::PathBuf;

use carom_tables::{Law, Recipe};

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=build.rs");
    let out = std::env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run this through cargo")?;
    let mut text = String::from("/// The standard tables.\npub mod standard {\n");
    for (law, name) in
        [(Law::LinearDashpot, "LINEAR_DASHPOT"), (Law::Viscoelastic, "VISCOELASTIC")]
    {
        text += &Recipe::standard(law).emit(name)?;
    }
    text += "}\n";
    let path = PathBuf::from(out).join("tables.rs");
    std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))
}
