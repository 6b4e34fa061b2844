//! Ranges and lists of numbers as users write them: one grammar for every flag and file.
//!
//! | written | meaning |
//! |---|---|
//! | `X` | that number alone: an integer, a fraction or a decimal ([`exact::parse`]) |
//! | `LO..HI` | from LO to HI, both included |
//! | `LO..`, `..HI` | to the greatest, or from the least, value that the field allows |
//! | `[LO,HI]`, `(LO,HI]`, ... | a bracket includes its end, a parenthesis does not |
//! | `A,B,C` | the numbers listed |

use std::ops::RangeInclusive;

use num_traits::{One, Zero};

use crate::exact::{self, shortened};
use crate::{Error, Rational, Result};

/// A range of numbers that is not empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The lower end, at most the upper one.
    pub low: Rational,
    /// Whether the lower end belongs to it.
    pub low_closed: bool,
    /// The upper end, at least the lower one.
    pub high: Rational,
    /// Whether the upper end belongs to it.
    pub high_closed: bool,
}

impl Interval {
    /// Whether `x` is in the interval.
    pub fn contains(&self, x: &Rational) -> bool {
        let above = *x > self.low || (self.low_closed && *x == self.low);
        let below = *x < self.high || (self.high_closed && *x == self.high);
        above && below
    }
}

/// A range of weights; a missing end defaults to that of \[0, 1\], the weights of the paper's
/// definition 6.
///
/// # Errors
/// Another form, or an empty range; `what` names the field.
pub fn interval(what: &str, text: &str) -> Result<Interval> {
    let (low_closed, inner, high_closed) = bracketed(text.trim());
    let brackets = inner.len() < text.trim().len();
    let ends = if brackets { inner.split_once(',') } else { inner.split_once("..") };
    let (low, high) = match ends {
        Some((low, high)) => (low, high),
        None if brackets => {
            return Err(refused(what, text, "a range like `0..1/2`, `[0,1/2]` or `(1/2,1]`"));
        }
        None => (inner, inner),
    };
    let end = |text: &str, left_out: Rational| {
        let may_be_left_out = ends.is_some() && !brackets && text.trim().is_empty();
        if may_be_left_out { Ok(left_out) } else { exact::parse(what, text) }
    };
    let (low, high) = (end(low, Rational::zero())?, end(high, Rational::one())?);
    if low < high || (low == high && low_closed && high_closed) {
        Ok(Interval { low, low_closed, high, high_closed })
    } else {
        Err(empty(what, text))
    }
}

/// As [`interval`], where both ends must be included.
///
/// # Errors
/// As [`interval`]; or an end that is excluded.
pub fn closed(what: &str, text: &str) -> Result<(Rational, Rational)> {
    match interval(what, text)? {
        Interval { low, low_closed: true, high, high_closed: true } => Ok((low, high)),
        _ => Err(refused(what, text, "a range with both ends, like `0..1/2`")),
    }
}

/// A number or a range of integers, within the bounds of the field.
///
/// # Errors
/// Another form, a number out of bounds, or an empty range; `what` names the field.
pub fn whole(
    what: &str,
    text: &str,
    within: RangeInclusive<usize>,
) -> Result<RangeInclusive<usize>> {
    let (least, most) = within.into_inner();
    let number = |part: &str, left_out: Option<usize>| match (part.trim(), left_out) {
        ("", Some(bound)) => Ok(bound),
        (part, _) => part.parse().ok().filter(|n| (least..=most).contains(n)).ok_or_else(|| {
            refused(what, text, &format!("a number from {least} to {most}, or a range like 3..7"))
        }),
    };
    let (low, high) = match text.split_once("..") {
        Some((low, high)) => (number(low, Some(least))?, number(high, Some(most))?),
        None => (number(text, None)?, number(text, None)?),
    };
    if low > high { Err(empty(what, text)) } else { Ok(low..=high) }
}

/// The numbers of a list like `0,10,20.5,1/3`; `what` gives the name of the field of each.
///
/// # Errors
/// An entry that is not a number.
pub fn list(what: impl Fn(usize) -> String, text: &str) -> Result<Vec<Rational>> {
    text.split(',').enumerate().map(|(i, entry)| exact::parse(&what(i), entry)).collect()
}

/// Whether each end is included, and the text between the brackets (without brackets, all of it).
fn bracketed(text: &str) -> (bool, &str, bool) {
    let inner = text.strip_prefix(['[', '(']).and_then(|t| t.strip_suffix([']', ')']));
    match inner {
        Some(inner) => (text.starts_with('['), inner, text.ends_with(']')),
        None => (true, text, true),
    }
}

fn refused(what: &str, text: &str, expected: &str) -> Error {
    Error::input(format!("{what}: `{}`: expected {expected}", shortened(text)))
}

fn empty(what: &str, text: &str) -> Error {
    refused(what, text, "a range that is not empty")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn q(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    #[test]
    fn one_grammar_for_ranges() {
        let cases = [
            ("1/2", q(1, 2), q(1, 2)),
            ("0..1/2", q(0, 1), q(1, 2)),
            (" -0.5 .. 1e0 ", q(-1, 2), q(1, 1)),
            ("1/2..", q(1, 2), q(1, 1)),
            ("..1/3", q(0, 1), q(1, 3)),
            ("..", q(0, 1), q(1, 1)),
            ("[0,1/2]", q(0, 1), q(1, 2)),
        ];
        for (text, low, high) in cases {
            assert_eq!(closed("eps", text).unwrap(), (low, high), "{text}");
        }
        let open = interval("eps", "(1/2, 1]").unwrap();
        assert_eq!((open.low_closed, open.high_closed), (false, true));
        assert!(!open.contains(&q(1, 2)) && open.contains(&q(3, 4)) && open.contains(&q(1, 1)));
        assert_eq!(whole("drones", "5", 3..=50).unwrap(), 5..=5);
        assert_eq!(whole("drones", "3..7", 3..=50).unwrap(), 3..=7);
        assert_eq!(whole("drones", "48..", 3..=50).unwrap(), 48..=50);
        assert_eq!(list(|_| "eps".into(), "1/3,0.5").unwrap(), [q(1, 3), q(1, 2)]);
    }

    #[test]
    fn refusals_say_what_was_expected() {
        let said = |text: &str| closed("eps", text).unwrap_err().to_string();
        assert_eq!(said("1..0"), "eps: `1..0`: expected a range that is not empty");
        assert_eq!(said("2.."), "eps: `2..`: expected a range that is not empty");
        assert_eq!(said("(0,1]"), "eps: `(0,1]`: expected a range with both ends, like `0..1/2`");
        assert!(said("[0..1]").contains("expected a range like `0..1/2`, `[0,1/2]`"));
        assert!(said("(1,1)").ends_with("expected a range that is not empty"));
        assert!(said("0..1/0").starts_with("eps: `1/0` divides by zero"));
        assert!(said("").starts_with("eps: `` is not a number"));
        assert!(said("0,1").starts_with("eps: `0,1` is not a number"));
        assert!(said("[,1]").starts_with("eps: `` is not a number"));
        let said = |text: &str| whole("drones", text, 3..=9).unwrap_err().to_string();
        assert_eq!(said("2"), "drones: `2`: expected a number from 3 to 9, or a range like 3..7");
        assert_eq!(said("5..3"), "drones: `5..3`: expected a range that is not empty");
        let eleven = "9".repeat(60);
        assert!(said(&eleven).starts_with("drones: `9999999999999999999999999999999999999999...`"));
    }
}
