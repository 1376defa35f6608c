//! In which files does a run end up? Reads samples; writes CSV, extended XYZ and aligned text.

use crate::growing::Growing;
use crate::method::LoggedEvent;
use crate::run::Sample;
use crate::scenario::{MethodName, Scenario, Side, Start, present};
use anyhow::Result;
use std::io::Write;
use std::path::Path;

/// The files of one run by one method, as far as they have grown.
#[derive(Debug)]
pub struct Files {
    names: Vec<String>,
    series: Series,
    frames: Growing,
    events: Option<csv::Writer<Growing>>,
}

impl Files {
    /// Begins NAME.csv and NAME.xyz, and NAME-events.csv if the scenario asks for it.
    ///
    /// # Errors
    /// When one cannot be made.
    pub fn new(folder: &Path, name: MethodName, scenario: &Scenario) -> Result<Self> {
        Self::from_lengths(folder, name, scenario, &[])
    }

    /// Goes on with the files as they were when they had these lengths ([`Files::secured`]).
    ///
    /// # Errors
    /// When one is shorter or cannot be opened.
    pub fn from_lengths(
        folder: &Path,
        name: MethodName,
        scenario: &Scenario,
        lengths: &[u64],
    ) -> Result<Self> {
        let names = names(name, scenario);
        let length = |k: usize| lengths.get(k).copied().unwrap_or(0);
        let open = |k: usize| Growing::from_length(&folder.join(&names[k]), length(k));
        let series = Series { rows: csv::Writer::from_writer(open(0)?), begun: length(0) > 0 };
        let frames = open(1)?;
        let mut events = None;
        if names.len() > 2 {
            let mut rows = csv::Writer::from_writer(open(2)?);
            if length(2) == 0 {
                events_head(&mut rows)?;
            }
            events = Some(rows);
        }
        Ok(Self { names, series, frames, events })
    }

    /// One more sample.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, start: &Start, sample: &Sample) -> Result<()> {
        self.series.add(sample)?;
        write_frame(&mut self.frames, start, sample)?;
        self.add_events(&sample.events)
    }

    /// More events, if they are asked for.
    ///
    /// # Errors
    /// When they cannot be written.
    pub fn add_events(&mut self, events: &[LoggedEvent]) -> Result<()> {
        self.events.as_mut().map_or(Ok(()), |rows| write_events(rows, events))
    }

    /// How long the files are. All of them is on the disk then.
    ///
    /// # Errors
    /// When something cannot be written.
    pub fn secured(&mut self) -> Result<Vec<u64>> {
        self.frames.flush()?;
        let mut lengths = vec![secured(&mut self.series.rows)?, self.frames.secured()?];
        if let Some(rows) = &mut self.events {
            lengths.push(secured(rows)?);
        }
        Ok(lengths)
    }

    /// The names of the files in their folder.
    pub fn names(&self) -> &[String] {
        &self.names
    }
}

fn names(name: MethodName, scenario: &Scenario) -> Vec<String> {
    let stem = name.file_stem();
    let mut names = vec![format!("{stem}.csv"), format!("{stem}.xyz")];
    if scenario.options.events && matches!(name, MethodName::Emd | MethodName::EmdStar) {
        names.push(format!("{stem}-events.csv"));
    }
    names
}

fn secured(rows: &mut csv::Writer<Growing>) -> Result<u64> {
    rows.flush()?;
    rows.get_ref().secured()
}

/// A time series as CSV: time, kinetic energy, collisions and the method's statistics.
#[derive(Debug)]
struct Series {
    rows: csv::Writer<Growing>,
    begun: bool,
}

impl Series {
    /// One row.
    fn add(&mut self, sample: &Sample) -> Result<()> {
        let rotates = !sample.rotations.is_empty();
        if !self.begun {
            let names = sample.statistics.iter().map(|(name, _)| *name);
            let rotation = rotates.then_some("rotational_energy");
            let first = ["time", "kinetic_energy"].into_iter().chain(rotation);
            self.rows.write_record(first.chain(["contacts_begun"]).chain(names))?;
            self.begun = true;
        }
        let mut row = vec![format!("{:?}", sample.time), format!("{:?}", sample.kinetic_energy)];
        row.extend(rotates.then(|| format!("{:?}", sample.rotational_energy)));
        row.push(sample.collisions.to_string());
        row.extend(sample.statistics.iter().map(|(_, count)| count.to_string()));
        Ok(self.rows.write_record(row)?)
    }
}

