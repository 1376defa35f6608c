//! What does `carom` offer on a workstation? Reads scenarios and cases; writes trajectories, tables and pictures.
//!
//! The library behind the program `carom`: the same scenario by several methods, the reference MD among
//! them (`carom-reference`), the papers' figures, and the pictures. Everything the program does can be
//! reached from here, which is how the tests reach it. With `default-features = false` it is the
//! library alone, without command line, progress bars, figures and heaps.

pub mod any_rule;
#[cfg(feature = "figures")]
pub mod bench;
#[cfg(feature = "cli")]
pub mod cli;
pub mod collide;
pub mod columns;
#[cfg(feature = "cli")]
pub mod commands;
pub mod compare;
pub mod divergence;
pub mod drive;
pub mod figure;
pub mod growing;
#[cfg(feature = "figures")]
pub mod heaps;
pub mod impacts;
pub mod integrated;
pub mod interrupt;
pub mod machine;
pub mod measure;
pub mod method;
pub mod observe;
pub mod output;
pub mod parameter_space;
pub mod plot;
pub mod progress;
pub mod report;
mod rows;
pub mod run;
pub mod scale;
pub mod scenario;
pub mod session;
pub mod sweep;
pub mod tables;

/// The examples of README.md and docs/guide, compiled and run with the documentation tests.
#[cfg(doctest)]
mod guide {
    #[doc = include_str!("../../README.md")]
    mod readme {}
    #[doc = include_str!("../../docs/guide/exactness.md")]
    mod exactness {}
    #[doc = include_str!("../../docs/guide/speed.md")]
    mod speed {}
    #[doc = include_str!("../../docs/guide/tables.md")]
    mod tables {}
    #[doc = include_str!("../../docs/guide/fixed-point.md")]
    mod fixed_point {}
    #[doc = include_str!("../../docs/guide/firmware.md")]
    mod firmware {}
    #[doc = include_str!("../../docs/guide/plates-and-rest.md")]
    mod plates_and_rest {}
    #[doc = include_str!("../../docs/guide/friction.md")]
    mod friction {}
    #[doc = include_str!("../../docs/guide/obstacles.md")]
    mod obstacles {}
    #[cfg(feature = "figures")]
    #[doc = include_str!("../../docs/guide/program.md")]
    mod program {}
}
