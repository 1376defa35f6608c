//! What do the functions that C calls to describe and run a world do? Reads its arguments; writes the world.

use crate::error::carom_error;
use crate::held::{Held, State};
use crate::law::{AnyRule, Law, Mode, Number, soft};
use crate::types::carom_event;
use carom::error::Subject;
use carom::law::{HardSphere, LinearDashpot, Viscoelastic};
use carom::space::{Plane, Surface, Vibration};
use carom::world::WorldBuilder;
use carom::{Error, Grain, Instant, World};

/// What a call comes to.
pub type Told<T = ()> = Result<T, carom_error>;

type Described<S, const D: usize> = WorldBuilder<'static, S, D, AnyRule<S>>;

/// What every call can answer: see [`carom_error`].
impl<S: Number, const D: usize> Held<S, D> {
    fn describe<T>(
        &mut self,
        call: impl FnOnce(&mut Described<S, D>) -> Result<T, Error>,
    ) -> Told<T> {
        let told = call(self.builder()?);
        self.note(told)
    }

    fn set_law(&mut self, law: Law<S>) -> Told {
        let rule = AnyRule { law, ..self.rule };
        self.describe(|world| world.set_rule(rule))?;
        self.rule = rule;
        Ok(())
    }

    /// What becomes of contacts that last or crowd, under the law that there is or that will be chosen.
    pub fn set_mode(&mut self, mode: i32) -> Told {
        self.builder()?;
        let rule = AnyRule { mode: Mode::of(mode)?, ..self.rule };
        if !matches!(rule.law, Law::Missing) {
            self.describe(|world| world.set_rule(rule))?;
        }
        self.rule = rule;
        Ok(())
    }

    /// Hard grains of this coefficient of restitution.
    pub fn set_restitution(&mut self, restitution: S) -> Told {
        self.set_law(Law::Hard(HardSphere { restitution }))
    }

    /// Linear spring-dashpots, read from this set of tables.
    pub fn set_linear_dashpot(&mut self, law: LinearDashpot<S>, table: i32) -> Told {
        self.set_law(Law::Linear(soft(law, table)?))
    }

    /// Viscoelastic grains, read from this set of tables.
    pub fn set_viscoelastic(&mut self, law: Viscoelastic<S>, table: i32) -> Told {
        self.set_law(Law::Viscoelastic(soft(law, table)?))
    }

    /// One plane more.
    pub fn add_plane(&mut self, plane: Plane<S, D>) -> Told {
        self.describe(|world| world.add_plane(plane)).map(drop)
    }

    /// A plate that vibrates.
    pub fn add_plate(&mut self, plane: Plane<S, D>, [amplitude, frequency]: [S; 2]) -> Told {
        self.add_plane(plane.vibrating(Vibration::new(amplitude, frequency)))
    }

    /// A box of walls: all of them, or none.
    pub fn add_walls(&mut self, low: [S; D], high: [S; D], surface: Surface<S>) -> Told {
        let sides = core::array::from_fn(|axis| [low[axis], high[axis]]);
        self.describe(|world| world.add_walls(sides, surface))
    }

    /// A periodic axis.
    pub fn set_periodic(&mut self, axis: u32, low: S, high: S) -> Told {
        self.describe(|world| world.set_periodic_axis(axis as usize, [low, high]))
    }

    /// Gravity, before the start or at any time after it.
    pub fn set_gravity(&mut self, gravity: [S; D]) -> Told {
        let told = match &mut self.state {
            State::Described(builder) => builder.set_gravity(gravity),
            State::Started(world) => world.set_gravity(gravity),
            State::Lost => return Err(carom_error::CAROM_ERROR_NOT_STARTED),
        };
        self.note(told)
    }

    /// How long slow contacts of hard grains last.
    pub fn set_contact_time(&mut self, time: S) -> Told {
        self.describe(|world| world.set_contact_time(time))
    }

    /// In how many steps the shortest contact of many is integrated.
    pub fn set_steps_per_contact(&mut self, steps: u32) -> Told {
        self.describe(|world| world.set_steps_per_contact(steps))
    }

    /// One grain more.
    pub fn add_grain(&mut self, grain: Grain<S, D>) -> Told {
        self.describe(|world| world.add_grain(grain)).map(drop)
    }

    /// So many empty places for grains that come later.
    pub fn add_empty_places(&mut self, places: u32) -> Told {
        let free = self.layout.grains.saturating_sub(self.builder()?.count());
        let full =
            Error::Full { knob: "the places for grains of create", capacity: self.layout.grains };
        if places as usize > free {
            return self.note(Err(full));
        }
        self.describe(|world| world.add_empty_places(places as usize))
    }

    /// One grain more in the first empty place, while time passes; its number.
    pub fn insert_grain(&mut self, grain: Grain<S, D>) -> Told<u32> {
        // There are as many places as a number of 32 bits has said.
        self.run(|world| world.add(grain)).map(|number| number as u32)
    }

    /// Takes a grain out; what it was.
    pub fn remove_grain(&mut self, index: u32) -> Told<Grain<S, D>> {
        if self.world()?.grain(index as usize).is_none() {
            return Err(carom_error::CAROM_ERROR_INDEX);
        }
        self.run(|world| world.remove(index as usize))
    }

    /// From now on time passes.
    pub fn start(&mut self) -> Told {
        self.describe(WorldBuilder::check)?;
        let State::Described(builder) = core::mem::replace(&mut self.state, State::Lost) else {
            return Err(carom_error::CAROM_ERROR_STARTED);
        };
        let started = builder.start();
        self.state = State::Started(self.note(started)?);
        Ok(())
    }

    fn run<T>(
        &mut self,
        call: impl FnOnce(&mut World<'static, S, D, AnyRule<S>>) -> Result<T, Error>,
    ) -> Told<T> {
        let told = call(self.world()?);
        self.note(told)
    }

    /// Gives a grain another velocity.
    pub fn set_velocity(&mut self, index: u32, velocity: [S; D]) -> Told {
        if self.world()?.grain(index as usize).is_none() {
            return Err(carom_error::CAROM_ERROR_INDEX);
        }
        self.run(|world| world.set_velocity(index as usize, velocity))
    }

    /// Everything up to that time happens.
    pub fn advance_to(&mut self, time: f64) -> Told {
        self.run(|world| world.advance_to(time))
    }

    /// So much time passes.
    pub fn advance_by(&mut self, time: f64) -> Told {
        self.run(|world| world.advance_to(later(world.now(), time)?))
    }

    /// Everything up to that time happens, or so many events; whether the time has come.
    pub fn advance_with_budget(&mut self, time: f64, events: u32) -> Told<bool> {
        self.run(|world| world.advance_with_budget(time, events))
    }

    /// The next event that changes how a grain moves, if there is one up to that time.
    pub fn step(&mut self, until: f64) -> Told<carom_event> {
        let none = || carom_event::none(until);
        self.run(|world| Ok(world.step_until(until)?.map_or_else(none, carom_event::from)))
    }
}

/// So much later.
fn later(now: Instant, time: f64) -> Result<Instant, Error> {
    if time.is_finite() && time >= 0.0 {
        return Ok(now + Instant::from(time));
    }
    let (subject, field) = (Subject::World, "time to advance by");
    Err(Error::Input { subject, field, value: time, wanted: "finite and at least 0" })
}
