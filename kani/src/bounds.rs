//! How much a harness covers: named bounds, each with its reason.

use core::fmt;

use crate::source::{Domain, Source};

/// What a harness about a line of drones draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// The positions, integers in any unit of length. The theorems are homogeneous in the
    /// positions, so that a position is as well any fraction over a common denominator whose
    /// numerators are in this domain.
    pub positions: Domain,
    /// The weight eps.
    pub weights: Weights,
}

/// Which weights a harness draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weights {
    /// These fractions.
    Table(&'static [(i32, i32)]),
    /// Every quotient of a numerator and a denominator of these domains.
    Quotients(Domain, Domain),
}

impl Weights {
    /// Numerator and denominator of a weight.
    pub fn draw<S: Source>(self, source: &mut S) -> (i32, i32) {
        match self {
            Self::Table(table) => {
                let last = i32::try_from(table.len()).unwrap_or(i32::MAX) - 1;
                let at = source.integer(Domain::whole(0, last));
                // The index is drawn below the length; the first stands for none.
                let weight = usize::try_from(at).ok().and_then(|at| table.get(at));
                *weight.unwrap_or(&table[0])
            }
            Self::Quotients(numerator, denominator) => {
                (source.integer(numerator), source.integer(denominator))
            }
        }
    }
}

/// Weights within [0, 1/2], with the ends, the paper's bound 1/3, and the weights of its runs and
/// recordings (1/10, 1/5, 1/4, 3/10) among them. Small denominators keep the products narrow.
pub const UP_TO_HALF: Weights =
    Weights::Table(&[(0, 1), (1, 10), (1, 5), (1, 4), (3, 10), (1, 3), (2, 5), (1, 2)]);

/// For three drones the order is kept up to 1.
pub const UP_TO_ONE: Weights =
    Weights::Table(&[(0, 1), (1, 5), (1, 3), (1, 2), (7, 10), (9, 10), (1, 1)]);

/// The same without 0, where the drones stand still.
pub const POSITIVE_UP_TO_HALF: Weights =
    Weights::Table(&[(1, 10), (1, 5), (3, 10), (1, 3), (1, 2)]);

/// Every weight with a denominator of 4 bits: the solver's work grows with the product of two
/// free numbers.
pub const QUOTIENTS: Weights = Weights::Quotients(Domain::new(0, 15, 4), Domain::new(1, 15, 6));

/// The weight of the paper's bound and a usual choice: for harnesses that are dear for another
/// reason.
pub const THREE_TENTHS: Weights = Weights::Table(&[(3, 10)]);

/// The largest safe weight.
pub const HALF: Weights = Weights::Table(&[(1, 2)]);

/// The paper's bound.
pub const THIRD: Weights = Weights::Table(&[(1, 3)]);

/// The paper's unstable run (Figs 11 and 12).
pub const SEVEN_TENTHS: Weights = Weights::Table(&[(7, 10)]);

/// Just above the bound 1/2: 501/1000.
pub const ABOVE_HALF: Weights = Weights::Table(&[(501, 1000)]);

/// No motion.
pub const ZERO: Weights = Weights::Table(&[(0, 1)]);

/// Positions of 8 bits: what a harness affords for all weights of a table.
pub const BYTE: Domain = Domain::new(0, 255, 6);

/// Positions of 16 bits: the range of a segment of 65 m in millimetres.
pub const WORD: Domain = Domain::new(0, 65_535, 6);

/// Positions of 5 bits: what a harness affords where the weight's parts are free too.
pub const FIVE_BITS: Domain = Domain::new(0, 31, 6);

/// Positions of 4 bits: where errors are squared or several steps are run.
pub const FOUR_BITS: Domain = Domain::new(0, 15, 6);

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..={}", self.low, self.high)
    }
}

impl fmt::Display for Weights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(table) => {
                for (i, (num, den)) in table.iter().enumerate() {
                    let comma = if i == 0 { "" } else { ", " };
                    match den {
                        1 => write!(f, "{comma}{num}")?,
                        _ => write!(f, "{comma}{num}/{den}")?,
                    }
                }
                Ok(())
            }
            Self::Quotients(num, den) => write!(f, "p/q, p in {num}, q in {den}"),
        }
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "positions {}, eps {}", self.positions, self.weights)
    }
}
