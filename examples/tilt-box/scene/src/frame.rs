//! What happens in a frame? Reads gravity and the time that is left; advances the disks, counts what was left out.

use carom::{Error, Instant};

use crate::scene::{self, Disks, Memory, Number};

/// How long a frame lasts, in ms.
pub const FRAME: u32 = 25;
/// How long physics may take of it, in ms; the rest is for the accelerometer and the display.
pub const SHARE: u32 = 15;
/// So many events happen between two looks at the clock: physics takes at most one portion longer than its share.
const PORTION: u32 = 1;

/// How well the box keeps up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "board", derive(defmt::Format))]
pub struct Pace {
    /// All frames.
    pub frames: u32,
    /// Those whose share of time was over before the physics was: the disks went slower then.
    pub slowed: u32,
    /// By how much the disks' clock is behind the frames', in µs. It only grows: what is left out is not caught up with.
    pub behind: u64,
}

/// The box: its disks, and how well they keep up.
pub struct TiltBox<'m> {
    disks: Disks<'m>,
    pace: Pace,
}

impl<'m> TiltBox<'m> {
    /// The box with its disks let go.
    ///
    /// # Errors
    /// As [`scene::disks`].
    pub fn new<const N: usize>(memory: &'m mut Memory<N>) -> Result<Self, Error> {
        Ok(Self { disks: scene::disks(memory)?, pace: Pace::default() })
    }

    /// One frame under this gravity, as long as `has_time` says so. It is asked before each event.
    ///
    /// Where the time does not suffice the disks go slower: the next frame begins where this one ended, and what is
    /// missing is counted in [`Pace`]. Catching up would only take time from the next frame.
    ///
    /// # Errors
    /// Any error of the engine; [`Error::LongContact`] where gravity is so strong that disks would be pressed flat. Nothing
    /// has changed then, or the world has stopped for good.
    pub fn frame(
        &mut self,
        gravity: [Number; 2],
        mut has_time: impl FnMut() -> bool,
    ) -> Result<(), Error> {
        self.disks.set_gravity(gravity)?;
        let end = self.disks.now() + Instant::from(FRAME as Number);
        self.pace.frames = self.pace.frames.saturating_add(1);
        while has_time() {
            if self.disks.advance_with_budget(end, PORTION)? {
                return Ok(());
            }
        }
        self.pace.slowed = self.pace.slowed.saturating_add(1);
        let missing = end.since::<Number>(self.disks.now());
        self.pace.behind += (missing * 1000.0) as u64;
        Ok(())
    }

    /// The disks.
    #[must_use]
    pub fn disks(&self) -> &Disks<'m> {
        &self.disks
    }

    /// How well the box keeps up.
    #[must_use]
    pub fn pace(&self) -> Pace {
        self.pace
    }
}
