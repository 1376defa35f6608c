//! On what does a collision depend, and what comes out? Reads nothing; writes nothing, names the scaled numbers before and after.

use super::real::Real;

/// The dimensionless groups on which one collision depends (MP13, Sec. V). None has a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groups<S> {
    /// Eccentricity `e = d/l = sin(alpha)`, where `alpha` is the angle between the relative
    /// velocity and the line of centres.
    pub sin: S,
    /// `cos(alpha)`, the normal component of the impact velocity over its magnitude.
    pub cos: S,
    /// Softness `eta = X/l`, one over MP13's scaled contact distance `l~` (MP13 Eqs. 45, 47).
    pub eta: S,
    /// Scaled damping `c_dis` (MP13 Eqs. 43, 54).
    pub c_dis: S,
}

impl<S: Real> Groups<S> {
    /// The same groups in the number type in which tables are read.
    pub(super) fn to_precise(self) -> Groups<S::Precise> {
        let Self { sin, cos, eta, c_dis } = self;
        let [sin, cos, eta, c_dis] = [sin, cos, eta, c_dis].map(S::to_precise);
        Groups { sin, cos, eta, c_dis }
    }
}

/// Scaled restitution of one collision: the independent entries of MP13's matrix of restitution.
///
/// A certificate uses the same four numbers for the errors of these coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaledRestitution<S> {
    /// Contact duration in units of `T` (MP13 Eq. 20).
    pub tau: S,
    /// Normal speed after over normal speed before, not negative (minus MP13 Eq. 21).
    pub speed: S,
    /// Rotation of the line of centres in radians (MP13 Eq. 17).
    pub angle: S,
    /// Distance of the centres after over before (MP13 Eq. 16).
    pub separation: S,
}

impl<S: Real> ScaledRestitution<S> {
    /// The nearest values to those in the number type in which tables are read.
    pub(super) fn from_precise(precise: ScaledRestitution<S::Precise>) -> Self {
        let ScaledRestitution { tau, speed, angle, separation } = precise;
        let [tau, speed, angle, separation] = [tau, speed, angle, separation].map(S::from_precise);
        Self { tau, speed, angle, separation }
    }
}
