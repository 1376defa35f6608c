//! What happens when two grains touch? Reads both and the rule; writes both.

use super::accept_answer::ask;
use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::{contact_begin, instantaneous_collision, rest, supported_collision, surface_collision};
use crate::error::Error;
use crate::law::{Response, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::Scalar;

/// Two grains touch.
pub(super) fn collide<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    who: [usize; 2],
) -> Result<EventOutcome<S>, Error> {
    // In the order of their numbers: it must not matter whose event it is, not in the last bit either.
    let [i, k] = if who[0] < who[1] { who } else { [who[1], who[0]] };
    let [a, b] = [context.present(i), context.present(k)];
    let [separation, velocity] = context.domain.relative(&a, &b, context.now());
    let Some(frame) = ImpactFrame::new(separation, velocity) else {
        let gap = -(a.radius + b.radius).to_f64();
        return Err(Error::Overlap { grain: i, with: Partner::grain(k), gap, also: None });
    };
    if !(frame.radial < S::zero()) {
        // Deferred until a contact could be ended, or grazing within rounding: they part already, and are
        // predicted from here. From where they were, rounding could say that they near each other, again and again.
        context.replace(i, a);
        context.replace(k, b);
        return Ok(EventOutcome::Unchanged);
    }
    let impact = frame.impact(&a, &b);
    let response = ask(rule, &impact, context.effects, (i, Partner::grain(k)))?;
    let outcome = respond(context, rule, [i, k], &[a, b], (&frame, response))?;
    if let EventOutcome::Collision { restitution } = outcome {
        surface_collision::act(context, rule, || frame.touch([i, k], restitution));
    }
    Ok(outcome)
}

// One caller: as a function of its own it would copy both bodies.
#[inline(always)]
fn respond<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    (frame, response): (&ImpactFrame<S, D>, Response<S>),
) -> Result<EventOutcome<S>, Error> {
    let [restitution, duration] = match response {
        Response::Lasting(outcome) => [outcome.restitution, outcome.duration],
        Response::Instantaneous(restitution) => [restitution, S::zero()],
        Response::Refused { .. } | Response::Overflow(_) => return Ok(EventOutcome::Unchanged),
    };
    context.count(Incident::Collision);
    let is_slow = rest::is_slow(context, pair, frame, [restitution, duration]);
    let ([i, k], [a, b], pace) = (who, pair, (is_slow, frame.radial));
    let pair = [
        rest::count_slow_collision(context, (i, a), pace),
        rest::count_slow_collision(context, (k, b), pace),
    ];
    if is_slow && rest::may_rest(rule) && rest::pair_comes_to_rest(context, who, &pair, frame) {
        return Ok(EventOutcome::CameToRest);
    }
    let [asleep, supported] = [Body::is_asleep, Body::is_supported].map(|is| pair.iter().any(is));
    if let (Response::Lasting(outcome), false) = (response, is_slow && asleep) {
        if contact_begin::begin(context, who, &pair, (frame, &outcome)) {
            return Ok(EventOutcome::ContactBegan(outcome));
        }
    }
    if is_slow && supported {
        return supported_collision::collide(context, who, &pair, frame);
    }
    instantaneous_collision::collide(context, who, &pair, frame, (restitution, is_slow))
}
