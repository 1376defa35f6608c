//! Can a rule's answer be used? Reads an impact and the rule; writes nothing, refuses what is no outcome.

use super::effects::{Effects, Incident};
use crate::error::{Error, Subject};
use crate::law::{Answer, Impact, Response, Rule, Scales, Validity};
use crate::particle::Partner;
use crate::scalar::Scalar;

/// Asks the rule, notes how far its answer can be trusted, and accepts it if it is the outcome of a collision.
pub(super) fn ask<S: Scalar>(
    rule: &impl Rule<S>,
    impact: &Impact<S>,
    effects: &mut Effects,
    (grain, with): (usize, Partner),
) -> Result<Response<S>, Error> {
    let Answer { response, validity } = rule.collide(impact);
    // A fitted table may lie above one by its error.
    let one = S::from_f64(1.0 + 1.0 / 256.0);
    let most = if rule.adds_energy() { S::NEVER } else { one };
    match validity {
        Validity::Inside => {}
        Validity::Clamped => effects.count(Incident::Clamped),
        Validity::HardSphere => effects.count(Incident::HardSphere),
    }
    match response {
        Response::Instantaneous(e) => accept(e, "restitution", Some(most), grain)?,
        Response::Lasting(o) => {
            accept(o.restitution, "restitution", Some(most), grain)?;
            accept(o.duration, "duration", None, grain)?;
            accept_separation(o.separation, one, grain)?;
            accept(o.angle, "angle", None, grain)?;
        }
        Response::Overflow(quantity) => {
            let range = S::NEVER.to_f64();
            return Err(Error::overflow(Subject::Grain(grain), quantity, range));
        }
        Response::Refused { eta, c_dis } => {
            return Err(outside_table(impact, (grain, with), eta, c_dis));
        }
    }
    Ok(response)
}

fn outside_table<S: Scalar>(
    impact: &Impact<S>,
    (grain, with): (usize, Partner),
    eta: S,
    c_dis: S,
) -> Error {
    let scales = Scales { time: S::one(), length: S::zero(), c_dis: S::zero() };
    let eccentricity = impact.groups(&scales).sin.to_f64();
    Error::OutsideTable { grain, with, eccentricity, eta: eta.to_f64(), c_dis: c_dis.to_f64() }
}

/// The distance at the end of a contact cannot be larger than at its beginning, in units of which it is.
fn accept_separation<S: Scalar>(value: S, one: S, grain: usize) -> Result<(), Error> {
    accept(value, "separation", None, grain)?;
    if value > S::zero() && value <= one {
        return Ok(());
    }
    let wanted = "above 0 and at most 1, in units of the contact distance";
    Err(Error::InvalidOutcome { field: "separation", value: value.to_f64(), wanted })
}

fn accept<S: Scalar>(
    value: S,
    field: &'static str,
    most: Option<S>,
    grain: usize,
) -> Result<(), Error> {
    if value.is_finite() && value >= S::zero() && most.is_none_or(|most| value <= most) {
        return Ok(());
    }
    if S::RANGE.is_some() && !value.is_finite() {
        // Whatever the rule is: what is no number here did not fit.
        return Err(Error::overflow(Subject::Grain(grain), field, S::NEVER.to_f64()));
    }
    let wanted = match most {
        Some(_) => "between 0 and 1, or a rule that says that it adds energy (Rule::adds_energy)",
        None => "finite and at least 0",
    };
    Err(Error::InvalidOutcome { field, value: value.to_f64(), wanted })
}
