//! How does C hold a world? Reads pointers and checks them; writes worlds into memory that the caller gives.
//!
//! `include/carom.h` is made from [`export`] by cbindgen; `tests/header.rs` checks that it is up to date.
//!
//! * [`export`]: what C sees, three times: worlds of disks in `float` and in `double`, of spheres in `double`.
//! * [`calls`] and [`look`]: what these functions do, in safe code.
//! * [`held`]: what lies at the start of the caller's memory.
//! * [`memory`]: the arrays behind it.
//! * [`saved`]: what a snapshot is.
//! * [`pointer`]: whether a pointer can be used.
//! * [`law`], [`types`], [`error`]: rules, structures and numbers with names.
//!
//! The unsafe code is all in this package: the engine forbids it.
#![no_std]
// They are what C calls them.
#![allow(non_camel_case_types)]

#[cfg(not(target_os = "none"))]
extern crate std;

pub mod calls;
pub mod error;
pub mod export;
pub mod held;
pub mod law;
pub mod look;
pub mod memory;
pub mod pointer;
pub mod saved;
pub mod types;

/// Nothing in the library panics, which `arduino/check.sh` sees by its symbols; Rust wants to know what would happen.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
