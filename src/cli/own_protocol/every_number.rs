//! Proofs for every number of agents.

use serde_json::{Value, json};

use super::page::Page;
use crate::cli::table::counted;
use cordon_core::exact::shortened;
use cordon_core::system::System;
use cordon_core::{Evidence, Result};
use cordon_proof::claims::certificate::within_limits;
use cordon_proof::prove::any_size::any_size;
use cordon_run::protocol::Family;

/// What is known for every number of agents.
pub(super) struct EveryNumber {
    pub proved: bool,
    /// The claims that are proved, as they stand in the file.
    pub claims: Vec<String>,
    /// Why not all.
    reason: Option<String>,
    /// Clauses of the invariant.
    clauses: Option<usize>,
    /// Accepted by the checker.
    certificate: Option<Value>,
}

impl EveryNumber {
    fn none(reason: String) -> Self {
        Self {
            proved: false,
            claims: Vec::new(),
            reason: Some(reason),
            clauses: None,
            certificate: None,
        }
    }
}

/// Proofs for every number of agents, or why there are none.
///
/// # Errors
/// The checker rejects what was found.
pub(super) fn every_number(family: std::result::Result<Family, String>) -> Result<EveryNumber> {
    let found =
        family.and_then(|f| any_size(&f).map(|found| (f, found)).map_err(|e| e.to_string()));
    let (family, found) = match found {
        Ok(found) => found,
        Err(reason) => return Ok(EveryNumber::none(reason)),
    };
    let text = |index: usize| family.claims.get(index).map_or("", |c| c.text.as_str());
    let reason = found.open.first().map(|(index, why)| match family.claims.len() {
        1 => why.clone(),
        _ => format!("`{}`: {why}", shortened(text(*index))),
    });
    let Some(certificate) = found.certificate else {
        return Ok(EveryNumber::none(reason.unwrap_or_default()));
    };
    Ok(match within_limits(certificate)? {
        Err(reason) => EveryNumber::none(reason),
        Ok(certificate) => {
            let is_open = |index: usize| found.open.iter().any(|(open, _)| *open == index);
            let proved = (0..family.claims.len()).filter(|&index| !is_open(index));
            EveryNumber {
                proved: found.open.is_empty(),
                claims: proved.map(|index| text(index).to_owned()).collect(),
                reason,
                clauses: Some(found.invariant),
                certificate: Some(certificate),
            }
        }
    })
}

/// Says it.
///
/// # Errors
/// The certificate cannot be written.
pub(super) fn say(system: &System, found: &EveryNumber, page: &mut Page<'_>) -> Result<()> {
    let title = &system.title;
    if let Some(reason) = &found.reason {
        page.line(format_args!("{title}: not proved for every number of agents: {reason}"))?;
    }
    if let Some(clauses) = found.clauses {
        let claims = if found.proved {
            page.line(format_args!("{title}: every number of agents from 3 on"))?;
            "the claims hold".to_owned()
        } else {
            let texts: Vec<String> = found.claims.iter().map(|c| format!("`{c}`")).collect();
            format!("for every number of agents from 3 on, {}", texts.join(", "))
        };
        page.line(format_args!("  proved: {claims} at every step from every assumed start"))?;
        page.line(format_args!(
            "  {}: by induction over the steps, with cases over the agents; {} in the invariant",
            Evidence::Certified,
            counted(clauses, "clause")
        ))?;
    }
    let file = match &found.certificate {
        Some(certificate) => page.certificate("-every-n", certificate)?,
        None => None,
    };
    page.field(
        "every_number",
        json!({
            "proved": found.proved,
            "claims": found.claims,
            "reason": found.reason,
            "clauses": found.clauses,
            "file": file,
        }),
    );
    page.flush()
}
