//! How is a world of the core a method? Reads and writes the world; hands out its state as the comparison needs it.

use super::interface::{LoggedEvent, Method, three};
use crate::drive::Driving;
use crate::observe::{Layout, Tally};
use crate::scenario::{MethodName, Placed};
use anyhow::Result;
use carom::World;
use carom::law::Rule;
use carom::world::{Event, EventOutcome, Motion, Observer, Transfer, View};

/// A world of the core as a method.
pub struct EventDriven<'m, const D: usize, R> {
    world: World<'m, f64, D, R>,
    name: MethodName,
    log: Option<EventLog>,
    tally: Option<Tally<D>>,
    driving: Option<Driving<D>>,
}

impl<'m, const D: usize, R: Rule<f64>> EventDriven<'m, D, R> {
    /// Wraps a world that has just started or was restored.
    pub fn new(world: World<'m, f64, D, R>, name: MethodName, log: bool) -> Self {
        Self { world, name, log: log.then(EventLog::default), tally: None, driving: None }
    }

    /// Sums over contacts, going on from these if they are given.
    #[must_use]
    pub fn with_tally(self, layout: Option<&Layout>, sums: Option<&[f64]>) -> Self {
        let mut tally = layout.map(|layout| Tally::new(layout, self.world.inertia()));
        if let (Some(tally), Some(sums)) = (&mut tally, sums) {
            tally.set(sums);
        }
        Self { tally, ..self }
    }

    /// Driven by these sources, from where they stand.
    #[must_use]
    pub fn driven(self, driving: Option<Driving<D>>) -> Self {
        Self { driving, ..self }
    }

    fn advance(&mut self, time: f64, events: u32) -> Result<bool> {
        let Self { world, log, tally, driving, .. } = self;
        let mut watch = Watch { log: log.as_mut(), tally: tally.as_mut() };
        Ok(match driving {
            Some(driving) => driving.advance_within(world, time, events, &mut watch)?,
            None if watch.is_idle() => world.advance_with_budget(time, events)?,
            None => world.advance_observed_with_budget(time, events, &mut watch)?,
        })
    }
}

/// Whoever observes the events.
struct Watch<'a, const D: usize> {
    log: Option<&'a mut EventLog>,
    tally: Option<&'a mut Tally<D>>,
}

impl<const D: usize> Watch<'_, D> {
    fn is_idle(&self) -> bool {
        self.log.is_none() && self.tally.is_none()
    }
}

impl<const D: usize> Observer<f64, D> for Watch<'_, D> {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        if let Some(tally) = &mut self.tally {
            tally.before(event, view);
        }
    }

    fn transferred(&mut self, transfer: &Transfer<f64, D>) {
        if let Some(tally) = &mut self.tally {
            tally.transferred(transfer);
        }
    }

    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        if let Some(log) = &mut self.log {
            log.after(event, view);
        }
        if let Some(tally) = &mut self.tally {
            tally.after(event, view);
        }
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
        self.advance(time, events)
    }

    fn save(&self) -> Result<Option<Vec<u8>>> {
        let tally = self.tally.as_ref().map(Tally::sums);
        Ok(Some(postcard::to_stdvec(&(self.world.save(), tally, &self.driving))?))
    }

    fn next_event_time(&self) -> Option<f64> {
        let source = self.driving.as_ref().map(Driving::next_time).filter(|time| time.is_finite());
        let event = self.world.next_event_time().map(|time| time.as_f64());
        source.into_iter().chain(event).reduce(f64::min)
    }

    fn digest(&self) -> Option<u64> {
        Some(self.world.digest())
    }

    fn take_tally(&mut self) -> Vec<f64> {
        let Some(tally) = &mut self.tally else { return Vec::new() };
        tally.rest(&self.world);
        tally.take(self.world.now().as_f64())
    }

    fn grains(&self) -> Vec<Placed> {
        let view = self.world.view();
        (0..view.len())
            .map(|i| {
                view.grain(i).map_or(Placed::GONE, |grain| Placed {
                    radius: grain.radius,
                    mass: grain.mass,
                    position: three(grain.position.as_slice()),
                    velocity: three(grain.velocity.as_slice()),
                })
            })
            .collect()
    }

    fn rotations(&self) -> Vec<[f64; 3]> {
        let view = self.world.view();
        (0..view.len()).filter_map(|i| view.angular_velocity(i)).collect()
    }

    fn rotational_energy(&self) -> f64 {
        let inertia = self.world.inertia();
        inertia.map_or(0.0, |inertia| self.world.view().rotational_energy(inertia))
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
            ("cut_steps", c.cut_steps),
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
