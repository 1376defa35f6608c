//! How does a processor without a floating-point unit add, multiply and divide `f32`? Reads two numbers' bits; writes those of the result.
//!
//! IEEE 754, to the nearest, ties to even, subnormal numbers included: the same bits as a unit gives. The routines of
//! `compiler-builtins` are generic over the width of numbers; these know that they have 32 bits, and that a Cortex-M0
//! multiplies 32 bits by 32 to 32 and neither divides nor counts leading zeros.
#![cfg_attr(not(test), no_std)]

mod compare;
#[cfg(target_os = "none")]
mod exported;

pub use compare::{Ordering, compare};

const SIGN: u32 = 1 << 31;
const INFINITE: u32 = 0xFF << 23;
const NAN: u32 = INFINITE | 1 << 22;
/// The leading digit, which is not written.
const LEADING: u32 = 1 << 23;
const DIGITS: u32 = LEADING - 1;
/// The leading digit where eight bits are kept below the last place, for rounding.
const TOP: u32 = 1 << 31;

/// The sum.
#[inline(always)]
#[must_use]
pub fn add(a: u32, b: u32) -> u32 {
    // Without the signs the larger one first.
    let (x, y) = if a << 1 >= b << 1 { (a, b) } else { (b, a) };
    let (exponent, below) = (exponent(x), exponent(y));
    if below == 0 || exponent == 255 {
        // Many numbers are zero: components along walls, and of gravity.
        let is_plain = y << 1 == 0 && is_normal(x);
        return if is_plain { x } else { add_special(x, y) };
    }
    let shift = (exponent - below) as u32;
    if shift > 25 {
        return x;
    }
    sum(x, exponent, (x << 8 | TOP, shifted(y << 8 | TOP, shift)), y)
}

/// Digits moved down. What is shifted out stays as one bit; eight bits there are for it.
#[inline(always)]
fn shifted(n: u32, shift: u32) -> u32 {
    if shift <= 8 {
        return n >> shift;
    }
    n >> shift | u32::from(n << (32 - shift) != 0)
}

/// The sum of x and y, whose digits are m and, moved to the place of x's, n.
#[inline(always)]
fn sum(x: u32, mut exponent: i32, (m, n): (u32, u32), y: u32) -> u32 {
    if ((x ^ y) as i32) >= 0 {
        let (sum, carry) = m.overflowing_add(n);
        return match carry {
            true => rounded(x & SIGN, exponent + 1, sum >> 1 | sum & 1 | TOP),
            false => packed(x & SIGN, exponent, sum),
        };
    }
    let mut m = m - n;
    if m == 0 {
        return 0;
    }
    while m >> 24 == 0 && exponent > 8 {
        (m, exponent) = (m << 8, exponent - 8);
    }
    while (m as i32) > 0 && exponent > 1 {
        (m, exponent) = (m << 1, exponent - 1);
    }
    packed(x & SIGN, exponent, m)
}

/// The same where the larger, x, is not finite, or the smaller is zero or subnormal.
#[cold]
#[inline(never)]
fn add_special(x: u32, y: u32) -> u32 {
    if exponent(x) == 255 {
        let is_nan = x & DIGITS != 0 || x ^ y == SIGN;
        return if is_nan { NAN } else { x };
    }
    if x << 1 == 0 {
        // Two zeros.
        return x & y;
    }
    let ((exponent, m), (below, n)) = (parts(x), parts(y));
    let shift = (exponent - below) as u32;
    if shift > 25 {
        return x;
    }
    // Subnormal digits have no leading one: the sum of two may get it, and carries nothing further.
    sum(x, exponent, (m, shifted(n, shift)), y)
}

/// The difference.
#[inline(always)]
#[must_use]
pub fn subtract(a: u32, b: u32) -> u32 {
    add(a, b ^ SIGN)
}

/// The product.
#[inline(always)]
#[must_use]
pub fn multiply(a: u32, b: u32) -> u32 {
    let sign = (a ^ b) & SIGN;
    if !(is_normal(a) && is_normal(b)) {
        let is_plain = a << 1 == 0 && is_finite(b) || b << 1 == 0 && is_finite(a);
        return if is_plain { sign } else { multiply_special(sign, a & !SIGN, b & !SIGN) };
    }
    product(sign, (exponent(a), a & DIGITS | LEADING), (exponent(b), b & DIGITS | LEADING))
}

/// The quotient.
#[inline(always)]
#[must_use]
pub fn divide(a: u32, b: u32) -> u32 {
    let sign = (a ^ b) & SIGN;
    if !(is_normal(a) && is_normal(b)) {
        return divide_special(sign, a & !SIGN, b & !SIGN);
    }
    quotient(sign, (exponent(a), a & DIGITS | LEADING), (exponent(b), b & DIGITS | LEADING))
}

