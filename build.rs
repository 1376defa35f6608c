//! Which tables does this build carry? Reads the cargo features; writes the tables as Rust text into OUT_DIR.

use std::error::Error;
use std::path::PathBuf;

use carom_tables::{Law, Recipe, recipe::Number};

/// One module of Rust text: a table for each law.
fn module(name: &str, recipe: fn(Law) -> Recipe, number: Number) -> Result<String, Box<dyn Error>> {
    let make = |law, name| recipe(law).number(number).emit(name);
    let linear = make(Law::LinearDashpot, "LINEAR_DASHPOT")?;
    let viscoelastic = make(Law::Viscoelastic, "VISCOELASTIC")?;
    Ok(format!("/// The {name} tables.\npub mod {name} {{\n{linear}{viscoelastic}}}\n"))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let enabled = |feature: &str| std::env::var_os(format!("CARGO_FEATURE_{feature}")).is_some();
    let number = if enabled("F64_TABLES") { Number::F64 } else { Number::F32 };
    let mut text = String::new();
    if enabled("COMPACT") {
        text += &module("compact", Recipe::compact, number)?;
    }
    if enabled("STANDARD") {
        text += &module("standard", Recipe::standard, number)?;
    }
    if enabled("WIDE") {
        text += &module("wide", Recipe::wide, number)?;
    }
    let out = std::env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run this through cargo")?;
    Ok(std::fs::write(PathBuf::from(out).join("tables.rs"), text)?)
}
