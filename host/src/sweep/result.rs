//! What did one run come to? Runs it; writes nothing, returns a row.

use super::plan::Run;
use super::table::{Cell, Column, Kind};
use crate::method::{self, Method};
use crate::run::Plan;
use crate::scenario::Start;
use anyhow::Result;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A run that is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// Its number.
    pub run: usize,
    /// A cell for each of [`columns`].
    pub cells: Vec<Cell>,
    /// How often everything happened.
    pub counters: Vec<(String, u64)>,
}

/// The columns of a result; counters follow.
pub fn columns() -> Vec<Column> {
    let named = [
        ("grains", Kind::Whole),
        ("time", Kind::Number),
        ("contacts", Kind::Whole),
        ("kinetic_energy_start", Kind::Number),
        ("kinetic_energy", Kind::Number),
        ("error", Kind::Text),
    ];
    named.map(|(name, kind)| Column { name: name.to_owned(), kind }).to_vec()
}

/// The names of all counters of all runs, in alphabetical order.
pub fn counters(all: &[Done]) -> BTreeSet<&str> {
    all.iter().flat_map(|done| done.counters.iter().map(|(name, _)| name.as_str())).collect()
}

/// Runs one run to its end. A run that fails is done as well: its row says why.
pub fn execute(number: usize, run: &Run) -> Done {
    match finish(number, run) {
        Ok(done) => done,
        Err(error) => {
            let mut cells = vec![Cell::Nothing; columns().len() - 1];
            cells.push(Cell::Text(format!("{error:#}")));
            Done { run: number, cells, counters: Vec::new() }
        }
    }
}

fn finish(number: usize, run: &Run) -> Result<Done> {
    let start = Start::new(&run.scenario)?;
    method::with(run.method, &run.scenario, &start, |method| {
        let before = method.kinetic_energy();
        advance(method, &Plan::new(&run.scenario))?;
        let whole = |count: u64| Cell::Whole(i64::try_from(count).unwrap_or(i64::MAX));
        let cells = vec![
            whole(start.grains.len() as u64),
            number_cell(method.time()),
            whole(method.collisions()),
            number_cell(before),
            number_cell(method.kinetic_energy()),
            Cell::Nothing,
        ];
        let counters = method.counters().into_iter();
        let counters = counters.map(|(name, count)| (name.to_owned(), count)).collect();
        Ok(Done { run: number, cells, counters })
    })
}

/// Goes on from sample to sample until the scenario is over, as `carom run` does.
fn advance(method: &mut dyn Method, plan: &Plan) -> Result<()> {
    for sample in 0.. {
        let time = plan.instant(sample);
        method.advance_to(time)?;
        if time >= plan.duration || method.collisions() >= plan.collisions {
            break;
        }
    }
    Ok(())
}

fn number_cell(number: f64) -> Cell {
    if number.is_finite() { Cell::Number(number) } else { Cell::Nothing }
}
