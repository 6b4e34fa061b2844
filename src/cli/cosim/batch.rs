//! A batch of runs, as a table with one row per run.

use std::io::Write;
use std::path::Path;

use super::{Args, eprint_all, summary};
use crate::cli::table;
use cordon_core::exact::fraction;
use cordon_core::{Error, Evidence, Outcome, Result, files};
use cordon_cosim::batch::Batch;
use cordon_cosim::collision::EventKind;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::record::Record;
use cordon_cosim::run as engine;
use cordon_cosim::store::Format;

/// Columns that follow those of the parameters.
const COLUMNS: [&str; 5] = ["collisions", "order lost", "smallest gap", "at [s]", "off at end"];

/// Runs the batch and writes the table: to stdout, and as CSV to `--out`.
pub(super) fn run(
    args: &Args,
    swarm: &Cosimulation,
    batch: &Batch,
    out: &mut dyn Write,
) -> Result<Outcome> {
    if args.exact {
        return Err(Error::input("exact: expected one run, found several"));
    }
    if !args.variables.is_empty() {
        return Err(Error::input("variables: expected one run, found several"));
    }
    let format = args.out.as_deref().map(|path| args.format_of(path)).transpose()?;
    if format.or(args.format).is_some_and(|format| format != Format::Csv) {
        return Err(Error::input(
            "format: expected `csv`: a table is what several runs are written as",
        ));
    }
    // Checked again, now that the files named by the scenario are known.
    args.out.as_deref().map_or(Ok(()), files::expect_writable)?;
    let names = batch.names.iter().map(String::as_str);
    let head: Vec<String> =
        ["run"].into_iter().chain(names).chain(COLUMNS).map(str::to_owned).collect();
    let mut rows = vec![head];
    let mut broken = None;
    for (k, values) in (1..).zip(&batch.runs) {
        let (record, ended) = engine::run_as_far_as_it_goes(&batch.swarm(swarm, values))?;
        for note in &record.notes {
            eprint_all(format!("warning: run {k}: {note}\n").as_bytes());
        }
        let mut row = vec![k.to_string()];
        row.extend(values.iter().map(fraction));
        row.extend(outcome(&record));
        rows.push(row);
        if let Err(e) = ended {
            broken.get_or_insert(Error::input(format!("run {k}: {e}")));
        }
    }
    writeln!(out, "{}\n", swarm.scenario.title)?;
    table::write(&rows, out)?;
    writeln!(out, "(gaps and distances in m; every row: {})", Evidence::ThisRunOnly)?;
    if let Some(path) = &args.out {
        save(&rows, path)?;
    }
    broken.map_or(Ok(Outcome::Holds), Err)
}

/// The results of a run: collisions, losses of the order, the smallest gap (in the plane: distance) and
/// its time, and the largest distance of a drone from its desired position at the end.
fn outcome(record: &Record) -> [String; COLUMNS.len()] {
    let count = |kind| {
        let events = record.events.iter().flatten();
        events.filter(|e| e.kind == kind).count().to_string()
    };
    let [gap, at] = match summary::least(record) {
        Some(least) => {
            let time = record.times.get(least.row).copied().unwrap_or_default();
            [format!("{:.4}", least.size), format!("{time:.2}")]
        }
        None => ["".to_owned(), "".to_owned()],
    };
    let last = record.rows().saturating_sub(1);
    let mut off = vec![0.0_f64; record.count];
    for (_, track) in record.tracks() {
        let pairs = record.at(&track.desired, last).iter().zip(record.at(&track.actual, last));
        off.iter_mut().zip(pairs).for_each(|(off, (x_d, x))| *off = off.hypot(x_d - x));
    }
    let off = off.into_iter().fold(0.0, f64::max);
    let off = match &record.broken_off {
        Some(_) => "broke off".to_owned(),
        None => format!("{off:.4}"),
    };
    [count(EventKind::Collision), count(EventKind::OrderLost), gap, at, off]
}

fn save(rows: &[Vec<String>], path: &Path) -> Result<()> {
    let lines: Vec<String> = rows.iter().map(|row| row.join(",") + "\n").collect();
    files::write_atomically(path, lines.concat().as_bytes())
}
