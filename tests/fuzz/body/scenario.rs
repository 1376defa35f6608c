//! Is any text a scenario, or refused in one line? Reads bytes; writes nothing, panics if it is neither.

use anyhow::Result;
use carom_host::method::{self, Method};
use carom_host::scenario::{MethodName, Scenario, Start};

/// Grains that one input may have; more say nothing new.
const MAX_GRAINS: usize = 60;
/// Events that one input may take.
const EVENTS: u64 = 3000;
/// Advances of one input: each goes twice as far as the one before.
const ADVANCES: i32 = 60;

/// Parses a scenario, starts it and runs it by every event-driven method.
///
/// # Errors
/// Why it was refused.
pub fn run(bytes: &[u8]) -> Result<()> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    one_line(Scenario::parse(text)).and_then(|scenario| started(&scenario))
}

fn started(scenario: &Scenario) -> Result<()> {
    if scenario.gas.as_ref().is_some_and(|gas| gas.count > MAX_GRAINS)
        || scenario.grains.len() > MAX_GRAINS
        || scenario.species.iter().any(|species| species.count.is_none_or(|n| n > MAX_GRAINS))
    {
        return Ok(());
    }
    let start = one_line(Start::new(scenario))?;
    let methods = match scenario.laws().any(|law| law.has_force()) {
        false => &[MethodName::Emd][..],
        true => &[MethodName::Emd, MethodName::EmdStar],
    };
    methods.iter().try_for_each(|name| {
        one_line(method::with(*name, scenario, &start, |method| advance(method, scenario)))
    })
}

/// Doubles the time until the events are used up or the scenario is over.
fn advance(method: &mut dyn Method, scenario: &Scenario) -> Result<()> {
    let end = scenario.duration.unwrap_or(1e6 * scenario.sample);
    for remaining in (0..ADVANCES).rev() {
        let before = method.time();
        method.advance_to(end * 0.5_f64.powi(remaining))?;
        assert!(method.time() >= before, "time went back from {before} to {}", method.time());
        assert!(!method.kinetic_energy().is_nan(), "kinetic energy is not a number");
        let events: u64 = method.statistics().iter().map(|(_, count)| count).sum();
        if events > EVENTS {
            break;
        }
    }
    Ok(())
}

/// An error is one line.
fn one_line<T>(result: Result<T>) -> Result<T> {
    if let Err(error) = &result {
        let text = format!("{error:#}");
        assert_eq!(text.lines().count(), 1, "{text:?}");
    }
    result
}
