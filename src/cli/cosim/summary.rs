//! A run in words: the positions of the drones every few seconds, and the events.

use std::io::Write;

use crate::cli::table;
use cordon_core::exact::fraction;
use cordon_core::{Evidence, Rational, Result};
use cordon_cosim::collision::{Event, EventKind};
use cordon_cosim::physics::Body;
use cordon_cosim::record::Record;

/// Approximate number of rows of the table.
const ROWS: usize = 10;

/// Most events listed; the others are counted.
const LISTED: usize = 12;

/// Writes a table of desired and actual positions, the events and the smallest gap, together with the
/// certified one, `known`.
///
/// # Errors
/// `out` cannot be written.
pub fn text(record: &Record, known: Option<&Rational>, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}", record.title)?;
    if let Some(s) = &record.setup {
        write!(out, "{}", s.protocol)?;
        if let Some((min, max)) = &s.segment {
            write!(out, " of [{min}, {max}]")?;
        }
        let (rhythm, with) = (s.rhythm(), s.flown_with());
        writeln!(out, ", N = {}{}, {rhythm}; {with}", record.count, s.weighted())?;
    }
    writeln!(out)?;
    positions(record, out)?;
    events(record, out)?;
    smallest_gap(record, known, out)?;
    if let Some(why) = &record.broken_off {
        writeln!(out, "\nthe run broke off: {why}")?;
    }
    Ok(())
}

fn positions(record: &Record, out: &mut dyn Write) -> Result<()> {
    let axes = record.tracks().count();
    let shown = record.count.min(8 / axes.max(1));
    let last = record.rows().saturating_sub(1);
    let every = (last / ROWS).max(1);
    let mut head = vec!["t [s]".to_owned()];
    for (name, _) in record.positions() {
        let name = name.replace('d', "_d");
        head.extend((0..shown).map(|i| format!("{name}{i}")));
    }
    let mut rows = vec![head];
    let shown_rows = (0..=last).filter(|row| row % every == 0 || *row == last);
    for row in shown_rows {
        let time = record.times.get(row).copied().unwrap_or_default();
        let mut cells = vec![format!("{time:.2}")];
        for (_, numbers) in record.positions() {
            cells.extend(record.at(numbers, row).iter().take(shown).map(|x| format!("{x:.2}")));
        }
        rows.push(cells);
    }
    table::write(&rows, out)?;
    match (shown < record.count, axes) {
        (true, 1) => writeln!(
            out,
            "(the first {shown} of {} drones; desired x_d, actual x, in m)",
            record.count
        )?,
        (true, _) => writeln!(
            out,
            "(the first {shown} of {} drones; desired x_d and y_d, actual x and y, in m)",
            record.count
        )?,
        (false, 1) => writeln!(out, "(desired x_d and actual x, in m)")?,
        (false, _) => writeln!(out, "(desired x_d and y_d, actual x and y, in m)")?,
    }
    Ok(())
}

fn events(record: &Record, out: &mut dyn Write) -> Result<()> {
    let Some(events) = &record.events else {
        return Ok(());
    };
    writeln!(out)?;
    let only = Evidence::ThisRunOnly;
    let count = |kind| events.iter().filter(|e| e.kind == kind).count();
    if count(EventKind::Collision) == 0 {
        writeln!(out, "no collision, at the grid points and between them ({only})")?;
    }
    if count(EventKind::OrderLost) == 0 && record.y.is_none() {
        writeln!(out, "the drones stay in order ({only})")?;
    }
    for event in events.iter().take(LISTED) {
        writeln!(out, "{}", sentence(event))?;
    }
    if events.len() > LISTED {
        writeln!(out, "and {} more", events.len() - LISTED)?;
    }
    Ok(())
}

/// Writes the smallest gap of neighbours at the grid points, or in the plane the smallest distance.
fn smallest_gap(record: &Record, known: Option<&Rational>, out: &mut dyn Write) -> Result<()> {
    let only = Evidence::ThisRunOnly;
    let Some(Least { size, drones: (i, j), row }) = least(record) else { return Ok(()) };
    let time = record.times.get(row).copied().unwrap_or_default();
    let what = if record.y.is_some() { "distance" } else { "gap" };
    write!(out, "smallest {what} {size:.4} m, of drones {i} and {j} at {time:.2} s ({only})")?;
    if record.y.is_some() {
        write!(out, "; at {:.1} m their arms touch", Body::default().touching())?;
    }
    if let Some(known) = known {
        write!(out, "; never below {} m: see `cordon separation`", fraction(known))?;
    }
    writeln!(out)?;
    Ok(())
}

/// The smallest distance of two drones, and when.
#[derive(Clone, Copy)]
pub struct Least {
    /// The gap, or in the plane the distance, in m.
    pub size: f64,
    /// The two drones, in their order.
    pub drones: (usize, usize),
    /// The row of the table, from 0.
    pub row: usize,
}

/// The smallest gap of neighbours at the grid points, or in the plane the smallest distance of any two
/// drones; `None` where collisions were not searched for.
pub fn least(record: &Record) -> Option<Least> {
    record.events.as_ref()?;
    match &record.y {
        None => least_gap(record),
        Some(y) => nearest(record, &y.actual),
    }
}

fn least_gap(record: &Record) -> Option<Least> {
    let at = |row: usize| {
        let gaps = record.actual_at(row).windows(2).map(|x| x[1] - x[0]).enumerate();
        gaps.map(move |(i, size)| Least { size, drones: (i, i + 1), row })
    };
    (0..record.rows()).flat_map(at).min_by(|a, b| a.size.total_cmp(&b.size))
}

fn nearest(record: &Record, across: &[f64]) -> Option<Least> {
    let mut least: Option<Least> = None;
    for row in 0..record.rows() {
        let (x, y) = (record.actual_at(row), record.at(across, row));
        let mut drones: Vec<_> = x.iter().zip(y).enumerate().collect();
        drones.sort_by(|(_, a), (_, b)| a.0.total_cmp(b.0));
        for (place, (i, (x_i, y_i))) in drones.iter().enumerate() {
            for (j, (x_j, y_j)) in drones.iter().skip(place + 1) {
                let gap = **x_j - **x_i;
                if least.is_some_and(|l| gap >= l.size) {
                    // Those further along x are further away.
                    break;
                }
                let size = gap.hypot(**y_j - **y_i);
                if least.is_none_or(|l| size < l.size) {
                    least = Some(Least { size, drones: (*i.min(j), *i.max(j)), row });
                }
            }
        }
    }
    least
}

/// An event in words.
pub fn sentence(event: &Event) -> String {
    let (i, j) = event.drones;
    let what = match event.kind {
        EventKind::Collision => "collide",
        EventKind::OrderLost => "lose their order",
        EventKind::OrderRestored => "are in order again",
    };
    format!("at {:.4} s drones {i} and {j} {what}", event.time)
}
