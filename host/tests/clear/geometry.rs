//! How far is a place from a facet, and is it enclosed by facets? Reads corners; writes nothing, shares nothing with what it judges.

pub type Point = [f64; 3];

/// a − b.
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a · b.
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The distance from a facet by minimising |p − a − u e − v f|² over its parts, one after the other.
pub fn distance(corners: &[Point], p: Point) -> f64 {
    let segment = |a: Point, b: Point| {
        let part = (dot(minus(p, a), minus(b, a)) / dot(minus(b, a), minus(b, a))).clamp(0.0, 1.0);
        let to: Point = std::array::from_fn(|k| a[k] + part * (b[k] - a[k]) - p[k]);
        dot(to, to).sqrt()
    };
    let [a, b, rest @ ..] = corners else { return f64::INFINITY };
    let Some(&c) = rest.first() else { return segment(*a, *b) };
    let edges = segment(*a, *b).min(segment(*b, c)).min(segment(c, *a));
    // Barycentric coordinates of the foot, by Cramer's rule.
    let (e, f, r) = (minus(*b, *a), minus(c, *a), minus(p, *a));
    let det = dot(e, e) * dot(f, f) - dot(e, f).powi(2);
    let u = (dot(f, f) * dot(e, r) - dot(e, f) * dot(f, r)) / det;
    let v = (dot(e, e) * dot(f, r) - dot(e, f) * dot(e, r)) / det;
    if u < 0.0 || v < 0.0 || u + v > 1.0 {
        return edges;
    }
    let normal = cross(e, f);
    dot(normal, r).abs() / dot(normal, normal).sqrt()
}

/// How often facets wind round a place: angles in the plane, solid angles in space (van Oosterom and Strackee).
pub fn winding<'c>(facets: impl Iterator<Item = &'c [Point]>, p: Point) -> f64 {
    let angle = |facet: &[Point]| {
        let r: Vec<Point> = facet.iter().map(|corner| minus(*corner, p)).collect();
        let length = |k: usize| dot(r[k], r[k]).sqrt();
        match r[..] {
            [a, b] => cross(a, b)[2].atan2(dot(a, b)) / std::f64::consts::TAU,
            [a, b, c] => {
                let below = length(0) * length(1) * length(2)
                    + dot(a, b) * length(2)
                    + dot(b, c) * length(0)
                    + dot(c, a) * length(1);
                2.0 * dot(a, cross(b, c)).atan2(below) / (2.0 * std::f64::consts::TAU)
            }
            _ => 0.0,
        }
    };
    facets.map(angle).sum()
}
