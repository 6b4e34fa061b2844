//! Exact placements as a table, and long lists in short.

use std::io::Write;

use cordon_core::exact::fraction;
use cordon_core::{Rational, Result};

/// Widest table, in characters: beyond that only first and last columns would be readable.
const WIDEST: usize = 160;

/// Writes one line a placement, aligned, exact; of wide ones the columns that fit.
pub fn placements(run: &[Vec<Rational>], out: &mut dyn Write) -> Result<()> {
    let cells: Vec<Vec<String>> = run.iter().map(|x| x.iter().map(fraction).collect()).collect();
    let count = cells.first().map_or(0, Vec::len);
    let mut widths: Vec<usize> = (0..count).map(|i| format!("x{i}").len()).collect();
    for row in &cells {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.len());
        }
    }
    let mut shown = 0;
    let mut total = 8;
    for width in &widths {
        total += width + 2;
        if total > WIDEST {
            break;
        }
        shown += 1;
    }
    let dots = if shown < count { "  ..." } else { "" };
    let line = |label: &str, row: &[String]| {
        let cells = row.iter().zip(&widths).take(shown);
        let text: String = cells.map(|(c, w)| format!("  {c:>w$}")).collect();
        format!("  {label:>4}{text}{dots}")
    };
    let header: Vec<String> = (0..count).map(|i| format!("x{i}")).collect();
    writeln!(out, "{}", line("step", &header))?;
    for (k, row) in cells.iter().enumerate() {
        writeln!(out, "{}", line(&k.to_string(), row))?;
    }
    Ok(())
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
