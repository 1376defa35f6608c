//! Is a world held by C's functions the engine's own? Calls them as C does, also under Miri; compares with safe Rust.
#![allow(clippy::undocumented_unsafe_blocks, reason = "every call is one, on a world made here")]

use carom::law::embedded::Compact;
use carom::law::{
    HardSphere, IntegratedMode, LinearDashpot, Outside, PaperMode, Rule, Soft, Viscoelastic,
};
use carom::space::{Plane, Surface, Vibration};
use carom::{Grain, Memory, World};
use carom_c::error::carom_error::*;
use carom_c::error::{CODES, carom_error, carom_error_meaning, carom_error_name};
use carom_c::export::*;
use carom_c::law::{CAROM_MODE_INTEGRATED, CAROM_MODE_PAPER};
use carom_c::types::{CAROM_NOBODY, carom_event, carom_event_kind};
use std::ffi::{CStr, c_char};
use std::mem::{MaybeUninit, size_of};
use std::ptr;

/// Memory as C gives it: of no particular value.
#[repr(align(64))]
struct Given([MaybeUninit<u8>; 8192]);

impl Given {
    fn new() -> Box<Self> {
        Box::new(Self([MaybeUninit::uninit(); 8192]))
    }
    fn zeros() -> Box<Self> {
        Box::new(Self([MaybeUninit::zeroed(); 8192]))
    }
    fn start(&mut self) -> *mut std::ffi::c_void {
        self.0.as_mut_ptr().cast()
    }
}

/// As long as Miri has patience for, and as is needed for something to happen.
const END: f64 = if cfg!(miri) { 0.06 } else { 5.0 };

fn ok(error: carom_error) {
    assert_eq!(error, CAROM_OK);
}

fn bead(k: u8) -> Grain<f64, 2> {
    let at = [k % 3, k / 3].map(|place| 0.5 + f64::from(place));
    Grain::with_mass(0.25 + f64::from(k) / 64.0, 1.0).at(at).moving([f64::from(k % 5) - 2.0, 1.0])
}

/// Nine beads between a vibrating floor, a wall that the law moves, and a periodic axis.
fn engine<R: Rule<f64>>(memory: &mut Memory<f64, 2, 16>, rule: R) -> World<'_, f64, 2, R> {
    let floor = Plane::new([0.0, 1.0], 0.0, Surface::Hard(0.9));
    World::builder(memory)
        .periodic_axis(0, [0.0, 3.0])
        .plane(floor.vibrating(Vibration::new(0.01, 2.0)))
        .plane(Plane::new([0.0, -1.0], -3.5, Surface::Rule))
        .gravity([0.0, -1.0])
        .rule(rule)
        .grains((0..9).map(bead))
        .unwrap()
        .start()
        .unwrap()
}

/// The same from C, but for its law.
unsafe fn described(given: &mut Given) -> *mut carom_world_2d_f64 {
    let mut world = ptr::null_mut();
    unsafe {
        ok(carom_2d_f64_create(given.start(), 8192, 16, 8, &mut world));
        ok(carom_2d_f64_set_periodic(world, 0, 0.0, 3.0));
        ok(carom_2d_f64_add_plate(world, [0.0, 1.0].as_ptr(), 0.0, 0.9, 0.01, 2.0));
        ok(carom_2d_f64_add_plane(world, [0.0, -1.0].as_ptr(), -3.5));
        ok(carom_2d_f64_set_gravity(world, [0.0, -1.0].as_ptr()));
        for k in 0..9 {
            ok(carom_2d_f64_add_grain(world, &bead(k).into()));
        }
    }
    world
}

unsafe fn digest(world: *mut carom_world_2d_f64) -> u64 {
    let mut digest = 0;
    ok(unsafe { carom_2d_f64_digest(world, &mut digest) });
    digest
}

