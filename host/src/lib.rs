//! What does `carom` offer on a workstation? Reads scenarios and cases; writes trajectories, tables and pictures.
//!
//! The library behind the program `carom`: the reference force-based molecular dynamics, the same
//! scenario by several methods, and the pictures. Everything the program does can be reached from
//! here, which is how the tests reach it.

pub mod bench;
pub mod cli;
pub mod collide;
pub mod commands;
pub mod compare;
pub mod divergence;
pub mod figure;
pub mod integrated;
pub mod method;
pub mod output;
pub mod plot;
pub mod progress;
pub mod report;
pub mod run;
pub mod scale;
pub mod scenario;
pub mod storage;
pub mod sweep;
pub mod tables;
