//! What does C see? Reads pointers and numbers of C; calls what [`crate::calls`] and [`crate::look`] do.
//!
//! # Safety
//! In every function a pointer that is not NULL and has the alignment of what it points to must point to that: a world
//! to memory in which one was created and that has not been moved since, a number or structure to one, an array to as
//! many as the function says. One world is used by one thread at a time; different worlds have nothing in common.
#![allow(clippy::missing_safety_doc, reason = "it is the same for all, and said above")]

mod describe;
mod keep;
mod kind;
mod look;
mod run;

use crate::error::{carom_error, told};
use crate::held::Held;
use crate::look::write_text;
use crate::memory::{Layout, Promised};
use crate::pointer::{check, read, write, write_all};
use crate::types::{carom_event, carom_statistics};
use carom::Grain;
use carom::law::{LinearDashpot, Viscoelastic};
use carom::space::{Plane, Surface};
use core::ffi::c_char;
use pastey::paste;

/// The alignment that the memory of worlds and snapshots must have where pointers have 64 bits.
pub const CAROM_ALIGNMENT_64: usize = 64;
/// The same where they have 32.
pub const CAROM_ALIGNMENT_32: usize = 8;
const _: () = assert!(
    crate::memory::ALIGNMENT
        == if size_of::<usize>() == 8 { CAROM_ALIGNMENT_64 } else { CAROM_ALIGNMENT_32 }
);

/// A call on a world.
///
/// # Safety
/// As [`Held::at`].
unsafe fn on<S: crate::law::Number, const D: usize, W>(
    world: *mut W,
    call: impl FnOnce(&mut Held<S, D>) -> Result<(), carom_error>,
) -> carom_error {
    // SAFETY: the caller's promise.
    told(unsafe { Held::at(world.cast()) }.and_then(call))
}

/// All functions of one kind of world.
macro_rules! worlds {
    ($kind:ident, $KIND:ident, $s:ident, $d:literal, $what:literal, $($bits:tt: $bytes:tt),*) => {
        kind::kind!($kind, $KIND, $s, $d, $what, $($bits: $bytes),*);
        describe::describe!($kind, $s, $d);
        run::run!($kind, $s, $d);
        look::look!($kind, $s, $d);
        keep::keep!($kind, $s, $d);
    };
}

// Bytes of the world, of a grain and of a plane, with some room in the first: the compiler says when it is used up.
worlds!(_2d_f32, _2D_F32, f32, 2, "disks whose numbers are float", 32: [704, 96, 64], 64: [1024, 100, 64]);
worlds!(_2d_f64, _2D_F64, f64, 2, "disks whose numbers are double", 32: [896, 160, 128], 64: [1152, 184, 128]);
worlds!(_3d_f64, _3D_F64, f64, 3, "spheres whose numbers are double", 32: [960, 192, 136], 64: [1216, 192, 136]);