fn same<R: Rule<f64>>(rule: R, law: unsafe fn(*mut carom_world_2d_f64) -> carom_error) {
    let (mut memory, mut given) = (Memory::new(), Given::new());
    let mut own = engine(&mut memory, rule);
    unsafe {
        let world = described(&mut given);
        ok(law(world));
        ok(carom_2d_f64_start(world));
        assert_eq!(digest(world), own.digest());
        for frame in 1..=10 {
            let tilt = [0.125 * f64::from(frame), -1.0];
            own.set_gravity(tilt).unwrap();
            ok(carom_2d_f64_set_gravity(world, tilt.as_ptr()));
            own.advance_to(END * f64::from(frame) / 10.0).unwrap();
            ok(carom_2d_f64_advance_to(world, END * f64::from(frame) / 10.0));
            assert_eq!(digest(world), own.digest());
        }
        let mut seen = Default::default();
        ok(carom_2d_f64_statistics(world, &mut seen));
        assert_eq!(seen, own.statistics().into());
        assert!(cfg!(miri) || seen.collisions + seen.joins > 0);
        looks_the_same(world, &own);
    }
}

unsafe fn looks_the_same<R: Rule<f64>>(world: *mut carom_world_2d_f64, own: &World<'_, f64, 2, R>) {
    let (mut time, mut energy, mut count) = (0.0, 0.0, 0);
    let (mut momentum, mut places, mut speeds) = ([0.0; 2], [0.0; 18], [0.0; 20]);
    unsafe {
        ok(carom_2d_f64_time(world, &mut time));
        ok(carom_2d_f64_kinetic_energy(world, &mut energy));
        ok(carom_2d_f64_momentum(world, momentum.as_mut_ptr()));
        ok(carom_2d_f64_count(world, &mut count));
        ok(carom_2d_f64_positions(world, places.as_mut_ptr(), 18));
        ok(carom_2d_f64_velocities(world, speeds.as_mut_ptr(), 20));
    }
    let view = own.view();
    assert_eq!((time, energy), (own.now().as_f64(), view.kinetic_energy()));
    assert_eq!((momentum, count), (view.momentum().into(), 9));
    for k in 0..9 {
        let grain = own.grain(k).unwrap();
        let mut seen = bead(0).into();
        ok(unsafe { carom_2d_f64_grain(world, k as u32, &mut seen) });
        assert_eq!(seen, grain.into());
        assert_eq!(places[2 * k..2 * k + 2], <[f64; 2]>::from(grain.position));
        assert_eq!(speeds[2 * k..2 * k + 2], <[f64; 2]>::from(grain.velocity));
    }
    assert_eq!(speeds[18..], [0.0; 2]);
}

#[test]
fn hard_grains_are_the_engines() {
    same(IntegratedMode(HardSphere { restitution: 0.8 }), |world| unsafe {
        carom_2d_f64_set_restitution(world, 0.8)
    });
}

#[test]
fn soft_grains_are_the_engines() {
    let law = LinearDashpot { stiffness: 2.0e4, damping: 20.0 };
    same(Soft::embedded(law, Compact, Outside::HardSphere), |world| unsafe {
        carom_2d_f64_set_linear_dashpot(world, 2.0e4, 20.0, 0)
    });
}

#[test]
#[cfg(feature = "standard")]
fn viscoelastic_grains_are_the_engines() {
    let law = Viscoelastic { young: 1.0e6, poisson: 0.4, dissipation: 1.0e-3 };
    same(Soft::viscoelastic(law, Outside::HardSphere), |world| unsafe {
        carom_2d_f64_set_viscoelastic(world, 1.0e6, 0.4, 1.0e-3, 1)
    });
}

