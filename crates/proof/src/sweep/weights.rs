//! The weights eps that a sweep covers.

use num_bigint::BigInt;
use num_traits::Zero;
use serde::{Deserialize, Serialize};

use cordon_core::linear::simplest::fractions_within;
use cordon_core::{Error, Rational, Result, serial};

/// Which weights a sweep covers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WeightSet {
    /// Every p/q in lowest terms with `from <= p/q <= to` and q at most `max_denominator`.
    Range {
        /// The least weight, which belongs to the range.
        #[serde(with = "serial")]
        from: Rational,
        /// The largest weight, which belongs to the range.
        #[serde(with = "serial")]
        to: Rational,
        /// Largest denominator, at least 1.
        max_denominator: u32,
    },
    /// The weights listed, and no others.
    List(#[serde(with = "serial::list")] Vec<Rational>),
}

/// Most weights in one sweep; more are a mistake, and would fill the memory with work items.
const MAX_WEIGHTS: u64 = 1_000_000;

impl WeightSet {
    /// The weights from 0 to 1, definition 6 of the paper.
    pub fn unit(max_denominator: u32) -> Self {
        let [from, to] = [0, 1].map(|end: i32| Rational::from_integer(end.into()));
        Self::Range { from, to, max_denominator }
    }

    /// The weights in increasing order, none twice.
    ///
    /// # Errors
    /// An empty or reversed range, more than a million weights.
    pub fn listed(&self) -> Result<Vec<Rational>> {
        let mut weights = match self {
            Self::List(list) => list.clone(),
            Self::Range { from, to, max_denominator } => in_range(from, to, *max_denominator)?,
        };
        weights.sort();
        weights.dedup();
        if weights.is_empty() {
            return Err(Error::input("eps: no weight is in the range: expected at least one"));
        }
        Ok(weights)
    }
}

fn in_range(from: &Rational, to: &Rational, max_denominator: u32) -> Result<Vec<Rational>> {
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
    // What listing them costs is bounded before they are listed.
    let mut candidates = BigInt::zero();
    for q in 1..=max_denominator {
        candidates += ((to - from) * BigInt::from(q)).ceil().to_integer() + 1;
        if candidates > BigInt::from(4 * MAX_WEIGHTS) {
            return Err(too_many());
        }
    }
    let weights = fractions_within(from, to, max_denominator);
    if weights.len() as u64 > MAX_WEIGHTS { Err(too_many()) } else { Ok(weights) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    fn shown(weights: &WeightSet) -> Vec<String> {
        let listed = weights.listed().unwrap_or_else(|e| unreachable!("{e}"));
        listed.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn weights_are_the_farey_sequence() {
        let five = ["0", "1/5", "1/4", "1/3", "2/5", "1/2", "3/5", "2/3", "3/4", "4/5", "1"];
        assert_eq!(shown(&WeightSet::unit(5)), five);
        // 1 + the sum of Euler's totients.
        for (q, size) in [(1, 2), (2, 3), (6, 13), (12, 47), (20, 129)] {
            assert_eq!(shown(&WeightSet::unit(q)).len(), size);
        }
    }

    #[test]
    fn ranges_may_leave_the_unit_interval_and_lists_are_sorted() {
        let range = WeightSet::Range { from: q(-1, 2), to: q(3, 2), max_denominator: 2 };
        assert_eq!(shown(&range), ["-1/2", "0", "1/2", "1", "3/2"]);
        let list = WeightSet::List(vec![q(501, 1000), q(1, 5), q(2, 10)]);
        assert_eq!(shown(&list), ["1/5", "501/1000"]);
    }

    #[test]
    fn bad_weights_are_refused() {
        let range = |from, to, max_denominator| WeightSet::Range { from, to, max_denominator };
        for bad in [
            range(q(1, 1), q(0, 1), 5),
            range(q(0, 1), q(1, 1), 0),
            range(q(0, 1), q(1_000_000_000, 1), 5),
            range(q(0, 1), q(1, 1), 1_000_000),
            range(q(1, 7), q(1, 7), 3),
            WeightSet::List(vec![]),
        ] {
            assert!(bad.listed().is_err(), "{bad:?}");
        }
    }

    #[test]
    fn files_hold_fractions() {
        let text = r#"{"range":{"from":"-1/2","to":"1","max_denominator":3}}"#;
        let read = |text: &str| serde_json::from_str::<WeightSet>(text);
        let set = read(text).unwrap_or_else(|e| unreachable!("{e}"));
        assert_eq!(set, WeightSet::Range { from: q(-1, 2), to: q(1, 1), max_denominator: 3 });
        assert_eq!(serde_json::to_string(&set).ok().as_deref(), Some(text));
        assert!(read(r#"{"list":["1/0"]}"#).is_err());
        assert!(read(r#"{"list":["x"]}"#).is_err());
    }
}
