//! What are square root, quotient, sine and logarithm of integers? Reads bits and the number of fraction bits; writes bits, no float is used.
//!
//! Every function says how far its answer is from the exact one, in units of the last place (ulp).

/// 1.0 with 62 bits after the point, the inner format of the transcendental functions.
const ONE: i64 = 1 << 62;
/// π/2 with 94 bits after the point: 2⁻⁹⁵ · 2³¹ quarter turns stay below 2⁻⁶⁴.
const HALF_PI: i128 = 0x6487_ed51_10b4_611a_6263_3146;
/// 2/π and ln 2 with 62 bits.
const TWO_OVER_PI: i128 = 0x28be_60db_9391_054a;
const LN_2: i128 = 0x2c5c_85fd_f473_de6b;
/// 2^(−1/10), 2^(−3/10), … 2^(−9/10) with 62 bits.
const TENTHS: [i64; 5] = [
    4_302_855_201_801_774_107,
    3_745_853_019_710_192_356,
    3_260_954_456_333_195_553,
    2_838_825_738_843_869_635,
    2_471_341_346_050_066_508,
];
/// 1/(2·3), 1/(4·5), … 1/(16·17): the factors of the sine's series.
const SINE: [i64; 8] = inverses(2);
/// 1/(1·2), 1/(3·4), … 1/(15·16): the factors of the cosine's series.
const COSINE: [i64; 8] = inverses(1);

/// ⌊√n⌋, digit by digit.
pub(super) fn isqrt(n: u128) -> u64 {
    if let Ok(short) = u64::try_from(n) {
        return u64::from(isqrt_u64(short));
    }
    let (mut rest, mut root) = (n, 0_u128);
    let mut bit = 1_u128 << ((127 - n.leading_zeros()) & !1);
    while bit != 0 {
        let trial = root + bit;
        root >>= 1;
        if rest >= trial {
            rest -= trial;
            root += bit;
        }
        bit >>= 2;
    }
    root as u64
}

/// ⌊√n⌋ of 64 bits.
fn isqrt_u64(n: u64) -> u32 {
    let (mut rest, mut root) = (n, 0_u64);
    let mut bit = 1_u64 << ((63 - (n | 1).leading_zeros()) & !1);
    while bit != 0 {
        let trial = root + bit;
        root >>= 1;
        if rest >= trial {
            rest -= trial;
            root += bit;
        }
        bit >>= 2;
    }
    root as u32
}

/// √n to the nearest whole number.
pub(super) fn rounded_sqrt(n: u128) -> u64 {
    let floor = isqrt(n);
    // (floor + 1/2)² lies between floor² + floor and the next whole number.
    let up = n - u128::from(floor) * u128::from(floor) > u128::from(floor);
    floor.saturating_add(u64::from(up))
}

/// n 2^shift / d to the nearest whole number, halves up; none if d is 0 or the result has more than 63 bits.
pub fn quotient(n: u128, d: u128, shift: u32) -> Option<i64> {
    if d == 0 || d >> 127 != 0 {
        return None;
    }
    let free = n.leading_zeros().min(shift);
    let (mut q, mut rest) = div_rem(n << free, d);
    for _ in free..shift {
        if q >> 63 != 0 {
            return None;
        }
        (q, rest) = (q << 1, rest << 1);
        if rest >= d {
            (q, rest) = (q | 1, rest - d);
        }
    }
    i64::try_from(q + u128::from(rest >= d - rest)).ok()
}

fn div_rem(n: u128, d: u128) -> (u128, u128) {
    if let (Ok(n), Ok(d)) = (u64::try_from(n), u64::try_from(d)) {
        return (u128::from(n / d), u128::from(n % d));
    }
    (n / d, n % d)
}

/// A product of 256 bits: high and low half.
fn widening_mul(a: u128, b: u128) -> (u128, u128) {
    let low = |x: u128| x & u128::from(u64::MAX);
    let (a1, a0, b1, b0) = (a >> 64, low(a), b >> 64, low(b));
    let lowest = a0 * b0;
    let (middle, wrapped) = (a1 * b0).overflowing_add(a0 * b1);
    let (sum, carried) = lowest.overflowing_add(middle << 64);
    let high = a1 * b1 + (middle >> 64) + (u128::from(wrapped) << 64) + u128::from(carried);
    (high, sum)
}

