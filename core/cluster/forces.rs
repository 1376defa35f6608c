//! Which forces act on clustered grains? Reads positions and velocities in the middle of a step; writes the sums of their accelerations.
//!
//! Pairs come in the order of their numbers, however neighbours are found: the sums have the same bits.

use super::contact::Touching;
use super::members::Clusters;
use super::order::put_last_in_order;
use super::settings::Settings;
use super::sleep::rounded_speed;
use crate::law::{Impact, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, norm};
use crate::space::{Domain, Particles, Plane};

/// After so many collisions in a step a grain goes on by forces alone.
pub(crate) const MAX_COLLISIONS: u16 = 8;

/// So many sleeping grains are woken in a step; others that should be follow in the next.
const MAX_WOKEN: usize = 16;

/// Neighbours of one grain, the smallest numbers first: so many at a time.
type Few<const N: usize = 16> = heapless::Vec<usize, N>;

/// Two bodies that overlap by more than an eighth of the smaller radius: more than a hundred grains' weight
/// presses them together, or nothing can give way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crush<S> {
    pub grain: usize,
    pub with: Partner,
    pub overlap: S,
    /// The overlap in units of the smaller radius.
    part: S,
}

impl<S: Scalar> Crush<S> {
    /// Those who touch, if they are crushed.
    fn of(touching: &Touching<S>, grain: usize, with: Partner) -> Option<Self> {
        let overlap = touching.overlap;
        let is_crushed = overlap * S::from_f32(8.0) > touching.radius;
        is_crushed.then(|| Self { grain, with, overlap, part: overlap / touching.radius })
    }
}

/// A step's forces, and what they show.
pub(super) struct Forces<'a, 'm, S: Scalar, const D: usize, R> {
    pub particles: &'a mut Particles<'m, S, D>,
    pub domain: &'a Domain<'a, S, D>,
    pub rule: &'a R,
    pub settings: &'a Settings<S>,
    /// When the middle and the end of the step are.
    pub middle: S,
    pub end: S,
    pub step: S,
    /// The deepest overlap of all.
    pub deepest: S,
    /// The largest ω of a stand-in.
    pub frequency: S,
    /// Who is crushed most.
    pub crush: Option<Crush<S>>,
    /// Sleeping grains that something moves.
    pub woken: heapless::Vec<usize, MAX_WOKEN>,
}

impl<S: Scalar, const D: usize, R: Rule<S>> Forces<'_, '_, S, D, R> {
    /// Adds up all forces on all clustered grains.
    pub fn add(&mut self, clusters: &Clusters<S>) {
        let mut next = clusters.first();
        while let Some(i) = next {
            self.add_pairs(i);
            self.add_planes(i);
            next = self.particles.body(i).and_then(|body| body.partner.next_clustered());
        }
    }

    /// The forces between grain `i` and all that it touches, of clustered ones those with higher numbers.
    fn add_pairs(&mut self, i: usize) {
        let mut after = None;
        loop {
            let some = self.touched(i, after);
            some.iter().for_each(|&k| self.add_pair(i, k));
            after = some.last().copied();
            if !some.is_full() {
                return;
            }
        }
    }

    /// The next few, by their numbers, of those that grain `i` touches.
    fn touched(&self, i: usize, after: Option<usize>) -> Few {
        let mut some = Few::new();
        let Some(me) = self.particles.body(i) else { return some };
        self.particles.cells.for_each_near(me.cell, me.radius, |k| {
            let Some(other) = self.particles.body(k) else { return };
            let counts = other.is_clustered() && k > i || other.is_asleep();
            if !counts || after.is_some_and(|after| k <= after) || k == i {
                return;
            }
            let (apart, reach) = (self.domain.separation(me, other), me.radius + other.radius);
            if S::dot(&apart, &apart) < reach.times(reach) {
                insert(&mut some, k);
            }
        });
        some
    }

