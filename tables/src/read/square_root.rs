//! What is a square root? Reads one value; writes the nearest to its root, by `libm` or by an instruction.
//!
//! Both round correctly, so both give the same bits. Where a processor has an instruction that stable Rust reaches,
//! `libm` uses it, but for WebAssembly, where stable Rust has none for one number, only that for a register of several,
//! and for the units of microcontrollers: `carom-sqrt`. Where there is no unit `libm` multiplies 32 bits by 32 to 64, which
//! a Cortex-M0 does in pieces; digit by digit is three times as fast there.

#[cfg(not(any(
    all(target_arch = "wasm32", target_feature = "simd128"),
    all(target_arch = "arm", target_os = "none"),
    all(target_arch = "riscv32", target_os = "none", not(target_feature = "f"))
)))]
pub(super) use libm::{sqrt, sqrtf};

#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
pub(super) use {carom_sqrt::sqrtf, libm::sqrt};

#[cfg(any(
    all(target_arch = "arm", target_os = "none", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", target_os = "none", not(target_feature = "f"))
))]
pub(super) use {by_digits::sqrtf, libm::sqrt};

#[cfg(any(
    test,
    all(target_arch = "arm", target_os = "none", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", target_os = "none", not(target_feature = "f"))
))]
mod by_digits {
    /// The root, a binary digit in each step and one to round by.
    #[inline(never)]
    pub fn sqrtf(x: f32) -> f32 {
        let bits = x.to_bits();
        if !(f32::MIN_POSITIVE..=f32::MAX).contains(&x) {
            return special(x);
        }
        let exponent = (bits >> 23) as i32 - 127;
        // Four, or two, times the digits: below the root's square there is room for twice its digits.
        let mut rest = ((bits & 0x7F_FFFF) | 0x80_0000) << (1 + (exponent & 1));
        // As if nobody knew how often: as a loop it is a tenth as long.
        let (mut root, mut twice, mut digit) = (0_u32, 0_u32, core::hint::black_box(1_u32 << 24));
        while digit != 0 {
            let least = twice + digit;
            if least <= rest {
                (twice, rest, root) = (least + digit, rest - least, root + digit);
            }
            (rest, digit) = (rest << 1, digit >> 1);
        }
        // Never halfway: a root of so few digits has a square of as many.
        f32::from_bits((root + (root & 1)) / 2 + ((((exponent >> 1) + 126) as u32) << 23))
    }

    #[cold]
    fn special(x: f32) -> f32 {
        if x == 0.0 || x == f32::INFINITY {
            x
        } else if x > 0.0 {
            // Subnormal: 2²⁴ times as large.
            sqrtf(x * 16_777_216.0) * (1.0 / 4096.0)
        } else {
            f32::NAN
        }
    }

    #[test]
    fn every_root_is_the_units() {
        let same = |x: f32| {
            let (mine, units) = (sqrtf(x), libm::sqrtf(x));
            assert!(mine.to_bits() == units.to_bits() || mine.is_nan() && units.is_nan(), "{x:e}");
        };
        let ends = [0.0, -0.0, 1.0, 2.0, 4.0, f32::MAX, f32::INFINITY, f32::NAN, -1.0, 1e-45];
        ends.into_iter().for_each(same);
        (0..u32::MAX).step_by(4_001).for_each(|bits| same(f32::from_bits(bits)));
        // All digits of two exponents.
        (0x3F80_0000..0x4080_0000).step_by(17).for_each(|bits| same(f32::from_bits(bits)));
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub(super) use register::{sqrt, sqrtf};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod register {
    use core::arch::wasm32::{
        f32x4_extract_lane, f32x4_splat, f32x4_sqrt, f64x2_extract_lane, f64x2_splat, f64x2_sqrt,
    };

    #[inline]
    pub fn sqrt(x: f64) -> f64 {
        f64x2_extract_lane::<0>(f64x2_sqrt(f64x2_splat(x)))
    }

    #[inline]
    pub fn sqrtf(x: f32) -> f32 {
        f32x4_extract_lane::<0>(f32x4_sqrt(f32x4_splat(x)))
    }
}
