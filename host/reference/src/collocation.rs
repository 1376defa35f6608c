//! How does a smooth motion go on for one step? Reads y' = f(y) and a start; writes the step as a polynomial.

use std::sync::LazyLock;

/// Gauss-Legendre nodes of a step: order 32 at its end, degree 16 within.
pub(crate) const NODES: usize = 16;
const SWEEPS: usize = 80;

type Row = [f64; NODES];

/// What an error in one unknown is compared with.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Scale {
    /// A given size.
    Fixed(f64),
    /// The unknown's largest size within the step, or the given floor.
    Largest(f64),
}

/// One step, y(θ) for 0 ≤ θ ≤ 1.
///
/// Gauss collocation: the polynomial of degree 16 whose slope is f at 16 Gauss-Legendre nodes.
/// Its last Legendre coefficients say how exact it is, everywhere in the step.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Segment {
    unknowns: usize,
    start: Vec<f64>,
    /// NODES rows of `unknowns`; row k belongs to P_{k+1} − P_{k−1}.
    coefficients: Vec<f64>,
    /// Last coefficients, relative to the scales.
    pub error: f64,
}

struct Rule {
    nodes: Row,
    /// Integral from 0 to node i of the cardinal function of node j.
    integral: [Row; NODES],
    /// Legendre coefficient k from the values at the nodes, divided by 2 (2k + 1).
    legendre: [Row; NODES],
}

static RULE: LazyLock<Rule> = LazyLock::new(rule);

/// The place of node i in the step, 0 < θ < 1.
pub(crate) fn node(i: usize) -> f64 {
    RULE.nodes[i]
}

/// P_0 … P_{NODES} at ξ.
fn polynomials(xi: f64) -> [f64; NODES + 1] {
    let mut p = [1.0; NODES + 1];
    p[1] = xi;
    for k in 1..NODES {
        let n = k as f64;
        p[k + 1] = ((2.0 * n + 1.0) * xi * p[k] - n * p[k - 1]) / (n + 1.0);
    }
    p
}

/// P_{k+1}(ξ) − P_{k−1}(ξ), which is (2k + 1) times the integral of P_k from −1 to ξ.
fn basis(xi: f64) -> Row {
    let p = polynomials(xi);
    std::array::from_fn(|k| if k == 0 { p[1] + 1.0 } else { p[k + 1] - p[k - 1] })
}

/// Node i of Gauss and Legendre on (−1, 1), and its weight.
fn gauss(i: usize) -> (f64, f64) {
    let n = NODES as f64;
    let mut x = -libm::cos(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5));
    let mut slope = 1.0;
    for _ in 0..10 {
        let p = polynomials(x);
        slope = n * (x * p[NODES] - p[NODES - 1]) / (x * x - 1.0);
        x -= p[NODES] / slope;
    }
    (x, 2.0 / ((1.0 - x * x) * slope * slope))
}

fn rule() -> Rule {
    let points: [(f64, f64); NODES] = std::array::from_fn(gauss);
    let legendre: [Row; NODES] =
        std::array::from_fn(|k| points.map(|(x, w)| 0.25 * w * polynomials(x)[k]));
    let integral = std::array::from_fn(|i| {
        let b = basis(points[i].0);
        std::array::from_fn(|j| (0..NODES).map(|k| b[k] * legendre[k][j]).sum())
    });
    Rule { nodes: points.map(|(x, _)| 0.5 * (x + 1.0)), integral, legendre }
}

impl Segment {
    /// Solves one step of length h, or says that the sweeps did not converge.
    pub fn solve(
        rhs: &impl Fn(&[f64], &mut [f64]),
        start: &[f64],
        h: f64,
        scales: &[Scale],
        guess: Option<Guess>,
    ) -> Option<Self> {
        let n = start.len();
        let mut stages = match guess {
            Some(guess) => guess.stages(),
            None => straight(rhs, start, h),
        };
        let mut slopes = vec![0.0; n * NODES];
        let mut before = f64::INFINITY;
        for _ in 0..SWEEPS {
            for (y, f) in stages.chunks_exact(n).zip(slopes.chunks_exact_mut(n)) {
                rhs(y, f);
            }
            let change = sweep(start, h, &slopes, &mut stages, scales);
            if change < 1e-15 || (change < 1e-12 && change >= 0.5 * before) {
                return Some(Self::from_slopes(start, h, &slopes, &stages, scales));
            }
            if !change.is_finite() {
                return None;
            }
            before = change;
        }
        None
    }