/// √(b² − a c) where that is above zero, to 2⁻⁶³ of itself; none where it is not.
///
/// The square and the product are exact, with 256 bits.
pub fn root_of_difference(b: u128, a: u128, c: u128) -> Option<u128> {
    let bits = |x: u128| 128 - x.leading_zeros();
    if 2 * bits(b) + 2 <= bits(a) + bits(c) {
        return None;
    }
    let ((high, low), (high_ac, low_ac)) = (widening_mul(b, b), widening_mul(a, c));
    if (high, low) <= (high_ac, low_ac) {
        return None;
    }
    let (low, borrow) = low.overflowing_sub(low_ac);
    let high = high - high_ac - u128::from(borrow);
    if high == 0 {
        return Some(rounded_sqrt_u128(low));
    }
    let half = (129 - high.leading_zeros()) / 2;
    if half == 64 {
        return Some(u128::from(isqrt(high)) << 64);
    }
    let top = (high << (128 - 2 * half)) | (low >> (2 * half));
    Some(u128::from(isqrt(top)) << half)
}

/// √n of 128 bits, to the nearest whole number.
fn rounded_sqrt_u128(n: u128) -> u128 {
    u128::from(rounded_sqrt(n))
}

/// a b of two numbers with 62 bits after the point.
fn times(a: i64, b: i64) -> i64 {
    ((i128::from(a) * i128::from(b)) >> 62) as i64
}

/// 1 / (n (n+1)), and so on for every second n, with 62 bits.
const fn inverses(mut n: i64) -> [i64; 8] {
    let mut all = [0; 8];
    let mut i = 0;
    while i < 8 {
        all[i] = ONE / (n * (n + 1));
        n += 2;
        i += 1;
    }
    all
}

/// 1 − s c₁ (1 − s c₂ (1 − …)).
fn series(s: i64, factors: &[i64; 8]) -> i64 {
    factors.iter().rev().fold(ONE, |sum, &c| ONE - times(times(s, c), sum))
}

