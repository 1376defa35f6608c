//! What holds grains that sleep? Reads bodies that lie still; writes nothing, tells the forces of their contacts.

use super::contact::{Mean, Touching};
use super::forces::{between, with_plane};
use super::friction::held;
use super::settings::Settings;
use super::transfer::Transfer;
use crate::law::Rule;
use crate::particle::Partner;
use crate::scalar::{Scalar, Vector, norm};
use crate::space::{Domain, Particles};

/// Visits the contacts of sleeping grains with each other and with planes: forces times one unit of time, and since when
/// both have lain still. What a sleeping grain and one awake give each other is told in the steps of that one.
pub(crate) fn for_each_resting<S: Scalar, const D: usize, R: Rule<S>>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    law: (&R, &Settings<S>),
    now: S,
    visit: &mut dyn FnMut(&Transfer<S, D>, S),
) {
    for (i, body) in particles.bodies.iter().enumerate().filter(|(_, body)| body.is_asleep()) {
        let mut tell =
            |with, touching: &Touching<S>, (normal, distance): (Vector<S, D>, S), since| {
                let impulse = resting_force(particles, law, touching, ((i, with), &normal));
                let transfer = Transfer {
                    grain: i,
                    partner: with,
                    impulse,
                    position: body.position,
                    separation: normal * distance,
                    work: S::zero(),
                    approach: None,
                };
                visit(&transfer, since);
            };
        for (p, plane) in domain.boundary.planes().iter().enumerate() {
            let overlap = -plane.gap(&body.position, body.radius, now);
            if overlap > S::zero() {
                let touching = with_plane(body, plane, overlap, now);
                let apart = (plane.normal, body.radius - overlap);
                tell(Partner::plane(p), &touching, apart, body.reference_time);
            }
        }
        if let Some(obstacles) = domain.boundary.obstacles() {
            obstacles.for_each_touched((&body.position, now), body.radius, |k, plane, distance| {
                let touching = with_plane(body, plane, body.radius - distance, now);
                tell(Partner::facet(k), &touching, (plane.normal, distance), body.reference_time);
            });
        }
        particles.cells.for_each_near(body.cell, body.radius, |k| {
            let Some(other) = particles.body(k).filter(|other| k > i && other.is_asleep()) else {
                return;
            };
            let [apart, velocity] = domain.relative(body, other, now);
            let distance = norm(&apart);
            if !(distance > S::zero() && distance < body.radius + other.radius) {
                return;
            }
            let e = apart / distance;
            let touching = between([body, other], distance, &e, &velocity);
            let since = body.reference_time.max(other.reference_time);
            tell(Partner::grain(k), &touching, (e, distance), since);
        });
    }
}

/// The force on the first of two that lie still: only the overlap counts, and what the contact remembers.
fn resting_force<S: Scalar, const D: usize, R: Rule<S>>(
    particles: &Particles<'_, S, D>,
    (rule, settings): (&R, &Settings<S>),
    touching: &Touching<S>,
    (who, normal): ((usize, Partner), &Vector<S, D>),
) -> Vector<S, D> {
    let state = particles.contacts.known(who.0, who.1);
    let mean = if !rule.remembers() || touching.hard.is_some() {
        // Without a rate it does not matter how long a step is.
        touching.mean_force(rule, settings, S::one())
    } else {
        let Some(mut state) = state.copied() else { return Vector::zeros() };
        let now = [touching.overlap, S::zero()];
        Mean::at_rest(rule.remembered_force(&touching.impact, now, state.remember()), now[0])
    };
    let held = state.zip(rule.inertia()).map(|(state, q)| {
        let law = rule.tangential(touching.impact.materials);
        law.map_or(Vector::zeros(), |law| held(&law, q, (touching, &mean), (state, normal)))
    });
    normal * mean.force + held.unwrap_or(Vector::zeros())
}
