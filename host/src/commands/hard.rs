//! `carom fluid`, `carom soak`: is it a fluid of hard spheres, and can anything stop it? Runs gases; writes what was measured beside published values.

use crate::figure::hard::pressure::{self, Mean, Plan};
use crate::figure::hard::{Fluid, Overlaps, Run, RunState, measure};
use crate::heaps::Number;
use crate::progress::Progress;
use anyhow::{Result, ensure};
use clap::Args;
use serde::Serialize;
use std::io::Write;

/// The options of `carom fluid`.
#[derive(Args, Debug)]
pub struct FluidOptions {
    /// Run ten times longer.
    #[arg(long)]
    full: bool,
    /// Print the results as JSON.
    #[arg(long)]
    json: bool,
    /// Print the table in docs/figures/README.md.
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
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

const HANSEN_GOOS: &str = "Hansen-Goos 2016 (J. Chem. Phys. 144, 164506)";
const KOLAFA: &str = "Kolafa & Rottner 2006, doi:10.1080/00268970600967963";
const LUE: &str = "Lue 2005, doi:10.1063/1.1834498";

/// Measures all systems.
///
/// # Errors
/// An error of the engine.
pub fn fluid(options: &FluidOptions) -> Result<()> {
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
    if options.markdown { markdown(&mut out, &rows) } else { print(&mut out, &rows) }
}

fn markdown(out: &mut impl Write, rows: &[Row]) -> Result<()> {
    writeln!(out, "| system | quantity | measured | published | difference | source |")?;
    writeln!(out, "|---|---|---|---|---|---|")?;
    for row in rows {
        let Row { system, quantity, measured, standard_error, published, source, .. } = row;
        let difference = 100.0 * row.relative_difference;
        let found = format!("{measured:.5} ± {standard_error:.5}");
        writeln!(
            out,
            "| {system} | {quantity} | {found} | {published:.5} | {difference:+.2} % | {source} |"
        )?;
    }
    Ok(())
}

fn spheres(
    options: &FluidOptions,
    grains: usize,
    system: &'static str,
    (block, blocks): (u64, u64),
    progress: &Progress,
) -> Result<Vec<Row>> {
    let fluid = Fluid { seed: options.seed, ..Fluid::elastic(grains, 0.5) };
    let plan = Plan { equilibrate: 100, block, blocks };
    let measured = measure::<3>(&fluid, plan, || progress.add(1))?;
    let z = pressure::hansen_goos(pressure::packing_of_spheres(fluid.density));
    Ok(vec![
        row(system, "Z", measured.compressibility, z, HANSEN_GOOS),
        row(system, "mean free time", measured.mean_free_time, pressure::LUE, LUE),
    ])
}

fn disks(
    options: &FluidOptions,
    (block, blocks): (u64, u64),
    progress: &Progress,
) -> Result<Vec<Row>> {
    let eta = 0.5;
    let fluid = Fluid {
        seed: options.seed,
        ..Fluid::elastic(1_024, eta / pressure::packing_of_disks(1.0))
    };
    let plan = Plan { equilibrate: 200, block, blocks };
    let measured = measure::<2>(&fluid, plan, || progress.add(1))?;
    let z = pressure::kolafa_rottner(eta);
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
        "elastic hard spheres", "quantity", "measured", "error", "published", "diff."
    )?;
    for row in rows {
        let Row { system, quantity, measured, standard_error, published, source, .. } = row;
        let difference = 100.0 * row.relative_difference;
        writeln!(
            out,
            "{system:<28} {quantity:<15} {measured:>9.5} ± {standard_error:.5} {published:>9.5} {difference:>+7.2} %  {source}"
        )?;
    }
    Ok(())
}

/// The options of `carom soak`.
#[derive(Args, Debug)]
pub struct SoakOptions {
    /// In place of the gas: draw so many boxes of up to 200 grains from the seed on, let them fall, shake
    /// and settle, and check each.
    #[arg(long, value_name = "BOXES", conflicts_with_all = ["collisions", "restitution", "grains", "density"])]
    heaps: Option<u64>,
    /// What the boxes are computed in.
    #[arg(long, value_enum, default_value_t, requires = "heaps")]
    number: Number,
    /// How many collisions.
    #[arg(long, default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(1..))]
    collisions: u64,
    /// Coefficient of restitution, from 0 to 1.
    #[arg(long, default_value_t = 0.9, value_parser = fraction)]
    restitution: f64,
    /// How many grains.
    #[arg(long, default_value_t = 1_372, value_parser = clap::value_parser!(u32).range(16..))]
    grains: u32,
    /// Number density N σ³/V.
    #[arg(long, default_value_t = 0.5)]
    density: f64,
    /// Seed of the velocities; of the first box.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn fraction(text: &str) -> Result<f64> {
    let value: f64 = text.parse()?;
    ensure!((0.0..=1.0).contains(&value), "must be from 0 to 1");
    Ok(value)
}

