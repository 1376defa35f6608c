//! How many components has a vector? Reads three numbers; writes as many of them as a world has dimensions.

/// The first `D` of three numbers.
pub(super) fn first<const D: usize>(numbers: &[f64; 3]) -> [f64; D] {
    std::array::from_fn(|k| numbers[k])
}
