//! Which runs does a sweep file ask for, and what exactly is run number k? Reads TOML; writes nothing, returns checked scenarios.

use super::table::Source;
use crate::columns::{Cell, Column, Kind};
use crate::scenario::{MethodName, Scenario};
use anyhow::{Context, Result, anyhow, bail};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// A sweep that can be run: every one of its runs has been checked.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The files that say it, which identify it.
    pub source: Source,
    axes: Vec<Axis>,
    methods: Vec<MethodName>,
    scenario: Table,
    /// Where the scenario's own files are.
    folder: PathBuf,
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

/// More runs than this are taken for a mistake.
const MAX_RUNS: usize = 10_000_000;

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
        let folder = scenario.parent().unwrap_or(Path::new("")).to_owned();
        Self::new(sweep, &spec, text, folder).with_context(|| name.to_string())
    }

    fn new(sweep: String, spec: &Spec, text: String, folder: PathBuf) -> Result<Self> {
        let scenario: Table = toml::from_str(&text)
            .map_err(|why| anyhow!("{}: {}", spec.scenario, line(&text, &why)))?;
        let axes = spec.axes(&scenario)?;
        let methods = match &spec.methods {
            Some(methods) if methods.is_empty() => bail!("methods is empty, must name at least 1"),
            Some(methods) => methods.clone(),
            None => Scenario::parse_in(&text, &folder)
                .with_context(|| spec.scenario.clone())?
                .chosen_methods(),
        };
        let runs = axes.iter().try_fold(methods.len(), |n, axis| n.checked_mul(axis.points.len()));
        let Some(runs) = runs.filter(|&runs| runs <= MAX_RUNS) else {
            bail!("there are more than {MAX_RUNS} runs; split the sweep");
        };
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let source = Source { sweep, scenario: text, version, runs };
        let plan = Self { source, axes, methods, scenario, folder };
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
        let text = toml::to_string(&table)?;
        Scenario::parse_in(&text, &self.folder).map_err(nameless)?.with_method(method)
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

/// A sweep as its file says it. The runs are every row of `list` with every point of `grid`, every
/// seed and every method; the last of these changes fastest.
///
/// ```toml
/// scenario = "gas.toml"                 # beside the sweep file
/// methods = ["emd", "emd*"]             # those of the scenario if left out
/// seeds = { from = 1, count = 100 }     # or a list; sets every seed of the scenario
/// [grid]                                # any fields of the scenario
/// gas.packing_fraction = [0.01, 0.02, 0.05]
/// law.dissipation = { from = 1e-5, to = 1e-3, count = 5, scale = "log" }
/// [[list]]                              # fields that change together
/// gas.count = 100
/// duration = 2.0
/// ```
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spec {
    /// The scenario file, relative to the sweep file.
    pub scenario: String,
    /// Which methods run.
    pub methods: Option<Vec<crate::scenario::MethodName>>,
    /// Values of `gas.seed`, if there is a gas, and of `seed`, if there are species or something drives them.
    seeds: Option<Value>,
    #[serde(default)]
    grid: Table,
    #[serde(default)]
    list: Vec<Table>,
}

/// One field, or several that change together, and what is set in them one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The fields, as dotted paths.
    pub paths: Vec<String>,
    /// A value for each of them, many times.
    pub points: Vec<Vec<Value>>,
}

/// Evenly spaced values.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Range {
    from: Value,
    to: Option<f64>,
    count: u32,
    #[serde(default)]
    scale: Scale,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Scale {
    #[default]
    Linear,
    Log,
}

impl Spec {
    /// The axes, the slowest first: list, grid in the order of the paths, seeds.
    ///
    /// # Errors
    /// A line that names the field: no values, rows that differ in their fields, a field set twice.
    pub fn axes(&self, scenario: &Table) -> Result<Vec<Axis>> {
        let mut axes: Vec<Axis> = list(&self.list)?.into_iter().collect();
        let mut grid = Vec::new();
        flatten("", &self.grid, &mut grid);
        for (path, value) in grid {
            axes.push(along(&format!("grid: {path}"), &[path], value)?);
        }
        if let Some(seeds) = &self.seeds {
            axes.push(along("seeds", &seeds_of(scenario)?, seeds)?);
        }
        let mut paths: Vec<&String> = axes.iter().flat_map(|axis| &axis.paths).collect();
        paths.sort();
        match paths.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => bail!("{} is set twice, must be once in list, grid or seeds", pair[0]),
            None => Ok(axes),
        }
    }
}

