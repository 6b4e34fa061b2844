//! Traces as comma-separated values.

use std::io::Write;

use super::Numbers;
use cordon_core::Result;
use cordon_core::exact;
use cordon_run::trace::Trace;

/// Writes a head line, then one line a row: step, tick, time in seconds where there is a
/// clock, and for every drone its position as a fraction (`x1`), a decimal (`x1_decimal`) or
/// both. No field ever needs quotes.
///
/// # Errors
/// `out` cannot be written.
pub fn csv(trace: &Trace<'_>, numbers: Numbers, digits: usize, out: &mut dyn Write) -> Result<()> {
    let timed = trace.scenario.tau.is_some();
    write!(out, "step,tick")?;
    if timed {
        write!(out, ",time")?;
    }
    for i in 0..trace.scenario.count() {
        if numbers != Numbers::Decimal {
            write!(out, ",x{i}")?;
        }
        if numbers != Numbers::Fraction {
            write!(out, ",x{i}_decimal")?;
        }
    }
    writeln!(out)?;
    for row in &trace.rows {
        write!(out, "{},{}", row.step, row.tick)?;
        if let Some(t) = trace.time(row) {
            write!(out, ",{}", exact::decimal_string(&t, digits))?;
        }
        for x in &row.positions {
            if numbers != Numbers::Decimal {
                write!(out, ",{}", exact::fraction(x))?;
            }
            if numbers != Numbers::Fraction {
                write!(out, ",{}", exact::decimal_string(x, digits))?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}
