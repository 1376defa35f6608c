//! Which sparse expansions hold a contact law? Reads law, end and frame; writes branches, leaves, rows and coefficients.

mod check;
mod column;

use crate::contact::{follow, follow_quickly};
use crate::form::{Branch, Domain, End, Frame, Law, Leaf, MAX_TERMS, Row};
use crate::recipe::Number;
pub(crate) use check::place;
use check::{Check, errors};
use column::Column;

/// Below this softness coordinate the third column is the angle with its factors divided out.
const DIRECT: f64 = 0.28;

/// What a fit is asked for.
#[derive(Clone, Debug)]
pub(crate) struct Ask {
    pub law: Law,
    pub end: End,
    pub frame: Frame<f64>,
    pub domain: Domain,
    /// Largest error of each output that a leaf may have.
    pub goal: f64,
    /// The same where no typical collision falls.
    pub loose: f64,
    /// Largest number of coefficients of one leaf.
    pub limit: usize,
    /// Nodes along each axis to begin with.
    pub start: [usize; 3],
    /// Rather bisect than take more nodes when the error is this many times the goal.
    pub patience: f64,
    /// The number in which the table will be read.
    pub number: Number,
    /// Integrate to 1e-12 rather than 1e-10.
    pub precise: bool,
    /// Typical collisions in the unit cube; empty: all are equally typical.
    pub typical: Vec<[f64; 3]>,
    /// Where the check points of the leaves lie: a little more than the domain.
    pub checked: Domain,
    /// The bisection, if an earlier search is to be repeated: see [`Fit::plan`].
    pub plan: Option<&'static str>,
}

/// The tree in double precision.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fit {
    pub branches: Vec<Branch>,
    pub leaves: Vec<Leaf>,
    pub rows: Vec<Row>,
    pub coefficients: Vec<f64>,
    /// The box of each leaf.
    pub cubes: Vec<Cube>,
    /// The largest leaf.
    pub terms: usize,
    /// What the search has decided, depth first: `0`, `1`, `2` bisects that axis, three letters
    /// are a leaf and its nodes along the axes (`a` is none, `b` one, ...).
    pub plan: String,
}

/// A box in the unit cube.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cube {
    pub low: [f64; 3],
    pub size: [f64; 3],
}

impl Cube {
    /// The point of the unit cube at local coordinates.
    pub fn at(&self, y: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| self.low[a] + self.size[a] * y[a])
    }

    fn half(&self, axis: usize, upper: bool) -> Cube {
        let mut half = *self;
        half.size[axis] *= 0.5;
        if upper {
            half.low[axis] += half.size[axis];
        }
        half
    }

    fn holds(&self, y: &[f64; 3]) -> bool {
        (0..3).all(|a| y[a] >= self.low[a] && y[a] < self.low[a] + self.size[a])
    }
}

/// The whole unit cube, bisected until every leaf keeps the goal, or as planned.
pub(crate) fn fit(ask: &Ask) -> Fit {
    let mut fit = Fit::default();
    let cube = Cube { low: [0.0; 3], size: [1.0; 3] };
    match ask.plan {
        Some(plan) => follow_plan(ask, cube, ask.typical.clone(), &mut plan.bytes(), &mut fit),
        None => search(ask, cube, ask.typical.clone(), 0, &mut fit),
    };
    fit
}

/// How far bisection may go; a table that would need more keeps a larger error, and its certificate says so.
const DEPTH: usize = 24;
/// How many leaves there may be.
const LEAVES: usize = 2_000;

/// Where typical collisions are rare the goal is loose.
fn goal(ask: &Ask, typical: &[[f64; 3]]) -> f64 {
    if ask.typical.is_empty() || typical.len() > 1 { ask.goal } else { ask.loose }
}

/// Fits one box: more nodes along the slowest axis while that pays, else two halves.
fn search(ask: &Ask, cube: Cube, typical: Vec<[f64; 3]>, depth: usize, fit: &mut Fit) -> i16 {
    let goal = goal(ask, &typical);
    let checks = Check::of(ask, &cube);
    let mut nodes = ask.start;
    let mut trial = Trial::new(ask, &cube, nodes, goal, &checks);
    while depth < DEPTH && fit.leaves.len() < LEAVES && !trial.keeps(ask, goal) {
        let axis = trial.slowest();
        let hopeless = trial.error > ask.patience * goal || trial.count > ask.limit;
        if hopeless || nodes[axis] + 2 > MAX_TERMS {
            fit.plan.push((b'0' + axis as u8) as char);
            return split(cube, axis, typical, fit, |cube, typical, fit| {
                search(ask, cube, typical, depth + 1, fit)
            });
        }
        nodes[axis] += 2;
        trial = Trial::new(ask, &cube, nodes, goal, &checks);
    }
    keep(ask, cube, &trial, fit)
}

/// Repeats what a search has decided; a plan that breaks off gives small leaves.
fn follow_plan(
    ask: &Ask,
    cube: Cube,
    typical: Vec<[f64; 3]>,
    plan: &mut std::str::Bytes<'static>,
    fit: &mut Fit,
) -> i16 {
    let order = plan.next().unwrap_or(b'c');
    if (b'0'..=b'2').contains(&order) {
        fit.plan.push(order as char);
        return split(cube, (order - b'0') as usize, typical, fit, |cube, typical, fit| {
            follow_plan(ask, cube, typical, plan, fit)
        });
    }
    let mut number = |letter: u8| usize::from(letter.saturating_sub(b'a')).clamp(2, MAX_TERMS);
    let nodes = [order, plan.next().unwrap_or(b'c'), plan.next().unwrap_or(b'c')].map(&mut number);
    let goal = goal(ask, &typical);
    let trial = Trial::new(ask, &cube, nodes, goal, &Check::of(ask, &cube));
    keep(ask, cube, &trial, fit)
}

