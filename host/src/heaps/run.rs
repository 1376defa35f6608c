//! How does a box fare? Reads a drawn box; runs it in one number type, returns what was measured or broken.

use super::check::Watch;
use super::draw::{Drawn, Gravity, LawKind, draw};
use carom::law::embedded::{Standard, TableSet};
use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft, Viscoelastic};
use carom::scalar::{I16F16, I32F32};
use carom::space::{Plane, Surface, Vibration};
use carom::{Enduring, Grain, HeapMemory, Scalar, World};
use std::f64::consts::TAU;

/// The number that a world computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Number {
    /// 64 bits.
    #[default]
    F64,
    /// 32 bits.
    F32,
    /// Fixed point, 64 bits.
    I32f32,
    /// Fixed point, 32 bits.
    I16f16,
}

/// How a box ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ended {
    /// Nothing will ever happen again, from this time on.
    Asleep(f64),
    /// It need not sleep, or all that still moves slides on a smooth floor.
    Moving {
        /// Whether it had to be at rest but for what slides.
        slides: bool,
    },
    /// Its law is too soft for what fell on one of the grains: it lay within another, or within a plane, and the
    /// world had said so before (`EventOutcome::Crushed`).
    Crushed,
    /// Something broke: what.
    Broken(String),
}

/// What was measured of a box.
#[derive(Clone, Debug)]
pub struct Report {
    /// How it ended.
    pub ended: Ended,
    /// The largest rise of energy, in units of m g R.
    pub rise: f64,
    /// The deepest overlap, in units of the smaller radius.
    pub deepest: f64,
    /// Events of all kinds.
    pub events: u64,
    /// The most collisions a grain had in one unit of time, on average over the grains of a box.
    pub collisions: f64,
    /// Seconds of one core.
    pub seconds: f64,
}

/// Runs the box of a seed, of at most so many grains.
pub fn run(seed: u64, most: usize, number: Number) -> (Drawn, Report) {
    let drawn = draw(seed, most, number == Number::I16f16);
    let report = match number {
        Number::F64 => in_dimension::<f64>(&drawn),
        Number::F32 => in_dimension::<f32>(&drawn),
        Number::I32f32 => in_dimension::<I32F32>(&drawn),
        Number::I16f16 => in_dimension::<I16F16>(&drawn),
    };
    (drawn, report)
}

fn in_dimension<S: Scalar>(drawn: &Drawn) -> Report
where
    Standard: TableSet<S, Stored: Send + Sync>,
{
    let rule = rule::<S>(drawn.law);
    match drawn.dimension {
        1 => of_box::<S, 1>(drawn, rule),
        2 => of_box::<S, 2>(drawn, rule),
        _ => of_box::<S, 3>(drawn, rule),
    }
}

/// A rule of any kind: in f64 it is [`AnyRule`](crate::any_rule::AnyRule), whose worlds are compiled already.
type AnyRule<S> = Box<dyn Rule<S> + Send + Sync>;

fn rule<S: Scalar>(law: LawKind) -> AnyRule<S>
where
    Standard: TableSet<S, Stored: Send + Sync>,
{
    let s = S::from_f64;
    match law {
        LawKind::Hard(restitution) => Box::new(HardSphere { restitution: s(restitution) }),
        LawKind::Linear([stiffness, damping]) => {
            let law = LinearDashpot { stiffness: s(stiffness), damping: s(damping) };
            Box::new(Soft::linear_dashpot(law, Outside::HardSphere))
        }
        LawKind::Viscoelastic([young, dissipation]) => {
            let (young, poisson, dissipation) = (s(young), s(0.3), s(dissipation));
            let law = Viscoelastic { young, poisson, dissipation };
            Box::new(Soft::viscoelastic(law, Outside::HardSphere))
        }
    }
}

fn of_box<S: Scalar, const D: usize>(drawn: &Drawn, rule: AnyRule<S>) -> Report {
    let begin = std::time::Instant::now();
    let mut memory = HeapMemory::<S, D>::with_capacity(drawn.count());
    let mut report = match world(&mut memory, drawn, rule) {
        Ok(world) => Run { drawn, watch: Watch::new(drawn, world.view()), world }.report(),
        Err(error) => Report {
            ended: Ended::Broken(format!("at the start: {error}")),
            rise: 0.0,
            deepest: 0.0,
            events: 0,
            collisions: 0.0,
            seconds: 0.0,
        },
    };
    report.seconds = begin.elapsed().as_secs_f64();
    report
}

