//! What does every method have? Reads and writes nothing itself.

use crate::scenario::{MethodName, Placed};
use anyhow::Result;

/// One way to find out what the grains do.
///
/// All methods start from the same [`Start`](crate::scenario::Start) and have the same interface, so that a comparison needs
/// to know nothing else of them.
pub trait Method {
    /// Which one it is.
    fn name(&self) -> MethodName;

    /// The present (s).
    fn time(&self) -> f64;

    /// Goes on to an instant.
    ///
    /// # Errors
    /// An error of the method.
    fn advance_to(&mut self, time: f64) -> Result<()>;

    /// As [`Method::advance_to`], but after so many events it may stop: false if it has not arrived then.
    /// In how many calls it arrives changes nothing.
    ///
    /// # Errors
    /// An error of the method.
    fn advance_within(&mut self, time: f64, events: u32) -> Result<bool> {
        let _ = events;
        self.advance_to(time).map(|()| true)
    }

    /// The whole state, from which [`super::with_state`] goes on with the same bits; none if the method
    /// cannot be saved and must begin anew.
    ///
    /// # Errors
    /// When it cannot be put into bytes.
    fn save(&self) -> Result<Option<Vec<u8>>> {
        Ok(None)
    }

    /// When something happens next by itself (s), a grain's way into another cell among it; none if nothing
    /// ever does, or the method has no events.
    fn next_event_time(&self) -> Option<f64> {
        None
    }

    /// A digest of the whole state, the same on every machine; none where the method promises no such bits.
    fn digest(&self) -> Option<u64> {
        None
    }

    /// All grains as they are now, inside the box where it is periodic; [`Placed::GONE`] where one was taken out.
    fn grains(&self) -> Vec<Placed>;

    /// The angular velocity of each grain (1/s), about each axis; nothing where grains are smooth.
    fn rotations(&self) -> Vec<[f64; 3]> {
        Vec::new()
    }

    /// Kinetic energy of rotation (J).
    fn rotational_energy(&self) -> f64 {
        0.0
    }

    /// Kinetic energy of the grains' centres (J).
    fn kinetic_energy(&self) -> f64;

    /// Contacts begun so far, with grains and walls.
    fn collisions(&self) -> u64;

    /// How often everything happened, by name.
    fn statistics(&self) -> Vec<(&'static str, u64)>;

    /// How many grains move in which way now, by name; nothing where the method knows no such ways.
    fn motions(&self) -> Vec<(&'static str, usize)> {
        Vec::new()
    }

    /// What contacts have transferred and cost since the last call, if it is asked for: sums as
    /// [`Layout`](crate::observe::Layout) numbers them.
    fn take_tally(&mut self) -> Vec<f64> {
        Vec::new()
    }

    /// The events since the last call, if a log was asked for.
    fn take_events(&mut self) -> Vec<LoggedEvent> {
        Vec::new()
    }
}

/// Three numbers, 0 beyond the dimension.
pub(super) fn three(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

/// One line of an event log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedEvent {
    /// When (s).
    pub time: f64,
    /// What happened.
    pub kind: &'static str,
    /// To which grain.
    pub grain: usize,
    /// With which grain.
    pub partner: Option<usize>,
    /// With which plane: two for each walled axis, lower one first.
    pub plane: Option<usize>,
}
