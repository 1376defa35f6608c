//! How does one method get from start to end? Reads a method and a plan; hands out samples, and pauses in between.

use crate::method::{LoggedEvent, Method};
use crate::observe::Looks;
use crate::progress::Progress;
use crate::scenario::{Placed, Scenario};
use anyhow::{Error, Result, anyhow};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// The state of a method at one time.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The time (s).
    pub time: f64,
    /// All grains.
    pub grains: Vec<Placed>,
    /// The angular velocity of each grain (1/s); nothing where grains are smooth.
    pub rotations: Vec<[f64; 3]>,
    /// Kinetic energy of rotation (J).
    pub rotational_energy: f64,
    /// Kinetic energy (J).
    pub kinetic_energy: f64,
    /// Contacts so far.
    pub collisions: u64,
    /// Everything that was counted so far.
    pub statistics: Vec<(&'static str, u64)>,
    /// How many grains move in which way.
    pub motions: Vec<(&'static str, usize)>,
    /// Events since the last sample, if a log was asked for.
    pub events: Vec<LoggedEvent>,
}

impl Sample {
    /// What a method has now.
    pub fn take(method: &mut dyn Method, time: f64) -> Self {
        let grains = method.grains();
        Self::of(method, time, grains)
    }

    /// The same, of grains that have been looked at already.
    pub fn of(method: &mut dyn Method, time: f64, grains: Vec<Placed>) -> Self {
        Self {
            time,
            grains,
            rotations: method.rotations(),
            rotational_energy: method.rotational_energy(),
            kinetic_energy: method.kinetic_energy(),
            collisions: method.collisions(),
            statistics: method.statistics(),
            motions: method.motions(),
            events: method.take_events(),
        }
    }
}

/// When a run ends, and at what times it is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Time between two samples.
    pub sample: f64,
    /// Last instant, if the scenario gives one.
    pub duration: f64,
    /// Collisions to run, if the scenario gives them.
    pub collisions: u64,
    /// When the attendant looks besides, if something is measured.
    pub looks: Option<Looks>,
}

/// So many samples without a collision: there will never be enough of them, or samples are too close.
const IDLE: u64 = 100_000;

impl Plan {
    /// The plan of a scenario.
    pub fn new(scenario: &Scenario) -> Self {
        Self {
            sample: scenario.sample,
            duration: scenario.duration.unwrap_or(f64::INFINITY),
            collisions: scenario.collisions.unwrap_or(u64::MAX),
            looks: scenario.observe.as_ref().map(|spec| Looks::new(spec, scenario.sample)),
        }
    }

    /// The same samples until a given instant.
    pub const fn until(self, duration: f64) -> Self {
        Self { duration, collisions: u64::MAX, ..self }
    }

    /// The same samples, at most until a given instant: a part of them, so that sample stays sample.
    #[must_use]
    pub fn at_most(self, limit: Option<f64>) -> Self {
        match limit {
            Some(limit) if limit < self.duration => {
                Self { duration: (limit / self.sample + 1e-9).floor() * self.sample, ..self }
            }
            _ => self,
        }
    }

    /// The instant of a sample: multiples of the interval, and the end.
    pub fn instant(&self, number: u64) -> f64 {
        let time = number as f64 * self.sample;
        // A last interval that differs from the others by round-off only is no interval.
        if time > self.duration - 1e-9 * self.sample { self.duration } else { time }
    }

    /// The next look, if it is due by this time.
    pub fn look(&self, position: &Position, by: f64) -> Option<f64> {
        self.looks.map(|looks| looks.instant(position.look)).filter(|time| *time <= by)
    }

    /// Whether a run that has come so far is over.
    pub fn is_over(&self, time: f64, collisions: u64) -> bool {
        time >= self.duration || collisions >= self.collisions
    }

    /// What is wrong with a run that waits for collisions that do not come.
    fn impatience(&self, position: &Position) -> Option<Error> {
        let idle = position.sample - position.last_busy;
        (self.collisions < u64::MAX && idle >= IDLE).then(|| {
            let Self { sample, collisions, .. } = self;
            anyhow!(
                "sample is {sample}: there was no collision in the last {IDLE} samples, and collisions must be {collisions}; samples must be further apart, or nothing collides any more"
            )
        })
    }
}

/// How far a run has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// The number of the sample that comes next.
    pub sample: u64,
    /// The number of the look that comes next.
    pub look: u64,
    /// Seconds that the method took, sampling excluded.
    pub seconds: f64,
    /// The last sample before which there was a collision, and how many there were.
    last_busy: u64,
    collisions: u64,
}

impl Position {
    fn count(&mut self, collisions: u64) {
        if collisions > self.collisions {
            (self.last_busy, self.collisions) = (self.sample, collisions);
        }
        self.sample += 1;
    }
}

/// How a run ended.
#[derive(Debug)]
#[must_use]
pub enum Ended {
    /// As planned.
    Whole,
    /// By an error of the method: what was sampled before is good.
    BrokenOff(Error),
}

impl Ended {
    /// A run that broke off is an error.
    ///
    /// # Errors
    /// That of the method.
    pub fn whole(self) -> Result<()> {
        match self {
            Self::Whole => Ok(()),
            Self::BrokenOff(why) => Err(why),
        }
    }
}

