//! Where is an obstacle nearest? The distance from a position to a facet, and on which part of it; reads both, writes nothing.
//!
//! The distance to a segment or a triangle has a continuous gradient: beside a face it is that to a plane, beside an edge
//! that to a line, beside a corner that to a point. It is a convex function of the position.

use super::facet::Facet;
use super::plane::Plane;
use crate::scalar::{Scalar, Vector, WideProduct, component, dot, moment, norm, unit};

/// What of a facet is nearest to a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Nearest<S: Scalar, const D: usize> {
    /// From there to the position.
    pub apart: Vector<S, D>,
    /// The distance, never negative.
    pub distance: S,
    /// The part of the facet on which it lies, a bit for each corner that spans it: all of them for its face.
    pub part: u8,
}

/// The part that is a facet's face.
const fn face<const D: usize>() -> u8 {
    (1 << D) - 1
}

impl<S: Scalar, const D: usize> Nearest<S, D> {
    /// Whether it lies inside the face, not on an edge or at a corner.
    pub fn is_on_face(&self) -> bool {
        self.part == face::<D>()
    }

    /// The unit vector from there to the position; of one on the facet itself, its normal.
    pub fn direction(&self, facet: &Facet<S, D>) -> Vector<S, D> {
        match self.is_on_face() || !(self.distance > S::zero()) {
            true if dot(&self.apart, facet.normal()) < S::zero() => -*facet.normal(),
            true => *facet.normal(),
            false => self.apart / self.distance,
        }
    }

    /// The plane there, across the way to the position: what a body at that position touches is this plane.
    pub fn plane(&self, facet: &Facet<S, D>, position: &Vector<S, D>) -> Plane<S, D> {
        let normal = self.direction(facet);
        let offset = dot(&normal, position) - self.distance;
        Plane { normal, offset, surface: *facet.surface(), vibration: None, drift: None }
    }

    /// f = |r| − R of a body of this radius, and ḟ at this velocity.
    pub fn overlap(&self, radius: S, velocity: &Vector<S, D>) -> (S, S) {
        if !(self.distance > S::zero()) {
            return (-radius, -norm(velocity));
        }
        let rate = S::dot(&self.apart, velocity).divided_by(self.distance);
        if self.is_on_face() {
            return (self.distance - radius, rate);
        }
        // The difference of squares keeps the last places of those that touch.
        let squares = S::dot(&self.apart, &self.apart) - radius.times(radius);
        (squares.divided_by(self.distance + radius), rate)
    }
}

impl<S: Scalar, const D: usize> Facet<S, D> {
    /// The distance to the plane through it: positive on the side of its normal.
    pub(crate) fn height(&self, position: &Vector<S, D>) -> S {
        dot(self.normal(), &(position - self.corner(0)))
    }

    /// Whether a position is beside its face: its foot on the plane through it lies inside.
    pub(crate) fn is_beside_face(&self, position: &Vector<S, D>) -> bool {
        match D {
            2 => self.beyond_end(position).is_none(),
            3 => (0..3).all(|edge| !self.is_beyond(position, edge)),
            _ => true,
        }
    }

    /// What of it is nearest to a position.
    pub(crate) fn nearest(&self, position: &Vector<S, D>) -> Nearest<S, D> {
        match D {
            2 => match self.beyond_end(position) {
                Some((end, _)) => self.beside_corner(position, end),
                None => self.beside_face(position),
            },
            3 => {
                let beyond = (0..3).filter(|&edge| self.is_beyond(position, edge));
                let edges = beyond.map(|edge| self.beside_edge(position, edge));
                let nearer = |a: Nearest<S, D>, b: Nearest<S, D>| {
                    if b.distance < a.distance { b } else { a }
                };
                edges.reduce(nearer).unwrap_or_else(|| self.beside_face(position))
            }
            _ => self.beside_face(position),
        }
    }

