//! What do grains do among obstacles? Makes the figures of drums and hoppers; reads nothing, writes data, pictures and comparisons.

pub mod drum;
pub mod hopper;
