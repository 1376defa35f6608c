//! Does a ray meet a facet, and from which side? Reads corners; writes nothing, returns 1, −1, or 0 where it does not.
//!
//! The ray leads along the first axis, from a place that is on no facet. It is thought of as displaced by next to nothing, so that it
//! never meets a corner or an edge: what is on one counts as beside it, for all facets that share it alike. Signs of
//! determinants are exact (Shewchuk's predicates), so a closed mesh is closed for the ray, too.

use super::nearest::Point;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// How a ray along x from a place crosses a segment or a triangle: 1 from inside to outside where the corners of the facet
/// run as those of an anticlockwise polygon, or of a mesh whose normals lead outwards; −1 the other way.
pub fn crossing(corners: &[Point], place: &Point) -> i32 {
    match corners {
        [a, b] => along(flat(a, [0, 1]), flat(b, [0, 1]), flat(place, [0, 1])),
        [a, b, c] => through([a, b, c], place),
        _ => 0,
    }
}

/// Two of the components.
fn flat(point: &Point, [first, second]: [usize; 2]) -> Coord<f64> {
    Coord { x: point[first], y: point[second] }
}

/// The same in the plane of two components, for an edge: 1 where it leads up.
fn along(from: Coord<f64>, to: Coord<f64>, place: Coord<f64>) -> i32 {
    let leads_up = to.y > from.y;
    // From below in any case, so that both facets of an edge get the same answer.
    let (low, high) = if leads_up { (from, to) } else { (to, from) };
    let spans = low.y <= place.y && place.y < high.y;
    match spans && orient2d(low, high, place) > 0.0 {
        true if leads_up => 1,
        true => -1,
        false => 0,
    }
}

fn through(corners: [&Point; 3], place: &Point) -> i32 {
    let [a, b, c] = corners.map(|corner| flat(corner, [1, 2]));
    let here = flat(place, [1, 2]);
    let round = along(a, b, here) + along(b, c, here) + along(c, a, here);
    if round == 0 {
        return 0;
    }
    let [a, b, c] = corners.map(|&[x, y, z]| Coord3D { x, y, z });
    let [x, y, z] = *place;
    let side = orient3d(a, b, c, Coord3D { x, y, z });
    // `round` is how the corners run as they are seen against the ray.
    if side * f64::from(round) > 0.0 { round } else { 0 }
}
