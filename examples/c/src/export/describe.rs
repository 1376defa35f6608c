//! How does C describe a world? Reads numbers and arrays of C; writes the description.

/// The functions that describe one kind of world.
macro_rules! describe {
    ($kind:ident, $s:ident, $d:literal) => {
        paste! {
            /// The law of hard grains: this constant coefficient of restitution, from 0 to 1.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_restitution>](
                world: *mut [<carom_world $kind>],
                restitution: $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_restitution(restitution)) }
            }

            /// The law of linear spring-dashpots (stiffness: force over length, damping: force over speed), with one of
            /// the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_linear_dashpot>](
                world: *mut [<carom_world $kind>],
                stiffness: $s,
                damping: $s,
                table: i32,
            ) -> carom_error {
                let law = LinearDashpot { stiffness, damping };
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_linear_dashpot(law, table)) }
            }

            /// The law of viscoelastic spheres (Young's modulus, Poisson's ratio, the dissipative constant A: a time),
            /// with one of the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_viscoelastic>](
                world: *mut [<carom_world $kind>],
                young: $s,
                poisson: $s,
                dissipation: $s,
                table: i32,
            ) -> carom_error {
                let law = Viscoelastic { young, poisson, dissipation };
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_viscoelastic(law, table)) }
            }

            #[doc = concat!("A box of walls from low to high, ", $d, " numbers each; the law says what they do. All of them, or none.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_walls>](
                world: *mut [<carom_world $kind>],
                low: *const $s,
                high: *const $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        held.add_walls(read(low.cast())?, read(high.cast())?, Surface::Rule)
                    })
                }
            }

            #[doc = concat!("A box of hard walls of this coefficient of restitution from low to high, ", $d, " numbers each. All of them, or none.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_hard_walls>](
                world: *mut [<carom_world $kind>],
                low: *const $s,
                high: *const $s,
                restitution: $s,
            ) -> carom_error {
                let surface = Surface::Hard(restitution);
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        held.add_walls(read(low.cast())?, read(high.cast())?, surface)
                    })
                }
            }

            #[doc = concat!("A plane. Grains stay where normal . r >= offset; the normal, ", $d, " numbers, has the length 1. The law says what it does.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_plane>](
                world: *mut [<carom_world $kind>],
                normal: *const $s,
                offset: $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        held.add_plane(Plane::new(read(normal.cast())?, offset, Surface::Rule))
                    })
                }
            }

            /// A hard plane of this coefficient of restitution.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_hard_plane>](
                world: *mut [<carom_world $kind>],
                normal: *const $s,
                offset: $s,
                restitution: $s,
            ) -> carom_error {
                let surface = Surface::Hard(restitution);
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        held.add_plane(Plane::new(read(normal.cast())?, offset, surface))
                    })
                }
            }

            /// A hard plane that vibrates along its normal about its offset, with this amplitude and frequency (cycles
            /// per unit of time).
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_plate>](
                world: *mut [<carom_world $kind>],
                normal: *const $s,
                offset: $s,
                restitution: $s,
                amplitude: $s,
                frequency: $s,
            ) -> carom_error {
                let surface = Surface::Hard(restitution);
                // SAFETY: the caller's promise.
                unsafe {
                    on::<$s, $d, _>(world, |held| {
                        let plane = Plane::new(read(normal.cast())?, offset, surface);
                        held.add_plate(plane, [amplitude, frequency])
                    })
                }
            }

            /// Makes an axis periodic, from low to high. Its length is at least 4.5 times the largest radius.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_periodic>](
                world: *mut [<carom_world $kind>],
                axis: u32,
                low: $s,
                high: $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_periodic(axis, low, high)) }
            }

            #[doc = concat!("Gravity, ", $d, " numbers: before the start, and at any time after it.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_gravity>](
                world: *mut [<carom_world $kind>],
                gravity: *const $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_gravity(read(gravity.cast())?)) }
            }

            /// How long slow contacts of hard grains last; by default a sixteenth of the square root of R / g.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_contact_time>](
                world: *mut [<carom_world $kind>],
                time: $s,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_contact_time(time)) }
            }

            /// In how many steps the shortest contact of several grains is integrated: from 8 to 131072, by default 32.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_steps_per_contact>](
                world: *mut [<carom_world $kind>],
                steps: u32,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_steps_per_contact(steps)) }
            }

            /// CAROM_MODE_INTEGRATED, the default, or CAROM_MODE_PAPER, if the library has it.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _set_mode>](
                world: *mut [<carom_world $kind>],
                mode: i32,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.set_mode(mode)) }
            }

            /// So many empty places, behind the grains so far, for grains that are inserted while time passes. Of the
            /// places that create was told of.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_empty_places>](
                world: *mut [<carom_world $kind>],
                places: u32,
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.add_empty_places(places)) }
            }

            /// One grain more. Grains are numbered from 0 in the order in which they are added.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _add_grain>](
                world: *mut [<carom_world $kind>],
                grain: *const [<carom_grain $kind>],
            ) -> carom_error {
                // SAFETY: the caller's promise.
                unsafe { on::<$s, $d, _>(world, |held| held.add_grain(read(grain)?.into())) }
            }
        }
    };
}
pub(super) use describe;
