//! Why something is not accepted.

/// A rule that was broken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The rule.
    pub rule: &'static str,
    /// Why.
    pub reason: String,
}

/// What is accepted, or why not.
pub type Result<T> = std::result::Result<T, Fault>;

/// A fault of that rule.
///
/// # Errors
/// Always.
pub fn fault<T>(rule: &'static str, reason: impl Into<String>) -> Result<T> {
    Err(Fault { rule, reason: reason.into() })
}

/// A fault of a rule, unless the condition holds.
///
/// # Errors
/// It does not hold.
pub fn need<W: Into<String>>(
    holds: bool,
    rule: &'static str,
    words: impl FnOnce() -> W,
) -> Result<()> {
    if holds { Ok(()) } else { fault(rule, words()) }
}
