//! What happens now? Reads a slot and the rule; writes the bodies it concerns and the counters.

use super::scene::{Release, Scene};
use super::turn::Touch;
use super::{bounce, contact, plane, rest};
use crate::fault::{Fault, Subject};
use crate::law::force::Scales;
use crate::law::{Answer, Encounter, Outcome, Response, Rule, Trust};
use crate::matter::grid::Stride;
use crate::matter::{Body, Partner};
use crate::number::{Scalar, Vector, dot};

/// What an event did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Deed<S> {
    /// An instantaneous collision with this coefficient of restitution.
    Collision {
        /// ε.
        restitution: S,
    },
    /// A contact began (E^φ).
    Contact(Outcome<S>),
    /// A contact ended (E^v).
    Release,
    /// A grain came to rest: on a plane, on which it may slide, or frozen among others.
    Rest,
    /// A grain at rest was let go.
    TakeOff,
    /// A third body came before the contact's end, which was drawn forward to now.
    Interruption,
    /// The neighbours were looked at again.
    Wander,
}

/// The grains that an event concerns.
#[derive(Default)]
pub(crate) struct Affected {
    /// Their events must be predicted anew.
    pub again: heapless::Vec<usize, 4>,
    /// They were at rest until now: those that lie on them must look again.
    pub woken: heapless::Vec<usize, 4>,
}

impl Affected {
    /// This grain's events must be predicted anew. No event concerns more than four grains.
    pub fn again(&mut self, grain: usize) {
        if !self.again.contains(&grain) {
            let _ = self.again.push(grain);
        }
    }

    /// This grain was at rest until now.
    pub fn wakes(&mut self, grain: usize) {
        let _ = self.woken.push(grain);
    }
}

/// Grain `i` meets its partner.
pub(crate) fn meet<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    rule: &impl Rule<S>,
    i: usize,
    partner: Partner,
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    affected.again(i);
    let other = partner.as_grain();
    if let Some(k) = other {
        affected.again(k);
    }
    if interrupt(scene, [Some(i), other], affected) {
        return Ok(Deed::Interruption);
    }
    match (other, partner.as_plane()) {
        (Some(k), _) => grains(scene, rule, [i, k], affected),
        (None, Some(p)) => plane::meet(scene, rule, i, p, affected),
        (None, None) => Ok(Deed::Wander),
    }
}

/// Ends the contacts that the grains are in before their time (MP13 §VI.B.5, exception b).
///
/// Only that: if the two still approach each other afterwards, they meet again at this instant.
fn interrupt<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    grains: [Option<usize>; 2],
    affected: &mut Affected,
) -> bool {
    let mut any = false;
    for i in grains.into_iter().flatten() {
        if let Some(body) = scene.body(i).filter(|body| body.in_contact()) {
            scene.counters.put_off += u64::from(scene.now <= body.moment);
            scene.counters.interrupted += 1;
            end_contact(scene, i, affected);
            any = true;
        }
    }
    any
}

/// The contact of grain `i` ends at its time.
pub(crate) fn release<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) -> Deed<S> {
    affected.again(i);
    let before = affected.again.len();
    end_contact(scene, i, affected);
    scene.counters.releases += 1 + u64::from(affected.again.len() > before);
    Deed::Release
}

/// E^v for grain `i`, and for its partner too if they are released as a pair.
fn end_contact<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) {
    let partner = scene.body(i).and_then(|body| body.partner.as_grain());
    if let Some(k) = partner.filter(|&k| scene.release == Release::Paired && scene.bound(i, k)) {
        set_free(scene, k);
        affected.again(k);
    }
    set_free(scene, i);
}

/// Gives a grain the velocity its contact left for it (MP13 §VI.B.3).
fn set_free<S: Scalar, const D: usize>(scene: &mut Scene<'_, S, D>, i: usize) {
    let body = scene.present(i);
    let plane = body.partner.as_plane().and_then(|p| scene.boundary.planes().get(p));
    let velocity = match plane {
        Some(plane) => without(&body.velocity, &plane.normal) + body.release,
        None => body.velocity + body.release,
    };
    let free = Body {
        velocity,
        release: Vector::zeros(),
        release_at: S::NEVER,
        moment: scene.now,
        partner: Partner::NOTHING,
        ..body
    };
    scene.place(i, free);
}

/// The part of a vector across a unit vector.
pub(super) fn without<S: Scalar, const D: usize>(
    v: &Vector<S, D>,
    n: &Vector<S, D>,
) -> Vector<S, D> {
    v - n * dot(n, v)
}

