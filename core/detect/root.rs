//! When does an overlap function first demand an event? Reads coefficients; writes nothing.
//!
//! BSFP14, Eq. (10): an event happens after the smallest Δt ≥ 0 with f ≤ 0 and ḟ < 0. There is no
//! tolerance, no "just collided" flag and no shifted radius: an overlap that gets better by itself
//! is left alone, one that gets worse is stopped at once.

use crate::scalar::{Scalar, Vector, WideProduct};

/// For two spheres without relative acceleration: separation `r`, relative velocity `v`, reach σ = R₁ + R₂.
///
/// f = |r + v t|² − σ² (BSFP14, Eq. 8). A glancing pass (a double root) demands nothing.
/// The discriminant is taken from the closest approach r − v (r·v)/v², which loses only |r|/σ units
/// in the last place where (r·v)² − v² (r² − σ²) loses (|r|/σ)²; the root is the one without cancellation.
pub fn spheres<S: Scalar, const D: usize>(
    r: &Vector<S, D>,
    v: &Vector<S, D>,
    sigma: S,
) -> Option<S> {
    if let Some(found) = S::collision_time(r, v, sigma) {
        return found;
    }
    let approach = -r.dot(v);
    let gap = r.dot(r) - sigma * sigma;
    let speed2 = v.dot(v);
    // Most pairs part or pass far from each other: the plain discriminant, with a margin above its
    // rounding error, says so without a division, and both together with one branch.
    let near = approach * approach >= speed2 * gap * S::from_f32(0.99);
    if !((approach > S::zero()) & near) {
        return None;
    }
    if gap <= S::zero() {
        return Some(S::zero());
    }
    let closest = r + v * (approach / speed2);
    let inside = sigma * sigma - closest.dot(&closest);
    if !(inside > S::zero()) {
        return None;
    }
    Some(gap / (approach + (speed2 * inside).sqrt()))
}

/// For a distance to a plane: f = gap + v t + a t²/2 (BSFP14, Eq. 11 and Algorithm 2).
///
/// With a < 0 (gravity towards the plane) the event is at the later root, or at the peak if the
/// whole parabola lies below the surface. A grain that overlaps and falls gets Δt = 0.
pub fn plane<S: Scalar>(gap: S, v: S, a: S) -> Option<S> {
    let found = if a < S::zero() { Some(falling(gap, v, -a)) } else { approaching(gap, v, a) };
    found.filter(|span| span.is_finite())
}

/// Whether gap + v t + a t²/2 stays above a margin up to a time: [`plane`] finds nothing before that.
#[inline(always)]
pub fn stays_above<S: Scalar>(margin: S, [gap, v, a]: [S; 3], within: S) -> bool {
    let zero = S::zero();
    // What was not computed with numbers, as a time without end, says nothing.
    gap + (v.min(zero) + a.min(zero) * S::half() * within) * within > margin
}

/// The last time at which gap + v t − b t²/2 ≥ 0 for b > 0, or the peak if there is none; never negative.
fn falling<S: Scalar>(gap: S, v: S, b: S) -> S {
    let peak = (v / b).max(S::zero());
    let root = (v.times(v) + (b + b).times(gap)).sqrt();
    if !(root > S::zero()) {
        return peak;
    }
    let t = if v > S::zero() {
        (v + root) / b
    } else if root > v {
        // The same root without cancellation; for gap < 0 it lies in the past.
        (gap + gap) / (root - v)
    } else {
        S::zero()
    };
    t.max(peak)
}

/// The first time at which gap + v t + a t²/2 ≤ 0 while falling, for a ≥ 0.
fn approaching<S: Scalar>(gap: S, v: S, a: S) -> Option<S> {
    if !(v < S::zero()) {
        return None;
    }
    if gap <= S::zero() {
        return Some(S::zero());
    }
    let root = (v.times(v) - (a + a).times(gap)).sqrt();
    (root > S::zero()).then(|| (gap + gap) / (root - v))
}

/// The first time at which |v t + a t²/2| reaches `far` > 0.
pub fn leaving<S: Scalar>(far: S, v: S, a: S) -> Option<S> {
    let away = plane(far, -v, -a);
    let back = plane(far, v, a);
    match (away, back) {
        (Some(x), Some(y)) => Some(x.min(y)),
        (x, y) => x.or(y),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn head_on_spheres_meet_when_the_gap_is_flown() {
        let t = spheres(&Vector::from([3.0, 0.0]), &Vector::from([-2.0, 0.0]), 1.0);
        assert_eq!(t, Some(1.0));
    }

    #[test]
    fn overlapping_spheres_meet_only_if_they_get_closer() {
        let r = Vector::from([0.5, 0.0]);
        assert_eq!(spheres(&r, &Vector::from([-1.0, 0.0]), 1.0), Some(0.0));
        assert_eq!(spheres(&r, &Vector::from([1.0, 0.0]), 1.0), None);
        assert_eq!(spheres(&r, &Vector::from([0.0, 1.0]), 1.0), None);
    }

    #[test]
    fn a_glancing_pass_is_no_event() {
        assert_eq!(spheres(&Vector::from([-2.0, 1.0]), &Vector::from([1.0, 0.0]), 1.0), None);
    }

    #[test]
    fn a_dropped_ball_lands_at_the_square_root_of_two_h_over_g() {
        let t = plane(1.0, 0.0, -9.81).unwrap();
        assert!((t - libm::sqrt(2.0 / 9.81_f64)).abs() < 1e-15);
    }

    #[test]
    fn a_ball_below_the_surface_is_let_rise_to_its_peak() {
        let t = plane(-1.0, 1.0, -10.0).unwrap();
        assert_eq!(t, 0.1);
        assert_eq!(plane(-1e-16, -1.0, -10.0), Some(0.0));
        assert_eq!(plane(-1e-16, -1.0, 10.0), Some(0.0));
        assert_eq!(plane(-1e-16, 1.0, 10.0), None);
    }

    #[test]
    fn a_ball_that_turns_back_at_the_surface_is_no_event() {
        // Gravity away from the plane: v² = 2 a gap.
        assert_eq!(plane(0.5, -1.0, 1.0), None);
        assert!(plane(0.5, -1.001, 1.0).is_some());
    }

    #[test]
    fn what_stays_above_has_no_event() {
        assert!(
            stays_above(0.0, [1.0, 0.0, -10.0], 0.44) && !stays_above(0.0, [1.0, 0.0, -10.0], 0.45)
        );
        assert!(!stays_above(0.0, [1.0, 0.0, -10.0], f64::MAX));
        assert!(!stays_above(0.0, [0.0, 1.0, 1.0], 1.0));
    }

    proptest::proptest! {
        #[test]
        fn nobody_is_said_to_stay_above_who_does_not(
            gap in 0.0..3.0_f64, v in -3.0..3.0_f64, a in -3.0..3.0_f64,
        ) {
            if let Some(span) = plane(gap, v, a) {
                proptest::prop_assert!(!stays_above(1e-9, [gap, v, a], span));
            }
        }
    }

    #[test]
    fn leaving_is_found_on_both_sides() {
        assert_eq!(leaving(2.0, 1.0, 0.0), Some(2.0));
        assert_eq!(leaving(2.0, -1.0, 0.0), Some(2.0));
        assert_eq!(leaving(2.0, 0.0, 1.0), Some(2.0));
        assert_eq!(leaving(2.0, 0.0, 0.0_f64), None);
    }
}
