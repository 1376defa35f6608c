//! What does the reference run? Reads a scenario and its start; writes a system with its force law.

use super::components::first;
use super::l94::L94;
use crate::scenario::{LawSpec, Scenario, Side, Start};
use anyhow::{Context, Result, bail};

/// The grains and their box, and the law of their contacts.
pub(super) fn system<const D: usize>(
    scenario: &Scenario,
    start: &Start,
) -> Result<(carom_reference::System<D>, carom_reference::ForceLaw)> {
    let boundary = std::array::from_fn(|axis| match start.sides[axis] {
        Side::Periodic([lo, hi]) => carom_reference::Boundary::Periodic { lo, hi },
        Side::Walls([lo, hi], ..) => carom_reference::Boundary::Walls { lo, hi },
        Side::Plate(plate, _) => carom_reference::Boundary::Plate(plate),
        Side::Open => carom_reference::Boundary::Open,
    });
    let grains = start.grains.iter().map(|grain| carom_reference::Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: first(&grain.position),
        velocity: first(&grain.velocity),
    });
    let system = carom_reference::System::new(grains.collect(), boundary, first(&start.gravity))?;
    Ok((system, force_law(scenario)?))
}

/// When contacts under this law are over.
pub(super) const fn end(law: &carom_reference::ForceLaw) -> carom_reference::End {
    match law {
        carom_reference::ForceLaw::PowerLaw { .. } => carom_reference::End::Overlap,
        _ => carom_reference::End::Force,
    }
}

/// The force law of the reference.
///
/// # Errors
/// When the law has no force.
pub fn force_law(scenario: &Scenario) -> Result<carom_reference::ForceLaw> {
    match scenario.only_law().context("MD needs one law for all contacts")? {
        LawSpec::Lsd { stiffness, damping } => {
            Ok(carom_reference::ForceLaw::LinearDashpot { stiffness, damping })
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            Ok(carom_reference::ForceLaw::Viscoelastic { young, poisson, dissipation })
        }
        LawSpec::L94 { stiffness, beta, damping, gamma } => {
            Ok(L94 { stiffness, beta, damping, gamma }.of_reference())
        }
        LawSpec::Constant { .. } => bail!("MD needs a force law, but law.kind is constant"),
    }
}
