//! How does a dictionary become a scenario, and counts a dictionary? Reads Python's values, returns those of TOML; or the other way.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyString};
use toml::{Table, Value};

/// The table of a dictionary; what is None is left out.
pub fn table(dictionary: &Bound<'_, PyDict>, path: &str) -> PyResult<Table> {
    let mut table = Table::new();
    for (key, item) in dictionary {
        let key: String = key
            .extract()
            .map_err(|_| PyTypeError::new_err(format!("{}: keys must be words", named(path))))?;
        let below = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        if !item.is_none() {
            table.insert(key, value(&item, &below)?);
        }
    }
    Ok(table)
}

fn value(item: &Bound<'_, PyAny>, path: &str) -> PyResult<Value> {
    if item.is_instance_of::<PyBool>() {
        return item.extract().map(Value::Boolean);
    }
    if item.is_instance_of::<PyInt>() {
        let too_large = |_| PyValueError::new_err(format!("{path} is {item}, which is too large"));
        return item.extract().map(Value::Integer).map_err(too_large);
    }
    if item.is_instance_of::<PyFloat>() {
        return item.extract().map(Value::Float);
    }
    if item.is_instance_of::<PyString>() {
        return item.extract().map(Value::String);
    }
    if let Ok(dictionary) = item.cast::<PyDict>() {
        return table(dictionary, path).map(Value::Table);
    }
    others(item, path)
}

/// numpy's numbers and arrays, paths, and whatever else has items.
fn others(item: &Bound<'_, PyAny>, path: &str) -> PyResult<Value> {
    if item.hasattr("tolist")? {
        return value(&item.call_method0("tolist")?, path);
    }
    if item.hasattr("__fspath__")? {
        return item.call_method0("__fspath__")?.extract().map(Value::String);
    }
    let Ok(items) = item.try_iter() else {
        let kind = item.get_type();
        let kind = kind.name()?;
        return Err(PyTypeError::new_err(format!(
            "{path} is a {kind}, must be a number, a word, a list or a dictionary"
        )));
    };
    let list = items.enumerate().map(|(k, item)| value(&item?, &format!("{path}.{k}")));
    list.collect::<PyResult<Vec<Value>>>().map(Value::Array)
}

fn named(path: &str) -> &str {
    if path.is_empty() { "the scenario" } else { path }
}

/// Numbers by their names.
pub fn dictionary<'py, N: for<'a> IntoPyObject<'a>>(
    py: Python<'py>,
    entries: Vec<(&'static str, N)>,
) -> PyResult<Bound<'py, PyDict>> {
    let dictionary = PyDict::new(py);
    for (name, number) in entries {
        dictionary.set_item(name, number)?;
    }
    Ok(dictionary)
}
