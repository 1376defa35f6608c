//! With what force do surfaces that touch hold each other? Reads how they slide; writes forces, what turns grains, and the springs of contacts.
//!
//! A spring across the normal is stretched by the sliding of the surfaces, its force held to μ times the normal force
//! (Cundall & Strack, Géotechnique 29, 47, 1979). Sliding and spring are taken in the middle of the step, as all forces
//! are. A force F = −φ × n on the first of two turns both by a φ, a their centres' distance from the contact; so
//! angular momentum is kept.

use super::contact::{Mean, Touching, scaled_damping};
use super::forces::Forces;
use super::settings::Settings;
use super::transfer::{Receiver, Transfer};
use crate::law::{Rule, Tangential};
use crate::particle::Partner;
use crate::scalar::{Axial, Scalar, Vector, WideProduct, dot, moment, norm, sliding, swept};
use crate::space::{ContactState, Contacts, Particles};

/// What holds two surfaces: a spring, a dashpot, and the most that both can do.
struct Grip<S> {
    stiffness: S,
    damping: S,
    /// A law's own dashpot: where the force is held, the spring has what that leaves for it. Zero for a stand-in's.
    dashpot: S,
    /// μ F_n; none without a limit.
    most: Option<S>,
}

impl<S: Scalar> Grip<S> {
    /// Of a law with forces its own spring; else one as fast as the normal force's, with the same loss.
    fn new(law: &Tangential<S>, q: S, (touching, mean): (&Touching<S>, &Mean<S>), step: S) -> Self {
        let (mass, share) = (touching.impact.reduced_mass, q / (S::one() + q));
        let normal = mean.elastic / mean.depth;
        let own = normal * share;
        let dashpot = |beta: S| {
            let loss = scaled_damping(beta.max(S::zero()));
            (normal.times(mass).sqrt() * (share * loss))
                .min(mass * share / (step * S::from_f32(4.0)))
        };
        let most = |mu| Some(mu * (mean.force / mean.share));
        let (is_stand_in, none) = (mean.frequency > S::zero(), S::zero());
        match *law {
            Tangential::Constant { beta } => {
                Self { stiffness: own, damping: dashpot(beta), dashpot: none, most: None }
            }
            Tangential::Walton { mu, beta_0 } => {
                Self { stiffness: own, damping: dashpot(beta_0), dashpot: none, most: most(mu) }
            }
            Tangential::Spring { mu, .. } if is_stand_in => {
                let damping = dashpot(S::half());
                Self { stiffness: own, damping, dashpot: none, most: most(mu) }
            }
            Tangential::Spring { mu, stiffness, damping } => {
                Self { stiffness, damping, dashpot: damping, most: most(mu) }
            }
        }
    }

    /// n × F of the surfaces, at this displacement and sliding, both about the normal.
    fn torque(&self, displacement: &Axial<S>, sliding: &Axial<S>) -> (Axial<S>, bool) {
        let free = *displacement * self.stiffness + *sliding * self.damping;
        let size = norm(&free);
        match self.most {
            Some(most) if size > most => (free * (most / size), true),
            _ => (free, false),
        }
    }

