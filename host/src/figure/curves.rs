//! How are the columns of a table drawn? Reads columns and rows; writes a scene with a picture for each kind of quantity.

use super::data::{Figure, Series};
use super::draw::{self, Kind, PlotStyle, Scale};
use crate::columns::{Cell, Column, Kind as Of};
use crate::plot::Scene;
use anyhow::{Context, Result, bail};

/// A table whose columns are curves over its first one.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    columns: Vec<Column>,
    rows: Vec<Vec<Cell>>,
    /// The column of abscissae.
    x: usize,
    /// Columns of ordinates.
    y: Vec<usize>,
}

/// How curves are drawn.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// Only columns whose heads have one of these in them; all if empty.
    pub show: Vec<String>,
    /// Equal steps are equal factors, along x and y.
    pub logarithmic: [bool; 2],
    /// Over the first picture.
    pub title: String,
}

/// More pictures on a page than this are not read by anybody.
const MOST: usize = 24;

impl Curves {
    /// The curves of a table of numbers.
    ///
    /// # Errors
    /// When its first column is none of numbers, or no column is as wished.
    pub fn new(columns: Vec<Column>, rows: Vec<Vec<Cell>>, show: &[String]) -> Result<Self> {
        let first = columns.first().context("there are no columns")?;
        if first.kind == Of::Text {
            bail!("its first column, {:?}, holds words: there is nothing to draw over", first.name);
        }
        let is_wished = |head: &str| show.is_empty() || show.iter().any(|part| head.contains(part));
        let is_curve = |k: &usize| {
            let Column { name, kind } = &columns[*k];
            *k > 0 && *kind != Of::Text && !is_error(name) && name != "to [s]" && is_wished(name)
        };
        let y: Vec<usize> = (0..columns.len()).filter(is_curve).collect();
        if y.is_empty() {
            let heads: Vec<&str> = columns.iter().skip(1).map(|c| c.name.as_str()).collect();
            bail!("no column is called {}; there are: {}", show.join(" or "), heads.join(", "));
        }
        Ok(Self { columns, rows, x: 0, y })
    }

    /// One picture for each kind of quantity, two in a line.
    ///
    /// # Errors
    /// When there are too many.
    pub fn draw(&self, wishes: &Wishes) -> Result<Scene> {
        let groups = self.groups();
        if groups.len() > MOST {
            bail!("{} pictures, at most {MOST}: choose some by --show", groups.len());
        }
        let pictures = groups.iter().enumerate().map(|(k, (name, columns))| {
            let title = if k == 0 { wishes.title.as_str() } else { "" };
            self.picture(name, columns, wishes.logarithmic, title)
        });
        let pictures: Vec<Scene> = pictures.collect();
        let lines = pictures.chunks(2).map(|line| match line {
            [one, two] => draw::beside(one.clone(), two.clone()),
            _ => line[0].clone(),
        });
        lines.reduce(draw::below).context("there is nothing to draw")
    }

    /// Columns of one kind and unit, in the order of the first of each.
    fn groups(&self) -> Vec<(String, Vec<usize>)> {
        let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
        for &k in &self.y {
            let kind = kind_of(&self.columns[k].name);
            match groups.iter_mut().find(|(name, _)| *name == kind) {
                Some((_, columns)) => columns.push(k),
                None => groups.push((kind, vec![k])),
            }
        }
        groups
    }

    fn picture(&self, name: &str, columns: &[usize], logarithmic: [bool; 2], title: &str) -> Scene {
        let labels = [escaped(&self.columns[self.x].name), escaped(name)];
        let mut figure = Figure::new("table", [&*labels[0], &*labels[1]]);
        for &k in columns {
            figure = figure.with(self.series(k, logarithmic));
        }
        let scale = |logarithmic| if logarithmic { Scale::LOG } else { Scale::LINEAR };
        let style = PlotStyle::new(escaped(title))
            .scales(scale(logarithmic[0]), scale(logarithmic[1]))
            .kinds(&[if self.rows.len() > 60 { Kind::Line } else { Kind::Both }]);
        draw::draw(&figure, &style)
    }

    /// The points of a column that are there, with their errors if all have one.
    fn series(&self, column: usize, logarithmic: [bool; 2]) -> Series {
        let name = &self.columns[column].name;
        let errors = self.columns.get(column + 1).filter(|next| is_error(&next.name));
        let errors = errors.map(|_| column + 1);
        let mut series = Series::new(legend(name));
        for row in &self.rows {
            let at = |k: usize| row.get(k).and_then(number);
            let (Some(x), Some(y)) = (at(self.x), at(column)) else { continue };
            if (logarithmic[0] && !(x > 0.0)) || (logarithmic[1] && !(y > 0.0)) {
                continue;
            }
            match errors {
                Some(k) => series.push_with_error(x, y, at(k).unwrap_or(0.0)),
                None => series.push(x, y),
            }
        }
        series
    }
}

fn number(cell: &Cell) -> Option<f64> {
    match cell {
        Cell::Number(number) => Some(*number),
        Cell::Whole(number) => Some(*number as f64),
        _ => None,
    }
}

/// Whether a column holds the errors of the one before it.
fn is_error(head: &str) -> bool {
    without_unit(head).0.ends_with(" error")
}

/// The name and the unit in a head.
fn without_unit(head: &str) -> (&str, Option<&str>) {
    match head.strip_suffix(']').and_then(|head| head.rsplit_once(" [")) {
        Some((name, unit)) => (name, Some(unit)),
        None => (head, None),
    }
}

/// What a column has in common with others: its name without axis and species, and its unit.
fn kind_of(head: &str) -> String {
    let (name, unit) = without_unit(head);
    let name = name.split(" (").next().unwrap_or(name);
    let is_axes =
        |word: &str| !word.is_empty() && word.len() < 3 && word.chars().all(|c| "xyz".contains(c));
    let name = match name.rsplit_once(' ') {
        Some((rest, word)) if is_axes(word) => rest,
        _ => name,
    };
    unit.map_or_else(|| name.to_owned(), |unit| format!("{name} [{unit}]"))
}

/// A head without its unit, which stands along the axis.
fn legend(head: &str) -> String {
    without_unit(head).0.to_owned()
}

/// Asterisks and underscores are letters here.
fn escaped(text: &str) -> String {
    text.replace('*', "∗").replace('_', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_a_kind_share_a_picture() {
        for (head, kind) in [
            ("temperature [J]", "temperature [J]"),
            ("temperature x [J]", "temperature [J]"),
            ("temperature y (species 1) [J]", "temperature [J]"),
            ("stress xx [N/m]", "stress [N/m]"),
            ("g (species 0 - species 1)", "g"),
            ("kinetic_energy", "kinetic_energy"),
        ] {
            assert_eq!(kind_of(head), kind);
        }
        assert!(
            is_error("temperature error [J]")
                && is_error("g error")
                && !is_error("error rate [1/s]")
        );
    }
}
