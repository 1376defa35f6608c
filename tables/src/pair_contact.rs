//! How does one contact of two bodies go under any force law without a state? Reads the force and the speeds; writes what it comes to.
//!
//! Dormand and Prince's method of fifth order, its steps chosen by its error (J. Comput. Appl. Math. 6, 19, 1980).

use crate::read::pair::PairOutcome;

/// Two bodies, and the force between them at an overlap that grows at a rate.
pub(crate) struct Pair<'a> {
    pub contact_distance: f64,
    pub reduced_mass: f64,
    pub force: &'a dyn Fn(f64, f64) -> f64,
}

/// Why a contact comes to nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Endless {
    /// Nothing stops the two.
    Passes,
    /// They do not part.
    Holds,
}

/// Overlap, its rate, and how far the line of centres has turned.
type State = [f64; 3];

/// So often two have neared each other anew, or so many times as long has it lasted as they take to come to rest, and
/// they do not part.
const STUCK: (u32, f64) = (8, 1000.0);
const PRECISION: f64 = 1e-12;
/// More steps are not done.
const STEPS: usize = 100_000;

impl Pair<'_> {
    /// What a contact at these speeds, along and across, comes to.
    pub fn collide(&self, [normal, tangential]: [f64; 2]) -> Result<PairOutcome<f64>, Endless> {
        let time = self.depth(normal).ok_or(Endless::Passes)? / normal;
        let slope = |y: &State| self.slope(y, tangential);
        let units = [normal * time, normal, 1.0];
        let (mut t, mut h, mut y) = (0.0, 1e-6 * time, [0.0, normal, 0.0]);
        let mut neared = 0;
        for _ in 0..STEPS {
            if t >= STUCK.1 * time || neared >= STUCK.0 {
                break;
            }
            let (next, wrong) = step(&y, h, &units, slope);
            if !(wrong <= PRECISION) && h > 1e-10 * time {
                h *= (0.9 * (PRECISION / wrong).powf(0.2)).clamp(0.2, 0.9);
                continue;
            }
            if next[0] >= self.contact_distance {
                return Err(Endless::Passes);
            }
            if next[0] <= 0.0 && next[1] < 0.0 {
                let (end, h) = self.ended(&y, h, &units, tangential);
                let [_, rate, angle] = end;
                return Ok(PairOutcome { duration: t + h, restitution: -rate / normal, angle });
            }
            neared += u32::from(y[1] < 0.0 && next[1] >= 0.0);
            (t, y) = (t + h, next);
            h *= (0.9 * (PRECISION / wrong.max(1e-20)).powf(0.2)).clamp(0.2, 3.0);
            h = h.min(0.05 * time);
        }
        Err(Endless::Holds)
    }

    /// About how deep two go at this speed: where the force over that way has their energy.
    fn depth(&self, speed: f64) -> Option<f64> {
        let energy = self.reduced_mass * speed * speed;
        let mut x = 1e-15 * self.contact_distance;
        while x < self.contact_distance {
            if (self.force)(x, 0.0) * x >= energy {
                return Some(x);
            }
            x *= 1.5;
        }
        None
    }

    fn slope(&self, &[x, u, _]: &State, tangential: f64) -> State {
        let (l, r) = (self.contact_distance, self.contact_distance - x);
        let spin = l * tangential;
        let force = if x > 0.0 { (self.force)(x, u) } else { 0.0 };
        [u, -force / self.reduced_mass - spin * spin / (r * r * r), spin / (r * r)]
    }

    /// The instant within a step at which the overlap is none again.
    fn ended(&self, y: &State, h: f64, units: &State, tangential: f64) -> (State, f64) {
        let at = |h| step(y, h, units, |y| self.slope(y, tangential)).0;
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if at(middle)[0] > 0.0 { low = middle } else { high = middle }
        }
        (at(high), high)
    }
}

const A: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Fifth order less fourth.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The state after a step, and by how much it may be wrong in these units.
fn step(y: &State, h: f64, units: &State, slope: impl Fn(&State) -> State) -> (State, f64) {
    let mut slopes = [[0.0; 3]; 7];
    let mut at = *y;
    for (stage, weights) in A.iter().enumerate() {
        let sum = |k: usize| weights.iter().zip(&slopes).map(|(a, s)| a * s[k]).sum::<f64>();
        at = core::array::from_fn(|k| y[k] + h * sum(k));
        slopes[stage] = slope(&at);
    }
    let wrong = |k: usize| {
        let sum: f64 = ERROR.iter().zip(&slopes).map(|(e, s)| e * s[k]).sum();
        (h * sum / units[k]).abs()
    };
    (at, (0..3).map(wrong).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear spring and dashpot that may pull: τ = π/ω and ε = exp(−γ τ/(2 m)), in closed form.
    #[test]
    fn a_central_linear_contact_is_the_closed_form() {
        let (k, gamma, m) = (1e5, 20.0, 0.5_f64);
        let force = |x: f64, u: f64| k * x + gamma * u;
        let pair = Pair { contact_distance: 0.2, reduced_mass: m, force: &force };
        let hit = pair.collide([0.3, 0.0]).unwrap();
        let mu = gamma / (2.0 * m);
        let tau = core::f64::consts::PI / (k / m - mu * mu).sqrt();
        assert!((hit.duration / tau - 1.0).abs() < 1e-9, "{hit:?}");
        assert!((hit.restitution - (-mu * tau).exp()).abs() < 1e-9, "{hit:?}");
        assert_eq!(hit.angle, 0.0);
    }
}
