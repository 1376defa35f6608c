//! Which forces act on clustered grains? Reads positions and velocities in the middle of a step; writes the sums of their accelerations.
//!
//! Pairs come in the order of their numbers, however neighbours are found: the sums have the same bits.

use super::contact::{Mean, Touching};
use super::members::Clusters;
use super::order::put_last_in_order;
use super::settings::Settings;
use super::sleep::rounded_speed;
use super::transfer::{Receiver, Transfer};
use crate::error::Error;
use crate::law::{Impact, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, norm};
use crate::space::{Domain, Obstacles, Particles, Plane};

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
pub(super) struct Forces<'a, 'm, S: Scalar, const D: usize, R, O> {
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
    /// A contact under friction for which there was no place.
    pub full: Option<Error>,
    /// Who is told what grains give each other.
    pub receiver: &'a mut O,
}

impl<S: Scalar, const D: usize, R: Rule<S>, O: Receiver<S, D>> Forces<'_, '_, S, D, R, O> {
    /// Adds up all forces on all clustered grains.
    pub fn add(&mut self, clusters: &Clusters<S>) {
        let mut next = clusters.first();
        while let Some(i) = next {
            self.add_pairs(i);
            self.add_planes(i);
            self.add_obstacles(i);
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
            let apart = self.domain.separation(me, other, self.middle);
            let reach = me.radius + other.radius + self.reach((me, i), (other, k));
            if S::dot(&apart, &apart) < reach.times(reach) {
                insert(&mut some, k);
            }
        });
        some
    }

    fn add_pair(&mut self, i: usize, k: usize) {
        let (Some(a), Some(b)) = (self.particles.body(i), self.particles.body(k)) else { return };
        let [apart, velocity] = self.domain.relative(a, b, self.middle);
        let distance = norm(&apart);
        let e = if distance > S::zero() { apart / distance } else { along_first_axis() };
        let touching = between([a, b], distance, &e, &velocity);
        let moves = S::dot(&a.velocity, &a.velocity);
        let slow = self.settings.sleep_speed(b.radius).max(rounded_speed(a, self.step));
        let limit = slow * S::from_f32(2.0);
        let (mass, other_mass, sleeps) = (a.mass, b.mass, b.is_asleep());
        let who = (i, Partner::grain(k));
        let mean = self.mean_force(&touching, who);
        let force = mean.force;
        if !sleeps {
            self.push(k, -e * (force / other_mass));
        } else if moves > limit.times(limit) {
            let _ = self.woken.push(k);
        }
        self.push(i, e * (force / mass));
        self.tell((&touching, &mean), who, (&e, distance), touching.rate);
        self.rub((&touching, &mean), who, &e);
    }

    /// Who observes is told what two give each other along the normal; kinetic energy goes as they near each other, or as the
    /// grain nears a plane whose own motion is not its.
    #[inline(always)]
    fn tell(
        &mut self,
        (touching, mean): (&Touching<S>, &Mean<S>),
        (grain, partner): (usize, Partner),
        (normal, distance): (&Vector<S, D>, S),
        nearing: S,
    ) {
        let begins = mean.share < S::one() && touching.rate > S::zero();
        let position = self.position(grain);
        self.receiver.receive(&Transfer {
            grain,
            partner,
            impulse: normal * (mean.force * self.step),
            position,
            separation: normal * distance,
            work: mean.force * nearing * self.step,
            approach: begins.then_some(touching.rate),
        });
    }

    /// Where a grain is in the middle of the step.
    #[inline(always)]
    pub(super) fn position(&self, grain: usize) -> Vector<S, D> {
        self.particles.body(grain).map_or(Vector::zeros(), |body| body.position)
    }

    /// The mean force of two over the step; what it says of the next step's length is kept, and whether they
    /// are crushed.
    fn mean_force(&mut self, touching: &Touching<S>, (i, with): (usize, Partner)) -> Mean<S> {
        let mean = match self.remembered(touching, (i, with)) {
            Some(mean) => mean,
            None => touching.mean_force(self.rule, self.settings, self.step),
        };
        self.deepest = self.deepest.max(touching.overlap);
        self.frequency = self.frequency.max(mean.frequency);
        let more = |crush: &Crush<S>| self.crush.is_none_or(|most| crush.part > most.part);
        self.crush = Crush::of(touching, i, with).filter(more).or(self.crush);
        mean
    }

    pub(super) fn push(&mut self, grain: usize, change: Vector<S, D>) {
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
            let who = (i, Partner::plane(p));
            if overlap > S::zero() || self.holds_at(body, plane, (who, overlap)) {
                let touching = with_plane(body, plane, overlap, self.middle);
                let nearing = -dot(&plane.normal, &body.velocity);
                self.add_plane(&touching, who, (plane.normal, body.mass, nearing));
            }
        }
    }

    /// The forces of all obstacles on grain `i`.
    #[inline(always)]
    fn add_obstacles(&mut self, i: usize) {
        if let Some(obstacles) = self.domain.boundary.obstacles() {
            self.add_facets(i, obstacles);
        }
    }

    #[inline(never)]
    fn add_facets(&mut self, i: usize, obstacles: &Obstacles<'_, S, D>) {
        let Some(body) = self.particles.body(i).copied() else { return };
        // What holds beyond the touch is seen as far as the lists see.
        let reach = if self.rule.remembers() { S::NEVER } else { body.radius };
        obstacles.for_each_touched((&body.position, self.middle), reach, |k, plane, distance| {
            self.follow((i, &body.position), (k, reach), obstacles);
            let (who, overlap) = ((i, Partner::facet(k)), body.radius - distance);
            if overlap > S::zero() || self.holds_at(&body, plane, (who, overlap)) {
                let touching = with_plane(&body, plane, overlap, self.middle);
                let nearing = -dot(&plane.normal, &body.velocity);
                self.add_plane(&touching, who, (plane.normal, body.mass, nearing));
            }
        });
    }

    /// The force of a plane, or of the facet whose plane it is, on a grain that overlaps it.
    #[inline(always)]
    fn add_plane(
        &mut self,
        touching: &Touching<S>,
        who: (usize, Partner),
        (normal, mass, nearing): (Vector<S, D>, S, S),
    ) {
        let mean = self.mean_force(touching, who);
        let distance = touching.impact.contact_distance - touching.overlap;
        self.push(who.0, normal * (mean.force / mass));
        self.tell((touching, &mean), who, (&normal, distance), nearing);
        self.rub((touching, &mean), who, &normal);
    }
}

