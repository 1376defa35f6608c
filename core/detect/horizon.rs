//! Can two grains meet before a time? Reads their motion; writes nothing, errs only on the side of "maybe".

use crate::scalar::{Scalar, Vector};

/// How two grains move against each other at the present.
pub(super) struct Motion<S> {
    /// How fast they part, times their distance: r·v.
    parting: S,
    distance2: S,
    speed2: S,
    /// r² − σ², less a margin.
    gap: S,
}

impl<S: Scalar> Motion<S> {
    /// Separation, relative velocity, and the distance at which they touch.
    #[inline(always)]
    pub fn new<const D: usize>(r: &Vector<S, D>, v: &Vector<S, D>, reach: S) -> Self {
        let distance2 = r.dot(r);
        let gap = distance2 - reach * reach * S::from_f32(1.0 + 1.0 / 256.0);
        Self { parting: r.dot(v), distance2, speed2: v.dot(v), gap }
    }

    /// Never false where [`super::root::spheres`] finds a collision within this time, even from separations that are
    /// wrong by a thousandth of the reach. For floats only.
    ///
    /// The margins are those of the prefilter: σ² larger by 1/256, the discriminant smaller by 1/100. The distance is a
    /// convex function of time, so its tangent says when it is down to σ at the earliest: r + ṙ t ≤ σ, and with
    /// r ṙ = r·v that is (r² − σ²)/2 ≤ −(r·v) t. Where t is so long that rounding of r·v could matter nothing is said.
    #[inline(always)]
    pub fn may_collide(&self, within: S) -> bool {
        if self.gap <= S::zero() {
            return true;
        }
        if self.parting > S::zero() {
            return false;
        }
        if !(self.parting * self.parting >= self.speed2 * self.gap * S::from_f32(0.99)) {
            return false;
        }
        let flown = self.speed2 * within * within;
        self.gap <= -self.parting * within * S::from_f32(2.02)
            || flown > self.distance2 * S::from_f32(1e6)
    }
}

#[cfg(test)]
mod tests {
    use super::super::root::spheres;
    use super::*;

    proptest::proptest! {
        /// As the prefilter's test, asked up to just after the collision; f32 as well.
        #[test]
        fn no_collision_within_the_time_is_missed(
            gap in proptest::prop_oneof![-0.5..4.0_f64, -1e-3..1e-3_f64, 10.0..1e4_f64],
            aim in proptest::prop_oneof![-1.5..1.5_f64, 0.999..1.001_f64],
            (turn, speed) in (0.0..6.2_f64, 1e-3..1e3_f64),
            error in proptest::array::uniform3(-0.0005..0.0005_f64),
            later in proptest::prop_oneof![0.0..1e-9_f64, 0.0..2.0_f64],
        ) {
            let (distance, sigma) = (1.0 + gap, 1.0);
            let across = (aim / distance).clamp(-1.0, 1.0);
            let along = libm::sqrt(1.0 - across * across) * if turn > 3.1 { 1.0 } else { -1.0 };
            let (sin, cos) = (libm::sin(turn), libm::cos(turn));
            let r = Vector::from([distance * cos, distance * sin, 0.0]);
            let v = Vector::from([along * cos - across * sin, along * sin + across * cos, 0.0]) * speed;
            if let Some(span) = spheres(&r, &v, sigma) {
                let within = span * (1.0 + later);
                let near = r + Vector::from(error);
                proptest::prop_assert!(Motion::new(&near, &v, sigma).may_collide(within));
                let coarse = Motion::new(&r.cast::<f32>(), &v.cast::<f32>(), 1.0);
                proptest::prop_assert!(coarse.may_collide(within as f32));
            }
        }

        /// What is left out is worth it: most that come too late.
        #[test]
        fn who_comes_much_later_is_left_out(gap in 0.2..10.0_f64, speed in 1e-3..1e3_f64) {
            let (r, v) = (Vector::from([1.0 + gap, 0.0]), Vector::from([-speed, 0.0]));
            let span = spheres(&r, &v, 1.0).unwrap();
            proptest::prop_assert!(!Motion::new(&r, &v, 1.0).may_collide(0.45 * span));
        }
    }
}
