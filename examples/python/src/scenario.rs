//! How does Python say what is to be simulated? Reads TOML text, a file or a dictionary; keeps a checked scenario.

use super::error::{Problem, of_scenario, problems, refused};
use super::value;
use carom_host::scenario::{self, Found, MethodName};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is to be simulated: the fields of a scenario file, checked.
///
/// Files that it names are looked for in `folder`.
#[pyclass(frozen, module = "carom")]
pub struct Scenario {
    /// The scenario.
    pub checked: Arc<scenario::Scenario>,
    text: String,
}

impl Scenario {
    /// Checks a text; `words` says what is wrong with it.
    fn checked(
        py: Python<'_>,
        text: String,
        folder: &Path,
        words: impl FnOnce(&Found) -> String,
    ) -> PyResult<Self> {
        match py.detach(|| scenario::examine(&text, folder)) {
            (Some(checked), found) if found.is_empty() => {
                Ok(Self { checked: Arc::new(checked), text })
            }
            (_, found) => Err(refused(py, words(&found), problems(&found))),
        }
    }
}

/// The first problem, and how many more there are.
fn first(found: &Found, with_line: bool) -> String {
    let Some(((line, _), problem)) = found.first() else { return "this is no scenario".to_owned() };
    let place = if with_line { format!("line {line}: ") } else { String::new() };
    let more = match found.len() - 1 {
        0 => String::new(),
        more => format!(" ({more} more)"),
    };
    format!("{place}{problem}{more}")
}

#[pymethods]
impl Scenario {
    #[new]
    #[pyo3(signature = (text, folder=PathBuf::new()))]
    pub fn new(py: Python<'_>, text: String, folder: PathBuf) -> PyResult<Self> {
        Self::checked(py, text, &folder, |found| first(found, true))
    }

    /// Reads a scenario file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let name = path.display();
        let text = std::fs::read_to_string(&path).map_err(|why| {
            of_scenario(py, anyhow::Error::new(why).context(format!("cannot read {name}")))
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::checked(py, text, folder, |found| format!("{name}: {}", first(found, true)))
    }

    /// The scenario of a dictionary, with the keys that a file has.
    #[staticmethod]
    #[pyo3(signature = (fields, folder=PathBuf::new()))]
    fn from_dict(py: Python<'_>, fields: &Bound<'_, PyDict>, folder: PathBuf) -> PyResult<Self> {
        let table = value::table(fields, "")?;
        let text = toml::to_string(&table).map_err(|e| PyValueError::new_err(e.to_string()))?;
        Self::checked(py, text, &folder, |found| first(found, false))
    }

    /// All that is wrong with a text; nothing if it is a scenario.
    #[staticmethod]
    #[pyo3(signature = (text, folder=PathBuf::new()))]
    fn check(text: &str, folder: PathBuf) -> Vec<Problem> {
        problems(&scenario::examine(text, &folder).1)
    }

    /// The scenario as a file says it.
    #[getter]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Where files are looked for that it names.
    #[getter]
    pub fn folder(&self) -> PathBuf {
        self.checked.folder.clone()
    }

    /// One line about it.
    #[getter]
    fn title(&self) -> &str {
        &self.checked.title
    }

    /// 1, 2 or 3.
    #[getter]
    fn dimension(&self) -> usize {
        self.checked.dimension
    }

    /// How long it runs (s), if it says so.
    #[getter]
    fn duration(&self) -> Option<f64> {
        self.checked.duration
    }

    /// Time between two samples (s).
    #[getter]
    fn sample(&self) -> f64 {
        self.checked.sample
    }

    /// The methods that `carom run` would run.
    #[getter]
    fn methods(&self) -> Vec<&'static str> {
        self.checked.chosen_methods().into_iter().map(name_of).collect()
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String, PathBuf))> {
        let this = slf.get();
        Ok((slf.get_type().into_any(), (this.text.clone(), this.folder())))
    }

    fn __repr__(&self) -> String {
        format!("<carom.Scenario {:?}, {} dimensions>", self.checked.title, self.checked.dimension)
    }

    fn _repr_html_(&self) -> String {
        let text = self.text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!("<pre>{text}</pre>")
    }
}

/// JSON Schema of a scenario, as a dictionary.
#[pyfunction]
pub fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let text = scenario::schema().to_string();
    py.import("json")?.call_method1("loads", (text,))
}

/// A method as scenarios write it.
pub const fn name_of(method: MethodName) -> &'static str {
    match method {
        MethodName::Md => "md",
        MethodName::Exact => "md-exact",
        MethodName::Emd => "emd",
        MethodName::EmdStar => "emd*",
    }
}

/// The method of this name.
pub fn method(name: &str) -> PyResult<MethodName> {
    let all = [MethodName::Md, MethodName::Exact, MethodName::Emd, MethodName::EmdStar];
    all.into_iter().find(|method| name_of(*method) == name).ok_or_else(|| {
        PyValueError::new_err(format!("method is {name:?}, must be md, md-exact, emd or emd*"))
    })
}
