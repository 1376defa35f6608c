//! Which facets are near a position? Reads lists of facets in cells, those that stand and those that move; writes nothing.
//!
//! A facet is listed in all cells from which a grain can see it. Where grains are, and how many, does not matter. Facets that
//! move as one have cells of their own, that move with them.

use super::facet::Facet;
use super::facet_lists::{self, KNOB};
use super::grid::Grid;
use super::obstacle_buffers::ObstacleBuffers;
use super::plane::{Plane, Surface};
use super::pose::Pose;
use super::rigid_motion::RigidMotion;
use crate::error::Error;
use crate::particle::Index;
use crate::scalar::{Instant, Scalar, Vector, component};

/// All facets, and their lists.
#[derive(Debug)]
pub(crate) struct Obstacles<'m, S: Scalar, const D: usize> {
    pub facets: &'m [Facet<S, D>],
    /// The cells of those that stand.
    pub grid: Grid<S, D>,
    /// Where the list of each cell begins, and where the last one ends; then the lists themselves.
    lists: &'m [Index],
    motions: &'m mut [RigidMotion<S, D>],
    /// Whether a surface moves along itself.
    runs: bool,
}

/// How facets that stand, or that move as one, see a position at a time.
struct FromFacet<'a, S: Scalar, const D: usize> {
    position: &'a Vector<S, D>,
    now: S,
    /// The position in their frame.
    inside: Vector<S, D>,
    /// How they move, and where they are.
    moving: Option<(&'a RigidMotion<S, D>, Pose<S, D>)>,
}

impl<'a, S: Scalar, const D: usize> FromFacet<'a, S, D> {
    #[inline(always)]
    fn new(motion: Option<&'a RigidMotion<S, D>>, position: &'a Vector<S, D>, now: S) -> Self {
        let moving = motion.map(|motion| (motion, motion.at(now)));
        let inside = moving.as_ref().map_or(*position, |(_, pose)| pose.inside(position));
        Self { position, now, inside, moving }
    }

    /// How they move. Without the feature `plates` a compiler sees that none does.
    #[inline(always)]
    fn moving(&self) -> Option<&(&'a RigidMotion<S, D>, Pose<S, D>)> {
        if cfg!(feature = "plates") { self.moving.as_ref() } else { None }
    }

    /// A plane in their frame, so far from the position, as it is and moves.
    #[inline(always)]
    fn as_it_moves(&self, plane: Plane<S, D>, distance: S) -> Plane<S, D> {
        let Some((_, pose)) = self.moving() else { return plane };
        let normal = pose.direction(&plane.normal);
        let velocity = pose.velocity_at(&(self.position - normal * distance));
        plane.carried((normal, &velocity), (self.position, distance), self.now)
    }
}

impl<'m, S: Scalar, const D: usize> Obstacles<'m, S, D> {
    /// These facets, each in the lists of all cells that are nearer to it than `sight`; none without facets. The cells
    /// are as fine as the memory's places allow, but not much finer than facets or grains are.
    ///
    /// # Errors
    /// [`Error::Full`] if there are not two places more than facets, and two for each motion.
    pub fn new(buffers: ObstacleBuffers<'m, S, D>, sight: S) -> Result<Option<Self>, Error> {
        let (facets, lists, motions) = buffers.parts();
        if facets.is_empty() {
            return Ok(None);
        }
        let motions = if cfg!(feature = "plates") { motions } else { &mut [] };
        let sight = sight * S::from_f32(1.0 + 1.0 / 64.0);
        let grid = facet_lists::build(facets, (sight, &mut *lists), motions)
            .ok_or(Error::Full { knob: KNOB, capacity: lists.len() })?;
        let runs = facets.iter().any(Facet::runs);
        Ok(Some(Self { facets, grid, lists, motions, runs }))
    }

