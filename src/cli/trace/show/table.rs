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
use cordon_run::trace::{Checked, Trace};

/// Writes what was run, the rows, and below them what was checked.
///
/// # Errors
/// `out` cannot be written.
pub fn table(
    trace: &Trace<'_>,
    checks: &[Checked],
    numbers: Numbers,
    digits: usize,
    out: &mut dyn Write,
) -> Result<()> {
    heading(trace.scenario, out)?;
    let timed = trace.scenario.tau.is_some();
    let ticked = trace.scenario.period > 1 || timed;
    let mut head = vec!["step".to_owned()];
    if ticked {
        head.push("tick".to_owned());
    }
    if timed {
        head.push("t [s]".to_owned());
    }
    head.extend(table::names(trace.scenario.count()));
    head.extend(checks.iter().map(|c| c.theorem.number().to_owned()));
    let mut rows = vec![head];
    for row in &trace.rows {
        let mut cells = vec![row.step.to_string()];
        if ticked {
            cells.push(row.tick.to_string());
        }
        if let Some(t) = trace.time(row) {
            cells.push(exact::decimal_string(&t, 2));
        }
        cells.extend(row.positions.iter().map(|x| numbers.write(x, digits)));
        cells.extend(checks.iter().map(|c| mark(c.verdicts.get(&row.step)).to_owned()));
        rows.push(cells);
    }
    table::write(&rows, out)?;
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
