//! What keeps grains moving? Sources of energy and changes at given times; reads a world between events, writes velocities, gravity and who is there.
//!
//! The core knows none of this: it lets a user change grains between events, and this module is such a user. It
//! draws from one generator, whose state is part of [`Driving`]: a driven run that is saved and restored goes on
//! with the same bits.

mod gravity;
mod sample;
mod source;

pub use gravity::{Gravity, Vector};
pub use source::{Action, Source};

use anyhow::{Context, Result, bail};
use carom::law::Rule;
use carom::nalgebra::SVector;
use carom::space::Plane;
use carom::world::{Event, EventKind, EventOutcome, Observer, Transfer};
use carom::{Grain, World};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use serde::{Deserialize, Serialize};

/// The sources of a run and how far each has come.
///
/// ```
/// use carom::{Grain, HeapMemory, World, law::HardSphere};
/// use carom_host::drive::{Driving, Source};
/// let mut memory = HeapMemory::<f64, 2>::with_capacity(1);
/// let mut world = World::builder(&mut memory)
///     .hard_walls([[0.0, 1.0]; 2], 1.0)
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.1, 1.0).at([0.5, 0.5]).moving([1.0, 0.3]))?
///     .start()?;
/// // The lower wall across the first axis has k T = 2.
/// let wall = Source::ThermalWall { plane: 0, temperature: 2.0 };
/// let mut driving = Driving::new(vec![wall], 1, 42)?;
/// driving.advance(&mut world, 10.0, &mut ())?;
/// # Ok::<(), anyhow::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Driving<const D: usize> {
    sources: Vec<Source<D>>,
    /// When each acts next (s); none for one that only answers to events.
    next: Vec<Option<f64>>,
    rng: Pcg64,
}

impl<const D: usize> Driving<D> {
    /// These sources for so many grains, from time 0 on. Equal seeds give equal runs.
    ///
    /// # Errors
    /// A number of a source that makes no sense, with the source's place in the list.
    pub fn new(sources: Vec<Source<D>>, grains: usize, seed: u64) -> Result<Self> {
        for (number, source) in sources.iter().enumerate() {
            source.check(grains).with_context(|| format!("driving source {number}"))?;
        }
        let mut rng = Pcg64::seed_from_u64(seed);
        let next = sources.iter().map(|source| source.first_time(grains, &mut rng)).collect();
        Ok(Self { sources, next, rng })
    }

    /// The next time at which a source acts by itself (s); infinite if none does.
    #[must_use]
    pub fn next_time(&self) -> f64 {
        self.next.iter().flatten().copied().fold(f64::INFINITY, f64::min)
    }

    /// A world goes on to this time (s), driven and observed.
    ///
    /// # Errors
    /// An error of the engine, or a source that the world has no place for.
    pub fn advance<R: Rule<f64>>(
        &mut self,
        world: &mut World<'_, f64, D, R>,
        time: f64,
        observer: &mut impl Observer<f64, D>,
    ) -> Result<()> {
        while !self.advance_within(world, time, u32::MAX, observer)? {}
        Ok(())
    }

    /// As [`Driving::advance`], but after so many events that change a trajectory it stops: false if it has not
    /// arrived then. In how many calls it arrives changes nothing.
    ///
    /// # Errors
    /// As [`Driving::advance`].
    pub fn advance_within<R: Rule<f64>>(
        &mut self,
        world: &mut World<'_, f64, D, R>,
        time: f64,
        events: u32,
        observer: &mut impl Observer<f64, D>,
    ) -> Result<bool> {
        for _ in 0..events {
            let due = self.next_time().min(time);
            match world.step_until_observed(due, observer)? {
                Some(event) => self.answer(world, &event, observer)?,
                None if self.next_time() > time => return Ok(true),
                None => self.act(world, due)?,
            }
        }
        Ok(false)
    }

    /// A grain that has touched a thermal wall leaves it with a velocity drawn from it; what the wall gives for that is told.
    fn answer<R: Rule<f64>>(
        &mut self,
        world: &mut World<'_, f64, D, R>,
        event: &Event<f64>,
        observer: &mut impl Observer<f64, D>,
    ) -> Result<()> {
        let Some(touched) = event.partner.as_plane().filter(|_| has_touched(event)) else {
            return Ok(());
        };
        for source in &self.sources {
            let Source::ThermalWall { plane, temperature } = *source else { continue };
            if plane != touched {
                continue;
            }
            let Some(grain) = world.grain(event.grain) else { continue };
            let Some(wall) = world.view().boundary().planes().get(plane).copied() else {
                bail!("a thermal wall is plane {plane}, which does not exist");
            };
            let normal = std::array::from_fn(|axis| wall.normal[axis]);
            let speed = (temperature / grain.mass).sqrt();
            let leaving = sample::leaving(&mut self.rng, normal, speed);
            world.set_velocity(event.grain, leaving)?;
            observer.transferred(&given(&grain, &wall, leaving, event));
        }
        Ok(())
    }

    /// All sources that are due at this time act, in the order in which they were given.
    fn act<R: Rule<f64>>(&mut self, world: &mut World<'_, f64, D, R>, now: f64) -> Result<()> {
        for (source, next) in self.sources.iter().zip(&mut self.next) {
            if next.is_some_and(|next| next <= now) {
                source.act(world, now, &mut self.rng)?;
                *next = source.time_after(now, world.view().len(), &mut self.rng);
            }
        }
        Ok(())
    }
}

/// What a thermal wall gives a grain besides having reflected it.
fn given<const D: usize>(
    grain: &Grain<f64, D>,
    wall: &Plane<f64, D>,
    leaving: [f64; D],
    event: &Event<f64>,
) -> Transfer<f64, D> {
    let (before, after) = (grain.velocity, SVector::from(leaving));
    Transfer {
        grain: event.grain,
        partner: event.partner,
        impulse: (after - before) * grain.mass,
        position: grain.position,
        separation: wall.normal * grain.radius,
        work: 0.5 * grain.mass * (before.norm_squared() - after.norm_squared()),
        approach: None,
    }
}

/// Whether a grain has just touched what an event names.
fn has_touched(event: &Event<f64>) -> bool {
    let touched = matches!(
        event.outcome,
        Some(
            EventOutcome::Collision { .. }
                | EventOutcome::Joined
                | EventOutcome::CameToRest
                | EventOutcome::ContactBegan(_)
        )
    );
    touched && event.kind == EventKind::Collision
}
