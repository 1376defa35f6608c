//! How long is a vector, and which part of it lies along another? Reads vectors; writes nothing.

use super::traits::{Scalar, Vector, WideProduct};

/// A vector of these components, also in a constant.
pub const fn vector<S, const D: usize>(components: [S; D]) -> Vector<S, D> {
    Vector::from_array_storage(nalgebra::ArrayStorage([components]))
}

/// Whether every component can be computed with.
pub fn all_finite<S: Scalar, const D: usize>(v: &Vector<S, D>) -> bool {
    v.iter().all(|x| x.is_finite())
}

/// A component of a vector; zero for an axis that there is not.
#[inline(always)]
pub fn component<S: Scalar, const D: usize>(v: &Vector<S, D>, axis: usize) -> S {
    let [column] = &v.data.0;
    column.get(axis).copied().unwrap_or(S::zero())
}

/// The scalar product of two vectors, rounded once in fixed point.
///
/// # Units
/// The product of theirs.
#[must_use]
#[inline]
pub fn dot<S: Scalar, const D: usize>(a: &Vector<S, D>, b: &Vector<S, D>) -> S {
    S::dot(a, b).rounded()
}

/// The length of a vector. In fixed point, too, its square does not overflow.
///
/// # Units
/// Those of its components.
///
/// ```
/// use carom::{Grain, scalar::{dot, norm}};
/// let grain = Grain::with_mass(0.5_f32, 1.0).moving([2.0, 3.0, 6.0]);
/// assert_eq!(norm(&grain.velocity), 7.0);
/// assert_eq!(dot(&grain.velocity, &grain.velocity), 49.0);
/// ```
#[must_use]
#[inline]
pub fn norm<S: Scalar, const D: usize>(v: &Vector<S, D>) -> S {
    S::dot(v, v).sqrt()
}

/// The direction of a vector; zero if it has none.
pub fn unit<S: Scalar, const D: usize>(v: &Vector<S, D>) -> Vector<S, D> {
    let length = norm(v);
    if length > S::zero() && length.is_finite() { *v / length } else { Vector::zeros() }
}

/// The magnitude of the largest component.
pub fn max_abs<S: Scalar, const D: usize>(v: &Vector<S, D>) -> S {
    v.iter().fold(S::zero(), |most, x| most.max(x.abs()))
}

/// The part of a vector at right angles to a unit vector.
pub fn reject<S: Scalar, const D: usize>(v: &Vector<S, D>, n: &Vector<S, D>) -> Vector<S, D> {
    v - n * dot(n, v)
}