#[inline(always)]
fn exponent(x: u32) -> i32 {
    (x >> 23 & 0xFF) as i32
}

/// Neither zero nor subnormal, infinite or NaN.
#[inline(always)]
fn is_normal(x: u32) -> bool {
    (exponent(x) - 1) as u32 <= 253
}

#[inline(always)]
fn is_finite(x: u32) -> bool {
    exponent(x) != 255
}

/// The exponent, 1 for subnormal numbers, and the digits with eight bits below.
#[inline(always)]
fn parts(x: u32) -> (i32, u32) {
    match exponent(x) {
        0 => (1, x << 8 & !TOP),
        exponent => (exponent, x << 8 | TOP),
    }
}

/// The number with these digits, of which eight bits are below the last place.
#[inline(always)]
fn packed(sign: u32, exponent: i32, m: u32) -> u32 {
    let (digits, below) = (m >> 8, m & 0xFF);
    let up = (below + (digits & 1) + 0x7F) >> 8;
    // The leading digit counts the exponent up by one; a carry out of the digits does, too.
    sign | ((((exponent - 1) as u32) << 23) + digits + up)
}

/// The same where the exponent may be too large.
#[inline(always)]
fn rounded(sign: u32, exponent: i32, m: u32) -> u32 {
    if exponent >= 255 { sign | INFINITE } else { packed(sign, exponent, m) }
}

/// The same where it may be too small, too: then the number is subnormal.
#[inline(always)]
fn rounded_from_below(sign: u32, exponent: i32, m: u32) -> u32 {
    if (exponent - 1) as u32 <= 253 { packed(sign, exponent, m) } else { beyond(sign, exponent, m) }
}

#[cold]
#[inline(never)]
fn beyond(sign: u32, exponent: i32, m: u32) -> u32 {
    if exponent >= 255 {
        return sign | INFINITE;
    }
    let shift = (1 - exponent) as u32;
    let m = if shift < 32 { m >> shift | u32::from(m << (32 - shift) != 0) } else { 1 };
    packed(sign, 1, m)
}

#[inline(always)]
fn product(sign: u32, (p, a): (i32, u32), (q, b): (i32, u32)) -> u32 {
    let (mut m, low) = wide_product(a, b);
    let mut exponent = p + q - 126;
    if (m as i32) >= 0 {
        (m, exponent) = (m << 1, exponent - 1);
    }
    // What is below only says on which side of the middle the product lies.
    rounded_from_below(sign, exponent, m | u32::from(low != 0))
}

/// The product of two numbers of 24 bits: without its lower 16 bits, and something that is zero if those are.
#[inline(always)]
fn wide_product(a: u32, b: u32) -> (u32, u32) {
    if cfg!(target_arch = "arm") { product_of_parts(a, b) } else { product_of_64_bits(a, b) }
}

#[inline(always)]
fn product_of_parts(a: u32, b: u32) -> (u32, u32) {
    let low = (a & 0xFFFF) * (b & 0xFFFF);
    (a * (b >> 16) + (a >> 16) * (b & 0xFFFF) + (low >> 16), low << 16)
}

#[inline(always)]
fn product_of_64_bits(a: u32, b: u32) -> (u32, u32) {
    let all = u64::from(a) * u64::from(b);
    ((all >> 16) as u32, (all as u32) << 16)
}

#[inline(always)]
fn quotient(sign: u32, (p, mut a): (i32, u32), (q, b): (i32, u32)) -> u32 {
    let mut exponent = p - q + 127;
    if a < b {
        (a, exponent) = (a << 1, exponent - 1);
    }
    let (digits, rest) = divided(a, b);
    rounded_from_below(sign, exponent, digits << 5 | u32::from(rest != 0))
}

/// a·2²⁶/b of two numbers with b ≤ a < 2 b, and what is left.
#[inline(always)]
fn divided(a: u32, b: u32) -> (u32, u32) {
    if cfg!(target_arch = "arm") { divided_by_reciprocal(a, b) } else { divided_by_parts(a, b) }
}

/// Where the processor does not divide: thirteen digits at a time, by a reciprocal that is too small.
#[inline(always)]
fn divided_by_reciprocal(a: u32, b: u32) -> (u32, u32) {
    // Of b the first sixteen digits, rounded up; their reciprocal times 2³¹ from a line by two of Newton's steps,
    // all rounded down: too small by less than a part in 8,000.
    let upper = (b >> 8) + 1;
    let newton = |r: u32| (r * (0_u32.wrapping_sub(upper * r) >> 16)) >> 15;
    let reciprocal = newton(newton(95_492 - upper));
    let (mut digits, mut rest) = (1, a - b);
    for _ in 0..2 {
        let mut part = ((rest >> 8) * reciprocal) >> 18;
        rest = (rest << 13).wrapping_sub(part * b);
        while rest >= b {
            (part, rest) = (part + 1, rest - b);
        }
        digits = digits << 13 | part;
    }
    (digits, rest)
}

