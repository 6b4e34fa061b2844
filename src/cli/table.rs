//! Tables as they come, placements, and long lists in short.

use std::io::Write;

use cordon_core::exact::fraction;
use cordon_core::table::{line, lines, widths};
use cordon_core::text::cut;
use cordon_core::{Rational, Result};

/// Widest table of a run, in characters: wider ones are not readable in lines.
const WIDEST: usize = 160;

/// Widest table of a trace, in characters.
const WIDEST_TRACE: usize = 200;

/// Longest number in such a table, in characters: the command that replays the run has all of it.
const LONGEST: usize = 60;

/// Longest run that is shown in full; of longer ones, half as many states from each end.
const MOST_STATES: usize = 40;

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
/// Wide tables show the columns at both ends that fit.
///
/// # Errors
/// `out` cannot be written.
pub fn stream(
    head: &[String],
    known: Option<&[usize]>,
    rows: impl Iterator<Item = Vec<String>>,
    out: &mut dyn Write,
) -> Result<()> {
    let mut lines = std::iter::once(head.to_vec()).chain(rows);
    let (gathered, mut widths) = match known {
        None => {
            let all: Vec<_> = lines.by_ref().collect();
            let widths = widths(&all);
            (all, widths)
        }
        Some(_) => (Vec::new(), widths(&[head.to_vec()])),
    };
    let known = known.unwrap_or_default();
    widths.iter_mut().zip(known).for_each(|(width, known)| *width = (*width).max(*known));
    let gap = at_both_ends(&widths);
    widths.splice(gap.clone(), (!gap.is_empty()).then_some(GAP.len()));
    for mut row in gathered.into_iter().chain(lines) {
        if row.len() >= gap.end {
            row.splice(gap.clone(), (!gap.is_empty()).then(|| GAP.to_owned()));
        }
        writeln!(out, "{}", line(&row, &widths, |_| false))?;
    }
    if let (Some(first), Some(last)) = (head.get(gap.start), head.get(gap.end.wrapping_sub(1)))
        && !gap.is_empty()
    {
        writeln!(out, "(columns {first} to {last} are left out here: --format csv has all)")?;
    }
    Ok(())
}

/// What stands for columns or rows that are left out.
const GAP: &str = "...";

/// The columns in the middle that are left out, so that those at both ends fit.
fn at_both_ends(widths: &[usize]) -> std::ops::Range<usize> {
    let wide = |width: &usize| width + 2;
    if widths.iter().map(wide).sum::<usize>() <= WIDEST_TRACE + 2 {
        return 0..0;
    }
    let mut left = WIDEST_TRACE - GAP.len();
    let (mut start, mut end) = (0, widths.len());
    while start < end {
        let next = if start <= widths.len() - end { start } else { end - 1 };
        match widths.get(next).and_then(|width| left.checked_sub(wide(width))) {
            Some(rest) => left = rest,
            None => break,
        }
        if next == start { start += 1 } else { end -= 1 }
    }
    start..end
}

/// Writes one line a placement, exact, as [`run`] does.
///
/// # Errors
/// `out` cannot be written.
pub fn placements(run: &[Vec<Rational>], out: &mut dyn Write) -> Result<()> {
    let count = run.first().map_or(0, Vec::len);
    let head = std::iter::once("step".to_owned()).chain(names(count)).collect();
    let number = |x: &Rational| cut(&fraction(x), LONGEST);
    let row = |(k, x): (usize, &Vec<Rational>)| {
        std::iter::once(k.to_string()).chain(x.iter().map(number)).collect()
    };
    self::run(head, run.iter().enumerate().map(row).collect(), &[], |_| false, out)
}

/// A number of things: `1 half-space`, `2 half-spaces`.
pub fn counted(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// Writes a run, a row a state: of long ones the ends, of wide ones the columns that fit: the first, `kept`,
/// those beside `kept`, and from the left on. Columns are aligned to the right, but for those of `left`.
///
/// # Errors
/// `out` cannot be written.
pub fn run(
    head: Vec<String>,
    states: Vec<Vec<String>>,
    kept: &[usize],
    left: impl Fn(usize) -> bool,
    out: &mut dyn Write,
) -> Result<()> {
    let end = MOST_STATES / 2;
    let skipped = if states.len() > MOST_STATES { end..states.len() - end } else { 0..0 };
    let mut rows = vec![head];
    for (k, row) in states.into_iter().enumerate().filter(|(k, _)| !skipped.contains(k)) {
        if k == skipped.end && k > 0 {
            rows.push(vec![GAP.to_owned()]);
        }
        rows.push(row);
    }
    let widths = widths(&rows);
    let near = |by: usize| kept.iter().flat_map(move |k| [k.wrapping_sub(by), k + by]);
    let order = [0].into_iter().chain((0..=MOST_NEAR).flat_map(near)).chain(0..widths.len());
    let mut shown = vec![false; widths.len()];
    let mut room = WIDEST - 2;
    for column in order {
        let (Some(width), Some(slot)) = (widths.get(column), shown.get_mut(column)) else {
            continue;
        };
        match room.checked_sub(if *slot { 0 } else { width + 2 }) {
            Some(rest) => (room, *slot) = (rest, true),
            None => break,
        }
    }
    // Each gap as one column.
    let mut columns: Vec<Option<usize>> = Vec::new();
    for (column, shown) in shown.iter().enumerate() {
        match (shown, columns.last()) {
            (true, _) => columns.push(Some(column)),
            (false, Some(None)) => {}
            (false, _) => columns.push(None),
        }
    }
    let text = |row: &Vec<String>| -> Vec<String> {
        let is_whole = row.len() > 1;
        let cell = |column: &Option<usize>| match column {
            Some(column) => row.get(*column).cloned(),
            None => is_whole.then(|| GAP.to_owned()),
        };
        columns.iter().map_while(cell).collect()
    };
    let rows: Vec<Vec<String>> = rows.iter().map(text).collect();
    for line in lines(&rows, |shown| columns.get(shown).copied().flatten().is_some_and(&left)) {
        writeln!(out, "  {line}")?;
    }
    Ok(())
}

/// Columns beside one that is kept.
const MOST_NEAR: usize = 2;

/// The heads of the positions' columns.
pub fn names(count: usize) -> impl Iterator<Item = String> {
    (0..count).map(|i| format!("x{i}"))
}

/// The items with commas between; of more than eight, which are sorted, the ends and how many.
pub fn abridged(items: &[String]) -> String {
    match items {
        [first, .., last] if items.len() > 8 => {
            format!("{first} ... {last} ({} in all)", items.len())
        }
        _ => items.join(", "),
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

    /// A cell that takes two lines.
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
