//! Is there memory for so many grains? Reads what the machine has; writes nothing, says why not.

use super::side::Placed;
use crate::machine::{available_memory, world_bytes_per_grain};

/// More than the engine can number, and more than any machine has memory for.
const MAX_GRAINS: usize = 1 << 30;

/// Copies of a grain that the host keeps besides: the start, a sample, and one that is being written.
const COPIES: usize = 3;

/// Why so many grains cannot be; nothing if they can. Begins as a message about the number does.
pub fn refusal(count: usize, dimension: usize) -> Option<String> {
    let each = world_bytes_per_grain(dimension) + COPIES * size_of::<Placed>();
    let needed = count as f64 * each as f64;
    let available = available_memory().map(|bytes| bytes as f64);
    if count <= MAX_GRAINS && available.is_none_or(|available| needed <= available) {
        return None;
    }
    let gigabytes = |bytes: f64| format!("{:.1} GB", bytes * 1e-9);
    let has = available.map_or_else(String::new, |available| {
        format!(", the machine has {} free", gigabytes(available))
    });
    Some(format!("is {count}: so many grains need {} of memory{has}", gigabytes(needed)))
}
