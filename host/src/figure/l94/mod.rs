//! Which figures of L94 (Luding et al., Phys. Rev. E 50, 4113, 1994) can be made? Reads nothing; lists them.

pub mod column;
pub mod fig1;
pub mod fig2;
pub mod fig3;
pub mod fig4;
pub mod fig5;
pub mod fig7;
pub mod fit;
pub mod hard;
pub mod layer;
mod panels;
pub mod shaken;
pub mod table1;

use super::{Entry, Made, Options};
use anyhow::Result;

const fn entry(id: &'static str, what: &'static str, make: fn(&Options) -> Result<Made>) -> Entry {
    Entry { id, what, make }
}

/// The figures of L94.
pub const FIGURES: &[Entry] = &[
    entry("l94-1", "trajectories of ten beads at a wall, for three gaps", fig1::make),
    entry("l94-2a", "ε_eff of a column at a wall, against the gaps", fig2::make_a),
    entry("l94-2b", "loss of beads in contact, against N and ε", fig2::make_b),
    entry("l94-2c", "relative energy left by the impact of beads in contact", fig2::make_c),
    entry("l94-3", "ε_eff of beads in contact, for three force laws", fig3::make),
    entry("l94-4a", "ε_eff of a layer in two dimensions, against the gaps", fig4::make_a),
    entry("l94-4b", "loss of layers in contact, against their height", fig4::make_b),
    entry("l94-5", "a column on a vibrating plate, for two contact times", fig5::make),
    entry("l94-7", "height of a strongly shaken column, against α", fig7::make),
    entry("l94-table1", "exponents of depth, duration and loss of a contact", table1::make),
];