#[test]
#[cfg(feature = "paper")]
fn the_papers_mode_is_the_engines() {
    let law = LinearDashpot { stiffness: 2.0e4, damping: 20.0 };
    same(PaperMode(Soft::embedded(law, Compact, Outside::HardSphere)), |world| unsafe {
        ok(carom_2d_f64_set_mode(world, CAROM_MODE_PAPER));
        carom_2d_f64_set_linear_dashpot(world, 2.0e4, 20.0, 0)
    });
    // The law first, and a mode that is taken back.
    same(PaperMode(HardSphere { restitution: 0.8 }), |world| unsafe {
        ok(carom_2d_f64_set_restitution(world, 0.8));
        ok(carom_2d_f64_set_mode(world, CAROM_MODE_PAPER));
        assert_eq!(carom_2d_f64_set_mode(world, 2), CAROM_ERROR_MODE);
        ok(carom_2d_f64_set_mode(world, CAROM_MODE_INTEGRATED));
        carom_2d_f64_set_mode(world, CAROM_MODE_PAPER)
    });
}

#[test]
fn grains_come_and_go_as_in_the_engine() {
    let (mut memory, mut given) = (Memory::<f64, 2, 16>::new(), Given::new());
    let rule = IntegratedMode(HardSphere { restitution: 0.8 });
    let mut own = World::builder(&mut memory)
        .walls([[0.0, 3.0], [0.0, 3.0]])
        .rule(rule)
        .grains((0..8).map(bead))
        .unwrap()
        .reserve(1)
        .unwrap()
        .start()
        .unwrap();
    let (mut world, mut index, mut count) = (ptr::null_mut(), u32::MAX, 0);
    unsafe {
        ok(carom_2d_f64_create(given.start(), 8192, 9, 4, &mut world));
        ok(carom_2d_f64_set_restitution(world, 0.8));
        ok(carom_2d_f64_add_walls(world, [0.0; 2].as_ptr(), [3.0; 2].as_ptr()));
        (0..8).for_each(|k| ok(carom_2d_f64_add_grain(world, &bead(k).into())));
        let mut taken = bead(0).into();
        assert_eq!(carom_2d_f64_remove_grain(world, 3, &mut taken), CAROM_ERROR_NOT_STARTED);
        assert_eq!(carom_2d_f64_add_empty_places(world, 2), CAROM_ERROR_FULL);
        ok(carom_2d_f64_count(world, &mut count));
        assert_eq!(count, 8);
        ok(carom_2d_f64_add_empty_places(world, 1));
        ok(carom_2d_f64_start(world));
        assert_eq!(carom_2d_f64_grain(world, 8, &mut taken), CAROM_ERROR_INDEX);
        let (on_another, new) = (bead(4), Grain { radius: 0.25, ..bead(8) });
        assert_eq!(
            carom_2d_f64_insert_grain(world, &on_another.into(), &mut index),
            CAROM_ERROR_OVERLAP
        );
        assert_eq!(
            carom_2d_f64_insert_grain(world, &new.into(), ptr::null_mut()),
            CAROM_ERROR_NULL
        );
        assert_eq!((index, digest(world)), (u32::MAX, own.digest()));
        ok(carom_2d_f64_insert_grain(world, &new.into(), &mut index));
        assert_eq!((index as usize, Ok(8)), (8, own.add(new)));
        assert_eq!(carom_2d_f64_insert_grain(world, &new.into(), &mut index), CAROM_ERROR_FULL);
        own.advance_to(END).unwrap();
        ok(carom_2d_f64_advance_to(world, END));
        assert_eq!(digest(world), own.digest());
        assert_eq!(carom_2d_f64_remove_grain(world, 3, ptr::null_mut()), CAROM_ERROR_NULL);
        ok(carom_2d_f64_remove_grain(world, 3, &mut taken));
        assert_eq!(taken, own.remove(3).unwrap().into());
        assert_eq!(carom_2d_f64_remove_grain(world, 3, &mut taken), CAROM_ERROR_INDEX);
        own.advance_to(2.0 * END).unwrap();
        ok(carom_2d_f64_advance_to(world, 2.0 * END));
        assert_eq!(digest(world), own.digest());
    }
}

