//! What can be seen of a world? Reads its state; writes nothing.

use super::statistics::Statistics;
use crate::particle::{Body, Grain, Partner};
use crate::scalar::{Clock, Instant, Scalar, Vector, WideProduct, dot};
use crate::space::{Boundary, Domain, Facet, Particles, flight};

/// A world to look at.
#[derive(Clone, Copy)]
pub struct View<'a, S: Scalar, const D: usize> {
    pub(super) particles: &'a Particles<'a, S, D>,
    pub(super) domain: &'a Domain<'a, S, D>,
    pub(super) clock: &'a Clock<S>,
    pub(super) statistics: &'a Statistics,
}

/// One grain as another sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relative<S: Scalar, const D: usize> {
    /// r_a − r_b, nearest image.
    pub separation: Vector<S, D>,
    /// v_a − v_b.
    pub velocity: Vector<S, D>,
    /// m_a m_b/(m_a + m_b).
    pub reduced_mass: S,
}

/// How a grain moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Motion {
    /// Freely: from event to event.
    Flight,
    /// In a contact of two, or of one with a plane, which ends at a time that is known.
    Contact,
    /// Under the forces of all that it touches, step by step.
    Cluster,
    /// Not, or as what carries it does.
    Rest,
}

impl<S: Scalar, const D: usize> core::fmt::Debug for View<'_, S, D> {
    /// The present, gravity and every grain as it is now.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("View")
            .field("now", &self.now())
            .field("gravity", &self.gravity())
            .field("grains", &Grains(*self))
            .finish()
    }
}

/// All grains of a view, as they are now.
struct Grains<'a, S: Scalar, const D: usize>(View<'a, S, D>);

impl<S: Scalar, const D: usize> core::fmt::Debug for Grains<'_, S, D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self(view) = self;
        f.debug_list().entries((0..view.len()).filter_map(|i| view.grain(i))).finish()
    }
}

