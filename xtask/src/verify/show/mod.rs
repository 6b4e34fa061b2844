//! The output formats of the matrix.

mod json;
mod text;

pub use json::json;
pub use text::text;

use super::TierVerdict;

/// A verdict with its reason, in one line.
fn described(verdict: &TierVerdict) -> String {
    match verdict {
        TierVerdict::Holds => "holds".to_owned(),
        TierVerdict::Refuted(why) => format!("refuted: {why}"),
        TierVerdict::Rejected(why) => format!("rejected: {why}"),
        TierVerdict::Inconclusive(why) => format!("inconclusive: {why}"),
    }
}
