//! Which runs does a sweep file ask for? Reads TOML; writes nothing, returns axes of values.

use anyhow::{Result, anyhow, bail};
use serde::Deserialize;
use toml::{Table, Value};

/// A sweep as its file says it. The runs are every row of `list` with every point of `grid`, every
/// seed and every method; the last of these changes fastest.
///
/// ```toml
/// scenario = "gas.toml"                 # beside the sweep file
/// methods = ["emd", "emd*"]             # those of the scenario if left out
/// seeds = { from = 1, count = 100 }     # or a list; sets gas.seed
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
    /// Values of `gas.seed`.
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
    pub fn axes(&self) -> Result<Vec<Axis>> {
        let mut axes: Vec<Axis> = list(&self.list)?.into_iter().collect();
        let mut grid = Vec::new();
        flatten("", &self.grid, &mut grid);
        for (path, value) in grid {
            axes.push(along(&format!("grid: {path}"), &path, value)?);
        }
        if let Some(seeds) = &self.seeds {
            axes.push(along("seeds", "gas.seed", seeds)?);
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

fn along(name: &str, path: &str, value: &Value) -> Result<Axis> {
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
    let points = values.into_iter().map(|value| vec![value]).collect();
    Ok(Axis { paths: vec![path.to_owned()], points })
}

impl Range {
    fn values(&self, name: &str) -> Result<Vec<Value>> {
        let last = f64::from(self.count) - 1.0;
        let from = match (&self.from, self.to) {
            (Value::Integer(from), None) => {
                return Ok((0..i64::from(self.count)).map(|k| Value::Integer(from + k)).collect());
            }
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
