//! What is measured of a method that runs to its end? Reads a scenario; writes nothing, hands out what a recorder has seen.

use crate::method::{self, Method};
use crate::observe::Recorder;
use crate::run::{self, Attendant, Plan, Position};
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::{Context, Result};

/// Runs a scenario by a method and measures what its table `[observe]` asks for; nothing is written.
///
/// # Errors
/// Those of the method; a scenario without `[observe]`, or with one that does not fit it.
///
/// ```
/// use carom_host::{measure, scenario::{MethodName, Scenario, Start}};
/// let scenario = Scenario::parse("dimension = 2\nduration = 2.0\nsample = 2.0\n\
///     law = { kind = \"constant\", restitution = 1.0 }\n\
///     box = { x = { kind = \"periodic\" }, y = { kind = \"periodic\" }, packing_fraction = 0.2 }\n\
///     species = [{ count = 50, radius = 0.01, density = 2500.0, temperature = 1e-2 }]\n\
///     observe = { every = 0.01 }").unwrap();
/// let start = Start::new(&scenario).unwrap();
/// let recorder = measure::run(MethodName::Emd, &scenario, &start).unwrap();
/// let pressure = recorder.means().into_iter().find(|(quantity, _)| quantity.name == "pressure");
/// assert!(pressure.unwrap().1.value > 0.0);
/// ```
pub fn run(name: MethodName, scenario: &Scenario, start: &Start) -> Result<Recorder> {
    method::with(name, scenario, start, |method| attend(method, scenario, start))
}

/// As [`run()`], of a method that is there already.
///
/// # Errors
/// As [`run()`].
pub fn attend(method: &mut dyn Method, scenario: &Scenario, start: &Start) -> Result<Recorder> {
    let recorder = Recorder::new(scenario, start, None)?;
    let mut looker = Looker(recorder.context("the scenario has no table [observe]")?);
    let plan = Plan::new(scenario);
    run::attend(method, &plan, &mut Position::default(), &mut looker)?.whole()?;
    Ok(looker.0)
}

/// Only looks.
struct Looker(Recorder);

impl Attendant for Looker {
    fn sample(&mut self, _: &mut dyn Method, _: f64) -> Result<()> {
        Ok(())
    }

    fn look(&mut self, method: &mut dyn Method, time: f64) {
        let tally = method.take_tally();
        self.0.look(time, &tally, &method.grains());
    }
}
