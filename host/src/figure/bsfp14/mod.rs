//! Which figures of BSFP14 (Bannerman et al., Comput. Part. Mech. 1, 191, 2014) can be made? Reads nothing; lists them.

mod ball;

use super::Entry;

/// The figures of BSFP14.
pub const FIGURES: &[Entry] = &[Entry {
    id: "bsfp14-7",
    what: "a bouncing ball on a plate at any height: naive detection halts, the stable one rests",
    make: ball::make,
}];
