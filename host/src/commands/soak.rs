//! `carom soak`: can anything stop a dissipative gas? Runs collisions by the million; writes what was seen and counted.

use crate::figure::Progress;
use crate::figure::hard::{Fluid, Soak, State};
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

/// Lines about progress.
const LINES: u64 = 10;

/// Runs.
///
/// # Errors
/// What the engine says, or what it should not have done.
pub fn run(options: &Options) -> Result<()> {
    let Options { collisions, restitution, grains, density, seed } = *options;
    let fluid = Fluid { grains: grains as usize, density, restitution, seed };
    let mut out = std::io::stdout().lock();
    writeln!(out, "{grains} hard spheres, density {density}, restitution {restitution}")?;
    writeln!(out, "  {:>12}  {:>11}  {:>13}  time", "collisions", "wall s", "energy/grain")?;
    let begin = std::time::Instant::now();
    let mut soak = Soak::new(fluid)?;
    let progress = Progress::new("soak", collisions);
    let mut shown = 0;
    let ran = soak.run(collisions, |state| {
        progress.add(state.collisions - shown);
        let tenth = |count: u64| count * LINES / collisions;
        if tenth(state.collisions) > tenth(shown) {
            line(&mut out, state, begin.elapsed().as_secs_f64())?;
        }
        shown = state.collisions;
        Ok(())
    });
    drop(progress);
    report(&mut out, &soak.state)?;
    ran?;
    judge(&soak.state)
}

fn line(out: &mut impl Write, state: &State, wall: f64) -> Result<()> {
    let State { collisions, energy, units, time, .. } = state;
    let unit = |power: u32| if power == 0 { String::new() } else { format!(" × 2^{power}") };
    let (slower, longer) = (format!(" × 2^-{}", 40 * units), unit(20 * units));
    let slower = if *units == 0 { "" } else { &slower };
    writeln!(out, "  {collisions:>12}  {wall:>11.1}  {energy:>13.4e}{slower}  {time:.6e}{longer}")?;
    Ok(out.flush()?)
}

fn report(out: &mut impl Write, state: &State) -> Result<()> {
    let State { overlaps, counters, units, at_once, backward, .. } = state;
    let share = overlaps.overlapping as f64 / overlaps.impacts.max(1) as f64;
    writeln!(out, "  unit of time made 2^20 times longer: {units} times")?;
    writeln!(out, "  impacts {}, overlapping {:.4}", overlaps.impacts, share)?;
    writeln!(out, "  impacts with a third grain overlapped: {}", overlaps.three_body)?;
    writeln!(out, "  deepest overlap: {:.3e}", -overlaps.deepest)?;
    writeln!(out, "  largest deepening of an overlap: {:.3e}", overlaps.decrease)?;
    writeln!(
        out,
        "  overlapping pairs that approach after an event: {}, at most at {:.1e} of their speed",
        overlaps.approaching, overlaps.fastest
    )?;
    writeln!(out, "  events before their predecessor: {backward}")?;
    writeln!(out, "  most collisions at one instant: {at_once}")?;
    writeln!(out, "  counters: {counters:?}")?;
    Ok(())
}

/// What must not have happened.
fn judge(state: &State) -> Result<()> {
    ensure!(state.backward == 0, "{} events had a negative time step", state.backward);
    Ok(())
}
