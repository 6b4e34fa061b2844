//! Traces as aligned tables.

use std::io::Write;

use cordon_core::theorems;
use cordon_spec::Phase;
use cordon_spec::theorems::Verdict;

use super::Numbers;
use crate::cli::table;
use crate::cli::trace::Checks;
use cordon_core::exact;
use cordon_core::system::ParameterKind;
use cordon_core::{Evidence, Result};
use cordon_run::scenario::{Protocol, Scenario};
use cordon_run::trace::{Checked, CheckedClaim, Row, Selection, decimal_widths, out_of_range};

/// Writes the scenario, the rows, and below them the checks. The rows of a selection are written one by
/// one if their widths are known in advance.
///
/// # Errors
/// `out` cannot be written.
pub fn table(
    scenario: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    Checks { along: checks, claims, .. }: Checks<'_>,
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
    // Known in advance for decimals only.
    let widths =
        selection.filter(|_| numbers == Numbers::Decimal && checks.is_empty() && claims.is_empty());
    let widths = widths.and_then(|rows| {
        let (tick, step) = rows.unit.tick_and_step(scenario, rows.last());
        let mut widths: Vec<usize> = counters(tick, step).iter().map(String::len).collect();
        widths.extend(decimal_widths(scenario, rows, digits)?);
        Some(widths)
    });
    head.extend(scenario.columns());
    head.extend(checks.iter().map(|c| c.theorem.number().to_owned()));
    head.extend(claims.iter().map(|c| format!("claim {}", c.number)));
    let lines = rows.map(|row| {
        let mut cells = counters(row.tick, row.step);
        cells.extend(numbers.write(&row.positions, digits));
        cells.extend(checks.iter().map(|c| mark(c.verdicts.get(&row.step)).to_owned()));
        cells.extend(claims.iter().map(|c| claim_mark(c.holds.get(&row.step)).to_owned()));
        cells
    });
    table::stream(&head, widths.as_deref(), lines, out)?;
    if !checks.is_empty() || !claims.is_empty() {
        writeln!(out)?;
    }
    checks.iter().try_for_each(|c| summary(c, out))?;
    claims.iter().try_for_each(|c| claim_summary(scenario, c, out))
}

/// What is run, as the table is headed.
///
/// # Errors
/// `out` cannot be written.
pub fn heading(scenario: &Scenario, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}", scenario.title)?;
    let segment = match &scenario.protocol {
        Protocol::Coverage { min, max } => format!("coverage of [{min}, {max}]"),
        other => other.name().to_owned(),
    };
    write!(out, "{segment}, N = {}", scenario.count())?;
    match scenario.own() {
        None => write!(out, ", eps = {}", scenario.weight)?,
        Some(own) => {
            for (p, value) in own.values().filter(|(p, _)| p.kind != ParameterKind::Choice) {
                write!(out, ", {} = {}", p.name, exact::fraction(value))?;
            }
            if let Some(choices) = own.choices() {
                write!(out, ", {choices}")?;
            }
        }
    }
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

fn claim_mark(holds: Option<&bool>) -> &'static str {
    match holds {
        Some(true) => "ok",
        Some(false) => "FAILS",
        None => "-",
    }
}

fn claim_summary(scenario: &Scenario, c: &CheckedClaim, out: &mut dyn Write) -> Result<()> {
    let (number, text, steps) = (c.number, &c.text, c.holds.len());
    match &c.first_violation {
        Some((_, what)) => {
            writeln!(out, "claim {number}, `{text}`, fails {what}")?;
            for p in scenario.own().into_iter().flat_map(out_of_range) {
                writeln!(
                    out,
                    "  (no contradiction: the file is about {} from {} to {})",
                    p.name,
                    exact::fraction(&p.low),
                    exact::fraction(&p.high)
                )?;
            }
        }
        None if steps == 0 => {
            writeln!(out, "claim {number}, `{text}`, is about none of these steps")?;
        }
        None => {
            let only = Evidence::ThisRunOnly;
            writeln!(out, "claim {number}, `{text}`, holds at all {steps} steps checked ({only})")?;
        }
    }
    Ok(())
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
