//! Does the engine keep what it promises? Conservation, symmetry, time, errors and snapshots, for all inputs.

mod advance;
mod asked;
mod conservation;
mod contact;
mod corners;
mod errors;
mod fixed;
mod gas;
mod gravity;
mod interruption;
mod landing;
mod neighbours;
mod piles;
mod plates;
mod range;
mod rest;
mod restored;
mod robustness;
mod scales;
mod serialised;
mod simultaneous;
mod snapshot;
mod symmetry;
mod time;
mod turn;
