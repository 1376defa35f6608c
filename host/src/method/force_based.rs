//! How is a run of the reference a method? Reads and writes the run; hands out its state as the comparison needs it.

use super::interface::{Method, three};
use crate::scenario::{MethodName, Placed, Side, Start};
use anyhow::Result;
use carom_reference::{Exact, Verlet};

/// A run of the reference as a method.
#[derive(Debug)]
pub struct ForceBased<R> {
    run: R,
    sides: [Side; 3],
}

impl<R> ForceBased<R> {
    /// Wraps a run that has just started.
    pub const fn new(run: R, start: &Start) -> Self {
        Self { run, sides: start.sides }
    }

    /// Grains with their positions inside the box.
    fn inside<const D: usize>(&self, grains: Vec<carom_reference::Grain<D>>) -> Vec<Placed> {
        let wrap = |axis: usize, x: f64| match self.sides[axis] {
            Side::Periodic([from, to]) => from + (x - from).rem_euclid(to - from),
            _ => x,
        };
        let placed = |grain: carom_reference::Grain<D>| Placed {
            radius: grain.radius,
            mass: grain.mass,
            position: three(&std::array::from_fn::<f64, D, _>(|k| wrap(k, grain.position[k]))),
            velocity: three(&grain.velocity),
        };
        grains.into_iter().map(placed).collect()
    }
}

fn kinetic_energy<const D: usize>(grains: &[carom_reference::Grain<D>]) -> f64 {
    let square =
        |grain: &carom_reference::Grain<D>| grain.velocity.iter().map(|v| v * v).sum::<f64>();
    grains.iter().map(|grain| 0.5 * grain.mass * square(grain)).sum()
}

impl<const D: usize> Method for ForceBased<Verlet<D>> {
    fn name(&self) -> MethodName {
        MethodName::Md
    }

    fn time(&self) -> f64 {
        self.run.now()
    }

    fn advance_to(&mut self, time: f64) -> Result<()> {
        Ok(self.run.advance_to(time)?)
    }

    fn grains(&self) -> Vec<Placed> {
        self.inside(self.run.grains())
    }

    fn kinetic_energy(&self) -> f64 {
        kinetic_energy(&self.run.grains())
    }

    fn collisions(&self) -> u64 {
        self.run.statistics().contacts
    }

    fn statistics(&self) -> Vec<(&'static str, u64)> {
        let c = self.run.statistics();
        vec![
            ("contacts", c.contacts),
            ("steps", c.steps),
            ("distances", c.distances),
            ("forces", c.forces),
            ("lists", c.lists),
        ]
    }
}

impl<const D: usize> Method for ForceBased<Exact<D>> {
    fn name(&self) -> MethodName {
        MethodName::Exact
    }

    fn time(&self) -> f64 {
        self.run.now()
    }

    fn advance_to(&mut self, time: f64) -> Result<()> {
        Ok(self.run.advance_to(time)?)
    }

    fn grains(&self) -> Vec<Placed> {
        self.inside(self.run.grains())
    }

    fn kinetic_energy(&self) -> f64 {
        kinetic_energy(&self.run.grains())
    }

    fn collisions(&self) -> u64 {
        self.run.records().len() as u64
    }

    fn statistics(&self) -> Vec<(&'static str, u64)> {
        vec![("contacts", self.run.records().len() as u64), ("steps", self.run.steps())]
    }
}
