//! What is the tilt box, whatever board it runs on? Reads an accelerometer over `embedded-hal`; draws on a display of `embedded-graphics`.
//!
//! Everything but pins and clocks: the boards' packages beside this one choose those, and the package
//! `window` shows the same box on a workstation.
//!
//! No allocator, no `unsafe`; the world lives in a `static`.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(feature = "board")]
pub mod board;
pub mod frame;
pub mod picture;
pub mod replay;
pub mod scene;
pub mod screen;
pub mod script;
pub mod sensor;
pub mod tilt;

pub use frame::{Pace, TiltBox};
pub use scene::Memory;
pub use tilt::{Axis, Mounting, Tilt};
