//! What do grains do among obstacles? Makes the figures of drums; reads nothing, writes data, pictures and comparisons.

pub mod drum;
