//! How does C keep a world, and what does it hear of an error? Reads the world; writes memory of C.

/// Snapshots and texts of errors of one kind of world.
macro_rules! keep {
    ($kind:ident, $s:ident, $d:literal) => {
        paste! {
            /// How many bytes a snapshot of this world takes.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _saved_bytes>](
                world: *mut [<carom_world $kind>],
                bytes: *mut usize,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(bytes, || held.saved_bytes())) }
            }

            /// Writes a snapshot of the world into this memory, which has CAROM_ALIGNMENT, too. Another run of the
            /// program cannot read it.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _save>](
                world: *mut [<carom_world $kind>],
                memory: *mut core::ffi::c_void,
                bytes: usize,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.save(memory.cast(), bytes)) }
            }

            /// Brings this world into the state of a snapshot, of this world or another; it goes on with the same bits.
            /// It must have places for as many grains and planes.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _restore>](
                world: *mut [<carom_world $kind>],
                saved: *const core::ffi::c_void,
            ) -> carom_error {
                // SAFETY: the caller's promise; a world begins where its memory does.
                unsafe {
                    on::<$s, $d, _>(world, |held| held.restore(world.cast(), saved.cast()))
                }
            }

            /// Writes the text of this world's last error, in words: which field is wrong, its value, and what would be
            /// right. It ends with a zero; what does not fit into so many bytes, at least one, is left out. Empty if
            /// there was no error.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _error_text>](
                world: *mut [<carom_world $kind>],
                text: *mut c_char,
                bytes: usize,
            ) -> carom_error {
                // SAFETY: the caller's promise; there is at least one byte.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        check(text)?;
                        if bytes == 0 {
                            return Err(carom_error::CAROM_ERROR_LENGTH);
                        }
                        write_text(text, bytes, held.error);
                        Ok(())
                    })
                }
            }
        }
    };
}
pub(super) use keep;
