//! What is a square root? Reads one value; writes the nearest to its root, by `libm` or by an instruction.
//!
//! Both round correctly, so both give the same bits. Where a processor has an instruction that stable Rust reaches,
//! `libm` uses it, but for WebAssembly, where stable Rust has none for one number, only that for a register of several,
//! and for the units of microcontrollers: `carom-sqrt`.

#[cfg(not(any(
    all(target_arch = "wasm32", target_feature = "simd128"),
    all(target_arch = "arm", target_os = "none", target_abi = "eabihf")
)))]
pub(super) use libm::{sqrt, sqrtf};

#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
pub(super) use {carom_sqrt::sqrtf, libm::sqrt};

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
