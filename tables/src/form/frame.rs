//! Where in the unit cube does a collision lie, and what was divided out there? Reads `kappa`, `eta`, `c_dis`; writes coordinates and restitution.

use super::Stored;
use crate::law::{End, Law};
use crate::number::Real;

/// How the groups become coordinates in the unit cube.
///
/// The stiff, weakly damped corner needs algebra only; a wide frame divides out the
/// asymptotics of overdamped and grazing contacts and takes a logarithm and cube roots for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<C> {
    /// The force law.
    pub law: Law,
    /// The end of the contact.
    pub end: End,
    /// Any damping and softness (logarithms), or the stiff, weakly damped corner (algebra only)?
    pub wide: bool,
    /// Centrifugal scale `a` in `kappa / (kappa + a)`.
    pub kappa_scale: C,
    /// `softness_max`, the largest `eta / cos(alpha)`.
    pub softness: C,
    /// Largest `c_dis`.
    pub c_dis: C,
    /// How strongly centrifugal push and damping go together.
    pub bend: C,
}

fn number<S: Real>(value: f32) -> S {
    S::from_f32(value)
}

impl<C: Stored> Frame<C> {
    /// The unit cube: centrifugal push, softness, damping.
    pub fn coordinates<S: Real>(&self, [kappa, eta, c_dis]: [S; 3]) -> [S; 3] {
        let one: S = number(1.0);
        let first = kappa / (kappa + self.kappa_scale.get());
        let bend = one + self.bend.get::<S>() * kappa;
        if !self.is_wide() {
            let u = c_dis / self.c_dis.get();
            let third = u * bend / (one + (bend - one) * u);
            return [first, self.softness_coordinate(kappa, eta), third];
        }
        let z = bend * rate(self.law, kappa, c_dis);
        let third = z / (one + z);
        match self.law {
            Law::LinearDashpot => {
                let y = eta * deepest(c_dis);
                let top: S = self.softness.get();
                [first.cbrt(), y / (one + y) * ((one + top) / top), third]
            }
            Law::Viscoelastic => [first, self.softness_coordinate(kappa, eta), third],
        }
    }

    fn is_wide(&self) -> bool {
        C::WIDE && self.wide
    }

    fn softness_coordinate<S: Real>(&self, kappa: S, eta: S) -> S {
        let b: S = self.softness.get();
        eta * (b + b + kappa) / ((b + b) * b)
    }

    /// What the first column is multiplied with to give the duration.
    fn duration<S: Real>(&self, [kappa, _, c_dis]: [S; 3]) -> S {
        let one: S = number(1.0);
        if self.is_wide() {
            return wide_duration(self.law, kappa, c_dis);
        }
        let push = one + kappa;
        one / match self.law {
            Law::LinearDashpot => push + number::<S>(0.5) * c_dis,
            Law::Viscoelastic => push + number::<S>(0.2357) * c_dis / push.sqrt(),
        }
    }

    /// What the second column is multiplied with to give `1/speed - 1`.
    fn slowing<S: Real>(&self, [kappa, _, c_dis]: [S; 3]) -> S {
        let push = number::<S>(1.0) + kappa;
        if self.end == End::Overlap {
            // Grazing grains lose nothing: the contact is over before damping has worked.
            return match self.law {
                Law::LinearDashpot => c_dis / push,
                Law::Viscoelastic => c_dis / (push * push.sqrt()),
            };
        }
        let drag = match self.law {
            Law::LinearDashpot => number::<S>(0.6667) * c_dis,
            Law::Viscoelastic if self.is_wide() => {
                let root = c_dis.cbrt();
                number::<S>(0.2777) * c_dis / (push + root * root).sqrt()
            }
            Law::Viscoelastic => number::<S>(0.2777) * c_dis / push.sqrt(),
        };
        c_dis * (push + drag)
    }

    /// Duration, speed and angle from the three columns; `turn = tan(alpha) eta`.
    pub fn unscale<S: Real>(
        &self,
        groups: [S; 3],
        turn: S,
        direct: bool,
        columns: [S; 3],
    ) -> [S; 3] {
        let one: S = number(1.0);
        let tau = columns[0] * self.duration(groups);
        let speed = one / (one + self.slowing(groups) * columns[1]);
        let angle = if direct { columns[2] } else { turn * tau * (one + groups[1] * columns[2]) };
        [tau, speed, angle]
    }
}

/// How fast damping ends a contact: the time constant of the force that decays.
fn rate<S: Real>(law: Law, kappa: S, c_dis: S) -> S {
    match law {
        Law::LinearDashpot => c_dis,
        Law::Viscoelastic => {
            let root = c_dis.cbrt();
            let one: S = number(1.0);
            c_dis / (one + number::<S>(4.5) * kappa + number::<S>(0.763) * root * root).sqrt()
        }
    }
}

/// The deepest compression of a central contact, roughly.
fn deepest<S: Real>(c_dis: S) -> S {
    let one: S = number(1.0);
    let part = number::<S>(0.2726) * c_dis;
    (one + part) / (one + part + c_dis * (number::<S>(core::f32::consts::FRAC_PI_4) + part))
}

/// The duration of a contact that damping or centrifugal push ends: `ln(1 + y)/rate`, with
/// the limits `1/(1 + kappa)` (elastic), `1/kappa` (grazing), `ln(rate/(kappa + rate^-m))/rate` (overdamped).
fn wide_duration<S: Real>(law: Law, kappa: S, c_dis: S) -> S {
    let one: S = number(1.0);
    let r = rate(law, kappa, c_dis);
    let (boost, floor) = match law {
        Law::LinearDashpot => (one, one / (one + r * r * r)),
        Law::Viscoelastic => {
            let root = c_dis.cbrt();
            let root4 = root * root * root * root;
            let push = one + kappa;
            let boost = (push + number::<S>(2.098) * r) / (push + r);
            (boost, one / (one + root4 * root4 * number(0.763)))
        }
    };
    let y = r * boost / (kappa + floor);
    let slope = if y < number(1e-3) { one - y * number(0.5) } else { y.ln_1p() / y };
    boost / (kappa + floor) * slope
}

#[cfg(feature = "generate")]
impl Frame<f64> {
    /// The groups `kappa`, `eta`, `c_dis` at a point of the unit cube: the inverse of [`Frame::coordinates`].
    pub fn groups(&self, y: [f64; 3]) -> [f64; 3] {
        let cubed = self.wide && self.law == Law::LinearDashpot;
        let first = if cubed { y[0] * y[0] * y[0] } else { y[0] };
        let kappa = self.kappa_scale * first / (1.0 - first);
        let bend = 1.0 + self.bend * kappa;
        let c_dis = if self.wide {
            self.damping_of(kappa, y[2] / (1.0 - y[2]) / bend)
        } else {
            self.c_dis * y[2] / (bend - (bend - 1.0) * y[2])
        };
        let eta = if cubed {
            let part = y[1] * self.softness / (1.0 + self.softness);
            part / (1.0 - part) / deepest(c_dis)
        } else {
            let b2 = 2.0 * self.softness;
            y[1] * b2 * self.softness / (b2 + kappa)
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

    /// The three columns from duration, speed and angle: the inverse of [`Frame::unscale`].
    pub fn scale(&self, groups: [f64; 3], turn: f64, direct: bool, outcome: [f64; 3]) -> [f64; 3] {
        let [tau, speed, angle] = outcome;
        let third = if direct { angle } else { (angle / (turn * tau) - 1.0) / groups[1] };
        [tau / self.duration(groups), (1.0 / speed - 1.0) / self.slowing(groups), third]
    }
}
