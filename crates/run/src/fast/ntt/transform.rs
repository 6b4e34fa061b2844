//! Transforms of length 2^a, 3*2^a and 5*2^a, two levels of a product tree a pass.

use cordon_vector::{Task, widest};

use super::residue::{Row, Words, inverse, power};

/// The twiddle factors: that of node b is the square root of what node b reduces by,
/// `root^(bits of b reversed)`. That of the sum of two nodes without a bit in common is the
/// product of theirs.
pub(super) struct Twiddles {
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
    pub(super) fn new(count: usize, backward: bool) -> Self {
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
fn quarters(x: &mut [Words]) -> [&mut [Words]; 4] {
    let (low, high) = x.split_at_mut(x.len() / 2);
    let (a, b) = low.split_at_mut(low.len() / 2);
    let (c, d) = high.split_at_mut(high.len() / 2);
    [a, b, c, d]
}

/// Two levels forward. Residues up to 2.72 before and after.
#[inline(always)]
fn reduce_four(x: &mut [Words], [r, left, right]: [Row; 3], fused: bool) {
    let [a, b, c, d] = quarters(x);
    for (((a, b), c), d) in a.iter_mut().zip(b).zip(c).zip(d) {
        let (a0, b0) = (Row::load(a).reduced(fused), Row::load(b));
        let (c0, d0) = (Row::load(c).times(r, fused), Row::load(d).times(r, fused));
        let (low, low_odd) = (a0.plus(c0), b0.plus(d0).times(left, fused));
        let (high, high_odd) = (a0.minus(c0), b0.minus(d0).times(right, fused));
        low.plus(low_odd).store(a);
        low.minus(low_odd).store(b);
        high.plus(high_odd).store(c);
        high.minus(high_odd).store(d);
    }
}

/// Two levels backward. Residues up to 1.96 before and after.
#[inline(always)]
fn join_four(x: &mut [Words], [r, left, right]: [Row; 3], fused: bool) {
    let [a, b, c, d] = quarters(x);
    for (((a, b), c), d) in a.iter_mut().zip(b).zip(c).zip(d) {
        let (a0, b0, c0, d0) = (Row::load(a), Row::load(b), Row::load(c), Row::load(d));
        let (low, low_odd) = (a0.plus(b0), a0.minus(b0).times(left, fused));
        let (high, high_odd) = (c0.plus(d0), c0.minus(d0).times(right, fused));
        low.plus(high).reduced(fused).store(a);
        low_odd.plus(high_odd).reduced(fused).store(b);
        low.minus(high).times(r, fused).store(c);
        low_odd.minus(high_odd).times(r, fused).store(d);
    }
}

/// One level forward.
#[inline(always)]
fn reduce_two(x: &mut [Words], r: Row, fused: bool) {
    let (low, high) = x.split_at_mut(x.len() / 2);
    for (a, b) in low.iter_mut().zip(high) {
        let (a0, b0) = (Row::load(a).reduced(fused), Row::load(b).times(r, fused));
        a0.plus(b0).store(a);
        a0.minus(b0).store(b);
    }
}

/// One level backward.
#[inline(always)]
fn join_two(x: &mut [Words], r: Row, fused: bool) {
    let (low, high) = x.split_at_mut(x.len() / 2);
    for (a, b) in low.iter_mut().zip(high) {
        let (a0, b0) = (Row::load(a), Row::load(b));
        a0.plus(b0).reduced(fused).store(a);
        a0.minus(b0).times(r, fused).store(b);
    }
}

/// A part of a transform: two levels of the whole segment, or all levels of a block.
struct Levels<'a> {
    x: &'a mut [Words],
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
fn forward(x: &mut [Words], node: usize, twiddles: &Twiddles) {
    widest(Levels { x, node, twiddles, backward: false });
    if x.len() > BLOCK {
        for (i, quarter) in quarters(x).into_iter().enumerate() {
            forward(quarter, 4 * node + i, twiddles);
        }
    }
}

/// The polynomial from its values, times the number of leaves.
fn backward(x: &mut [Words], node: usize, twiddles: &Twiddles) {
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
    x: &'a mut [Words],
    /// A square root i of -1: the inverse of the forward one if `backward`.
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
            let (a0, b0, c0) = (Row::load(a), Row::load(b), Row::load(c));
            let turned = b0.times(self.quarter_turn, fused);
            if !self.backward {
                // Modulo z^2q - 1: (a + c) + b z^q. Modulo z^q - i: a - c + i b.
                a0.plus(c0).store(a);
                a0.minus(c0).plus(turned).store(c);
            } else {
                // With a = 2q(a' + c'), b = 2q b', c = q(a' - c' + i b'): 4q a', 4q b', 4q c'.
                let difference = c0.plus(c0).plus(turned);
                a0.plus(difference).store(a);
                b0.plus(b0).store(b);
                a0.minus(difference).store(c);
            }
        }
    }
}

