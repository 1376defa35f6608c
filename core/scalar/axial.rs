//! How does a rotation move a point, and a force turn a body? Reads axial and polar vectors; writes nothing.
//!
//! An axial vector (angular velocity, torque) has three components, of which the plane has one: the last.

use super::traits::{Scalar, Vector};
use super::vector::{component, reject};

/// A vector about which something turns. In two dimensions only its last component is not zero.
pub type Axial<S> = Vector<S, 3>;

/// How many components an angular velocity has: D (D − 1)/2.
pub const fn axes<const D: usize>() -> usize {
    D * D.saturating_sub(1) / 2
}

/// ω × r: the velocity of a point at r.
pub fn swept<S: Scalar, const D: usize>(w: &Axial<S>, r: &Vector<S, D>) -> Vector<S, D> {
    let [x, y, z] = [0, 1, 2].map(|axis| component(r, axis));
    let [a, b, c] = [0, 1, 2].map(|axis| component(w, axis));
    let turned = match D {
        3 => [b * z - c * y, c * x - a * z, a * y - b * x],
        _ => [-(c * y), c * x, S::zero()],
    };
    Vector::from_fn(|axis, _| turned.get(axis).copied().unwrap_or(S::zero()))
}

/// r × f: how a force f at r turns.
pub fn moment<S: Scalar, const D: usize>(r: &Vector<S, D>, f: &Vector<S, D>) -> Axial<S> {
    let [x, y, z] = [0, 1, 2].map(|axis| component(r, axis));
    let [a, b, c] = [0, 1, 2].map(|axis| component(f, axis));
    match D {
        3 => Axial::new(y * c - z * b, z * a - x * c, x * b - y * a),
        _ => Axial::new(S::zero(), S::zero(), x * b - y * a),
    }
}

/// How fast two surfaces slide along each other, of two that move so and whose contact lies along a unit normal from the
/// second's centre to the first's: across the normal, with a₁ω₁ + a₂ω₂ of their rotations and their centres' distances
/// a from the contact.
pub fn sliding<S: Scalar, const D: usize>(
    velocity: &Vector<S, D>,
    turning: &Axial<S>,
    normal: &Vector<S, D>,
) -> Vector<S, D> {
    reject(velocity, normal) - swept(turning, normal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_about_the_last_axis_is_the_same_in_the_plane() {
        let w = Axial::new(0.0, 0.0, 2.0);
        let plane = swept(&w, &Vector::<f64, 2>::new(3.0, 5.0));
        let space = swept(&w, &Vector::<f64, 3>::new(3.0, 5.0, 0.0));
        assert_eq!((plane.x, plane.y), (-10.0, 6.0));
        assert_eq!((space.x, space.y, space.z), (-10.0, 6.0, 0.0));
        assert_eq!(swept(&w, &Vector::<f64, 1>::new(3.0)).x, 0.0);
    }

    #[test]
    fn the_power_of_a_force_is_that_of_its_moment() {
        // f · (ω × r) = ω · (r × f)
        let [w, r, f] =
            [[0.3, -1.1, 0.7], [2.0, 0.5, -0.25], [0.1, 0.9, 1.7]].map(Axial::<f64>::from);
        assert!((f.dot(&swept(&w, &r)) - w.dot(&moment(&r, &f))).abs() < 1e-15);
    }

    #[test]
    fn a_plane_has_one_axis_of_rotation_and_space_three() {
        assert_eq!([axes::<1>(), axes::<2>(), axes::<3>()], [0, 1, 3]);
    }
}
