//! What are the data of a figure? Reads numbers; writes nothing, keeps them in the form that `--json` prints.

use crate::plot::Scene;
use anyhow::{Result, ensure};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The data of a figure.
///
/// ```
/// use carom_host::figure::{Figure, Series};
/// let figure = Figure::new("l94-1", ["t", "z"])
///     .with(Series::new("ED").param("method", "ED").param("eps", 0.9).point(0.0, 1.0));
/// let json = serde_json::to_string(&figure)?;
/// assert_eq!(
///     json,
///     r#"{"id":"l94-1","axes":{"x":"t","y":"z"},"series":[{"name":"ED","params":{"eps":0.9,"method":"ED"},"x":[0.0],"y":[1.0],"yerr":[]}]}"#
/// );
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figure {
    /// Its name: paper and number.
    pub id: String,
    /// What stands along the axes, with units.
    pub axes: Axes,
    /// The curves.
    pub series: Vec<Series>,
}

/// What stands along the axes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axes {
    /// From left to right.
    pub x: String,
    /// From bottom to top.
    pub y: String,
}

/// One curve.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Series {
    /// What it is called in the legend.
    pub name: String,
    /// The parameters that make it differ from the others: `method`, `eps`, …
    pub params: BTreeMap<String, Value>,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates, one for each abscissa.
    pub y: Vec<f64>,
    /// Standard errors of the ordinates, one for each; empty where there are none.
    pub yerr: Vec<f64>,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word.
    Text(String),
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl Figure {
    /// A figure without curves.
    pub fn new(id: &str, [x, y]: [&str; 2]) -> Self {
        let axes = Axes { x: x.to_owned(), y: y.to_owned() };
        Self { id: id.to_owned(), axes, series: Vec::new() }
    }

    /// One more curve.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// The curve whose parameters have these values.
    pub fn find(&self, params: &[(&str, Value)]) -> Option<&Series> {
        let has =
            |s: &Series| params.iter().all(|(name, value)| s.params.get(*name) == Some(value));
        self.series.iter().find(|series| has(series))
    }

    /// Checks what JSON and pictures rely on.
    ///
    /// # Errors
    /// A list that is longer than another of its series, or a number that is not finite.
    pub fn check(&self) -> Result<()> {
        for Series { name, x, y, yerr, .. } in &self.series {
            let [nx, ny, ne] = [x.len(), y.len(), yerr.len()];
            ensure!(
                nx == ny && (ne == 0 || ne == ny),
                "{}: series {name:?} has {nx} x, {ny} y, {ne} yerr",
                self.id
            );
            let bad = [x, y, yerr].into_iter().flatten().find(|value| !value.is_finite());
            ensure!(bad.is_none(), "{}: series {name:?} holds {bad:?}", self.id);
        }
        Ok(())
    }
}

impl Series {
    /// A curve without points.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// One more parameter.
    #[must_use]
    pub fn param(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.params.insert(name.to_owned(), value.into());
        self
    }

    /// One more point without an error bar.
    #[must_use]
    pub fn point(mut self, x: f64, y: f64) -> Self {
        self.push(x, y);
        self
    }

    /// Adds a point without an error bar.
    pub fn push(&mut self, x: f64, y: f64) {
        self.x.push(x);
        self.y.push(y);
    }

    /// Adds a point with its standard error.
    pub fn push_with_error(&mut self, x: f64, y: f64, error: f64) {
        self.push(x, y);
        self.yerr.push(error);
    }
}

/// How a figure is to be made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// With more statistics, up to the paper's, however long that takes; otherwise in under two minutes.
    pub full: bool,
}

/// What the paper says and what we get.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Of what.
    pub what: String,
    /// What the paper says, or "not given".
    pub paper: String,
    /// What a formula says that carom evaluates; empty where there is none.
    pub theory: String,
    /// What we get.
    pub ours: String,
}

impl Note {
    /// One line of the comparison.
    pub fn new(what: impl Into<String>, paper: impl Into<String>, ours: impl Into<String>) -> Self {
        let theory = String::new();
        Self { what: what.into(), paper: paper.into(), theory, ours: ours.into() }
    }

    /// The same with what a formula says.
    #[must_use]
    pub fn theory(self, theory: impl Into<String>) -> Self {
        Self { theory: theory.into(), ..self }
    }
}

/// A figure that was made.
#[derive(Clone, Debug)]
pub struct Made {
    /// Its data.
    pub figure: Figure,
    /// Its picture.
    pub picture: Scene,
    /// The comparison with the paper.
    pub notes: Vec<Note>,
}

/// A figure that can be made.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name: paper and number.
    pub id: &'static str,
    /// What it shows, in one line.
    pub what: &'static str,
    /// Makes it.
    pub make: fn(&Options) -> Result<Made>,
    /// What its page says around the tables.
    pub text: &'static str,
}
