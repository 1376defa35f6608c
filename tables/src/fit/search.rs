//! How is the unit cube bisected? Reads the options of a fit; writes the tree of boxes that keeps the tolerance.

use super::check::Check;
use super::cube::Cube;
use super::options::FitOptions;
use super::tree::FittedTree;
use super::trial::Trial;
use crate::read::layout::{Branch, MAX_TERMS};

/// Bisects the unit cube until every leaf keeps the tolerance, or as an earlier search did.
pub(crate) fn fit(options: &FitOptions) -> FittedTree {
    let mut tree = FittedTree::default();
    let cube = Cube { low: [0.0; 3], size: [1.0; 3] };
    match options.bisection {
        Some(bisection) => repeat_bisection(
            options,
            cube,
            options.typical.clone(),
            &mut bisection.bytes(),
            &mut tree,
        ),
        None => search(options, cube, options.typical.clone(), 0, &mut tree),
    };
    tree
}

/// How far bisection may go; a table that would need more keeps a larger error, and its certificate says so.
const MAX_DEPTH: usize = 24;
/// How many leaves there may be.
const MAX_LEAVES: usize = 2_000;

/// Fits one box: more nodes along the slowest axis while that pays, else two halves.
fn search(
    options: &FitOptions,
    cube: Cube,
    typical: Vec<[f64; 3]>,
    depth: usize,
    tree: &mut FittedTree,
) -> i16 {
    let tolerance = options.tolerance_for(&typical);
    let checks = Check::of(options, &cube);
    let mut nodes = options.first_nodes;
    let mut trial = Trial::new(options, &cube, nodes, tolerance, &checks);
    while depth < MAX_DEPTH
        && tree.leaves.len() < MAX_LEAVES
        && !trial.is_good_enough(options, tolerance)
    {
        let axis = trial.slowest_axis();
        let hopeless =
            trial.error > options.bisect_above * tolerance || trial.count > options.terms_max;
        if hopeless || nodes[axis] + 2 > MAX_TERMS {
            tree.bisection.push((b'0' + axis as u8) as char);
            return split(cube, axis, typical, tree, |cube, typical, tree| {
                search(options, cube, typical, depth + 1, tree)
            });
        }
        nodes[axis] += 2;
        trial = Trial::new(options, &cube, nodes, tolerance, &checks);
    }
    keep(options, cube, &trial, tree)
}

/// Repeats what a search has decided; where the text breaks off the leaves have two nodes an axis.
fn repeat_bisection(
    options: &FitOptions,
    cube: Cube,
    typical: Vec<[f64; 3]>,
    bisection: &mut std::str::Bytes<'static>,
    tree: &mut FittedTree,
) -> i16 {
    let order = bisection.next().unwrap_or(b'c');
    if (b'0'..=b'2').contains(&order) {
        tree.bisection.push(order as char);
        return split(cube, (order - b'0') as usize, typical, tree, |cube, typical, tree| {
            repeat_bisection(options, cube, typical, bisection, tree)
        });
    }
    let mut count = |letter: u8| usize::from(letter.saturating_sub(b'a')).clamp(2, MAX_TERMS);
    let nodes =
        [order, bisection.next().unwrap_or(b'c'), bisection.next().unwrap_or(b'c')].map(&mut count);
    let tolerance = options.tolerance_for(&typical);
    let trial = Trial::new(options, &cube, nodes, tolerance, &Check::of(options, &cube));
    keep(options, cube, &trial, tree)
}

/// Stores a leaf; gives its number as a branch names it.
fn keep(options: &FitOptions, cube: Cube, trial: &Trial, tree: &mut FittedTree) -> i16 {
    tree.bisection.extend(trial.columns[0].n.map(|n| (b'a' + n as u8) as char));
    tree.terms = tree.terms.max(trial.count);
    tree.cubes.push(cube);
    let leaf = tree.push_rows(&trial.columns, options.stores_direct_angle(&cube));
    tree.leaves.push(leaf);
    !(tree.leaves.len() as i16 - 1)
}

/// Bisects a box and goes on with both halves.
fn split(
    cube: Cube,
    axis: usize,
    typical: Vec<[f64; 3]>,
    tree: &mut FittedTree,
    mut go_on: impl FnMut(Cube, Vec<[f64; 3]>, &mut FittedTree) -> i16,
) -> i16 {
    let here = tree.branches.len();
    tree.branches.push(Branch { axis: axis as u8, low: 0, high: 0 });
    let lower = cube.half(axis, false);
    let (below, above) = typical.into_iter().partition(|y| lower.contains(y));
    tree.branches[here].low = go_on(lower, below, tree);
    tree.branches[here].high = go_on(cube.half(axis, true), above, tree);
    here as i16
}
