//! Long multiplication by number-theoretic transforms: the default backend.
//!
//! Both factors are cut into digits of 88 bits, the coefficients of two polynomials; their
//! product is found modulo four primes below 2^50 at once, by transforms of length 2^a or 3*2^a,
//! and put together by the Chinese remainder theorem. Portable Rust without `unsafe`, in time
//! n log n: `benches/peers` measures it against the libraries. Short factors go to
//! `num-bigint`.
//!
//! Residues are integers in doubles, the four of one coefficient side by side in a `Row`, so
//! that all arithmetic is on vectors of four. Products modulo p are exact: `a*b = h + l` with
//! the rounded product h and its error l, both doubles, and `h - q*p` is small for the rounded
//! quotient q (see `Lane::times`). Residues are lazy: a few p long, of either sign. The bounds
//! are in the comments, in units of p.
//!
//! The transform is the one of a product tree: a node reduces a polynomial modulo `z^2h - r^2`
//! to its remainders modulo `z^h - r` and `z^h + r`, in place, two levels a pass. The twiddle
//! factors r in bit-reversed order are the same table at every depth.

use cordon_vector::{Task, widest};

use super::limbs;
use super::multiply::{Multiply, NumBigint};

/// Number-theoretic transforms over four primes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ntt;

/// Factors shorter than this many limbs go to `num-bigint`, which is faster there.
pub(super) const SHORTEST: usize = 450;

/// Most limbs of the shorter factor of one transform: 2^23 digits, so that a coefficient of the
/// product, below 2^(23 + 2*88), is below the product of the primes.
const LONGEST: usize = (1 << 20) * GROUP_LIMBS;

impl Multiply for Ntt {
    fn name(&self) -> &'static str {
        "ntt"
    }

    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
        let (a, b) = (limbs::trimmed(a), limbs::trimmed(b));
        let (short, long) = if a.len() < b.len() { (a, b) } else { (b, a) };
        if short.len() < SHORTEST {
            return NumBigint.product(a, b);
        }
        if short.len() <= LONGEST {
            return multiply(long.to_vec(), Some(short));
        }
        in_parts(short, long, LONGEST)
    }

    fn square(&self, mut a: Vec<u64>) -> Vec<u64> {
        a.truncate(limbs::trimmed(&a).len());
        match a.len() {
            ..SHORTEST => NumBigint.square(a),
            SHORTEST..=LONGEST => multiply(a, None),
            _ => self.product(&a, &a),
        }
    }
}

/// A prime p = 1 modulo 2^36, a little below 0.99*2^50, and its inverse as a double.
#[derive(Clone, Copy)]
struct Lane {
    p: f64,
    inverse: f64,
}

/// The primes, each with a quadratic non-residue.
const PRIMES: [(u64, u64); 4] = [
    (0x3_f580_0000_0001, 3),
    (0x3_f490_0000_0001, 3),
    (0x3_f3a0_0000_0001, 3),
    (0x3_f2a0_0000_0001, 19),
];

const LANES: [Lane; 4] = {
    let mut lanes = [Lane { p: 0.0, inverse: 0.0 }; 4];
    let mut i = 0;
    while i < 4 {
        let p = PRIMES[i].0 as f64;
        lanes[i] = Lane { p, inverse: 1.0 / p };
        i += 1;
    }
    lanes
};

