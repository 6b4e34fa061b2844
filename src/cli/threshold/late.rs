//! The critical weight of ordering when messages are late: one bracket, or a table of them.

use std::collections::BTreeSet;
use std::io::Write;

use serde_json::json;

use super::{Args, judged_and_written, list_files};
use crate::cli::certificates::Named;
use crate::cli::select::OutputFormat;
use crate::cli::table;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::{Error, Evidence, Outcome, Result, progress, range};
use cordon_proof::certificate;
use cordon_proof::threshold::late::{Bracket, WORK, bracket};

/// Most decimal places: each takes three or four more searches.
const MOST_DIGITS: usize = 4;

/// Most drones: for more, the search proves nothing in the same time.
const MOST_DRONES: usize = 20;

/// Largest delay of a message, in steps.
const LONGEST: usize = 20;

/// Brackets the critical weight for every combination of number of drones and delay.
pub(super) fn run(args: &Args, drones: &str, delay: &str, out: &mut dyn Write) -> Result<Outcome> {
    let digits = args.digits.unwrap_or(2);
    if !(1..=MOST_DIGITS).contains(&digits) {
        return Err(Error::input(format!(
            "digits: `{digits}`: expected a number from 1 to {MOST_DIGITS} with --delay"
        )));
    }
    let drones = range::whole("drones", drones, 3..=MOST_DRONES)?;
    let delays = range::whole("delay", delay, 1..=LONGEST)?;
    let cells: Vec<(usize, usize)> =
        drones.flat_map(|n| delays.clone().map(move |d| (n, d))).collect();
    if cells.len() > 1 && args.format == OutputFormat::Json {
        return Err(Error::input(
            "format: `json`: expected one number of drones and one delay with it",
        ));
    }
    progress::expect(cells.len() as u64);
    let mut found = Vec::new();
    for &(count, longest) in &cells {
        let Some(bracket) = bracket(count, longest, digits, WORK)? else {
            return super::not_found(args, count, out);
        };
        found.push(bracket);
        progress::advance(1);
    }
    let certificates: Vec<Named> = found.iter().flat_map(certificates).collect();
    let files = judged_and_written(args, &certificates)?;
    match (args.format, found.as_slice()) {
        (OutputFormat::Json, all) => {
            for cell in all {
                writeln!(out, "{:#}", as_json(cell, digits, &files))?;
            }
        }
        (OutputFormat::Text, [one]) => {
            text(one, digits, out)?;
            writeln!(out, "{}", super::certified(certificates.len(), 0))?;
        }
        (OutputFormat::Text, all) => {
            rows(all, digits, out)?;
            writeln!(out, "{}", super::certified(certificates.len(), 0))?;
        }
    }
    list_files(args, &files, out)?;
    Ok(match found.iter().all(|cell| cell.kept.is_some()) {
        true => Outcome::Holds,
        false => Outcome::Inconclusive,
    })
}

/// The certificates of both sides, by file name.
fn certificates(cell: &Bracket) -> Vec<Named> {
    let name = |side: &str| format!("ordering-{}-late-{}-{side}", cell.count, cell.longest);
    let below = cell.kept.iter().map(|kept| (name("below"), kept.certificate.clone()));
    below.chain([(name("above"), certificate::refutation(&cell.lost))]).collect()
}

fn text(cell: &Bracket, digits: usize, out: &mut dyn Write) -> Result<()> {
    let steps = if cell.longest == 1 { "step" } else { "steps" };
    let exact = match &cell.kept {
        Some(kept) if cell.is_exact => format!(": critical weight {} exactly", fraction(&kept.eps)),
        _ => String::new(),
    };
    writeln!(
        out,
        "ordering (7.2), N = {}, messages up to {} {steps} late{exact}",
        cell.count, cell.longest
    )?;
    match &cell.kept {
        Some(kept) => writeln!(
            out,
            "  below  at eps = {} a start that is strictly ordered stays so, at every step, whatever is late: {} \
             half-spaces, {}",
            decimal_string(&kept.eps, digits),
            kept.half_spaces,
            Evidence::Certified
        )?,
        None => writeln!(out, "  below  no weight was found at which order is kept")?,
    }
    if let Some((eps, end)) = &cell.open {
        writeln!(
            out,
            "  open   at eps = {} neither was found: {end}",
            decimal_string(eps, digits)
        )?;
    }
    writeln!(
        out,
        "  above  at eps = {}: {}",
        decimal_string(&cell.lost.eps, digits),
        cell.lost.what_fails()
    )?;
    Ok(())
}

fn rows(all: &[Bracket], digits: usize, out: &mut dyn Write) -> Result<()> {
    let head = ["N", "late", "kept at", "half-spaces", "lost at", "step", "open at"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    let weight = |eps| decimal_string(eps, digits);
    for cell in all {
        let kept = cell.kept.as_ref();
        rows.push(vec![
            cell.count.to_string(),
            cell.longest.to_string(),
            kept.map_or_else(|| "-".to_owned(), |k| weight(&k.eps)),
            kept.map_or_else(|| "-".to_owned(), |k| k.half_spaces.to_string()),
            weight(&cell.lost.eps),
            cell.lost.step.to_string(),
            cell.open.as_ref().map_or_else(|| "-".to_owned(), |(eps, _)| weight(eps)),
        ]);
    }
    writeln!(out, "ordering (7.2) with late messages: weights eps")?;
    table::write(&rows, out)?;
    let ends: BTreeSet<&String> = all.iter().filter_map(|c| Some(&c.open.as_ref()?.1)).collect();
    for end in ends {
        writeln!(out, "  open: {end}")?;
    }
    Ok(())
}

fn as_json(cell: &Bracket, digits: usize, files: &[String]) -> serde_json::Value {
    let critical = cell.kept.as_ref().filter(|_| cell.is_exact);
    let below = cell.kept.as_ref().map(|kept| {
        json!({
            "eps": fraction(&kept.eps),
            "evidence": Evidence::Certified,
            "half_spaces": kept.half_spaces,
        })
    });
    json!({
        "schema": "cordon-threshold/1",
        "property": "ordering",
        "drones": cell.count,
        "delay": cell.longest,
        "digits": digits,
        "critical": critical.map(|kept| fraction(&kept.eps)),
        "exact": cell.is_exact,
        "holds_at_critical": cell.is_exact,
        "below": below,
        "above": cell.lost.to_json(),
        "open": cell.open.as_ref().map(|(eps, end)| json!({ "eps": fraction(eps), "ended": end })),
        "files": files,
    })
}
