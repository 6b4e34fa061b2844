//! The matrix for people and for programs.

mod json;
mod text;

pub use json::json;
pub use text::text;

use super::Verdict;

/// A verdict with its reason, in one line.
fn described(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Holds => "holds".to_owned(),
        Verdict::Refuted(why) => format!("refuted: {why}"),
        Verdict::Rejected(why) => format!("rejected: {why}"),
        Verdict::Inconclusive(why) => format!("inconclusive: {why}"),
    }
}
