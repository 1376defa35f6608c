//! What stands or moves inside the boundaries? Hands on what obstacles say; writes nothing.

use super::boundary::Boundary;
use super::facet::Facet;
use super::if_obstacles::IfObstacles;
use super::obstacles::Obstacles;
use super::plane::{Plane, Surface};
use crate::particle::Partner;
use crate::scalar::{Scalar, Vector};

impl<'m, S: Scalar, const D: usize> Boundary<'m, S, D> {
    /// Puts obstacles inside.
    pub(crate) fn set_obstacles(&mut self, obstacles: Option<Obstacles<'m, S, D>>) {
        self.obstacles = IfObstacles::new(obstacles);
    }

    /// What stands inside.
    #[inline(always)]
    pub(crate) fn obstacles(&self) -> Option<&Obstacles<'m, S, D>> {
        self.obstacles.get()
    }

    /// What tells the obstacles from others; 0 without any.
    pub(crate) fn fingerprint(&self) -> u64 {
        self.obstacles().map_or(0, Obstacles::fingerprint)
    }

    /// The facets of all obstacles, in the order in which they were lent.
    #[must_use]
    pub fn facets(&self) -> &[Facet<S, D>] {
        self.obstacles().map_or(&[], |obstacles| obstacles.facets)
    }

    /// A facet as it is at a time since the epoch.
    pub(crate) fn facet_at(&self, facet: usize, now: S) -> Option<Facet<S, D>> {
        let (all, facet) = (self.obstacles()?, self.facets().get(facet)?);
        Some(all.motion_of(facet).map_or(*facet, |motion| facet.posed(&motion.at(now))))
    }

    /// The plane that a body at a position touches where a facet is the nearest to it, at a time.
    pub(crate) fn facet_plane(
        &self,
        facet: usize,
        position: &Vector<S, D>,
        now: S,
    ) -> Option<Plane<S, D>> {
        self.obstacles()?.plane(facet, position, now)
    }

    /// How the surface moves that a grain touches at a position; none if it stands.
    #[inline(always)]
    pub(crate) fn surface_velocity(
        &self,
        with: Partner,
        at: &Vector<S, D>,
        now: S,
    ) -> Option<Vector<S, D>> {
        self.obstacles()?.surface_velocity(with.as_facet()?, at, now)
    }

    /// What planes and facets do.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = Surface<S>> + Clone + '_ {
        let facets = self.obstacles().into_iter().flat_map(Obstacles::surfaces);
        self.planes().iter().map(|plane| plane.surface).chain(facets.copied())
    }
}
