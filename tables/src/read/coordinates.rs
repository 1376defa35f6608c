//! Where in the unit cube does a collision lie, and what was divided out there? Reads `kappa`, `eta`, `c_dis`; writes coordinates and restitution.

use super::law::{End, Law};
use super::real::Real;
use super::stored::StoredNumber;

/// How the groups become coordinates in the unit cube.
///
/// The stiff, weakly damped corner needs algebra only; a wide map divides out the
/// asymptotics of overdamped and grazing contacts and takes a logarithm and cube roots for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordinateMap<C> {
    /// The force law.
    pub law: Law,
    /// The end of the contact.
    pub end: End,
    /// Whether the map covers any damping and softness (with logarithms and cube roots), or only the
    /// stiff, weakly damped corner (algebra only).
    pub wide: bool,
    /// The scale `a` in the first coordinate `kappa / (kappa + a)`.
    pub kappa_scale: C,
    /// Largest softness, `eta / cos(alpha)`.
    pub softness_max: C,
    /// Largest `c_dis`.
    pub c_dis_max: C,
    /// How strongly the third coordinate depends on `kappa`, beside damping.
    pub coupling: C,
}

fn constant<S: Real>(value: f32) -> S {
    S::from_f32(value)
}

impl<C: StoredNumber> CoordinateMap<C> {
    /// The point of the unit cube for `kappa`, `eta`, `c_dis`. Its coordinates are for centrifugal force, softness, damping.
    pub(crate) fn cube_point<S: Real>(&self, [kappa, eta, c_dis]: [S; 3]) -> [S; 3] {
        let one: S = constant(1.0);
        let first = kappa / (kappa + self.kappa_scale.get());
        let bend = one + self.coupling.get::<S>() * kappa;
        if !self.is_wide() {
            let u = c_dis / self.c_dis_max.get();
            let third = u * bend / (one + (bend - one) * u);
            return [first, self.softness_coordinate(kappa, eta), third];
        }
        let z = bend * rate(self.law, kappa, c_dis);
        let third = z / (one + z);
        match self.law {
            Law::LinearDashpot => {
                let y = eta * deepest(c_dis);
                let top: S = self.softness_max.get();
                [first.cbrt(), y / (one + y) * ((one + top) / top), third]
            }
            Law::Viscoelastic => [first, self.softness_coordinate(kappa, eta), third],
        }
    }

    fn is_wide(&self) -> bool {
        C::WIDE && self.wide
    }

    fn softness_coordinate<S: Real>(&self, kappa: S, eta: S) -> S {
        let b: S = self.softness_max.get();
        eta * (b + b + kappa) / ((b + b) * b)
    }

    /// What the first column is multiplied with to give the duration.
    fn duration<S: Real>(&self, [kappa, _, c_dis]: [S; 3]) -> S {
        let one: S = constant(1.0);
        if self.is_wide() {
            return wide_duration(self.law, kappa, c_dis);
        }
        let centrifugal = one + kappa;
        one / match self.law {
            Law::LinearDashpot => centrifugal + constant::<S>(0.5) * c_dis,
            Law::Viscoelastic => centrifugal + constant::<S>(0.2357) * c_dis / centrifugal.sqrt(),
        }
    }

    /// What the second column is multiplied with to give `1/speed - 1`.
    fn slowing<S: Real>(&self, [kappa, _, c_dis]: [S; 3]) -> S {
        let centrifugal = constant::<S>(1.0) + kappa;
        if self.end == End::Overlap {
            // Grazing grains lose nothing: the contact is over before damping has worked.
            return match self.law {
                Law::LinearDashpot => c_dis / centrifugal,
                Law::Viscoelastic => c_dis / (centrifugal * centrifugal.sqrt()),
            };
        }
        let drag = match self.law {
            Law::LinearDashpot => constant::<S>(0.6667) * c_dis,
            Law::Viscoelastic if self.is_wide() => {
                let root = c_dis.cbrt();
                constant::<S>(0.2777) * c_dis / (centrifugal + root * root).sqrt()
            }
            Law::Viscoelastic => constant::<S>(0.2777) * c_dis / centrifugal.sqrt(),
        };
        c_dis * (centrifugal + drag)
    }

