//! Parsing Kani's report of one harness.

use cordon_kani::Expected;

use cordon_core::Outcome;

/// How a harness ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Every check holds, or the expected counterexample was found; every cover is met.
    Proved,
    /// A check fails that has to hold, or none fails where one has to.
    Refuted,
    /// A cover is not satisfied: the proof may be vacuous.
    Vacuous,
    /// The time limit was reached.
    TimedOut,
    /// The memory limit was reached.
    OutOfMemory,
    /// The model checker ended without a verdict.
    Broken,
    /// There is no report of it.
    Missing,
}

impl Ending {
    const ALL: [Self; 7] = [
        Self::Proved,
        Self::Refuted,
        Self::Vacuous,
        Self::TimedOut,
        Self::OutOfMemory,
        Self::Broken,
        Self::Missing,
    ];

    /// The verdict with this label.
    pub fn labelled(label: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|v| v.label() == label)
    }

    /// The verdict in a word or two.
    pub fn label(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Refuted => "refuted",
            Self::Vacuous => "cover not met",
            Self::TimedOut => "timed out",
            Self::OutOfMemory => "out of memory",
            Self::Broken => "no verdict",
            Self::Missing => "missing",
        }
    }

    /// Its contribution to the outcome of a run.
    pub fn outcome(self) -> Outcome {
        match self {
            Self::Proved => Outcome::Holds,
            Self::Refuted => Outcome::Refuted,
            Self::TimedOut | Self::OutOfMemory | Self::Broken => Outcome::Inconclusive,
            Self::Vacuous | Self::Missing => Outcome::Rejected,
        }
    }
}

/// The result of a harness.
#[derive(Clone, Debug, PartialEq)]
pub struct HarnessResult {
    /// What Kani found.
    pub verdict: Ending,
    /// What is wrong, in words; empty if nothing is.
    pub detail: String,
    /// Number of checks, not counting covers.
    pub checks: usize,
    /// Covers satisfied, and covers in all.
    pub covers: (usize, usize),
    /// Time that the model checker took in seconds, if reported.
    pub seconds: Option<f64>,
}

impl HarnessResult {
    /// The result of a harness without a report.
    pub fn missing() -> Self {
        Self {
            verdict: Ending::Missing,
            detail: "no report of it".to_owned(),
            checks: 0,
            covers: (0, 0),
            seconds: None,
        }
    }
}

/// One check of a report.
struct Check {
    name: String,
    status: String,
    description: String,
}

impl Check {
    fn is_cover(&self) -> bool {
        matches!(self.status.as_str(), "SATISFIED" | "UNSATISFIABLE")
            || self.name.rsplit('.').nth(1) == Some("cover")
    }
}

/// Reads the file that Kani wrote about a harness (its `regular` format).
///
/// The verdict is that of the checks, each with its status; Kani's own closing line has to agree.
pub fn read(text: &str, expected: Expected) -> HarnessResult {
    let checks = checks(text);
    let (covers, asserted): (Vec<_>, Vec<_>) = checks.iter().partition(|c| c.is_cover());
    let met = covers.iter().filter(|c| c.status == "SATISFIED").count();
    let failed: Vec<_> = asserted.iter().filter(|c| c.status == "FAILURE").collect();
    // If a loop bound fails, other checks remain undetermined; then nothing is proved.
    let open = asserted
        .iter()
        .any(|c| !matches!(c.status.as_str(), "SUCCESS" | "FAILURE" | "UNREACHABLE"));
    let said = text.lines().find_map(|l| l.trim().strip_prefix("VERIFICATION:- "));
    let succeeded = said.is_some_and(|s| s.starts_with("SUCCESSFUL"));

    let (verdict, detail) = if text.contains("CBMC timed out") {
        (Ending::TimedOut, "the time limit was reached".to_owned())
    } else if text.contains("out of memory") || text.contains("bad_alloc") {
        (Ending::OutOfMemory, "the memory limit was reached".to_owned())
    } else if asserted.is_empty() || said.is_none() {
        let last = text.lines().rfind(|l| !l.trim().is_empty()).unwrap_or("an empty report");
        (Ending::Broken, last.trim().to_owned())
    } else {
        match expected {
            Expected::Holds if !failed.is_empty() => {
                let first: Vec<_> = failed.iter().map(|c| c.description.as_str()).collect();
                (Ending::Refuted, first.join("; "))
            }
            Expected::Fails if failed.is_empty() => {
                (Ending::Refuted, "no counterexample where one was expected".to_owned())
            }
            _ if !succeeded => (Ending::Refuted, format!("Kani says {}", said.unwrap_or_default())),
            Expected::Holds if open => (Ending::Broken, "a check is undetermined".to_owned()),
            _ if covers.is_empty() => (Ending::Vacuous, "it has no cover".to_owned()),
            _ if met < covers.len() => {
                (Ending::Vacuous, format!("{met} of {} covers met", covers.len()))
            }
            _ => (Ending::Proved, String::new()),
        }
    };
    HarnessResult {
        verdict,
        detail,
        checks: asserted.len(),
        covers: (met, covers.len()),
        seconds: seconds(text),
    }
}

