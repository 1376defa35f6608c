//! `carom collide`: what do collisions lead to? Reads a CSV file; writes CSV, and a line for each bad row.

use super::impacts;
use crate::collide::{self, BadRow, Case, Integrated, Restitution};
use crate::rows as csv_rows;
use crate::tables::{Embedded, Generated, Size};
use anyhow::{Context, Result};
use carom_tables::read::{End, Law};
use clap::{Args, ValueEnum};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;

/// The options of `carom collide`.
#[derive(Args, Debug)]
pub struct Options {
    /// CSV with a header of at least id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e; law is lsd or
    /// viscoelastic, with forces also constant, power, walton-braun, dmt or jkr; SI units; fields a law does not use
    /// stay empty.
    cases: PathBuf,
    /// Look the coefficients up in a table, integrate the contact equation to 1e-12, or show the engine's contact and
    /// the force-based reference's side by side, with spins w1 and w2.
    #[arg(long, value_enum, default_value = "table")]
    with: With,
    #[command(flatten)]
    surfaces: impacts::Options,
    /// Which table.
    #[arg(long, value_enum, default_value = "standard")]
    table: Size,
    /// Where a contact ends: when the force vanishes (MP13) or when the overlap does (L94).
    #[arg(long, value_enum, default_value = "force")]
    end: EndOption,
    /// Outside the table's domain: use the nearest point inside.
    #[arg(long, value_enum)]
    outside: Option<OutsideOption>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum With {
    Table,
    Integrate,
    Forces,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum EndOption {
    Force,
    Overlap,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum OutsideOption {
    Clamp,
}

/// Computes every case of the file.
///
/// # Errors
/// A file that cannot be read, or, once the others are answered, that some rows were bad.
pub fn run(options: &Options) -> Result<()> {
    let name = options.cases.display();
    let file = File::open(&options.cases).with_context(|| format!("cannot read {name}"))?;
    if matches!(options.with, With::Forces) {
        return impacts::run(file, &name.to_string(), &options.surfaces);
    }
    options.surfaces.must_be_absent()?;
    let rows = collide::read(file).with_context(|| format!("{name}"))?;
    let end = match options.end {
        EndOption::Force => End::Force,
        EndOption::Overlap => End::Overlap,
    };
    let source: Box<dyn Restitution> = match options.with {
        With::Integrate | With::Forces => Box::new(Integrated(end)),
        With::Table if end == End::Force => Box::new(Embedded(options.table)),
        With::Table => Box::new(Generated::new(options.table, end, &laws(&rows))?),
    };
    let clamp = options.outside.is_some();
    let mut sink = BufWriter::new(std::io::stdout().lock());
    let answer = |row: &'_ Result<Case, BadRow>| match row {
        Ok(case) => Some(collide::solve(source.as_ref(), case, end, clamp)),
        Err(_) => None,
    };
    collide::write(&mut sink, rows.iter().map(|row| (id(row), answer(row))))?;
    sink.flush()?;
    let bad: Vec<&BadRow> = rows.iter().filter_map(|row| row.as_ref().err()).collect();
    csv_rows::report(&name.to_string(), &bad, rows.len())
}

fn id(row: &Result<Case, BadRow>) -> &str {
    match row {
        Ok(case) => &case.id,
        Err(bad) => &bad.id,
    }
}

/// The laws that occur.
fn laws(rows: &[Result<Case, BadRow>]) -> Vec<Law> {
    let mut laws = Vec::new();
    for case in rows.iter().flatten() {
        if !laws.contains(&case.contact.law()) {
            laws.push(case.contact.law());
        }
    }
    laws
}
