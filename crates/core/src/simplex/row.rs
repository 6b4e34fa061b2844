//! Sparse rows of integers, known up to a positive factor.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

use super::int::Int;
use crate::Rational;

/// The entries that are not zero, by column. The factor is free: it changes neither a sign nor a
/// ratio.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    entries: Vec<(usize, Int)>,
}

const ZERO: &Int = &Int::Small(0);

impl Row {
    /// The row with these entries, scaled by a positive number to integers without a common divisor.
    pub fn integral<'x>(entries: impl Iterator<Item = (usize, &'x Rational)>) -> Self {
        let mut entries: Vec<_> = entries.filter(|(_, x)| !x.is_zero()).collect();
        entries.sort_by_key(|(j, _)| *j);
        let one = BigInt::one();
        let fractions = entries.iter().filter(|(_, x)| !x.is_integer());
        let common = fractions.fold(one, |lcm, (_, x)| lcm.lcm(x.denom()));
        let scaled = |(j, x): (usize, &Rational)| match common.is_one() {
            true => (j, Int::from(x.numer().clone())),
            false => (j, Int::from(x.numer() * (&common / x.denom()))),
        };
        let mut row = Self { entries: entries.into_iter().map(scaled).collect() };
        row.reduce();
        row
    }

    /// The entry in a column.
    pub fn at(&self, column: usize) -> &Int {
        let index = self.entries.binary_search_by_key(&column, |(j, _)| *j);
        index.ok().and_then(|i| self.entries.get(i)).map_or(ZERO, |(_, x)| x)
    }

    /// The entries that are not zero, by column.
    pub fn entries(&self) -> impl Iterator<Item = (usize, &Int)> {
        self.entries.iter().map(|(j, x)| (*j, x))
    }

    /// The first column below `end` whose entry is negative.
    pub fn first_negative(&self, end: usize) -> Option<usize> {
        let entries = self.entries().take_while(|(j, _)| *j < end);
        entries.filter(|(_, x)| x.is_negative()).map(|(j, _)| j).next()
    }

    pub fn negate(&mut self) {
        self.entries.iter_mut().for_each(|(_, x)| *x = x.negated());
    }

    /// `own` times this row minus `factor` times another.
    pub fn combine(&mut self, own: &Int, other: &Self, factor: &Int) {
        let mut mine = std::mem::take(&mut self.entries).into_iter().peekable();
        let mut theirs = other.entries.iter().peekable();
        let mut entries = Vec::with_capacity(mine.len() + theirs.len());
        loop {
            let columns = (mine.peek().map(|(j, _)| *j), theirs.peek().map(|(j, _)| *j));
            let column = match columns {
                (Some(a), Some(b)) => a.min(b),
                (Some(j), None) | (None, Some(j)) => j,
                (None, None) => break,
            };
            let x = mine.next_if(|(j, _)| *j == column);
            let y = theirs.next_if(|(j, _)| *j == column);
            let x = x.as_ref().map_or(ZERO, |(_, x)| x);
            let value = Int::determinant(own, x, factor, y.map_or(ZERO, |(_, y)| y));
            if !value.is_zero() {
                entries.push((column, value));
            }
        }
        self.entries = entries;
        // Only big integers are worth reducing: it keeps them from growing.
        if self.entries.iter().any(|(_, x)| matches!(x, Int::Big(_))) {
            self.reduce();
        }
    }

    /// The cost of computing its entries.
    pub fn work(&self) -> u64 {
        self.entries.iter().map(|(_, x)| x.work()).sum()
    }

    /// The cost of reading a row of this many numbers, which arrive as big integers.
    pub fn work_of_reading(numbers: usize) -> u64 {
        20 * numbers as u64
    }

    /// Adds the multiple of `pivot_row` that clears a column, for a positive pivot; returns whether the
    /// entry was nonzero.
    pub fn eliminate(&mut self, pivot_row: &Self, column: usize) -> bool {
        let factor = self.at(column);
        if factor.is_zero() {
            return false;
        }
        let pivot = pivot_row.at(column);
        let common = pivot.gcd(factor);
        let (own, factor) = (pivot.divided(&common), factor.divided(&common));
        self.combine(&own, pivot_row, &factor);
        true
    }

    fn reduce(&mut self) {
        let mut divisor = Int::Small(0);
        for (_, x) in &self.entries {
            divisor = divisor.gcd(x);
            if divisor == Int::Small(1) {
                return;
            }
        }
        self.entries.iter_mut().for_each(|(_, x)| *x = x.divided(&divisor));
    }
}
