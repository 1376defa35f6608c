//! What lies at the start of the caller's memory? The world, its law and its last error; reads a pointer to it.

use crate::error::{carom_error, code};
use crate::law::{AnyRule, Number};
use crate::memory::{ALIGNMENT, Layout, is_aligned};
use crate::pointer::check;
use carom::world::WorldBuilder;
use carom::{Error, World};

/// How far a world has come.
pub enum State<S: Number, const D: usize> {
    /// It is being described.
    Described(WorldBuilder<'static, S, D, AnyRule<S>>),
    /// It runs.
    Started(World<'static, S, D, AnyRule<S>>),
    /// It ended in the middle of a call that was not to fail.
    Lost,
}

/// A world in the caller's memory. Its arrays follow it.
#[cfg_attr(target_pointer_width = "64", repr(align(64)))]
#[cfg_attr(not(target_pointer_width = "64"), repr(align(8)))]
pub struct Held<S: Number, const D: usize> {
    sign: u32,
    /// What grains do when they touch.
    pub rule: AnyRule<S>,
    /// How far it has come.
    pub state: State<S, D>,
    /// The last error of the engine.
    pub error: Option<Error>,
    /// Where its arrays are.
    pub layout: Layout,
}

const _: () = assert!(
    is_aligned::<Held<f32, 2>, f32, 2>()
        && is_aligned::<Held<f64, 2>, f64, 2>()
        && is_aligned::<Held<f64, 3>, f64, 3>()
);

impl<S: Number, const D: usize> Held<S, D> {
    /// What the memory of a world of this kind begins with.
    const SIGN: u32 = 0xCA20_0000 | ((D as u32) << 8) | size_of::<S>() as u32;

    /// An empty world in this memory.
    ///
    /// # Errors
    /// The code of what is wrong with the memory; nothing is written then.
    ///
    /// # Safety
    /// If `memory` is not null and aligned, `bytes` bytes can be written there, which nobody else uses as long as the
    /// world is used.
    pub unsafe fn create(
        memory: *mut u8,
        bytes: usize,
        grains: usize,
        planes: usize,
    ) -> Result<*mut Self, carom_error> {
        check(memory)?;
        if memory.addr() % ALIGNMENT != 0 {
            return Err(carom_error::CAROM_ERROR_MISALIGNED);
        }
        let layout = Layout::of::<Self, S, D>(grains, planes);
        if !layout.is_possible() || layout.bytes > bytes {
            return Err(carom_error::CAROM_ERROR_MEMORY);
        }
        // SAFETY: there are as many bytes, aligned, and the caller's promise.
        let arrays = unsafe { layout.arrays(memory) };
        let rule = AnyRule::EMPTY;
        let builder = World::builder_with(arrays).rule(rule);
        let state = State::Described(builder);
        let held = Self { sign: Self::SIGN, rule, state, error: None, layout };
        let place = memory.cast::<Self>();
        // SAFETY: the layout begins with a place for it.
        unsafe { place.write(held) };
        Ok(place)
    }

    /// The world behind a pointer.
    ///
    /// # Errors
    /// The code of what is wrong with the pointer.
    ///
    /// # Safety
    /// If it is not null and aligned, it points to memory of the size of a `Held` that can be read, and if a world of
    /// this kind is there, nobody else uses it at the same time.
    pub unsafe fn at<'a>(world: *mut Self) -> Result<&'a mut Self, carom_error> {
        check(world)?;
        // SAFETY: the memory can be read, and a sign of any bits is one.
        if unsafe { (&raw const (*world).sign).read() } != Self::SIGN {
            return Err(carom_error::CAROM_ERROR_NO_WORLD);
        }
        // SAFETY: `create` has written a world there, and the caller's promise.
        Ok(unsafe { &mut *world })
    }

    /// What an engine's answer is to C; an error is kept, for its text.
    ///
    /// # Errors
    /// The error's code.
    pub fn note<T>(&mut self, result: Result<T, Error>) -> Result<T, carom_error> {
        result.map_err(|error| {
            self.error = Some(error);
            code(&error)
        })
    }

    /// The world while it is being described.
    ///
    /// # Errors
    /// [`carom_error::CAROM_ERROR_STARTED`].
    pub fn builder(&mut self) -> Result<&mut WorldBuilder<'static, S, D, AnyRule<S>>, carom_error> {
        match &mut self.state {
            State::Described(builder) => Ok(builder),
            _ => Err(carom_error::CAROM_ERROR_STARTED),
        }
    }

    /// The world that runs.
    ///
    /// # Errors
    /// [`carom_error::CAROM_ERROR_NOT_STARTED`].
    pub fn world(&mut self) -> Result<&mut World<'static, S, D, AnyRule<S>>, carom_error> {
        match &mut self.state {
            State::Started(world) => Ok(world),
            _ => Err(carom_error::CAROM_ERROR_NOT_STARTED),
        }
    }
}
