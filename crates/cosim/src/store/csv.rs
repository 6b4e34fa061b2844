//! Runs as comma-separated values: `time,xd0,..,x0,..`, the columns of the recorded runs.

use std::io::Write;

use crate::record::Record;
use cordon_core::{Error, Result};

/// Writes a head line, then one line a grid point. Every number is the shortest decimal that
/// reads back as the same double.
///
/// # Errors
/// `out` cannot be written.
pub fn csv(record: &Record, out: &mut dyn Write) -> Result<()> {
    write!(out, "time")?;
    for prefix in ["xd", "x"] {
        for i in 0..record.count {
            write!(out, ",{prefix}{i}")?;
        }
    }
    writeln!(out)?;
    for (row, time) in record.times.iter().enumerate() {
        write!(out, "{time:?}")?;
        for x in record.desired_at(row).iter().chain(record.actual_at(row)) {
            write!(out, ",{x:?}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Reads what [`csv`] writes. `name` stands for the file in messages.
pub(super) fn parse(name: &str, text: &str) -> Result<Record> {
    let fail = |line: usize, what: String| Error::input(format!("{name}:{line}: {what}"));
    if !text.is_empty() && !text.ends_with('\n') {
        let last = text.lines().count();
        return Err(fail(last, "the last line is cut off: expected an end of line".to_owned()));
    }
    let mut lines = text.lines().zip(1..);
    let head = lines.next().map(|(head, _)| head).unwrap_or_default();
    let columns = head.split(',').count();
    let count = columns.saturating_sub(1) / 2;
    let names = ["xd", "x"].into_iter().flat_map(|p| (0..count).map(move |i| format!("{p}{i}")));
    let expected: Vec<String> = std::iter::once("time".to_owned()).chain(names).collect();
    if count == 0 || !head.split(',').eq(expected.iter().map(String::as_str)) {
        return Err(fail(
            1,
            "expected the columns time, xd0, xd1, .., x0, x1, .., of a co-simulated run".to_owned(),
        ));
    }
    let mut record = Record {
        title: name.to_owned(),
        count,
        times: Vec::new(),
        desired: Vec::new(),
        actual: Vec::new(),
        events: None,
        setup: None,
        notes: Vec::new(),
        broken_off: None,
    };
    for (text, line) in lines {
        let fields = text.split(',').count();
        if fields != columns {
            return Err(fail(line, format!("{fields} fields: expected {columns}")));
        }
        for (place, field) in text.split(',').enumerate() {
            let number = field.parse::<f64>().ok().filter(|x| x.is_finite());
            let number =
                number.ok_or_else(|| fail(line, format!("`{field}`: expected a finite number")))?;
            match place {
                0 => record.times.push(number),
                p if p <= count => record.desired.push(number),
                _ => record.actual.push(number),
            }
        }
    }
    super::check(name, &record)?;
    Ok(record)
}
