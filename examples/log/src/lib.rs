//! What does a logger for defmt get? Keeps the bytes of this thread's frames; a firmware's logger sends them.

use std::cell::RefCell;

thread_local! {
    static BYTES: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// A logger that keeps what it gets, each thread for itself: there is nothing to lock.
#[defmt::global_logger]
struct Kept;

// SAFETY: no interrupt comes between `acquire` and `release`, and no thread sees another's bytes.
unsafe impl defmt::Logger for Kept {
    fn acquire() {}

    unsafe fn flush() {}

    unsafe fn release() {}

    unsafe fn write(bytes: &[u8]) {
        BYTES.with_borrow_mut(|all| all.extend_from_slice(bytes));
    }
}

defmt::timestamp!("");

/// What a logger gets for this value: the numbers of two texts ("{}" and the value's own), then its fields.
pub fn frame(value: impl defmt::Format) -> Vec<u8> {
    BYTES.take();
    defmt::println!("{}", value);
    BYTES.take()
}
