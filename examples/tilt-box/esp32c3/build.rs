//! How is the image linked? Reads nothing; names the linker scripts of esp-hal and defmt.

fn main() {
    println!("cargo::rustc-link-arg=-Tdefmt.x");
    println!("cargo::rustc-link-arg=-Tlinkall.x");
}
