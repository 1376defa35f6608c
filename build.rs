//! Which tables does this build carry? Reads the cargo features; writes the tables as Rust text into OUT_DIR.

use std::error::Error;
use std::path::PathBuf;

use carom_tables::read::Law;
use carom_tables::recipe::{NumberType, Recipe, emit_history};

/// The numbers in which tables are stored, and what that adds to a table's name.
fn numbers() -> Vec<(NumberType, &'static str)> {
    let mut all = vec![(NumberType::F32, "")];
    if enabled("F64_TABLES") {
        all.push((NumberType::F64, "_F64"));
    }
    #[cfg(feature = "fixed")]
    all.extend([(NumberType::I32F32, "_I32F32"), (NumberType::I16F16, "_I16F16")]);
    all
}

fn enabled(feature: &str) -> bool {
    std::env::var_os(format!("CARGO_FEATURE_{feature}")).is_some()
}

/// The course of contacts over time, which friction asks for: small, and linked only where it is used.
fn histories() -> Result<String, Box<dyn Error>> {
    let reader = "::carom_tables::read";
    let linear = emit_history(Law::LinearDashpot, "LINEAR_DASHPOT", reader)?;
    let viscoelastic = emit_history(Law::Viscoelastic, "VISCOELASTIC", reader)?;
    Ok(format!(
        "/// The course of contacts over time.\npub mod history {{\n{linear}{viscoelastic}}}\n"
    ))
}

/// One module of Rust text: a table for each law and number.
fn module(module: &str, recipe: fn(Law) -> Recipe) -> Result<String, Box<dyn Error>> {
    let mut text = format!("/// The {module} tables.\npub mod {module} {{\n");
    for (number, ending) in numbers() {
        for (law, name) in
            [(Law::LinearDashpot, "LINEAR_DASHPOT"), (Law::Viscoelastic, "VISCOELASTIC")]
        {
            // Wide and fine tables have numbers too large to be quantised.
            let is_quantised = !matches!(number, NumberType::F32 | NumberType::F64);
            if !(is_quantised && ["wide", "fine"].contains(&module)) {
                text += &recipe(law).number_type(number).emit(&format!("{name}{ending}"))?;
            }
        }
    }
    Ok(text + "}\n")
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let mut text = histories()?;
    if enabled("COMPACT") {
        text += &module("compact", Recipe::compact)?;
    }
    if enabled("STANDARD") {
        text += &module("standard", Recipe::standard)?;
    }
    if enabled("WIDE") {
        text += &module("wide", Recipe::wide)?;
    }
    if enabled("FINE") {
        text += &module("fine", Recipe::fine)?;
    }
    let out = std::env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run this through cargo")?;
    Ok(std::fs::write(PathBuf::from(out).join("tables.rs"), text)?)
}