/// `a*b - h` for the rounded product h, exactly. `fused`: whether [`f64::mul_add`] is an
/// instruction.
#[inline(always)]
fn error(a: f64, b: f64, h: f64, fused: bool) -> f64 {
    if fused {
        return a.mul_add(b, -h);
    }
    // T. J. Dekker: factors of 26 bits, whose products are exact.
    let split = |x: f64| {
        let c = x * 134_217_729.0;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    a0 * b0 - (((h - a1 * b1) - a0 * b1) - a1 * b0)
}

/// The nearest integer, for |x| up to 2^52.
#[inline(always)]
fn nearest(x: f64, fused: bool) -> f64 {
    if fused {
        return x.round_ties_even();
    }
    let unit = (1u64 << 52) as f64;
    let shift = unit.copysign(x);
    (x + shift) - shift
}

impl Lane {
    /// `a*b` modulo p, for integers with |a b| up to 4 p^2: a result up to
    /// 1/2 + 0.38 |a b|/p^2, exactly.
    ///
    /// The product h, the inverse and their product each round by 2^-53 at most, so that the
    /// quotient q is off a b/p by at most 1/2 + 3.01 * 2^-53 |a b|/p, where 2^-53 p is below
    /// 0.99/8. So `h - q*p`, the error of h and their sum are integers below 2^53, which doubles
    /// hold: no operation after the quotient rounds.
    #[inline(always)]
    fn times(self, a: f64, b: f64, fused: bool) -> f64 {
        let h = a * b;
        let l = error(a, b, h, fused);
        let q = nearest(h * self.inverse, fused);
        if fused {
            return (-q).mul_add(self.p, h) + l;
        }
        let g = q * self.p;
        (h - g) - error(q, self.p, g, fused) + l
    }

    /// `a` brought to |result| <= 1/2, from |a| <= 8.
    #[inline(always)]
    fn reduce(self, a: f64, fused: bool) -> f64 {
        let q = nearest(a * self.inverse, fused);
        if fused { (-q).mul_add(self.p, a) } else { a - q * self.p }
    }
}

/// A coefficient modulo each of the primes.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Row([f64; 4]);

const ZERO: Row = Row([0.0; 4]);

impl Row {
    /// `f` of each pair of residues.
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(Lane, f64, f64) -> f64) -> Self {
        let mut result = ZERO;
        for (((x, lane), a), b) in result.0.iter_mut().zip(LANES).zip(self.0).zip(other.0) {
            *x = f(lane, a, b);
        }
        result
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self.with(other, |_, a, b| a + b)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.with(other, |_, a, b| a - b)
    }

    #[inline(always)]
    fn times(self, other: Self, fused: bool) -> Self {
        self.with(other, |lane, a, b| lane.times(a, b, fused))
    }

    #[inline(always)]
    fn reduced(self, fused: bool) -> Self {
        self.with(self, |lane, a, _| lane.reduce(a, fused))
    }

    /// What `make` returns for each prime and its non-residue.
    fn of(make: impl Fn(u64, u64) -> u64) -> Self {
        Self(PRIMES.map(|(p, non_residue)| balanced(make(p, non_residue), p)))
    }
}

/// `x` below p as the nearest of its residues to 0.
fn balanced(x: u64, p: u64) -> f64 {
    if x > p / 2 { -((p - x) as f64) } else { x as f64 }
}

fn power(mut base: u64, mut exponent: u64, p: u64) -> u64 {
    let times = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(p)) as u64;
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = times(result, base);
        }
        base = times(base, base);
        exponent >>= 1;
    }
    result
}

fn inverse(x: u64, p: u64) -> u64 {
    power(x % p, p - 2, p)
}

/// The twiddle factors: that of node b is the square root of what node b reduces by,
/// `root^(bits of b reversed)`. That of the sum of two nodes without a bit in common is the
/// product of theirs.
struct Twiddles {
    /// Of the nodes 0 .. `LOW`.
    low: Vec<Row>,
    /// Of their multiples.
    high: Vec<Row>,
}

const LOW: usize = 1 << 9;

/// The roots of unity that are used have orders up to 2^DEEPEST.
const DEEPEST: u32 = 36;

impl Twiddles {
    /// Those of nodes 0 .. count; of the inverse roots if `backward`.
    fn new(count: usize, backward: bool) -> Self {
        // Of order 2^depth, from the one that is needed last.
        let mut roots = vec![Row::of(|p, non_residue| {
            let root = power(non_residue, (p - 1) >> DEEPEST, p);
            if backward { inverse(root, p) } else { root }
        })];
        for depth in (2..DEEPEST).rev() {
            let root = roots[(DEEPEST - depth - 1) as usize];
            roots.push(root.times(root, false).reduced(false));
        }
        roots.reverse();
        let table = |count: usize, first: usize| {
            let mut table = vec![Row([1.0; 4])];
            for root in &roots[first..] {
                for b in 0..table.len().min(count - table.len()) {
                    table.push(table[b].times(*root, false).reduced(false));
                }
            }
            table
        };
        Self {
            low: table(count.min(LOW), 0),
            high: table(count.div_ceil(LOW), LOW.ilog2() as usize),
        }
    }

