//! Where does a function vanish? Reads coefficients or a function; writes the root.

/// The roots of c + b t + a t² that lie in (0, ∞) in increasing order, without cancellation.
#[inline]
pub(crate) fn quadratic(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 || discriminant.is_nan() {
        return [None, None];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let ahead = |t: f64| (t.is_finite() && t > 0.0).then_some(t);
    match (ahead(c / q), ahead(q / a)) {
        (Some(s), Some(t)) => [Some(s.min(t)), Some(s.max(t))],
        (Some(t), None) | (None, Some(t)) => [Some(t), None],
        (None, None) => [None, None],
    }
}

/// A root of f between a and b, where f changes sign, to the last bits of a and b.
///
/// Regula falsi after Illinois, with a bisection wherever it is slow.
pub(crate) fn bracketed(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    for turn in 0..200 {
        let middle = 0.5 * (a + b);
        if fb == 0.0 || middle <= a.min(b) || middle >= a.max(b) {
            break;
        }
        let secant = b - fb * (b - a) / (fb - fa);
        let inside = secant > a.min(b) && secant < a.max(b);
        let c = if inside && turn % 3 != 2 { secant } else { middle };
        let fc = f(c);
        if (fc > 0.0) != (fb > 0.0) {
            (a, fa) = (b, fb);
        } else {
            fa *= 0.5;
        }
        (b, fb) = (c, fc);
    }
    b
}

/// Where the smooth f is largest between a and b (golden section).
pub(crate) fn largest(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..60 {
        let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
        if f(c) > f(d) {
            b = d;
        } else {
            a = c;
        }
    }
    0.5 * (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_roots_keep_all_digits() {
        // (t - 1e-9) (t - 1e9)
        let [near, far] = quadratic(1.0, -(1e9 + 1e-9), 1.0);
        assert!((near.expect("near") / 1e-9 - 1.0).abs() < 1e-15);
        assert!((far.expect("far") / 1e9 - 1.0).abs() < 1e-15);
        assert_eq!(quadratic(1.0, 0.0, 1.0), [None, None]);
        assert_eq!(quadratic(0.0, -2.0, 1.0), [Some(0.5), None]);
    }

    #[test]
    fn a_bracketed_root_is_found() {
        let root = bracketed(|x| x * x * x - 2.0, 0.0, 2.0);
        assert!((root - 2.0_f64.cbrt()).abs() < 1e-15);
        assert!((largest(|x| -(x - 0.3) * (x - 0.3), 0.0, 1.0) - 0.3).abs() < 1e-7);
    }
}
