//! What does the engine make of an impact? Reads a case; steps a world of two grains until they part.

use super::case::{Case, Law, Surfaces};
use crate::any_rule::AnyRule;
use crate::scale::Contact;
use anyhow::{Result, bail};
use carom::law::{
    Cohesive, ContactLaw, Dmt, HardSphere, Integrated, Jkr, LinearDashpot, Outside, Rough, Rule,
    Soft, Viscoelastic,
};
use carom::space::ContactState;
use carom::world::{Motion, Rotating, WithContacts};
use carom::{Grain, Memory, World};

/// How two part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// How long after they touched the first gap opens between them (s).
    pub apart: f64,
    /// The relative velocity of the first, along the normal as it was at the touch and across it (m/s).
    pub velocity: [f64; 2],
    /// The angular velocities (1/s).
    pub spins: [f64; 2],
}

/// So often two near each other anew without parting: they do not part.
const STUCK: u32 = 8;

/// How the two part by the engine, with so many steps a contact; nothing if they stick.
///
/// # Errors
/// What the engine refuses.
pub fn by_engine(case: &Case, surfaces: Option<&Surfaces>, steps: u32) -> Result<Option<Answer>> {
    let surfaces = (surfaces, steps);
    match case.law {
        Law::Soft(Contact::LinearDashpot { stiffness, damping }) => {
            let law = LinearDashpot { stiffness, damping };
            rubbed(case, Soft::linear_dashpot(law, Outside::HardSphere), surfaces)
        }
        Law::Soft(Contact::Viscoelastic { young, poisson, dissipation }) => {
            let law = Viscoelastic { young, poisson, dissipation };
            rubbed(case, Soft::viscoelastic(law, Outside::HardSphere), surfaces)
        }
        Law::Constant { restitution } => rubbed(case, HardSphere { restitution }, surfaces),
        Law::Power(law) => held(case, law, surfaces),
        Law::WaltonBraun(law) => held(case, law, surfaces),
        Law::Dmt(of) => held(case, Dmt(of), surfaces),
        Law::Jkr(of) => held(case, Jkr(of), surfaces),
    }
}

/// A law of its own, with what holds.
fn held<L: ContactLaw<f64> + Send + Sync>(
    case: &Case,
    law: L,
    surfaces: (Option<&Surfaces>, u32),
) -> Result<Option<Answer>> {
    rubbed(case, Integrated(Cohesive { law, cohesion: case.cohesion }), surfaces)
}

/// A rule, with friction if there is any; then all contacts that last are integrated.
fn rubbed(
    case: &Case,
    normal: impl Rule<f64> + Send + Sync,
    (surfaces, steps): (Option<&Surfaces>, u32),
) -> Result<Option<Answer>> {
    match surfaces {
        None => meet(case, Box::new(normal), steps),
        Some(&Surfaces { tangential, inertia }) => {
            meet(case, Box::new(Rough { normal, tangential, inertia, eta_max: 0.0 }), steps)
        }
    }
}

fn meet(case: &Case, rule: AnyRule<'_>, steps: u32) -> Result<Option<Answer>> {
    let memory = WithContacts::new(Memory::<f64, 2, 2>::new(), [ContactState::VACANT; 2]);
    let mut memory = Rotating::new(memory, [case.spins, [0.0; 2], [0.0; 2]]);
    let is_rough = rule.inertia().is_some();
    let [[r, s], [m, n]] = [case.pair.radii, case.pair.masses];
    let mut world = World::builder(&mut memory)
        .rule(rule)
        .steps_per_contact(steps)
        .grain(
            Grain::with_mass(r, m).at([case.pair.contact_distance(), 0.0]).moving(case.velocity),
        )?
        .grain(Grain::with_mass(s, n).at([0.0; 2]))?
        .start()?;
    let (mut neared, mut before) = (0, -1.0);
    // A contact that lasts a thousand times as long as its steps are for goes on.
    for _ in 0..u64::from(steps) * 1000 {
        world.step()?;
        let (apart, velocity) = relative(&world);
        let rate = apart.dot(&velocity);
        neared += u32::from(before > 0.0 && rate < 0.0);
        before = rate;
        let flies = (0..2).all(|k| world.view().motion(k) == Some(Motion::Flight));
        if rate > 0.0 && flies {
            let spin = |k| world.view().angular_velocity(k).map_or(case.spins[k], |w| w[2]);
            let spins = if is_rough { [spin(0), spin(1)] } else { case.spins };
            let since = since_apart(apart.into(), velocity.into(), case.pair.contact_distance());
            let now = world.now().as_f64();
            return Ok(Some(Answer { apart: now - since, velocity: velocity.into(), spins }));
        }
        if neared == STUCK {
            return Ok(None);
        }
    }
    bail!("{}: after {steps} steps a contact a thousand times over it goes on", case.id)
}

/// How far and how fast the first is from the second.
fn relative(
    world: &World<'_, f64, 2, AnyRule<'_>>,
) -> (carom::Vector<f64, 2>, carom::Vector<f64, 2>) {
    let [a, b] = [0, 1].map(|k| world.grain(k).map(|grain| (grain.position, grain.velocity)));
    let nothing = Default::default();
    let ((x, v), (y, u)) = (a.unwrap_or(nothing), b.unwrap_or(nothing));
    (x - y, v - u)
}

/// How long two that fly apart have been further from each other than that; below zero if they are not yet.
pub(super) fn since_apart([x, y]: [f64; 2], [u, v]: [f64; 2], distance: f64) -> f64 {
    // |r − v t| = l, the later root in the past.
    let (square, along) = (u * u + v * v, x * u + y * v);
    let excess = x * x + y * y - distance * distance;
    let root = (along * along - square * excess).max(0.0).sqrt();
    excess / (along + root)
}