    /// At most 1/2.
    #[inline(always)]
    fn at(&self, node: usize, fused: bool) -> Row {
        let low = self.low[node % LOW];
        if node < LOW { low } else { low.times(self.high[node / LOW], fused).reduced(fused) }
    }

    /// Those of a node and of its two children.
    #[inline(always)]
    fn three(&self, node: usize, fused: bool) -> [Row; 3] {
        [self.at(node, fused), self.at(2 * node, fused), self.at(2 * node + 1, fused)]
    }
}

/// Segments of so many rows are done depth by depth in one call. Longer ones are left to their
/// quarters after a pass, which so are in the fastest memory when their turn comes.
const BLOCK: usize = 32;

#[inline(always)]
fn quarters(x: &mut [Row]) -> [&mut [Row]; 4] {
    let (low, high) = x.split_at_mut(x.len() / 2);
    let (a, b) = low.split_at_mut(low.len() / 2);
    let (c, d) = high.split_at_mut(high.len() / 2);
    [a, b, c, d]
}

/// Two levels forward. Residues up to 2.72 before and after.
#[inline(always)]
fn reduce_four(x: &mut [Row], [r, left, right]: [Row; 3], fused: bool) {
    let [a, b, c, d] = quarters(x);
    for (((a, b), c), d) in a.iter_mut().zip(b).zip(c).zip(d) {
        let (a0, b0) = (a.reduced(fused), *b);
        let (c0, d0) = (c.times(r, fused), d.times(r, fused));
        let (low, low_odd) = (a0.plus(c0), b0.plus(d0).times(left, fused));
        let (high, high_odd) = (a0.minus(c0), b0.minus(d0).times(right, fused));
        (*a, *b) = (low.plus(low_odd), low.minus(low_odd));
        (*c, *d) = (high.plus(high_odd), high.minus(high_odd));
    }
}

/// Two levels backward. Residues up to 1.96 before and after.
#[inline(always)]
fn join_four(x: &mut [Row], [r, left, right]: [Row; 3], fused: bool) {
    let [a, b, c, d] = quarters(x);
    for (((a, b), c), d) in a.iter_mut().zip(b).zip(c).zip(d) {
        let (low, low_odd) = (a.plus(*b), a.minus(*b).times(left, fused));
        let (high, high_odd) = (c.plus(*d), c.minus(*d).times(right, fused));
        *a = low.plus(high).reduced(fused);
        *b = low_odd.plus(high_odd).reduced(fused);
        *c = low.minus(high).times(r, fused);
        *d = low_odd.minus(high_odd).times(r, fused);
    }
}

/// One level forward.
#[inline(always)]
fn reduce_two(x: &mut [Row], r: Row, fused: bool) {
    let (low, high) = x.split_at_mut(x.len() / 2);
    for (a, b) in low.iter_mut().zip(high) {
        let (a0, b0) = (a.reduced(fused), b.times(r, fused));
        (*a, *b) = (a0.plus(b0), a0.minus(b0));
    }
}

/// One level backward.
#[inline(always)]
fn join_two(x: &mut [Row], r: Row, fused: bool) {
    let (low, high) = x.split_at_mut(x.len() / 2);
    for (a, b) in low.iter_mut().zip(high) {
        (*a, *b) = (a.plus(*b).reduced(fused), a.minus(*b).times(r, fused));
    }
}

/// A part of a transform: two levels of the whole segment, or all levels of a block.
struct Levels<'a> {
    x: &'a mut [Row],
    node: usize,
    twiddles: &'a Twiddles,
    backward: bool,
}

