//! What are obstacles made of? Segments in the plane, triangles in space; reads corners, writes nothing.

use super::plane::Surface;
use super::pose::Pose;
use super::unit_normal::unit_normal;
use crate::scalar::{Scalar, Vector, component, dot, norm, vector};

/// A piece of an obstacle: a segment in two dimensions, a triangle in three; in one, a point. Grains touch it from both
/// sides, at its face, its edges and its corners.
///
/// Neighbouring facets share corners, to the last bit: then nothing leaks between them, and what they share is there
/// once. An edge has no thickness of its own: the grains' radii are all.
///
/// # Units
/// Corners are lengths, in the units of the grains' positions.
///
/// ```
/// use carom::space::{Facet, Surface};
/// let ramp = Facet::<f64, 2>::new([[0.0, 0.0], [0.04, 0.03]], Surface::Hard(0.5));
/// let normal = ramp.normal();
/// assert!((normal[0] + 0.6).abs() < 1e-14 && (normal[1] - 0.8).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet<S: Scalar, const D: usize> {
    corners: [Vector<S, D>; D],
    normal: Vector<S, D>,
    surface: Surface<S>,
    belt: Vector<S, D>,
    /// Which of the motions is its own, counted from 1; 0 if it stands.
    motion: u16,
}

impl<S: Scalar, const D: usize> Facet<S, D> {
    /// A place in memory that no facet has: all bits zero. A world refuses it.
    pub const VACANT: Self = Self {
        corners: [vector([S::ZERO; D]); D],
        normal: vector([S::ZERO; D]),
        surface: Surface::Rule,
        belt: vector([S::ZERO; D]),
        motion: 0,
    };

    /// The segment or triangle with these corners.
    #[must_use]
    pub fn new(corners: [[S; D]; D], surface: Surface<S>) -> Self {
        let corners = corners.map(Vector::from);
        let normal = unit_normal(&corners);
        Self { corners, normal, surface, belt: Vector::zeros(), motion: 0 }
    }

    /// The same facet, its surface moving along itself with this velocity: a belt, or the wall of a round drum that turns.
    /// The facet itself stays where it is. Only rough grains feel it ([`Rough`](crate::law::Rough)).
    ///
    /// # Units
    /// Length over time. Across the facet it must be zero: a world refuses it otherwise.
    ///
    /// ```
    /// use carom::space::{Facet, Surface};
    /// let belt = Facet::new([[0.0, 0.0], [1.0, 0.0]], Surface::Rule).running([0.3, 0.0]);
    /// assert_eq!(belt.belt()[0], 0.3);
    /// ```
    #[must_use]
    pub fn running(self, velocity: [S; D]) -> Self {
        Self { belt: Vector::from(velocity), ..self }
    }

    /// The same facet, moving as this one of the [`RigidMotion`](super::RigidMotion)s says that the world borrows, counted from 0.
    #[cfg(feature = "plates")]
    #[must_use]
    pub fn moving(self, motion: u8) -> Self {
        Self { motion: u16::from(motion) + 1, ..self }
    }

    /// Which motion is its own; none if it stands.
    #[inline]
    #[must_use]
    pub fn motion(&self) -> Option<usize> {
        usize::from(self.motion).checked_sub(1)
    }

    /// How far its furthest corner is from a point; without one 0.
    pub(super) fn reach_from(&self, centre: Option<&Vector<S, D>>) -> S {
        let far = |centre| {
            self.corners.iter().fold(S::zero(), |far, corner| far.max(norm(&(corner - centre))))
        };
        centre.map_or(S::zero(), far)
    }

    /// The same facet as it is in a pose.
    pub(super) fn posed(self, pose: &Pose<S, D>) -> Self {
        Self {
            corners: self.corners.map(|corner| pose.outside(&corner)),
            normal: pose.direction(&self.normal),
            belt: pose.vector(&self.belt),
            ..self
        }
    }

    /// The velocity with which its surface moves along itself.
    #[must_use]
    pub fn belt(&self) -> &Vector<S, D> {
        &self.belt
    }

    /// Whether its surface moves along itself.
    pub(super) fn runs(&self) -> bool {
        self.belt.iter().any(|&x| x != S::zero())
    }

    /// The corners.
    #[must_use]
    pub fn corners(&self) -> &[Vector<S, D>; D] {
        &self.corners
    }

