//! What does the force-based reference make of an impact? Reads a case; integrates it, or takes the closed form.

use super::case::{Case, Law, Surfaces};
use super::engine::{Answer, since_apart};
use crate::scale::Contact;
use anyhow::Result;
use carom::law::{Adhesive, Tangential};
use carom_reference::{
    ForceLaw, Friction, GeneralLaw, HardImpact, RoughGrain, Sticky, collide_general, collide_hard,
    collide_rough,
};

/// How the two part by the reference; an inner nothing if they stick, an outer one if it does not know what surfaces
/// do in a contact that lasts where only a coefficient is given.
///
/// # Errors
/// What the reference refuses.
pub fn by_reference(case: &Case, surfaces: Option<&Surfaces>) -> Result<Option<Option<Answer>>> {
    let hit = match case.law {
        Law::Constant { restitution } => {
            let after = collide_hard(grains(case), hard(restitution, surfaces))?;
            Some((0.0, after))
        }
        _ => {
            let Some(friction) = friction(surfaces) else { return Ok(None) };
            lasting(case, friction)?
        }
    };
    Ok(Some(hit.map(|(duration, after)| answer(case, duration, &after))))
}

fn lasting(case: &Case, friction: Friction) -> Result<Option<(f64, [RoughGrain; 2])>> {
    let sticky = |of: Adhesive<f64>| {
        let Adhesive { young, poisson, dissipation, work } = of;
        Sticky { young, poisson, dissipation, work }
    };
    let law = match case.law {
        Law::Soft(Contact::LinearDashpot { stiffness, damping }) => {
            return plain(case, ForceLaw::LinearDashpot { stiffness, damping }, friction);
        }
        Law::Soft(Contact::Viscoelastic { young, poisson, dissipation }) => {
            let law = ForceLaw::Viscoelastic { young, poisson, dissipation };
            return plain(case, law, friction);
        }
        Law::Power(law) => GeneralLaw::Power {
            stiffness: law.stiffness,
            exponent: law.exponent,
            damping: law.damping,
            damping_exponent: law.damping_exponent,
        },
        Law::WaltonBraun(law) => {
            GeneralLaw::WaltonBraun { loading: law.loading, unloading: law.unloading }
        }
        Law::Dmt(of) => GeneralLaw::Dmt(sticky(of)),
        Law::Jkr(of) => GeneralLaw::Jkr(sticky(of)),
        Law::Constant { .. } => return Ok(None),
    };
    let hit = collide_general(grains(case), (law, case.cohesion), friction)?;
    Ok(hit.map(|hit| (hit.duration, hit.after)))
}

fn plain(case: &Case, law: ForceLaw, friction: Friction) -> Result<Option<(f64, [RoughGrain; 2])>> {
    let hit = collide_rough(grains(case), law, friction)?;
    Ok(Some((hit.duration, hit.after)))
}

/// Smooth surfaces are those without friction.
fn friction(surfaces: Option<&Surfaces>) -> Option<Friction> {
    let smooth = Friction { mu: 0.0, stiffness: 1.0, damping: 0.0, inertia: 0.4 };
    match surfaces {
        None => Some(smooth),
        Some(&Surfaces { tangential: Tangential::Spring { mu, stiffness, damping }, inertia }) => {
            Some(Friction { mu, stiffness, damping, inertia })
        }
        Some(_) => None,
    }
}

/// A spring without duration loses nothing: β₀ = 1.
fn hard(restitution: f64, surfaces: Option<&Surfaces>) -> HardImpact {
    let smooth = HardImpact { restitution, beta_0: -1.0, mu: None, inertia: 0.4 };
    let Some(&Surfaces { tangential, inertia }) = surfaces else { return smooth };
    let (beta_0, mu) = match tangential {
        Tangential::Constant { beta } => (beta, None),
        Tangential::Walton { mu, beta_0 } => (beta_0, Some(mu)),
        Tangential::Spring { mu, .. } => (1.0, Some(mu)),
        _ => (-1.0, None),
    };
    HardImpact { restitution, beta_0, mu, inertia }
}

fn grains(case: &Case) -> [RoughGrain; 2] {
    let distance = case.pair.contact_distance();
    let [u, v] = case.velocity;
    let grain = |k: usize, x, velocity| RoughGrain {
        radius: case.pair.radii[k],
        mass: case.pair.masses[k],
        position: [x, 0.0, 0.0],
        velocity,
        rotation: [0.0, 0.0, case.spins[k]],
    };
    [grain(0, distance, [u, v, 0.0]), grain(1, 0.0, [0.0; 3])]
}

fn answer(case: &Case, duration: f64, [a, b]: &[RoughGrain; 2]) -> Answer {
    let difference = |x: [f64; 3], y: [f64; 3]| [x[0] - y[0], x[1] - y[1]];
    let (apart, velocity) =
        (difference(a.position, b.position), difference(a.velocity, b.velocity));
    let since = since_apart(apart, velocity, case.pair.contact_distance());
    Answer { apart: duration - since, velocity, spins: [a.rotation[2], b.rotation[2]] }
}
