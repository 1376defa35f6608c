//! What does every method have? Reads a world of the core or a run of the reference; writes its state as the comparison needs it.

use crate::observe::{Layout, Tally};
use crate::scenario::{MethodName, Placed, Side, Start};
use anyhow::Result;
use carom::World;
use carom::law::Rule;
use carom::world::{Event, EventOutcome, Motion, Observer, View};
use carom_reference::{Exact, Verlet};

/// One way to find out what the grains do.
///
/// All methods start from the same [`Start`] and have the same interface, so that a comparison needs
/// to know nothing else of them.
pub trait Method {
    /// Which one it is.
    fn name(&self) -> MethodName;

    /// The present (s).
    fn time(&self) -> f64;

    /// Goes on to an instant.
    ///
    /// # Errors
    /// An error of the method.
    fn advance_to(&mut self, time: f64) -> Result<()>;

    /// As [`Method::advance_to`], but after so many events it may stop: false if it has not arrived then.
    /// In how many calls it arrives changes nothing.
    ///
    /// # Errors
    /// An error of the method.
    fn advance_within(&mut self, time: f64, events: u32) -> Result<bool> {
        let _ = events;
        self.advance_to(time).map(|()| true)
    }

    /// The whole state, from which [`super::with_state`] goes on with the same bits; none if the method
    /// cannot be saved and must begin anew.
    ///
    /// # Errors
    /// When it cannot be put into bytes.
    fn save(&self) -> Result<Option<Vec<u8>>> {
        Ok(None)
    }

    /// All grains as they are now, inside the box where it is periodic.
    fn grains(&self) -> Vec<Placed>;

    /// Kinetic energy (J).
    fn kinetic_energy(&self) -> f64;

    /// Contacts begun so far, with grains and walls.
    fn collisions(&self) -> u64;

    /// How often everything happened, by name.
    fn statistics(&self) -> Vec<(&'static str, u64)>;

    /// How many grains move in which way now, by name; nothing where the method knows no such ways.
    fn motions(&self) -> Vec<(&'static str, usize)> {
        Vec::new()
    }

    /// What contacts have transferred and cost since the last call, if it is asked for: sums as
    /// [`Layout`] numbers them.
    fn take_tally(&mut self) -> Vec<f64> {
        Vec::new()
    }

    /// The events since the last call, if a log was asked for.
    fn take_events(&mut self) -> Vec<LoggedEvent> {
        Vec::new()
    }
}

/// Three numbers, 0 beyond the dimension.
fn three(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

/// One line of an event log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedEvent {
    /// When (s).
    pub time: f64,
    /// What happened.
    pub kind: &'static str,
    /// To which grain.
    pub grain: usize,
    /// With which grain.
    pub partner: Option<usize>,
    /// With which plane: two for each walled axis, lower one first.
    pub plane: Option<usize>,
}

/// A world of the core as a method.
pub struct EventDriven<'m, const D: usize, R> {
    world: World<'m, f64, D, R>,
    name: MethodName,
    log: Option<EventLog>,
    tally: Option<Tally<D>>,
}

impl<'m, const D: usize, R: Rule<f64>> EventDriven<'m, D, R> {
    /// Wraps a world that has just started or was restored.
    pub fn new(world: World<'m, f64, D, R>, name: MethodName, log: bool) -> Self {
        Self { world, name, log: log.then(EventLog::default), tally: None }
    }

    /// Sums over contacts, going on from these if they are given.
    #[must_use]
    pub fn with_tally(self, layout: Option<&Layout>, sums: Option<&[f64]>) -> Self {
        let mut tally = layout.map(Tally::new);
        if let (Some(tally), Some(sums)) = (&mut tally, sums) {
            tally.set(sums);
        }
        Self { tally, ..self }
    }

    fn advance(&mut self, time: f64, events: u32) -> Result<bool, carom::Error> {
        let Self { world, log, tally, .. } = self;
        match (log, tally) {
            (None, None) => world.advance_with_budget(time, events),
            (Some(log), None) => world.advance_observed_with_budget(time, events, log),
            (None, Some(tally)) => world.advance_observed_with_budget(time, events, tally),
            (Some(log), Some(tally)) => {
                world.advance_observed_with_budget(time, events, &mut Both(log, tally))
            }
        }
    }
}

