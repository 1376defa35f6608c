//! `carom bench`: how many collisions a second? Runs the cases one after the other; writes a table or JSON.

use crate::bench::{self, Case, Contact, Row};
use anyhow::{Result, bail};
use clap::Args;
use std::io::Write;

/// The options of `carom bench`.
#[derive(Args, Debug)]
pub struct Options {
    /// Only this case, or those whose names begin so (hs3d, emdstar-10000); all if left out.
    case: Option<String>,
    /// Print `[{"case", "n", "collisions_per_s", "bytes_per_grain", "clustered", "events", "seconds"}]`.
    #[arg(long)]
    json: bool,
    /// Print the table in docs/guide/speed.md.
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
}

/// Runs the cases on one core.
///
/// # Errors
/// A case that does not exist.
pub fn run(options: &Options) -> Result<()> {
    let cases = chosen(options.case.as_deref())?;
    let mut out = std::io::stdout().lock();
    if options.json {
        let rows = cases.iter().map(bench::measure).collect::<Result<Vec<Row>>>()?;
        return Ok(writeln!(out, "{}", serde_json::to_string_pretty(&rows)?)?);
    }
    if options.markdown {
        return markdown(&mut out, &cases);
    }
    writeln!(
        out,
        "{:<20}{:>9}{:>14}{:>12}{:>11}{:>16}  others (collisions/s)",
        "case", "N", "collisions/s", "bytes/grain", "clustered", "CPU s/sim. time"
    )?;
    for case in &cases {
        line(&mut out, case, &bench::measure(case)?)?;
        out.flush()?;
    }
    Ok(())
}

/// Thousands of collisions a second, beside what others have published.
fn markdown(out: &mut impl Write, cases: &[Case]) -> Result<()> {
    writeln!(out, "| case | collisions/s | bytes a grain | published |\n|---|---|---|---|")?;
    for case in cases {
        let Row { collisions_per_s, bytes_per_grain, .. } = bench::measure(case)?;
        let others = case.others.iter().map(|(who, rate)| format!("{who} {:.0} k", rate / 1e3));
        let (name, rate) = (case.name, collisions_per_s / 1e3);
        let others = others.collect::<Vec<_>>().join(", ");
        writeln!(out, "| {name} | {rate:.0} k | {bytes_per_grain:.0} | {others} |")?;
        out.flush()?;
    }
    Ok(())
}

fn chosen(name: Option<&str>) -> Result<Vec<Case>> {
    let Some(name) = name else { return Ok(bench::ALL.to_vec()) };
    let cases = bench::named(name);
    if cases.is_empty() {
        let names: Vec<&str> = bench::ALL.iter().map(|case| case.name).collect();
        bail!("there is no case {name}; there are {}", names.join(", "));
    }
    Ok(cases)
}

fn line(out: &mut impl Write, case: &Case, row: &Row) -> Result<()> {
    let Row { n, collisions_per_s, bytes_per_grain, clustered, seconds, simulated, .. } = *row;
    let clustered = format!("{:.2} %", 100.0 * clustered);
    let cost = seconds / simulated;
    // In the hard-sphere cases the unit of time is arbitrary.
    let cost = match case.contact {
        Contact::Viscoelastic { .. } => format!("{cost:.2e}"),
        Contact::Hard { .. } => "-".to_owned(),
    };
    let others: Vec<String> = case
        .others
        .iter()
        .map(|(who, rate)| format!("{who} {rate:.0}: x {:.2}", collisions_per_s / rate))
        .collect();
    let (name, others) = (case.name, others.join(", "));
    Ok(writeln!(
        out,
        "{name:<20}{n:>9}{collisions_per_s:>14.0}{bytes_per_grain:>12.0}{clustered:>11}{cost:>16}  {others}"
    )?)
}