#[test]
fn a_snapshot_goes_on_with_the_same_bits_here_and_elsewhere() {
    let (mut given, mut other, mut kept) = (Given::new(), Given::new(), Given::new());
    let (mut elsewhere, mut bytes) = (ptr::null_mut(), 0);
    unsafe {
        let world = described(&mut given);
        ok(carom_2d_f64_set_restitution(world, 0.7));
        ok(carom_2d_f64_start(world));
        ok(carom_2d_f64_advance_to(world, END / 2.0));
        ok(carom_2d_f64_saved_bytes(world, &mut bytes));
        ok(carom_2d_f64_save(world, kept.start(), bytes));
        let then = digest(world);
        ok(carom_2d_f64_advance_to(world, END));
        let end = digest(world);
        ok(carom_2d_f64_restore(world, kept.start()));
        assert_eq!(digest(world), then);
        ok(carom_2d_f64_advance_to(world, END));
        assert_eq!(digest(world), end);
        ok(carom_2d_f64_create(other.start(), 8192, 8, 8, &mut elsewhere));
        assert_eq!(carom_2d_f64_restore(elsewhere, kept.start()), CAROM_ERROR_MEMORY);
        ok(carom_2d_f64_create(other.start(), 8192, 9, 1, &mut elsewhere));
        assert_eq!(carom_2d_f64_restore(elsewhere, kept.start()), CAROM_ERROR_MEMORY);
        ok(carom_2d_f64_create(other.start(), 8192, 9, 2, &mut elsewhere));
        ok(carom_2d_f64_restore(elsewhere, kept.start()));
        drop(kept);
        ok(carom_2d_f64_advance_to(elsewhere, END));
        assert_eq!(digest(elsewhere), end);
    }
}

#[test]
fn steps_and_budgets_end_where_a_single_call_does() {
    let (mut given, mut other) = (Given::new(), Given::new());
    unsafe {
        let [world, again] = [&mut given, &mut other].map(|given| {
            let world = described(given);
            ok(carom_2d_f64_set_restitution(world, 0.8));
            ok(carom_2d_f64_start(world));
            world
        });
        let (mut arrived, mut frames, mut next) = (false, 0, 0.0);
        while !arrived {
            ok(carom_2d_f64_advance_with_budget(world, END, 10, &mut arrived));
            frames += 1;
        }
        assert!(cfg!(miri) || frames > 1);
        ok(carom_2d_f64_next_event_time(again, &mut next));
        assert!(next > 0.0 && (cfg!(miri) || next < END));
        let mut event = carom_event::none(0.0);
        let mut seen = Vec::new();
        while seen.last() != Some(&carom_event_kind::CAROM_EVENT_NONE) {
            ok(carom_2d_f64_step(again, END, &mut event));
            seen.push(event.kind);
        }
        assert!(cfg!(miri) || seen.contains(&carom_event_kind::CAROM_EVENT_COLLISION));
        assert_eq!(event, carom_event { time: END, grain: CAROM_NOBODY, ..event });
        assert_eq!(digest(world), digest(again));
        ok(carom_2d_f64_set_velocity(world, 3, [0.5, 0.25].as_ptr()));
        let mut grain = bead(0).into();
        ok(carom_2d_f64_grain(world, 3, &mut grain));
        assert_eq!(grain.velocity, [0.5, 0.25]);
        ok(carom_2d_f64_advance_by(world, 0.5));
        ok(carom_2d_f64_time(world, &mut next));
        assert_eq!(next, END + 0.5);
    }
}

