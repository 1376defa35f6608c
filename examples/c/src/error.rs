//! What can go wrong, in one number? Reads the engine's errors; writes codes, their names and what they mean.

use carom::Error;
use core::ffi::c_char;

/// Codes, their names and meanings, in one list.
macro_rules! codes {
    ($(#[doc = $doc:literal] $name:ident = $number:literal,)*) => {
        /// What a call says: CAROM_OK, or why nothing was done.
        #[repr(i32)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum carom_error {
            $(#[doc = $doc] $name = $number,)*
        }

        /// Every code.
        pub const CODES: &[carom_error] = &[$(carom_error::$name),*];

        fn words(code: i32) -> [&'static str; 2] {
            match code {
                $($number => [concat!(stringify!($name), "\0"), concat!($doc, "\0")],)*
                _ => ["unknown\0", "not a code of carom\0"],
            }
        }
    };
}

codes! {
    /// It is done.
    CAROM_OK = 0,
    /// A pointer is NULL.
    CAROM_ERROR_NULL = 1,
    /// A pointer has not the alignment of what it points to; the memory of a world has CAROM_ALIGNMENT.
    CAROM_ERROR_MISALIGNED = 2,
    /// The memory is too small for so many grains and planes, or for a snapshot.
    CAROM_ERROR_MEMORY = 3,
    /// The pointer is that of no world, or snapshot, of this kind.
    CAROM_ERROR_NO_WORLD = 4,
    /// The world has not been started yet.
    CAROM_ERROR_NOT_STARTED = 5,
    /// The world has been started: it cannot be described any longer.
    CAROM_ERROR_STARTED = 6,
    /// There is no grain of this number.
    CAROM_ERROR_INDEX = 7,
    /// The array is too short.
    CAROM_ERROR_LENGTH = 8,
    /// The library was built without this table.
    CAROM_ERROR_TABLE = 9,
    /// A number cannot be what it is: the text of the error says which, and what would be right.
    CAROM_ERROR_INPUT = 10,
    /// There is no place for another grain or plane.
    CAROM_ERROR_FULL = 11,
    /// Two grains, or a grain and a plane, overlap at the start.
    CAROM_ERROR_OVERLAP = 12,
    /// A collision lies outside the table's domain.
    CAROM_ERROR_OUTSIDE_TABLE = 13,
    /// The contact time is so long that a grain at rest would sink in by more than a twentieth of its radius.
    CAROM_ERROR_LONG_CONTACT = 14,
    /// The law gave something that is not the outcome of a collision.
    CAROM_ERROR_OUTCOME = 15,
    /// Too many events at one instant.
    CAROM_ERROR_STUCK = 16,
    /// A grain's state has left the range of its number.
    CAROM_ERROR_NOT_FINITE = 17,
    /// The time asked for lies in the past.
    CAROM_ERROR_PAST = 18,
    /// A number does not fit the fixed-point type. No world of this library has one.
    CAROM_ERROR_OVERFLOW = 19,
    /// The library was built without this mode, or there is none of this number.
    CAROM_ERROR_MODE = 20,
    /// Another error: the text says which.
    CAROM_ERROR_OTHER = 21,
}

/// The code of an error of the engine: the engine's own number.
#[must_use]
pub fn code(error: &Error) -> carom_error {
    let number = usize::from(error.code());
    CODES.get(number).copied().unwrap_or(carom_error::CAROM_ERROR_OTHER)
}

/// The code of what a call came to.
#[must_use]
pub fn told(result: Result<(), carom_error>) -> carom_error {
    result.err().unwrap_or(carom_error::CAROM_OK)
}

/// The name of a code, such as "CAROM_ERROR_NULL": a text that is always there.
#[unsafe(no_mangle)]
pub extern "C" fn carom_error_name(error: i32) -> *const c_char {
    let [name, _] = words(error);
    name.as_ptr().cast()
}

/// What a code means, in one sentence: a text that is always there.
#[unsafe(no_mangle)]
pub extern "C" fn carom_error_meaning(error: i32) -> *const c_char {
    let [_, meaning] = words(error);
    meaning.as_ptr().cast()
}
