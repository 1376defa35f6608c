//! What does an error say to people? Reads an error; writes a sentence.

use super::refusal::{Error, Subject};
use core::fmt;

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Grain(i) => write!(f, "grain {i}"),
            Self::Plane(i) => write!(f, "plane {i}"),
            Self::Facet(i) => write!(f, "facet {i}"),
            Self::Axis(i) => write!(f, "axis {i}"),
            Self::Rule => f.write_str("rule"),
            Self::World => f.write_str("world"),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Input { subject, field, value, wanted } => {
                write!(f, "{subject}: {field} is {value}, must be {wanted}")
            }
            Self::Full { knob, capacity } => {
                write!(f, "no place left: {knob} holds {capacity}; enlarge it")
            }
            Self::Overlap { grain, with, gap, also: None } => {
                write!(
                    f,
                    "grain {grain} and {with} overlap: their gap is {gap}, must be at least 0"
                )
            }
            Self::Overlap { grain, with, gap, also: Some(also) } => write!(
                f,
                "grain {grain} overlaps {with} and, on its other side, {also}: between them is no room for it; \
                 the gap is {gap}, must be at least 0"
            ),
            Self::OutsideTable { grain, with, eccentricity, eta, c_dis } => write!(
                f,
                "grain {grain} meets {with} outside the table's domain: e = {eccentricity}, 1/l = {eta}, c_dis = {c_dis}; \
                 choose Outside::Clamp or Outside::HardSphere, or a wider table"
            ),
            Self::LongContact { contact_time, overlap, longest } => write!(
                f,
                "world: contact time is {contact_time}, must be at most {longest}: at rest a grain would overlap \
                 what carries it by {overlap} of its radius, at most 0.05 is allowed"
            ),
            Self::InvalidOutcome { field, value, wanted } => {
                write!(f, "the rule returned {field} = {value}, must be {wanted}")
            }
            Self::Stuck { grain, with, at, events } => write!(
                f,
                "stuck at t = {at}: {events} events at this instant, the last of grain {grain} with {with}; \
                 the collision rule does not resolve this collapse"
            ),
            Self::NotFinite { grain, field, at } => {
                write!(f, "grain {grain}: its {field} is no longer a finite number at t = {at}")
            }
            Self::Overflow { subject, quantity, range, choose } => write!(
                f,
                "{subject}: its {quantity} does not fit the fixed-point number, which holds it up to {range}; \
                 choose {choose}"
            ),
            Self::Past { asked, now } => write!(f, "t = {asked} is in the past: it is {now} now"),
        }
    }
}

impl core::error::Error for Error {}
