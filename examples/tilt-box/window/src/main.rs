//! What does the tilt box look like on a workstation? Reads the mouse, or a script; shows a window, or writes a PNG.
//!
//! `cargo run -- tilt-box.png` writes twelve pictures of the scripted box; `cargo run --features window` opens a window in
//! which down is where the mouse points to.

mod strip;
#[cfg(feature = "window")]
mod window;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    #[cfg(feature = "window")]
    if std::env::args().len() == 1 {
        return Ok(window::show()?);
    }
    let path = std::env::args().nth(1).unwrap_or_else(|| "tilt-box.png".to_owned());
    strip::write(path.as_ref())?;
    println!("{path}: twelve pictures of the scripted box, half a second from one to the next");
    Ok(())
}
