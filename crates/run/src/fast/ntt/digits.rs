//! Between a number and the residues of its digits.

use cordon_vector::{Task, widest};

use super::residue::{LANES, PRIMES, Row, ZERO, inverse};

/// Digits in a group, and the limbs that they fill: 8 * 88 = 11 * 64.
const GROUP: usize = 8;
pub(super) const GROUP_LIMBS: usize = 11;
pub(super) const DIGIT: usize = 88;
const HALF: usize = DIGIT / 2;

/// Added to a natural number below it, it leaves that in the lower bits of the double.
const TWO_52: f64 = (1u64 << 52) as f64;

/// The digits of a number as residues, followed by zeros.
struct Spread<'a> {
    limbs: &'a [u64],
    rows: &'a mut Vec<Row>,
    /// 2^44.
    half: Row,
}

impl Task for Spread<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        for limbs in self.limbs.chunks(GROUP_LIMBS) {
            let mut group = [0; GROUP_LIMBS + 1];
            group[..limbs.len()].copy_from_slice(limbs);
            let mut rows = [ZERO; GROUP];
            for (i, row) in rows.iter_mut().enumerate() {
                let half = |bit: usize| {
                    let (at, shift) = (bit / 64, bit % 64);
                    let wide = u128::from(group[at]) | u128::from(group[at + 1]) << 64;
                    let half = (wide >> shift) as u64 & ((1 << HALF) - 1);
                    f64::from_bits(half | TWO_52.to_bits()) - TWO_52
                };
                let (low, high) = (half(DIGIT * i), half(DIGIT * i + HALF));
                *row = Row([high; 4]).times(self.half, fused).plus(Row([low; 4]));
            }
            self.rows.extend_from_slice(&rows);
        }
    }
}

/// The digits of a number as residues, in a vector of that length.
pub(super) fn spread(limbs: &[u64], length: usize) -> Vec<Row> {
    let mut rows = Vec::with_capacity(length);
    widest(Spread { limbs, rows: &mut rows, half: Row::of(|_, _| 1 << HALF) });
    rows.resize(length, ZERO);
    rows
}

/// The number whose digits, up to carries, have the given residues.
struct Gather<'a> {
    rows: &'a [Row],
    limbs: &'a mut [u64],
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
        for (limbs, rows) in self.limbs.chunks_mut(GROUP_LIMBS).zip(self.rows.chunks(GROUP)) {
            // Garner: coefficient = x0 + p0 (x1 + p1 (x2 + p2 x3)), each from those before it.
            let mut mixed = [[0.0; GROUP]; 4];
            for (i, lane) in LANES.into_iter().enumerate() {
                let mut column = [0.0; GROUP];
                for (x, row) in column.iter_mut().zip(rows) {
                    *x = lane.reduce(row.0[i], fused);
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
            let mut group = [0u64; GROUP_LIMBS + 1];
            let [x0, x1, x2, x3] = mixed;
            for (k, (((x0, x1), x2), x3)) in x0.into_iter().zip(x1).zip(x2).zip(x3).enumerate() {
                let [x0, x1, x2, x3] =
                    [x0, x1, x2, x3].map(|x| (x + TWO_52).to_bits() ^ TWO_52.to_bits());
                let a = wide(x3, p2) + u128::from(x2);
                let b0 = wide(a as u64, p1) + u128::from(x1);
                let b1 = wide((a >> 64) as u64, p1) + (b0 >> 64);
                let c0 = wide(b0 as u64, p0) + u128::from(x0);
                let c1 = wide(b1 as u64, p0) + (c0 >> 64);
                let c2 = wide((b1 >> 64) as u64, p0) + (c1 >> 64);
                let low = u128::from(c0 as u64) | u128::from(c1 as u64) << 64;
                let (low, over) = low.overflowing_add(carry);
                let digit = low & ((1 << DIGIT) - 1);
                carry = low >> DIGIT | (c2 + u128::from(over)) << (128 - DIGIT);
                let (at, shift) = (DIGIT * k / 64, DIGIT * k % 64);
                group[at] |= (digit << shift) as u64;
                group[at + 1] |= (digit >> (64 - shift)) as u64;
                if shift > 128 - DIGIT {
                    group[at + 2] |= (digit >> (128 - shift)) as u64;
                }
            }
            limbs.copy_from_slice(&group[..limbs.len()]);
        }
    }
}

/// The number of so many limbs whose digits, up to carries, have these residues.
pub(super) fn gather(rows: &[Row], limbs: usize) -> Vec<u64> {
    let over = [0, 1, 2].map(|j| Row::of(|p, _| inverse(PRIMES[j].0, p)).0);
    let mut number = vec![0; limbs];
    widest(Gather { rows, limbs: &mut number, over });
    number
}
