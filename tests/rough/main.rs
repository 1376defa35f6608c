//! Do rough grains do what rough grains do? Closed forms, conservation and gases, against published values.

mod bird;
mod cooling;
mod friction;
mod hops;
mod impact;
mod judge;
mod kept;
mod laws;
mod numbers;
mod oblique;
mod pair;
mod pair_table;
mod saved;
mod stiff;