/// Fields of fields as dotted paths; a table with `from` is a range of values.
fn flatten<'t>(above: &str, table: &'t Table, into: &mut Vec<(String, &'t Value)>) {
    for (key, value) in table {
        let path = if above.is_empty() { key.clone() } else { format!("{above}.{key}") };
        match value {
            Value::Table(inner) if !inner.contains_key("from") => flatten(&path, inner, into),
            _ => into.push((path, value)),
        }
    }
}

fn list(rows: &[Table]) -> Result<Option<Axis>> {
    let mut paths: Option<Vec<String>> = None;
    let mut points = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let mut fields = Vec::new();
        flatten("", row, &mut fields);
        let (names, values): (Vec<String>, Vec<Value>) =
            fields.into_iter().map(|(path, value)| (path, value.clone())).unzip();
        let first = paths.get_or_insert_with(|| names.clone());
        if *first != names || names.is_empty() {
            bail!("list: row {number} sets {names:?}, must set {first:?} as the first one does");
        }
        points.push(values);
    }
    Ok(paths.map(|paths| Axis { paths, points }))
}

/// Where a scenario says from which seed it draws.
fn seeds_of(scenario: &Table) -> Result<Vec<String>> {
    let any_of = |names: &[&str]| names.iter().any(|name| scenario.contains_key(*name));
    let places = [(any_of(&["gas"]), "gas.seed"), (any_of(&["species", "drive"]), "seed")];
    let paths = places.into_iter().filter(|(is_there, _)| *is_there);
    let paths: Vec<String> = paths.map(|(_, path)| path.to_owned()).collect();
    if paths.is_empty() {
        bail!("seeds: the scenario draws nothing at random: it has no gas, species or drive");
    }
    Ok(paths)
}

/// The same value in one field or more.
fn along(name: &str, paths: &[String], value: &Value) -> Result<Axis> {
    let values = match value {
        Value::Array(values) => values.clone(),
        Value::Table(_) => {
            let range = value.clone().try_into::<Range>();
            range.map_err(|why| anyhow!("{name}: {}", why.message()))?.values(name)?
        }
        _ => bail!("{name} is {value}, must be a list or {{ from, to, count, scale }}"),
    };
    if values.is_empty() {
        bail!("{name} has no values, must have at least 1");
    }
    let points = values.into_iter().map(|value| vec![value; paths.len()]).collect();
    Ok(Axis { paths: paths.to_vec(), points })
}

impl Range {
    /// Whole numbers, one after the other.
    fn whole(&self, name: &str, from: i64) -> Result<Vec<Value>> {
        let count = i64::from(self.count);
        if from.checked_add(count).is_none() {
            let most = i64::MAX - count;
            bail!("{name}: from is {from}, must be at most {most} with {count} values");
        }
        Ok((from..from + count).map(Value::Integer).collect())
    }

    fn values(&self, name: &str) -> Result<Vec<Value>> {
        if self.count as usize > MAX_RUNS {
            bail!("{name}: count is {}, must be at most {MAX_RUNS}; split the sweep", self.count);
        }
        let last = f64::from(self.count) - 1.0;
        let from = match (&self.from, self.to) {
            (Value::Integer(from), None) => return self.whole(name, *from),
            (Value::Integer(from), Some(_)) => *from as f64,
            (Value::Float(from), Some(_)) => *from,
            _ => bail!(
                "{name}: from is {}, must be a number, and to too unless both are whole",
                self.from
            ),
        };
        let to = self.to.unwrap_or(from);
        let value = |k: u32| {
            let part = if last > 0.0 { f64::from(k) / last } else { 0.0 };
            match self.scale {
                Scale::Linear => from + (to - from) * part,
                Scale::Log => from * (to / from).powf(part),
            }
        };
        if matches!(self.scale, Scale::Log) && !(from > 0.0 && to > 0.0) {
            bail!(
                "{name}: from is {from} and to is {to}, both must be above 0 for scale = \"log\""
            );
        }
        Ok((0..self.count).map(|k| Value::Float(value(k))).collect())
    }
}
