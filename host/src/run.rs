//! How does one method get from start to end? Reads a method and a scenario; hands out samples.

use crate::method::{LoggedEvent, Method};
use crate::progress::Progress;
use crate::scenario::{Placed, Scenario};
use anyhow::Result;
use std::time::{Duration, Instant};

/// The state of a method at one time.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The time (s).
    pub time: f64,
    /// All grains.
    pub grains: Vec<Placed>,
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

/// When a run ends, and at what times it is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Time between two samples.
    pub sample: f64,
    /// Last instant, if the scenario gives one.
    pub duration: f64,
    /// Collisions to run, if the scenario gives them.
    pub collisions: u64,
}

impl Plan {
    /// The plan of a scenario.
    pub fn new(scenario: &Scenario) -> Self {
        Self {
            sample: scenario.sample,
            duration: scenario.duration.unwrap_or(f64::INFINITY),
            collisions: scenario.collisions.unwrap_or(u64::MAX),
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
    pub fn instant(&self, number: u32) -> f64 {
        let time = f64::from(number) * self.sample;
        // A last interval that differs from the others by round-off only is no interval.
        if time > self.duration - 1e-9 * self.sample { self.duration } else { time }
    }
}

/// Runs a method and hands each sample on; returns the seconds the method took, sampling excluded.
///
/// # Errors
/// An error of the method or of `each`.
pub fn drive(
    method: &mut dyn Method,
    plan: &Plan,
    mut each: impl FnMut(&Sample) -> Result<()>,
) -> Result<f64> {
    let progress = RunProgress::new(method.name().label(), plan);
    let mut cost = Duration::ZERO;
    for number in 0.. {
        let time = plan.instant(number);
        let begin = Instant::now();
        method.advance_to(time)?;
        cost += begin.elapsed();
        let sample = take_sample(method, time);
        each(&sample)?;
        progress.show(&sample);
        if time >= plan.duration || sample.collisions >= plan.collisions {
            break;
        }
    }
    Ok(cost.as_secs_f64())
}

fn take_sample(method: &mut dyn Method, time: f64) -> Sample {
    Sample {
        time,
        grains: method.grains(),
        kinetic_energy: method.kinetic_energy(),
        collisions: method.collisions(),
        statistics: method.statistics(),
        motions: method.motions(),
        events: method.take_events(),
    }
}

/// How much of a plan is done, on a progress bar.
struct RunProgress {
    bar: Progress,
    begin: Instant,
    plan: Plan,
}

const PARTS: u64 = 10_000;

impl RunProgress {
    fn new(label: &'static str, plan: &Plan) -> Self {
        Self { bar: Progress::of_method(label, PARTS), begin: Instant::now(), plan: *plan }
    }

    fn show(&self, sample: &Sample) {
        let part = if self.plan.duration.is_finite() {
            sample.time / self.plan.duration
        } else {
            sample.collisions as f64 / self.plan.collisions as f64
        };
        let seconds = self.begin.elapsed().as_secs_f64().max(1e-9);
        let rate = sample.collisions as f64 / seconds;
        self.bar.set_message(format!("{} collisions, {rate:.0}/s", sample.collisions));
        self.bar.set((part * PARTS as f64) as u64);
    }
}
