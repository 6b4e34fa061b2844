//! Claims about a protocol file in continuous time.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::page::Page;
use super::show::headline_in;
use crate::cli::select::OutputFormat;
use crate::cli::table::counted;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Flow, Switching};
use cordon_core::{Evidence, Outcome, Result, progress};
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
    progress::tries("ellipsoids that no run leaves");
    let found = flow::prove(flow)?;
    let claim = |index: usize| {
        flow.system.claims.get(index).map_or("", |claim| claim.predicate.text.as_str())
    };
    let mut page = Page::new(args, &flow.system, folder, format, out);
    let headline = headline_in(&flow.system, "at each time");
    page.line(format_args!("{headline}{}", switching(flow)))?;
    if protocol.is_family() && args.agents.is_none() {
        page.line(
            "  the fewest agents of the file: in continuous time --agents says which number is meant",
        )?;
    }
    let claims = match &found {
        Answer::Proved(found) => {
            page.line("  proved: the claims hold at every time from every assumed start")?;
            page.line(format_args!(
                "  {}: {} that no run leaves; every claim with {} to spare",
                Evidence::Certified,
                counted(found.ellipsoids, "ellipsoid"),
                decimal_string(&found.spare, 3)
            ))?;
            let file = page.certificate("", &found.certificate)?;
            json!({
                "proved": true,
                "evidence": Evidence::Certified,
                "ellipsoids": found.ellipsoids,
                "spare": fraction(&found.spare),
                "file": file,
            })
        }
        Answer::Missed(index, by) => {
            let claim = claim(*index);
            page.line(format_args!(
                "  not proved: the best ellipsoids found miss `{claim}` by {by:.3}; that does not refute it"
            ))?;
            json!({ "proved": Value::Null, "missed": claim, "by": by })
        }
        Answer::Open => {
            page.line("  not proved: no ellipsoid that no run leaves was found")?;
            json!({ "proved": Value::Null })
        }
    };
    page.field("claims", claims);
    page.end()?;
    Ok(if matches!(found, Answer::Proved(_)) { Outcome::Holds } else { Outcome::Inconclusive })
}

fn switching(flow: &Flow) -> String {
    match &flow.switching {
        Switching::Any => String::new(),
        Switching::Dwell(time) => format!(", each for {} at least", fraction(time)),
        Switching::Every(time) => format!(", each for {}", fraction(time)),
    }
}
