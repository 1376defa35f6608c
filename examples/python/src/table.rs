//! How does Python read a table? Reads cells under columns; returns arrays, frames of pandas and polars, HTML, pictures.

use super::error::SimulationError;
use super::picture::Picture;
use carom_host::columns::{Cell, Kind};
use carom_host::figure::curves::{Curves, Wishes};
use carom_host::method::LoggedEvent;
use carom_host::observe;
use numpy::PyArray1;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Columns, whose heads have units, and rows.
#[pyclass(frozen, mapping, module = "carom")]
pub struct Table(observe::Table);

impl Table {
    /// This table.
    pub const fn new(table: observe::Table) -> Self {
        Self(table)
    }

    /// Numbers as an array, NaN where there is none; words as a list.
    fn column<'py>(&self, py: Python<'py>, number: usize) -> PyResult<Bound<'py, PyAny>> {
        let cells = self.0.rows.iter().filter_map(|row| row.get(number));
        if self.0.columns.get(number).is_some_and(|column| column.kind == Kind::Text) {
            let words = |cell: &Cell| match cell {
                Cell::Text(text) => Some(text.clone()),
                _ => None,
            };
            return cells.map(words).collect::<Vec<_>>().into_pyobject(py);
        }
        let numbers = cells.map(|cell| match cell {
            Cell::Number(number) => *number,
            Cell::Whole(number) => *number as f64,
            _ => f64::NAN,
        });
        Ok(PyArray1::from_iter(py, numbers).into_any())
    }

    fn frame<'py>(&self, py: Python<'py>, library: &str) -> PyResult<Bound<'py, PyAny>> {
        let options = PyDict::new(py);
        if library == "polars" {
            options.set_item("nan_to_null", true)?;
        }
        let frame = py.import(library)?.getattr("DataFrame")?;
        frame.call((self.to_dict(py)?,), Some(&options))
    }
}

/// More rows than this a notebook does not show.
const SHOWN: usize = 30;

#[pymethods]
impl Table {
    /// What it is.
    #[getter]
    fn name(&self) -> &'static str {
        self.0.name
    }

    /// The heads of its columns, with units.
    #[getter]
    fn columns(&self) -> Vec<&str> {
        self.0.columns.iter().map(|column| column.name.as_str()).collect()
    }

    /// Each column under its head: an array of numbers, or a list of words.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dictionary = PyDict::new(py);
        for (number, column) in self.0.columns.iter().enumerate() {
            dictionary.set_item(&column.name, self.column(py, number)?)?;
        }
        Ok(dictionary)
    }

    /// As a frame of pandas, which must be installed.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "pandas")
    }

    /// As a frame of polars, which must be installed.
    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "polars")
    }

    /// Curves over the first column, those whose heads have one of these words in them; with logarithmic axes
    /// "x", "y" or "xy".
    #[pyo3(signature = (show=Vec::new(), *, log=""))]
    fn plot(&self, show: Vec<String>, log: &str) -> PyResult<Picture> {
        if !["", "x", "y", "xy"].contains(&log) {
            return Err(PyValueError::new_err(format!("log is {log:?}, must be x, y or xy")));
        }
        let logarithmic = ["x", "y"].map(|axis| log.contains(axis));
        let (columns, rows) = (self.0.columns.clone(), self.0.rows.clone());
        let wishes = Wishes { show, logarithmic, title: self.0.name.replace('-', " ") };
        let scene = Curves::new(columns, rows, &wishes.show).and_then(|c| c.draw(&wishes));
        scene.map(Picture::new).map_err(|error| PyValueError::new_err(format!("{error:#}")))
    }

    fn __len__(&self) -> usize {
        self.0.rows.len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, head: &str) -> PyResult<Bound<'py, PyAny>> {
        let place = self.0.columns.iter().position(|column| column.name == head);
        let heads = || self.columns().join(", ");
        let number = place.ok_or_else(|| {
            PyKeyError::new_err(format!("no column is called {head:?}; there are: {}", heads()))
        })?;
        self.column(py, number)
    }

    fn _repr_html_(&self) -> String {
        let row = |tag: &str, cells: Vec<String>| {
            let cells = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell)));
            format!("<tr>{}</tr>", cells.collect::<String>())
        };
        let heads = row("th", self.columns().into_iter().map(str::to_owned).collect());
        let rows = self.0.rows.iter().take(SHOWN);
        let rows: String = rows.map(|cells| row("td", cells.iter().map(short).collect())).collect();
        let more = match self.0.rows.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("<p>… {more} more rows</p>"),
        };
        format!("<table><thead>{heads}</thead><tbody>{rows}</tbody></table>{more}")
    }

    fn __repr__(&self) -> String {
        format!(
            "<carom.Table {}: {} rows of {}>",
            self.0.name,
            self.0.rows.len(),
            self.columns().join(", ")
        )
    }
}

/// Tables by their names.
pub fn by_name(py: Python<'_>, tables: Vec<observe::Table>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    for table in tables {
        all.set_item(table.name, Py::new(py, Table::new(table))?)?;
    }
    Ok(all)
}

/// Nothing was measured yet, or nothing is to be.
pub fn nothing(is_asked: bool) -> PyErr {
    SimulationError::new_err(match is_asked {
        true => "nothing was measured yet: [observe] looks at two times at least",
        false => "nothing is measured: the scenario has no [observe]",
    })
}

/// Events as a table.
pub fn of_events(log: &[LoggedEvent]) -> Table {
    let mut table =
        observe::Table::new("events", 1, vec!["kind", "time [s]", "grain", "partner", "plane"]);
    let whole = |number: usize| Cell::Whole(number as i64);
    let row = |event: &LoggedEvent| {
        vec![
            Cell::Text(event.kind.to_owned()),
            Cell::Number(event.time),
            whole(event.grain),
            event.partner.map_or(Cell::Nothing, whole),
            event.plane.map_or(Cell::Nothing, whole),
        ]
    };
    table.rows = log.iter().map(row).collect();
    Table(table)
}

/// Six digits.
fn short(cell: &Cell) -> String {
    match cell {
        Cell::Nothing => String::new(),
        Cell::Flag(flag) => flag.to_string(),
        Cell::Whole(number) => number.to_string(),
        Cell::Text(text) => text.clone(),
        Cell::Number(number) if *number == 0.0 || (1e-3..1e6).contains(&number.abs()) => {
            let digits = (5 - number.abs().max(1e-9).log10().floor() as i32).clamp(0, 9) as usize;
            let text = format!("{number:.digits$}");
            if text.contains('.') {
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            } else {
                text
            }
        }
        Cell::Number(number) => format!("{number:.5e}"),
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