/// Two who observe the same events.
struct Both<'a, const D: usize>(&'a mut EventLog, &'a mut Tally<D>);

impl<const D: usize> Observer<f64, D> for Both<'_, D> {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        self.1.before(event, view);
    }

    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        self.0.after(event, view);
        self.1.after(event, view);
    }
}

impl<const D: usize, R: Rule<f64>> Method for EventDriven<'_, D, R> {
    fn name(&self) -> MethodName {
        self.name
    }

    fn time(&self) -> f64 {
        self.world.now().as_f64()
    }

    fn advance_to(&mut self, time: f64) -> Result<()> {
        while !self.advance(time, u32::MAX)? {}
        Ok(())
    }

    fn advance_within(&mut self, time: f64, events: u32) -> Result<bool> {
        Ok(self.advance(time, events)?)
    }

    fn save(&self) -> Result<Option<Vec<u8>>> {
        let tally = self.tally.as_ref().map(Tally::sums);
        Ok(Some(postcard::to_stdvec(&(self.world.save(), tally))?))
    }

    fn take_tally(&mut self) -> Vec<f64> {
        self.tally.as_mut().map(Tally::take).unwrap_or_default()
    }

    fn grains(&self) -> Vec<Placed> {
        let view = self.world.view();
        (0..view.len())
            .filter_map(|i| view.grain(i))
            .map(|grain| Placed {
                radius: grain.radius,
                mass: grain.mass,
                position: three(grain.position.as_slice()),
                velocity: three(grain.velocity.as_slice()),
            })
            .collect()
    }

    fn kinetic_energy(&self) -> f64 {
        self.world.view().kinetic_energy()
    }

    fn collisions(&self) -> u64 {
        let statistics = self.world.statistics();
        statistics.collisions + statistics.plane_collisions
    }

    fn statistics(&self) -> Vec<(&'static str, u64)> {
        let c = self.world.statistics();
        vec![
            ("collisions", c.collisions),
            ("plane_collisions", c.plane_collisions),
            ("releases", c.releases),
            ("rotation_refused", c.rotation_refused),
            ("interrupted", c.interrupted),
            ("deferred", c.deferred),
            ("clamped", c.clamped),
            ("hard_sphere", c.hard_sphere),
            ("rests", c.rests),
            ("take_offs", c.take_offs),
            ("within_tc", c.within_tc),
            ("collapses", c.collapses),
            ("supported_collisions", c.supported_collisions),
            ("joins", c.joins),
            ("steps", c.steps),
            ("crushed", c.crushed),
            ("reordered", c.reordered),
            ("stale", c.stale),
            ("cell_crossings", c.cell_crossings),
            ("rechecks", c.rechecks),
        ]
    }

    fn motions(&self) -> Vec<(&'static str, usize)> {
        let view = self.world.view();
        let count = |motion| (0..view.len()).filter(|&i| view.motion(i) == Some(motion)).count();
        vec![
            ("in flight", count(Motion::Flight)),
            ("in contacts of two", count(Motion::Contact)),
            ("in clusters", count(Motion::Cluster)),
            ("at rest", count(Motion::Rest)),
        ]
    }

    fn take_events(&mut self) -> Vec<LoggedEvent> {
        self.log.as_mut().map(|log| std::mem::take(&mut log.0)).unwrap_or_default()
    }
}

/// Keeps the events that change a trajectory.
#[derive(Default)]
struct EventLog(Vec<LoggedEvent>);

impl<const D: usize> Observer<f64, D> for EventLog {
    fn after(&mut self, event: &Event<f64>, _: View<'_, f64, D>) {
        let kind = match event.outcome {
            Some(EventOutcome::Collision { .. }) => "collision",
            Some(EventOutcome::ContactBegan(_)) => "contact",
            Some(EventOutcome::ContactEnded) => "release",
            Some(EventOutcome::ContactInterrupted) => "interruption",
            Some(EventOutcome::CameToRest) => "rest",
            Some(EventOutcome::TookOff) => "take-off",
            _ => return,
        };
        self.0.push(LoggedEvent {
            time: event.at.as_f64(),
            kind,
            grain: event.grain,
            partner: event.partner.as_grain(),
            plane: event.partner.as_plane(),
        });
    }
}

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
