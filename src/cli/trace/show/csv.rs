//! Traces as comma-separated values.

use std::io::Write;

use super::Numbers;
use cordon_core::Result;
use cordon_core::exact;
use cordon_run::scenario::Scenario;
use cordon_run::trace::Row;

/// Writes a header, then one line per row: step, tick, time in seconds where there is a clock, and for
/// every drone its position as a fraction (`x1`), a decimal (`x1_decimal`) or both; for a protocol file
/// every state variable. No field ever needs quotes.
///
/// # Errors
/// `out` cannot be written.
pub fn csv(
    scenario: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    numbers: Numbers,
    digits: usize,
    out: &mut dyn Write,
) -> Result<()> {
    let timed = scenario.tau.is_some();
    write!(out, "step,tick")?;
    if timed {
        write!(out, ",time")?;
    }
    let columns = scenario.columns();
    for x in &columns {
        if numbers != Numbers::Decimal {
            write!(out, ",{x}")?;
        }
        if numbers != Numbers::Fraction {
            write!(out, ",{x}_decimal")?;
        }
    }
    writeln!(out)?;
    for row in rows {
        write!(out, "{},{}", row.step, row.tick)?;
        if let Some(t) = scenario.time(row.tick) {
            write!(out, ",{}", exact::decimal_string(&t, digits))?;
        }
        let fractions = match numbers {
            Numbers::Decimal => Vec::new(),
            Numbers::Fraction | Numbers::Both => row.positions.lowest(),
        };
        let decimals = match numbers {
            Numbers::Fraction => Vec::new(),
            Numbers::Decimal | Numbers::Both => row.positions.decimals(digits),
        };
        for i in 0..columns.len() {
            if let Some(x) = fractions.get(i) {
                write!(out, ",{}", exact::fraction(x))?;
            }
            if let Some(x) = decimals.get(i) {
                write!(out, ",{x}")?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}
