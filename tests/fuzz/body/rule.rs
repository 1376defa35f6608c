//! What do the grains do when they touch? Reads bytes; writes nothing, returns one of the engine's rules.

use super::draw::Draw;
use carom::Scalar;
use carom::law::embedded::{Stored, compact, read::Table, standard, wide};
use carom::law::{
    ByMaterial, Central, HardSphere, LinearDashpot, Outside, Rule, Soft, Viscoelastic,
};

/// A rule and what the judge must know of it.
pub struct Drawn<S: Scalar> {
    pub rule: Box<dyn Rule<S>>,
    /// The relative energy that one collision may bring by rounding or by the table's error.
    pub gain: f64,
}

/// A rule: hard, soft by every table and every way out of its domain, or one for each pair of materials.
pub fn rule<S: Scalar>(draw: &mut Draw<'_>) -> Drawn<S> {
    match draw.below(6) {
        0 | 1 => hard(draw),
        2 => soft(
            draw,
            lsd,
            [&compact::LINEAR_DASHPOT, &standard::LINEAR_DASHPOT, &wide::LINEAR_DASHPOT],
        ),
        3 => soft(
            draw,
            rubber,
            [&compact::VISCOELASTIC, &standard::VISCOELASTIC, &wide::VISCOELASTIC],
        ),
        4 => {
            let law = lsd(draw);
            let table = carom::law::embedded::linear_dashpot();
            let rule = Central(Soft::with_table(law, table, Outside::Clamp));
            Drawn { rule: Box::new(rule), gain: 1e-3 }
        }
        _ => {
            let one = HardSphere { restitution: draw.fraction() };
            let other = HardSphere { restitution: draw.fraction() };
            Drawn { rule: Box::new(ByMaterial([[one, other], [other, one]])), gain: 1e-5 }
        }
    }
}

fn hard<S: Scalar>(draw: &mut Draw<'_>) -> Drawn<S> {
    let restitution = if draw.below(16) == 15 { draw.number() } else { draw.fraction() };
    Drawn { rule: Box::new(HardSphere { restitution }), gain: 1e-5 }
}

fn soft<S: Scalar, L>(
    draw: &mut Draw<'_>,
    law: impl Fn(&mut Draw<'_>) -> L,
    tables: [&'static Table<Stored>; 3],
) -> Drawn<S>
where
    Soft<L, Stored>: Rule<S> + 'static,
{
    let table = tables[usize::from(draw.below(3))];
    let outside =
        [Outside::Reject, Outside::Clamp, Outside::HardSphere][usize::from(draw.below(3))];
    let rule = Soft::with_table(law(draw), table, outside);
    Drawn { rule: Box::new(rule), gain: 2e-2 }
}

/// Ten to a power from −2 to 10.
fn decade<S: Scalar>(draw: &mut Draw<'_>) -> S {
    S::from_f64(10f64.powf(f64::from(draw.byte()) / 21.25 - 2.0))
}

fn lsd<S: Scalar>(draw: &mut Draw<'_>) -> LinearDashpot<S> {
    let stiffness = decade(draw);
    let damping = if draw.below(3) == 0 { S::zero() } else { decade(draw) };
    LinearDashpot { stiffness, damping }
}

fn rubber<S: Scalar>(draw: &mut Draw<'_>) -> Viscoelastic<S> {
    let young = decade(draw);
    let dissipation =
        if draw.below(3) == 0 { S::zero() } else { decade::<S>(draw) * S::from_f64(1e-6) };
    Viscoelastic { young, poisson: S::from_f64(0.4), dissipation }
}