    fn from_slopes(start: &[f64], h: f64, slopes: &[f64], stages: &[f64], to: &[Scale]) -> Self {
        let n = start.len();
        let mut coefficients = vec![0.0; n * NODES];
        for (row, out) in RULE.legendre.iter().zip(coefficients.chunks_exact_mut(n)) {
            for (weight, slope) in row.iter().zip(slopes.chunks_exact(n)) {
                out.iter_mut().zip(slope).for_each(|(c, f)| *c += h * weight * f);
            }
        }
        let mut error = 0.0_f64;
        for k in 0..n {
            let last = |back: usize| coefficients[(NODES - back) * n + k].abs();
            error = error.max(last(1).max(last(2)) / size(to[k], stages, n, k));
        }
        Self { unknowns: n, start: start.to_vec(), coefficients, error }
    }

    /// All unknowns at θ.
    pub fn at(&self, theta: f64) -> Vec<f64> {
        let weights = basis(2.0 * theta - 1.0);
        let mut y = self.start.clone();
        for (w, row) in weights.iter().zip(self.coefficients.chunks_exact(self.unknowns)) {
            y.iter_mut().zip(row).for_each(|(y, c)| *y += w * c);
        }
        y
    }

    /// One unknown at θ.
    pub fn one(&self, theta: f64, k: usize) -> f64 {
        let weights = basis(2.0 * theta - 1.0);
        let rows = self.coefficients.chunks_exact(self.unknowns);
        self.start[k] + weights.iter().zip(rows).map(|(w, row)| w * row[k]).sum::<f64>()
    }
}

/// Where to begin the sweeps: on another step's polynomial, from θ = `from` on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Guess<'a> {
    pub segment: &'a Segment,
    pub from: f64,
    /// Length of the new step in units of the other one.
    pub ratio: f64,
}

impl Guess<'_> {
    fn stages(&self) -> Vec<f64> {
        let place = |c: &f64| self.segment.at(self.from + self.ratio * c);
        RULE.nodes.iter().flat_map(place).collect()
    }
}

fn straight(rhs: &impl Fn(&[f64], &mut [f64]), start: &[f64], h: f64) -> Vec<f64> {
    let mut slope = vec![0.0; start.len()];
    rhs(start, &mut slope);
    let stage = |c: f64| start.iter().zip(&slope).map(move |(y, f)| y + h * c * f);
    RULE.nodes.iter().flat_map(|&c| stage(c).collect::<Vec<_>>()).collect()
}

/// New stages from the slopes; the largest change, relative to the scales.
fn sweep(start: &[f64], h: f64, slopes: &[f64], stages: &mut [f64], to: &[Scale]) -> f64 {
    let n = start.len();
    let mut changes = vec![0.0_f64; n];
    let mut fresh = vec![0.0; n];
    for (row, y) in RULE.integral.iter().zip(stages.chunks_exact_mut(n)) {
        fresh.fill(0.0);
        for (weight, slope) in row.iter().zip(slopes.chunks_exact(n)) {
            fresh.iter_mut().zip(slope).for_each(|(y, f)| *y += weight * f);
        }
        for k in 0..n {
            let value = start[k] + h * fresh[k];
            changes[k] = worst(changes[k], (value - y[k]).abs());
            y[k] = value;
        }
    }
    (0..n).map(|k| changes[k] / size(to[k], stages, n, k)).fold(0.0, worst)
}

/// The larger one; NaN if one is.
fn worst(a: f64, b: f64) -> f64 {
    if b <= a { a } else { b }
}

fn size(scale: Scale, stages: &[f64], n: usize, k: usize) -> f64 {
    match scale {
        Scale::Fixed(size) => size,
        Scale::Largest(floor) => {
            stages.iter().skip(k).step_by(n).fold(floor, |m, y| m.max(y.abs())).max(1e-300)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exponential_to_round_off() {
        let rhs = |y: &[f64], f: &mut [f64]| f[0] = -y[0];
        let step =
            Segment::solve(&rhs, &[1.0], 1.0, &[Scale::Largest(0.0)], None).expect("converges");
        for theta in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let wrong = (step.one(theta, 0) - (-theta).exp()).abs();
            assert!(wrong < 3e-16, "{theta}: {wrong:e}");
            assert!((step.one(theta, 0) - step.at(theta)[0]).abs() < 3e-16);
        }
    }
}