    fn add_pair(&mut self, i: usize, k: usize) {
        let (Some(a), Some(b)) = (self.particles.body(i), self.particles.body(k)) else { return };
        let apart = self.domain.separation(a, b);
        let distance = norm(&apart);
        let e = if distance > S::zero() { apart / distance } else { along_first_axis() };
        let touching = Touching {
            impact: Impact {
                contact_distance: a.radius + b.radius,
                effective_radius: a.radius / (a.radius + b.radius) * b.radius,
                reduced_mass: a.mass / (a.mass + b.mass) * b.mass,
                normal_speed: S::zero(),
                tangential_speed: S::zero(),
                acceleration: S::zero(),
                materials: [a.material, b.material],
            },
            radius: a.radius.min(b.radius),
            overlap: a.radius + b.radius - distance,
            rate: -dot(&e, &(a.velocity - b.velocity)),
            hard: None,
            only_forces: a.consecutive_collisions.max(if b.is_asleep() {
                0
            } else {
                b.consecutive_collisions
            }) >= MAX_COLLISIONS,
        };
        let moves = S::dot(&a.velocity, &a.velocity);
        let slow = self.settings.sleep_speed(b.radius).max(rounded_speed(a, self.step));
        let limit = slow * S::from_f32(2.0);
        let (mass, other_mass, sleeps) = (a.mass, b.mass, b.is_asleep());
        let force = self.mean_force(&touching, (i, Partner::grain(k)));
        if !sleeps {
            self.push(k, -e * (force / other_mass));
        } else if moves > limit.times(limit) {
            let _ = self.woken.push(k);
        }
        self.push(i, e * (force / mass));
    }

    /// The mean force of two over the step; what it says of the next step's length is kept, and whether they
    /// are crushed.
    fn mean_force(&mut self, touching: &Touching<S>, (i, with): (usize, Partner)) -> S {
        let mean = touching.mean_force(self.rule, self.settings, self.step);
        self.deepest = self.deepest.max(touching.overlap);
        self.frequency = self.frequency.max(mean.frequency);
        let more = |crush: &Crush<S>| self.crush.is_none_or(|most| crush.part > most.part);
        self.crush = Crush::of(touching, i, with).filter(more).or(self.crush);
        mean.force
    }

    fn push(&mut self, grain: usize, change: Vector<S, D>) {
        let end = self.end;
        if let Some(body) = self.particles.bodies.get_mut(grain) {
            body.velocity_change += change;
            body.contact_end = end;
        }
    }

    /// The forces of all planes on grain `i`.
    fn add_planes(&mut self, i: usize) {
        for p in 0..self.domain.boundary.planes().len() {
            let (Some(plane), Some(body)) =
                (self.domain.boundary.planes().get(p), self.particles.body(i))
            else {
                return;
            };
            let overlap = -plane.gap(&body.position, body.radius, self.middle);
            if !(overlap > S::zero()) {
                continue;
            }
            let touching = with_plane(body, plane, overlap, self.middle);
            let (normal, mass) = (plane.normal, body.mass);
            let force = self.mean_force(&touching, (i, Partner::plane(p)));
            self.push(i, normal * (force / mass));
        }
    }
}

/// A body that overlaps a plane: the other one is infinitely heavy and flat.
fn with_plane<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    overlap: S,
    now: S,
) -> Touching<S> {
    Touching {
        impact: Impact {
            contact_distance: body.radius,
            effective_radius: body.radius,
            reduced_mass: body.mass,
            normal_speed: S::zero(),
            tangential_speed: S::zero(),
            acceleration: S::zero(),
            materials: plane.surface.materials(body.material),
        },
        radius: body.radius,
        overlap,
        rate: plane.motion(now).speed - dot(&plane.normal, &body.velocity),
        hard: plane.surface.restitution(),
        only_forces: body.consecutive_collisions >= MAX_COLLISIONS,
    }
}

/// A direction for two whose centres coincide.
fn along_first_axis<S: Scalar, const D: usize>() -> Vector<S, D> {
    Vector::from_fn(|axis, _| if axis == 0 { S::one() } else { S::zero() })
}

/// Keeps a number among the smallest, in order.
fn insert<const N: usize>(some: &mut Few<N>, k: usize) {
    if some.is_full() {
        if some.last().is_none_or(|&last| last < k) {
            return;
        }
        some.pop();
    }
    if some.push(k).is_ok() {
        put_last_in_order(some);
    }
}
