//! Traces as aligned tables.

use std::io::Write;

use cordon_core::theorems;
use cordon_spec::Phase;
use cordon_spec::theorems::Verdict;

use super::Numbers;
use crate::cli::table;
use cordon_core::exact;
use cordon_core::{Evidence, Result};
use cordon_run::scenario::{Protocol, Scenario};
use cordon_run::trace::{Checked, Row, Selection, decimal_widths};

/// Writes what was run, the rows, and below them what was checked. Rows of a known selection are
/// written one by one where their widths are known without them.
///
/// # Errors
/// `out` cannot be written.
pub fn table(
    scenario: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    checks: &[Checked],
    numbers: Numbers,
    digits: usize,
    selection: Option<Selection>,
    out: &mut dyn Write,
) -> Result<()> {
    heading(scenario, out)?;
    let timed = scenario.tau.is_some();
    let ticked = scenario.period > 1 || timed;
    let counters = |tick: u64, step: u64| {
        let mut cells = vec![step.to_string()];
        if ticked {
            cells.push(tick.to_string());
        }
        cells.extend(scenario.time(tick).map(|t| exact::decimal_string(&t, 2)));
        cells
    };
    let mut head = vec!["step".to_owned()];
    if ticked {
        head.push("tick".to_owned());
    }
    if timed {
        head.push("t [s]".to_owned());
    }
    // Known beforehand, of decimals only.
    let widths = selection.filter(|_| numbers == Numbers::Decimal && checks.is_empty());
    let widths = widths.and_then(|rows| {
        let (tick, step) = rows.unit.tick_and_step(scenario, rows.last());
        let mut widths: Vec<usize> = counters(tick, step).iter().map(String::len).collect();
        widths.extend(decimal_widths(scenario, rows, digits)?);
        Some(widths)
    });
    head.extend(table::names(scenario.count()));
    head.extend(checks.iter().map(|c| c.theorem.number().to_owned()));
    let lines = rows.map(|row| {
        let mut cells = counters(row.tick, row.step);
        cells.extend(numbers.write(&row.positions, digits));
        cells.extend(checks.iter().map(|c| mark(c.verdicts.get(&row.step)).to_owned()));
        cells
    });
    table::stream(&head, widths.as_deref(), lines, out)?;
    if !checks.is_empty() {
        writeln!(out)?;
    }
    checks.iter().try_for_each(|c| summary(c, out))
}

fn heading(scenario: &Scenario, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}", scenario.title)?;
    let segment = match &scenario.protocol {
        Protocol::Coverage { min, max } => format!("coverage of [{min}, {max}]"),
        other => other.name().to_owned(),
    };
    write!(out, "{segment}, N = {}, eps = {}", scenario.count(), scenario.weight)?;
    if scenario.period > 1 {
        let first = match scenario.phase {
            Phase::First => 1,
            Phase::Last => scenario.period,
        };
        write!(out, ", an update every {} ticks, the first in tick {first}", scenario.period)?;
    }
    writeln!(out, "\n")?;
    Ok(())
}

fn mark(verdict: Option<&Verdict>) -> &'static str {
    match verdict {
        Some(Verdict::Holds) => "ok",
        Some(Verdict::Vacuous) => "-",
        Some(Verdict::Violated(_)) => "FAILS",
        Some(Verdict::Undecided) | None => "?",
    }
}

fn summary(c: &Checked, out: &mut dyn Write) -> Result<()> {
    let (number, form) = (c.theorem.number(), c.form.label());
    let steps = c.verdicts.len();
    match &c.first_violation {
        Some((_, what)) => {
            writeln!(out, "{number} ({form} form) fails {what}")?;
            if !c.weight_in_range {
                let range = theorems::weights(c.theorem.hypothesis(c.form).weights);
                writeln!(out, "  (no contradiction: the theorem is about {range})")?;
            }
        }
        None if c.met() == 0 => {
            writeln!(
                out,
                "{number} ({form} form): its premise is met at none of the {steps} steps checked"
            )?;
        }
        None => {
            writeln!(
                out,
                "{number} ({form} form) holds at all {steps} steps checked ({})",
                Evidence::ThisRunOnly
            )?;
        }
    }
    Ok(())
}
