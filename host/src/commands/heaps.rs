//! `carom soak --heaps`: can a heap stop the engine? Draws boxes and runs them; writes those that broke, and a line for each family.

use crate::heaps::{self, Drawn, Ended, Families, Number, Report, Summary};
use crate::progress::Progress;
use anyhow::{Result, ensure};
use rayon::prelude::*;
use std::io::Write;

/// The most grains of a box. Of more than 30 a small one's acceleration does not fit 16 binary places.
fn most(number: Number) -> usize {
    if number == Number::I16f16 { 30 } else { 200 }
}

/// Runs so many boxes from this seed on.
///
/// # Errors
/// A box that broke.
pub fn soak(boxes: u64, seed: u64, number: Number) -> Result<()> {
    let begin = std::time::Instant::now();
    let mut out = std::io::stdout().lock();
    let progress = Progress::new("heaps", boxes);
    let mut families = Families::new();
    let all: Vec<u64> = (0..boxes).map(|k| seed.wrapping_add(k)).collect();
    for some in all.chunks(64) {
        let ran: Vec<_> =
            some.par_iter().map(|&seed| heaps::run(seed, most(number), number)).collect();
        for (drawn, report) in &ran {
            families.entry(heaps::family(drawn)).or_default().add(drawn, report);
            if let Ended::Broken(what) = &report.ended {
                broken(&mut out, (drawn, report), what)?;
            }
        }
        progress.add(some.len() as u64);
    }
    drop(progress);
    table(&mut out, &families)?;
    let sum = |of: fn(&Summary) -> u64| families.values().map(of).sum::<u64>();
    let (broken, crushed) = (sum(|all| all.broken), sum(|all| all.crushed));
    let seconds = begin.elapsed().as_secs_f64();
    writeln!(
        out,
        "{boxes} boxes, {broken} broke, in {crushed} a grain was crushed; {seconds:.0} s"
    )?;
    ensure!(broken == 0, "{broken} of {boxes} boxes broke");
    Ok(())
}

fn broken(out: &mut impl Write, (drawn, report): (&Drawn, &Report), what: &str) -> Result<()> {
    let Drawn { seed, dimension, law, hard_walls, gravity, .. } = drawn;
    let count = drawn.count();
    writeln!(
        out,
        "--seed {seed}: {what}; {dimension}D, {count} grains, {law:?}, walls {hard_walls:?}, gravity {gravity:?}, {:.1} s",
        report.seconds
    )?;
    Ok(out.flush()?)
}

fn table(out: &mut impl Write, families: &Families) -> Result<()> {
    writeln!(
        out,
        "{:<40}{:>7}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>10}{:>9}{:>9}{:>8}",
        "family (time in (R/g)^½)",
        "boxes",
        "asleep",
        "median",
        "latest",
        "sliding",
        "crushed",
        "broken",
        "energy",
        "overlap",
        "coll./t",
        "s"
    )?;
    for (family, summary) in families {
        let size = if family.is_large { ", over 20" } else { "" };
        let name = format!("{}D {} {:?}{size}", family.dimension, family.law, family.gravity);
        let time = |time: Option<f64>| time.map_or("-".to_owned(), |time| format!("{time:.0}"));
        writeln!(
            out,
            "{name:<40}{:>7}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>10.1e}{:>9.3}{:>9.0}{:>8.1}",
            summary.boxes,
            summary.asleep.len(),
            time(summary.median()),
            time(summary.asleep.last().copied()),
            summary.sliding,
            summary.crushed,
            summary.broken,
            summary.rise,
            summary.deepest,
            summary.collisions,
            summary.slowest
        )?;
    }
    Ok(())
}
