//! Which figures of MP13 (Müller and Pöschel, Phys. Rev. E 87, 033301, 2013) can be made? Reads nothing; lists them.

mod exceptions;
pub mod gas;
pub mod transport;

use super::Entry;

/// The figures of MP13, and what the paper leaves open.
pub const FIGURES: &[Entry] = &[
    Entry {
        id: "mp13-7",
        what: "how often eMD* cannot treat a contact as one of two grains alone",
        make: exceptions::make,
    },
    Entry {
        id: "mp13-7-transport",
        what: "self-diffusion and pressure by eMD and eMD*, against MD",
        make: transport::make,
    },
];
