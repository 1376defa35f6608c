//! Does an obstacle stand outside the box? Reads its facets and the box; writes nothing, returns a problem.

use super::nearest::Point;
use super::problem::Problem;
use super::side::Side;
use super::standing::Standing;
use super::walls::Wall;

/// From where to where grains may be at some time, along each axis; infinitely far where nothing bounds it.
pub struct Room {
    ends: [[f64; 2]; 3],
    dimension: usize,
}

impl Room {
    /// That of a box whose walls go on as fast as `steady` says.
    pub fn new(dimension: usize, sides: &[Side; 3], steady: &[[f64; 2]; 3]) -> Self {
        let mut room = Self { ends: [[f64::NEG_INFINITY, f64::INFINITY]; 3], dimension };
        for ((ends, side), [lower, upper]) in room.ends.iter_mut().zip(sides).zip(steady) {
            let ([low, high], swing) = match side {
                Side::Plate(plate, _) => ([plate.at, f64::INFINITY], plate.amplitude.abs()),
                Side::Walls(range, _, shaking) => {
                    (*range, shaking.map_or(0.0, |s| s.amplitude.abs()))
                }
                Side::Open | Side::Periodic(_) => continue,
            };
            // A wall that goes outwards leaves room behind.
            *ends = [
                if *lower < 0.0 { f64::NEG_INFINITY } else { low - swing },
                if *upper > 0.0 { f64::INFINITY } else { high + swing },
            ];
        }
        room
    }

    /// Where it begins or ends, along the axes that there are.
    fn corner(&self, end: usize) -> Vec<f64> {
        self.ends[..self.dimension].iter().map(|ends| ends[end]).collect()
    }
}

/// An obstacle of which no part is inside the box; none if there is no such. Those that move may come in.
pub fn outside(room: &Room, walls: &[Wall], standing: &[Standing]) -> Option<Problem> {
    standing.iter().enumerate().find_map(|(number, one)| {
        let own = || walls.iter().filter(|wall| wall.obstacle == number);
        let is_out = |wall: &Wall| wall.motion.is_none() && inside(&wall.corners, room).is_empty();
        own().all(is_out).then(|| {
            let message = told(one, own().flat_map(|wall| &wall.corners), room);
            let message = format!("obstacle {number}: {message}");
            Problem { path: format!("obstacle.{number}"), offset: None, message }
        })
    })
}

/// The corners of that part of a facet which is inside (Sutherland and Hodgman, Commun. ACM 17, 32 (1974)).
fn inside(corners: &[Point], room: &Room) -> Vec<Point> {
    let mut left = corners.to_vec();
    let ends = (0..room.dimension).flat_map(|axis| [(axis, 0, 1.0), (axis, 1, -1.0)]);
    for (axis, end, sign) in ends.filter(|(axis, end, _)| room.ends[*axis][*end].is_finite()) {
        let depth = |point: &Point| sign * (point[axis] - room.ends[axis][end]);
        let mut next = Vec::new();
        for (k, to) in left.iter().enumerate() {
            let from = &left[(k + left.len() - 1) % left.len()];
            let (before, after) = (depth(from), depth(to));
            if (before < 0.0) != (after < 0.0) {
                let part = before / (before - after);
                next.push(std::array::from_fn(|k| from[k] + part * (to[k] - from[k])));
            }
            next.extend((after >= 0.0).then_some(*to));
        }
        left = next;
    }
    left
}

fn told<'c>(one: &Standing, corners: impl Iterator<Item = &'c Point>, room: &Room) -> String {
    let mut reach = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for corner in corners {
        for ([low, high], &x) in reach.iter_mut().zip(corner) {
            (*low, *high) = (low.min(x), high.max(x));
        }
    }
    let reach = Room { ends: reach, ..*room };
    let name = one.file.as_ref().map_or_else(|| "it".to_owned(), |file| format!("{file:?}"));
    let [[from, to], [low, high]] = [&reach, room].map(|range| [0, 1].map(|k| range.corner(k)));
    format!(
        "{name} is outside the box: it reaches from {from:?} to {to:?} m, the box from {low:?} to {high:?} m"
    )
}
