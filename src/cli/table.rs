//! Tables of streamed rows, placements, and abridged lists.

use std::io::Write;

use cordon_core::exact::fraction;
use cordon_core::table::{line, lines, widths};
use cordon_core::text::cut;
use cordon_core::{Rational, Result};

/// Widest table of placements, in characters: wider ones show only the first and last columns.
const WIDEST: usize = 160;

/// Longest number in such a table, in characters: the command that replays the run has all of it.
const LONGEST: usize = 60;

/// Longest run that is shown in full; of longer ones, half as many placements from each end.
const MOST_PLACEMENTS: usize = 40;

/// Writes a table whose first row is its header, right-aligned.
///
/// # Errors
/// `out` cannot be written.
pub fn write(rows: &[Vec<String>], out: &mut dyn Write) -> Result<()> {
    for line in lines(rows, |_| false) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// Writes head and rows, right-aligned; row by row if the widths of the columns are known in advance.
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

/// Writes one line per placement, with exact numbers; the columns that fit, and for long runs the ends.
pub fn placements(run: &[Vec<Rational>], out: &mut dyn Write) -> Result<()> {
    let count = run.first().map_or(0, Vec::len);
    let mut rows = vec![std::iter::once("step".to_owned()).chain(names(count)).collect()];
    let end = MOST_PLACEMENTS / 2;
    let left_out = if run.len() > MOST_PLACEMENTS { end..run.len() - end } else { 0..0 };
    for (k, x) in run.iter().enumerate().filter(|(k, _)| !left_out.contains(k)) {
        if k == left_out.end && k > 0 {
            rows.push(vec!["...".to_owned()]);
        }
        let number = |x| cut(&fraction(x), LONGEST);
        rows.push(std::iter::once(k.to_string()).chain(x.iter().map(number)).collect::<Vec<_>>());
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

/// The headings of the columns of positions.
pub fn names(count: usize) -> impl Iterator<Item = String> {
    (0..count).map(|i| format!("x{i}"))
}

/// The items, separated by commas; of more than eight, which must be sorted, only the ends and the
/// number.
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
    fn known_widths_make_the_same_table() {
        let head = ["step", "x0"].map(String::from);
        let lines = || (8..12).map(|i| vec![i.to_string(), format!("{:.3}", f64::from(i))]);
        let (mut gathered, mut streamed) = (Vec::new(), Vec::new());
        stream(&head, None, lines(), &mut gathered).unwrap();
        stream(&head, Some(&[2, 6]), lines(), &mut streamed).unwrap();
        assert_eq!(gathered, streamed);
        assert_eq!(gathered.split(|&c| c == b'\n').nth(1).unwrap(), b"   8   8.000");
    }

    #[test]
    fn long_runs_and_long_numbers_are_cut() {
        let number = |n: i32| Rational::from_integer(n.into());
        let shown = |run: &[Vec<Rational>]| {
            let mut out = Vec::new();
            placements(run, &mut out).unwrap();
            String::from_utf8(out).unwrap()
        };
        let run = |last| (0..=last).map(|k| vec![number(0), number(k)]).collect::<Vec<_>>();
        assert_eq!(shown(&run(39)).lines().count(), 41, "a head and 40 placements");
        let long = shown(&run(1_000));
        let lines: Vec<_> = long.lines().map(str::trim).collect();
        assert_eq!(lines.len(), 42);
        assert!(lines[20].starts_with("19 ") && lines[22].starts_with("981 "), "{long}");
        assert_eq!(lines[21], "...");
        assert!(lines[41].starts_with("1000 "), "{long}");
        let long = Rational::from_integer(num_traits::pow(num_bigint::BigInt::from(10), 99));
        assert!(shown(&[vec![long]]).ends_with(&format!("1{}...\n", "0".repeat(59))));
    }

    /// A writer that is full after two lines.
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
