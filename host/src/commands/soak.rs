//! `carom soak`: can anything stop a dissipative gas? Runs collisions by the million; writes what was seen and counted.

use crate::figure::Progress;
use crate::figure::hard::{Fluid, Overlaps, Pace, Run};
use anyhow::{Result, ensure};
use clap::Args;
use std::io::Write;

/// The options of `carom soak`.
#[derive(Args, Debug)]
pub struct Options {
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
    /// Seed of the velocities.
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

/// Lines about progress.
const LINES: u64 = 10;

/// Runs.
///
/// # Errors
/// What the engine says, or what it should not have done.
pub fn run(options: &Options) -> Result<()> {
    let Options { collisions, restitution, grains, density, seed } = *options;
    let fluid = Fluid { restitution, seed, ..Fluid::elastic(grains as usize, density) };
    let mut out = std::io::stdout().lock();
    writeln!(out, "{grains} hard spheres, density {density}, restitution {restitution}")?;
    writeln!(out, "  {:>12}  {:>11}  {:>13}  time", "collisions", "wall s", "energy/grain")?;
    let begin = std::time::Instant::now();
    let mut gas = Run::new(fluid, fluid.equilibrium::<3>(20)?);
    let mut overlaps = Overlaps::new(fluid.grains);
    let progress = Progress::new("soak", collisions);
    let mut shown = 0;
    let ran = gas.run(collisions, &mut overlaps, |pace| {
        progress.add(pace.collisions - shown);
        let tenth = |count: u64| count * LINES / collisions;
        if tenth(pace.collisions) > tenth(shown) {
            line(&mut out, pace, begin.elapsed().as_secs_f64())?;
        }
        shown = pace.collisions;
        Ok(())
    });
    drop(progress);
    report(&mut out, &gas.pace, &overlaps)?;
    ran?;
    judge(&gas.pace, &overlaps)
}

fn line(out: &mut impl Write, pace: &Pace, wall: f64) -> Result<()> {
    let Pace { collisions, energy, units, time, .. } = pace;
    let power = |power: u32, sign: &str| match power {
        0 => String::new(),
        _ => format!(" × 2^{sign}{power}"),
    };
    let (slower, longer) = (power(40 * units, "-"), power(20 * units, ""));
    writeln!(out, "  {collisions:>12}  {wall:>11.1}  {energy:>13.4e}{slower}  {time:.6e}{longer}")?;
    Ok(out.flush()?)
}

fn report(out: &mut impl Write, pace: &Pace, overlaps: &Overlaps) -> Result<()> {
    let share = overlaps.overlapping as f64 / overlaps.impacts.max(1) as f64;
    writeln!(out, "  the unit of time was made 2^20 times longer: {} times", pace.units)?;
    writeln!(out, "  the gas streamed without colliding and was stirred: {} times", pace.stirred)?;
    writeln!(out, "  impacts {}, overlapping {share:.4}", overlaps.impacts)?;
    writeln!(out, "  impacts with a third grain overlapped: {}", overlaps.three_body)?;
    writeln!(out, "  deepest overlap: {:.3e}", -overlaps.deepest)?;
    writeln!(out, "  largest deepening of an overlap: {:.3e}", overlaps.decrease)?;
    writeln!(
        out,
        "  overlapping pairs that approach after an event: {}, at most at {:.1e} of their speed",
        overlaps.approaching, overlaps.fastest
    )?;
    writeln!(out, "  events before their predecessor: {}", pace.backward)?;
    writeln!(out, "  most collisions at one instant: {}", pace.at_once)?;
    let counters = pace.counters.iter().map(|(name, count)| format!("{name} {count}"));
    writeln!(out, "  counters: {}", counters.collect::<Vec<_>>().join(", "))?;
    Ok(())
}

/// What must not have happened.
fn judge(pace: &Pace, overlaps: &Overlaps) -> Result<()> {
    ensure!(pace.backward == 0, "{} events had a negative time step", pace.backward);
    ensure!(
        overlaps.decrease < DEEPER,
        "an overlap became deeper by {:.1e}, more than {DEEPER:.1e}",
        overlaps.decrease
    );
    Ok(())
}
