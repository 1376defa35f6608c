//! Which exception is an error? Reads an error of the host; returns a Python exception with the same words.

use anyhow::Error;
use carom_host::scenario::{self, Found};
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::io;

create_exception!(
    carom,
    ScenarioError,
    PyValueError,
    "A scenario that cannot be. `problems` has all that is wrong with it."
);
create_exception!(
    carom,
    SimulationError,
    PyRuntimeError,
    "A run that cannot go on, or cannot do what it was asked."
);

/// One thing that is wrong with a scenario.
#[pyclass(frozen, get_all, module = "carom")]
#[derive(Clone, Debug)]
pub struct Problem {
    /// The field, as in `grain.3.radius`; empty if it is all of the scenario.
    pub field: String,
    /// What is wrong, and what would be right.
    pub message: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1.
    pub column: usize,
}

#[pymethods]
impl Problem {
    fn __repr__(&self) -> String {
        format!("Problem(line {}, column {}: {})", self.line, self.column, self.message)
    }

    fn __str__(&self) -> &str {
        &self.message
    }
}

/// All problems that were found.
pub fn problems(found: &Found) -> Vec<Problem> {
    let problem = |((line, column), problem): &((usize, usize), scenario::Problem)| Problem {
        field: problem.path.clone(),
        message: problem.message.clone(),
        line: *line,
        column: *column,
    };
    found.iter().map(problem).collect()
}

/// A scenario is refused, in these words.
pub fn refused(py: Python<'_>, words: String, problems: Vec<Problem>) -> PyErr {
    let error = ScenarioError::new_err(words);
    match error.value(py).setattr("problems", problems) {
        Ok(()) => error,
        Err(other) => other,
    }
}

/// An error of a scenario, or of a file that it names.
pub fn of_scenario(py: Python<'_>, error: Error) -> PyErr {
    file_error(&error).unwrap_or_else(|| {
        let found = error.downcast_ref::<scenario::Problem>().map(|problem| Problem {
            field: problem.path.clone(),
            message: problem.message.clone(),
            line: 0,
            column: 0,
        });
        refused(py, format!("{error:#}"), found.into_iter().collect())
    })
}

/// An error of a run: an exception that was raised meanwhile is that one.
pub fn of_run(error: Error) -> PyErr {
    match error.downcast::<PyErr>() {
        Ok(raised) => raised,
        Err(error) => {
            file_error(&error).unwrap_or_else(|| SimulationError::new_err(format!("{error:#}")))
        }
    }
}

/// An error of a file: FileNotFoundError, PermissionError and the like.
fn file_error(error: &Error) -> Option<PyErr> {
    let kind = error.chain().find_map(|cause| cause.downcast_ref::<io::Error>())?.kind();
    Some(io::Error::new(kind, format!("{error:#}")).into())
}
