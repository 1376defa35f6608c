//! What does a contact do in a step? What whoever asked is told; reads and writes nothing itself.

use crate::exact::Partner;
use crate::vector::Vector;

/// What a contact does in one time step of [`Verlet`](crate::Verlet).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStep<const D: usize> {
    /// The grain.
    pub grain: usize,
    /// What it touches.
    pub partner: Partner,
    /// The force on the grain (N); a partner feels the opposite.
    pub force: [f64; D],
    /// The grain's centre (m).
    pub position: [f64; D],
    /// From the partner's centre, or the nearest point of the wall, to the grain's (m), nearest image.
    pub separation: [f64; D],
    /// The velocity of the grain, and of the partner; a wall's is that of its surface.
    pub velocities: [[f64; D]; 2],
    /// How long the step is (s); its two halves apart where a run begins, ends or pauses at an instant.
    pub step: f64,
    /// Whether the contact began in it.
    pub began: bool,
}

/// Who is told of each contact in each step, if anybody is.
pub type Tell<'a, const D: usize> = Option<&'a mut dyn FnMut(&ContactStep<D>)>;

/// What a contact does, by numbers.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Push<const D: usize> {
    pub(super) grain: u32,
    /// Another grain, which feels the opposite, or a wall.
    pub(super) other: Other,
    /// On the grain.
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) force: Vector<D>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) separation: Vector<D>,
}

/// The other side of a contact.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Other {
    Grain(u32),
    Wall { axis: usize, upper: bool, velocity: f64 },
}

impl<const D: usize> Push<D> {
    /// By which the contact is known from step to step.
    pub(super) fn key(&self) -> u64 {
        let other = match self.other {
            Other::Grain(other) => u64::from(other),
            Other::Wall { axis, upper, .. } => {
                u64::from(u32::MAX) - (2 * axis as u64 + u64::from(upper))
            }
        };
        u64::from(self.grain) << 32 | other
    }
}
