//! What is a square root where a floating-point unit has an instruction for it? Reads one `f32`; writes the nearest to its root.
//!
//! Empty but on Arm without an operating system and with floating-point registers.
#![no_std]

/// The square root, correctly rounded: the same bits as software gives. NaN of what is below zero.
///
/// Stable Rust reaches the instruction by inline assembly alone, and has no name for a floating-point register
/// there (its class wants a target feature, `vfp2`, that these targets do not say they have). So one is
/// borrowed and given back.
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
#[inline(always)]
#[must_use]
pub fn sqrtf(x: f32) -> f32 {
    let root: u32;
    // SAFETY: only the two operands and the flags of the unit change: s0 holds afterwards what it held before,
    // memory and stack are not touched, and every such target has the instruction.
    unsafe {
        core::arch::asm!(
            "vmov {kept}, s0",
            "vmov s0, {x}",
            "vsqrt.f32 s0, s0",
            "vmov {x}, s0",
            "vmov s0, {kept}",
            x = inout(reg) x.to_bits() => root,
            kept = out(reg) _,
            options(pure, nomem, nostack),
        );
    }
    f32::from_bits(root)
}