impl Task for Levels<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        let Self { x, node, twiddles, backward } = self;
        let length = x.len();
        if length > BLOCK {
            let three = twiddles.three(node, fused);
            if backward {
                join_four(x, three, fused)
            } else {
                reduce_four(x, three, fused)
            }
            return;
        }
        let odd = length.trailing_zeros() % 2 == 1;
        if !backward {
            let mut size = length;
            if odd {
                reduce_two(x, twiddles.at(node, fused), fused);
                size /= 2;
            }
            while size > 1 {
                let first = node * (length / size);
                for (i, segment) in x.chunks_exact_mut(size).enumerate() {
                    reduce_four(segment, twiddles.three(first + i, fused), fused);
                }
                size /= 4;
            }
        } else {
            let mut size = 4;
            while size <= length {
                let first = node * (length / size);
                for (i, segment) in x.chunks_exact_mut(size).enumerate() {
                    join_four(segment, twiddles.three(first + i, fused), fused);
                }
                size *= 4;
            }
            if odd {
                join_two(x, twiddles.at(node, fused), fused);
            }
        }
    }
}

/// The values of a polynomial at the leaves below a node.
fn forward(x: &mut [Row], node: usize, twiddles: &Twiddles) {
    widest(Levels { x, node, twiddles, backward: false });
    if x.len() > BLOCK {
        for (i, quarter) in quarters(x).into_iter().enumerate() {
            forward(quarter, 4 * node + i, twiddles);
        }
    }
}

/// The polynomial from its values, times the number of leaves.
fn backward(x: &mut [Row], node: usize, twiddles: &Twiddles) {
    if x.len() > BLOCK {
        for (i, quarter) in quarters(x).into_iter().enumerate() {
            backward(quarter, 4 * node + i, twiddles);
        }
    }
    widest(Levels { x, node, twiddles, backward: true });
}

/// The first or the last pass of a length of 3*2^a: the tree of length 2^(a+2) without its last
/// quarter.
struct Three<'a> {
    x: &'a mut [Row],
    /// A square root of -1: the inverse of the forward one if `backward`.
    quarter_turn: Row,
    backward: bool,
}

impl Task for Three<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        let third = self.x.len() / 3;
        let (low, rest) = self.x.split_at_mut(third);
        let (middle, top) = rest.split_at_mut(third);
        for ((a, b), c) in low.iter_mut().zip(middle).zip(top) {
            let turned = b.times(self.quarter_turn, fused);
            if !self.backward {
                // Modulo z^2q - 1: (a + c) + b z^q. Modulo z^q - i: a - c + i b.
                (*a, *c) = (a.plus(*c), a.minus(*c).plus(turned));
            } else {
                // With a = 2q(a' + c'), b = 2q b', c = q(a' - c' + i b'): 4q a', 4q b', 4q c'.
                let difference = c.plus(*c).plus(turned);
                (*a, *b, *c) = (a.plus(difference), b.plus(*b), a.minus(difference));
            }
        }
    }
}

/// The shortest transform length of at least n: 2^a or 3*2^a.
fn transform_length(n: usize) -> usize {
    let power = n.next_power_of_two().max(16);
    if n <= power / 4 * 3 { power / 4 * 3 } else { power }
}

/// Both directions of a transform of one length.
fn transform(x: &mut [Row], twiddles: &Twiddles, back: bool) {
    let length = x.len();
    if length.is_power_of_two() {
        return if back { backward(x, 0, twiddles) } else { forward(x, 0, twiddles) };
    }
    let quarter_turn = twiddles.low[1];
    if back {
        let (pair, single) = x.split_at_mut(length / 3 * 2);
        backward(pair, 0, twiddles);
        backward(single, 2, twiddles);
        widest(Three { x, quarter_turn, backward: true });
    } else {
        widest(Three { x, quarter_turn, backward: false });
        let (pair, single) = x.split_at_mut(length / 3 * 2);
        forward(pair, 0, twiddles);
        forward(single, 2, twiddles);
    }
}

/// Digits in a group, and the limbs that they fill: 8 * 88 = 11 * 64.
const GROUP: usize = 8;
const GROUP_LIMBS: usize = 11;
const DIGIT: usize = 88;
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

fn spread(limbs: &[u64], length: usize) -> Vec<Row> {
    let mut rows = Vec::with_capacity(length);
    widest(Spread { limbs, rows: &mut rows, half: Row::of(|_, _| 1 << HALF) });
    rows.resize(length, ZERO);
    rows
}

