//! Which sparse Chebyshev expansions reproduce a contact law? Reads the options of a fit; writes a tree of boxes with coefficients.

mod check;
mod column;
pub(crate) mod cube;
mod exact;
pub(crate) mod history;
pub(crate) mod options;
pub(crate) mod search;
pub(crate) mod tree;
mod trial;
