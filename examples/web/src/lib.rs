//! Which functions does the WebAssembly module export? Reads numbers and memory from JavaScript; writes one world and what JavaScript sees of it.
//!
//! One instance of the module is one world: JavaScript makes as many instances as it wants worlds and
//! forgets them when it is done. There is no allocator; everything lives in statics for up to 500 grains.
//! Plain numbers cross the border, and addresses of arrays that JavaScript reads and writes in place.
//! The only `unsafe` is the attribute that gives a function its plain name.
#![no_std]

mod description;
mod integrate;
mod lent;
mod rule;
mod view_buffers;

use carom::law::{LinearDashpot, Outside, Viscoelastic};
use carom::{Enduring, Error, World};
use core::fmt::Write;
use description::{Description, GRAIN_FIELDS, first};
use lent::{D, Lent, MAX_GRAINS, WorldRule, lent};
use rule::{ChosenRule, Material};
use spin::Mutex;
use static_cell::StaticCell;
use view_buffers::{STATISTICS, ViewBuffers};

/// What JavaScript described, until the start.
static DESCRIPTION: Mutex<Description> = Mutex::new(Description::new());
static MEMORY: StaticCell<Lent> = StaticCell::new();
static WORLD: Mutex<Option<World<'static, f64, D, WorldRule>>> = Mutex::new(None);
/// All zeros, so that it takes no place in the file.
static SHARED: Mutex<Shared> = Mutex::new(Shared {
    grains: [[0.0; GRAIN_FIELDS]; MAX_GRAINS],
    view: ViewBuffers::new(),
    error: heapless::String::new(),
});

/// The memory that JavaScript reads and writes in place.
struct Shared {
    grains: [[f64; GRAIN_FIELDS]; MAX_GRAINS],
    view: ViewBuffers,
    error: heapless::String<512>,
}

impl Shared {
    /// Zero for success; else one, and the error's text can be read.
    fn status(&mut self, result: Result<(), Error>) -> u32 {
        let Err(error) = result else { return 0 };
        self.fail(format_args!("{error}"))
    }

    fn fail(&mut self, what: core::fmt::Arguments<'_>) -> u32 {
        self.error.clear();
        // A message that is too long is cut off, which does not matter.
        let _ = self.error.write_fmt(what);
        1
    }

    fn start(&mut self, count: usize) -> u32 {
        let description = DESCRIPTION.lock();
        let Some(memory) = MEMORY.try_init_with(|| lent(&description.facets)) else {
            return self.fail(format_args!("this instance has been started before"));
        };
        let grains = self.grains.get(..count).unwrap_or(&self.grains);
        match description.start(memory, grains) {
            Ok(world) => *WORLD.lock() = Some(world),
            Err(error) => return self.status(Err(error)),
        }
        self.with_world(|_| Ok(()))
    }