/// The header of an event log.
fn events_head(rows: &mut csv::Writer<Growing>) -> Result<()> {
    Ok(rows.write_record(["time", "event", "grain", "partner", "plane"])?)
}

/// The rows of an event log.
fn write_events(rows: &mut csv::Writer<Growing>, events: &[LoggedEvent]) -> Result<()> {
    let number = |number: Option<usize>| number.map_or_else(String::new, |n| n.to_string());
    for event in events {
        rows.write_record([
            format!("{:?}", event.time),
            event.kind.to_owned(),
            event.grain.to_string(),
            number(event.partner),
            number(event.plane),
        ])?;
    }
    Ok(())
}

/// One frame of an extended XYZ trajectory (as read by OVITO and ASE): grains with the name of their species, position,
/// velocity, radius and mass, the box as `Lattice`, the instant as `Time`.
///
/// An open axis is given the extent of the grains of this frame and is marked not periodic.
///
/// # Errors
/// When it cannot be written.
pub fn write_frame(sink: &mut dyn Write, start: &Start, sample: &Sample) -> Result<()> {
    let mut origin = [0.0; 3];
    let mut size = [0.0; 3];
    for axis in 0..3 {
        let [from, to] = start.range_at(axis, sample.time).unwrap_or_else(|| extent(sample, axis));
        (origin[axis], size[axis]) = (from, to - from);
    }
    let periodic =
        start.sides.map(|side| if matches!(side, Side::Periodic(_)) { "T" } else { "F" });
    writeln!(sink, "{}", present(&sample.grains).count())?;
    let rotation = if sample.rotations.is_empty() { "" } else { ":angular_velocity:R:3" };
    writeln!(
        sink,
        "Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{}\" \
         Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1{rotation} Time={:?}",
        size[0],
        size[1],
        size[2],
        origin[0],
        origin[1],
        origin[2],
        periodic.join(" "),
        sample.time
    )?;
    let names: Vec<String> = start.species_names.iter().map(|name| word(name)).collect();
    for (number, grain) in present(&sample.grains) {
        let of = start.species.get(number).filter(|_| start.has_species);
        let name = of.and_then(|of| names.get(usize::from(*of))).map_or("G", String::as_str);
        let ([x, y, z], [u, v, w]) = (grain.position, grain.velocity);
        write!(
            sink,
            "{name} {x:?} {y:?} {z:?} {u:?} {v:?} {w:?} {:?} {:?}",
            grain.radius, grain.mass
        )?;
        match sample.rotations.get(number) {
            Some([a, b, c]) => writeln!(sink, " {a:?} {b:?} {c:?}")?,
            None => writeln!(sink)?,
        }
    }
    Ok(())
}

/// A name without blanks, as XYZ needs it.
fn word(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("-")
}

fn extent(sample: &Sample, axis: usize) -> [f64; 2] {
    let there = present(&sample.grains).map(|(_, grain)| grain);
    let low = there.clone().map(|g| g.position[axis] - g.radius);
    let high = there.map(|g| g.position[axis] + g.radius);
    [low.fold(f64::INFINITY, f64::min), high.fold(f64::NEG_INFINITY, f64::max)]
}

/// Writes rows as a table, the first one as its head: the first `left` columns flush left, the
/// others flush right.
///
/// # Errors
/// An error of `sink`.
pub fn write_aligned(sink: &mut dyn Write, rows: &[Vec<String>], left: usize) -> Result<()> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let length = |row: &Vec<String>, k: usize| row.get(k).map_or(0, |cell| cell.chars().count());
    let widths: Vec<usize> = (0..columns)
        .map(|column| rows.iter().map(|row| length(row, column)).max().unwrap_or(0))
        .collect();
    for (number, row) in rows.iter().enumerate() {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
            if column < left { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        writeln!(sink, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
        if number == 0 {
            let total = widths.iter().sum::<usize>() + 2 * columns.saturating_sub(1);
            writeln!(sink, "  {}", "-".repeat(total))?;
        }
    }
    Ok(())
}
