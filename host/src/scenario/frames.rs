//! Which grains does a file hold? Reads extended XYZ, CSV or Parquet; writes nothing, returns the grains of one frame.

use super::problem::Problem;
use anyhow::{Context, Result, bail};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::File;
use std::path::Path;

/// A grain as a file tells it; what the file does not tell is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Told {
    /// Centre; 0 for axes that the file does not have.
    pub position: [f64; 3],
    /// Velocity.
    pub velocity: Option<[f64; 3]>,
    /// Radius.
    pub radius: Option<f64>,
    /// Mass.
    pub mass: Option<f64>,
    /// What kind it is.
    pub species: Option<String>,
    /// When.
    pub time: Option<f64>,
}

/// The columns that are understood, by the names that programs give them.
const COLUMNS: [(&str, &[&str]); 11] = [
    ("x", &["x", "pos_x", "position_x"]),
    ("y", &["y", "pos_y", "position_y"]),
    ("z", &["z", "pos_z", "position_z"]),
    ("vx", &["vx", "velo_x", "velocity_x"]),
    ("vy", &["vy", "velo_y", "velocity_y"]),
    ("vz", &["vz", "velo_z", "velocity_z"]),
    ("radius", &["radius", "r"]),
    ("mass", &["mass", "m"]),
    ("species", &["species", "type", "id"]),
    ("frame", &["frame", "sample"]),
    ("time", &["time", "t"]),
];

/// The grains of a frame, counted from 0; of the last one if none is named.
///
/// # Errors
/// What cannot be read, with the file's name.
pub fn read(file: &Path, frame: Option<usize>) -> Result<Vec<Told>, Problem> {
    let name = file.display();
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let read = match ending {
        "xyz" | "extxyz" => xyz(file, frame),
        "csv" => csv(file).and_then(|table| table.grains(frame)),
        "parquet" => parquet(file).and_then(|table| table.grains(frame)),
        _ => Err(anyhow::anyhow!("its name must end in .xyz, .csv or .parquet")),
    };
    read.map_err(|error| Problem {
        path: String::new(),
        offset: None,
        message: format!("{name}: {error:#}").replace('\n', " "),
    })
}

/// Named columns of words.
struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// The column of this name, or of another name for the same.
    fn column(&self, name: &str) -> Option<usize> {
        let (_, names) = COLUMNS.iter().find(|(known, _)| *known == name)?;
        let is = |head: &String| names.iter().any(|one| one.eq_ignore_ascii_case(head.trim()));
        self.head.iter().position(is)
    }

    fn number(&self, row: usize, column: usize) -> Result<f64> {
        let word = self.rows[row][column].trim();
        let number: Option<f64> = word.parse().ok().filter(|number: &f64| number.is_finite());
        number.with_context(|| {
            format!("row {}: {} is {word:?}, must be a finite number", row + 1, self.head[column])
        })
    }

    /// The rows of a frame, if they say of which they are; else all.
    fn of_frame(&self, frame: Option<usize>) -> Result<Vec<usize>> {
        let all = 0..self.rows.len();
        let Some(column) = self.column("frame").or_else(|| self.column("time")) else {
            if frame.is_some_and(|frame| frame > 0) {
                bail!("there is one frame only, as no column says frame or time");
            }
            return Ok(all.collect());
        };
        let stamps: Vec<f64> =
            all.clone().map(|row| self.number(row, column)).collect::<Result<_>>()?;
        let mut frames = stamps.clone();
        frames.sort_by(f64::total_cmp);
        frames.dedup();
        let number = frame.unwrap_or(frames.len().saturating_sub(1));
        let Some(stamp) = frames.get(number) else {
            bail!("there is no frame {number}, the last one is {}", frames.len().saturating_sub(1))
        };
        Ok(all.filter(|row| stamps[*row] == *stamp).collect())
    }

    fn grains(&self, frame: Option<usize>) -> Result<Vec<Told>> {
        let places = ["x", "y", "z"].map(|name| self.column(name));
        if places[0].is_none() {
            bail!("there is no column x");
        }
        let speeds = ["vx", "vy", "vz"].map(|name| self.column(name));
        let [radius, mass, species, time] =
            ["radius", "mass", "species", "time"].map(|name| self.column(name));
        let vector = |row: usize, columns: [Option<usize>; 3]| -> Result<[f64; 3]> {
            let mut vector = [0.0; 3];
            for (x, column) in vector.iter_mut().zip(columns) {
                *x = column.map_or(Ok(0.0), |column| self.number(row, column))?;
            }
            Ok(vector)
        };
        let one = |row: usize| {
            let number = |column: Option<usize>| column.map(|c| self.number(row, c)).transpose();
            Ok(Told {
                position: vector(row, places)?,
                velocity: speeds[0].map(|_| vector(row, speeds)).transpose()?,
                radius: number(radius)?,
                mass: number(mass)?,
                species: species.map(|column| self.rows[row][column].trim().to_owned()),
                time: number(time)?,
            })
        };
        self.of_frame(frame)?.into_iter().map(one).collect()
    }
}

