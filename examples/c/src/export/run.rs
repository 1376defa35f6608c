//! How does C let time pass? Reads times; writes the world.

/// The functions that run one kind of world.
macro_rules! run {
    ($kind:ident, $s:ident, $d:literal) => {
        paste! {
            /// The description is complete: everything is checked, and the world can run. If something is wrong it can
            /// still be described, and started then.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _start>](
                world: *mut [<carom_world $kind>],
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, Held::start) }
            }

            #[doc = concat!("Gives a grain another velocity, ", $d, " numbers, now.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_velocity>](
                world: *mut [<carom_world $kind>],
                index: u32,
                velocity: *const $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| held.set_velocity(index, read(velocity.cast())?))
                }
            }

            /// One grain more, now, in the first empty place, whose number index is: CAROM_ERROR_FULL without one,
            /// CAROM_ERROR_OVERLAP where another body is. Its radius is at most the largest at the start.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _insert_grain>](
                world: *mut [<carom_world $kind>],
                grain: *const [<carom_grain $kind>],
                index: *mut u32,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        let grain = read(grain)?;
                        write(index, || held.insert_grain(grain.into()))
                    })
                }
            }

            /// Takes a grain out, now; grain is what it was. Its place is empty: the others keep their numbers.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _remove_grain>](
                world: *mut [<carom_world $kind>],
                index: u32,
                grain: *mut [<carom_grain $kind>],
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write(grain, || held.remove_grain(index).map(Into::into))
                    })
                }
            }

            /// Everything up to this time happens, and it becomes the present.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _advance_to>](
                world: *mut [<carom_world $kind>],
                time: f64,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.advance_to(time)) }
            }

            /// So much time passes.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _advance_by>](
                world: *mut [<carom_world $kind>],
                time: f64,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.advance_by(time)) }
            }

            /// As advance_to, but it stops after so many events; arrived says whether the time has come. Called again
            /// until it has, it ends in the same state to the last bit.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _advance_with_budget>](
                world: *mut [<carom_world $kind>],
                time: f64,
                events: u32,
                arrived: *mut bool,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write(arrived, || held.advance_with_budget(time, events))
                    })
                }
            }

            /// The next event that changes how a grain moves happens, if it is not later than this time; else the time
            /// becomes the present, and the event is CAROM_EVENT_NONE.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _step>](
                world: *mut [<carom_world $kind>],
                until: f64,
                event: *mut carom_event,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(event, || held.step(until))) }
            }
        }
    };
}
pub(super) use run;
