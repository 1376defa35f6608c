//! `carom fluid`: is it a fluid of hard spheres? Runs elastic ones; writes pressure and mean free time beside published values.

use crate::figure::Progress;
use crate::figure::hard::{Fluid, Mean, Plan, measure, theory};
use anyhow::Result;
use clap::Args;
use serde::Serialize;
use std::io::Write;

/// The options of `carom fluid`.
#[derive(Args, Debug)]
pub struct Options {
    /// Run ten times longer.
    #[arg(long)]
    full: bool,
    /// Print the results as JSON.
    #[arg(long)]
    json: bool,
    /// Seed of the velocities.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// One measured number beside the published one.
#[derive(Debug, Serialize)]
struct Row {
    system: &'static str,
    quantity: &'static str,
    measured: f64,
    standard_error: f64,
    published: f64,
    source: &'static str,
    relative_difference: f64,
}

const CARNAHAN: &str = "Carnahan & Starling 1969, doi:10.1063/1.1672048";
const KOLAFA: &str = "Kolafa & Rottner 2006, doi:10.1080/00268970600967963";
const LUE: &str = "Lue 2005, doi:10.1063/1.1834498";

/// Measures all systems.
///
/// # Errors
/// What the engine says.
pub fn run(options: &Options) -> Result<()> {
    let blocks = if options.full { 200 } else { 20 };
    let progress = Progress::new("fluid", 3 * blocks);
    let mut rows = spheres(options, 1_372, "3D, N = 1,372, density 0.5", (100, blocks), &progress)?;
    let large = spheres(options, 13_500, "3D, N = 13,500, density 0.5", (12, blocks), &progress)?;
    rows.extend(large);
    rows.extend(disks(options, (150, blocks), &progress)?);
    drop(progress);
    let mut out = std::io::stdout().lock();
    if options.json {
        return Ok(writeln!(out, "{}", serde_json::to_string_pretty(&rows)?)?);
    }
    print(&mut out, &rows)
}

fn spheres(
    options: &Options,
    grains: usize,
    system: &'static str,
    (block, blocks): (u64, u64),
    progress: &Progress,
) -> Result<Vec<Row>> {
    let fluid = Fluid { seed: options.seed, ..Fluid::elastic(grains, 0.5) };
    let plan = Plan { equilibrate: 100, block, blocks };
    let measured = measure::<3>(&fluid, plan, || progress.add(1))?;
    let z = theory::carnahan_starling(theory::packing_of_spheres(fluid.density));
    Ok(vec![
        row(system, "Z", measured.compressibility, z, CARNAHAN),
        row(system, "mean free time", measured.mean_free_time, theory::LUE, LUE),
    ])
}

fn disks(options: &Options, (block, blocks): (u64, u64), progress: &Progress) -> Result<Vec<Row>> {
    let eta = 0.5;
    let fluid =
        Fluid { seed: options.seed, ..Fluid::elastic(1_024, eta / theory::packing_of_disks(1.0)) };
    let plan = Plan { equilibrate: 200, block, blocks };
    let measured = measure::<2>(&fluid, plan, || progress.add(1))?;
    let z = theory::kolafa_rottner(eta);
    Ok(vec![row("2D, N = 1,024, packing 0.5", "Z", measured.compressibility, z, KOLAFA)])
}

fn row(
    system: &'static str,
    quantity: &'static str,
    Mean { value, error }: Mean,
    published: f64,
    source: &'static str,
) -> Row {
    Row {
        system,
        quantity,
        measured: value,
        standard_error: error,
        published,
        source,
        relative_difference: value / published - 1.0,
    }
}

fn print(out: &mut impl Write, rows: &[Row]) -> Result<()> {
    writeln!(
        out,
        "{:<28} {:<15} {:>9}   {:<7} {:>9} {:>9}  source",
        "elastic hard spheres", "quantity", "measured", "error", "published", "apart"
    )?;
    for row in rows {
        let Row { system, quantity, measured, standard_error, published, source, .. } = row;
        let apart = 100.0 * row.relative_difference;
        writeln!(
            out,
            "{system:<28} {quantity:<15} {measured:>9.5} ± {standard_error:.5} {published:>9.5} {apart:>+7.2} %  {source}"
        )?;
    }
    Ok(())
}
