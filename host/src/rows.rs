//! What do the rows of a CSV file say? Reads CSV; writes what each row was made into, or why it cannot be.

use anyhow::{Context, Result, anyhow, bail, ensure};
use csv::StringRecord;
use std::io::Read;
#[cfg(feature = "cli")]
use std::io::Write;

/// A row that is no case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadRow {
    /// What it calls itself; empty if that cannot be read.
    pub id: String,
    /// Its number, line, column, value and what would be right.
    pub why: String,
}

/// Reads every row of a CSV file with a header, which must have these columns, and makes something of each.
///
/// # Errors
/// A missing column, or a file that cannot be read on.
pub(crate) fn read<T>(
    source: impl Read,
    required: &[&str],
    make: impl Fn(&Row<'_>) -> Result<T>,
) -> Result<Vec<Result<T, BadRow>>> {
    let mut builder = csv::ReaderBuilder::new();
    let mut reader = builder.trim(csv::Trim::All).flexible(true).from_reader(source);
    let header = reader.headers().context("the header cannot be read")?.clone();
    for name in required {
        header.iter().find(|field| field == name).ok_or_else(|| {
            anyhow!("column `{name}` is missing; the header needs {}", required.join(","))
        })?;
    }
    let mut rows = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let number = index + 1;
        match record {
            Ok(record) => {
                let row = Row { record: &record, header: &header };
                let made = row.has_all_fields().and_then(|()| make(&row));
                rows.push(made.map_err(|why| row.bad(number, &why)));
            }
            Err(error) if error.is_io_error() => {
                return Err(error).with_context(|| format!("row {number} cannot be read"));
            }
            Err(error) => {
                let why = format!("row {number} cannot be read: {error}");
                rows.push(Err(BadRow { id: String::new(), why }));
            }
        }
    }
    Ok(rows)
}

/// Says which rows were bad; an error if any was.
#[cfg(feature = "cli")]
pub(crate) fn report(name: &str, bad: &[&BadRow], rows: usize) -> Result<()> {
    bad.iter().try_for_each(|row| writeln!(std::io::stderr(), "carom: {name}: {}", row.why))?;
    ensure!(bad.is_empty(), "{name}: {} of {rows} rows have no answer", bad.len());
    Ok(())
}

/// One row.
pub(crate) struct Row<'a> {
    record: &'a StringRecord,
    header: &'a StringRecord,
}

impl Row<'_> {
    fn has_all_fields(&self) -> Result<()> {
        let (fields, columns) = (self.record.len(), self.header.len());
        ensure!(fields == columns, "{fields} fields, but the header has {columns}");
        Ok(())
    }

    fn bad(&self, number: usize, why: &anyhow::Error) -> BadRow {
        let line = self.record.position().map_or(0, csv::Position::line);
        BadRow {
            id: self.text("id").to_owned(),
            why: format!("row {number} (line {line}): {why:#}"),
        }
    }

    /// What stands in a column; nothing if there is none.
    pub fn text(&self, column: &str) -> &str {
        let place = self.header.iter().position(|field| field == column);
        place.and_then(|place| self.record.get(place)).unwrap_or("")
    }

    /// A number that is good.
    pub fn number(&self, column: &str, wanted: &str, good: fn(f64) -> bool) -> Result<f64> {
        let text = self.text(column);
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() && good(value) => Ok(value),
            _ => bail!("column `{column}`: `{text}` is not {wanted}"),
        }
    }

    /// The same; what is left out is 0.
    pub fn number_or_zero(&self, column: &str, wanted: &str, good: fn(f64) -> bool) -> Result<f64> {
        if self.text(column).is_empty() { Ok(0.0) } else { self.number(column, wanted, good) }
    }

    pub fn positive(&self, column: &str, wanted: &str) -> Result<f64> {
        self.number(column, &format!("{wanted} greater than 0"), |x| x > 0.0)
    }

    pub fn not_negative(&self, column: &str, wanted: &str) -> Result<f64> {
        self.number(column, &format!("{wanted} of at least 0"), |x| x >= 0.0)
    }
}
