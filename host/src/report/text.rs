//! How do rows of text become a table? Reads rows; writes aligned lines.

use anyhow::Result;
use std::io::Write;

/// Writes rows as a table, the first one as its head: the first `left` columns flush left, the
/// others flush right.
///
/// # Errors
/// What `sink` says.
pub fn write_aligned(sink: &mut dyn Write, rows: &[Vec<String>], left: usize) -> Result<()> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let length = |row: &Vec<String>, k: usize| row.get(k).map_or(0, |cell| cell.chars().count());
    let widths: Vec<usize> = (0..columns)
        .map(|column| rows.iter().map(|row| length(row, column)).max().unwrap_or(0))
        .collect();
    for (number, row) in rows.iter().enumerate() {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
            if column < left { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        writeln!(sink, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
        if number == 0 {
            let total = widths.iter().sum::<usize>() + 2 * columns.saturating_sub(1);
            writeln!(sink, "  {}", "-".repeat(total))?;
        }
    }
    Ok(())
}