#[test]
fn memory_that_will_not_do_is_refused_and_not_touched() {
    let mut given = Given::zeros();
    let memory = given.start();
    let mut world = ptr::null_mut();
    let bytes = carom_3d_f64_bytes(8, 6);
    let small = carom_2d_f32_bytes(8, 4);
    unsafe {
        let at = |offset: usize| memory.byte_add(offset);
        for (memory, bytes, grains, planes, wanted) in [
            (ptr::null_mut(), 8192, 8, 6, CAROM_ERROR_NULL),
            (at(1), 8100, 8, 6, CAROM_ERROR_MISALIGNED),
            (at(16), 8100, 8, 6, CAROM_ERROR_MISALIGNED),
            (at(0), 0, 8, 6, CAROM_ERROR_MEMORY),
            (at(0), bytes - 1, 8, 6, CAROM_ERROR_MEMORY),
            (at(0), 8192, u32::MAX, 6, CAROM_ERROR_MEMORY),
            (at(0), usize::MAX, u32::MAX, 6, CAROM_ERROR_MEMORY),
            (at(0), 8192, 8, 9, CAROM_ERROR_MEMORY),
        ] {
            let created = carom_3d_f64_create(memory, bytes, grains, planes, &mut world);
            assert_eq!(created, wanted);
            assert!(world.is_null());
        }
        assert_eq!(carom_3d_f64_create(memory, 8192, 8, 6, ptr::null_mut()), CAROM_ERROR_NULL);
        assert_eq!(carom_3d_f64_start(memory.cast()), CAROM_ERROR_NO_WORLD);
        assert!(given.0.iter().all(|byte| byte.assume_init() == 0));
        ok(carom_3d_f64_create(memory, bytes, 8, 6, &mut world));
        assert_eq!(carom_2d_f64_start(world.cast()), CAROM_ERROR_NO_WORLD);
        assert_eq!(carom_3d_f64_start(world.byte_add(8)), CAROM_ERROR_MISALIGNED);
        // What is behind the world is not the world's.
        assert!(given.0[bytes..].iter().all(|byte| byte.assume_init() == 0));
        ok(carom_2d_f32_create(given.start(), small, 8, 4, (&raw mut world).cast()));
    }
}

#[test]
fn a_world_takes_no_more_than_the_header_says() {
    let [fixed, grain, plane] = match size_of::<usize>() {
        8 => [CAROM_2D_F32_FIXED_64, CAROM_2D_F32_GRAIN_64, CAROM_2D_F32_PLANE_64],
        _ => [CAROM_2D_F32_FIXED_32, CAROM_2D_F32_GRAIN_32, CAROM_2D_F32_PLANE_32],
    };
    for (grains, planes) in [(0, 0), (1, 0), (3, 5), (16, 4), (1001, 8), (1_000_000, 8)] {
        let most = fixed + grain * grains as usize + plane * planes as usize;
        let bytes = carom_2d_f32_bytes(grains, planes);
        assert!((most - 400..=most).contains(&bytes), "{bytes} of {most}");
    }
    assert_eq!(carom_2d_f32_bytes(u32::MAX, 4), 0);
    assert_eq!(carom_2d_f32_bytes(1, 9), 0);
}

#[test]
fn texts_end_where_the_memory_does() {
    let mut given = Given::new();
    let mut world = ptr::null_mut();
    let mut text: [c_char; 8] = [1; 8];
    unsafe {
        ok(carom_2d_f32_create(given.start(), 8192, 8, 4, &mut world));
        ok(carom_2d_f32_error_text(world, text.as_mut_ptr(), 8));
        assert_eq!(text[..2], [0, 1]);
        assert_eq!(carom_2d_f32_set_restitution(world, f32::NAN), CAROM_ERROR_INPUT);
        assert_eq!(carom_2d_f32_error_text(world, text.as_mut_ptr(), 0), CAROM_ERROR_LENGTH);
        ok(carom_2d_f32_error_text(world, text.as_mut_ptr(), 7));
        assert_eq!(CStr::from_ptr(text.as_ptr()), c"rule: ");
        assert_eq!(text[7], 1);
    }
}

#[test]
fn codes_have_names_and_numbers() {
    let text = |words| unsafe { CStr::from_ptr(words) }.to_str().unwrap();
    for (number, &code) in CODES.iter().enumerate() {
        assert_eq!(code as i32, number as i32);
        assert_eq!(text(carom_error_name(code as i32)), format!("{code:?}"));
        assert!(text(carom_error_meaning(code as i32)).ends_with('.'));
    }
    assert_eq!(text(carom_error_name(-1)), "unknown");
    assert_eq!(text(carom_error_name(CODES.len() as i32)), "unknown");
}
