//! What is a world of one kind, and how does it come to be? Reads memory of C; writes a world into it.

/// Structures, sizes and `create` of one kind of world.
macro_rules! kind {
    ($kind:ident, $KIND:ident, $s:ident, $d:literal, $what:literal,
     32: [$fixed_32:literal, $grain_32:literal, $plane_32:literal],
     64: [$fixed_64:literal, $grain_64:literal, $plane_64:literal]) => {
        paste! {
            #[doc = concat!("A world of ", $what, ". It lies in memory that the caller gives.")]
            pub struct [<carom_world $kind>] {
                _held: Held<$s, $d>,
            }

            #[doc = concat!("One of ", $what, ".")]
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct [<carom_grain $kind>] {
                /// Centre.
                pub position: [$s; $d],
                /// Velocity of the centre.
                pub velocity: [$s; $d],
                /// Radius, above 0.
                pub radius: $s,
                /// Mass, above 0.
                pub mass: $s,
            }

            impl From<Grain<$s, $d>> for [<carom_grain $kind>] {
                fn from(grain: Grain<$s, $d>) -> Self {
                    let (position, velocity) = (grain.position.into(), grain.velocity.into());
                    Self { position, velocity, radius: grain.radius, mass: grain.mass }
                }
            }

            impl From<[<carom_grain $kind>]> for Grain<$s, $d> {
                fn from(grain: [<carom_grain $kind>]) -> Self {
                    let at = Grain::with_mass(grain.radius, grain.mass).at(grain.position);
                    at.moving(grain.velocity)
                }
            }

            /// Bytes of such a world without grains and planes where pointers have 32 bits.
            pub const [<CAROM $KIND _FIXED_32>]: usize = $fixed_32;
            /// Bytes of each grain there.
            pub const [<CAROM $KIND _GRAIN_32>]: usize = $grain_32;
            /// Bytes of each plane there.
            pub const [<CAROM $KIND _PLANE_32>]: usize = $plane_32;
            /// Bytes of such a world without grains and planes where pointers have 64 bits.
            pub const [<CAROM $KIND _FIXED_64>]: usize = $fixed_64;
            /// Bytes of each grain there.
            pub const [<CAROM $KIND _GRAIN_64>]: usize = $grain_64;
            /// Bytes of each plane there.
            pub const [<CAROM $KIND _PLANE_64>]: usize = $plane_64;
            const _: () = assert!(
                if size_of::<usize>() == 8 {
                    Promised { fixed: $fixed_64, grain: $grain_64, plane: $plane_64 }
                } else {
                    Promised { fixed: $fixed_32, grain: $grain_32, plane: $plane_32 }
                }
                .is_enough::<Held<$s, $d>, $s, $d>(),
                "enlarge what worlds! is told, and make the header anew"
            );

            /// How many bytes a world of so many grains and planes takes; 0 if there cannot be one. It is not more
            /// than the macro of the same name says, which can be used for a static array.
            #[unsafe(no_mangle)]
            pub extern "C" fn [<carom $kind _bytes>](grains: u32, planes: u32) -> usize {
                let layout = Layout::of::<Held<$s, $d>, $s, $d>(grains as usize, planes as usize);
                if layout.is_possible() { layout.bytes } else { 0 }
            }

            /// Makes an empty world in this memory, with places for so many grains and at most 8 planes. What was there
            /// before, a world too, is gone.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<carom $kind _create>](
                memory: *mut core::ffi::c_void,
                bytes: usize,
                grains: u32,
                planes: u32,
                world: *mut *mut [<carom_world $kind>],
            ) -> carom_error {
                // SAFETY: what the memory must be, and the place for the pointer, are the caller's promise.
                told(unsafe {
                    write(world, || {
                        let (grains, planes) = (grains as usize, planes as usize);
                        let held = Held::<$s, $d>::create(memory.cast(), bytes, grains, planes)?;
                        Ok(held.cast())
                    })
                })
            }
        }
    };
}
pub(super) use kind;
