//! Claims about a protocol file in continuous time.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::prove::written;
use super::show::{head, headline_in};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Flow, Switching};
use cordon_core::{Evidence, Outcome, Result};
use cordon_proof::flow::{self, Answer};
use cordon_run::protocol::ProtocolFile;

/// Proves the claims, or says that it cannot.
///
/// # Errors
/// The system is beyond the search, or a certificate cannot be written.
pub fn prove(
    args: &ProtocolArgs,
    protocol: &ProtocolFile,
    flow: &Flow,
    folder: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let found = flow::prove(flow)?;
    let file = match &found {
        Answer::Proved(found) => written(args, folder, "", &found.certificate)?,
        _ => None,
    };
    let claim = |index: usize| {
        flow.system.claims.get(index).map_or("", |claim| claim.predicate.text.as_str())
    };
    match format {
        OutputFormat::Text => {
            writeln!(out, "{}{}", headline_in(&flow.system, "at each time"), switching(flow))?;
            if protocol.is_family() && args.agents.is_none() {
                writeln!(
                    out,
                    "  the fewest agents of the file: in continuous time --agents says which number is meant"
                )?;
            }
            match &found {
                Answer::Proved(found) => {
                    let many = if found.ellipsoids == 1 { "" } else { "s" };
                    writeln!(
                        out,
                        "  proved: the claims hold at every time from every assumed start"
                    )?;
                    writeln!(
                        out,
                        "  {}: {} ellipsoid{many} that no run leaves; every claim with {} to spare",
                        Evidence::Certified,
                        found.ellipsoids,
                        decimal_string(&found.spare, 3)
                    )?;
                }
                Answer::Missed(index, by) => writeln!(
                    out,
                    "  not proved: the best ellipsoids found miss `{}` by {by:.3}; that does not refute it",
                    claim(*index)
                )?,
                Answer::Open => {
                    writeln!(out, "  not proved: no ellipsoid that no run leaves was found")?
                }
            }
            if let Some(file) = &file {
                writeln!(out, "  wrote {file}")?;
            }
        }
        OutputFormat::Json => {
            let mut page = head(&flow.system);
            page.insert(
                "claims",
                match &found {
                    Answer::Proved(found) => json!({
                        "proved": true,
                        "evidence": Evidence::Certified,
                        "ellipsoids": found.ellipsoids,
                        "spare": fraction(&found.spare),
                        "file": file,
                    }),
                    Answer::Missed(index, by) => {
                        json!({ "proved": Value::Null, "missed": claim(*index), "by": by })
                    }
                    Answer::Open => json!({ "proved": Value::Null }),
                },
            );
            writeln!(out, "{:#}", json!(page))?;
        }
    }
    Ok(if matches!(found, Answer::Proved(_)) { Outcome::Holds } else { Outcome::Inconclusive })
}

fn switching(flow: &Flow) -> String {
    match &flow.switching {
        Switching::Any => String::new(),
        Switching::Dwell(time) => format!(", each for {} at least", fraction(time)),
        Switching::Every(time) => format!(", each for {}", fraction(time)),
    }
}