    /// The unit normal: to the left of a segment from its first corner to its second; of a triangle towards whom its
    /// corners run anticlockwise. Zero where the facet has no length or no area.
    #[must_use]
    pub fn normal(&self) -> &Vector<S, D> {
        &self.normal
    }

    /// What it does.
    #[must_use]
    pub fn surface(&self) -> &Surface<S> {
        &self.surface
    }

    /// A corner; there are as many as axes.
    #[cfg_attr(feature = "alloc", inline(always))]
    pub(super) fn corner(&self, number: usize) -> Vector<S, D> {
        self.corners.get(number).copied().unwrap_or(Vector::zeros())
    }

    /// The smallest and the largest coordinates of the corners.
    pub(crate) fn extent(&self) -> [Vector<S, D>; 2] {
        let first = self.corner(0);
        self.corners.iter().fold([first; 2], |[low, high], corner| {
            [low.zip_map(corner, S::min), high.zip_map(corner, S::max)]
        })
    }

    /// Whether it lies outside a box, beyond one of its sides.
    #[cfg_attr(feature = "alloc", inline)]
    pub(crate) fn is_outside(&self, [low, high]: &[Vector<S, D>; 2]) -> bool {
        (0..D).any(|axis| {
            let [low, high] = [component(low, axis), component(high, axis)];
            let is_beyond = |corner: &Vector<S, D>| component(corner, axis) > high;
            let is_below = |corner: &Vector<S, D>| component(corner, axis) < low;
            self.corners.iter().all(is_beyond) || self.corners.iter().all(is_below)
        })
    }

    /// Whether all corners are numbers, and span a segment or a triangle; a needle, or one that rounding has made flat,
    /// has no normal.
    pub(crate) fn is_valid(&self) -> bool {
        let length = dot(&self.normal, &self.normal);
        let rounding = S::RESOLUTION * S::from_f32(16.0);
        self.is_finite() && (length - S::one()).abs() <= rounding
    }

    /// Whether all corners are numbers.
    pub(crate) fn is_finite(&self) -> bool {
        self.corners.iter().all(|corner| corner.iter().all(|x| x.in_range()))
    }
}

/// A closed polygon: a facet from each corner to the next, and from the last to the first.
///
/// ```
/// use carom::space::{Surface, polygon};
/// let square = polygon([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Surface::Hard(0.9));
/// assert!(square.iter().all(|side| side.normal().sum() == 1.0 || side.normal().sum() == -1.0));
/// ```
#[must_use]
pub fn polygon<S: Scalar, const N: usize>(
    corners: [[S; 2]; N],
    surface: Surface<S>,
) -> [Facet<S, 2>; N] {
    core::array::from_fn(|k| {
        let at = |k: usize| corners.get(k).copied().unwrap_or_default();
        Facet::new([at(k), at(if k + 1 == N { 0 } else { k + 1 })], surface)
    })
}

/// An open chain: a facet from each point to the next.
///
/// ```
/// use carom::space::{Surface, chain};
/// let funnel = [[-1.0, 1.0], [-0.2, 0.0], [-0.2, -0.1]];
/// assert_eq!(chain(&funnel, Surface::Hard(0.9)).count(), 2);
/// ```
pub fn chain<S: Scalar>(
    points: &[[S; 2]],
    surface: Surface<S>,
) -> impl Iterator<Item = Facet<S, 2>> + '_ {
    let next = points.iter().skip(1);
    points.iter().zip(next).map(move |(&from, &to)| Facet::new([from, to], surface))
}

/// The triangles of a mesh: each names its three vertices by their numbers, counted from zero. A triangle that names one
/// that is not there has no area, and a world refuses it.
///
/// ```
/// use carom::space::{Surface, mesh};
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
/// let tetrahedron = mesh(&vertices, &faces, Surface::Hard(0.9));
/// assert_eq!(tetrahedron.count(), 4);
/// ```
pub fn mesh<'a, S: Scalar>(
    vertices: &'a [[S; 3]],
    triangles: &'a [[usize; 3]],
    surface: Surface<S>,
) -> impl Iterator<Item = Facet<S, 3>> + 'a {
    triangles.iter().map(move |triangle| {
        let corners = triangle.map(|k| vertices.get(k).copied());
        match corners {
            [Some(a), Some(b), Some(c)] => Facet::new([a, b, c], surface),
            _ => Facet::VACANT,
        }
    })
}
