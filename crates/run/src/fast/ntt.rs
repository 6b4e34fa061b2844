//! Long multiplication by number-theoretic transforms: the default backend.
//!
//! The limbs of both factors are the coefficients of two polynomials; their product is found
//! modulo three primes of 62 bits, by transforms of length 2^a or 3*2^a in each prime field,
//! and put together by the Chinese remainder theorem. Portable Rust without `unsafe`, in time
//! n log n: `benches/peers` measures it against the libraries. Short factors go to
//! `num-bigint`.
//!
//! The transform is the one of a product tree: a node reduces a polynomial modulo `z^2h - r^2`
//! to its remainders modulo `z^h - r` and `z^h + r`, in place. The twiddle factors r in
//! bit-reversed order are the same table at every depth. Butterflies are lazy (D. Harvey,
//! "Faster arithmetic for number-theoretic transforms"): residues stay below 4p < 2^64.

use super::limbs;
use super::multiply::{Multiply, NumBigint};

/// Number-theoretic transforms over three primes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ntt;

/// Factors shorter than this many limbs go to `num-bigint`, which is faster there.
const SHORTEST: usize = 1000;

/// Most limbs of a product: the transforms' roots of unity have order 2^40.
const LONGEST: usize = 1 << 38;

impl Multiply for Ntt {
    fn name(&self) -> &'static str {
        "ntt"
    }

    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
        let (a, b) = (limbs::trimmed(a), limbs::trimmed(b));
        if a.len().min(b.len()) < SHORTEST || a.len() + b.len() > LONGEST {
            return NumBigint.product(a, b);
        }
        multiply(a.to_vec(), Some(b))
    }

    fn square(&self, mut a: Vec<u64>) -> Vec<u64> {
        a.truncate(limbs::trimmed(&a).len());
        if a.len() < SHORTEST || 2 * a.len() > LONGEST {
            return NumBigint.square(a);
        }
        multiply(a, None)
    }
}

/// A prime p = 1 modulo 2^40, a little below 2^62, and a quadratic non-residue.
#[derive(Clone, Copy)]
struct Field {
    p: u64,
    non_residue: u64,
    /// `-1/p` modulo 2^64.
    minus_inverse: u64,
    /// `2^125/p`, rounded down.
    reciprocal: u64,
}

const FIELDS: [Field; 3] = [
    Field::new(0x3fff_c000_0000_0001, 7),
    Field::new(0x3fff_be00_0000_0001, 3),
    Field::new(0x3fff_8400_0000_0001, 11),
];

/// A factor and `2^64/p` times it, rounded down: what makes a product cheap (V. Shoup).
#[derive(Clone, Copy)]
struct Factor {
    value: u64,
    quotient: u64,
}

/// The high limb of a product.
fn high(a: u64, b: u64) -> u64 {
    ((u128::from(a) * u128::from(b)) >> 64) as u64
}

impl Field {
    const fn new(p: u64, non_residue: u64) -> Self {
        // Newton's iteration doubles the bits of an inverse; p is its own inverse modulo 8.
        let mut inverse = p;
        let mut round = 0;
        while round < 5 {
            inverse = inverse.wrapping_mul(2u64.wrapping_sub(p.wrapping_mul(inverse)));
            round += 1;
        }
        let reciprocal = ((1u128 << 125) / p as u128) as u64;
        Self { p, non_residue, minus_inverse: inverse.wrapping_neg(), reciprocal }
    }

