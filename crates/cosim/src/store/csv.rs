//! Runs as comma-separated values: `time,xd0,..,x0,..`, the columns of the recorded runs; then `yd0,..,y0,..`
//! where drones fly in the plane, and the other variables with their units, `plant0.theta [rad]`.

use std::io::Write;
use std::sync::mpsc::sync_channel;

use crate::record::{Record, Series, Track};
use cordon_core::text::cut;
use cordon_core::{Error, Result};

/// Size of the blocks passed to the writer, in bytes.
const PIECE: usize = 1 << 17;

/// Writes a header, then one line per grid point. Every number is the shortest decimal that reads back
/// as the same double.
///
/// # Errors
/// `out` cannot be written.
pub fn csv(record: &Record, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}", heads(record).join(","))?;
    // Formatting and writing run in parallel.
    std::thread::scope(|scope| {
        let (ready, pieces) = sync_channel::<Vec<u8>>(4);
        scope.spawn(move || {
            let mut piece = Vec::with_capacity(PIECE);
            let mut lines = Lines::default();
            for row in 0..record.rows() {
                lines.line(record, row, &mut piece);
                if piece.len() > PIECE / 2 || row + 1 == record.rows() {
                    let full = std::mem::replace(&mut piece, Vec::with_capacity(PIECE));
                    // The reader is gone where writing failed.
                    if ready.send(full).is_err() {
                        return;
                    }
                }
            }
        });
        pieces.into_iter().try_for_each(|piece| Ok(out.write_all(&piece)?))
    })
}

/// The headings of all columns.
pub(super) fn heads(record: &Record) -> Vec<String> {
    let positions = record.positions().flat_map(|(prefix, _)| named(prefix, record.count));
    let series = record.series.iter().map(|s| quoted(s.head()));
    std::iter::once("time".to_owned()).chain(positions).chain(series).collect()
}

fn named(prefix: &str, count: usize) -> impl Iterator<Item = String> {
    (0..count).map(move |i| format!("{prefix}{i}"))
}

/// Formats rows. Desired positions do not change between updates, so their text is reused.
#[derive(Default)]
struct Lines {
    /// For each block of columns the text of the last row.
    blocks: Vec<Vec<u8>>,
}

impl Lines {
    fn line(&mut self, record: &Record, row: usize, text: &mut Vec<u8>) {
        number(record.times.get(row).copied().unwrap_or_default(), text);
        for (index, (_, numbers)) in record.positions().enumerate() {
            if self.blocks.len() == index {
                self.blocks.push(Vec::new());
            }
            let Some(block) = self.blocks.get_mut(index) else { continue };
            let now = record.at(numbers, row);
            let before = row.checked_sub(1).map(|row| record.at(numbers, row));
            let same = |a: &[f64]| a.iter().zip(now).all(|(a, b)| a.to_bits() == b.to_bits());
            if !before.is_some_and(same) {
                block.clear();
                now.iter().for_each(|x| field(*x, block));
            }
            text.extend_from_slice(block);
        }
        record.series.iter().filter_map(|s| s.values.get(row)).for_each(|x| field(*x, text));
        text.push(b'\n');
    }
}

fn field(x: f64, text: &mut Vec<u8>) {
    text.push(b',');
    number(x, text);
}

/// A number in Rust's notation, `{:?}`.
fn number(x: f64, text: &mut Vec<u8>) {
    // The printers may differ only where two decimals are equally short and equally near, which needs a
    // number with few binary places.
    if (1e-4..1e16).contains(&x.abs()) && !(1..=24).contains(&binary_places(x)) {
        text.extend_from_slice(zmij::Buffer::new().format_finite(x).as_bytes());
    } else {
        // Zero, and numbers with an exponent.
        text.extend_from_slice(format!("{x:?}").as_bytes());
    }
}

/// The number of digits after the binary point of a normal number; negative where it ends in zeros
/// before the point.
fn binary_places(x: f64) -> i64 {
    let (bits, digits) = (x.to_bits(), i64::from(f64::MANTISSA_DIGITS) - 1);
    let exponent = (bits >> digits & 0x7ff) as i64 - 1023;
    let zeros = (bits | 1 << digits).trailing_zeros();
    digits - exponent - i64::from(zeros)
}

/// A heading as it stands in a line: names in other tools may contain commas.
fn quoted(head: String) -> String {
    match head.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", head.replace('"', "\"\"").replace(['\n', '\r'], " ")),
        false => head,
    }
}

/// The headings of a line, as written by [`quoted`].
fn unquoted(line: &str) -> Vec<String> {
    let (mut heads, mut within) = (vec![String::new()], false);
    let mut characters = line.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '"' if within && characters.next_if_eq(&'"').is_some() => push(&mut heads, c),
            '"' => within = !within,
            ',' if !within => heads.push(String::new()),
            c => push(&mut heads, c),
        }
    }
    heads
}

