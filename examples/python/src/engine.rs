//! How does a method go on from Python? Keeps a method with what it measures; lets Ctrl-C stop it between two events.

use anyhow::{Context, Result, bail, ensure};
use carom_host::method::{self, Method, Running};
use carom_host::observe::{Recorder, Table};
use carom_host::run::{self, Attendant, Ended, Plan, Position};
use carom_host::scenario::{MethodName, Placed, Scenario, Start};
use pyo3::Python;
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// A method at work.
pub struct Engine {
    name: MethodName,
    running: Running,
    recorder: Option<Recorder>,
    plan: Plan,
    position: Position,
}

/// From where an engine goes on.
#[derive(Deserialize, Serialize)]
pub struct Kept {
    method: Vec<u8>,
    measured: Option<Vec<u8>>,
    position: Position,
}

impl Engine {
    /// At the start of a scenario, or from where it was kept.
    pub fn new(
        scenario: &Scenario,
        name: MethodName,
        kept: Option<&Kept>,
    ) -> Result<(Start, Self)> {
        let chosen = scenario.clone().with_method(name)?;
        let start = Start::new(&chosen)?;
        let running = method::begin(name, &chosen, &start, kept.map(|kept| &*kept.method))?;
        let measured = kept.and_then(|kept| kept.measured.as_deref());
        let recorder = Recorder::new(&chosen, &start, measured)?;
        let position = kept.map_or_else(Position::default, |kept| kept.position);
        Ok((start, Self { name, running, recorder, plan: Plan::new(scenario), position }))
    }

    /// What the method says.
    pub fn ask<T>(&mut self, question: impl FnOnce(&mut dyn Method) -> T) -> T {
        self.running.with(question)
    }

    /// The grains as they are now.
    pub fn grains(&mut self) -> Vec<Placed> {
        self.ask(|method| method.grains())
    }

    fn work<T>(
        &mut self,
        work: impl FnOnce(&mut dyn Method, &Plan, &mut Position, &mut Watch<'_>) -> Result<T>,
    ) -> Result<T> {
        let Self { running, recorder, plan, position, .. } = self;
        let mut watch = Watch { recorder: recorder.as_mut(), looked: Instant::now() };
        running.with(|method| work(method, plan, position, &mut watch))
    }

    /// Goes on to the next sample and returns its time; none after the last.
    pub fn next_sample(&mut self) -> Result<Option<f64>> {
        self.work(|method, plan, position, watch| {
            if plan.is_over(method.time(), method.collisions()) {
                return Ok(None);
            }
            match run::next_sample(method, plan, position, watch)? {
                Some(Ended::BrokenOff(why)) => Err(why),
                _ => Ok(Some(method.time())),
            }
        })
    }

    /// Goes on to an instant.
    pub fn come_to(&mut self, time: f64) -> Result<()> {
        ensure!(time.is_finite(), "time to advance to is {time}, must be a finite number");
        let come = self.work(|method, plan, position, watch| {
            run::come_to(method, time, plan, position, watch)?
        });
        self.leave_behind();
        come
    }

    /// Samples that lie behind are none any more, also where an error or Ctrl-C ended the way.
    fn leave_behind(&mut self) {
        let passed = (self.ask(|method| method.time()) / self.plan.sample + 1e-9).floor() as u64;
        self.position.sample = self.position.sample.max(passed + 1);
    }

    /// So many events happen; false if nothing ever happens any more.
    pub fn step(&mut self, events: u64) -> Result<bool> {
        if matches!(self.name, MethodName::Md | MethodName::Exact) {
            bail!("{} has no events: advance_to a time", self.name.label());
        }
        let stepped = self.work(|method, plan, position, watch| {
            for _ in 0..events {
                let Some(time) = method.next_event_time() else { return Ok(false) };
                while let Some(look) = plan.look(position, time) {
                    run::come_to(method, look, plan, position, watch)??;
                }
                // A time as a number may be a little before the instant that it stands for.
                method.advance_within(time.next_up(), 1)?;
                watch.pause(method, position)?;
            }
            Ok(true)
        });
        self.leave_behind();
        stepped
    }

    /// The tables of what was measured; none if nothing is to be.
    pub fn tables(&self) -> Option<Vec<Table>> {
        self.recorder.as_ref().map(Recorder::tables)
    }

    /// From where it can go on.
    pub fn keep(&mut self) -> Result<Kept> {
        let label = self.name.label();
        let method = self.ask(|method| method.save())?;
        let method = method.with_context(|| format!("{label} cannot be saved"))?;
        let measured = self.recorder.as_ref().map(Recorder::save).transpose()?;
        Ok(Kept { method, measured, position: self.position })
    }
}

/// Measures, and lets Ctrl-C stop the run.
struct Watch<'a> {
    recorder: Option<&'a mut Recorder>,
    looked: Instant,
}

/// How often signals are looked for.
const PATIENCE: Duration = Duration::from_millis(50);

impl Attendant for Watch<'_> {
    fn sample(&mut self, _: &mut dyn Method, _: f64) -> Result<()> {
        Ok(())
    }

    fn look(&mut self, method: &mut dyn Method, time: f64) {
        let tally = method.take_tally();
        if let Some(recorder) = &mut self.recorder {
            recorder.look(time, &tally, &method.grains());
        }
    }

    fn pause(&mut self, _: &mut dyn Method, _: &Position) -> Result<()> {
        if self.looked.elapsed() < PATIENCE {
            return Ok(());
        }
        self.looked = Instant::now();
        Ok(Python::attach(|py| py.check_signals())?)
    }
}