/// By how much an overlap may become deeper by rounding of positions in a box of some ten diameters.
const DEEPER: f64 = 1e-14;

/// By how much energy and momentum may change by rounding, a random walk of 10⁹ steps of some 10⁻¹⁶ over 10³ grains.
const ROUNDING: f64 = 1e-12;

/// Lines about progress.
const LINES: u64 = 10;

/// Runs.
///
/// # Errors
/// An error of the engine, or a broken invariant.
pub fn soak(options: &SoakOptions) -> Result<()> {
    let SoakOptions { heaps, number, collisions, restitution, grains, density, seed } = *options;
    if let Some(boxes) = heaps {
        return super::heaps::soak(boxes, seed, number);
    }
    let fluid = Fluid { restitution, seed, ..Fluid::elastic(grains as usize, density) };
    let mut out = std::io::stdout().lock();
    writeln!(out, "{grains} hard spheres, density {density}, restitution {restitution}")?;
    writeln!(out, "  {:>12}  {:>11}  {:>13}  time", "collisions", "wall s", "energy/grain")?;
    let begin = std::time::Instant::now();
    let mut gas = Run::new(fluid, fluid.equilibrium::<3>(20)?);
    let mut overlaps = Overlaps::new(fluid.grains);
    let progress = Progress::new("soak", collisions);
    let mut shown = 0;
    let ran = gas.run(collisions, &mut overlaps, |state| {
        progress.add(state.collisions - shown);
        let tenth = |count: u64| count * LINES / collisions;
        if tenth(state.collisions) > tenth(shown) {
            line(&mut out, state, begin.elapsed().as_secs_f64())?;
        }
        shown = state.collisions;
        Ok(())
    });
    drop(progress);
    report(&mut out, &gas.state, &overlaps)?;
    ran?;
    verify(&gas.state, restitution, &overlaps)
}

fn line(out: &mut impl Write, state: &RunState, wall: f64) -> Result<()> {
    let RunState { collisions, energy, units, time, .. } = state;
    let power = |power: u32, sign: &str| match power {
        0 => String::new(),
        _ => format!(" × 2^{sign}{power}"),
    };
    let (slower, longer) = (power(40 * units, "-"), power(20 * units, ""));
    writeln!(out, "  {collisions:>12}  {wall:>11.1}  {energy:>13.4e}{slower}  {time:.6e}{longer}")?;
    Ok(out.flush()?)
}

fn report(out: &mut impl Write, state: &RunState, overlaps: &Overlaps) -> Result<()> {
    let share = overlaps.overlapping as f64 / overlaps.impacts.max(1) as f64;
    writeln!(out, "  the unit of time was made 2^20 times longer: {} times", state.units)?;
    writeln!(
        out,
        "  velocities drawn anew, of a gas that streamed without colliding: {} times",
        state.redrawn
    )?;
    writeln!(out, "  impacts {}, overlapping {share:.4}", overlaps.impacts)?;
    writeln!(out, "  impacts with a third grain overlapped: {}", overlaps.three_body)?;
    writeln!(out, "  deepest overlap: {:.3e}", -overlaps.deepest)?;
    writeln!(out, "  largest deepening of an overlap: {:.3e}", overlaps.decrease)?;
    writeln!(
        out,
        "  overlapping pairs that approach after an event: {}, at most at {:.1e} of their speed",
        overlaps.approaching, overlaps.fastest
    )?;
    writeln!(out, "  largest change of the energy: {:.2e} of it", state.energy_change)?;
    writeln!(out, "  largest change of the momentum: {:.2e} of √(2 E M)", state.momentum_change)?;
    writeln!(out, "  events before their predecessor: {}", state.backward)?;
    writeln!(out, "  most collisions at one instant: {}", state.at_once)?;
    let statistics = state.statistics.iter().map(|(name, count)| format!("{name} {count}"));
    writeln!(out, "  statistics: {}", statistics.collect::<Vec<_>>().join(", "))?;
    Ok(())
}

/// The invariants.
fn verify(state: &RunState, restitution: f64, overlaps: &Overlaps) -> Result<()> {
    let (energy, momentum) = (state.energy_change, state.momentum_change);
    ensure!(momentum < ROUNDING, "momentum changed by {momentum:.1e}, more than {ROUNDING:.0e}");
    ensure!(
        restitution < 1.0 || energy < ROUNDING,
        "energy changed by {energy:.1e} of itself, more than {ROUNDING:.0e}"
    );
    ensure!(state.backward == 0, "{} events had a negative time step", state.backward);
    ensure!(
        overlaps.decrease < DEEPER,
        "an overlap became deeper by {:.1e}, more than {DEEPER:.1e}",
        overlaps.decrease
    );
    Ok(())
}
