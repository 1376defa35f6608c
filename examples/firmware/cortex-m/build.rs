//! Which memory has the board of each image? Reads the target; writes memory.x for the linker, one for each board.

use std::error::Error;
use std::path::PathBuf;

/// Arm MPS2 with the image AN385 (Cortex-M3) or AN386 (Cortex-M4F).
const MPS2: &str =
    "MEMORY { FLASH : ORIGIN = 0x00000000, LENGTH = 4M  RAM : ORIGIN = 0x20000000, LENGTH = 4M }";
/// BBC micro:bit (nRF51822).
const MICROBIT: &str = "MEMORY { FLASH : ORIGIN = 0x00000000, LENGTH = 256K  RAM : ORIGIN = 0x20000000, LENGTH = 16K }";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let small = std::env::var("TARGET")?.starts_with("thumbv6m");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?);
    // The tilt box must fit into a micro:bit. All scenes with all tables in three number types do not, nor does
    // the force-based run beside the other.
    let board = if small { MICROBIT } else { MPS2 };
    let images = [
        ("replay", MPS2),
        ("tilt_box", board),
        ("measure", MPS2),
        ("heap", MPS2),
        ("frames", MPS2),
        ("hourglass", MPS2),
        ("rough_box", MPS2),
        ("smallest", board),
        ("smallest_heap", board),
    ];
    for (image, memory) in images {
        let directory = out.join(image);
        std::fs::create_dir_all(&directory)?;
        std::fs::write(directory.join("memory.x"), memory)?;
        println!("cargo::rustc-link-arg-bin={image}=-L{}", directory.display());
    }
    // Functions with the same code are one.
    println!("cargo::rustc-link-arg-bins=--icf=all");
    Ok(())
}
