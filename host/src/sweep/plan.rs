//! What exactly is run number k? Reads a sweep file and its scenario; writes nothing, returns checked scenarios.

use super::spec::{Axis, Spec};
use super::table::{Cell, Column, Kind};
use crate::scenario::{MethodName, Scenario};
use anyhow::{Context, Result, anyhow, bail};
use std::path::Path;
use toml::{Table, Value};

/// A sweep that can be run: every one of its runs has been checked.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The files that say it, which identify it.
    pub source: Source,
    axes: Vec<Axis>,
    methods: Vec<MethodName>,
    scenario: Table,
}

/// Where a sweep comes from: two results belong together only if all of this is the same.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Source {
    /// The text of the sweep file.
    pub sweep: String,
    /// The text of the scenario file.
    pub scenario: String,
    /// The version of this program.
    pub version: String,
    /// How many runs there are.
    pub runs: usize,
}

/// One run.
#[derive(Clone, Debug)]
pub struct Run {
    /// What is simulated.
    pub scenario: Scenario,
    /// By which method.
    pub method: MethodName,
    /// What was set for this run: a cell for each of [`Plan::columns`].
    pub cells: Vec<Cell>,
}

/// More runs than this are a slip of the pen.
const MOST: usize = 10_000_000;

impl Plan {
    /// Reads a sweep file and its scenario, and checks every run.
    ///
    /// # Errors
    /// One line that names the file, and the run and its field if it is one run that cannot be.
    pub fn read(file: &Path) -> Result<Self> {
        let name = file.display();
        let sweep = read(file)?;
        let spec: Spec =
            toml::from_str(&sweep).map_err(|why| anyhow!("{name}: {}", line(&sweep, &why)))?;
        let scenario = file.parent().unwrap_or(Path::new("")).join(&spec.scenario);
        let text = read(&scenario)?;
        Self::new(sweep, &spec, text).with_context(|| name.to_string())
    }

    fn new(sweep: String, spec: &Spec, text: String) -> Result<Self> {
        let scenario: Table = toml::from_str(&text)
            .map_err(|why| anyhow!("{}: {}", spec.scenario, line(&text, &why)))?;
        let axes = spec.axes()?;
        let methods = match &spec.methods {
            Some(methods) if methods.is_empty() => bail!("methods is empty, must name at least 1"),
            Some(methods) => methods.clone(),
            None => Scenario::parse(&text).with_context(|| spec.scenario.clone())?.chosen_methods(),
        };
        let runs = axes.iter().try_fold(methods.len(), |n, axis| n.checked_mul(axis.points.len()));
        let Some(runs) = runs.filter(|&runs| runs <= MOST) else {
            bail!("there are more than {MOST} runs; split the sweep");
        };
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let source = Source { sweep, scenario: text, version, runs };
        let plan = Self { source, axes, methods, scenario };
        (0..runs).try_for_each(|number| plan.run(number).map(drop))?;
        Ok(plan)
    }

    /// The columns that say which run a row is: its method and every field that was set.
    pub fn columns(&self) -> Vec<Column> {
        let method = Column { name: "method".to_owned(), kind: Kind::Text };
        let swept = self.axes.iter().flat_map(|axis| {
            axis.paths.iter().enumerate().map(|(place, path)| {
                let kinds = axis.points.iter().map(|point| Cell::from(&point[place]).kind());
                Column { name: path.clone(), kind: kinds.reduce(Kind::both).unwrap_or(Kind::Text) }
            })
        });
        std::iter::once(method).chain(swept).collect()
    }

    /// Run number `number`, counted from 0.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn run(&self, number: usize) -> Result<Run> {
        let method = self.methods[number % self.methods.len()];
        let mut rest = number / self.methods.len();
        let mut values = Vec::new();
        for axis in self.axes.iter().rev() {
            let point = &axis.points[rest % axis.points.len()];
            rest /= axis.points.len();
            values.extend(axis.paths.iter().zip(point).rev());
        }
        values.reverse();
        let scenario = self.scenario(&values, method).with_context(|| named(number, &values))?;
        let cells = values.iter().map(|(_, value)| Cell::from(*value));
        let method_cell = Cell::Text(method.file_stem().to_owned());
        Ok(Run { scenario, method, cells: std::iter::once(method_cell).chain(cells).collect() })
    }

    fn scenario(&self, values: &[(&String, &Value)], method: MethodName) -> Result<Scenario> {
        let mut table = Value::Table(self.scenario.clone());
        for (path, value) in values {
            set(&mut table, path, (*value).clone())?;
        }
        // The lines of this text are nobody's.
        let nameless = |why: anyhow::Error| {
            let text = format!("{why:#}");
            match text.split_once(": ") {
                Some((place, message)) if place.starts_with("line ") => anyhow!("{message}"),
                _ => anyhow!(text),
            }
        };
        Scenario::parse(&toml::to_string(&table)?).map_err(nameless)?.with_method(method)
    }
}

fn read(file: &Path) -> Result<String> {
    std::fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))
}

fn line(text: &str, why: &toml::de::Error) -> String {
    let line = why.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
    format!("line {line}: {}", why.message().replace('\n', ", "))
}

fn named(number: usize, values: &[(&String, &Value)]) -> String {
    let fields: Vec<String> =
        values.iter().map(|(path, value)| format!("{path} = {value}")).collect();
    format!("run {number} ({})", fields.join(", "))
}

/// Sets a field by its dotted path; a number in it counts the entries of a list from 0.
fn set(root: &mut Value, path: &str, value: Value) -> Result<()> {
    let mut place = root;
    for key in path.split('.') {
        place = match place {
            Value::Table(table) => table.entry(key).or_insert_with(|| Value::Table(Table::new())),
            Value::Array(list) => {
                let count = list.len();
                let entry = key.parse().ok().and_then(|number: usize| list.get_mut(number));
                entry.with_context(|| {
                    format!(
                        "{path}: {key} must be from 0 to {}, the entries of the list",
                        count.saturating_sub(1)
                    )
                })?
            }
            _ => bail!("{path}: there are no fields above {key}"),
        };
    }
    *place = value;
    Ok(())
}