/// The same where the processor divides: eight digits at a time.
#[inline(always)]
fn divided_by_parts(a: u32, b: u32) -> (u32, u32) {
    let (mut digits, mut rest) = (1, a - b);
    for bits in [8, 8, 8, 2] {
        let part = (rest << bits) / b;
        (digits, rest) = (digits << bits | part, (rest << bits) - part * b);
    }
    (digits, rest)
}

/// A finite number above zero with its leading digit where it is in normal ones.
fn normalised(x: u32) -> (i32, u32) {
    if is_normal(x) {
        return (exponent(x), x & DIGITS | LEADING);
    }
    let (mut exponent, mut m) = (1, x);
    while m < LEADING {
        (m, exponent) = (m << 1, exponent - 1);
    }
    (exponent, m)
}

#[cold]
#[inline(never)]
fn multiply_special(sign: u32, a: u32, b: u32) -> u32 {
    match (a.max(b), a.min(b)) {
        (INFINITE, 1..) => sign | INFINITE,
        (INFINITE.., _) => NAN,
        (_, 0) => sign,
        _ => product(sign, normalised(a), normalised(b)),
    }
}

#[cold]
#[inline(never)]
fn divide_special(sign: u32, a: u32, b: u32) -> u32 {
    match (a, b) {
        (INFINITE, ..INFINITE) | (1..INFINITE, 0) => sign | INFINITE,
        (..INFINITE, INFINITE) | (0, 1..INFINITE) => sign,
        (1..INFINITE, 1..INFINITE) => quotient(sign, normalised(a), normalised(b)),
        _ => NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of every kind: any bits, few digits, exponents near each other, and the ends of all ranges.
    fn numbers(state: &mut u64) -> [u32; 2] {
        let mut next = || {
            *state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (*state >> 32) as u32
        };
        let kind = next() % 6;
        let ends = [0, 1, DIGITS, LEADING, LEADING | 1, INFINITE - 1, INFINITE, NAN, 127 << 23];
        let mut number = || {
            let bits = next();
            match kind {
                0 => bits,
                1 => bits & (SIGN | 7 << 23 | DIGITS) | 124 << 23,
                2 => bits & (SIGN | 1 << 23 | 7 << 20 | 7) | 126 << 23,
                3 => ends[(bits % 9) as usize] | next() & SIGN,
                4 => bits & (SIGN | 31 << 23 | DIGITS) | if bits & 1 == 0 { 0 } else { 96 << 23 },
                _ => {
                    bits & (SIGN | 3 << 23 | DIGITS)
                        | [0, 63 << 23, 190 << 23, 252 << 23][(bits % 4) as usize]
                }
            }
        };
        [number(), number()]
    }

    #[test]
    fn both_ways_of_each_processor_are_one() {
        let mut state = 2;
        for _ in 0..1_000_000 {
            let [a, b] = numbers(&mut state).map(|x| x & DIGITS | LEADING);
            assert_eq!(product_of_parts(a, b), product_of_64_bits(a, b));
            let (a, b) = (a.max(b), a.min(b));
            let whole = (u64::from(a) << 26) / u64::from(b);
            let rest = (u64::from(a) << 26) % u64::from(b);
            assert_eq!(divided_by_reciprocal(a, b), (whole as u32, rest as u32));
            assert_eq!(divided_by_parts(a, b), (whole as u32, rest as u32));
        }
    }

    #[test]
    fn every_bit_is_that_of_the_units() {
        let mut state = 1;
        let same = |mine: u32, units: f32| {
            mine == units.to_bits() || units.is_nan() && f32::from_bits(mine).is_nan()
        };
        for _ in 0..20_000_000 {
            let [a, b] = numbers(&mut state);
            let [x, y] = [a, b].map(f32::from_bits);
            assert!(same(add(a, b), x + y), "{a:x} + {b:x}");
            assert!(same(subtract(a, b), x - y), "{a:x} - {b:x}");
            assert!(same(multiply(a, b), x * y), "{a:x} * {b:x}");
            assert!(same(divide(a, b), x / y), "{a:x} / {b:x}");
            let ordered = match compare(a, b) {
                Ordering::Below => x < y,
                Ordering::Equal => x == y,
                Ordering::Above => x > y,
                Ordering::None => x.is_nan() || y.is_nan(),
            };
            assert!(ordered, "{a:x}, {b:x}");
        }
    }
}
