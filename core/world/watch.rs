//! What can be seen of a world, and when? Reads the scene; writes nothing.

use crate::event::scene::Scene;
use crate::event::{Counters, Deed, Kind};
use crate::matter::{Body, Boundary, Grain, Partner, flight};
use crate::number::{Instant, Product, Scalar, Vector, dot};

/// One event as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Happening<S> {
    /// When.
    pub at: Instant,
    /// To which grain.
    pub grain: usize,
    /// With what.
    pub partner: Partner,
    /// What was due.
    pub kind: Kind,
    /// What it did; none before it is done.
    pub deed: Option<Deed<S>>,
}

/// Sees each event just before and just after it happens. Watching changes nothing.
pub trait Watch<S: Scalar, const D: usize> {
    /// The event is due; the grains stand where it will happen.
    fn before(&mut self, happening: &Happening<S>, view: View<'_, S, D>) {
        let _ = (happening, view);
    }
    /// The event has happened.
    fn after(&mut self, happening: &Happening<S>, view: View<'_, S, D>) {
        let _ = (happening, view);
    }
}

/// Nobody watches.
impl<S: Scalar, const D: usize> Watch<S, D> for () {}

/// A world to look at.
#[derive(Clone, Copy)]
pub struct View<'a, S: Scalar, const D: usize> {
    pub(crate) scene: &'a Scene<'a, S, D>,
}

impl<S: Scalar, const D: usize> View<'_, S, D> {
    /// How many grains there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.scene.bodies.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The present.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.scene.instant()
    }

    /// A grain as it is now. While it is in contact its velocity is that of the contact (MP13 §VI.B.2).
    #[must_use]
    pub fn grain(&self, index: usize) -> Option<Grain<S, D>> {
        let body = self.scene.body(index)?;
        let now = flight::at(body, self.scene.field(), self.scene.now);
        let Body { velocity, radius, mass, material, .. } = now;
        Some(Grain {
            position: self.scene.boundary.wrap(now.position),
            velocity,
            radius,
            mass,
            material,
        })
    }

    /// With what a grain is in contact, and when that ends.
    #[must_use]
    pub fn contact(&self, index: usize) -> Option<(Partner, Instant)> {
        let body = self.scene.body(index).filter(|b| b.in_contact())?;
        Some((body.partner, self.scene.epoch + Instant::from(body.release_at)))
    }

    /// Whether a grain is at rest: frozen among what holds it, or on a plane, on which it may slide.
    #[must_use]
    pub fn is_at_rest(&self, index: usize) -> bool {
        self.scene.body(index).is_some_and(Body::is_held)
    }

    /// A grain as it will be if its contact ends undisturbed now: the velocity that E^v will give it.
    ///
    /// Energies taken from it do not miss what a contact under way holds back.
    #[must_use]
    pub fn released(&self, index: usize) -> Option<Grain<S, D>> {
        let mut grain = self.grain(index)?;
        let body = self.scene.body(index)?;
        let plane = body.partner.as_plane().and_then(|p| self.scene.boundary.planes().get(p));
        if let Some(plane) = plane {
            let along = dot(&plane.normal, &grain.velocity);
            grain.velocity -= plane.normal * along;
        }
        grain.velocity += body.release;
        Some(grain)
    }

    /// The separation r_a − r_b of two grains, nearest image.
    #[must_use]
    pub fn separation(&self, a: usize, b: usize) -> Option<Vector<S, D>> {
        let (a, b) = (self.grain(a)?, self.grain(b)?);
        Some(self.scene.boundary.nearest(a.position - b.position))
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
        &self.scene.boundary
    }

    /// The gravity that acts now.
    #[must_use]
    pub fn gravity(&self) -> Vector<S, D> {
        self.scene.gravity
    }

    /// How often everything happened.
    #[must_use]
    pub fn counters(&self) -> &Counters {
        &self.scene.counters
    }
}