impl<S: Scalar, const D: usize> View<'_, S, D> {
    /// How many grains there are, empty places ([`WorldBuilder::reserve`](super::WorldBuilder::reserve)) included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.particles.bodies.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The present.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.clock.instant()
    }

    /// A grain as it is now. While it is in contact its velocity is that of the contact (MP13 §VI.B.2); in
    /// a cluster it goes on from the last step with the acceleration that it had there.
    #[must_use]
    pub fn grain(&self, index: usize) -> Option<Grain<S, D>> {
        let body = self.particles.body(index).filter(|body| !body.is_vacant())?;
        let mut now = flight::at(body, self.domain, self.clock.now);
        if body.is_clustered() {
            let span = self.clock.now - body.clock;
            let beyond = (body.velocity_change - self.domain.gravity()) * span;
            now.velocity += beyond;
            now.position += self.domain.boundary.on_lattice(beyond * (span * S::half()));
        }
        let Body { velocity, radius, mass, material, .. } = now;
        Some(Grain {
            position: self.domain.boundary.wrap(now.position),
            velocity,
            radius,
            mass,
            material,
        })
    }

    /// How a grain moves now.
    #[must_use]
    pub fn motion(&self, index: usize) -> Option<Motion> {
        let body = self.particles.body(index).filter(|body| !body.is_vacant())?;
        Some(match body {
            _ if body.is_supported() => Motion::Rest,
            _ if body.is_clustered() => Motion::Cluster,
            _ if body.in_contact() => Motion::Contact,
            _ => Motion::Flight,
        })
    }

    /// With what a grain is in contact, and when that ends.
    #[must_use]
    pub fn contact(&self, index: usize) -> Option<(Partner, Instant)> {
        let body = self.particles.body(index).filter(|b| b.in_contact())?;
        Some((body.partner, self.clock.instant_of(body.contact_end)))
    }

    /// Whether a grain is at rest: asleep among what supports it, or on a plane, on which it may slide.
    #[must_use]
    pub fn is_at_rest(&self, index: usize) -> bool {
        self.particles.body(index).is_some_and(Body::is_supported)
    }

    /// A grain as it will be if its contact ends undisturbed now: the velocity that E^v will give it.
    ///
    /// Energies taken from it do not miss what a contact under way holds back.
    #[must_use]
    pub fn released(&self, index: usize) -> Option<Grain<S, D>> {
        let mut grain = self.grain(index)?;
        let body = self.particles.body(index)?;
        if !body.in_contact() {
            return Some(grain);
        }
        let plane = body.partner.as_plane().and_then(|p| self.domain.boundary.planes().get(p));
        if let Some(plane) = plane {
            let along = dot(&plane.normal, &grain.velocity);
            grain.velocity -= plane.normal * along;
        }
        grain.velocity += body.velocity_change;
        Some(grain)
    }

    /// The velocity of a grain now: that of [`View::grain`], for less work.
    #[must_use]
    #[inline]
    pub fn velocity(&self, index: usize) -> Option<Vector<S, D>> {
        let body = self.particles.body(index)?;
        if body.is_supported() || body.is_clustered() {
            return self.grain(index).map(|grain| grain.velocity);
        }
        Some(flight::free(body, self.domain, self.clock.now).1)
    }

    /// Grain `a` as grain `b` sees it: what [`View::grain`] says of both, for less work.
    #[must_use]
    #[inline]
    pub fn relative(&self, a: usize, b: usize) -> Option<Relative<S, D>> {
        let (one, other) = (self.particles.body(a)?, self.particles.body(b)?);
        let motion = |body: &Body<S, D>, index| {
            if body.is_supported() || body.is_clustered() {
                return self.grain(index).map(|grain| (grain.position, grain.velocity));
            }
            Some(flight::free(body, self.domain, self.clock.now))
        };
        let ((r, v), (s, w)) = (motion(one, a)?, motion(other, b)?);
        let boundary = &self.domain.boundary;
        let apart = boundary.wrap(r) - boundary.wrap(s);
        let [separation, velocity] = boundary.relative([apart, v - w], self.clock.now);
        Some(Relative {
            separation,
            velocity,
            reduced_mass: one.mass / (one.mass + other.mass) * other.mass,
        })
    }

    /// The separation r_a − r_b of two grains, nearest image.
    #[must_use]
    pub fn separation(&self, a: usize, b: usize) -> Option<Vector<S, D>> {
        let (a, b) = (self.grain(a)?, self.grain(b)?);
        let relative = [a.position - b.position, a.velocity - b.velocity];
        let [separation, _] = self.domain.boundary.relative(relative, self.clock.now);
        Some(separation)
    }

    /// The velocity of a grain against the steady flow of a sheared box: v − γ̇ (y − y₀), y₀ in its middle. Without shear
    /// that is its velocity. Of contacts under way it is that after them, as in [`View::released`].
    #[must_use]
    pub fn peculiar_velocity(&self, index: usize) -> Option<Vector<S, D>> {
        let grain = self.released(index)?;
        Some(grain.velocity - self.domain.boundary.flow_at(&grain.position))
    }

    /// How far the image above a sheared box has moved along the flow by now, less whole lengths of the box: between −1/2
    /// and 1/2 of one. Zero without shear.
    #[must_use]
    pub fn image_offset(&self) -> S {
        let images = self.domain.boundary.images();
        images.map_or(S::zero(), |images| images.offset(self.clock.now))
    }

    /// Kinetic energy Σ m v²/2, contacts under way counted as if they ended now.
    #[must_use]
    pub fn kinetic_energy(&self) -> S {
        (0..self.len()).filter_map(|i| self.released(i)).fold(S::zero(), |sum, g| {
            sum + S::half() * g.mass * S::dot(&g.velocity, &g.velocity).rounded()
        })
    }

    /// Momentum Σ m v.
    #[must_use]
    pub fn momentum(&self) -> Vector<S, D> {
        (0..self.len())
            .filter_map(|i| self.released(i))
            .fold(Vector::zeros(), |sum, g| sum + g.velocity * g.mass)
    }

    /// The boundaries.
    #[must_use]
    pub fn boundary(&self) -> &Boundary<'_, S, D> {
        &self.domain.boundary
    }

    /// A facet of an obstacle as it is now, where it moves ([`RigidMotion`](crate::space::RigidMotion)) or stands.
    #[must_use]
    pub fn facet(&self, number: usize) -> Option<Facet<S, D>> {
        self.domain.boundary.facet_at(number, self.clock.now)
    }

    /// The gravity that acts now.
    #[must_use]
    pub fn gravity(&self) -> Vector<S, D> {
        *self.domain.gravity()
    }

    /// How often everything happened.
    #[must_use]
    pub fn statistics(&self) -> &Statistics {
        self.statistics
    }
}
