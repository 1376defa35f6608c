//! What does each listed collision lead to? Reads checked cases and a table or the contact equation; writes answers as CSV.

pub mod case;

use crate::scale::Impact;
use anyhow::Result;
use carom_tables::contact;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use case::Case;
use std::io::Write;

/// Where the matrix of restitution comes from.
pub trait Restitution {
    /// The scaled coefficients, or nothing outside the range of validity.
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>>;

    /// The nearest groups inside the range of validity.
    fn clamp(&self, law: Law, groups: &Groups<f64>) -> Groups<f64>;
}

/// The contact equation, integrated to 1e-12 for each case.
#[derive(Clone, Copy, Debug)]
pub struct Integrated(
    /// Which condition ends the contact.
    pub End,
);

impl Restitution for Integrated {
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>> {
        Some(contact::integrate(law, self.0, groups))
    }

    fn clamp(&self, _law: Law, groups: &Groups<f64>) -> Groups<f64> {
        *groups
    }
}

/// What a case led to; the numbers are those of MP13's matrix of restitution, Eqs. (16) to (21).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Duration of the contact τ (s).
    pub tau: f64,
    /// ε_t, the duration in units of T.
    pub eps_t: f64,
    /// 1 − ε_r, computed without cancellation.
    pub one_minus_eps_r: f64,
    /// ε_ṙ, negative.
    pub eps_rdot: f64,
    /// ε_φ (rad).
    pub eps_phi: f64,
}

/// One case's result: the answer (if there is one) and whether the case was inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The coefficients; nothing when outside and not clamped.
    pub answer: Option<Answer>,
    /// Whether the case lies in the range of validity.
    pub inside: bool,
}

/// Looks one case up; outside the range, takes the nearest groups inside if `clamp` says so.
pub fn solve(source: &dyn Restitution, case: &Case, end: End, clamp: bool) -> Outcome {
    let law = case.contact.law();
    let groups = &case.impact.groups;
    if let Some(scaled) = source.restitution(law, groups) {
        return Outcome { answer: Some(answer(&case.impact, &scaled, end)), inside: true };
    }
    let nearest = || {
        let impact = Impact { groups: source.clamp(law, groups), ..case.impact };
        let scaled = source.restitution(law, &impact.groups)?;
        Some(answer(&impact, &scaled, end))
    };
    Outcome { answer: if clamp { nearest() } else { None }, inside: false }
}

fn answer(impact: &Impact, scaled: &ScaledRestitution<f64>, end: End) -> Answer {
    Answer {
        tau: scaled.tau * impact.time,
        eps_t: scaled.tau,
        one_minus_eps_r: impact.shortfall(scaled, end),
        eps_rdot: -scaled.speed,
        eps_phi: scaled.angle,
    }
}

/// Writes the answers as CSV, each number with as many digits as a double needs.
///
/// # Errors
/// What `sink` says.
pub fn write(sink: &mut dyn Write, cases: &[Case], outcomes: &[Outcome]) -> Result<()> {
    let mut writer = csv::Writer::from_writer(sink);
    writer.write_record([
        "id",
        "tau",
        "eps_t",
        "one_minus_eps_r",
        "eps_rdot",
        "eps_phi",
        "status",
    ])?;
    for (case, outcome) in cases.iter().zip(outcomes) {
        let status = if outcome.inside { "ok" } else { "outside" };
        let numbers = outcome.answer.map_or_else(
            || std::array::from_fn(|_| String::new()),
            |a| {
                [a.tau, a.eps_t, a.one_minus_eps_r, a.eps_rdot, a.eps_phi].map(|x| format!("{x:?}"))
            },
        );
        let mut row = vec![case.id.as_str()];
        row.extend(numbers.iter().map(String::as_str));
        row.push(status);
        writer.write_record(row)?;
    }
    writer.flush()?;
    Ok(())
}