fn push(heads: &mut [String], c: char) {
    if let Some(head) = heads.last_mut() {
        head.push(c);
    }
}

/// An empty record with the shape given by the headings of its columns.
fn shaped(name: &str, heads: &[String]) -> Option<Record> {
    let (time, rest) = heads.split_first()?;
    let count = rest.iter().zip(named("xd", usize::MAX)).take_while(|(a, b)| *a == b).count();
    let block = |rest: &[String], prefix| {
        let begins = rest.iter().zip(named(prefix, count)).take_while(|(a, b)| *a == b).count();
        begins == count && count > 0
    };
    let after = |rest: &[String], n: usize| rest.get(n..).map(<[String]>::to_vec);
    let rest = after(rest, count).filter(|rest| block(rest, "x"))?;
    let mut rest = after(&rest, count)?;
    let mut planar = false;
    if block(&rest, "yd") {
        rest = after(&rest, count).filter(|rest| block(rest, "y"))?;
        rest = after(&rest, count)?;
        planar = true;
    }
    let series = rest.iter().map(|head| {
        let (name, unit) = head.strip_suffix(']')?.rsplit_once(" [")?;
        Some(Series { name: name.to_owned(), unit: unit.to_owned(), values: Vec::new() })
    });
    let series = series.collect::<Option<_>>()?;
    (time == "time").then(|| Record {
        title: name.to_owned(),
        count,
        times: Vec::new(),
        x: Track::default(),
        y: planar.then(Track::default),
        height: None,
        series,
        events: None,
        setup: None,
        notes: Vec::new(),
        broken_off: None,
    })
}

/// Parses the output of [`csv`]. `name` stands for the file in messages.
pub(super) fn parse(name: &str, text: &str) -> Result<Record> {
    let fail = |line: usize, what: String| Error::input(format!("{name}:{line}: {what}"));
    if !text.is_empty() && !text.ends_with('\n') {
        let last = text.lines().count();
        return Err(fail(last, "the last line is cut off: expected an end of line".to_owned()));
    }
    let mut lines = text.lines().zip(1..);
    let heads = unquoted(lines.next().map(|(head, _)| head).unwrap_or_default());
    let mut record = shaped(name, &heads).ok_or_else(|| {
        let what = "expected the columns time, xd0, xd1, .., x0, x1, .., of a co-simulated run, and \
                    others with their units, `plant0.theta [rad]`";
        fail(1, what.to_owned())
    })?;
    let (count, columns) = (record.count, heads.len());
    for (text, line) in lines {
        let fields = text.split(',').count();
        if fields != columns {
            return Err(fail(line, format!("{fields} fields: expected {columns}")));
        }
        let mut numbers = Vec::with_capacity(columns);
        for field in text.split(',') {
            let number = field.parse::<f64>().ok().filter(|x| x.is_finite());
            let number = number.ok_or_else(|| {
                fail(line, format!("`{}`: expected a finite number", cut(field, 40)))
            })?;
            numbers.push(number);
        }
        let mut rest = numbers.into_iter();
        record.times.extend(rest.next());
        let tracks = [Some(&mut record.x), record.y.as_mut()].into_iter().flatten();
        for track in tracks {
            track.desired.extend(rest.by_ref().take(count));
            track.actual.extend(rest.by_ref().take(count));
        }
        record.series.iter_mut().zip(rest).for_each(|(s, x)| s.values.push(x));
    }
    // The head is the first line.
    super::check(name, &record, |row| format!("{name}:{}", row + 2))?;
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_rust_writes_them() {
        let mut compared = 0;
        let mut state = 1_u64;
        let mut check = |x: f64| {
            let mut text = Vec::new();
            number(x, &mut text);
            assert_eq!(String::from_utf8_lossy(&text), format!("{x:?}"));
            compared += 1;
        };
        for exponent in -330..=310 {
            for digits in ["1", "-1", "9.999999999999999", "1.2345678", "5e-1"] {
                let (mantissa, shift) = digits.split_once('e').unwrap_or((digits, "0"));
                let exponent = exponent + shift.parse::<i32>().unwrap_or_default();
                if let Ok(x) = format!("{mantissa}e{exponent}").parse::<f64>()
                    && x.is_finite()
                {
                    check(x);
                }
            }
        }
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let x = f64::from_bits(state);
            if x.is_finite() {
                check(x);
            }
            check((state >> 20) as f64 / 1e9);
            check((state >> 44) as f64 / 65_536.0);
        }
        assert!(compared > 40_000, "{compared}");
    }

    #[test]
    fn heads_with_commas_come_back() {
        for head in ["plant0.z [m]", "plant1.a[1,2] [1]", "plant1.\"q\",\" [m/s2]"] {
            let line = format!("time,{},x", quoted(head.to_owned()));
            assert_eq!(unquoted(&line), ["time", head, "x"]);
        }
    }
}