    /// `a*b` modulo p, below p.
    fn times(self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.p)) as u64
    }

    fn power(self, mut base: u64, mut exponent: u64) -> u64 {
        let mut result = 1;
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.times(result, base);
            }
            base = self.times(base, base);
            exponent >>= 1;
        }
        result
    }

    fn inverse(self, x: u64) -> u64 {
        self.power(x, self.p - 2)
    }

    /// A root of unity of order 2^bits.
    fn root(self, bits: u32) -> u64 {
        self.power(self.non_residue, (self.p - 1) >> bits)
    }

    /// Prepares a factor below p.
    fn factor(self, value: u64) -> Factor {
        // Too small by 3 at most, which the remainder shows.
        let mut quotient = ((u128::from(value) * u128::from(self.reciprocal)) >> 61) as u64;
        let mut rest = quotient.wrapping_mul(self.p).wrapping_neg();
        while rest >= self.p {
            rest -= self.p;
            quotient += 1;
        }
        Factor { value, quotient }
    }

    /// `f*x` modulo p, below 2p, for any limb x.
    fn scale(self, x: u64, f: Factor) -> u64 {
        f.value.wrapping_mul(x).wrapping_sub(high(f.quotient, x).wrapping_mul(self.p))
    }

    /// `x` below 4p brought below 2p.
    fn below_2p(self, x: u64) -> u64 {
        x.min(x.wrapping_sub(2 * self.p))
    }

    /// `x` below 2p brought below p.
    fn below_p(self, x: u64) -> u64 {
        x.min(x.wrapping_sub(self.p))
    }

    /// Any limb brought below 2p.
    fn reduce(self, limb: u64) -> u64 {
        // The top two bits count 2^62 = p + d with d below 2^60.
        limb - (limb >> 62) * self.p
    }

    /// `a*b/2^64` modulo p, below 2p, for a and b below 2p (P. Montgomery).
    fn montgomery(self, a: u64, b: u64) -> u64 {
        let product = u128::from(a) * u128::from(b);
        let m = (product as u64).wrapping_mul(self.minus_inverse);
        ((product + u128::from(m) * u128::from(self.p)) >> 64) as u64
    }

    /// The twiddle factors of nodes 0 .. count of every depth: entry b is the square root of
    /// what node b reduces by, `root^(bits of b reversed)`; of the inverse roots if `inverse`.
    fn twiddles(self, count: usize, inverse: bool) -> Vec<Factor> {
        let mut table = Vec::with_capacity(count);
        table.push(self.factor(1));
        let mut depth = 2;
        while table.len() < count {
            let root = self.root(depth);
            let root = self.factor(if inverse { self.inverse(root) } else { root });
            for b in 0..table.len().min(count - table.len()) {
                let next = self.below_p(self.scale(table[b].value, root));
                table.push(self.factor(next));
            }
            depth += 1;
        }
        table
    }
}

/// The shortest transform length of at least n: 2^a or 3*2^a.
fn transform_length(n: usize) -> usize {
    let power = n.next_power_of_two();
    if n <= power / 4 * 3 && power >= 16 { power / 4 * 3 } else { power.max(4) }
}

/// Segments of so many residues fit the fastest memory and are done depth by depth.
const BLOCK: usize = 1 << 12;

struct Transform {
    field: Field,
    length: usize,
    /// The length is 3*2^a: the tree of length 2^(a+2) without its last quarter.
    three: bool,
}

impl Transform {
    fn new(field: Field, length: usize) -> Self {
        Self { field, length, three: !length.is_power_of_two() }
    }

    /// How many twiddle factors are kept: those of every depth but the last, which has as many
    /// again; and what the first pass of a length of 3*2^a needs.
    fn nodes(&self) -> usize {
        (self.length.next_power_of_two() / 4).max(2)
    }

    /// What the twiddle factor of a node beyond those kept is more than that of the node as
    /// many before it as are kept.
    fn beyond(&self, inverse: bool) -> Factor {
        let f = self.field;
        let root = f.root(self.nodes().trailing_zeros() + 2);
        f.factor(if inverse { f.inverse(root) } else { root })
    }

    /// The values of a polynomial at the leaves; residues below 4p before and after.
    fn forward(&self, x: &mut [u64], table: &[Factor]) {
        let turn = self.beyond(false);
        if !self.three {
            return self.forward_node(x, 0, table, turn);
        }
        let f = self.field;
        let quarter = self.length / 3;
        let (low, rest) = x.split_at_mut(quarter);
        let (middle, top) = rest.split_at_mut(quarter);
        for ((a, b), c) in low.iter_mut().zip(middle.iter()).zip(top.iter_mut()) {
            // Modulo z^2q - 1: (a + c) + b z^q. Modulo z^q - i: a - c + i b.
            let (x, y) = (f.below_2p(*a), f.below_2p(*c));
            let turned = f.scale(*b, table[1]);
            *a = x + y;
            *c = f.below_2p(x + 2 * f.p - y) + turned;
        }
        let (pair, single) = x.split_at_mut(2 * quarter);
        self.forward_node(pair, 0, table, turn);
        self.forward_node(single, 2, table, turn);
    }

    fn forward_node(&self, x: &mut [u64], node: usize, table: &[Factor], turn: Factor) {
        if x.len() > BLOCK {
            let (low, high) = x.split_at_mut(x.len() / 2);
            self.reduce_pair(low, high, table[node]);
            self.forward_node(low, 2 * node, table, turn);
            self.forward_node(high, 2 * node + 1, table, turn);
            return;
        }
        let (mut size, mut first) = (x.len(), node);
        while size > 1 {
            let (kept, beyond) = kept(x, size, first, table.len());
            for (segment, &r) in kept.chunks_exact_mut(size).zip(from(table, first)) {
                let (low, high) = segment.split_at_mut(size / 2);
                self.reduce_pair(low, high, r);
            }
            let before = from(table, first.saturating_sub(table.len()));
            for (pair, &r) in beyond.chunks_exact_mut(2).zip(before) {
                let (low, high) = pair.split_at_mut(1);
                high[0] = self.field.scale(high[0], turn);
                self.reduce_pair(low, high, r);
            }
            (size, first) = (size / 2, first * 2);
        }
    }

