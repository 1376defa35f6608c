//! How does a figure read as text? Reads its data and notes; writes a table.

use super::{Figure, Made, Note, Series, Value};
use anyhow::Result;
use std::io::Write;

/// Points of a curve that are printed.
const MOST: usize = 40;

/// Prints the data, then the comparison with the paper.
///
/// # Errors
/// What the sink says.
pub fn print(out: &mut impl Write, what: &str, made: &Made) -> Result<()> {
    let Figure { id, axes, series } = &made.figure;
    writeln!(out, "{id}: {what}")?;
    writeln!(out, "  x: {}\n  y: {}", axes.x, axes.y)?;
    for series in series {
        curve(out, series)?;
    }
    if !made.notes.is_empty() {
        comparison(out, &made.notes)?;
    }
    Ok(())
}

fn curve(out: &mut impl Write, series: &Series) -> Result<()> {
    let params: Vec<_> = series.params.iter().map(|(k, v)| format!("{k} = {}", shown(v))).collect();
    writeln!(out, "\n  {} ({})", series.name, params.join(", "))?;
    let count = series.x.len();
    let every = count.div_ceil(MOST).max(1);
    if every > 1 {
        writeln!(out, "    (one of {every} of {count} points; --json prints all)")?;
    }
    for (i, (x, y)) in series.x.iter().zip(&series.y).enumerate().step_by(every) {
        let error = series.yerr.get(i).map_or_else(String::new, |e| format!("  ± {}", number(*e)));
        writeln!(out, "    {:>14}  {:>14}{error}", number(*x), number(*y))?;
    }
    Ok(())
}

fn comparison(out: &mut impl Write, notes: &[Note]) -> Result<()> {
    let width = |of: fn(&Note) -> &String| {
        notes.iter().map(|note| of(note).chars().count()).max().unwrap_or(0)
    };
    let (what, paper) = (width(|note| &note.what), width(|note| &note.paper).max(10));
    writeln!(out, "\n  {:what$}  {:paper$}  we get", "", "paper says")?;
    for note in notes {
        writeln!(out, "  {:what$}  {:paper$}  {}", note.what, note.paper, note.ours)?;
    }
    Ok(())
}

fn shown(value: &Value) -> String {
    match value {
        Value::Number(x) => number(*x),
        Value::Text(text) => text.clone(),
    }
}

/// Six digits, as short as they can be.
fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if (1e-3..1e7).contains(&x.abs()) {
        let digits = (5 - x.abs().log10().floor() as i32).clamp(0, 8) as usize;
        let text = format!("{x:.digits$}");
        if !text.contains('.') {
            return text;
        }
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{x:.5e}")
}
