//! What do the grains of a scenario do when they touch? Reads its law and options; writes nothing, returns rule or force.

use crate::integrated::Integrated;
use crate::scenario::{LawSpec, MatrixSpec, MethodName, OutsideSpec, Scenario};
use crate::tables::embedded;
use anyhow::{Result, bail};
use carom::law::{Central, HardSphere, LinearDashpot, Outside, Rule, Soft, Viscoelastic};
use carom_tables::Law;

/// The collision rule of an event-driven method.
///
/// # Errors
/// When the law has no such rule, or there is no such table.
pub fn rule(name: MethodName, scenario: &Scenario) -> Result<Box<dyn Rule<f64>>> {
    match scenario.law {
        LawSpec::Constant { restitution } if name == MethodName::Emd => {
            Ok(Box::new(HardSphere { restitution }))
        }
        LawSpec::Constant { .. } => {
            bail!("{} needs a force law, but law.kind is constant", name.label())
        }
        LawSpec::Lsd { stiffness, damping } => {
            let law = LinearDashpot { stiffness, damping };
            Ok(match scenario.options.matrix {
                MatrixSpec::Integrate => chosen(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::LinearDashpot);
                    chosen(name, Soft::with_table(law, table, outside(scenario)))
                }
            })
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            let law = Viscoelastic { young, poisson, dissipation };
            Ok(match scenario.options.matrix {
                MatrixSpec::Integrate => chosen(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::Viscoelastic);
                    chosen(name, Soft::with_table(law, table, outside(scenario)))
                }
            })
        }
    }
}

/// eMD takes only the central restitution of the rule, eMD* all of it.
fn chosen(name: MethodName, rule: impl Rule<f64> + 'static) -> Box<dyn Rule<f64>> {
    match name {
        MethodName::Emd => Box::new(Central(rule)),
        _ => Box::new(rule),
    }
}

fn outside(scenario: &Scenario) -> Outside {
    match scenario.options.outside {
        OutsideSpec::Reject => Outside::Reject,
        OutsideSpec::Clamp => Outside::Clamp,
        OutsideSpec::HardSphere => Outside::HardSphere,
    }
}

/// The force law of the reference.
///
/// # Errors
/// When the law has no force.
pub fn force_law(scenario: &Scenario) -> Result<carom_reference::ForceLaw> {
    match scenario.law {
        LawSpec::Lsd { stiffness, damping } => {
            Ok(carom_reference::ForceLaw::LinearDashpot { stiffness, damping })
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            Ok(carom_reference::ForceLaw::Viscoelastic { young, poisson, dissipation })
        }
        LawSpec::Constant { .. } => bail!("MD needs a force law, but law.kind is constant"),
    }
}