/// The same for 5*2^a: the tree of length 2^(a+3) without its last three eighths.
struct Five<'a> {
    x: &'a mut [Words],
    /// A square root w of i, i, and w^3: the inverse of the forward ones if `backward`.
    turns: [Row; 3],
    backward: bool,
}

impl Task for Five<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        let fifth = self.x.len() / 5;
        let (four, e) = self.x.split_at_mut(4 * fifth);
        let [a, b, c, d] = quarters(four);
        let [eighth, quarter, three_eighths] = self.turns;
        for ((((a, b), c), d), e) in a.iter_mut().zip(b).zip(c).zip(d).zip(e) {
            let (a0, b0, c0) = (Row::load(a), Row::load(b), Row::load(c));
            let (d0, e0) = (Row::load(d), Row::load(e));
            let turned = c0.times(quarter, fused);
            if !self.backward {
                // Modulo z^4q - 1: a + e in the place of a. Modulo z^q - w: a - e + w b + i c + w^3 d.
                let turned =
                    turned.plus(b0.times(eighth, fused)).plus(d0.times(three_eighths, fused));
                a0.plus(e0).store(a);
                a0.minus(e0).plus(turned).reduced(fused).store(e);
            } else {
                // With 4q times a' + e', b', c' and d', and e = q(a' - e' + w b' + i c' + w^3 d'):
                // 8q times each. As w^4 = -1, -w is the inverse of w^3.
                let turned =
                    turned.plus(b0.times(three_eighths, fused)).plus(d0.times(eighth, fused));
                let e0 = e0.reduced(fused);
                let twice = e0.plus(e0);
                let difference = twice.plus(twice).plus(turned);
                a0.plus(difference).store(a);
                b0.plus(b0).store(b);
                c0.plus(c0).store(c);
                d0.plus(d0).store(d);
                a0.minus(difference).store(e);
            }
        }
    }
}

/// The shortest transform length of at least n: 2^a, 3*2^a or 5*2^a.
pub(super) fn transform_length(n: usize) -> usize {
    let power = n.next_power_of_two().max(64);
    [power / 8 * 5, power / 4 * 3].into_iter().find(|length| n <= *length).unwrap_or(power)
}

/// Both directions of a transform of one length.
pub(super) fn transform(x: &mut [Words], twiddles: &Twiddles, back: bool) {
    let parts = x.len() >> x.len().trailing_zeros();
    if parts == 1 {
        return if back { backward(x, 0, twiddles) } else { forward(x, 0, twiddles) };
    }
    if !back {
        divide(x, parts, twiddles, back);
    }
    let (front, single) = x.split_at_mut(x.len() / parts * (parts - 1));
    let pass = if back { backward } else { forward };
    pass(front, 0, twiddles);
    pass(single, parts - 1, twiddles);
    if back {
        divide(x, parts, twiddles, back);
    }
}

/// The pass over a whole of three or five parts.
fn divide(x: &mut [Words], parts: usize, twiddles: &Twiddles, backward: bool) {
    let [quarter_turn, eighth] = [twiddles.low[1], twiddles.low[2]];
    if parts == 3 {
        widest(Three { x, quarter_turn, backward });
    } else {
        let three_eighths = eighth.times(quarter_turn, false).reduced(false);
        widest(Five { x, turns: [eighth, quarter_turn, three_eighths], backward });
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::random;
    use super::*;

    #[test]
    fn transform_lengths_waste_little() {
        for n in 1..5000 {
            let length = transform_length(n);
            assert!(length >= n && (n <= 32 || 3 * length < 4 * n), "{n}: {length}");
            assert!([1, 3, 5].contains(&(length >> length.trailing_zeros())));
        }
    }

    /// A transform without the instructions that the processor may have.
    #[test]
    fn both_compilations_agree() {
        let mut rows = vec![Words::default(); BLOCK];
        let limbs = random(BLOCK, 3);
        for (row, limb) in rows.iter_mut().zip(limbs) {
            Row([(limb >> 16) as f64; 4]).reduced(false).store(row);
        }
        let twiddles = Twiddles::new(BLOCK / 2, false);
        let mut wanted = rows.clone();
        forward(&mut wanted, 0, &twiddles);
        Levels { x: &mut rows, node: 0, twiddles: &twiddles, backward: false }.run(false);
        for (got, wanted) in rows.iter().zip(&wanted) {
            let difference = Row::load(got).minus(Row::load(wanted)).reduced(false);
            assert_eq!(difference.0, [0.0; 4]);
        }
    }
}
