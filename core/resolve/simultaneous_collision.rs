//! What is left of collisions that come at one instant and share a grain? Reads bodies that touch and the rule; writes velocities.
//!
//! They have no order: one after the other, what comes first decides, and what was symmetric is so no longer. So
//! all of them happen together: impulses p ≥ 0 along the normals such that at each contact that has one the
//! speed of separation is ε times that of approach (Moreau, in: Nonsmooth Mechanics and Applications, CISM
//! 302, 1988). Energy changes by −Σ p (1 − ε) v_n/2, which is never a gain.

use super::context::Context;
use super::crowded_collision::{kick, min_parting_speed};
use super::impact_frame::ImpactFrame;
use super::plane_collision;
use crate::cluster::put_last_in_order;
use crate::law::{Impact, Response, Rule};
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot};
use crate::space::{Plane, Surface};

/// More bodies, or contacts, than these are left to collide in the order of their speeds.
const MAX_BODIES: usize = 20;
const MAX_CONTACTS: usize = 40;

/// After so many rounds the impulses are as good as they get: each halves what is left of their error, or so.
const ROUNDS: u32 = 256;

/// A grain as it was before all of it, and what its velocity changes by.
struct Party<S: Scalar, const D: usize> {
    grain: usize,
    body: Body<S, D>,
    change: Vector<S, D>,
}

/// Two that touch and near each other.
struct Contact<S: Scalar, const D: usize> {
    /// Places of both in the list of parties; no second one is a plane.
    places: (usize, Option<usize>),
    /// From the second to the first.
    normal: Vector<S, D>,
    /// By how much their speed along it is to change.
    wanted: S,
    /// The reduced mass.
    mass: S,
    impulse: S,
}

/// All that collide at one instant, connected by grains that they share.
pub(crate) struct Crowd<S: Scalar, const D: usize> {
    parties: heapless::Vec<Party<S, D>, MAX_BODIES>,
    contacts: heapless::Vec<Contact<S, D>, MAX_CONTACTS>,
}

impl<S: Scalar, const D: usize> Crowd<S, D> {
    /// Those that these touch now and near, and so on; none if it is one contact only, or if one of them takes part in
    /// something that lasts, or if they are too many.
    pub fn gather(
        context: &Context<'_, '_, S, D>,
        rule: &impl Rule<S>,
        first: impl Iterator<Item = (usize, Body<S, D>)>,
    ) -> Option<Self> {
        let mut crowd = Self { parties: heapless::Vec::new(), contacts: heapless::Vec::new() };
        for (grain, body) in first {
            crowd.add(grain, body)?;
        }
        let mut place = 0;
        while place < crowd.parties.len() {
            crowd.look_around(context, rule, place)?;
            place += 1;
        }
        (crowd.contacts.len() > 1).then_some(crowd)
    }

    /// A grain takes part. Its place; none if it cannot.
    fn add(&mut self, grain: usize, body: Body<S, D>) -> Option<usize> {
        let lasts = body.in_contact() || body.is_clustered() || body.is_supported();
        let party = Party { grain, body, change: Vector::zeros() };
        (!lasts && self.parties.push(party).is_ok()).then(|| self.parties.len() - 1)
    }

    /// Adds what the party in this place touches and nears.
    fn look_around(
        &mut self,
        context: &Context<'_, '_, S, D>,
        rule: &impl Rule<S>,
        place: usize,
    ) -> Option<()> {
        let (grain, body) = self.parties.get(place).map(|party| (party.grain, party.body))?;
        let mut near = heapless::Vec::<usize, MAX_BODIES>::new();
        let mut fits = true;
        context.particles.cells.for_each_near(body.cell, body.radius, |k| {
            if k != grain && self.touches(context, (place, &body), k) {
                fits &= near.push(k).is_ok();
                put_last_in_order(&mut near);
            }
        });
        for &k in near.iter().filter(|_| fits) {
            self.add_pair(context, rule, (place, &body), k)?;
        }
        for plane in context.domain.boundary.planes() {
            fits = fits && self.add_plane(context, rule, (place, &body), plane);
        }
        if let Some(obstacles) = context.domain.boundary.obstacles() {
            let reach = body.radius + slack(&body);
            obstacles.for_each_touched((&body.position, context.now()), reach, |_, plane, _| {
                fits = fits && self.add_plane(context, rule, (place, &body), plane);
            });
        }
        fits.then_some(())
    }

    /// The grain `k` as it was before, and its place if it takes part already.
    fn before(&self, context: &Context<'_, '_, S, D>, k: usize) -> (Body<S, D>, Option<usize>) {
        let place = self.parties.iter().position(|party| party.grain == k);
        let known = place.and_then(|place| self.parties.get(place)).map(|party| party.body);
        (known.unwrap_or_else(|| context.present(k)), place)
    }

    /// Whether a contact with grain `k` is to be added: one that was looked around from has all of its own.
    fn touches(
        &self,
        context: &Context<'_, '_, S, D>,
        (place, body): (usize, &Body<S, D>),
        k: usize,
    ) -> bool {
        let (other, known) = self.before(context, k);
        let [apart, velocity] = context.domain.relative(body, &other, context.now());
        let reach = body.radius + other.radius + slack(body).max(slack(&other));
        let is_new = known.is_none_or(|known| known > place);
        let nears = ImpactFrame::new(apart, velocity)
            .is_some_and(|frame| frame.radial < -least(body, &other));
        is_new && nears && S::dot(&apart, &apart) <= reach.times(reach)
    }

