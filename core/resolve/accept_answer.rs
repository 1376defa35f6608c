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
    match validity {
        Validity::Inside => {}
        Validity::Clamped => effects.count(Incident::Clamped),
        Validity::HardSphere => effects.count(Incident::HardSphere),
    }
    match response {
        Response::Instantaneous(e) => accept(e, "restitution", false, grain)?,
        Response::Lasting(o) => {
            accept(o.restitution, "restitution", false, grain)?;
            accept(o.duration, "duration", false, grain)?;
            accept(o.separation, "separation", true, grain)?;
            accept(o.angle, "angle", false, grain)?;
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

fn accept<S: Scalar>(
    value: S,
    field: &'static str,
    positive: bool,
    grain: usize,
) -> Result<(), Error> {
    if value.is_finite() && (value > S::zero() || (!positive && value >= S::zero())) {
        return Ok(());
    }
    if S::RANGE.is_some() && !value.is_finite() {
        // Whatever the rule is: what is no number here did not fit.
        return Err(Error::overflow(Subject::Grain(grain), field, S::NEVER.to_f64()));
    }
    let wanted = if positive { "finite and above 0" } else { "finite and at least 0" };
    Err(Error::InvalidOutcome { field, value: value.to_f64(), wanted })
}
