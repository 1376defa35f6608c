//! How are D numbers added, scaled and multiplied? Reads arrays; writes nothing.

pub(super) type Vector<const D: usize> = [f64; D];

#[inline]
pub(super) fn dot<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[inline]
pub(super) fn minus<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a + s b
#[inline]
pub(super) fn plus<const D: usize>(a: &Vector<D>, s: f64, b: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| a[k] + s * b[k])
}

#[inline]
pub(super) fn length<const D: usize>(a: &Vector<D>) -> f64 {
    dot(a, a).sqrt()
}