/// Asks the rule, counts how far its answer can be trusted, and checks that it is one.
pub(super) fn ask<S: Scalar>(
    rule: &impl Rule<S>,
    encounter: &Encounter<S>,
    counters: &mut super::scene::Counters,
    who: (usize, Partner),
) -> Result<Response<S>, Fault> {
    let Answer { response, trust } = rule.meet(encounter);
    match trust {
        Trust::Inside => {}
        Trust::Clamped => counters.clamped += 1,
        Trust::HardSphere => counters.hard_sphere += 1,
    }
    match response {
        Response::Instant(e) => sound(e, "restitution", false, who.0)?,
        Response::Lasting(o) => {
            sound(o.restitution, "restitution", false, who.0)?;
            sound(o.duration, "duration", false, who.0)?;
            sound(o.separation, "separation", true, who.0)?;
            sound(o.angle, "angle", false, who.0)?;
        }
        Response::Overflow(quantity) => {
            let range = S::NEVER.to_f64();
            return Err(Fault::overflow(Subject::Grain(who.0), quantity, range));
        }
        Response::Refused { eta, c_dis } => return Err(refused(encounter, who, eta, c_dis)),
    }
    Ok(response)
}

fn refused<S: Scalar>(
    e: &Encounter<S>,
    (grain, with): (usize, Partner),
    eta: S,
    c_dis: S,
) -> Fault {
    let scales = Scales { time: S::one(), length: S::zero(), c_dis: S::zero() };
    let eccentricity = e.groups(&scales).sin.to_f64();
    Fault::OutsideTable { grain, with, eccentricity, eta: eta.to_f64(), c_dis: c_dis.to_f64() }
}

fn sound<S: Scalar>(
    value: S,
    field: &'static str,
    positive: bool,
    grain: usize,
) -> Result<(), Fault> {
    if value.is_number() && (value > S::zero() || (!positive && value >= S::zero())) {
        return Ok(());
    }
    if S::RANGE.is_some() && !value.is_number() {
        // Whatever the rule is: what is no number here did not fit.
        return Err(Fault::overflow(Subject::Grain(grain), field, S::NEVER.to_f64()));
    }
    let wanted = if positive { "finite and above 0" } else { "finite and at least 0" };
    Err(Fault::BadRule { field, value: value.to_f64(), wanted })
}

/// Two grains touch.
fn grains<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    rule: &impl Rule<S>,
    who: [usize; 2],
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    // In the order of their numbers: it must not matter whose event it is, not in the last bit either.
    let [i, k] = if who[0] < who[1] { who } else { [who[1], who[0]] };
    let who = [i, k];
    let pair = [scene.present(i), scene.present(k)];
    let [a, b] = &pair;
    let Some(touch) = Touch::new(scene.separation(a, b), a.velocity - b.velocity) else {
        return Err(Fault::Overlap {
            grain: i,
            with: Partner::grain(k),
            gap: -(a.radius + b.radius).to_f64(),
        });
    };
    if !(touch.radial < S::zero()) {
        // Put off until a contact could be ended, or grazing within rounding: they part already.
        return Ok(Deed::Wander);
    }
    let encounter = touch.encounter(a, b);
    let response = ask(rule, &encounter, &mut scene.counters, (i, Partner::grain(k)))?;
    let (restitution, duration) = match response {
        Response::Lasting(outcome) => (outcome.restitution, outcome.duration),
        Response::Instant(restitution) => (restitution, S::zero()),
        Response::Refused { .. } | Response::Overflow(_) => return Ok(Deed::Wander),
    };
    scene.counters.collisions += 1;
    let is_slow = rest::is_slow(scene, &pair, &touch, [restitution, duration]);
    let pace = (is_slow, touch.radial);
    let pair =
        [rest::calmed(scene, (i, a), pace, affected), rest::calmed(scene, (k, b), pace, affected)];
    if is_slow && rest::comes(scene, who, &pair, &touch) {
        return Ok(Deed::Rest);
    }
    let [frozen, held] = [Body::is_frozen, Body::is_held].map(|is| pair.iter().any(is));
    if let Response::Lasting(outcome) = response
        && !(is_slow && frozen)
        && contact::begins(scene, who, &pair, (&touch, &outcome), affected)
    {
        return Ok(Deed::Contact(outcome));
    }
    if is_slow && held {
        return rest::part(scene, who, &pair, &touch, affected);
    }
    bounce::grains(scene, who, &pair, &touch, (restitution, is_slow), affected)
}

/// Whether a body can still be computed with; the field that cannot.
pub(crate) fn broken<S: Scalar, const D: usize>(body: &Body<S, D>) -> Option<&'static str> {
    let inside = |v: &Vector<S, D>| v.iter().all(|x| x.in_range());
    if !inside(&body.position) {
        return Some("position");
    }
    if !(body.release_at.is_number()) {
        return Some("time of release");
    }
    (!inside(&body.velocity) || !inside(&body.release)).then_some("velocity")
}

/// Grain `i` leaves its cell or has flown far: other grains are near it now; its motion stays the same.
pub(crate) fn wander<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    face: u8,
) -> Deed<S> {
    scene.counters.wanderings += 1;
    if scene.cells.grid.is_some() {
        scene.cross(i, Stride::from_code(face));
    } else {
        scene.rein_in(i);
    }
    Deed::Wander
}
