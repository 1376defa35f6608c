//! What does C see of a world? Reads it; writes numbers and arrays of C.

/// The functions that look at one kind of world.
macro_rules! look {
    ($kind:ident, $s:ident, $d:literal) => {
        paste! {
            /// The present.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _time>](
                world: *mut [<carom_world $kind>],
                time: *mut f64,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(time, || held.time())) }
            }

            /// Nothing happens before this time: one can sleep until then. Infinite if nothing will ever happen.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _next_event_time>](
                world: *mut [<carom_world $kind>],
                time: *mut f64,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(time, || held.next_event_time())) }
            }

            /// How many grains there are, empty places included: an array of so many holds something of each.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _count>](
                world: *mut [<carom_world $kind>],
                count: *mut u32,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(count, || held.count())) }
            }

            /// A grain as it is now; CAROM_ERROR_INDEX for an empty place.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _grain>](
                world: *mut [<carom_world $kind>],
                index: u32,
                grain: *mut [<carom_grain $kind>],
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write(grain, || held.grain(index).map(Into::into))
                    })
                }
            }

            #[doc = concat!("All positions, ", $d, " numbers for each grain, 0 for empty places; length is how many numbers there are places for.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _positions>](
                world: *mut [<carom_world $kind>],
                positions: *mut $s,
                length: usize,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write_all(positions, length, held.all(|grain| grain.position.into())?)
                    })
                }
            }

            #[doc = concat!("All velocities, ", $d, " numbers for each grain, 0 for empty places; length is how many numbers there are places for.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _velocities>](
                world: *mut [<carom_world $kind>],
                velocities: *mut $s,
                length: usize,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write_all(velocities, length, held.all(|grain| grain.velocity.into())?)
                    })
                }
            }

            /// The kinetic energy, contacts under way counted as if they ended now.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _kinetic_energy>](
                world: *mut [<carom_world $kind>],
                energy: *mut $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(energy, || held.kinetic_energy())) }
            }

            #[doc = concat!("The momentum, ", $d, " numbers.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _momentum>](
                world: *mut [<carom_world $kind>],
                momentum: *mut $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        write(momentum.cast::<[$s; $d]>(), || held.momentum())
                    })
                }
            }

            /// A digest of the whole state: equal states have equal digests on every target and in every language.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _digest>](
                world: *mut [<carom_world $kind>],
                digest: *mut u64,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(digest, || held.digest())) }
            }

            /// How often what happened since the start.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _statistics>](
                world: *mut [<carom_world $kind>],
                statistics: *mut carom_statistics,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| write(statistics, || held.statistics())) }
            }
        }
    };
}
pub(super) use look;
