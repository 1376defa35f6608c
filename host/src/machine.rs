//! What does a run need of this machine? Reads sizes and the system's account; writes nothing, returns bytes.

use carom::{HeapMemory, Storage};

/// All that a world of this memory borrows.
///
/// # Units
/// Bytes.
pub fn borrowed<const D: usize>(memory: &mut HeapMemory<f64, D>) -> usize {
    let buffers = memory.buffers();
    size_of_val(buffers.bodies)
        + size_of_val(buffers.events)
        + size_of_val(buffers.tree)
        + size_of_val(buffers.links)
        + size_of_val(buffers.heads)
        + size_of_val(buffers.accelerations)
        + size_of_val(buffers.calendar)
}

/// What a world takes for each grain.
///
/// # Units
/// Bytes.
pub fn world_bytes_per_grain(dimension: usize) -> usize {
    const MANY: usize = 1024;
    let bytes = match dimension {
        1 => borrowed(&mut HeapMemory::<f64, 1>::with_capacity(MANY)),
        2 => borrowed(&mut HeapMemory::<f64, 2>::with_capacity(MANY)),
        _ => borrowed(&mut HeapMemory::<f64, 3>::with_capacity(MANY)),
    };
    bytes / MANY
}

/// The memory that a program could still have; none where the system does not say.
///
/// # Units
/// Bytes.
pub fn available_memory() -> Option<u64> {
    let account = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = account.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

#[cfg(test)]
mod tests {
    use super::available_memory;

    /// A system that says how much there is has more than a megabyte and less than an exabyte.
    #[test]
    fn memory_is_counted_in_bytes() {
        if let Some(bytes) = available_memory() {
            assert!((1 << 20..1 << 60).contains(&bytes), "{bytes}");
        }
    }
}
