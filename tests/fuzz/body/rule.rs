//! What do the grains do when they touch? Reads bytes; writes nothing, returns one of the engine's rules.

use super::input::Input;
use carom::Scalar;
use carom::law::embedded::{compact, read::Table, standard, wide};
use carom::law::{
    ByMaterial, Central, HardSphere, LinearDashpot, Outside, Rule, Soft, Viscoelastic,
};

/// A rule and what the invariants depend on.
pub struct DrawnRule<S: Scalar> {
    pub rule: Box<dyn Rule<S>>,
    /// The relative energy that one collision may bring by rounding or by the table's error.
    pub energy_gain: f64,
}

/// A rule: hard, soft by every table and every way out of its domain, or one for each pair of materials.
pub fn rule<S: Scalar>(input: &mut Input<'_>) -> DrawnRule<S> {
    match input.below(6) {
        0 | 1 => hard(input),
        2 => soft(
            input,
            linear_dashpot,
            [&compact::LINEAR_DASHPOT, &standard::LINEAR_DASHPOT, &wide::LINEAR_DASHPOT],
        ),
        3 => soft(
            input,
            viscoelastic,
            [&compact::VISCOELASTIC, &standard::VISCOELASTIC, &wide::VISCOELASTIC],
        ),
        4 => {
            let law = linear_dashpot(input);
            let table = &standard::LINEAR_DASHPOT;
            let rule = Central(Soft::with_table(law, table, Outside::Clamp));
            DrawnRule { rule: Box::new(rule), energy_gain: 1e-3 }
        }
        _ => {
            let one = HardSphere { restitution: input.fraction() };
            let other = HardSphere { restitution: input.fraction() };
            DrawnRule {
                rule: Box::new(ByMaterial([[one, other], [other, one]])),
                energy_gain: 1e-5,
            }
        }
    }
}

fn hard<S: Scalar>(input: &mut Input<'_>) -> DrawnRule<S> {
    let restitution = if input.below(16) == 15 { input.number() } else { input.fraction() };
    DrawnRule { rule: Box::new(HardSphere { restitution }), energy_gain: 1e-5 }
}

fn soft<S: Scalar, L>(
    input: &mut Input<'_>,
    law: impl Fn(&mut Input<'_>) -> L,
    tables: [&'static Table<f32>; 3],
) -> DrawnRule<S>
where
    Soft<L>: Rule<S> + 'static,
{
    let table = tables[usize::from(input.below(3))];
    let outside =
        [Outside::Reject, Outside::Clamp, Outside::HardSphere][usize::from(input.below(3))];
    let rule = Soft::with_table(law(input), table, outside);
    DrawnRule { rule: Box::new(rule), energy_gain: 2e-2 }
}

/// Ten to a power from −2 to 10.
fn decade<S: Scalar>(input: &mut Input<'_>) -> S {
    S::from_f64(10f64.powf(f64::from(input.byte()) / 21.25 - 2.0))
}

fn linear_dashpot<S: Scalar>(input: &mut Input<'_>) -> LinearDashpot<S> {
    let stiffness = decade(input);
    let damping = if input.below(3) == 0 { S::zero() } else { decade(input) };
    LinearDashpot { stiffness, damping }
}

fn viscoelastic<S: Scalar>(input: &mut Input<'_>) -> Viscoelastic<S> {
    let young = decade(input);
    let dissipation =
        if input.below(3) == 0 { S::zero() } else { decade::<S>(input) * S::from_f64(1e-6) };
    Viscoelastic { young, poisson: S::from_f64(0.4), dissipation }
}
