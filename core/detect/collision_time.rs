//! When do two bodies, or a body and a plane, touch? Reads both; writes nothing, picks closed form or bracket.

use super::bracketed_root::{Found, Search};
use super::plate_acceleration::{peak_acceleration, peak_acceleration_along};
use super::root;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, WideProduct, component, dot, norm};
use crate::space::{Domain, Images, Particles, Plane, flight};

/// At what time two bodies touch that nothing supports: BSFP14's rule. Uniform gravity leaves their
/// relative motion straight.
///
/// It depends on nothing but the two, not on when it is asked: both are taken at the later of their
/// clocks. `image` is what their separation lacks to that of the images which are near now.
#[cfg_attr(feature = "alloc", inline(always))]
#[cfg_attr(not(feature = "alloc"), inline)]
pub(super) fn free_pair<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    [me, other]: [&Body<S, D>; 2],
    image: &Vector<S, D>,
) -> Option<S> {
    let (from, [x, v], [y, w]) = at_later_clock(domain, [me, other]);
    let span = root::spheres(&(x - y + image), &(v - w), me.radius + other.radius)?;
    Some(from + span)
}

/// Positions and velocities of two bodies at the later of their clocks, and that.
#[inline(always)]
fn at_later_clock<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    [me, other]: [&Body<S, D>; 2],
) -> (S, [Vector<S, D>; 2], [Vector<S, D>; 2]) {
    let mut from = me.clock;
    let (mut x, mut v) = (me.position, me.velocity);
    let (mut y, mut w) = (other.position, other.velocity);
    if other.clock <= from {
        (y, w) = flight::free(other, domain, from);
    } else {
        from = other.clock;
        (x, v) = flight::free(me, domain, from);
    }
    (from, [x, v], [y, w])
}

/// The same across a sheared face: the other's image so many rows above the box, that which is the nearest along the
/// flow now. It depends on the two and on which image that is, not on when it is asked.
pub(super) fn pair_across<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    images: &Images<S>,
    now: S,
    ((here, me), other): ((&Vector<S, D>, &Body<S, D>), &Body<S, D>),
    rows: S,
) -> Option<S> {
    let [place, _] = images.image(rows, now);
    let apart = here - flight::free(other, domain, now).0 - place;
    let mut lengths = domain.boundary.nearest(domain.boundary.nearest(apart)) - apart;
    let (from, [x, v], [y, w]) = at_later_clock(domain, [me, other]);
    let flow = images.shear.flow;
    let along = component(&place, flow) - component(&lengths, flow);
    if let Some(along) = lengths.get_mut(flow) {
        // They are in the place of the image then.
        *along = S::zero();
    }
    let [then, moves] = images.continued(rows, (along, now), from);
    let apart = x - y - then + lengths;
    let span = root::spheres(&apart, &(v - w - moves), me.radius + other.radius)?;
    Some(from + span)
}

/// What the separation of two bodies, one of them `here` now, lacks to that of their nearest images.
#[inline(never)]
pub(super) fn nearest_image<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    here: &Vector<S, D>,
    other: &Body<S, D>,
) -> Vector<S, D> {
    let apart = here - flight::free(other, domain, now).0;
    domain.boundary.nearest(apart) - apart
}

/// How long after `start` two bodies touch of which at least one is supported. Both are as they are then.
///
/// A pair in contact has one velocity copied twice; it is skipped by the caller so that rounding of
/// two clocks cannot make it meet itself.
pub(super) fn supported_pair<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    start: S,
    [me, other]: [&Body<S, D>; 2],
    limit: S,
) -> Found<S> {
    let reach = me.radius + other.radius;
    if me.is_asleep() && other.is_asleep() && me.planes == other.planes {
        return Found::Nothing;
    }
    let apart = flight::acceleration(me, domain) - flight::acceleration(other, domain);
    let together = flight::carrying_plates(me, domain).eq(flight::carrying_plates(other, domain));
    let shaking = match together {
        true => S::zero(),
        false => peak_acceleration(domain, me) + peak_acceleration(domain, other),
    };
    let bound = norm(&apart) + shaking;
    let [separation, velocity] = domain.relative(me, other, start);
    if bound <= S::negligible_acceleration(reach) {
        let found = root::spheres(&separation, &velocity, reach);
        return found.map_or(Found::Nothing, Found::Event);
    }
    // Where they pass each other the distance grows by v²/r.
    let most = bound + S::dot(&velocity, &velocity).divided_by(reach);
    Search::new([bound, most], reach, limit).first(|t| {
        let [a, b] = [me, other].map(|body| flight::at(body, domain, start + t));
        let [apart, velocity] = domain.relative(&a, &b, start + t);
        overlap(&apart, &velocity, reach)
    })
}

