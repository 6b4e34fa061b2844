//! Between a number and the residues of its digits.

use cordon_vector::{Task, widest};

use super::residue::{LANES, PRIMES, Row, Words, inverse};

/// Digits in a group, and the limbs that they fill: 8 * 88 = 11 * 64.
const GROUP: usize = 8;
pub(super) const GROUP_LIMBS: usize = 11;
pub(super) const DIGIT: usize = 88;
const HALF: usize = DIGIT / 2;

/// Words of a row.
pub(super) const ROW: usize = 4;

/// Added to a natural number below it, it leaves that in the lower bits of the double.
const TWO_52: f64 = (1u64 << 52) as f64;

/// The digits of a number as residues, in the place of the number.
struct Spread<'a> {
    /// The number, followed by zeros.
    words: &'a mut [u64],
    limbs: usize,
    /// Where the rows begin.
    skip: usize,
    /// 2^44.
    half: Row,
}

impl Task for Spread<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        // From the last group on: rows are longer than limbs, and so overwrite what has been read.
        for at in (0..self.limbs.div_ceil(GROUP_LIMBS)).rev() {
            let mut group = [0; GROUP_LIMBS + 1];
            let from = &self.words[at * GROUP_LIMBS..self.limbs.min((at + 1) * GROUP_LIMBS)];
            group[..from.len()].copy_from_slice(from);
            let into = &mut self.words[self.skip + at * GROUP * ROW..][..GROUP * ROW];
            for (i, row) in into.as_chunks_mut().0.iter_mut().enumerate() {
                let half = |bit: usize| {
                    let (at, shift) = (bit / 64, bit % 64);
                    let wide = u128::from(group[at]) | u128::from(group[at + 1]) << 64;
                    let half = (wide >> shift) as u64 & ((1 << HALF) - 1);
                    f64::from_bits(half | TWO_52.to_bits()) - TWO_52
                };
                let (low, high) = (half(DIGIT * i), half(DIGIT * i + HALF));
                Row([high; 4]).times(self.half, fused).plus(Row([low; 4])).store(row);
            }
        }
    }
}

/// Replaces the number in the first `limbs` words, after which there are zeros, by its digits as
/// residues: rows that begin after `skip` words, `skip` being at most [`GROUP`].
pub(super) fn spread(words: &mut [u64], limbs: usize, skip: usize) {
    widest(Spread { words, limbs, skip, half: Row::of(|_, _| 1 << HALF) });
}

/// Rows at a time whose digits are found, so many that a processor need not wait for one operation
/// before it starts the next; and the limbs that they fill.
const BATCH: usize = 4 * GROUP;
const BATCH_LIMBS: usize = 4 * GROUP_LIMBS;

/// The number whose digits, up to carries, have the given residues, in their place.
struct Gather<'a> {
    words: &'a mut [u64],
    limbs: usize,
    /// Where the rows begin.
    skip: usize,
    /// `over[j][i]` is the inverse of prime j modulo prime i > j.
    over: [[f64; 4]; 3],
}

impl Task for Gather<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        let wide = |a: u64, b: u64| u128::from(a) * u128::from(b);
        let [p0, p1, p2, _] = PRIMES.map(|(p, _)| p);
        // What lies above the digits written so far: below 2^128.
        let mut carry = 0u128;
        for at in 0..self.limbs.div_ceil(BATCH_LIMBS) {
            let rest = &self.words[self.skip + at * BATCH * ROW..];
            let rows: &[Words] = rest[..rest.len().min(BATCH * ROW)].as_chunks().0;
            // Garner: coefficient = x0 + p0 (x1 + p1 (x2 + p2 x3)), each from those before it.
            let mut mixed = [[0.0; BATCH]; 4];
            for (i, lane) in LANES.into_iter().enumerate() {
                let mut column = [0.0; BATCH];
                for (x, row) in column.iter_mut().zip(rows) {
                    *x = lane.reduce(f64::from_bits(row[i]), fused);
                }
                for (known, over) in mixed.iter().zip(&self.over).take(i) {
                    for (x, known) in column.iter_mut().zip(known) {
                        *x = lane.times(*x - known, over[i], fused);
                    }
                }
                for x in &mut column {
                    *x = lane.reduce(*x, fused);
                }
                // From 0 to p.
                for x in &mut column {
                    *x += if *x < 0.0 { lane.p } else { 0.0 };
                }
                mixed[i] = column;
            }
            let mut batch = [0; BATCH_LIMBS];
            for part in 0..BATCH / GROUP {
                let mut digits = [0; GROUP + 1];
                for (k, digit) in digits.iter_mut().take(GROUP).enumerate() {
                    let [x0, x1, x2, x3] = [0, 1, 2, 3].map(|i: usize| {
                        (mixed[i][part * GROUP + k] + TWO_52).to_bits() ^ TWO_52.to_bits()
                    });
                    let a = wide(x3, p2) + u128::from(x2);
                    let b0 = wide(a as u64, p1) + u128::from(x1);
                    let b1 = wide((a >> 64) as u64, p1) + (b0 >> 64);
                    let c0 = wide(b0 as u64, p0) + u128::from(x0);
                    let c1 = wide(b1 as u64, p0) + (c0 >> 64);
                    let c2 = wide((b1 >> 64) as u64, p0) + (c1 >> 64);
                    let low = u128::from(c0 as u64) | u128::from(c1 as u64) << 64;
                    let (low, over) = low.overflowing_add(carry);
                    *digit = low & ((1 << DIGIT) - 1);
                    carry = low >> DIGIT | (c2 + u128::from(over)) << (128 - DIGIT);
                }
                let group = &mut batch[part * GROUP_LIMBS..][..GROUP_LIMBS];
                for (j, limb) in group.iter_mut().enumerate() {
                    let (i, shift) = (64 * j / DIGIT, 64 * j % DIGIT);
                    *limb = (digits[i] >> shift | digits[i + 1] << (DIGIT - shift)) as u64;
                }
            }
            let from = at * BATCH_LIMBS;
            let into = &mut self.words[from..self.limbs.min(from + BATCH_LIMBS)];
            into.copy_from_slice(&batch[..into.len()]);
        }
    }
}

/// Replaces rows that begin after `skip` words by the number of so many limbs whose digits, up to
/// carries, have these residues.
pub(super) fn gather(words: &mut [u64], limbs: usize, skip: usize) {
    let over = [0, 1, 2].map(|j| Row::of(|p, _| inverse(PRIMES[j].0, p)).0);
    widest(Gather { words, limbs, skip, over });
}