/// Stores a leaf; gives its number as a branch names it.
fn keep(ask: &Ask, cube: Cube, trial: &Trial, fit: &mut Fit) -> i16 {
    fit.plan.extend(trial.columns[0].n.map(|n| (b'a' + n as u8) as char));
    fit.terms = fit.terms.max(trial.count);
    fit.cubes.push(cube);
    let leaf = column::store(&trial.columns, direct(ask, &cube), fit);
    fit.leaves.push(leaf);
    !(fit.leaves.len() as i16 - 1)
}

/// Bisects a box and goes on with both halves.
fn split(
    cube: Cube,
    axis: usize,
    typical: Vec<[f64; 3]>,
    fit: &mut Fit,
    mut go_on: impl FnMut(Cube, Vec<[f64; 3]>, &mut Fit) -> i16,
) -> i16 {
    let here = fit.branches.len();
    fit.branches.push(Branch { axis: axis as u8, low: 0, high: 0 });
    let lower = cube.half(axis, false);
    let (below, above) = typical.into_iter().partition(|y| lower.holds(y));
    fit.branches[here].low = go_on(lower, below, fit);
    fit.branches[here].high = go_on(cube.half(axis, true), above, fit);
    here as i16
}

/// One attempt at a leaf.
struct Trial {
    columns: [Column; 3],
    thresholds: [f64; 3],
    count: usize,
    error: f64,
}

impl Trial {
    fn new(ask: &Ask, cube: &Cube, nodes: [usize; 3], goal: f64, checks: &[Check]) -> Self {
        let columns = sample(ask, cube, nodes);
        let thresholds = columns.each_ref().map(|c| c.all[0].abs() * goal * 0.3);
        let mut trial = Trial { columns, thresholds, count: 0, error: f64::INFINITY };
        trial.trim(ask, cube, goal, checks);
        trial.count = trial.columns.iter().map(Column::count).sum();
        trial
    }

    fn keeps(&self, ask: &Ask, goal: f64) -> bool {
        self.error <= goal && self.count <= ask.limit
    }

    /// Drops, round by round, what the goal does not need.
    fn trim(&mut self, ask: &Ask, cube: &Cube, goal: f64, checks: &[Check]) {
        let direct = direct(ask, cube);
        for round in 0..6 {
            for (column, &threshold) in self.columns.iter_mut().zip(&self.thresholds) {
                column.cut(threshold);
            }
            let errors = errors(ask, direct, &self.columns, checks);
            self.error = errors.iter().fold(0.0, |worst, &e| if e > worst { e } else { worst });
            if round == 0 && self.error > 100.0 * goal {
                return;
            }
            for (threshold, e) in self.thresholds.iter_mut().zip(errors) {
                let kept = round == 4 && e <= goal;
                *threshold *= if kept { 1.0 } else { (0.85 * goal / e).clamp(0.1, 4.0) };
            }
        }
    }

    /// The axis along which the expansions fall off most slowly.
    fn slowest(&self) -> usize {
        let mut tails = [0.0; 3];
        for (column, threshold) in self.columns.iter().zip(self.thresholds) {
            for (tail, more) in tails.iter_mut().zip(column.tails(threshold)) {
                *tail += more;
            }
        }
        let mut axis = 0;
        for a in 1..3 {
            if tails[a] > tails[axis] {
                axis = a;
            }
        }
        axis
    }
}

/// The three columns at the Chebyshev nodes of a box, transformed.
fn sample(ask: &Ask, cube: &Cube, nodes: [usize; 3]) -> [Column; 3] {
    let direct = direct(ask, cube);
    let places = nodes.map(column::nodes);
    let mut columns = [const { Vec::new() }; 3];
    for &first in &places[0] {
        for &second in &places[1] {
            for &third in &places[2] {
                let g = extended(ask, ask.frame.groups(cube.at([first, second, third])));
                let outcome = outcome(ask, g);
                let values = ask.frame.scale(g, turn(g), direct, outcome);
                columns[0].push(values[0]);
                columns[1].push(values[1]);
                columns[2].push(values[2]);
            }
        }
    }
    columns.map(|values| Column::new(values, nodes))
}

/// Duration, speed and angle for `kappa`, `eta`, `c_dis`.
fn outcome(ask: &Ask, g: [f64; 3]) -> [f64; 3] {
    let follow = if ask.precise { follow } else { follow_quickly };
    let done = follow(ask.law, ask.end, g[0], g[1], g[2]);
    [done.tau, done.speed, turn(g) * done.sweep]
}

/// `tan(alpha) eta`.
fn turn(g: [f64; 3]) -> f64 {
    libm::sqrt(g[0] * g[1])
}

/// Well below the smallest eccentricity of soft contacts the fit sees that eccentricity.
fn extended(ask: &Ask, [kappa, eta, c_dis]: [f64; 3]) -> [f64; 3] {
    let least = ask.domain.sin_min * ask.domain.sin_min * eta * 0.2;
    [if eta > 0.4 && kappa < least { least } else { kappa }, eta, c_dis]
}

/// Does the third column hold the angle itself?
fn direct(ask: &Ask, cube: &Cube) -> bool {
    ask.frame.wide && ask.law == Law::LinearDashpot && cube.low[1] > DIRECT
}