/// f = |r| − σ and ḟ. The difference of squares keeps the last places of a touching pair.
fn overlap<S: Scalar, const D: usize>(r: &Vector<S, D>, v: &Vector<S, D>, sigma: S) -> (S, S) {
    let distance = norm(r);
    if !(distance > S::zero()) {
        return (-sigma, -norm(v));
    }
    let gap = (S::dot(r, r) - sigma.times(sigma)).divided_by(distance + sigma);
    (gap, S::dot(r, v).divided_by(distance))
}

/// At what time a body that nothing supports touches a plane that stands, or goes on steadily; from its own clock on.
/// Where that is visibly after a limit it may say nothing.
#[inline]
pub(super) fn free_body_and_wall<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    (wall, limit): (&Plane<S, D>, S),
) -> Option<S> {
    let n = &wall.normal;
    let mut gap = wall.mean_gap(&me.position, me.radius);
    let [mut v, a] = [&me.velocity, domain.gravity()].map(|x| dot(n, x));
    if let Some(drift) = wall.drift() {
        gap -= drift.at(me.clock).place;
        v -= drift.rate();
    }
    let margin = me.radius * S::from_f32(1.0 / 256.0);
    if root::stays_above(margin, [gap, v, a], limit - me.clock) {
        return None;
    }
    Some(me.clock + root::plane(gap, v, a)?)
}

/// How long after `start` a body, as it is then, touches a plane that does not support it.
pub(super) fn body_and_plane<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    start: S,
    me: &Body<S, D>,
    (plane, limit): (&Plane<S, D>, S),
) -> Found<S> {
    let n = &plane.normal;
    let mean = plane.mean_gap(&me.position, me.radius);
    let (v, a) = (dot(n, &me.velocity), dot(n, &flight::acceleration(me, domain)));
    let bracketed = |from| bracketed_from(domain, start, me, (plane, from, limit));
    let Some(vibration) = plane.vibration() else {
        let motion = plane.motion(start);
        return match peak_acceleration_along(domain, me, n) > S::zero() {
            false => root::plane(mean - motion.place, v - motion.speed, a)
                .map_or(Found::Nothing, Found::Event),
            true => bracketed(S::zero()),
        };
    };
    // Above the plate's highest place there is nothing to touch.
    let top = vibration.swing().abs();
    if mean > top && !(peak_acceleration_along(domain, me, n) > S::zero()) {
        return match root::plane(mean - top, v, a) {
            Some(from) if from <= limit => bracketed(from),
            _ => Found::Nothing,
        };
    }
    bracketed(S::zero())
}

/// The same while the plane or what carries the body vibrates, looking from a span on.
fn bracketed_from<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    start: S,
    me: &Body<S, D>,
    (plane, from, limit): (&Plane<S, D>, S, S),
) -> Found<S> {
    let a = dot(&plane.normal, &flight::acceleration(me, domain)).abs();
    let shaking = plane.vibration().map_or(S::zero(), |v| v.peak_acceleration())
        + peak_acceleration_along(domain, me, &plane.normal);
    let bound = (a + shaking).max(S::negligible_acceleration(me.radius));
    let found = Search::new([bound; 2], me.radius, limit - from).first(|t| {
        let then = start + (from + t);
        let body = flight::at(me, domain, then);
        let rate = dot(&plane.normal, &body.velocity) - plane.motion(then).speed;
        (plane.gap(&body.position, me.radius, then), rate)
    });
    match found {
        Found::Event(span) => Found::Event(from + span),
        Found::NotBefore(span) => Found::NotBefore(from + span),
        Found::Nothing => Found::Nothing,
    }
}

/// At what time two bodies touch that fly freely, or of which the second is asleep; none if they do not.
pub(crate) fn pair_collision<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    [i, k]: [usize; 2],
) -> Option<S> {
    let (me, other) = (particles.body(i)?, particles.body(k)?);
    let here = flight::at(me, domain, now);
    if other.is_asleep() {
        let there = flight::at(other, domain, now);
        let [apart, nears] = domain.relative(&here, &there, now);
        return Some(now + root::spheres(&apart, &nears, me.radius + other.radius)?);
    }
    if let Some(images) = domain.boundary.images() {
        let there = flight::free(other, domain, now).0;
        let rows = images.nearest_row(component(&(here.position - there), images.shear.gradient));
        return pair_across(domain, images, now, ((&here.position, me), other), rows);
    }
    let image = match domain.boundary.is_open() {
        true => Vector::zeros(),
        false => nearest_image(domain, now, &here.position, other),
    };
    free_pair(domain, [me, other], &image)
}

/// At what time, not after the limit, a body that flies freely touches a plane; none if it does not.
pub(crate) fn plane_collision<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    (plane, limit): (&Plane<S, D>, S),
) -> Option<S> {
    let here = flight::at(me, domain, now);
    match body_and_plane(domain, now, &here, (plane, limit - now)) {
        Found::Event(span) => Some(now + span),
        Found::NotBefore(_) | Found::Nothing => None,
    }
}
