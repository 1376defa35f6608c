//! What do grains do to obstacles? Reads what a contact gives; writes sums.

use crate::scenario::{Motion, Start};
use carom::nalgebra::SVector;

/// What is summed for every obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Struck {
    /// Contacts that began.
    Count,
    /// Kinetic energy that grains lost there (J).
    Loss,
    /// Momentum given to the obstacle, along an axis (kg m/s).
    Momentum(usize),
    /// Angular momentum given to it about the centre of its rotation, about an axis (kg m²/s).
    Turn(usize),
}

impl Struck {
    /// How many there are.
    pub const COUNT: usize = 8;

    /// Its number among them.
    pub const fn place(self) -> usize {
        match self {
            Self::Count => 0,
            Self::Loss => 1,
            Self::Momentum(axis) => 2 + axis,
            Self::Turn(axis) => 5 + axis,
        }
    }
}

/// An obstacle that is observed.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// What it is called.
    pub name: String,
    /// The point about which it turns, if it does (m).
    pub centre: Option<[f64; 3]>,
}

impl Observed {
    /// All that stand at a start.
    pub fn all(start: &Start) -> Vec<Self> {
        let centre = |number: usize| {
            let facet = start.walls.iter().find(|facet| facet.obstacle == number)?;
            match start.motions.get(usize::from(facet.motion?))? {
                Motion::Rotation { centre, .. } => Some(*centre),
                _ => None,
            }
        };
        let numbered = start.obstacles.iter().enumerate();
        numbered
            .map(|(number, obstacle)| Self { name: obstacle.named(number), centre: centre(number) })
            .collect()
    }

    /// The sums of a contact in which a grain is given an impulse at a point of the obstacle, with its own spin's part.
    pub fn given<const D: usize>(
        &self,
        [count, loss]: [f64; 2],
        impulse: &SVector<f64, D>,
        (at, spin): (&SVector<f64, D>, [f64; 3]),
    ) -> [f64; Struck::COUNT] {
        let mut sums = [0.0; Struck::COUNT];
        sums[Struck::Count.place()] = count;
        sums[Struck::Loss.place()] = loss;
        let (at, impulse) = (three(at), three(impulse));
        let centre = self.centre.unwrap_or_default();
        let arm: [f64; 3] = std::array::from_fn(|k| at[k] - centre[k]);
        for axis in 0..3 {
            let [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
            sums[Struck::Momentum(axis).place()] = -impulse[axis];
            let turn = arm[b] * impulse[c] - arm[c] * impulse[b] + spin[axis];
            sums[Struck::Turn(axis).place()] = -turn;
        }
        sums
    }
}

fn three<const D: usize>(v: &SVector<f64, D>) -> [f64; 3] {
    std::array::from_fn(|axis| v.get(axis).copied().unwrap_or(0.0))
}
