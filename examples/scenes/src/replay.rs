//! How does a scene run, event by event? Reads a scene; writes digests to a callback.

use carom::law::Rule;
use carom::{Error, Instant, Memory, Scalar, World};

use crate::hourglass;
use crate::scene::{self, Number, Scene};

/// The digest of the state after so many events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EventDigest {
    /// How many events have happened.
    pub event: u32,
    /// The digest of the state after them.
    pub digest: u64,
}

/// After which events the digest is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// The last event; the run ends after it.
    pub last: u32,
    /// Of all events after `from`, those whose number is a multiple of this are reported.
    pub every: u32,
    /// Nothing is reported up to this event.
    pub from: u32,
}

impl Selection {
    /// Every thousandth event up to `last`.
    #[must_use]
    pub fn every_thousandth(last: u32) -> Self {
        Self { last, every: 1000, from: 0 }
    }

    /// Every event after `from` up to `last`.
    #[must_use]
    pub fn each(from: u32, last: u32) -> Self {
        Self { last, every: 1, from }
    }
}

/// How a scene is run in one number type.
pub type Run = fn(Selection, &mut dyn FnMut(EventDigest)) -> Result<(), Error>;

/// How this scene is run in this number type. A program that names only some of them carries only
/// their code and tables.
#[must_use]
pub fn replay<S: Number>(scene: Scene) -> Run {
    match scene {
        Scene::Fig6 => fig6::<S>,
        Scene::Box16 => box16::<S>,
        Scene::Gas32 => gas32::<S>,
        Scene::Column10 => column10::<S>,
        Scene::Heap16 => heap16::<S>,
        Scene::Hard16 => hard16::<S>,
        Scene::Rough16 => rough16::<S>,
        Scene::Hourglass16 => hourglass16::<S>,
    }
}

/// Runs [`Scene::Fig6`] and reports the digests.
///
/// # Errors
/// Any error of the engine, or [`Error::Full`] if the scene comes to an end before its last event.
pub fn fig6<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 2, 2>::new();
    let rule = scene::spring::<S>();
    run(&mut scene::fig6(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Box16`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn box16<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 2, 16>::new();
    let rule = scene::paper_rubber::<S>();
    turning(&mut scene::box16(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Gas32`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn gas32<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 3, 32>::new();
    let rule: &dyn Rule<S> = &scene::elastic::<S>();
    run(&mut scene::gas32(&mut memory, rule, 16)?, selection, report)
}

/// Runs [`Scene::Column10`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn column10<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 1, 10>::new();
    let rule = scene::bead::<S>();
    run(&mut scene::column10(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Heap16`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn heap16<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 2, 16>::new();
    let rule = scene::heaped_rubber::<S>();
    turning(&mut scene::box16(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Hard16`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn hard16<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = Memory::<S, 2, 16>::new();
    let rule = scene::hard::<S>();
    turning(&mut scene::box16(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Rough16`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn rough16<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = scene::rough_box::<S>();
    let rule = scene::rough::<S>();
    turning(&mut scene::box16(&mut memory, &rule)?, selection, report)
}

/// Runs [`Scene::Hourglass16`] and reports the digests.
///
/// # Errors
/// As [`fig6`].
pub fn hourglass16<S: Number>(
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let mut memory = hourglass::roofed::<S>();
    let rule = scene::hard::<S>();
    turning(&mut hourglass::hourglass16(&mut memory, &rule)?, selection, report)
}

/// Steps through all events.
fn run<S: Scalar, const D: usize, R: Rule<S>>(
    world: &mut World<'_, S, D, R>,
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    for number in 1..=selection.last {
        if world.step()?.is_none() {
            return Err(ended(number));
        }
        selection.report(number, world, report);
    }
    Ok(())
}

/// Steps through all events, turning gravity by a quarter every [`scene::QUARTER`] milliseconds.
fn turning<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    selection: Selection,
    report: &mut dyn FnMut(EventDigest),
) -> Result<(), Error> {
    let (mut number, mut quarters) = (0, 0);
    while number < selection.last {
        let turn = Instant::from(f64::from(scene::QUARTER) * f64::from(quarters + 1));
        if world.next_event_time().is_some_and(|next| next < turn) {
            world.step()?;
            number += 1;
            selection.report(number, world, report);
        } else {
            quarters += 1;
            // A stale event may have been the next one, and the one after it later than the turn.
            world.advance_to(turn.max(world.now()))?;
            world.set_gravity(scene::turned(quarters))?;
        }
    }
    Ok(())
}

impl Selection {
    fn report<S: Scalar, const D: usize, R>(
        self,
        number: u32,
        world: &World<'_, S, D, R>,
        report: &mut dyn FnMut(EventDigest),
    ) {
        if number > self.from && number % self.every.max(1) == 0 {
            report(EventDigest { event: number, digest: world.digest() });
        }
    }
}

fn ended(number: u32) -> Error {
    Error::Full { knob: "the scene, which has no further event,", capacity: number as usize }
}