fn world<'m, S: Scalar, const D: usize>(
    memory: &'m mut HeapMemory<S, D>,
    drawn: &Drawn,
    rule: AnyRule<S>,
) -> Result<World<'m, S, D, AnyRule<S>>, carom::Error> {
    let vector = |v: &[f64; 3]| std::array::from_fn(|axis| S::from_f64(v[axis]));
    let surface = match drawn.hard_walls {
        Some(restitution) => Surface::Hard(S::from_f64(restitution)),
        None => Surface::Rule,
    };
    let mut builder = World::builder(memory).enduring(Enduring::Integrated).gravity(down(drawn));
    for plane in &drawn.planes {
        let at = Plane::new(vector(&plane.normal), S::from_f64(plane.offset), surface);
        builder = builder.plane(match plane.vibration {
            Some([amplitude, frequency]) => {
                at.vibrating(Vibration::new(S::from_f64(amplitude), S::from_f64(frequency)))
            }
            None => at,
        });
    }
    let grains = drawn.grains.iter().map(|grain| {
        Grain::with_mass(S::from_f64(grain.radius), S::from_f64(grain.mass))
            .at(vector(&grain.position))
            .moving(vector(&grain.velocity))
    });
    builder.rule(rule).grains(grains)?.start()
}

/// Gravity at the start.
fn down<S: Scalar, const D: usize>(drawn: &Drawn) -> [S; D] {
    let mut gravity = [S::zero(); D];
    if drawn.gravity != Gravity::Zero {
        gravity[D - 1] = -S::one();
    }
    gravity
}

struct Run<'a, 'm, S: Scalar, const D: usize> {
    drawn: &'a Drawn,
    world: World<'m, S, D, AnyRule<S>>,
    watch: Watch,
}

/// Swinging gravity changes after so long: 25 ms for R = 1 mm.
const SWING: f64 = 2.5;

/// How long boxes run that need not sleep.
const LONG: f64 = 40.0;

/// More events a grain and unit of time than this are too many; steps are the most of them.
const BUDGET: f64 = 20_000.0;

impl<S: Scalar, const D: usize> Run<'_, '_, S, D> {
    fn report(mut self) -> Report {
        let long = self.drawn.must_sleep_by().unwrap_or(LONG);
        let unit = if self.drawn.gravity == Gravity::Swinging { SWING } else { 1.0 };
        let (mut events, mut most, mut time) = (0, 0.0_f64, 0.0);
        let ended = loop {
            if time > 0.0 && self.world.next_event_time().is_none() {
                break Ended::Asleep(time);
            }
            if time >= long {
                break self.still_moving();
            }
            time += unit;
            let before = self.collisions();
            let turned = self.turn(time / unit);
            match turned.and_then(|()| self.advance(time, unit)) {
                Ok(more) => events += more,
                Err(_) if self.is_crushed() => break Ended::Crushed,
                Err(what) => break Ended::Broken(what),
            }
            let collisions = (self.collisions() - before) as f64;
            most = most.max(2.0 * collisions / self.drawn.count() as f64 / unit);
        };
        let Watch { rise, deepest, .. } = self.watch;
        Report { ended, rise, deepest, events, collisions: most, seconds: 0.0 }
    }

    /// Whether something lies so deep in something else that what follows means nothing, and the world has said so.
    fn is_crushed(&self) -> bool {
        self.watch.is_too_deep && self.world.statistics().crushed > 0
    }

    fn collisions(&self) -> u64 {
        self.world.statistics().collisions + self.world.statistics().plane_collisions
    }

    /// Swinging gravity points elsewhere.
    fn turn(&mut self, turns: f64) -> Result<(), String> {
        if self.drawn.gravity != Gravity::Swinging {
            return Ok(());
        }
        // The golden angle: never twice the same.
        let angle = turns * 0.381_966 * TAU;
        let mut gravity = [S::zero(); D];
        gravity[D - 1] = S::from_f64(-angle.cos());
        if D > 1 {
            gravity[0] = S::from_f64(angle.sin());
        }
        self.world.set_gravity(gravity).map_err(|error| error.to_string())?;
        self.watch.turn(self.world.view());
        Ok(())
    }

    /// Events up to this time.
    fn advance(&mut self, time: f64, unit: f64) -> Result<u64, String> {
        const SLICE: u32 = 1000;
        let budget = (BUDGET * unit * self.drawn.count() as f64) as u64 + 1000;
        let mut events = 0;
        while !self.world.advance_with_budget(time, SLICE).map_err(|e| e.to_string())? {
            events += u64::from(SLICE);
            if events > budget {
                let count = self.drawn.count();
                return Err(format!("over {events} events of {count} grains before {time}"));
            }
        }
        self.watch.look(self.world.view())?;
        Ok(events)
    }

    fn still_moving(&self) -> Ended {
        if self.drawn.must_sleep_by().is_none() {
            return Ended::Moving { slides: false };
        }
        if self.watch.only_slides() {
            return Ended::Moving { slides: true };
        }
        Ended::Broken(format!("still awake, up to {:.1e} fast", self.watch.fastest()))
    }
}
