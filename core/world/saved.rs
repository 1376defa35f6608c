//! How is a world put away and taken up again? Reads and writes the whole state.

use super::World;
use super::memory::Lend;
use crate::event::Slot;
use crate::event::scene::{Counters, Release};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::grid::Grid;
use crate::matter::{Body, Boundary};
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
    boundary: Boundary<S, D>,
    grid: Option<Grid<S, D>>,
    gravity: Vector<S, D>,
    now: S,
    epoch: Instant,
    release: Release,
    counters: Counters,
    since_epoch: u32,
    at_once: u32,
    bodies: B,
    slots: Q,
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// The whole state, borrowed.
    #[must_use]
    pub fn save(&self) -> Saved<S, D, &[Body<S, D>], &[Slot<S>]> {
        Saved {
            boundary: self.scene.boundary.clone(),
            grid: self.scene.cells.grid,
            gravity: self.scene.gravity,
            now: self.scene.now,
            epoch: self.scene.epoch,
            release: self.scene.release,
            counters: self.scene.counters,
            since_epoch: self.since_epoch,
            at_once: self.at_once,
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
        check(bodies, slots, saved.now)?;
        let grains = bodies.iter().map(Body::as_grain);
        let mut world = World::setup(memory).rule(rule).grains(grains)?.build()?;
        world.scene.bodies.copy_from_slice(bodies);
        world.scene.boundary = saved.boundary.clone();
        world.scene.take_grid(saved.grid)?;
        world.scene.gravity = saved.gravity;
        world.scene.now = saved.now;
        world.scene.epoch = saved.epoch;
        world.scene.release = saved.release;
        world.scene.counters = saved.counters;
        world.since_epoch = saved.since_epoch;
        world.at_once = saved.at_once;
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
) -> Result<(), Fault> {
    let count = bodies.len();
    if slots.len() != count {
        let wanted = "one for each grain";
        return Err(Fault::input(Subject::World, "number of slots", slots.len() as f64, wanted));
    }
    if !now.is_number() {
        return Err(Fault::input(Subject::World, "now", now.to_f64(), "a finite number"));
    }
    let known = |p: crate::matter::Partner| p.as_grain().is_none_or(|k| k < count);
    for (i, (body, slot)) in bodies.iter().zip(slots).enumerate() {
        let subject = Subject::Grain(i);
        if !(body.clock <= now) {
            return Err(Fault::input(subject, "clock", body.clock.to_f64(), "at most the present"));
        }
        if !known(body.partner) || !known(slot.partner) {
            let word = f64::from(body.partner.word());
            return Err(Fault::input(subject, "partner", word, "the number of a grain or plane"));
        }
    }
    Ok(())
}