    /// The end of a segment beyond which a position is, and by how much.
    fn beyond_end(&self, position: &Vector<S, D>) -> Option<(usize, S)> {
        let [x, y] = [0, 1].map(|axis| component(self.normal(), axis));
        let along = Vector::<S, D>::from_fn(|axis, _| if axis == 0 { y } else { -x });
        let from = |end: usize| dot(&along, &(position - self.corner(end)));
        match (from(0), from(1)) {
            (way, _) if way < S::zero() => Some((0, -way)),
            (_, way) if way > S::zero() => Some((1, way)),
            _ => None,
        }
    }

    /// Whether a position is beyond an edge of a triangle.
    fn is_beyond(&self, position: &Vector<S, D>, edge: usize) -> bool {
        self.beyond_edge(position, edge) > S::zero()
    }

    /// How far a position is beyond an edge of a triangle, times the length of the edge.
    #[inline(always)]
    fn beyond_edge(&self, position: &Vector<S, D>, edge: usize) -> S {
        let [from, to] = self.edge(edge);
        let [from, to] = [self.corner(from), self.corner(to)];
        // In fixed point little would be left of a short edge: there the length is one.
        let along = if S::RANGE.is_some() { unit(&(to - from)) } else { to - from };
        let inwards = moment(self.normal(), &along);
        let inwards = Vector::<S, D>::from_fn(|axis, _| component(&inwards, axis));
        -dot(&inwards, &(position - from))
    }

    /// A way beyond an edge of a triangle, as a length.
    fn in_lengths(&self, way: S, edge: usize) -> S {
        let [from, to] = self.edge(edge).map(|k| self.corner(k));
        if S::RANGE.is_some() { way } else { way / norm(&(to - from)) }
    }

    /// How far the foot of a position on the plane through it is beside its face, at least; none if it lies inside.
    pub(crate) fn beside_by(&self, position: &Vector<S, D>) -> Option<S> {
        match D {
            2 => self.beyond_end(position).map(|(_, way)| way),
            3 => {
                let mut most = None;
                for edge in 0..3 {
                    let way = self.beyond_edge(position, edge);
                    if way > S::zero() {
                        let way = self.in_lengths(way, edge);
                        most = Some(most.map_or(way, |most: S| most.max(way)));
                    }
                }
                most
            }
            _ => None,
        }
    }

    /// The corners of an edge of a triangle, in the order of their numbers, but the last edge's.
    #[inline(always)]
    fn edge(&self, edge: usize) -> [usize; 2] {
        [edge, if edge + 1 == D { 0 } else { edge + 1 }]
    }

    fn beside_face(&self, position: &Vector<S, D>) -> Nearest<S, D> {
        let height = self.height(position);
        Nearest { apart: self.normal() * height, distance: height.abs(), part: face::<D>() }
    }

    fn beside_corner(&self, position: &Vector<S, D>, corner: usize) -> Nearest<S, D> {
        let apart = position - self.corner(corner);
        Nearest { apart, distance: norm(&apart), part: 1 << corner }
    }

    fn beside_edge(&self, position: &Vector<S, D>, edge: usize) -> Nearest<S, D> {
        let [from, to] = self.edge(edge);
        let [a, b] = [from, to].map(|k| self.corner(k));
        let along = unit(&(b - a));
        let way = dot(&along, &(position - a));
        if !(way > S::zero()) {
            return self.beside_corner(position, from);
        }
        if !(dot(&along, &(position - b)) < S::zero()) {
            return self.beside_corner(position, to);
        }
        let apart = position - a - along * way;
        Nearest { apart, distance: norm(&apart), part: 1 << from | 1 << to }
    }

    /// Whether another facet has all the corners of a part of this one, to the last bit.
    pub(crate) fn shares(&self, part: u8, other: &Self) -> bool {
        let spans = |k: &usize| part >> k & 1 == 1;
        (0..D).filter(spans).all(|k| other.corners().contains(&self.corner(k)))
    }
}