/// Two grains that touch, in what their force depends on.
#[inline(always)]
pub(super) fn with_grain<S: Scalar, const D: usize>(a: &Body<S, D>, b: &Body<S, D>) -> Impact<S> {
    Impact {
        contact_distance: a.radius + b.radius,
        effective_radius: a.radius / (a.radius + b.radius) * b.radius,
        reduced_mass: a.mass / (a.mass + b.mass) * b.mass,
        normal_speed: S::zero(),
        tangential_speed: S::zero(),
        acceleration: S::zero(),
        materials: [a.material, b.material],
    }
}

/// Two bodies whose centres are at this distance, `e` from the second to the first.
pub(super) fn between<S: Scalar, const D: usize>(
    [a, b]: [&Body<S, D>; 2],
    distance: S,
    e: &Vector<S, D>,
    velocity: &Vector<S, D>,
) -> Touching<S> {
    let collisions = |body: &Body<S, D>| match body.is_asleep() {
        true => 0,
        false => body.consecutive_collisions,
    };
    Touching {
        impact: with_grain(a, b),
        radius: a.radius.min(b.radius),
        overlap: a.radius + b.radius - distance,
        rate: -dot(e, velocity),
        hard: None,
        only_forces: collisions(a).max(collisions(b)) >= MAX_COLLISIONS,
    }
}

/// A body that overlaps a plane: the other one is infinitely heavy and flat.
pub(super) fn with_plane<S: Scalar, const D: usize>(
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
