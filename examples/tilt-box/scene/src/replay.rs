//! Does the box do the same on every processor? Runs the script with a budget of events; writes lines of digests.
//!
//! The firmware of QEMU and a workstation write the same lines.

use core::fmt::{self, Write};

use carom::Error;

use crate::frame::{Pace, TiltBox};
use crate::picture;
use crate::scene::Memory;
use crate::screen::Canvas;
use crate::script::{READINGS, Script};
use crate::sensor;
use crate::tilt::{Mounting, Tilt};

/// What looks on while the script runs, and says how much time there is.
pub trait Onlooker {
    /// A frame begins: the accelerometer has been read.
    fn begin(&mut self);
    /// Whether physics may go on.
    fn has_time(&mut self) -> bool;
    /// The physics of the frame is over, and the picture not yet drawn.
    fn end(&mut self, reading: u32, tilt_box: &TiltBox<'_>);
}

/// Why a script can end early.
#[derive(Debug)]
pub enum Refusal {
    /// The sensor could not be set up.
    Sensor,
    /// The engine's.
    Engine(Error),
    /// The picture could not be drawn.
    Picture,
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        Self::Engine(error)
    }
}

/// Runs the script to its end: everything that a board does, but for the bus and the clock.
///
/// # Errors
/// None, unless the box is broken.
#[inline(never)]
pub fn run<const N: usize>(
    memory: &mut Memory<N>,
    canvas: &mut Canvas,
    onlooker: &mut impl Onlooker,
) -> Result<Pace, Refusal> {
    let mut sensor = sensor::lis3dh(Script::default()).map_err(|_| Refusal::Sensor)?;
    let mut tilt = Tilt::new(Mounting::default());
    let mut tilt_box = TiltBox::new(memory)?;
    for reading in 0..READINGS {
        let gravity = tilt.read(&mut sensor);
        onlooker.begin();
        tilt_box.frame(gravity, || onlooker.has_time())?;
        onlooker.end(reading, &tilt_box);
        picture::draw(tilt_box.disks(), canvas).map_err(|_| Refusal::Picture)?;
    }
    Ok(tilt_box.pace())
}

/// So many events a frame suffice for most of the script's frames, and not for all.
const EVENTS: u32 = 100;
/// Frames between two lines.
const BETWEEN_LINES: u32 = 20;

/// An onlooker that writes digests.
struct Lines<'w, W> {
    to: &'w mut W,
    left: u32,
    written: fmt::Result,
}

impl<W: Write> Onlooker for Lines<'_, W> {
    fn begin(&mut self) {
        self.left = EVENTS;
    }

    fn has_time(&mut self) -> bool {
        let has_time = self.left > 0;
        self.left = self.left.saturating_sub(1);
        has_time
    }

    fn end(&mut self, reading: u32, tilt_box: &TiltBox<'_>) {
        if (reading + 1).is_multiple_of(BETWEEN_LINES) {
            let digest = tilt_box.disks().digest();
            let Pace { slowed, behind, .. } = tilt_box.pace();
            self.written =
                self.written.and(writeln!(self.to, "{reading} {digest:016x} {slowed} {behind}"));
        }
    }
}

/// Writes the digest of the disks, how many frames were slowed and by how many µs in all, every half second; at the
/// end the digest of the last picture.
///
/// # Errors
/// As [`run`]; what cannot be written.
pub fn lines<const N: usize>(
    memory: &mut Memory<N>,
    canvas: &mut Canvas,
    to: &mut impl Write,
) -> Result<fmt::Result, Refusal> {
    let mut lines = Lines { to, left: 0, written: Ok(()) };
    run(memory, canvas, &mut lines)?;
    let Lines { to, written, .. } = lines;
    Ok(written.and(writeln!(to, "picture {:016x}", fnv(canvas.data()))))
}

/// FNV-1a.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
