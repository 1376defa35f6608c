//! What was wrong with the input, or why did the integration stop? Reads nothing; writes one line that names it.

use thiserror::Error;

/// Why the reference cannot be set up, or cannot go on.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReferenceError {
    /// A parameter of the law, of a boundary or of the run is out of range.
    #[error("{field} = {value} should be {wanted}")]
    Parameter {
        /// The parameter's name.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// A field of a grain is out of range.
    #[error("grain {grain}: {field} = {value} should be {wanted}")]
    Grain {
        /// The grain's number, from 0.
        grain: usize,
        /// The field, with its axis if it is a vector.
        field: String,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// A boundary is empty, or too narrow for a grain.
    #[error("boundary of axis {axis}: from {lo} to {hi} should be {wanted}")]
    Boundary {
        /// The axis, from 0.
        axis: usize,
        /// Lower end.
        lo: f64,
        /// Upper end.
        hi: f64,
        /// What would be right.
        wanted: String,
    },
    /// Two grains have the same centre: the direction of their force is not defined.
    #[error("grains {first} and {second} have the same centre; their centres should be apart")]
    Coincident {
        /// One grain.
        first: usize,
        /// The other one.
        second: usize,
    },
    /// No grains at all.
    #[error("number of grains = 0 should be at least 1")]
    Empty,
    /// The adaptive integration cannot make progress (two centres coincide, or a time scale below resolution).
    #[error("at time {time} the contact of grain {grain} cannot be resolved: {why}")]
    Unresolved {
        /// When.
        time: f64,
        /// A grain of the contact.
        grain: usize,
        /// The cause, as far as known.
        why: &'static str,
    },
    /// The two grains asked for do not touch, or do not approach each other.
    #[error("grains {first} and {second} should touch and approach: {what} = {value}")]
    NotAnImpact {
        /// One grain.
        first: usize,
        /// The other one.
        second: usize,
        /// The quantity that says so.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}

impl ReferenceError {
    pub(crate) fn parameter(field: &'static str, value: f64, wanted: &'static str) -> Self {
        Self::Parameter { field, value, wanted }
    }
}

pub(crate) fn positive(field: &'static str, value: f64) -> Result<(), ReferenceError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(ReferenceError::parameter(field, value, "finite and above 0"))
}

pub(crate) fn zero_or_more(field: &'static str, value: f64) -> Result<(), ReferenceError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    Err(ReferenceError::parameter(field, value, "finite and at least 0"))
}