    /// (u, v) -> (u + r v, u - r v).
    fn reduce_pair(&self, low: &mut [u64], high: &mut [u64], r: Factor) {
        let f = self.field;
        for (u, v) in low.iter_mut().zip(high) {
            let (x, y) = (f.below_2p(*u), f.scale(*v, r));
            *u = x + y;
            *v = x + 2 * f.p - y;
        }
    }

    /// The polynomial from its values, times the length of the whole tree (3*2^a: 2^(a+2)).
    /// Residues below 2p before and after.
    fn backward(&self, x: &mut [u64], table: &[Factor]) {
        let turn = self.beyond(true);
        if !self.three {
            return self.backward_node(x, 0, table, turn);
        }
        let f = self.field;
        let quarter = self.length / 3;
        let (pair, single) = x.split_at_mut(2 * quarter);
        self.backward_node(pair, 0, table, turn);
        self.backward_node(single, 2, table, turn);
        let (low, middle) = pair.split_at_mut(quarter);
        let quarter_turn = f.factor(self.field.root(2));
        for ((a, b), c) in low.iter_mut().zip(middle).zip(single) {
            // With a = 2q(a' + c'), b = 2q b', c = q(a' - c' + i b'): 4q a', 4q b', 4q c'.
            let turned = f.below_2p(f.scale(*b, quarter_turn));
            let difference = f.below_2p(f.below_2p(2 * *c) + 2 * f.p - turned);
            let sum = *a;
            *a = f.below_2p(sum + difference);
            *c = f.below_2p(sum + 2 * f.p - difference);
            *b = f.below_2p(2 * *b);
        }
    }

    fn backward_node(&self, x: &mut [u64], node: usize, table: &[Factor], turn: Factor) {
        if x.len() > BLOCK {
            let (low, high) = x.split_at_mut(x.len() / 2);
            self.backward_node(low, 2 * node, table, turn);
            self.backward_node(high, 2 * node + 1, table, turn);
            self.join_pair(low, high, table[node]);
            return;
        }
        let mut size = 2;
        while size <= x.len() {
            let first = node * (x.len() / size);
            let (kept, beyond) = kept(x, size, first, table.len());
            for (segment, &r) in kept.chunks_exact_mut(size).zip(from(table, first)) {
                let (low, high) = segment.split_at_mut(size / 2);
                self.join_pair(low, high, r);
            }
            let before = from(table, first.saturating_sub(table.len()));
            for (pair, &r) in beyond.chunks_exact_mut(2).zip(before) {
                let (low, high) = pair.split_at_mut(1);
                self.join_pair(low, high, r);
                high[0] = self.field.scale(high[0], turn);
            }
            size *= 2;
        }
    }

    /// (u, v) -> (u + v, (u - v)/r), given 1/r.
    fn join_pair(&self, low: &mut [u64], high: &mut [u64], inverse: Factor) {
        let f = self.field;
        for (u, v) in low.iter_mut().zip(high) {
            let (x, y) = (*u, *v);
            *u = f.below_2p(x + y);
            *v = f.scale(x + 2 * f.p - y, inverse);
        }
    }
}

/// Segments of `size` whose nodes, from `first` on, are among those kept, and those beyond.
fn kept(x: &mut [u64], size: usize, first: usize, kept: usize) -> (&mut [u64], &mut [u64]) {
    let nodes = (x.len() / size).min(kept.saturating_sub(first));
    x.split_at_mut(nodes * size)
}

fn from(table: &[Factor], first: usize) -> &[Factor] {
    table.get(first..).unwrap_or_default()
}

/// The limbs as residues below 2p, followed by zeros.
fn spread(field: Field, length: usize, from: &[u64]) -> Vec<u64> {
    let mut x = Vec::with_capacity(length);
    x.extend(from.iter().map(|&limb| field.reduce(limb)));
    x.resize(length, 0);
    x
}

