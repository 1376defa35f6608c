//! What gives way when a contact is broken off? Reads bodies and the rule; writes velocities, and positions where those do not suffice.
//!
//! Until a pair's contact ends the two stand where it leaves them. A third body that breaks it off meets them
//! there; where they really are they may overlap it, by up to as much as they overlap each other. That
//! overlap stores energy that nobody has brought: it is taken from the speed with which they near each other.
//! (Planes are never near enough: a pair that could reach one has no contact of its own.)

use super::clearance::is_free;
use super::context::Context;
use super::impact_frame::ImpactFrame;
use crate::law::{Impact, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct};
use crate::space::flight;

/// Intervals of Simpson's rule for the energy of an overlap.
const INTERVALS: u32 = 8;

/// Those in the two lists that overlap each other give way or pay: first those of the second list, which came, give
/// way where speed cannot pay, then speed pays for what is left.
pub(super) fn between<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    [stay, came]: [[Option<usize>; 2]; 2],
) {
    for pays in [false, true] {
        for a in came.into_iter().flatten() {
            for b in stay.into_iter().flatten().filter(|&b| b != a) {
                part(context, rule, ([a, b], pays));
            }
        }
    }
}

/// Two of them: if they pay, only that; else the first gives way, or if it has no room the second.
#[inline(never)]
fn part<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (who, pays): ([usize; 2], bool),
) {
    let Some(pair) = together(context, who) else { return };
    let [a, b] = &pair;
    let [separation, velocity] = context.domain.relative(a, b, a.clock);
    let Some(frame) = ImpactFrame::new(separation, velocity) else { return };
    let impact = frame.impact(a, b);
    let overlap = impact.contact_distance - frame.distance;
    if !(overlap > S::zero()) {
        return;
    }
    match paid(rule, &impact, (overlap, frame.radial)) {
        Some(change) if pays => {
            let (change, mass) = (frame.along(change), a.mass + b.mass);
            for (x, body, share) in [(who[0], a, b.mass / mass), (who[1], b, -(a.mass / mass))] {
                context.replace(x, Body { velocity: body.velocity + change * share, ..*body });
            }
        }
        None if !pays => {
            let away = frame.along(overlap);
            let _ = give_way(context, (who[0], a), away) || give_way(context, (who[1], b), -away);
        }
        _ => {}
    }
}

/// Two bodies at the later of their clocks.
fn together<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    [i, k]: [usize; 2],
) -> Option<[Body<S, D>; 2]> {
    let (a, b) = (context.particles.body(i)?, context.particles.body(k)?);
    let at = a.clock.max(b.clock);
    Some([a, b].map(|body| flight::at(body, context.domain, at)))
}

/// By how much the speed at which two part changes if this overlap's energy is taken from it; none if it has
/// less than that.
#[inline(never)]
fn paid<S: Scalar>(rule: &impl Rule<S>, impact: &Impact<S>, (overlap, speed): (S, S)) -> Option<S> {
    let [least, now] = [released_speed(rule, impact, overlap)?, speed.abs()];
    let left = (now >= least).then(|| (now - least).times(now + least).sqrt())?;
    Some(if speed < S::zero() { now - left } else { left - now })
}

/// The speed that two have at last whom this overlap drives apart from rest: (2 ∫ F dx / m_eff)^½, by Simpson's
/// rule, exact for a linear spring.
fn released_speed<S: Scalar>(rule: &impl Rule<S>, impact: &Impact<S>, overlap: S) -> Option<S> {
    let width = overlap / S::from_count(INTERVALS);
    let mut sum = S::zero();
    for n in 0..=INTERVALS {
        let weight = match n {
            0 | INTERVALS => 1.0,
            n if n % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let force = rule.force(impact, width * S::from_count(n))?;
        sum += force.elastic / impact.reduced_mass * S::from_f64(weight / 3.0);
    }
    Some((sum + sum).times(width).sqrt())
}

/// Puts a grain elsewhere if there is room.
fn give_way<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (i, body): (usize, &Body<S, D>),
    by: Vector<S, D>,
) -> bool {
    let position = body.position + context.domain.boundary.on_lattice(by);
    let room =
        is_free(context.particles, context.domain, body.clock, (i, position, Partner::NOTHING));
    if room {
        context.relocate(i, Body { position, ..*body });
    }
    room
}
