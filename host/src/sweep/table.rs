//! What does one row say, and which columns are there? Reads and writes Parquet files, always the same bytes for the same rows.

use crate::output::Draft;
use anyhow::{Context, Result, anyhow, bail};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::Field;
use parquet::schema::types::Type;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::Arc;

/// Where a sweep comes from: two results belong together only if all of this is the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

/// One number or word of a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Cell {
    /// Nothing.
    Nothing,
    /// Yes or no.
    Flag(bool),
    /// A whole number.
    Whole(i64),
    /// Any number.
    Number(f64),
    /// Words.
    Text(String),
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// Yes or no.
    Flag,
    /// Whole numbers.
    Whole,
    /// Numbers.
    Number,
    /// Words; anything else as TOML writes it.
    Text,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// What it holds.
    pub kind: Kind,
}

/// Rows under columns, and where they come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// The sweep.
    pub source: Source,
    /// Which part of it, if not all: i of n.
    pub shard: Option<[usize; 2]>,
    /// The columns.
    pub columns: Vec<Column>,
    /// A cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

impl From<&toml::Value> for Cell {
    fn from(value: &toml::Value) -> Self {
        match value {
            toml::Value::Boolean(flag) => Self::Flag(*flag),
            toml::Value::Integer(number) => Self::Whole(*number),
            toml::Value::Float(number) => Self::Number(*number),
            toml::Value::String(text) => Self::Text(text.clone()),
            other => Self::Text(other.to_string()),
        }
    }
}

impl Cell {
    /// What column it belongs in.
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Flag(_) => Kind::Flag,
            Self::Whole(_) => Kind::Whole,
            Self::Number(_) => Kind::Number,
            Self::Text(_) | Self::Nothing => Kind::Text,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Nothing => String::new(),
            Self::Flag(flag) => flag.to_string(),
            Self::Whole(number) => number.to_string(),
            Self::Number(number) => number.to_string(),
            Self::Text(text) => text.clone(),
        }
    }
}

impl Kind {
    /// The kind that holds both.
    #[must_use]
    pub fn both(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if a == b => a,
            (Self::Whole, Self::Number) | (Self::Number, Self::Whole) => Self::Number,
            _ => Self::Text,
        }
    }
}

const SOURCE: &str = "carom.sweep";
const SHARD: &str = "carom.shard";