    /// The same, lent for a while.
    pub fn lent(&mut self) -> Obstacles<'_, S, D> {
        let Self { facets, grid, lists, runs, .. } = *self;
        Obstacles { facets, grid, lists, motions: self.motions, runs }
    }

    /// A facet, as it was described.
    #[inline]
    pub fn facet(&self, number: usize) -> Option<&'m Facet<S, D>> {
        self.facets.get(number)
    }

    /// What moves.
    #[inline(always)]
    pub fn motions(&self) -> &[RigidMotion<S, D>] {
        if cfg!(feature = "plates") { self.motions } else { &[] }
    }

    /// How a facet moves; none if it stands.
    #[inline(always)]
    pub fn motion_of(&self, facet: &Facet<S, D>) -> Option<&RigidMotion<S, D>> {
        self.motions().get(facet.motion()?)
    }

    /// Whether nothing moves, not even a surface along itself.
    pub fn is_still(&self) -> bool {
        !self.runs && self.motions().is_empty()
    }

    /// From now on clocks count from this epoch.
    pub fn set_epoch(&mut self, epoch: Instant) {
        self.motions.iter_mut().for_each(|motion| motion.set_epoch(epoch));
    }

    /// Those of the facets that stand that can be seen from a cell, in the order of their numbers.
    #[inline]
    pub fn list(&self, cell: u32) -> impl Iterator<Item = usize> + use<'m, S, D> {
        facet_lists::list(self.lists, 0, cell)
    }

    /// Those that move so and can be seen from a position in their own frame.
    #[inline]
    pub fn list_inside(
        &self,
        motion: &RigidMotion<S, D>,
        inside: &Vector<S, D>,
    ) -> impl Iterator<Item = usize> + use<'m, S, D> {
        let lists = self.lists;
        let listed = motion.lists;
        let cell = listed.map(|listed| (listed.first as usize, listed.grid.locate(inside)));
        cell.into_iter().flat_map(move |(first, cell)| facet_lists::list(lists, first, cell))
    }

    /// The facets that can be seen from a position at a time.
    pub fn near(&self, position: &Vector<S, D>, now: S) -> impl Iterator<Item = usize> {
        let standing = self.list(self.grid.locate(position));
        let moving = self
            .motions()
            .iter()
            .flat_map(move |motion| self.list_inside(motion, &motion.at(now).inside(position)));
        standing.chain(moving)
    }

    /// The distance from a position to a facet at a time.
    pub fn distance(&self, k: usize, position: &Vector<S, D>, now: S) -> Option<S> {
        let facet = self.facet(k)?;
        Some(facet.nearest(&self.sight(facet, position, now).inside).distance)
    }

    /// The plane that a body at a position touches where facet `k` is the nearest to it. It moves as the facet does there.
    pub fn plane(&self, k: usize, position: &Vector<S, D>, now: S) -> Option<Plane<S, D>> {
        let facet = self.facet(k)?;
        let from = self.sight(facet, position, now);
        let nearest = facet.nearest(&from.inside);
        Some(from.as_it_moves(nearest.plane(facet, &from.inside), nearest.distance))
    }

    /// How a facet sees a position at a time.
    fn sight<'a>(
        &'a self,
        facet: &Facet<S, D>,
        position: &'a Vector<S, D>,
        now: S,
    ) -> FromFacet<'a, S, D> {
        FromFacet::new(self.motion_of(facet), position, now)
    }

    /// The velocity of the surface of facet `k` at a position on it; none where nothing moves.
    #[inline(always)]
    pub fn surface_velocity(&self, k: usize, at: &Vector<S, D>, now: S) -> Option<Vector<S, D>> {
        if self.is_still() {
            return None;
        }
        let facet = self.facet(k)?;
        Some(self.motion_of(facet).map_or(*facet.belt(), |motion| {
            let pose = motion.at(now);
            pose.velocity_at(at) + pose.vector(facet.belt())
        }))
    }

    /// Facet `k` as a body at this position touches it, if it does so nearer than that. What two facets share is there
    /// once: of an edge or a corner the nearer facet has it, of equals the first.
    pub fn touched(
        &self,
        position: &Vector<S, D>,
        (k, reach): (usize, S),
        now: S,
    ) -> Option<(Plane<S, D>, S)> {
        self.touched_from(&self.sight(self.facet(k)?, position, now), (k, reach))
    }

    // On small machines it is one function for all who ask.
    #[cfg_attr(feature = "alloc", inline)]
    #[cfg_attr(not(feature = "alloc"), inline(never))]
    fn touched_from(
        &self,
        from: &FromFacet<'_, S, D>,
        (k, reach): (usize, S),
    ) -> Option<(Plane<S, D>, S)> {
        let (facet, there) = (self.facet(k)?, &from.inside);
        let nearest = facet.nearest(there);
        let distance = nearest.distance;
        if !(distance < reach) {
            return None;
        }
        let has = |other: usize| {
            let is_nearer = |facet: &Facet<S, D>| {
                let its = facet.nearest(there).distance;
                its < distance || its == distance && other < k
            };
            self.facet(other).is_some_and(|f| facet.shares(nearest.part, f) && is_nearer(f))
        };
        let is_another = !nearest.is_on_face()
            && match from.moving() {
                None => self.list(self.grid.locate(there)).any(|i| i != k && has(i)),
                Some((motion, _)) => self.list_inside(motion, there).any(|i| i != k && has(i)),
            };
        (!is_another).then(|| (from.as_it_moves(nearest.plane(facet, there), distance), distance))
    }

    /// Visits the facets that a body at this position touches nearer than that: the plane that each is there, and its
    /// distance.
    pub fn for_each_touched(
        &self,
        (position, now): (&Vector<S, D>, S),
        reach: S,
        mut visit: impl FnMut(usize, &Plane<S, D>, S),
    ) {
        let standing = FromFacet::new(None, position, now);
        for k in self.list(self.grid.locate(position)) {
            if let Some((plane, distance)) = self.touched_from(&standing, (k, reach)) {
                visit(k, &plane, distance);
            }
        }
        for motion in self.motions() {
            let from = FromFacet::new(Some(motion), position, now);
            for k in self.list_inside(motion, &from.inside) {
                if let Some((plane, distance)) = self.touched_from(&from, (k, reach)) {
                    visit(k, &plane, distance);
                }
            }
        }
    }

    /// The largest coordinate of a corner, wherever it moves.
    pub fn far(&self) -> S {
        let [low, high] = self.extent();
        low.iter().chain(high.iter()).fold(S::zero(), |far, x| far.max(x.abs()))
    }

    /// From where to where they are along an axis, wherever they move.
    pub fn along(&self, axis: usize) -> [S; 2] {
        let [low, high] = self.extent();
        [component(&low, axis), component(&high, axis)]
    }

    fn extent(&self) -> [Vector<S, D>; 2] {
        let boxes = self.facets.iter().flat_map(|facet| {
            facet.corners().iter().map(|corner| {
                self.motion_of(facet).map_or([*corner; 2], |motion| motion.swept(corner))
            })
        });
        facet_lists::hull(boxes)
    }

    /// The largest speed and acceleration of a corner.
    pub fn peaks(&self) -> [S; 2] {
        let moving = self.facets.iter().filter_map(|facet| Some((facet, self.motion_of(facet)?)));
        moving.fold([S::zero(); 2], |[speed, most], (facet, motion)| {
            let [v, a] = motion.peaks(facet.reach_from(motion.centre()));
            [speed.max(v), most.max(a)]
        })
    }

    /// What the facets do.
    pub fn surfaces(&self) -> impl Iterator<Item = &'m Surface<S>> + Clone + use<'m, S, D> {
        self.facets.iter().map(Facet::surface)
    }

    /// One number for all of them, to tell whether others stand in their place: FNV-1a over their bits.
    pub fn fingerprint(&self) -> u64 {
        let mut sum: u64 = 0xcbf2_9ce4_8422_2325;
        let mut add = |bits: u64| sum = (sum ^ bits).wrapping_mul(0x0100_0000_01b3);
        for facet in self.facets {
            let vectors = facet.corners().iter().chain([facet.belt()]);
            vectors.flat_map(|vector| vector.iter()).for_each(|x| add(x.bits()));
            facet.motion().into_iter().for_each(|motion| add(motion as u64));
        }
        let motions = self.motions().iter().flat_map(RigidMotion::numbers);
        motions.for_each(|x| add(x.bits()));
        sum
    }
}