/// The products of values, times `scale`. Up to 1.6, from factors up to 2.72.
struct Pointwise<'a> {
    x: &'a mut [Row],
    y: Option<&'a [Row]>,
    scale: Row,
}

impl Task for Pointwise<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        match self.y {
            None => {
                for x in self.x {
                    *x = x.times(self.scale, fused).times(*x, fused);
                }
            }
            Some(y) => {
                for (x, y) in self.x.iter_mut().zip(y) {
                    *x = x.times(self.scale, fused).times(*y, fused);
                }
            }
        }
    }
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

/// `short * long`, from products of `most` limbs of the short factor.
fn in_parts(short: &[u64], long: &[u64], most: usize) -> Vec<u64> {
    let mut sum = vec![0; short.len() + long.len()];
    for (i, part) in short.chunks(most).enumerate() {
        limbs::add(&mut sum[i * most..], &Ntt.product(part, long), false);
    }
    sum
}

/// `a*b`, or `a*a` where `b` is `None`; both nonempty.
fn multiply(a: Vec<u64>, b: Option<&[u64]>) -> Vec<u64> {
    let limbs = a.len() + b.map_or(a.len(), <[u64]>::len);
    let length = transform_length((limbs * 64).div_ceil(DIGIT));
    let leaves = length.next_power_of_two();
    let twiddles = Twiddles::new(leaves / 2, false);
    let mut x = spread(&a, length);
    drop(a);
    transform(&mut x, &twiddles, false);
    let y = b.map(|b| {
        let mut y = spread(b, length);
        transform(&mut y, &twiddles, false);
        y
    });
    let scale = Row::of(|p, _| inverse(leaves as u64, p));
    widest(Pointwise { x: &mut x, y: y.as_deref(), scale });
    drop(y);
    transform(&mut x, &Twiddles::new(leaves / 2, true), true);
    let over = [0, 1, 2].map(|j| Row::of(|p, _| inverse(PRIMES[j].0, p)).0);
    let mut product = vec![0; limbs];
    widest(Gather { rows: &x, limbs: &mut product, over });
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(length: usize, mut state: u64) -> Vec<u64> {
        let next = |_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        (0..length).map(next).collect()
    }

    /// Every transform length up to several blocks, with extreme and random limbs.
    #[test]
    fn products_are_those_of_num_bigint() {
        let mut lengths = std::collections::BTreeSet::new();
        for n in
            [1usize, 2, 3, 5, 8, 12, 13, 100, 383, 384, 385, 1000, 3000, 3100, 6144, 8000, 9000]
        {
            let all_ones = vec![u64::MAX; n];
            let (a, b) = (random(n, 88172645463325252), random(n.div_ceil(3), 12345));
            for (x, y) in [(&a, &b), (&all_ones, &a), (&all_ones, &all_ones)] {
                let got = limbs::natural(&multiply(x.clone(), Some(y)));
                assert_eq!(got, limbs::natural(&NumBigint.product(x, y)), "{n} limbs");
                lengths.insert(transform_length(((x.len() + y.len()) * 64).div_ceil(DIGIT)));
            }
            for x in [&a, &all_ones] {
                let got = limbs::natural(&multiply(x.clone(), None));
                assert_eq!(
                    got,
                    limbs::natural(&NumBigint.square(x.clone())),
                    "square of {n} limbs"
                );
            }
        }
        assert!(lengths.iter().any(|l| l.is_power_of_two() && *l > 1 << 12));
        assert!(lengths.iter().any(|l| !l.is_power_of_two() && *l > 1 << 12));
    }

    #[test]
    fn transform_lengths_waste_little() {
        for n in 1..5000 {
            let length = transform_length(n);
            assert!(length >= n && (n <= 8 || 2 * length < 3 * n), "{n}: {length}");
            let odd = length >> length.trailing_zeros();
            assert!(odd == 1 || odd == 3);
        }
    }

    /// Sparse factors, whose digits are mostly 0, and lengths that differ by far.
    #[test]
    fn powers_of_two_and_unequal_lengths() {
        let mut tried = 0;
        for bits in [0usize, 1, 43, 44, 87, 88, 89, 703, 704, 64_000, 64_087] {
            let mut power = vec![0u64; bits / 64 + 1];
            power[bits / 64] = 1 << (bits % 64);
            for other in [vec![1u64], vec![u64::MAX; 700], power.clone(), random(2000, 7)] {
                let got = limbs::natural(&multiply(power.clone(), Some(&other)));
                assert_eq!(got, limbs::natural(&other) << bits, "2^{bits}");
                tried += 1;
            }
        }
        assert_eq!(tried, 44);
    }

    #[test]
    fn factors_too_long_for_one_transform_are_cut() {
        let (long, short) = (random(4000, 5), random(3500, 6));
        let wanted = limbs::natural(&NumBigint.product(&long, &short));
        for most in [700, 1000, 3499, 3500] {
            assert_eq!(limbs::natural(&in_parts(&short, &long, most)), wanted, "{most} limbs");
        }
    }

    #[test]
    fn primes_are_what_they_claim() {
        let mut product = num_bigint::BigUint::from(1u8);
        for (p, non_residue) in PRIMES {
            assert_eq!(p % (1 << 36), 1);
            assert!((p as f64) < 0.99 * 2f64.powi(50));
            assert!(cordon_core::scalar::Modulus::new(p).is_some());
            assert_eq!(power(non_residue, (p - 1) / 2, p), p - 1, "order of the roots");
            product *= p;
        }
        // A coefficient is a sum of as many products of digits as the shorter factor has.
        let digits = num_bigint::BigUint::from(LONGEST * 64 / DIGIT);
        assert!((digits << (2 * DIGIT)) < product);
    }

    /// With and without fused operations: the residue and the bounds, at the ends of the ranges.
    #[test]
    fn arithmetic_is_exact_within_the_bounds() {
        let mut tried = 0;
        for ((p, _), lane) in PRIMES.into_iter().zip(LANES) {
            let modulo = |x: i128| x.rem_euclid(i128::from(p));
            let mut factors: Vec<i64> = vec![0, 1, 2, 1 << 26, (1 << 49) - 1, 1 << 49];
            factors.extend([p / 2, p / 2 + 1, p - 1, p, p + 1, 4 * p, 8 * p - 1].map(|x| x as i64));
            factors.extend(random(60, p).iter().map(|&x| (x % (8 * p)) as i64));
            factors.extend(factors.clone().iter().map(|x| -x));
            for &a in &factors {
                for fused in [true, false] {
                    let r = lane.reduce(a as f64, fused);
                    assert_eq!(modulo(r as i128), modulo(a.into()), "{a} modulo {p}");
                    assert!(r.abs() <= lane.p / 2.0 + 1.0);
                }
                for &b in &factors {
                    let size = (a as f64) * (b as f64) / lane.p / lane.p;
                    if size.abs() > 4.0 {
                        continue;
                    }
                    for fused in [true, false] {
                        let r = lane.times(a as f64, b as f64, fused);
                        let wanted = modulo(i128::from(a) * i128::from(b));
                        assert_eq!(modulo(r as i128), wanted, "{a} * {b} modulo {p}");
                        assert!(r.abs() <= (0.5 + 0.38 * size.abs()) * lane.p + 1.0);
                        tried += 1;
                    }
                }
            }
        }
        assert!(tried > 50_000, "{tried} products");
    }

    /// A transform without the instructions that the processor may have.
    #[test]
    fn both_compilations_agree() {
        let mut rows = spread(&random(900, 3), BLOCK);
        let twiddles = Twiddles::new(BLOCK / 2, false);
        let mut wanted = rows.clone();
        forward(&mut wanted, 0, &twiddles);
        Levels { x: &mut rows, node: 0, twiddles: &twiddles, backward: false }.run(false);
        for (got, wanted) in rows.iter().zip(&wanted) {
            let difference = got.minus(*wanted).reduced(false);
            assert_eq!(difference.0, [0.0; 4]);
        }
    }
}