/// The checks of a report: `Check 1: NAME`, then its status and description, indented.
fn checks(text: &str) -> Vec<Check> {
    let mut found: Vec<Check> = Vec::new();
    for line in text.lines().map(str::trim) {
        if let Some((_, name)) = line.strip_prefix("Check ").and_then(|l| l.split_once(": ")) {
            let (status, description) = (String::new(), String::new());
            found.push(Check { name: name.to_owned(), status, description });
        } else if let Some(check) = found.last_mut() {
            if let Some(status) = line.strip_prefix("- Status: ") {
                check.status = status.to_owned();
            } else if let Some(said) = line.strip_prefix("- Description: ") {
                check.description = said.trim_matches('"').to_owned();
            }
        }
    }
    found
}

fn seconds(text: &str) -> Option<f64> {
    let said = text.lines().find_map(|l| l.trim().strip_prefix("Verification Time: "))?;
    said.strip_suffix('s')?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROVED: &str = "\
RESULTS:
Check 1: harnesses::ordering::step_3.assertion.1
\t - Status: SUCCESS
\t - Description: \"attempt to add with overflow\"
\t - Location: src/lib.rs:5:68 in function v::a

Check 2: harnesses::ordering::step_3.cover.1
\t - Status: SATISFIED
\t - Description: \"the witness is reached\"
\t - Location: src/lib.rs:5:89 in function v::a


SUMMARY:
 ** 0 of 1 failed

 ** 1 of 1 cover properties satisfied


VERIFICATION:- SUCCESSFUL
Verification Time: 2.5s
";

    fn verdict(text: &str, expected: Expected) -> Ending {
        read(text, expected).verdict
    }

    #[test]
    fn a_report_is_read() {
        let finding = read(PROVED, Expected::Holds);
        assert_eq!(finding.verdict, Ending::Proved);
        assert_eq!((finding.checks, finding.covers), (1, (1, 1)));
        assert_eq!(finding.seconds, Some(2.5));
        assert_eq!(finding.detail, "");
    }

    #[test]
    fn whatever_is_amiss_is_no_proof() {
        let failing = PROVED.replace("Status: SUCCESS", "Status: FAILURE");
        let failing = failing.replace("VERIFICATION:- SUCCESSFUL", "VERIFICATION:- FAILED");
        assert_eq!(verdict(&failing, Expected::Holds), Ending::Refuted);
        assert!(read(&failing, Expected::Holds).detail.contains("add with overflow"));
        // A failure that Kani itself would accept.
        let lenient = PROVED.replace("Status: SUCCESS", "Status: FAILURE");
        assert_eq!(verdict(&lenient, Expected::Holds), Ending::Refuted);
        // Only the closing line differs.
        let closing = PROVED.replace("VERIFICATION:- SUCCESSFUL", "VERIFICATION:- FAILED");
        assert_eq!(verdict(&closing, Expected::Holds), Ending::Refuted);
        let cut = PROVED.split("SUMMARY").next().unwrap_or_default();
        assert_eq!(verdict(cut, Expected::Holds), Ending::Broken);
        let unmet = PROVED.replace("SATISFIED", "UNSATISFIABLE");
        assert_eq!(verdict(&unmet, Expected::Holds), Ending::Vacuous);
        let unreachable = PROVED.replace("SATISFIED", "UNREACHABLE");
        assert_eq!(verdict(&unreachable, Expected::Holds), Ending::Vacuous);
        let undetermined = PROVED.replace("Status: SUCCESS", "Status: UNDETERMINED");
        assert_eq!(verdict(&undetermined, Expected::Holds), Ending::Broken);
        let none = PROVED.replace("step_3.cover.1", "step_3.assertion.2");
        let none = none.replace("SATISFIED", "SUCCESS");
        assert_eq!(verdict(&none, Expected::Holds), Ending::Vacuous);
        let slow = "CBMC failed\nVERIFICATION:- FAILED\nCBMC timed out. You may want to rerun\n";
        assert_eq!(verdict(slow, Expected::Holds), Ending::TimedOut);
        assert_eq!(verdict(slow, Expected::Fails), Ending::TimedOut);
        let large = "CBMC failed\nVERIFICATION:- FAILED\nCBMC ran out of memory\n";
        assert_eq!(verdict(large, Expected::Holds), Ending::OutOfMemory);
        let failed = "CBMC failed with status 6\nVERIFICATION:- FAILED\n";
        assert_eq!(verdict(failed, Expected::Fails), Ending::Broken);
        assert_eq!(verdict("", Expected::Holds), Ending::Broken);
    }

    #[test]
    fn a_counterexample_has_to_be_found_where_one_is_expected() {
        assert_eq!(verdict(PROVED, Expected::Fails), Ending::Refuted);
        let found = PROVED.replace("Status: SUCCESS", "Status: FAILURE");
        assert_eq!(verdict(&found, Expected::Fails), Ending::Proved);
        let unmet = found.replace("SATISFIED", "UNSATISFIABLE");
        assert_eq!(verdict(&unmet, Expected::Fails), Ending::Vacuous);
    }

    #[test]
    fn every_verdict_has_its_outcome() {
        assert_eq!(Ending::Proved.outcome(), Outcome::Holds);
        assert_eq!(Ending::Refuted.outcome(), Outcome::Refuted);
        assert_eq!(Ending::TimedOut.outcome(), Outcome::Inconclusive);
        assert_eq!(HarnessResult::missing().verdict.outcome(), Outcome::Rejected);
    }
}