/// Who attends a run.
pub trait Attendant {
    /// The method has come to a sample.
    ///
    /// # Errors
    /// Ends the run.
    fn sample(&mut self, method: &mut dyn Method, time: f64) -> Result<()>;

    /// The method has come to where it is to be looked at, besides samples.
    fn look(&mut self, method: &mut dyn Method, time: f64) {
        let _ = (method, time);
    }

    /// The method has worked a little, and would go on.
    ///
    /// # Errors
    /// Ends the run.
    fn pause(&mut self, method: &mut dyn Method, position: &Position) -> Result<()> {
        let _ = (method, position);
        Ok(())
    }
}

/// Events between two pauses: some thousandths of a second, more where large clusters make steps.
const EVENTS: u32 = 1_000;

/// Runs a method from where it stands to its end.
///
/// # Errors
/// An error of the attendant.
pub fn attend(
    method: &mut dyn Method,
    plan: &Plan,
    position: &mut Position,
    attendant: &mut impl Attendant,
) -> Result<Ended> {
    loop {
        if let Some(ended) = next_sample(method, plan, position, attendant)? {
            return Ok(ended);
        }
        attendant.pause(method, position)?;
    }
}

/// Goes on to the next sample; how the run ended if it was the last.
///
/// # Errors
/// An error of the attendant.
pub fn next_sample(
    method: &mut dyn Method,
    plan: &Plan,
    position: &mut Position,
    attendant: &mut impl Attendant,
) -> Result<Option<Ended>> {
    let time = plan.instant(position.sample);
    if let Err(why) = come_to(method, time, plan, position, attendant)? {
        return Ok(Some(Ended::BrokenOff(why)));
    }
    attendant.sample(method, time)?;
    position.count(method.collisions());
    if plan.is_over(time, method.collisions()) {
        return Ok(Some(Ended::Whole));
    }
    Ok(plan.impatience(position).map(Ended::BrokenOff))
}

/// Goes on to an instant, with the looks that are due until then; the inner error is the method's.
///
/// # Errors
/// An error of the attendant.
pub fn come_to(
    method: &mut dyn Method,
    time: f64,
    plan: &Plan,
    position: &mut Position,
    attendant: &mut impl Attendant,
) -> Result<Result<()>> {
    while let Some(look) = plan.look(position, time) {
        if let Err(why) = advance(method, look, position, attendant)? {
            return Ok(Err(why));
        }
        attendant.look(method, look);
        position.look += 1;
        attendant.pause(method, position)?;
    }
    advance(method, time, position, attendant)
}

/// Goes on to an instant, with pauses; the inner error is the method's.
fn advance(
    method: &mut dyn Method,
    time: f64,
    position: &mut Position,
    attendant: &mut impl Attendant,
) -> Result<Result<()>> {
    loop {
        let begin = Instant::now();
        let advanced = method.advance_within(time, EVENTS);
        position.seconds += begin.elapsed().as_secs_f64();
        match advanced {
            Ok(true) => return Ok(Ok(())),
            Ok(false) => attendant.pause(method, position)?,
            Err(why) => return Ok(Err(why)),
        }
    }
}

/// Runs a method and hands each sample on; returns the seconds the method took, sampling excluded.
///
/// # Errors
/// An error of the method or of `each`.
pub fn drive(
    method: &mut dyn Method,
    plan: &Plan,
    each: impl FnMut(&Sample) -> Result<()>,
) -> Result<f64> {
    let mut position = Position::default();
    let progress = RunProgress::new(method, plan);
    attend(method, plan, &mut position, &mut Shown { each, progress })?.whole()?;
    Ok(position.seconds)
}

/// Hands samples on and shows how far it is.
struct Shown<F> {
    each: F,
    progress: RunProgress,
}

impl<F: FnMut(&Sample) -> Result<()>> Attendant for Shown<F> {
    fn sample(&mut self, method: &mut dyn Method, time: f64) -> Result<()> {
        (self.each)(&Sample::take(method, time))
    }

    fn pause(&mut self, method: &mut dyn Method, _: &Position) -> Result<()> {
        self.progress.show(method);
        Ok(())
    }
}

/// How much of a plan is done, on a progress bar.
#[derive(Debug)]
pub struct RunProgress {
    bar: Progress,
    begin: Instant,
    /// Collisions before.
    before: u64,
    plan: Plan,
}

const PARTS: u64 = 10_000;

impl RunProgress {
    /// A method that stands somewhere in its plan.
    pub fn new(method: &dyn Method, plan: &Plan) -> Self {
        let label = method.name().label();
        let bar = Progress::of_method(label, PARTS, done(method, plan));
        Self { bar, begin: Instant::now(), before: method.collisions(), plan: *plan }
    }

    /// It has come further.
    pub fn show(&self, method: &dyn Method) {
        let (seconds, collisions) = (self.begin.elapsed().as_secs_f64(), method.collisions());
        let rate = (collisions - self.before) as f64 / seconds.max(1e-9);
        self.bar.set_message(format!("{collisions} collisions, {rate:.0}/s"));
        self.bar.set(done(method, &self.plan));
    }
}

/// How many of all parts are done.
fn done(method: &dyn Method, plan: &Plan) -> u64 {
    let part = if plan.duration.is_finite() {
        method.time() / plan.duration
    } else {
        method.collisions() as f64 / plan.collisions as f64
    };
    (part * PARTS as f64) as u64
}
