//! Which of two `f32` is the larger without a floating-point unit? Reads two numbers' bits; writes nothing.

use super::{INFINITE, SIGN};

/// How two numbers stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ordering {
    /// The first is the smaller.
    Below,
    /// They are equal: so are both zeros.
    Equal,
    /// The first is the larger.
    Above,
    /// One of them is no number.
    None,
}

/// Compares.
#[inline(always)]
#[must_use]
pub fn compare(a: u32, b: u32) -> Ordering {
    if a << 1 > INFINITE << 1 || b << 1 > INFINITE << 1 {
        return Ordering::None;
    }
    let [x, y] = [ordered(a), ordered(b)];
    if x < y {
        Ordering::Below
    } else if x == y {
        Ordering::Equal
    } else {
        Ordering::Above
    }
}

/// A whole number that grows with the number.
#[inline(always)]
fn ordered(x: u32) -> i32 {
    if x & SIGN == 0 { x as i32 } else { -((x & !SIGN) as i32) }
}
