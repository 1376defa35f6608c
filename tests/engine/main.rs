//! Does the engine keep what it promises? Conservation, symmetry, time, errors and snapshots, for all inputs.

mod advance;
mod clusters;
mod conservation;
mod contact;
mod corners;
mod errors;
mod fixed;
mod gas;
mod heaps;
mod neighbours;
mod piles;
mod plates;
mod range;
mod rest;
mod robustness;
mod scales;
mod serialised;
mod snapshot;
mod symmetry;
mod time;
