//! Which rule has a pair of materials? Reads their laws and the options; boxes a rule for each pair.

use super::l94::{Hard, L94};
use crate::any_rule::AnyRule;
use crate::integrated::Integrated;
use crate::scenario::{FrictionSpec, LawSpec, Laws, MatrixSpec, MethodName, OutsideSpec, Scenario};
use crate::tables::embedded;
use anyhow::{Context, Result, bail};
use carom::law::{
    Central, HardSphere, LinearDashpot, Outside, Rough, Rule, Soft, Tangential, Viscoelastic,
};
use carom_tables::read::Law;

/// The rules of an event-driven method for all pairs of materials, row by row; pairs that never meet have
/// that of another.
///
/// # Errors
/// When no two materials have a law, or one has no such rule.
pub fn rules(name: MethodName, scenario: &Scenario, laws: &Laws) -> Result<Vec<AnyRule<'static>>> {
    let all = || laws.pairs().flatten();
    let some = all().next().context("there is no law")?;
    if name == MethodName::EmdStar && !all().any(|law| law.has_force()) {
        bail!("{} needs a force law, but law.kind is constant", name.label());
    }
    let of = |law: Option<LawSpec>| rule(name, scenario, law.unwrap_or(some));
    if !laws.has_friction() {
        return Ok(laws.pairs().map(of).collect());
    }
    let smooth = Tangential::Constant { beta: -1.0 };
    let inertia = scenario.inertia.unwrap_or(0.4);
    let rough = |(law, friction): (Option<LawSpec>, Option<FrictionSpec>)| {
        let tangential = friction.map_or(smooth, Into::into);
        Box::new(Rough { inertia, ..Rough::spheres(of(law), tangential) }) as AnyRule<'static>
    };
    Ok(laws.pairs().zip(laws.frictions()).map(rough).collect())
}

/// The collision rule of an event-driven method.
fn rule(name: MethodName, scenario: &Scenario, law: LawSpec) -> AnyRule<'static> {
    match law {
        LawSpec::Constant { restitution } => Box::new(HardSphere { restitution }),
        LawSpec::Lsd { stiffness, damping } => {
            let law = LinearDashpot { stiffness, damping };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::LinearDashpot);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
        LawSpec::L94 { stiffness, beta, damping, gamma } => {
            let law = L94 { stiffness, beta, damping, gamma };
            match name {
                MethodName::Emd => Box::new(Hard(law)),
                _ => Box::new(carom::law::Integrated(law)),
            }
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            let law = Viscoelastic { young, poisson, dissipation };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::Viscoelastic);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
    }
}

/// eMD takes only the central restitution of the rule, eMD* all of it.
fn by_method(name: MethodName, rule: impl Rule<f64> + Send + Sync + 'static) -> AnyRule<'static> {
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
