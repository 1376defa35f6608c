//! What can Python do with carom? Reads scenarios; hands out worlds, arrays, tables and pictures.
//!
//! The engine runs in memory that its object owns; while it computes Python's other threads go on.

mod engine;
mod error;
mod picture;
mod scenario;
mod table;
mod value;
mod views;
mod world;

use pyo3::pymodule;

#[pymodule]
mod _carom {
    #[pymodule_export]
    use super::error::{Problem, ScenarioError, SimulationError};
    #[pymodule_export]
    use super::picture::Picture;
    #[pymodule_export]
    use super::scenario::{Scenario, schema};
    #[pymodule_export]
    use super::table::Table;
    #[pymodule_export]
    use super::world::{Samples, World};
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