    /// Duration, speed and angle from the three columns; `turn = tan(alpha) eta`.
    pub(crate) fn outcome<S: Real>(
        &self,
        groups: [S; 3],
        turn: S,
        direct_angle: bool,
        columns: [S; 3],
    ) -> [S; 3] {
        let one: S = constant(1.0);
        let tau = columns[0] * self.duration(groups);
        let speed = one / (one + self.slowing(groups) * columns[1]);
        let angle =
            if direct_angle { columns[2] } else { turn * tau * (one + groups[1] * columns[2]) };
        [tau, speed, angle]
    }
}

/// How fast damping ends a contact: the time constant of the force that decays.
fn rate<S: Real>(law: Law, kappa: S, c_dis: S) -> S {
    match law {
        Law::LinearDashpot => c_dis,
        Law::Viscoelastic => {
            let root = c_dis.cbrt();
            let one: S = constant(1.0);
            c_dis / (one + constant::<S>(4.5) * kappa + constant::<S>(0.763) * root * root).sqrt()
        }
    }
}

/// The deepest compression of a central contact, roughly.
fn deepest<S: Real>(c_dis: S) -> S {
    let one: S = constant(1.0);
    let part = constant::<S>(0.2726) * c_dis;
    (one + part) / (one + part + c_dis * (constant::<S>(core::f32::consts::FRAC_PI_4) + part))
}

/// The duration of a contact that damping or centrifugal force ends: `ln(1 + y)/rate`, with
/// the limits `1/(1 + kappa)` (elastic), `1/kappa` (grazing), `ln(rate/(kappa + rate^-m))/rate` (overdamped).
fn wide_duration<S: Real>(law: Law, kappa: S, c_dis: S) -> S {
    let one: S = constant(1.0);
    let r = rate(law, kappa, c_dis);
    let (boost, floor) = match law {
        Law::LinearDashpot => (one, one / (one + r * r * r)),
        Law::Viscoelastic => {
            let root = c_dis.cbrt();
            let root4 = root * root * root * root;
            let centrifugal = one + kappa;
            let boost = (centrifugal + constant::<S>(2.098) * r) / (centrifugal + r);
            (boost, one / (one + root4 * root4 * constant(0.763)))
        }
    };
    let y = r * boost / (kappa + floor);
    let slope = if y < constant(1e-3) { one - y * constant(0.5) } else { y.ln_1p() / y };
    boost / (kappa + floor) * slope
}

#[cfg(feature = "generate")]
impl CoordinateMap<f64> {
    /// The groups `kappa`, `eta`, `c_dis` at a point of the unit cube: the inverse of [`CoordinateMap::cube_point`].
    pub(crate) fn groups_at(&self, y: [f64; 3]) -> [f64; 3] {
        let cubed = self.wide && self.law == Law::LinearDashpot;
        let first = if cubed { y[0] * y[0] * y[0] } else { y[0] };
        let kappa = self.kappa_scale * first / (1.0 - first);
        let bend = 1.0 + self.coupling * kappa;
        let c_dis = if self.wide {
            self.damping_of(kappa, y[2] / (1.0 - y[2]) / bend)
        } else {
            self.c_dis_max * y[2] / (bend - (bend - 1.0) * y[2])
        };
        let eta = if cubed {
            let part = y[1] * self.softness_max / (1.0 + self.softness_max);
            part / (1.0 - part) / deepest(c_dis)
        } else {
            let b2 = 2.0 * self.softness_max;
            y[1] * b2 * self.softness_max / (b2 + kappa)
        };
        [kappa, eta, c_dis]
    }

    /// `c_dis` at which the rate is `r`.
    fn damping_of(&self, kappa: f64, r: f64) -> f64 {
        if self.law == Law::LinearDashpot {
            return r;
        }
        // c = r sqrt(1 + 4.5 kappa + 0.763 c^(2/3)): a contraction in c^(1/3).
        let mut c = r * libm::sqrt(1.0 + 4.5 * kappa) + r * libm::sqrt(r);
        for _ in 0..60 {
            let root = libm::cbrt(c);
            c = r * libm::sqrt(1.0 + 4.5 * kappa + 0.763 * root * root);
        }
        c
    }

    /// The three columns from duration, speed and angle: the inverse of [`CoordinateMap::outcome`].
    pub(crate) fn columns(
        &self,
        groups: [f64; 3],
        turn: f64,
        direct_angle: bool,
        outcome: [f64; 3],
    ) -> [f64; 3] {
        let [tau, speed, angle] = outcome;
        let third = if direct_angle { angle } else { (angle / (turn * tau) - 1.0) / groups[1] };
        [tau / self.duration(groups), (1.0 / speed - 1.0) / self.slowing(groups), third]
    }
}
