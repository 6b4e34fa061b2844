//! Long multiplication by number-theoretic transforms: the default backend.
//!
//! Both factors are cut into digits of 88 bits, the coefficients of two polynomials; their
//! product is found modulo four primes below 2^50 at once, by transforms of length 2^a, 3*2^a
//! or 5*2^a,
//! and put together by the Chinese remainder theorem. Portable Rust (the one `unsafe`
//! call, to the copy for wide vectors, is `cordon-vector`'s), in time n log n: `benches/peers` measures
//! it against the libraries. Short factors go to
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

mod digits;
mod residue;
mod transform;

use cordon_vector::{Task, widest};

use digits::{DIGIT, GROUP_LIMBS, ROW, gather, spread};
use residue::{Row, Words, inverse};
use transform::{Twiddles, transform, transform_length};

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

    fn room(&self, limbs: usize) -> usize {
        match limbs {
            SHORTEST..=LONGEST => words(1, length_for(2 * limbs)),
            _ => limbs,
        }
    }
}

/// The products of values, times `scale`. Up to 1.6, from factors up to 2.72.
struct Pointwise<'a> {
    x: &'a mut [Words],
    y: Option<&'a [Words]>,
    scale: Row,
}

impl Task for Pointwise<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, fused: bool) {
        match self.y {
            None => {
                for words in self.x {
                    let x = Row::load(words);
                    x.times(self.scale, fused).times(x, fused).store(words);
                }
            }
            Some(y) => {
                for (words, y) in self.x.iter_mut().zip(y) {
                    let x = Row::load(words).times(self.scale, fused);
                    x.times(Row::load(y), fused).store(words);
                }
            }
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

/// Transforms of as many words have their memory cut to the length of the result. Of shorter ones
/// the result is copied: memory that is given back whole is there for the next product, without
/// asking the system. Squares come in rows, each twice as long as the one before, for which its
/// memory would be too short.
const CUT: usize = 1 << 21;
const CUT_SQUARE: usize = 1 << 17;

/// The length of the transforms for a product of so many limbs.
fn length_for(limbs: usize) -> usize {
    transform_length((limbs * 64).div_ceil(DIGIT))
}

/// The words of the transforms of so many factors, with those skipped before the first row.
fn words(factors: usize, length: usize) -> usize {
    factors * length * ROW + (ROW - 1)
}

/// `a*b`, or `a*a` where `b` is `None`; both nonempty. All in the memory of `a`, made longer.
fn multiply(a: Vec<u64>, b: Option<&[u64]>) -> Vec<u64> {
    let (limbs, mut buffer) = (a.len() + b.map_or(a.len(), <[u64]>::len), a);
    let length = length_for(limbs);
    let leaves = length.next_power_of_two();
    let (used, rows) = (buffer.len(), length * ROW);
    let factors = if b.is_some() { 2 } else { 1 };
    buffer.resize(words(factors, length), 0);
    // Rows do not cross the lines of caches.
    let skip = buffer.as_ptr().align_offset(size_of::<Words>()) % ROW;
    let (first, second) = buffer.split_at_mut(skip + rows);
    let twiddles = Twiddles::new(leaves / 2, false);
    spread(first, used, skip);
    let (x, _) = first[skip..].as_chunks_mut();
    transform(x, &twiddles, false);
    let y = b.map(|b| {
        second[..b.len()].copy_from_slice(b);
        spread(&mut second[..rows], b.len(), 0);
        let (y, _) = second[..rows].as_chunks_mut();
        transform(y, &twiddles, false);
        &*y
    });
    let scale = Row::of(|p, _| inverse(leaves as u64, p));
    widest(Pointwise { x, y, scale });
    transform(x, &Twiddles::new(leaves / 2, true), true);
    gather(first, limbs, skip);
    if rows < if factors == 1 { CUT_SQUARE } else { CUT } {
        return buffer[..limbs].to_vec();
    }
    buffer.truncate(limbs);
    buffer.shrink_to_fit();
    buffer
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn random(length: usize, mut state: u64) -> Vec<u64> {
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
        for n in [
            1usize, 2, 3, 5, 8, 12, 13, 100, 383, 384, 385, 1000, 3000, 3100, 3500, 6144, 8000,
            9000,
        ] {
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
        for parts in [1, 3, 5] {
            assert!(lengths.iter().any(|l| l >> l.trailing_zeros() == parts && *l > 1 << 12));
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
}
