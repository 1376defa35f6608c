//! Does the engine keep what it promises? Conservation, symmetry, time, faults and snapshots, for all inputs.

mod conservation;
mod contact;
mod corners;
mod faults;
mod fixed;
mod gas;
mod neighbours;
mod piles;
mod plates;
mod range;
mod rest;
mod saved;
mod symmetry;
mod time;
mod unbreakable;
