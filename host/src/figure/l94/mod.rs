//! Which figures of L94 (Luding et al., Phys. Rev. E 50, 4113, 1994) can be made? Reads nothing; lists them.

use super::Entry;

/// The figures of L94.
pub const FIGURES: &[Entry] = &[];
