//! Which digests does the scripted box get on this machine? Reads nothing; writes lines, as the firmware of QEMU does.

use carom_tilt_box::replay::{self, Refusal};
use carom_tilt_box::scene::Memory;
use carom_tilt_box::screen::Canvas;

fn main() -> Result<(), Refusal> {
    let mut lines = String::new();
    let written = replay::lines(&mut Memory::<12>::new(), &mut Canvas::new(), &mut lines)?;
    assert!(written.is_ok(), "a string can be written to");
    print!("{lines}");
    Ok(())
}
