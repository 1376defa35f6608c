//! Is a place clear of obstacles? Reads their facets as they are at the start; writes a tree of them.

use super::crossings::crossing;
use super::motion::Motion;
use super::nearest::{Point, apart, dot};
use super::standing::{Inside, Standing};
use super::walls::Wall;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// A facet where it is at time 0.
#[derive(Clone, Debug)]
struct Piece {
    /// Two corners in the plane, three in space.
    corners: Vec<Point>,
    /// Of which obstacle it is.
    obstacle: usize,
}

/// The facets of all obstacles, found by place.
#[derive(Debug, Default)]
pub struct Obstacles {
    pieces: Vec<Piece>,
    /// The box around each of them, with its number.
    tree: RTree<GeomWithData<Rectangle<Point>, usize>>,
    insides: Vec<Option<Inside>>,
}

impl Obstacles {
    /// These, as they are at time 0.
    pub fn new(walls: &[Wall], motions: &[Motion], standing: &[Standing]) -> Self {
        let piece = |wall: &Wall| {
            let motion = wall.motion.and_then(|number| motions.get(usize::from(number)));
            let at_start = |corner: &Point| motion.map_or(*corner, |m| m.carried(*corner, 0.0));
            let corners = wall.corners.iter().map(at_start).collect();
            Piece { corners, obstacle: wall.obstacle }
        };
        let pieces: Vec<Piece> = walls.iter().map(piece).collect();
        let around = |(number, piece): (usize, &Piece)| {
            GeomWithData::new(AABB::from_points(&piece.corners).into(), number)
        };
        let tree = RTree::bulk_load(pieces.iter().enumerate().map(around).collect());
        Self { pieces, tree, insides: standing.iter().map(|one| one.inside).collect() }
    }

    /// Whether there are none.
    pub fn are_none(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Whether a grain of this radius would overlap no facet there, and be inside of nothing solid.
    pub fn are_clear_of(&self, place: &Point, radius: f64) -> bool {
        let far = |number: usize| {
            let way = apart(self.corners(number), place);
            dot(&way, &way) >= radius * radius
        };
        let [low, high] = [-radius, radius].map(|by| place.map(|x| x + by));
        self.are_none() || self.within(low, high).all(far) && self.around(place).is_none()
    }

    /// The corners of all facets.
    pub fn facets(&self) -> impl Iterator<Item = &[Point]> {
        self.pieces.iter().map(|piece| &piece.corners[..])
    }

    fn corners(&self, number: usize) -> &[Point] {
        self.pieces.get(number).map_or(&[], |piece| &piece.corners)
    }

    /// The numbers of facets that may reach into a box.
    pub fn within(&self, low: Point, high: Point) -> impl Iterator<Item = usize> {
        let found = self.tree.locate_in_envelope_intersecting(&AABB::from_corners(low, high));
        found.map(|one| one.data)
    }

    /// The solid obstacle inside of which a place is that is on no facet.
    pub fn around(&self, place: &Point) -> Option<usize> {
        if self.insides.iter().all(Option::is_none) {
            return None;
        }
        let mut end = *place;
        end[0] = self.tree.root().envelope().upper()[0].max(end[0]);
        // How often a ray along x crosses each of them: from inside to outside less the other way, and in all.
        let mut crossings = vec![(0, 0); self.insides.len()];
        for piece in self.within(*place, end).filter_map(|number| self.pieces.get(number)) {
            let sign = crossing(&piece.corners, place);
            if let Some((wound, all)) = crossings.get_mut(piece.obstacle) {
                (*wound, *all) = (*wound + sign, *all + sign.abs());
            }
        }
        self.insides.iter().zip(crossings).position(|(inside, (wound, all))| match inside {
            Some(Inside::Wound) => wound != 0,
            Some(Inside::Odd) => all % 2 == 1,
            None => false,
        })
    }
}