    fn add_pair(
        &mut self,
        context: &Context<'_, '_, S, D>,
        rule: &impl Rule<S>,
        (place, body): (usize, &Body<S, D>),
        k: usize,
    ) -> Option<()> {
        let (other, known) = self.before(context, k);
        let [apart, velocity] = context.domain.relative(body, &other, context.now());
        let frame = ImpactFrame::new(apart, velocity)?;
        let impact = frame.impact(body, &other);
        let wanted = change_of(instantaneous(rule, &impact)?, -frame.radial, least(body, &other));
        let partner = known.or_else(|| self.add(k, other))?;
        self.contact((place, Some(partner)), frame.e_r(), (wanted, impact.reduced_mass))
    }

    /// False if it cannot be added.
    fn add_plane(
        &mut self,
        context: &Context<'_, '_, S, D>,
        rule: &impl Rule<S>,
        (place, body): (usize, &Body<S, D>),
        plane: &Plane<S, D>,
    ) -> bool {
        let motion = plane.motion(context.now());
        let speed = motion.speed - dot(&plane.normal, &body.velocity);
        let gap = plane.gap(&body.position, body.radius, context.now());
        let least = min_parting_speed(&body.velocity);
        if !(speed > least && gap <= slack(body)) {
            return true;
        }
        let weight = motion.acceleration - dot(&plane.normal, context.domain.gravity());
        let restitution = match plane.surface {
            Surface::Hard(restitution) => Some(restitution),
            Surface::Rule | Surface::Material(_) => {
                instantaneous(rule, &plane_collision::impact(body, plane, speed, weight))
            }
        };
        restitution.is_some_and(|restitution| {
            let wanted = change_of(restitution, speed, least);
            self.contact((place, None), plane.normal, (wanted, body.mass)).is_some()
        })
    }

    fn contact(
        &mut self,
        places: (usize, Option<usize>),
        normal: Vector<S, D>,
        (wanted, mass): (S, S),
    ) -> Option<()> {
        let contact = Contact { places, normal, wanted, mass, impulse: S::zero() };
        self.contacts.push(contact).ok()
    }

    /// All of it happens. The grains concerned, and how many of the contacts are with planes.
    pub fn happen(mut self, context: &mut Context<'_, '_, S, D>) -> (Grains, [u64; 2]) {
        let fastest = self.contacts.iter().fold(S::zero(), |most, c| most.max(c.wanted));
        for _ in 0..ROUNDS {
            if !(self.round() > fastest.rounding()) {
                break;
            }
        }
        let mut grains = Grains::new();
        for Party { grain, body, change } in &self.parties {
            context.replace(*grain, *body);
            kick(context, (*grain, body, body.radius), *change);
            let _ = grains.push(*grain);
        }
        let planes = self.contacts.iter().filter(|contact| contact.places.1.is_none()).count();
        (grains, [self.contacts.len() - planes, planes].map(|count| count as u64))
    }

    /// Corrects each impulse once, those before it being as they are. By how much the worst speed was wrong.
    fn round(&mut self) -> S {
        let mut worst = S::zero();
        for contact in &mut self.contacts {
            let (x, y) = contact.places;
            let change = |place: usize| self.parties.get(place).map(|party| party.change);
            let relative = match (change(x), y.and_then(change)) {
                (Some(a), Some(b)) => a - b,
                (Some(a), None) => a,
                _ => continue,
            };
            let wrong = contact.wanted - dot(&contact.normal, &relative);
            let impulse = (contact.impulse + wrong * contact.mass).max(S::zero());
            let more = impulse - contact.impulse;
            contact.impulse = impulse;
            worst = worst.max((more / contact.mass).abs());
            for (place, sign) in [(Some(x), more), (y, -more)] {
                if let Some(party) = place.and_then(|place| self.parties.get_mut(place)) {
                    party.change += contact.normal * (sign / party.body.mass);
                }
            }
        }
        worst
    }
}

/// Grains that a crowd concerned.
pub(crate) type Grains = heapless::Vec<usize, MAX_BODIES>;

/// ε at this impact, if it is one without duration.
fn instantaneous<S: Scalar>(rule: &impl Rule<S>, impact: &Impact<S>) -> Option<S> {
    match rule.collide(impact).response {
        Response::Instantaneous(restitution) => Some(restitution),
        _ => None,
    }
}

/// By how much the speed along the normal changes.
fn change_of<S: Scalar>(restitution: S, speed: S, least: S) -> S {
    speed + (restitution * speed).max(least)
}

/// Two part at least so fast, and do not near each other if they do so more slowly.
fn least<S: Scalar, const D: usize>(a: &Body<S, D>, b: &Body<S, D>) -> S {
    min_parting_speed(&a.velocity) + min_parting_speed(&b.velocity)
}

/// Who is not further off than this touches: positions are rounded.
pub(crate) fn slack<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    let far = body.position.iter().fold(body.radius, |far, x| far.max(x.abs()));
    far.rounding() * S::from_f32(64.0)
}
