//! In which ways can a world refuse? Every error names the field or knob, its value, and what would be right.

use crate::particle::Partner;
use crate::scalar::Instant;

/// What an error is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Subject {
    /// The grain with this number, in the order in which grains were added.
    Grain(usize),
    /// The plane with this number, in the order in which planes were added.
    Plane(usize),
    /// The facet with this number, in the order in which the memory lends them.
    Facet(usize),
    /// The axis with this number.
    Axis(usize),
    /// The contact law or rule.
    Rule,
    /// The world as a whole.
    World,
}

/// Every way in which a world can refuse. With the feature `serde` it is written, not read: its words are the program's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A field has a value it cannot have.
    Input {
        /// Whose field.
        subject: Subject,
        /// Its name.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// A store is full.
    Full {
        /// What to enlarge.
        knob: &'static str,
        /// How many it holds now.
        capacity: usize,
    },
    /// Two grains, or a grain and a plane or facet, overlap at the start.
    Overlap {
        /// The grain.
        grain: usize,
        /// With what.
        with: Partner,
        /// The distance of their surfaces: negative.
        gap: f64,
        /// The facet that it overlaps on the other side, where it stands between two that leave it no room.
        also: Option<Partner>,
    },
    /// A collision lies outside the table's domain and the rule was built with `Outside::Reject`.
    OutsideTable {
        /// The grain.
        grain: usize,
        /// With what.
        with: Partner,
        /// Eccentricity e = sin α.
        eccentricity: f64,
        /// η = 1/l̃.
        eta: f64,
        /// Scaled dissipation.
        c_dis: f64,
    },
    /// The contact time of slow hard grains is so long that one at rest would sink in by more than a twentieth
    /// of its radius.
    LongContact {
        /// The contact time.
        contact_time: f64,
        /// By how much the smallest grain would overlap what carries it, in units of its radius.
        overlap: f64,
        /// The longest contact time that gravity and the smallest grain allow.
        longest: f64,
    },
    /// A rule gave something that is not the outcome of a collision.
    InvalidOutcome {
        /// Which number.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// Too many events at one instant, 4,096 or more for each grain that has contacts there: a collapse the rule does
    /// not resolve. Only `Enduring::Paper` can return it: by default forces take over after 64 collisions in a row.
    Stuck {
        /// The grain of the last event.
        grain: usize,
        /// With what.
        with: Partner,
        /// The instant.
        at: Instant,
        /// How many events it has seen.
        events: u32,
    },
    /// A grain's state has left the range of the number type.
    NotFinite {
        /// The grain.
        grain: usize,
        /// Position or velocity.
        field: &'static str,
        /// The instant.
        at: Instant,
    },
    /// A number has left the range of the fixed-point type, or is too coarse in it: the units do not suit.
    Overflow {
        /// Whose number.
        subject: Subject,
        /// Which number.
        quantity: &'static str,
        /// The largest magnitude that it may have.
        range: f64,
        /// The unit to change, and how.
        choose: &'static str,
    },
    /// The instant asked for lies in the past.
    Past {
        /// The instant asked for.
        asked: Instant,
        /// The present.
        now: Instant,
    },
}

impl Error {
    /// A field with a wrong value.
    pub(crate) fn input(
        subject: Subject,
        field: &'static str,
        value: f64,
        wanted: &'static str,
    ) -> Self {
        Self::Input { subject, field, value, wanted }
    }

    /// A quantity that has left the range of its type.
    pub(crate) fn overflow(subject: Subject, quantity: &'static str, range: f64) -> Self {
        Self::Overflow { subject, quantity, range, choose: unit_for(quantity) }
    }
}

/// The unit in which a quantity's number becomes smaller.
fn unit_for(quantity: &str) -> &'static str {
    match quantity {
        "position" | "radius" | "length" | "separation" => "a larger unit of length",
        "velocity" | "gravity" => "a larger unit of length or a smaller unit of time",
        "time of the contact's end" | "duration" | "dissipation" => "a larger unit of time",
        "mass" => "a larger unit of mass",
        "stiffness" | "damping" | "young" | "stiffness over mass" => {
            "a smaller unit of time or a larger unit of mass"
        }
        "contact time" => "a smaller unit of time: it is too short for one step of the number",
        "scaled dissipation" => "a table's number for it: it is far above one",
        _ => "units in which it is nearer to one",
    }
}