    /// Where surfaces slide on, the spring turns towards where they slide. It has come `way` since the middle of the last
    /// step, where it was held to r_0 = |s_0|, and is held to r_1 now. Were s_0 + `way` simply cut, the angle by which it
    /// turns would be off by an order in `way`/r; so the part of `way` along s_0 counts by half, and by all of it where
    /// it is long.
    fn follow(&self, displacement: &Axial<S>, way: &Axial<S>) -> Axial<S> {
        let Some(most) = self.most else { return *displacement };
        let before = *displacement - *way;
        let (held, long) = (norm(&before), norm(way));
        if !(held > S::zero()) {
            return *displacement;
        }
        let mean = (held + most / self.stiffness) * S::half();
        let along = before / held;
        along * (mean - dot(way, &along) * (mean / (mean + mean + long))) + *way
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>, O: Receiver<S, D>> Forces<'_, '_, S, D, R, O> {
    /// Surfaces that touch hold each other, `normal` being from the partner to the grain. Smooth ones do not.
    #[inline(always)]
    pub(super) fn rub(
        &mut self,
        contact: (&Touching<S>, &Mean<S>),
        who: (usize, Partner),
        normal: &Vector<S, D>,
    ) {
        if let Some(q) = self.rule.inertia() {
            self.hold(q, contact, who, normal);
        }
    }

    fn hold(
        &mut self,
        q: S,
        (touching, mean): (&Touching<S>, &Mean<S>),
        (i, with): (usize, Partner),
        normal: &Vector<S, D>,
    ) {
        let Some(law) = self.rule.tangential(touching.impact.materials) else { return };
        if law == (Tangential::Constant { beta: -S::one() }) {
            return;
        }
        // Rounding may leave two that just touch without depth: nothing holds there.
        if !(mean.force > S::zero() && mean.depth > S::zero()) {
            return;
        }
        let grip = Grip::new(&law, q, (touching, mean), self.step);
        let reach = touching.impact.contact_distance;
        // Where the contact is, so that both arms add up to the distance.
        let part = (reach - touching.overlap) / reach;
        // What a surface that moves gives is not the grain's.
        let driven = self.surface_velocity((i, with), normal, part).unwrap_or(Vector::zeros());
        let slip = moment(normal, &self.sliding((i, with), normal, part));
        let half = self.step * mean.share * S::half();
        let state = match Contacts(&mut *self.particles.contacts.0).of(i, with) {
            Ok(state) => state,
            Err(full) => return self.full = self.full.or(Some(full)),
        };
        let stretched = turned(&state.displacement(), normal) + slip * half;
        let (mut torque, slides) = grip.torque(&stretched, &slip);
        // In two dimensions a spring has nowhere to turn; a dashpot's error hides that of its direction.
        if D == 3 && slides && grip.damping == S::zero() {
            let followed = grip.follow(&stretched, &(slip * (half + half)));
            let long = norm(&followed);
            if long > S::zero() {
                torque = followed * (norm(&torque) / long);
            }
        }
        let held = if slides { (torque - slip * grip.dashpot) / grip.stiffness } else { stretched };
        state.drag(&(held + slip * half));
        let torque = torque * mean.share;
        let force = -swept(&torque, normal);
        let position = self.position(i);
        self.receiver.receive(&Transfer {
            grain: i,
            partner: with,
            impulse: force * self.step,
            position,
            separation: *normal * (reach - touching.overlap),
            work: (dot(&torque, &slip) - dot(&force, &driven)) * self.step,
            approach: None,
        });
        self.turn((i, &force), &torque, (q, part));
        if let Some(k) = with.as_grain() {
            self.turn((k, &-force), &torque, (q, part));
        }
    }

    /// How the surface of a grain slides along its partner's.
    fn sliding(&self, (i, with): (usize, Partner), normal: &Vector<S, D>, part: S) -> Vector<S, D> {
        let side = |x: usize| {
            let body = self.particles.body(x)?;
            let turning = self.particles.rotation.velocity::<D>(x) * (body.radius * part);
            Some((body.velocity, turning))
        };
        let nothing = (Vector::zeros(), Axial::zeros());
        let (v, w) = side(i).unwrap_or(nothing);
        let (u, z) = with.as_grain().and_then(side).unwrap_or(nothing);
        let image = with.as_grain().and_then(|k| {
            let [me, other] = [self.particles.body(i)?, self.particles.body(k)?];
            self.domain.image_velocity(me, other)
        });
        let u = image.map_or(u, |image| u + image);
        let u = self.surface_velocity((i, with), normal, part).unwrap_or(u);
        sliding(&(v - u), &(w + z), normal)
    }

    /// How a surface moves that is no grain's, where a grain touches it.
    #[inline(always)]
    fn surface_velocity(
        &self,
        (i, with): (usize, Partner),
        normal: &Vector<S, D>,
        part: S,
    ) -> Option<Vector<S, D>> {
        let body = self.particles.body(i)?;
        let at = body.position - normal * (body.radius * part);
        self.domain.boundary.surface_velocity(with, &at, self.middle)
    }

    /// A force on the surface of a grain moves it and turns it. One that sleeps holds.
    fn turn(&mut self, (x, force): (usize, &Vector<S, D>), torque: &Axial<S>, (q, part): (S, S)) {
        let Some(body) = self.particles.body(x).filter(|body| body.is_clustered()) else { return };
        let (mass, radius) = (body.mass, body.radius);
        self.particles.rotation.accelerate::<D>(x, &(*torque * (part / (q * mass) / radius)));
        self.push(x, *force / mass);
    }
}

/// The force across the normal on the first of two that lie still: what the spring of their surfaces holds.
pub(super) fn held<S: Scalar, const D: usize>(
    law: &Tangential<S>,
    q: S,
    (touching, mean): (&Touching<S>, &Mean<S>),
    (state, normal): (&ContactState<S>, &Vector<S, D>),
) -> Vector<S, D> {
    if !(mean.force > S::zero() && mean.depth > S::zero()) {
        return Vector::zeros();
    }
    let grip = Grip::new(law, q, (touching, mean), S::one());
    let stretched = turned(&state.displacement(), normal);
    let (torque, _) = grip.torque(&stretched, &Axial::zeros());
    -swept(&(torque * mean.share), normal)
}

/// A displacement about the normal as it was, about the normal as it is: it keeps its size.
fn turned<S: Scalar, const D: usize>(before: &Axial<S>, normal: &Vector<S, D>) -> Axial<S> {
    if D < 3 {
        return *before;
    }
    let n = Axial::from_fn(|axis, _| crate::scalar::component(normal, axis));
    let now = *before - n * dot(&n, before);
    let (long, left) = (norm(before), norm(&now));
    if left > S::zero() { now * (long / left) } else { now }
}

/// The second half of a grain's rotation in a step. While its surface is fast it is not slow.
pub(super) fn turn<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    settings: &Settings<S>,
    i: usize,
    [to, step]: [S; 2],
) {
    let rotation = particles.rotation.go_to_end::<D>(i, step);
    if let Some(body) = particles.bodies.get_mut(i) {
        let speed = norm(&rotation) * body.radius;
        if speed > settings.sleep_speed(body.radius) {
            body.reference_time = to;
        }
    }
}
