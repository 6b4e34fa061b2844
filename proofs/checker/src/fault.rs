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

/// What a certificate shows, in words made from it, and how many proofs that took.
pub type Shown = (String, usize);

/// The text with escapes in the place of what is not shown, line breaks among them.
pub fn shown(text: &str) -> String {
    let escaped = |c: char| {
        let plain = "\"'\\".contains(c).then_some(c);
        plain.into_iter().chain(plain.is_none().then(|| c.escape_debug()).into_iter().flatten())
    };
    text.chars().flat_map(escaped).collect()
}

/// A fault of that rule.
///
/// # Errors
/// Always.
pub fn fault<T>(rule: &'static str, reason: impl Into<String>) -> Result<T> {
    Err(Fault { rule, reason: reason.into() })
}

/// Returns a fault of a rule, unless the condition holds.
macro_rules! ensure {
    ($holds:expr, $rule:expr, $($words:tt)+) => {
        if !$holds {
            return $crate::fault::fault($rule, format!($($words)+));
        }
    };
}
pub(crate) use ensure;
