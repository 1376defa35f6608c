//! Which figures of BSFP14 (Bannerman et al., Comput. Part. Mech. 1, 191, 2014) can be made? Reads nothing; lists them.

pub mod ball;
pub mod gas;
mod impact;
mod plates;
pub mod three;

use super::Entry;

/// The figures of BSFP14.
pub const FIGURES: &[Entry] = &[
    Entry {
        id: "bsfp14-3",
        what: "how far from contact spheres collide, in units of the last place",
        make: impact::make,
    },
    Entry {
        id: "bsfp14-5",
        what: "how often a grain overlaps its partner and a third at a collision",
        make: three::make,
    },
    Entry {
        id: "bsfp14-7",
        what: "a bouncing ball on plates at any height: naive detection halts, the stable one rests",
        make: plates::make,
    },
];