fn csv(file: &Path) -> Result<Table> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file)?;
    let head = reader.headers()?.iter().map(str::to_owned).collect();
    let words = |row: csv::StringRecord| row.iter().map(str::to_owned).collect();
    let rows = reader.records().map(|row| Ok(words(row?))).collect::<Result<_>>()?;
    Ok(Table { head, rows })
}

fn parquet(file: &Path) -> Result<Table> {
    let reader = SerializedFileReader::new(File::open(file)?)?;
    let schema = reader.metadata().file_metadata().schema_descr();
    let head = schema.columns().iter().map(|column| column.name().to_owned()).collect();
    let word = |field: &Field| match field {
        Field::Str(text) => text.clone(),
        Field::Double(number) => format!("{number:?}"),
        Field::Float(number) => format!("{number:?}"),
        other => other.to_string(),
    };
    let mut rows = Vec::new();
    for row in reader.get_row_iter(None)? {
        rows.push(row?.get_column_iter().map(|(_, field)| word(field)).collect());
    }
    Ok(Table { head, rows })
}

/// One frame of an extended XYZ file, whose comment says which columns there are.
fn xyz(file: &Path, frame: Option<usize>) -> Result<Vec<Told>> {
    let text = std::fs::read_to_string(file)?;
    let mut lines = text.lines();
    let mut last = None;
    let mut number = 0;
    while let Some(first) = lines.next() {
        if first.trim().is_empty() && lines.clone().all(|line| line.trim().is_empty()) {
            break;
        }
        let count: usize = first.trim().parse().ok().with_context(|| {
            format!("frame {number} begins with {first:?}, must be its number of grains")
        })?;
        let comment = lines.next().context("the file ends before the second line of a frame")?;
        let rows: Vec<&str> = lines.by_ref().take(count).collect();
        if rows.len() < count {
            bail!("frame {number} has {} grains, its first line says {count}", rows.len());
        }
        last = Some((comment, rows));
        number += 1;
        if frame.is_some_and(|frame| frame < number) {
            break;
        }
    }
    let (comment, rows) = last.context("there is no frame")?;
    if frame.is_some_and(|frame| frame >= number) {
        bail!("there is no frame {}, the last one is {}", frame.unwrap_or(0), number - 1);
    }
    let head = columns(comment);
    let split = |row: &&str| row.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let rows: Vec<Vec<String>> = rows.iter().map(split).collect();
    if let Some(row) = rows.iter().position(|row| row.len() < head.len()) {
        bail!("grain {row} has {} columns, must have {}", rows[row].len(), head.len());
    }
    let time = comment.split_whitespace().find_map(|word| word.strip_prefix("Time="));
    let time = time.and_then(|word| word.parse().ok());
    let grains = Table { head, rows }.grains(None)?;
    Ok(grains.into_iter().map(|grain| Told { time, ..grain }).collect())
}

/// The columns of an extended XYZ comment, `Properties=species:S:1:pos:R:3`; those of plain XYZ without it.
fn columns(comment: &str) -> Vec<String> {
    let said = comment.split_whitespace().find_map(|word| word.strip_prefix("Properties="));
    let words: Vec<&str> =
        said.unwrap_or("species:S:1:pos:R:3").trim_matches('"').split(':').collect();
    let mut head = Vec::new();
    for property in words.chunks_exact(3) {
        let (name, count) = (property[0], property[2].parse().unwrap_or(1));
        let axes = ["x", "y", "z"].iter();
        match count {
            1 => head.push(name.to_owned()),
            _ => head.extend(axes.take(count).map(|axis| format!("{name}_{axis}"))),
        }
        head.extend((3..count).map(|k| format!("{name}_{k}")));
    }
    head
}
