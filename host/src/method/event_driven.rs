//! What do eMD and eMD* say? Reads a world of the core; writes its state as the comparison wants it.

use super::{Method, three};
use crate::scenario::{MethodName, Placed};
use anyhow::Result;
use carom::World;
use carom::event::Deed;
use carom::law::Rule;
use carom::world::{Happening, View, Watch};

/// One line of an event log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logged {
    /// When (s).
    pub time: f64,
    /// What happened.
    pub what: &'static str,
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
    log: Option<Log>,
}

impl<'m, const D: usize, R: Rule<f64>> EventDriven<'m, D, R> {
    /// Wraps a world that has just started.
    pub fn new(world: World<'m, f64, D, R>, name: MethodName, log: bool) -> Self {
        Self { world, name, log: log.then(Log::default) }
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
        match &mut self.log {
            Some(log) => self.world.advance_watched(time, log)?,
            None => self.world.advance_to(time)?,
        }
        Ok(())
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
        let counters = self.world.counters();
        counters.collisions + counters.plane_collisions
    }

    fn counters(&self) -> Vec<(&'static str, u64)> {
        let c = self.world.counters();
        vec![
            ("collisions", c.collisions),
            ("plane_collisions", c.plane_collisions),
            ("releases", c.releases),
            ("rotation_refused", c.rotation_refused),
            ("interrupted", c.interrupted),
            ("put_off", c.put_off),
            ("clamped", c.clamped),
            ("hard_sphere", c.hard_sphere),
            ("rests", c.rests),
            ("take_offs", c.take_offs),
            ("within_tc", c.within_tc),
            ("collapses", c.collapses),
            ("propped", c.propped),
            ("reordered", c.reordered),
            ("stale", c.stale),
            ("wanderings", c.wanderings),
        ]
    }

    fn take_events(&mut self) -> Vec<Logged> {
        self.log.as_mut().map(|log| std::mem::take(&mut log.0)).unwrap_or_default()
    }
}

/// Keeps what happened.
#[derive(Default)]
struct Log(Vec<Logged>);

impl<const D: usize> Watch<f64, D> for Log {
    fn after(&mut self, happening: &Happening<f64>, _: View<'_, f64, D>) {
        let what = match happening.deed {
            Some(Deed::Collision { .. }) => "collision",
            Some(Deed::Contact(_)) => "contact",
            Some(Deed::Release) => "release",
            Some(Deed::Interruption) => "interruption",
            Some(Deed::Rest) => "rest",
            Some(Deed::TakeOff) => "take-off",
            Some(Deed::Wander) | None => return,
        };
        self.0.push(Logged {
            time: happening.at.as_f64(),
            what,
            grain: happening.grain,
            partner: happening.partner.as_grain(),
            plane: happening.partner.as_plane(),
        });
    }
}
