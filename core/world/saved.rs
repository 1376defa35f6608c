//! How is a world put away and taken up again? Reads and writes the whole state.

use super::World;
use super::memory::Lend;
use crate::event::scene::{Counters, Release};
use crate::event::{Kind, Slot};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::boundary::Kept;
use crate::matter::grid::Grid;
use crate::matter::{Body, Partner};
use crate::number::{Instant, Scalar, Vector};

/// The whole state of a world but its rule. With the feature `serde` it can be serialised.
///
/// `B` and `Q` hold bodies and pending events: slices for saving, anything that owns them for
/// restoring (`heapless::Vec`, `Vec`). A restored world goes on with the same bits.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize, B: serde::Serialize, Q: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>, B: serde::Deserialize<'de>, Q: serde::Deserialize<'de>"
    ))
)]
pub struct Saved<S: Scalar, const D: usize, B, Q> {
    boundary: Kept<S, D>,
    grid: Option<Grid<S, D>>,
    gravity: Vector<S, D>,
    now: S,
    epoch: Instant,
    release: Release,
    t_c: S,
    counters: Counters,
    since_epoch: u32,
    wanders: u32,
    at_once: u32,
    mark: Instant,
    bodies: B,
    slots: Q,
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// The whole state, borrowed.
    #[must_use]
    pub fn save(&self) -> Saved<S, D, &[Body<S, D>], &[Slot<S>]> {
        Saved {
            boundary: self.scene.boundary.keep(),
            grid: self.scene.cells.grid,
            gravity: self.scene.gravity,
            now: self.scene.now,
            epoch: self.scene.epoch,
            release: self.scene.release,
            t_c: self.scene.t_c,
            counters: self.scene.counters,
            since_epoch: self.since_epoch,
            wanders: self.wanders,
            at_once: self.at_once,
            mark: self.mark,
            bodies: &*self.scene.bodies,
            slots: &*self.queue.slots,
        }
    }
}

impl<'m, S: Scalar, const D: usize, R: Rule<S>> World<'m, S, D, R> {
    /// Takes up a saved world with this rule in this memory.
    ///
    /// # Errors
    /// [`Fault::Full`] if the memory is too small, [`Fault::Input`] if the state is not that of a world.
    pub fn restore<B, Q>(
        memory: &'m mut impl Lend<S, D>,
        rule: R,
        saved: &Saved<S, D, B, Q>,
    ) -> Result<Self, Fault>
    where
        B: AsRef<[Body<S, D>]>,
        Q: AsRef<[Slot<S>]>,
    {
        let (bodies, slots) = (saved.bodies.as_ref(), saved.slots.as_ref());
        let planes = saved.boundary.planes.len();
        check(bodies, slots, saved.now, planes)?;
        check_counters(&saved.counters)?;
        let mut setup =
            World::setup(memory).rule(rule).grains(bodies.iter().map(Body::as_grain))?;
        if !setup.boundary.take_up(&saved.boundary) {
            return Err(setup.no_plane_more());
        }
        setup.gravity = saved.gravity;
        let mut world = setup.release(saved.release).tc(saved.t_c).build()?;
        world.scene.bodies.copy_from_slice(bodies);
        world.scene.held = bodies.iter().filter(|body| body.is_held()).count();
        world.scene.now = saved.now;
        world.scene.epoch = saved.epoch;
        world.scene.boundary.start_epoch(saved.epoch);
        world.scene.take_grid(saved.grid)?;
        world.scene.counters = saved.counters;
        (world.since_epoch, world.wanders) = (saved.since_epoch, saved.wanders);
        world.at_once = saved.at_once;
        world.mark = saved.mark;
        world.queue.slots.copy_from_slice(slots);
        world.queue.rebuild();
        Ok(world)
    }
}

/// Whether these can be the bodies and events of one world: anything may have been read from a file.
fn check<S: Scalar, const D: usize>(
    bodies: &[Body<S, D>],
    slots: &[Slot<S>],
    now: S,
    planes: usize,
) -> Result<(), Fault> {
    let count = bodies.len();
    if slots.len() != count {
        let wanted = "one for each grain";
        return Err(Fault::input(Subject::World, "number of slots", slots.len() as f64, wanted));
    }
    if !(now >= S::zero() && now < S::NEVER) {
        return Err(Fault::input(Subject::World, "now", now.to_f64(), "at least 0 and finite"));
    }
    for (i, (body, slot)) in bodies.iter().zip(slots).enumerate() {
        check_body(i, body, now)?;
        check_slot(i, slot, now)?;
        for partner in [body.partner, slot.partner] {
            let grain = partner.as_grain().is_some_and(|k| k < count && k != i);
            let plane = partner.as_plane().is_some_and(|p| p < planes);
            if !(grain || plane || partner == Partner::NOTHING) {
                let wanted = "another grain, a plane or nothing";
                let word = f64::from(partner.word());
                return Err(Fault::input(Subject::Grain(i), "partner", word, wanted));
            }
        }
    }
    Ok(())
}

fn check_body<S: Scalar, const D: usize>(i: usize, body: &Body<S, D>, now: S) -> Result<(), Fault> {
    let no = |field, value: S, wanted| {
        Err(Fault::input(Subject::Grain(i), field, value.to_f64(), wanted))
    };
    if !(body.clock >= S::zero() && body.clock <= now) {
        return no("clock", body.clock, "at least 0 and at most the present");
    }
    if !(body.release_at >= now && body.release_at <= S::NEVER) {
        return no("release_at", body.release_at, "not before the present");
    }
    if !body.moment.is_number() {
        return no("moment", body.moment, "a finite number");
    }
    match body.release.iter().find(|x| !x.is_number()) {
        Some(&x) => no("release", x, "a finite number"),
        None => Ok(()),
    }
}

fn check_slot<S: Scalar>(i: usize, slot: &Slot<S>, now: S) -> Result<(), Fault> {
    let idle = slot.kind == Kind::Nothing;
    let due = slot.time >= now && slot.time < S::NEVER && slot.meeting >= slot.time;
    if idle && slot.time == S::NEVER || !idle && due {
        return Ok(());
    }
    let wanted = "not before the present, and never for a grain without an event";
    Err(Fault::input(Subject::Grain(i), "time of its event", slot.time.to_f64(), wanted))
}

/// Counters near the end of their range would overflow.
fn check_counters(counters: &Counters) -> Result<(), Fault> {
    if counters.largest() < 1 << 60 {
        return Ok(());
    }
    let wanted = "below 2^60";
    Err(Fault::input(Subject::World, "a counter", counters.largest() as f64, wanted))
}
