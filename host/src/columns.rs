//! What is a table of cells under columns, and how is it a Parquet file? Reads and writes Parquet, always the same bytes for the same rows.

use anyhow::{Context, Result, bail};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::Field;
use parquet::schema::types::Type;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

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

/// Writes rows as a Parquet file, always the same bytes for the same rows; gives the sink back.
///
/// # Errors
/// When it cannot be written.
pub fn write_parquet<W: Write + Send>(
    sink: W,
    name: &str,
    notes: Vec<KeyValue>,
    columns: &[Column],
    rows: &[Vec<Cell>],
) -> Result<W> {
    let fields: Vec<Arc<Type>> =
        columns.iter().map(|column| Ok(Arc::new(field(column)?))).collect::<Result<_>>()?;
    let schema = Arc::new(Type::group_type_builder(name).with_fields(fields).build()?);
    let properties = WriterProperties::builder().set_key_value_metadata(Some(notes)).build();
    let mut writer = SerializedFileWriter::new(sink, schema, Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    let mut number = 0;
    while let Some(mut column) = group.next_column()? {
        write_column(&mut column, columns[number].kind, || rows.iter().map(|row| &row[number]))?;
        column.close()?;
        number += 1;
    }
    group.close()?;
    Ok(writer.into_inner()?)
}

fn write_column<'r, I: Iterator<Item = &'r Cell>>(
    writer: &mut SerializedColumnWriter<'_>,
    kind: Kind,
    cells: impl Fn() -> I,
) -> Result<()> {
    match kind {
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

/// The columns and rows of a Parquet file, or of a CSV file: a column in which every cell is a number or
/// empty is one of numbers.
///
/// # Errors
/// When it cannot be read; one line that names it.
pub fn read_file(file: &Path) -> Result<(Vec<Column>, Vec<Vec<Cell>>)> {
    let name = || file.display().to_string();
    let open = File::open(file).with_context(|| format!("cannot read {}", file.display()))?;
    if file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("parquet")) {
        let reader = SerializedFileReader::new(open).with_context(name)?;
        return read_parquet(&reader).with_context(name);
    }
    read_csv(open).with_context(name)
}

fn read_csv(file: File) -> Result<(Vec<Column>, Vec<Vec<Cell>>)> {
    let mut reader = csv::Reader::from_reader(file);
    let heads: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
    let texts = reader.records().collect::<Result<Vec<_>, _>>()?;
    let is_number = |text: &str| text.is_empty() || text.parse::<f64>().is_ok();
    let kinds: Vec<Kind> = (0..heads.len())
        .map(|k| texts.iter().all(|row| row.get(k).is_none_or(is_number)))
        .map(|all| if all { Kind::Number } else { Kind::Text })
        .collect();
    let cell = |(text, kind): (&str, &Kind)| match (text, kind) {
        ("", _) => Cell::Nothing,
        (text, Kind::Number) => text.parse().map_or(Cell::Nothing, Cell::Number),
        (text, _) => Cell::Text(text.to_owned()),
    };
    let rows = texts.iter().map(|row| row.iter().zip(&kinds).map(cell).collect()).collect();
    let columns = heads.into_iter().zip(kinds).map(|(name, kind)| Column { name, kind });
    Ok((columns.collect(), rows))
}

/// The columns and rows of a Parquet file that [`write_parquet`] wrote.
///
/// # Errors
/// When it holds what this never writes.
pub fn read_parquet(reader: &impl FileReader) -> Result<(Vec<Column>, Vec<Vec<Cell>>)> {
    let fields = reader.metadata().file_metadata().schema_descr().root_schema().get_fields();
    let columns = fields.iter().map(|field| column(field)).collect::<Result<_>>()?;
    let mut rows = Vec::new();
    for row in reader.get_row_iter(None)? {
        rows.push(row?.get_column_iter().map(|(_, field)| cell(field)).collect::<Result<_>>()?);
    }
    Ok((columns, rows))
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
