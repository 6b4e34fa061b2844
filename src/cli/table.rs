//! Tables in text, and long lists in short.

use std::io::Write;

use cordon_core::exact::fraction;
use cordon_core::{Rational, Result};

/// Widest table of placements, in characters: beyond that only first and last columns would be
/// readable.
const WIDEST: usize = 160;

/// The lines of a table whose first row is its header: columns two blanks apart, those that
/// `left` names aligned to the left and the others to the right.
pub fn lines(rows: &[Vec<String>], left: impl Fn(usize) -> bool) -> Vec<String> {
    let widths = widths(rows);
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, &width))| {
            if left(i) { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

/// Writes such a table, all columns to the right.
pub fn write(rows: &[Vec<String>], out: &mut dyn Write) -> Result<()> {
    for line in lines(rows, |_| false) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// The width of the widest cell of each column, in characters.
fn widths(rows: &[Vec<String>]) -> Vec<usize> {
    let mut widths = Vec::new();
    for row in rows {
        widths.resize(widths.len().max(row.len()), 0);
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    widths
}

/// Writes one line a placement, exact; of wide ones the columns that fit.
pub fn placements(run: &[Vec<Rational>], out: &mut dyn Write) -> Result<()> {
    let count = run.first().map_or(0, Vec::len);
    let mut rows = vec![std::iter::once("step".to_owned()).chain(names(count)).collect()];
    for (k, x) in run.iter().enumerate() {
        rows.push(std::iter::once(k.to_string()).chain(x.iter().map(fraction)).collect::<Vec<_>>());
    }
    let ends = widths(&rows).into_iter().scan(2, |end, width| {
        *end += width + 2;
        Some(*end)
    });
    let shown = ends.take_while(|end| *end <= WIDEST).count();
    for row in rows.iter_mut().filter(|row| row.len() > shown) {
        row.truncate(shown);
        row.push("...".to_owned());
    }
    for line in lines(&rows, |_| false) {
        writeln!(out, "  {line}")?;
    }
    Ok(())
}

/// The heads of the positions' columns.
pub fn names(count: usize) -> impl Iterator<Item = String> {
    (0..count).map(|i| format!("x{i}"))
}

/// The items with commas between; of more than eight, which are sorted, the ends and how many.
pub fn abridged(weights: &[String]) -> String {
    match weights {
        [first, .., last] if weights.len() > 8 => {
            format!("{first} ... {last} ({} weights)", weights.len())
        }
        _ => weights.join(", "),
    }
}
