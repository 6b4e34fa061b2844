//! The report of a sweep, for people and for programs.

use std::io::Write;

use serde_json::json;

use crate::cli::select::OutputFormat;
use cordon_core::exact::fraction;
use cordon_core::theorems::words;
use cordon_core::{Evidence, Outcome, Rational, Result, table};
use cordon_proof::sweep::shard::Shard;
use cordon_proof::sweep::store::Header;
use cordon_proof::sweep::summary::{Summary, outcome, summaries};
use cordon_proof::sweep::{Config, Finding, Judgement, StartSpace, WeightSet};
use cordon_spec::theorems::Form;

/// Prints the results of a sweep.
pub(super) fn report(
    header: &Header,
    findings: &[Finding],
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let part = header.shard != Shard::WHOLE;
    let summaries = summaries(&header.config, findings, part)?;
    match format {
        OutputFormat::Text => text(header, findings, &summaries, out)?,
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-sweep-report/1",
                "config": header.config,
                "shard": header.shard,
                "claims": summaries.iter().map(Summary::json).collect::<Vec<_>>(),
                "findings": findings,
            });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(outcome(&summaries))
}

fn text(
    header: &Header,
    findings: &[Finding],
    summaries: &[Summary],
    out: &mut dyn Write,
) -> Result<()> {
    writeln!(out, "{}", described(&header.config))?;
    if header.shard != Shard::WHOLE {
        let Shard { index, of } = header.shard;
        writeln!(out, "part {index} of {of}: {} of {} work items", findings.len(), header.items)?;
    }
    writeln!(out)?;
    let complete = header.config.starts == StartSpace::Complete;
    let starts = if complete { "generators" } else { "starts" };
    let header = [
        "theorem",
        "form",
        "verdict",
        "items",
        "vacuous",
        starts,
        "cases",
        "non-vacuous",
        "violations",
        "evidence",
    ];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    rows.extend(summaries.iter().map(|c| {
        vec![
            c.theorem.number().to_owned(),
            c.form.label().to_owned(),
            c.verdict.text().to_owned(),
            c.items.to_string(),
            c.vacuous.to_string(),
            c.counts.starts.to_string(),
            c.counts.cases.to_string(),
            c.counts.non_vacuous.to_string(),
            c.counts.violations.to_string(),
            c.evidence.map_or("none", Evidence::text).to_owned(),
        ]
    }));
    for line in table::lines(&rows, |i| !(3..9).contains(&i)) {
        writeln!(out, "{line}")?;
    }
    for c in summaries {
        about(c, out)?;
    }
    expected(findings, out)?;
    Ok(())
}

/// Where only printed forms are refuted: a note that this is expected, and what holds instead.
fn expected(findings: &[Finding], out: &mut dyn Write) -> Result<()> {
    let refuted = || findings.iter().filter(|f| f.verdict == Judgement::Refuted);
    if refuted().next().is_none()
        || refuted().any(|f| f.form != Form::Paper || words(f.theorem).erratum.is_none())
    {
        return Ok(());
    }
    let mut theorems: Vec<_> = refuted().map(|f| f.theorem.number()).collect();
    theorems.dedup();
    writeln!(
        out,
        "\nexpected: as printed, {} fail{} beyond the range in which {} true (`cordon errata`); \
         `cordon sweep {}` sweeps the sharp forms, which hold",
        theorems.join(", "),
        if theorems.len() == 1 { "s" } else { "" },
        if theorems.len() == 1 { "it is" } else { "they are" },
        theorems.join(",")
    )?;
    Ok(())
}

/// Details beyond the table: the counterexample, or why nothing was decided.
fn about(claim: &Summary, out: &mut dyn Write) -> Result<()> {
    let name = format!("{} ({} form)", claim.theorem.number(), claim.form.label());
    if let Some(c) = &claim.counterexample {
        writeln!(out)?;
        writeln!(
            out,
            "{name} is refuted in {} of {} work items; the simplest counterexample:",
            claim.refuted, claim.items
        )?;
        writeln!(
            out,
            "  N = {}, eps = {}, start ({}): {}",
            c.start().len(),
            fraction(&c.eps),
            joined(c.start()),
            c.what_fails()
        )?;
        writeln!(out, "  {}", c.replay_line())?;
    }
    if claim.undecided > 0 {
        writeln!(out)?;
        let reason = claim.reason.as_deref().unwrap_or_default();
        writeln!(
            out,
            "{name} is undecided in {} of {} work items: {reason}",
            claim.undecided, claim.items
        )?;
    }
    if claim.items == 0 {
        writeln!(out)?;
        writeln!(out, "{name}: no weight of the sweep is in its range")?;
    } else if claim.vacuous == claim.items {
        writeln!(out)?;
        writeln!(out, "{name} is vacuous: no case met its premise, nothing was learnt")?;
    }
    Ok(())
}

/// The configuration in a line or two.
fn described(config: &Config) -> String {
    let [fewest, most] = config.drones;
    let weights = match &config.weights {
        WeightSet::List(list) => format!("eps = {}", joined(list)),
        WeightSet::Range { from, to, max_denominator } => {
            format!("eps = p/q in [{from}, {to}] with q <= {max_denominator}")
        }
    };
    let range = if config.only_weights_of_the_theorem {
        "each theorem in its own range of eps"
    } else {
        "whatever the theorem's range of eps"
    };
    let starts = match config.starts {
        StartSpace::Grid { resolution } => format!("every start on a grid of {resolution} units"),
        StartSpace::Sample { resolution, samples, seed } => {
            format!("{samples} random starts on a grid of {resolution} units, seed {seed}")
        }
        StartSpace::Complete => "all real starts".to_owned(),
    };
    let drones = if fewest == most { format!("{fewest}") } else { format!("{fewest}..{most}") };
    format!("N = {drones}, {weights}, k = 0..{}\n{starts}; {range}", config.steps)
}

fn joined(x: &[Rational]) -> String {
    x.iter().map(fraction).collect::<Vec<_>>().join(", ")
}
