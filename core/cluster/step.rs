//! How do clustered grains move in a step? Reads forces; writes bodies, who is in a cluster, and the next step's length.
//!
//! Positions go to the middle of the step, forces are taken there, velocities change, positions go on: one
//! evaluation of forces, of second order, and symmetric in time where nothing is lost. A dashpot needs the
//! velocity in the middle: it is predicted by the last step's acceleration.

use super::forces::{Crush, Forces};
use super::friction;
use super::members::{Clusters, join, leave, sleep};
use super::remembered;
use super::settings::Settings;
use super::sleep::{may_sleep, rounded_speed};
use super::transfer::Receiver;
use crate::error::Error;
use crate::law::Rule;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, norm};
use crate::space::{Domain, Particles};

/// A grain that has touched nothing for so many steps flies freely.
const FREE_AFTER: f32 = 8.0;

/// Clustered grains move on to this time, which is not later than the step is long. Returns who is crushed most.
///
/// # Errors
/// [`Error::Full`] if there was no place for a contact under friction.
pub(crate) fn step<S: Scalar, const D: usize, R: Rule<S>, O: Receiver<S, D>>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    clusters: &mut Clusters<S>,
    (rule, settings): (&R, &Settings<S>),
    to: S,
    receiver: &mut O,
) -> Result<Option<Crush<S>>, Error> {
    let (from, step) = (clusters.time, to - clusters.time);
    let half = step * S::half();
    let (mut crush, mut full) = (None, None);
    if step > S::zero() {
        let [begin, middle, end] = clusters.counted_from(step, particles.largest_radius);
        for_each(particles, clusters, |particles, i| {
            to_the_middle(particles, domain, i, ([from, half], [begin, middle]));
            if rule.inertia().is_some() {
                particles.rotation.go_to_middle::<D>(i, half);
            }
        });
        let mut forces = Forces {
            particles,
            domain,
            rule,
            settings,
            middle: from + half,
            end: to,
            step,
            deepest: S::zero(),
            frequency: S::zero(),
            crush: None,
            woken: heapless::Vec::new(),
            full: None,
            receiver,
        };
        forces.add(clusters);
        (crush, full) = (forces.crush, forces.full);
        let (deepest, frequency, woken) = (forces.deepest, forces.frequency, forces.woken);
        let mut fastest = S::zero();
        for_each(particles, clusters, |particles, i| {
            let times = ([to, step], [middle, end]);
            fastest = fastest.max(to_the_end(particles, domain, settings, i, times));
            if rule.inertia().is_some() {
                friction::turn(particles, settings, i, [to, step]);
            }
        });
        (clusters.time, clusters.speed, clusters.phase) = (to, fastest, end);
        woken.iter().for_each(|&k| join(particles, domain, clusters, (k, to)));
        if rule.inertia().is_some() || rule.remembers() {
            remembered::forget(particles);
        }
        clusters.step = settings.step(rule, fastest, (deepest, frequency));
    } else {
        clusters.step = settings.step(rule, clusters.speed, (S::zero(), S::zero()));
    }
    full.map_or(Ok(crush), Err)
}

/// Visits all clustered grains by their numbers.
fn for_each<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    clusters: &Clusters<S>,
    mut visit: impl FnMut(&mut Particles<'_, S, D>, usize),
) {
    let mut next = clusters.first();
    while let Some(i) = next {
        visit(particles, i);
        next = particles.body(i).and_then(|body| body.partner.next_clustered());
    }
}

/// The first half of the step. Whoever was free a moment ago is taken to its beginning first.
fn to_the_middle<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    i: usize,
    ([from, half], counted): ([S; 2], [S; 2]),
) {
    let body = particles.present(i, domain, from);
    let before = body.velocity_change;
    if let Some(place) = particles.accelerations.get_mut(i) {
        *place = before;
    }
    let there = Body {
        position: body.position + way(&body, domain, &body.velocity, counted),
        velocity: body.velocity + before * half,
        velocity_change: Vector::zeros(),
        ..body
    };
    particles.relocate(&domain.boundary, (i, from + half), there);
}

/// How far a grain goes in half a step, from one of these instants to the other: the difference of the ways to both,
/// each rounded to the lattice on which positions lie. In half a step a slow grain goes less than that lattice is
/// wide; rounded by themselves such ways would add up to another speed, and grains would drift into each other.
/// (On a lattice, too, so that it does not matter in which image a grain is kept.)
#[inline(never)]
fn way<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &Domain<'_, S, D>,
    velocity: &Vector<S, D>,
    [from, to]: [S; 2],
) -> Vector<S, D> {
    let rounded = |time| domain.boundary.on_lattice_near(&body.position, velocity * time);
    rounded(to) - rounded(from)
}

/// The second half; returns the grain's speed.
fn to_the_end<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    settings: &Settings<S>,
    i: usize,
    ([to, step], counted): ([S; 2], [S; 2]),
) -> S {
    let half = step * S::half();
    let Some(body) = particles.body(i).copied() else { return S::zero() };
    let now = body.velocity_change + domain.gravity();
    let before = particles.accelerations.get(i).copied().unwrap_or(now);
    let velocity = body.velocity - before * half + now * step;
    let speed = norm(&velocity);
    let slow = settings.sleep_speed(body.radius).max(rounded_speed(&body, step));
    let is_slow = speed <= slow;
    let there = Body {
        position: body.position + way(&body, domain, &velocity, counted),
        velocity,
        velocity_change: now,
        clock: to,
        reference_time: if is_slow { body.reference_time } else { to },
        consecutive_collisions: 0,
        ..body
    };
    particles.relocate(&domain.boundary, (i, to), there);
    speed
}

/// After a step: a grain that touches nothing flies, and one that has been slow among such as it for long sleeps.
pub(crate) fn settle<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    clusters: &mut Clusters<S>,
    (settings, i): (&Settings<S>, usize),
) {
    let now = clusters.time;
    let Some(body) = particles.body(i).copied() else { return };
    if body.contact_end < now - clusters.step * S::from_f32(FREE_AFTER) {
        leave(particles, clusters, (i, now));
    } else if !domain.is_weightless()
        && domain.is_still()
        && may_sleep(particles, domain, settings, (i, &body), [now, clusters.step])
    {
        sleep(particles, domain, clusters, (i, now));
    }
}
