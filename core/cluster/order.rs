//! How do a few numbers stay in order? Reads numbers of which only the last may be out of order; writes it to its place.

/// Moves the last of these numbers to its place among the others, which are in rising order.
///
/// The library's sort and insertion can panic, for orders and places that are none; a firmware carries that.
pub(crate) fn put_last_in_order(numbers: &mut [usize]) {
    for k in (1..numbers.len()).rev() {
        match numbers.get_mut(k - 1..=k) {
            Some([before, after]) if *before > *after => core::mem::swap(before, after),
            _ => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    #[test]
    fn numbers_that_come_one_by_one_end_in_order() {
        let mut numbers = Vec::new();
        for k in [5, 3, 9, 1, 7, 0, 8] {
            numbers.push(k);
            put_last_in_order(&mut numbers);
        }
        assert_eq!(numbers, [0, 1, 3, 5, 7, 8, 9]);
        put_last_in_order(&mut []);
    }
}