    /// Does something with the world and writes what JavaScript sees of it.
    fn with_world(
        &mut self,
        action: impl FnOnce(&mut World<'static, f64, D, WorldRule>) -> Result<(), Error>,
    ) -> u32 {
        let mut world = WORLD.lock();
        let Some(world) = world.as_mut() else {
            return self.fail(format_args!("the world has not been started"));
        };
        let result = action(world);
        self.view.write(world);
        self.status(result)
    }
}

/// The next event, if there is one; a copy of the engine's loop is large, so there is only this.
#[inline(never)]
fn next_event(world: &mut World<'static, f64, D, WorldRule>) -> Result<bool, Error> {
    world.step().map(|event| event.is_some())
}

/// Adds a plane, see [`description::Wall`].
#[unsafe(no_mangle)]
#[rustfmt::skip]
extern "C" fn plane(x: f64, y: f64, z: f64, offset: f64, e: f64, a: f64, f: f64, phase: f64) {
    // Carom refuses the ninth; a tenth adds nothing to that.
    let _ = DESCRIPTION.lock().planes.push([x, y, z, offset, e, a, f, phase]);
}

/// Makes an axis periodic.
#[unsafe(no_mangle)]
extern "C" fn periodic(axis: u32, low: f64, high: f64) {
    if let Some(place) = DESCRIPTION.lock().periodic.get_mut(axis as usize) {
        *place = Some([low, high]);
    }
}

/// Chooses material (0: hard, ε; 1: k, γ; 2: Y, ν, A), method (1: contacts last) and what happens outside
/// the table (0: reject, 1: clamp, 2: hard spheres, 3: integrate).
#[unsafe(no_mangle)]
extern "C" fn rule(material: u32, lasting: u32, outside: u32, a: f64, b: f64, c: f64) {
    let material = match material {
        0 => Material::Hard(a),
        1 => Material::Linear(LinearDashpot { stiffness: a, damping: b }),
        _ => Material::Viscoelastic(Viscoelastic { young: a, poisson: b, dissipation: c }),
    };
    let outside = match outside {
        0 => Some(Outside::Reject),
        1 => Some(Outside::Clamp),
        2 => Some(Outside::HardSphere),
        _ => None,
    };
    DESCRIPTION.lock().rule = ChosenRule { material, lasting: lasting != 0, outside };
}

/// Chooses the papers' mode (1) or the default one (0), how long a contact of hard grains lasts (NaN: as carom has
/// it), and the steps in a contact of a cluster (0: as carom has it).
#[unsafe(no_mangle)]
extern "C" fn contacts(paper: u32, time: f64, steps: u32) {
    let mut description = DESCRIPTION.lock();
    description.enduring = if paper != 0 { Enduring::Paper } else { Enduring::Integrated };
    description.contact_time = time;
    description.steps = steps;
}

/// Adds a segment of an obstacle, from a to b; e: its restitution (NaN: by the rule).
#[cfg(feature = "rough")]
#[unsafe(no_mangle)]
extern "C" fn facet(ax: f64, ay: f64, bx: f64, by: f64, e: f64) {
    let surface = description::surface(e);
    let facet = carom::space::Facet::new([[ax, ay], [bx, by]], surface);
    // JavaScript knows how many there may be.
    let _ = DESCRIPTION.lock().facets.push(facet);
}

/// Makes grains rough: Walton's rule with μ and β₀.
#[cfg(feature = "rough")]
#[unsafe(no_mangle)]
extern "C" fn friction(mu: f64, beta_0: f64) {
    DESCRIPTION.lock().friction = carom::law::Tangential::Walton { mu, beta_0 };
}

/// Sets gravity, before the start or now.
#[unsafe(no_mangle)]
extern "C" fn gravity(x: f64, y: f64, z: f64) -> u32 {
    DESCRIPTION.lock().gravity = [x, y, z];
    if WORLD.lock().is_none() {
        return 0;
    }
    SHARED.lock().with_world(|world| world.set_gravity(first(&[x, y, z])))
}

/// Starts the world with the first `count` grains of the table.
#[unsafe(no_mangle)]
extern "C" fn start(count: usize) -> u32 {
    SHARED.lock().start(count)
}

/// Everything up to this time happens: 0; or the first `max_events` events of it: 2.
#[unsafe(no_mangle)]
extern "C" fn advance(time: f64, max_events: u32) -> u32 {
    let mut arrived = true;
    let status = SHARED.lock().with_world(|world| {
        arrived = world.advance_with_budget(time, max_events)?;
        Ok(())
    });
    if status == 0 && !arrived { 2 } else { status }
}

/// The next event happens: 0, or nothing ever will: 2.
#[unsafe(no_mangle)]
extern "C" fn step() -> u32 {
    let mut any = false;
    let status = SHARED.lock().with_world(|world| next_event(world).map(|happened| any = happened));
    if status == 0 && !any { 2 } else { status }
}

/// One number of the whole state.
#[unsafe(no_mangle)]
extern "C" fn digest() -> u64 {
    WORLD.lock().as_ref().map_or(0, World::digest)
}

/// Where things are: 0: the table of grains, 1: positions, 2: velocities, 3: states, 4: statistics,
/// 5: now, next, energy, 6: the error's text, 7: the statistics' names, 8: angular velocities.
#[unsafe(no_mangle)]
extern "C" fn address(of: u32) -> *const u8 {
    let shared = SHARED.lock();
    match of {
        0 => shared.grains.as_ptr().cast(),
        1 => shared.view.positions.as_ptr().cast(),
        2 => shared.view.velocities.as_ptr().cast(),
        3 => shared.view.states.as_ptr(),
        4 => shared.view.statistics.as_ptr().cast(),
        5 => shared.view.clock.as_ptr().cast(),
        6 => shared.error.as_ptr(),
        #[cfg(feature = "rough")]
        8 => shared.view.rotations.as_ptr().cast(),
        _ => STATISTICS.as_ptr(),
    }
}

/// How long the texts among them are.
#[unsafe(no_mangle)]
extern "C" fn length(of: u32) -> usize {
    if of == 6 { SHARED.lock().error.len() } else { STATISTICS.len() }
}

/// Nothing in carom panics; should anything, the module stops and JavaScript gets an exception.
#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
