//! Which way does a facet look? Reads its corners; writes its unit normal, as near to length one as numbers allow.

use crate::scalar::{Scalar, Vector, component, dot, moment, norm, unit};

/// The unit normal of what these corners span; zero if that has none.
pub(super) fn unit_normal<S: Scalar, const D: usize>(corners: &[Vector<S, D>; D]) -> Vector<S, D> {
    nearest_to_length_one(normal(corners))
}

/// The same, rounded.
fn normal<S: Scalar, const D: usize>(corners: &[Vector<S, D>; D]) -> Vector<S, D> {
    let to = |k: usize| match (corners.first(), corners.get(k)) {
        (Some(from), Some(to)) => unit(&(to - from)),
        _ => Vector::zeros(),
    };
    match D {
        1 => Vector::from_element(S::one()),
        2 => {
            let along = to(1);
            let [x, y] = [0, 1].map(|axis| component(&along, axis));
            Vector::from_fn(|axis, _| if axis == 0 { -y } else { x })
        }
        3 => {
            // Of unit vectors, so that little is lost of small triangles in fixed point.
            let [first, second] = [to(1), to(2)];
            let across = moment(&first, &second);
            let sine = norm(&across);
            match sine > S::RESOLUTION * S::from_f32(1024.0) {
                true => Vector::from_fn(|axis, _| component(&across, axis) / sine),
                false => Vector::zeros(),
            }
        }
        _ => Vector::zeros(),
    }
}

/// So many neighbours of a component are tried, up and down.
const NEIGHBOURS: u32 = 32;

/// Of the vectors within some units in the last place the one whose length is nearest to one.
///
/// A facet is met again and again, and each time an elastic grain gains 2 v_n² (n·n − 1) of its v²: with a normal that is
/// just rounded the energy of a billiard drifts by 2·10⁻¹⁷ a bounce.
fn nearest_to_length_one<S: Scalar, const D: usize>(n: Vector<S, D>) -> Vector<S, D> {
    let Some([large, small]) = adjustable(&n) else { return n };
    // Outwards or inwards: a mirrored facet has the mirrored normal.
    let step = if component(&n, large) < S::zero() { -S::RESOLUTION } else { S::RESOLUTION };
    let mut best = (excess(&n).abs(), n);
    for k in 0..=2 * NEIGHBOURS {
        let mut tried = n;
        shift(&mut tried, large, (S::from_count(k) - S::from_count(NEIGHBOURS)) * step);
        let by = -excess(&tried) * S::half() / component(&n, small);
        if by.abs() > S::from_count(NEIGHBOURS) * S::RESOLUTION {
            continue;
        }
        shift(&mut tried, small, by);
        let left = excess(&tried).abs();
        if left < best.0 {
            best = (left, tried);
        }
    }
    best.1
}

/// The largest component, and the smallest by which a length can be changed without turning the vector.
fn adjustable<S: Scalar, const D: usize>(n: &Vector<S, D>) -> Option<[usize; 2]> {
    let size = |&axis: &usize| component(n, axis).abs();
    let larger = |a: &usize, b: &usize| if size(b) > size(a) { *b } else { *a };
    let large = (0..D).reduce(|a, b| larger(&a, &b))?;
    let others = (0..D).filter(|axis| *axis != large && size(axis) > S::from_f32(0.0078125));
    let small = others.reduce(|a, b| if size(&b) < size(&a) { b } else { a })?;
    Some([large, small])
}

fn shift<S: Scalar, const D: usize>(n: &mut Vector<S, D>, axis: usize, by: S) {
    if let Some(x) = n.get_mut(axis) {
        *x += by;
    }
}

/// n·n − 1, to twelve digits more than a number has: of squares of x = h + l with twelve digits in h, h² and h l are
/// exact, and so is what the first sum leaves.
fn excess<S: Scalar, const D: usize>(n: &Vector<S, D>) -> S {
    let high = n.map(S::leading_digits);
    let low = n - high;
    let two = S::from_count(2);
    (dot(&high, &high) - S::one()) + two * dot(&high, &low) + dot(&low, &low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n·n − 1 in whole numbers: components are multiples of 2⁻⁵⁶ if none is below an eighth.
    fn exact(n: &[f64; 2]) -> f64 {
        let whole = n.map(|x| (x * 2f64.powi(56)) as i128);
        (whole[0] * whole[0] + whole[1] * whole[1] - (1_i128 << 112)) as f64 / 2f64.powi(112)
    }

    fn slanted() -> impl Iterator<Item = [Vector<f64, 2>; 2]> {
        let angles = (1..400).map(|k| 0.13 + 1.3 * f64::from(k) / 400.0);
        angles.map(|angle| [Vector::zeros(), Vector::from([libm::cos(angle), libm::sin(angle)])])
    }

    #[test]
    fn the_excess_is_known_to_more_digits_than_numbers_have() {
        for corners in slanted() {
            let n = normal(&corners);
            let (found, exact) = (excess(&n), exact(&n.into()));
            assert!((found - exact).abs() < 1e-19, "{found:e}, {exact:e}");
        }
    }

    #[test]
    fn normals_are_fifty_times_as_near_to_length_one_and_look_the_same_way() {
        let (mut rounded, mut nearest) = (0.0, 0.0);
        for corners in slanted() {
            let (before, after) = (normal(&corners), unit_normal(&corners));
            assert!((before - after).norm() < 1.1e-14, "{before}, {after}");
            rounded += exact(&before.into()).abs();
            nearest += exact(&after.into()).abs();
        }
        assert!(nearest < rounded / 50.0, "{nearest:e}, {rounded:e}");
    }

    #[test]
    fn a_mirrored_facet_has_the_mirrored_normal() {
        for [from, to] in slanted() {
            let [n, mirrored] =
                [to, Vector::from([-to.x, to.y])].map(|to| unit_normal(&[from, to]));
            assert_eq!([n.x, n.y], [mirrored.x, -mirrored.y]);
            assert_eq!(unit_normal(&[to, from]), -n);
        }
    }

    #[test]
    fn along_an_axis_nothing_changes() {
        let corners =
            [Vector::from([0.0, 0.0, 0.0]), [1.0, 0.0, 0.0].into(), [0.0, 1.0, 0.0].into()];
        assert_eq!(unit_normal::<f64, 3>(&corners), Vector::from([0.0, 0.0, 1.0]));
    }
}
