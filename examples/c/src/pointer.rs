//! Can this pointer be used? Reads its address; what it points to is the caller's promise.

use crate::error::carom_error;

/// A pointer that is not null and has the alignment of what it points to.
///
/// # Errors
/// The code of what it is.
pub fn check<T>(pointer: *const T) -> Result<(), carom_error> {
    if pointer.is_null() {
        return Err(carom_error::CAROM_ERROR_NULL);
    }
    if pointer.is_aligned() { Ok(()) } else { Err(carom_error::CAROM_ERROR_MISALIGNED) }
}

/// What it points to.
///
/// # Errors
/// As [`check`].
///
/// # Safety
/// Not null and aligned, it points to a `T` that can be read.
pub unsafe fn read<T: Copy>(from: *const T) -> Result<T, carom_error> {
    check(from)?;
    // SAFETY: checked, and the caller's promise.
    Ok(unsafe { from.read() })
}

/// Writes what a call came to, if it came to something: an error writes nothing.
///
/// # Errors
/// As [`check`]; the call is not made then. Else as the call.
///
/// # Safety
/// Not null and aligned, it points to a place for a `T` that can be written.
pub unsafe fn write<T>(
    to: *mut T,
    call: impl FnOnce() -> Result<T, carom_error>,
) -> Result<(), carom_error> {
    check(to)?;
    let value = call()?;
    // SAFETY: checked, and the caller's promise.
    unsafe { to.write(value) };
    Ok(())
}

/// Writes one number after the other.
///
/// # Errors
/// As [`check`], and [`carom_error::CAROM_ERROR_LENGTH`] if there is not a place for each.
///
/// # Safety
/// Not null and aligned, it points to `length` places that can be written.
pub unsafe fn write_all<T>(
    to: *mut T,
    length: usize,
    values: impl ExactSizeIterator<Item = T>,
) -> Result<(), carom_error> {
    check(to)?;
    if values.len() > length {
        return Err(carom_error::CAROM_ERROR_LENGTH);
    }
    for (i, value) in values.take(length).enumerate() {
        // SAFETY: i < length, and the caller's promise.
        unsafe { to.add(i).write(value) };
    }
    Ok(())
}
