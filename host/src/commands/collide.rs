//! `carom collide`: what do the listed collisions lead to? Reads a CSV file; writes CSV to standard output.

use crate::collide::{self, Integrated, Restitution, case};
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
    /// viscoelastic; SI units; fields a law does not use stay empty.
    cases: PathBuf,
    /// Look the coefficients up in a table, or integrate the contact equation to 1e-12.
    #[arg(long, value_enum, default_value = "table")]
    with: With,
    /// Which table.
    #[arg(long, value_enum, default_value = "standard")]
    table: Size,
    /// Where a contact ends: when the force vanishes (MP13) or when the overlap does (L94).
    #[arg(long, value_enum, default_value = "force")]
    end: EndOption,
    /// Outside the table's domain: give the answer of the nearest point inside.
    #[arg(long, value_enum)]
    outside: Option<OutsideOption>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum With {
    Table,
    Integrate,
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

/// Answers every case of the file.
///
/// # Errors
/// A file that cannot be read, or its first bad row.
pub fn run(options: &Options) -> Result<()> {
    let name = options.cases.display();
    let file = File::open(&options.cases).with_context(|| format!("cannot read {name}"))?;
    let cases = case::read(file).with_context(|| format!("{name}"))?;
    let end = match options.end {
        EndOption::Force => End::Force,
        EndOption::Overlap => End::Overlap,
    };
    let source: Box<dyn Restitution> = match options.with {
        With::Integrate => Box::new(Integrated(end)),
        With::Table if end == End::Force => Box::new(Embedded(options.table)),
        With::Table => Box::new(Generated::new(options.table, end, &laws(&cases))?),
    };
    let clamp = options.outside.is_some();
    let outcomes: Vec<_> =
        cases.iter().map(|case| collide::solve(source.as_ref(), case, end, clamp)).collect();
    let mut sink = BufWriter::new(std::io::stdout().lock());
    collide::write(&mut sink, &cases, &outcomes)?;
    sink.flush()?;
    Ok(())
}

/// The laws that occur.
fn laws(cases: &[case::Case]) -> Vec<Law> {
    let mut laws = Vec::new();
    for case in cases {
        if !laws.contains(&case.contact.law()) {
            laws.push(case.contact.law());
        }
    }
    laws
}
