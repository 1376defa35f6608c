//! How does a comparison look on a terminal? Reads a comparison; writes a table as text.

use super::{Comparison, FOLLOWING, Summary};
use crate::report::write_aligned;
use anyhow::Result;
use std::io::Write;

const HEAD: [&str; 9] = [
    "method",
    "collisions",
    "energy [J]",
    "apart [R]",
    "rms [R]",
    "largest [R]",
    "follows to [s]",
    "cost [s]",
    "speed-up",
];

/// Prints the comparison: what each method got, what it cost, and what was out of the ordinary.
///
/// # Errors
/// What `sink` says.
pub fn print(sink: &mut dyn Write, comparison: &Comparison) -> Result<()> {
    writeln!(sink, "{} ({} grains)", comparison.title, comparison.grains)?;
    let mut rows = vec![HEAD.map(str::to_owned).to_vec()];
    rows.extend(comparison.methods.iter().map(|summary| row(comparison, summary).to_vec()));
    write_aligned(sink, &rows, 1)?;
    notes(sink, comparison)
}

fn row(comparison: &Comparison, summary: &Summary) -> [String; 9] {
    let radius = comparison.mean_radius;
    let is_judge = summary.method == comparison.judge;
    let dash = || "-".to_owned();
    let [median, rms, largest] = match summary.apart {
        Some(apart) if !is_judge => [apart.median, apart.rms, apart.largest]
            .map(|length| format!("{:.1e}", length / radius)),
        _ => [dash(), dash(), dash()],
    };
    [
        summary.method.label().to_owned(),
        summary.collisions.to_string(),
        format!("{:.6}", summary.kinetic_energy),
        median,
        rms,
        largest,
        match summary.followed_until {
            _ if is_judge => dash(),
            Some(time) => format!("{time:.3}"),
            None => format!("{:.3}+", comparison.judged_until),
        },
        seconds(summary.wall_seconds),
        summary.speed_up.filter(|_| !is_judge).map_or_else(dash, speed_up),
    ]
}

fn seconds(seconds: f64) -> String {
    if seconds < 0.01 { format!("{seconds:.1e}") } else { format!("{seconds:.3}") }
}

fn speed_up(factor: f64) -> String {
    if factor < 10.0 { format!("{factor:.2}") } else { format!("{factor:.0}") }
}

fn notes(sink: &mut dyn Write, comparison: &Comparison) -> Result<()> {
    let (judge, at) = (comparison.judge.label(), comparison.compared_at);
    writeln!(
        sink,
        "  apart: distance to where {judge} has the grain at t = {at:.4} s, median; grains in contact left out"
    )?;
    writeln!(
        sink,
        "  follows: until half of the grains are {FOLLOWING} R apart; speed-up: over MD (velocity Verlet)"
    )?;
    let end = comparison.methods.iter().map(|summary| summary.simulated).fold(0.0, f64::max);
    if comparison.judged_until < end {
        let until = comparison.judged_until;
        writeln!(sink, "  {judge} runs to t = {until} s only: collisions and energy are of then")?;
    }
    for summary in &comparison.methods {
        let told = ["rotation_refused", "interrupted", "clamped", "hard_sphere"];
        let list: Vec<String> = summary
            .counters
            .iter()
            .filter(|(name, _)| told.contains(name))
            .map(|(name, count)| format!("{} {count}", name.replace('_', " ")))
            .collect();
        if !list.is_empty() {
            writeln!(sink, "  {}: {}", summary.method.label(), list.join(", "))?;
        }
    }
    Ok(())
}