/// Sine and cosine of x (in radians, `fraction` bits after the point), in the same steps.
///
/// Within 0.5 ulp + 2⁻⁵⁶, that is, the nearest value except where two are equally near to 2⁻⁵⁶.
pub(super) fn sin_cos(x: i64, fraction: u32) -> (i64, i64) {
    let wide = i128::from(x) << (94 - fraction);
    let turns = (((i128::from(x) * TWO_OVER_PI) >> (61 + fraction)) + 1) >> 1;
    let r = ((wide - turns * HALF_PI) >> 32) as i64;
    let s = times(r, r);
    let (sine, cosine) = (times(series(s, &SINE), r), series(s, &COSINE));
    let [sine, cosine] = [sine, cosine].map(|y| (y + (1 << (61 - fraction))) >> (62 - fraction));
    match turns & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// (x₁ x₂ …)^(−1/5) of numbers above zero with `fraction` bits after the point, in the same steps.
///
/// The product has 62 bits however large or small it is. Within 0.51 ulp; none if it does not fit.
pub(super) fn inverse_fifth_root(factors: &[i64], fraction: u32) -> Option<i64> {
    // The product is m 2^power with m in [1, 2).
    let (mut m, mut power) = (ONE, 0_i32);
    for &x in factors {
        let x = u64::try_from(x).ok().filter(|&x| x > 0)?;
        let free = x.leading_zeros();
        power += 63 - free as i32 - fraction as i32;
        let product = (u128::from(x << free) * m as u128) >> 62;
        let carry = (product >> 64) as u32;
        power += carry as i32;
        m = (product >> (1 + carry)) as i64;
    }
    let (fifth, rest) = (power.div_euclid(5), power.rem_euclid(5));
    // y is 2^(−(rest + 1/2)/5) to 7 %, and each round cubes its error.
    // There are five; an index would leave a panic in small images.
    let mut y = TENTHS.get(rest as usize).copied().unwrap_or(ONE);
    for _ in 0..4 {
        let y2 = times(y, y);
        let y5 = times(times(y2, y2), y);
        let r = ONE - (((i128::from(m) * i128::from(y5)) >> (62 - rest)) as i64);
        y += times(times(y, r), ONE / 5 + times(r, ONE / 25 * 3));
    }
    let shift = 62 - fraction as i32 + fifth;
    match u32::try_from(shift) {
        Ok(0) => Some(y),
        Ok(shift) if shift < 63 => Some((y + (1 << (shift - 1))) >> shift),
        Ok(_) => Some(0),
        Err(_) => None,
    }
}

/// ∛n to the nearest whole number.
pub(super) fn rounded_cbrt(n: u128) -> i64 {
    let (mut rest, mut root) = (n, 0_u128);
    for digit in (0..=126).rev().step_by(3) {
        root <<= 1;
        let step = 3 * root * (root + 1) + 1;
        if rest >> digit >= step {
            rest -= step << digit;
            root += 1;
        }
    }
    // (root + 1/2)³ − root³ = (6 root² + 3 root + 1/2)/4.
    (root + u128::from(4 * rest > 6 * root * root + 3 * root)) as i64
}

/// ln(1 + x) for x ≥ 0 with `fraction` bits after the point, in the same steps; within 0.6 ulp.
pub(super) fn ln_1p(x: i64, fraction: u32) -> i64 {
    let y = x.unsigned_abs() + (1 << fraction);
    let top = 63 - y.leading_zeros();
    // The mantissa with 62 bits; each squaring gives one binary digit of its logarithm.
    let mut m = if top <= 62 { y << (62 - top) } else { y >> 1 };
    let mut log2 = i128::from(top) - i128::from(fraction);
    for _ in 0..fraction + 8 {
        let square = (u128::from(m) * u128::from(m)) >> 62;
        let digit = square >> 63;
        log2 = 2 * log2 + digit as i128;
        m = (square >> digit) as u64;
    }
    ((((log2 * LN_2) >> 62) + (1 << 7)) >> 8) as i64
}

/// The nearest multiple of 2^−fraction to a float given by its bits; none if it is no number or too large.
pub(super) const fn from_float(bits: u64, mantissa: u32, bias: i32, fraction: u32) -> Option<i64> {
    let exponents = 2 * bias + 1;
    let negative = bits >> (mantissa + exponents.count_ones()) != 0;
    let exponent = (bits >> mantissa) as i32 & exponents;
    let part = bits & ((1 << mantissa) - 1);
    if exponent == exponents {
        return None;
    }
    let whole = if exponent == 0 { part } else { part | 1 << mantissa };
    let place = if exponent == 0 { 1 } else { exponent } - bias - mantissa as i32;
    let shift = place + fraction as i32;
    let magnitude = if shift >= 0 {
        if shift > 62 - mantissa as i32 && whole != 0 {
            return None;
        }
        if whole == 0 { 0 } else { whole << shift }
    } else if shift < -(mantissa as i32) - 2 {
        0
    } else {
        (whole + (1 << (-shift - 1))) >> -shift
    };
    Some(if negative { -(magnitude as i64) } else { magnitude as i64 })
}

/// The bits of the `f64` nearest to x 2^−fraction; no float is computed with.
pub(super) const fn to_float(x: i64, fraction: u32) -> u64 {
    if x == 0 {
        return 0;
    }
    let sign = if x < 0 { 1 << 63 } else { 0 };
    let free = x.unsigned_abs().leading_zeros();
    let m = x.unsigned_abs() << free;
    let exponent = (1023 + 63 - free as u64 - fraction as u64) << 52;
    let part = (m >> 11) & ((1 << 52) - 1);
    let tail = m & 0x7ff;
    let up = tail > 0x400 || (tail == 0x400 && part & 1 == 1);
    sign | (exponent + part + up as u64)
}
