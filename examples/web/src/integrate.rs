//! How does one contact go, step by step? Reads law and scaled groups; writes the matrix of restitution to about 1e-9.

use carom::law::embedded::read::{Groups, ScaledRestitution};

/// Steps for a time of π T, about one contact.
const STEPS: f64 = 2000.0;
/// No contact within reach of the page lasts so many steps; an overdamped one may creep for ever.
const MAX_STEPS: u32 = 200_000;

/// The contact equation in MP13's scaled form (Eqs. 42 and 54), with η and κ for 1/l̃ and tan²α/l̃.
struct Contact {
    linear: bool,
    kappa: f64,
    eta: f64,
    c_dis: f64,
}

/// Compression, its rate, and ∫ dt/(1 − ηx)².
type State = [f64; 3];

impl Contact {
    fn slope(&self, [x, v, _]: State) -> State {
        let root = libm::sqrt(x.max(0.0));
        let (spring, dashpot) = if self.linear { (x, 1.0) } else { (x * root, root) };
        let r = 1.0 - self.eta * x;
        [v, -self.kappa / (r * r * r) - spring - self.c_dis * dashpot * v, 1.0 / (r * r)]
    }

    /// One step of the classical Runge-Kutta method.
    fn step(&self, s: State, h: f64) -> State {
        let along = |k: State, h: f64| [0, 1, 2].map(|i| s[i] + h * k[i]);
        let a = self.slope(s);
        let b = self.slope(along(a, 0.5 * h));
        let c = self.slope(along(b, 0.5 * h));
        let d = self.slope(along(c, h));
        [0, 1, 2].map(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }

    /// Whether the force has vanished: for both laws when x + c_dis x' ≤ 0 on the way out.
    fn is_over(&self, [x, v, _]: State) -> bool {
        v < 0.0 && x + self.c_dis * v <= 0.0
    }
}

/// One contact from touch to the end of the force (MP13 Eq. 10), by Runge-Kutta steps of π T/2000 and
/// bisection in the last one.
///
/// Two grains that would pass through each other's centre (l̃ cos α < 1) are beyond it.
pub fn contact(linear: bool, groups: &Groups<f64>) -> ScaledRestitution<f64> {
    let tan = groups.sin / groups.cos;
    let contact =
        Contact { linear, kappa: tan * tan * groups.eta, eta: groups.eta, c_dis: groups.c_dis };
    let step = core::f64::consts::PI / STEPS;
    let (mut state, mut tau) = ([0.0, 1.0, 0.0], 0.0);
    for _ in 0..MAX_STEPS {
        let next = contact.step(state, step);
        if contact.is_over(next) {
            break;
        }
        (state, tau) = (next, tau + step);
    }
    let (mut low, mut high) = (0.0, step);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        let over = contact.is_over(contact.step(state, middle));
        (low, high) = if over { (low, middle) } else { (middle, high) };
    }
    let [_, v, sweep] = contact.step(state, high);
    ScaledRestitution {
        tau: tau + high,
        speed: -v,
        angle: tan * groups.eta * sweep,
        separation: 1.0 + groups.c_dis * v * groups.eta,
    }
}
