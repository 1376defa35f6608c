//! How far is a place from a facet? Reads corners; writes nothing, returns the nearest point of a segment or a triangle.

/// Three components.
pub type Point = [f64; 3];

/// a − b.
pub fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a · b.
pub fn dot(a: &Point, b: &Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The way from the nearest point of a segment (two corners) or a triangle (three) to a place.
pub fn apart(corners: &[Point], place: &Point) -> Point {
    match corners {
        [a, b, c] => from_triangle([a, b, c], place),
        [a, b] => from_segment([a, b], place),
        [a] => minus(place, a),
        _ => [f64::INFINITY; 3],
    }
}

fn from_segment([a, b]: [&Point; 2], place: &Point) -> Point {
    let (along, from) = (minus(b, a), minus(place, a));
    let part = (dot(&from, &along) / dot(&along, &along)).clamp(0.0, 1.0);
    match part >= 1.0 {
        true => minus(place, b),
        false => std::array::from_fn(|k| from[k] - part * along[k]),
    }
}

/// Where its foot on the plane is inside, the way is along the normal; else it is from the nearest edge.
fn from_triangle([a, b, c]: [&Point; 3], place: &Point) -> Point {
    let normal = cross(&minus(b, a), &minus(c, a));
    let is_inside = |from: &Point, to: &Point| {
        dot(&cross(&normal, &minus(to, from)), &minus(place, from)) >= 0.0
    };
    if is_inside(a, b) && is_inside(b, c) && is_inside(c, a) {
        let height = dot(&normal, &minus(place, a)) / dot(&normal, &normal);
        return normal.map(|n| height * n);
    }
    let edges = [[a, b], [b, c], [c, a]].map(|edge| from_segment(edge, place));
    let square = |way: &Point| dot(way, way);
    edges.into_iter().min_by(|a, b| square(a).total_cmp(&square(b))).unwrap_or([f64::INFINITY; 3])
}

fn cross(a: &Point, b: &Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least distance to many points of a triangle is that to the triangle, nearly.
    #[test]
    fn the_way_from_a_triangle_is_the_shortest() {
        let triangle: [Point; 3] = [[0.1, -0.2, 0.3], [1.1, 0.2, -0.1], [0.3, 0.9, 0.5]];
        for number in 0..200 {
            let random =
                |k: usize| (f64::from(number * 3 + k as i32) * 0.618_034).fract() * 4.0 - 2.0;
            let place = [random(0), random(1) * 0.7, random(2) * 0.9];
            let way = apart(&triangle, &place);
            let found = dot(&way, &way).sqrt();
            let mut least = f64::INFINITY;
            for i in 0..=100 {
                for j in 0..=100 - i {
                    let (u, v) = (f64::from(i) / 100.0, f64::from(j) / 100.0);
                    let [a, b, c] = triangle;
                    let point: Point =
                        std::array::from_fn(|k| a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]));
                    let way = minus(&place, &point);
                    least = least.min(dot(&way, &way).sqrt());
                }
            }
            assert!(found <= least + 1e-12 && found > least - 0.01, "{place:?}: {found}, {least}");
        }
    }
}
