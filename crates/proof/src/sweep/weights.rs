//! The weights eps that a sweep covers.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use serde::{Deserialize, Serialize};

use cordon_core::{Error, Rational, Result, exact};

/// Which weights a sweep covers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weights {
    /// Every p/q in lowest terms with `from <= p/q <= to` and q at most `max_denominator`.
    Range {
        /// Least weight, an exact number as text.
        from: String,
        /// Largest weight, likewise.
        to: String,
        /// Largest denominator, at least 1.
        max_denominator: u32,
    },
    /// These, exact numbers as text.
    List(Vec<String>),
}

/// Most weights in one sweep; more are a mistake, and would fill the memory with work items.
const MAX_WEIGHTS: u64 = 1_000_000;

impl Weights {
    /// The weights from 0 to 1, definition 6 of the paper.
    pub fn unit(max_denominator: u32) -> Self {
        Self::Range { from: "0".into(), to: "1".into(), max_denominator }
    }

    /// The weights in increasing order, none twice.
    ///
    /// # Errors
    /// A number that cannot be read, an empty or reversed range, more than a million weights.
    pub fn listed(&self) -> Result<Vec<Rational>> {
        let mut weights = match self {
            Self::List(list) => {
                list.iter().map(|text| exact::parse("eps", text)).collect::<Result<Vec<_>>>()?
            }
            Self::Range { from, to, max_denominator } => in_range(
                exact::parse("eps-range", from)?,
                exact::parse("eps-range", to)?,
                *max_denominator,
            )?,
        };
        weights.sort();
        weights.dedup();
        if weights.is_empty() {
            return Err(Error::input("eps: no weight is in the range: expected at least one"));
        }
        Ok(weights)
    }
}

fn in_range(from: Rational, to: Rational, max_denominator: u32) -> Result<Vec<Rational>> {
    if from > to {
        return Err(Error::input(format!("eps-range: `{from}..{to}`: expected LO <= HI")));
    }
    if max_denominator == 0 {
        return Err(Error::input("max-denominator: `0`: expected at least 1"));
    }
    let too_many = || {
        Error::input(format!(
            "max-denominator: `{max_denominator}`: expected at most {MAX_WEIGHTS} weights in the range"
        ))
    };
    let width = &to - &from;
    let mut weights: Vec<Rational> = Vec::new();
    let mut candidates = BigInt::zero();
    for q in 1..=max_denominator {
        let den = Rational::from(BigInt::from(q));
        let (first, last) = ((&from * &den).ceil().to_integer(), (&to * &den).floor().to_integer());
        candidates += (&width * &den).ceil().to_integer() + 1;
        if candidates > BigInt::from(4 * MAX_WEIGHTS) {
            return Err(too_many());
        }
        let mut p = first;
        while p <= last {
            if p.gcd(&BigInt::from(q)).is_one() {
                weights.push(Rational::new_raw(p.clone(), q.into()));
            }
            p += 1;
        }
    }
    if weights.len() as u64 > MAX_WEIGHTS { Err(too_many()) } else { Ok(weights) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(weights: &Weights) -> Vec<String> {
        let listed = weights.listed().unwrap_or_else(|e| unreachable!("{e}"));
        listed.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn weights_are_the_farey_sequence() {
        let five = ["0", "1/5", "1/4", "1/3", "2/5", "1/2", "3/5", "2/3", "3/4", "4/5", "1"];
        assert_eq!(shown(&Weights::unit(5)), five);
        // 1 + the sum of Euler's totients.
        for (q, size) in [(1, 2), (2, 3), (6, 13), (12, 47), (20, 129)] {
            assert_eq!(shown(&Weights::unit(q)).len(), size);
        }
    }

    #[test]
    fn ranges_may_leave_the_unit_interval_and_lists_are_sorted() {
        let range = Weights::Range { from: "-0.5".into(), to: "3/2".into(), max_denominator: 2 };
        assert_eq!(shown(&range), ["-1/2", "0", "1/2", "1", "3/2"]);
        let list = Weights::List(vec!["501/1000".into(), "0.2".into(), "1/5".into()]);
        assert_eq!(shown(&list), ["1/5", "501/1000"]);
    }

    #[test]
    fn bad_weights_are_refused() {
        let range = |from: &str, to: &str, max_denominator| Weights::Range {
            from: from.into(),
            to: to.into(),
            max_denominator,
        };
        for bad in [
            range("1", "0", 5),
            range("0", "1", 0),
            range("0", "1e9", 5),
            range("0", "1", 1_000_000),
            range("1/7", "1/7", 3),
            range("x", "1", 3),
            Weights::List(vec!["1/0".into()]),
            Weights::List(vec![]),
        ] {
            assert!(bad.listed().is_err(), "{bad:?}");
        }
    }
}
