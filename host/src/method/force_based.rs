//! How is a run of the reference a method? Reads and writes the run; hands out its state as the comparison needs it.

use super::interface::{Method, three};
use crate::observe::{Given, Layout};
use crate::scenario::{MethodName, Placed, Side, Start};
use anyhow::{Context, Result, ensure};
use carom::particle::Partner as Touched;
use carom::world::Transfer;
use carom_reference::{ContactStep, Exact, Grain, Partner, ReferenceError, Verlet};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A run of the reference.
pub trait Run<const D: usize>: Serialize + DeserializeOwned {
    /// Which method it is.
    const NAME: MethodName;

    /// The present (s).
    fn now(&self) -> f64;

    /// Goes on to an instant, or pauses after some events; whether it has arrived. What contacts give is added up.
    ///
    /// # Errors
    /// An error of the reference.
    fn go_on(
        &mut self,
        time: f64,
        events: u32,
        given: Option<&mut Given>,
    ) -> Result<bool, ReferenceError>;

    /// All grains as they are now.
    fn grains(&self) -> Vec<Grain<D>>;

    /// How often everything happened; contacts come first.
    fn counted(&self) -> Vec<(&'static str, u64)>;
}

/// A run of the reference as a method.
#[derive(Debug)]
pub struct ForceBased<const D: usize, R> {
    run: R,
    sides: [Side; 3],
    given: Option<Given>,
}

impl<const D: usize, R: Run<D>> ForceBased<D, R> {
    /// Wraps a run that has just started, or goes on from a state that [`Method::save`] gave.
    ///
    /// # Errors
    /// When the state is not one of such a run.
    pub fn new(
        begin: impl FnOnce() -> Result<R>,
        state: Option<&[u8]>,
        start: &Start,
        layout: Option<&Layout>,
    ) -> Result<Self> {
        let mut given = layout.map(Given::new);
        let run = match state {
            None => begin()?,
            Some(bytes) => {
                let damaged = "the saved state is damaged";
                let (checksum, rest): (u32, Vec<u8>) =
                    postcard::from_bytes(bytes).context(damaged)?;
                ensure!(crc32fast::hash(&rest) == checksum, damaged);
                let (run, sums): (R, Option<Vec<f64>>) =
                    postcard::from_bytes(&rest).context(damaged)?;
                if let (Some(given), Some(sums)) = (&mut given, sums) {
                    given.set(&sums);
                }
                run
            }
        };
        Ok(Self { run, sides: start.sides, given })
    }

    /// Grains with their positions inside the box.
    fn inside(&self, grains: Vec<Grain<D>>) -> Vec<Placed> {
        let wrap = |axis: usize, x: f64| match self.sides[axis] {
            Side::Periodic([from, to]) => from + (x - from).rem_euclid(to - from),
            _ => x,
        };
        let placed = |grain: Grain<D>| Placed {
            radius: grain.radius,
            mass: grain.mass,
            position: three(&std::array::from_fn::<f64, D, _>(|k| wrap(k, grain.position[k]))),
            velocity: three(&grain.velocity),
        };
        grains.into_iter().map(placed).collect()
    }
}

impl<const D: usize, R: Run<D>> Method for ForceBased<D, R> {
    fn name(&self) -> MethodName {
        R::NAME
    }

    fn time(&self) -> f64 {
        self.run.now()
    }

    fn advance_to(&mut self, time: f64) -> Result<()> {
        while !self.advance_within(time, u32::MAX)? {}
        Ok(())
    }

    fn advance_within(&mut self, time: f64, events: u32) -> Result<bool> {
        Ok(self.run.go_on(time, events, self.given.as_mut())?)
    }

    fn save(&self) -> Result<Option<Vec<u8>>> {
        let sums = self.given.as_ref().map(Given::sums);
        let state = postcard::to_stdvec(&(&self.run, sums))?;
        Ok(Some(postcard::to_stdvec(&(crc32fast::hash(&state), state))?))
    }

    fn grains(&self) -> Vec<Placed> {
        self.inside(self.run.grains())
    }

    fn kinetic_energy(&self) -> f64 {
        let square = |grain: &Grain<D>| grain.velocity.iter().map(|v| v * v).sum::<f64>();
        self.run.grains().iter().map(|grain| 0.5 * grain.mass * square(grain)).sum()
    }

    fn collisions(&self) -> u64 {
        self.run.counted().first().map_or(0, |(_, count)| *count)
    }

    fn statistics(&self) -> Vec<(&'static str, u64)> {
        self.run.counted()
    }

    fn take_tally(&mut self) -> Vec<f64> {
        let now = self.run.now();
        self.given.as_mut().map(|given| given.take(now)).unwrap_or_default()
    }
}

/// Steps of one grain that take about as long as an event.
const STEPS: u64 = 100;

impl<const D: usize> Run<D> for Verlet<D> {
    const NAME: MethodName = MethodName::Md;

    fn now(&self) -> f64 {
        Verlet::now(self)
    }

    fn go_on(
        &mut self,
        time: f64,
        events: u32,
        given: Option<&mut Given>,
    ) -> Result<bool, ReferenceError> {
        let steps = (STEPS * u64::from(events) / self.len().max(1) as u64).max(1);
        let Some(given) = given else { return self.advance_observed(time, steps, None) };
        let mut tell =
            |contact: &ContactStep<D>| given.add(&transfer(contact, given), contact.step);
        self.advance_observed(time, steps, Some(&mut tell))
    }

    fn grains(&self) -> Vec<Grain<D>> {
        Verlet::grains(self)
    }

    fn counted(&self) -> Vec<(&'static str, u64)> {
        let c = Verlet::statistics(self);
        vec![
            ("contacts", c.contacts),
            ("steps", c.steps),
            ("distances", c.distances),
            ("forces", c.forces),
            ("lists", c.lists),
        ]
    }
}

/// What a contact gives in a step, as the engine would say it.
fn transfer<const D: usize>(contact: &ContactStep<D>, given: &Given) -> Transfer<f64, D> {
    let ContactStep { grain, ref force, ref separation, velocities: [own, other], step, .. } =
        *contact;
    let along = |velocity: &[f64; D]| -> f64 { (0..D).map(|k| force[k] * velocity[k]).sum() };
    let relative = std::array::from_fn(|k| own[k] - other[k]);
    let (partner, work) = match contact.partner {
        Partner::Grain(with) => (Touched::grain(with), -along(&relative) * step),
        // What a wall that moves gives is not the grain's.
        Partner::Wall { axis, upper } => {
            (Touched::plane(given.plane(axis, upper)), -along(&own) * step)
        }
    };
    let approach = || {
        let nearing: f64 = (0..D).map(|k| -separation[k] * relative[k]).sum();
        nearing / separation.iter().map(|r| r * r).sum::<f64>().sqrt()
    };
    Transfer {
        grain,
        partner,
        impulse: force.map(|force| force * step).into(),
        position: contact.position.into(),
        separation: (*separation).into(),
        work,
        approach: contact.began.then(approach),
    }
}

impl<const D: usize> Run<D> for Exact<D> {
    const NAME: MethodName = MethodName::Exact;

    fn now(&self) -> f64 {
        Exact::now(self)
    }

    fn go_on(
        &mut self,
        time: f64,
        events: u32,
        _: Option<&mut Given>,
    ) -> Result<bool, ReferenceError> {
        self.advance_within(time, u64::from(events))
    }

    fn grains(&self) -> Vec<Grain<D>> {
        Exact::grains(self)
    }

    fn counted(&self) -> Vec<(&'static str, u64)> {
        vec![("contacts", self.records().len() as u64), ("steps", self.steps())]
    }
}
