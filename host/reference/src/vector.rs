//! How are D numbers added, scaled and multiplied? Reads arrays; writes nothing.

pub(crate) type Vector<const D: usize> = [f64; D];

#[inline]
pub(crate) fn dot<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[inline]
pub(crate) fn minus<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a + s b
#[inline]
pub(crate) fn plus<const D: usize>(a: &Vector<D>, s: f64, b: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| a[k] + s * b[k])
}

#[inline]
pub(crate) fn length<const D: usize>(a: &Vector<D>) -> f64 {
    dot(a, a).sqrt()
}
