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
    rows.iter().map(|row| line(row, &widths, &left)).collect()
}

fn line(row: &[String], widths: &[usize], left: impl Fn(usize) -> bool) -> String {
    let cells = row.iter().zip(widths).enumerate().map(|(i, (cell, &width))| {
        // Not by a format's width, which ends at 65,535.
        let blanks = " ".repeat(width.saturating_sub(cell.chars().count()));
        if left(i) { format!("{cell}{blanks}") } else { format!("{blanks}{cell}") }
    });
    cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
}

/// Writes such a table, all columns to the right.
///
/// # Errors
/// `out` cannot be written.
pub fn write(rows: &[Vec<String>], out: &mut dyn Write) -> Result<()> {
    for line in lines(rows, |_| false) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// Writes head and rows, all columns to the right; row by row as they come where the widths of
/// the columns are known beforehand.
///
/// # Errors
/// `out` cannot be written.
pub fn stream(
    head: &[String],
    known: Option<&[usize]>,
    rows: impl Iterator<Item = Vec<String>>,
    out: &mut dyn Write,
) -> Result<()> {
    let Some(known) = known else {
        let all: Vec<_> = std::iter::once(head.to_vec()).chain(rows).collect();
        return write(&all, out);
    };
    let mut widths = widths(&[head.to_vec()]);
    widths.iter_mut().zip(known).for_each(|(width, known)| *width = (*width).max(*known));
    writeln!(out, "{}", line(head, &widths, |_| false))?;
    for row in rows {
        writeln!(out, "{}", line(&row, &widths, |_| false))?;
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::cell::Cell;
    use std::io;

    use super::*;

    #[test]
    fn columns_may_be_wider_than_a_format_allows() {
        let rows = [vec!["x0".to_owned()], vec!["7".repeat(70_000)]];
        let lines = lines(&rows, |_| false);
        assert_eq!(lines[0].len(), 70_000);
        assert!(lines[0].ends_with(" x0"));
    }

    #[test]
    fn known_widths_make_the_same_table() {
        let head = ["step", "x0"].map(String::from);
        let lines = || (8..12).map(|i| vec![i.to_string(), format!("{:.3}", f64::from(i))]);
        let (mut gathered, mut streamed) = (Vec::new(), Vec::new());
        stream(&head, None, lines(), &mut gathered).unwrap();
        stream(&head, Some(&[2, 6]), lines(), &mut streamed).unwrap();
        assert_eq!(gathered, streamed);
        assert_eq!(gathered.split(|&c| c == b'\n').nth(1).unwrap(), b"   8   8.000");
    }

    /// Takes two lines.
    struct Full(u32);

    impl Write for Full {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if bytes.contains(&b'\n') {
                self.0 += 1;
            }
            if self.0 > 2 { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(bytes.len()) }
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn lines_are_written_as_they_come() {
        let made = Cell::new(0);
        let lines = (0..1000).map(|i| {
            made.set(made.get() + 1);
            vec![i.to_string()]
        });
        assert!(stream(&["step".to_owned()], Some(&[3]), lines, &mut Full(0)).is_err());
        assert_eq!(made.get(), 2, "lines made until the reader is gone");
    }
}