impl Rows {
    /// Writes a Parquet file, whole or not at all.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&self, file: &Path) -> Result<()> {
        let fields: Vec<Arc<Type>> = self
            .columns
            .iter()
            .map(|column| Ok(Arc::new(field(column)?)))
            .collect::<Result<_>>()?;
        let schema = Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?);
        let mut notes =
            vec![KeyValue::new(SOURCE.to_owned(), serde_json::to_string(&self.source)?)];
        if let Some([i, n]) = self.shard {
            notes.push(KeyValue::new(SHARD.to_owned(), format!("{i}/{n}")));
        }
        let properties = WriterProperties::builder().set_key_value_metadata(Some(notes)).build();
        let mut writer =
            SerializedFileWriter::new(Draft::new(file)?, schema, Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        let mut number = 0;
        while let Some(mut column) = group.next_column()? {
            self.write_column(&mut column, number)?;
            column.close()?;
            number += 1;
        }
        group.close()?;
        writer.into_inner()?.finish()
    }

    fn write_column(&self, writer: &mut SerializedColumnWriter<'_>, number: usize) -> Result<()> {
        let cells = || self.rows.iter().map(|row| &row[number]);
        match self.columns[number].kind {
            Kind::Flag => put::<BoolType>(
                writer,
                cells().map(|cell| match cell {
                    Cell::Flag(flag) => Some(*flag),
                    _ => None,
                }),
            ),
            Kind::Whole => put::<Int64Type>(
                writer,
                cells().map(|cell| match cell {
                    Cell::Whole(number) => Some(*number),
                    _ => None,
                }),
            ),
            Kind::Number => put::<DoubleType>(
                writer,
                cells().map(|cell| match cell {
                    Cell::Number(number) => Some(*number),
                    Cell::Whole(number) => Some(*number as f64),
                    _ => None,
                }),
            ),
            Kind::Text => put::<ByteArrayType>(
                writer,
                cells().map(|cell| match cell {
                    Cell::Nothing => None,
                    cell => Some(ByteArray::from(cell.text().into_bytes())),
                }),
            ),
        }
    }

    /// Reads a Parquet file that [`Rows::write`] wrote.
    ///
    /// # Errors
    /// When it cannot be read or is none.
    pub fn read(file: &Path) -> Result<Self> {
        let name = || file.display().to_string();
        let open =
            std::fs::File::open(file).with_context(|| format!("cannot read {}", file.display()))?;
        let reader = SerializedFileReader::new(open).with_context(name)?;
        let metadata = reader.metadata().file_metadata();
        let note = |key: &str| {
            let notes = metadata.key_value_metadata()?;
            notes.iter().find(|note| note.key == key)?.value.clone()
        };
        let source = note(SOURCE)
            .ok_or_else(|| anyhow!("{}: not the result of carom sweep", file.display()))?;
        let source = serde_json::from_str(&source).with_context(name)?;
        let shard = note(SHARD).map(|text| shard(&text)).transpose().map_err(|why| anyhow!(why))?;
        let fields = metadata.schema_descr().root_schema().get_fields();
        let columns =
            fields.iter().map(|field| column(field)).collect::<Result<_>>().with_context(name)?;
        let mut rows = Vec::new();
        for row in reader.get_row_iter(None).with_context(name)? {
            let row = row.with_context(name)?;
            rows.push(row.get_column_iter().map(|(_, field)| cell(field)).collect::<Result<_>>()?);
        }
        Ok(Self { source, shard, columns, rows })
    }
}

fn field(column: &Column) -> Result<Type> {
    let (physical, logical) = match column.kind {
        Kind::Flag => (Physical::BOOLEAN, None),
        Kind::Whole => (Physical::INT64, None),
        Kind::Number => (Physical::DOUBLE, None),
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let field = Type::primitive_type_builder(&column.name, physical)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical);
    Ok(field.build()?)
}

fn column(field: &Type) -> Result<Column> {
    let name = field.name().to_owned();
    let kind = match field.get_physical_type() {
        Physical::BOOLEAN => Kind::Flag,
        Physical::INT64 => Kind::Whole,
        Physical::DOUBLE => Kind::Number,
        Physical::BYTE_ARRAY => Kind::Text,
        other => bail!("column {name} holds {other}, which carom sweep never writes"),
    };
    Ok(Column { name, kind })
}

fn cell(field: &Field) -> Result<Cell> {
    Ok(match field {
        Field::Null => Cell::Nothing,
        Field::Bool(flag) => Cell::Flag(*flag),
        Field::Long(number) => Cell::Whole(*number),
        Field::Double(number) => Cell::Number(*number),
        Field::Str(text) => Cell::Text(text.clone()),
        other => bail!("a cell is {other}, which carom sweep never writes"),
    })
}

/// Values where there are any; definition level 1 says that there is one.
fn put<T: DataType>(
    writer: &mut SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = Option<T::T>>,
) -> Result<()> {
    let cells: Vec<Option<T::T>> = cells.collect();
    let levels: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    let values: Vec<T::T> = cells.into_iter().flatten().collect();
    writer.typed::<T>().write_batch(&values, Some(&levels), None)?;
    Ok(())
}

/// Reads "i/n", the i-th of n shards.
///
/// # Errors
/// What would be right.
pub fn shard(text: &str) -> Result<[usize; 2], String> {
    let parts = text.split_once('/').and_then(|(i, n)| Some([i.parse().ok()?, n.parse().ok()?]));
    parts
        .filter(|&[i, n]: &[usize; 2]| i >= 1 && i <= n)
        .ok_or_else(|| format!("{text} is no shard, must be i/n with i from 1 to n"))
}