/// The coefficients of the product modulo one prime, below p, from its factors [`spread`]; the
/// square of x where y is `None`.
fn residues(field: Field, mut x: Vec<u64>, y: Option<Vec<u64>>) -> Vec<u64> {
    let length = x.len();
    let transform = Transform::new(field, length);
    let table = field.twiddles(transform.nodes(), false);
    transform.forward(&mut x, &table);
    match y {
        None => {
            for v in &mut x {
                let w = field.below_2p(*v);
                *v = field.montgomery(w, w);
            }
        }
        Some(mut y) => {
            transform.forward(&mut y, &table);
            for (v, w) in x.iter_mut().zip(y) {
                *v = field.montgomery(field.below_2p(*v), field.below_2p(w));
            }
        }
    }
    drop(table);
    transform.backward(&mut x, &field.twiddles(transform.nodes(), true));
    // The transform multiplied by its tree's length, the products divided by 2^64.
    let length = field.times(length.next_power_of_two() as u64, 1);
    let two_64 = field.power(2, 64);
    let scale = field.factor(field.times(field.inverse(length), two_64));
    for v in &mut x {
        *v = field.below_p(field.scale(*v, scale));
    }
    x
}

/// `a*b`, or `a*a` where `b` is `None`; both nonempty.
fn multiply(a: Vec<u64>, b: Option<&[u64]>) -> Vec<u64> {
    let limbs = a.len() + b.map_or(a.len(), <[u64]>::len);
    let length = transform_length(limbs);
    let one = |f: Field, x: Vec<u64>| {
        let mut x = residues(f, x, b.map(|b| spread(f, length, b)));
        // The rest is 0, and its memory is wanted.
        x.truncate(limbs);
        x.shrink_to_fit();
        x
    };
    let mut first = one(FIELDS[0], spread(FIELDS[0], length, &a));
    let second = one(FIELDS[1], spread(FIELDS[1], length, &a));
    // The factor is not needed any more: at the peak there are two sets of residues, and a
    // transform with its table of the same size.
    let last = spread(FIELDS[2], length, &a);
    drop(a);
    let third = one(FIELDS[2], last);
    let [f1, f2, f3] = FIELDS;
    // Garner: coefficient = x1 + p1*(x2 + p2*x3), each digit from the remainders so far.
    let (over_p1, over_p1_p2) = (
        f2.factor(f2.inverse(f1.p % f2.p)),
        f3.factor(f3.inverse(f3.times(f1.p % f3.p, f2.p % f3.p))),
    );
    let p1_in_3 = f3.factor(f1.p - f3.p);
    let p1_p2 = u128::from(f1.p) * u128::from(f2.p);
    // The sum of the coefficients so far that lies above the limb to write: below 2^128.
    let mut carry = 0u128;
    for ((r1, r2), r3) in first.iter_mut().zip(second).zip(third) {
        let x1 = *r1;
        // x1 is below p1, which is below 2 p2 and below 2 p3.
        let x2 = f2.below_p(f2.scale(r2 + 2 * f2.p - x1, over_p1));
        let known = f3.below_2p(x1 + f3.below_p(f3.scale(x2, p1_in_3)));
        let x3 = f3.below_p(f3.scale(r3 + 2 * f3.p - known, over_p1_p2));
        // Below p1 p2 < 2^124, then below 2^186 in three limbs.
        let low = u128::from(x1) + u128::from(f1.p) * u128::from(x2);
        let low_part = u128::from(p1_p2 as u64) * u128::from(x3);
        let high_part = (p1_p2 >> 64) * u128::from(x3);
        let (sum, over_a) = low.overflowing_add(low_part);
        let (sum, over_b) = sum.overflowing_add(carry);
        let overs = u128::from(over_a) + u128::from(over_b);
        *r1 = sum as u64;
        carry = (sum >> 64) + high_part + (overs << 64);
    }
    first
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
                lengths.insert(transform_length(x.len() + y.len()));
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
        assert!(lengths.iter().any(|l| l.is_power_of_two() && *l > 2 * BLOCK));
        assert!(lengths.iter().any(|l| !l.is_power_of_two() && *l > 2 * BLOCK));
    }

    #[test]
    fn transform_lengths_waste_little() {
        for n in 1..5000 {
            let length = transform_length(n);
            assert!(length >= n && (n < 8 || 2 * length < 3 * n), "{n}: {length}");
            let odd = length >> length.trailing_zeros();
            assert!(odd == 1 || odd == 3);
        }
    }

    #[test]
    fn fields_are_what_they_claim() {
        for f in FIELDS {
            assert_eq!(f.p % (1 << 40), 1);
            assert!(f.p > 61 << 56 && f.p < 1 << 62);
            assert!(cordon_core::scalar::Modulus::new(f.p).is_some());
            assert_eq!(f.power(f.root(40), 1 << 39), f.p - 1, "order of the root");
            for value in [0, 1, f.p / 2, f.p - 1] {
                let wanted = ((u128::from(value) << 64) / u128::from(f.p)) as u64;
                assert_eq!(f.factor(value).quotient, wanted);
            }
        }
    }
}
