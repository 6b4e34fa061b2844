//! The state of an own protocol after k steps without the steps between.
//!
//! By Cayley and Hamilton the k-th power of a matrix A is what remains of `t^k` after division by
//! its characteristic polynomial: a combination of the first powers. So one polynomial with long
//! coefficients is squared again and again, each time as one long multiplication (Kronecker), and
//! no long matrix. The characteristic polynomial is found modulo primes (Hessenberg's form).

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::answer::Answer;
use super::course::{Course, Matrix, Run};
use super::growth::{limbs_for, log2_above, longest};
use super::limbs;
use super::multiply::Multiply;
use super::{cost, power};
use cordon_core::scalar::Modulus;

/// The state after `k` steps; `None` where the choices of the steps are drawn.
pub fn after(course: &Course, k: u64, by: &dyn Multiply) -> Option<Answer> {
    let cycle = course.cycle()?;
    let round = whole_round(cycle);
    let length = cycle.len() as u64;
    let rounds = k / length.max(1);
    let mut landed = course.clone();
    if rounds > 0 {
        landed.start = applied(&round, &course.start, rounds, by);
        if let Some(last) = landed.start.last_mut() {
            *last = power::natural(course.den.magnitude(), rounds * length, by).into();
        }
    }
    let mut run = Run::onward(landed, rounds * length, k);
    Some(run.advance_to(k).answer())
}

/// The matrices one after the other, the first first.
fn whole_round(cycle: &[Matrix]) -> Matrix {
    let after = |first: Matrix, then: &Matrix| -> Matrix {
        let row = |row: &Vec<(usize, BigInt)>| {
            let mut sums = vec![BigInt::zero(); first.len()];
            for (j, a) in row {
                for (i, b) in first.get(*j).into_iter().flatten() {
                    if let Some(sum) = sums.get_mut(*i) {
                        *sum += a * b;
                    }
                }
            }
            sums.into_iter().enumerate().filter(|(_, a)| !a.is_zero()).collect()
        };
        then.iter().map(row).collect()
    };
    let mut matrices = cycle.iter();
    let first = matrices.next().cloned().unwrap_or_default();
    matrices.fold(first, after)
}

/// The `k`-th power of the matrix, applied to a vector, but for its last number where no other
/// depends on it.
fn applied(a: &Matrix, x: &[BigInt], k: u64, by: &dyn Multiply) -> Vec<BigInt> {
    let last = a.len().saturating_sub(1);
    let constants = a.iter().take(last).flatten().any(|(j, _)| *j == last);
    let size = if constants { a.len() } else { last };
    let combination = remainder(&characteristic(a.get(..size).unwrap_or_default()), k, by);
    let mut moved = x.to_vec();
    let mut sums = vec![BigInt::zero(); x.len()];
    for coefficient in &combination {
        for (sum, v) in sums.iter_mut().zip(&moved).take(size) {
            *sum += coefficient * v;
        }
        moved = times(a, &moved);
    }
    sums
}

fn times(a: &Matrix, x: &[BigInt]) -> Vec<BigInt> {
    let row = |row: &Vec<(usize, BigInt)>| {
        row.iter().filter_map(|(j, a)| Some(a * x.get(*j)?)).sum::<BigInt>()
    };
    a.iter().map(row).collect()
}

/// `t^k` modulo a polynomial with leading coefficient 1, of which the other coefficients are given,
/// lowest first.
fn remainder(c: &[BigInt], k: u64, by: &dyn Multiply) -> Vec<BigInt> {
    let mut r = vec![BigInt::zero(); c.len()];
    if let Some(constant) = r.first_mut() {
        constant.set_one();
    }
    for bit in (0..u64::BITS - k.leading_zeros()).rev() {
        r = reduced(square(&r, by), c);
        if k >> bit & 1 == 1 {
            r.insert(0, BigInt::zero());
            r = reduced(r, c);
        }
    }
    r
}

/// The remainder of a polynomial, whose leading coefficients are used up from the highest on.
fn reduced(mut r: Vec<BigInt>, c: &[BigInt]) -> Vec<BigInt> {
    while r.len() > c.len() {
        let Some(top) = r.pop().filter(|top| !top.is_zero()) else { continue };
        let from = r.len() - c.len();
        for (x, c) in r.iter_mut().skip(from).zip(c).filter(|(_, c)| !c.is_zero()) {
            *x -= &top * c;
        }
    }
    r
}

/// The square of a polynomial, packed into one number with room for every coefficient.
fn square(r: &[BigInt], by: &dyn Multiply) -> Vec<BigInt> {
    let slot = slot(r.len(), longest(r));
    let [mut plus, mut minus] = [true, false].map(|positive| {
        let mut packed = vec![0; r.len() * slot];
        for (place, x) in packed.chunks_exact_mut(slot).zip(r) {
            if x.is_positive() == positive {
                place.iter_mut().zip(x.magnitude().iter_u64_digits()).for_each(|(d, l)| *d = l);
            }
        }
        packed
    });
    if limbs::less(&plus, &minus) {
        std::mem::swap(&mut plus, &mut minus);
    }
    limbs::sub(&mut plus, &minus, false);
    let mut squared = by.square(limbs::trimmed(&plus).to_vec());
    let length = (2 * r.len()).saturating_sub(1);
    squared.resize(length * slot, 0);
    let mut borrowed = false;
    let mut coefficient = |digits: &mut [u64]| {
        // What is borrowed from a 0 is borrowed on.
        let over = borrowed && limbs::add(digits, &[1], false);
        borrowed = over || limbs::is_negative(digits);
        limbs::integer(digits)
    };
    squared.chunks_exact_mut(slot).map(&mut coefficient).collect()
}

/// Limbs that hold any coefficient of the square of such a polynomial, with its sign.
fn slot(length: usize, bits: u64) -> usize {
    limbs_for(2 * bits + u64::from(usize::BITS - length.leading_zeros()) + 2)
}

/// What a jump to step `k` costs, in the units of the cost model; infinite where none is possible.
pub fn jumping(course: &Course, k: u64) -> f64 {
    let Some(cycle) = course.cycle() else { return f64::INFINITY };
    let size = course.start.len();
    let (n, rounds) = (size as f64, k as f64 / cycle.len().max(1) as f64);
    // The coefficients are about as long as the numbers of the state.
    let bits = course.log2_growth() * k as f64;
    let words = bits / 64.0 + 1.0;
    let short = 1.0 + course.log2_growth() * cycle.len() as f64 * n / 64.0;
    let packed = (size as f64 * (words + 1.0)).to_usize().unwrap_or(usize::MAX);
    // Squares of half the length each time, reduced; and the combination.
    let squares = 2.0 * cost::square(packed) + rounds.log2().max(1.0) * 600.0 * n;
    let passes = 6.0 * n * n * words * short;
    let primes = bound_bits(cycle.len(), course.log2_growth(), size) / 60.0 + 1.0;
    squares + passes + primes * 60.0 * n * n * n
}

fn bound_bits(length: usize, log2_growth: f64, size: usize) -> f64 {
    (log2_growth * length as f64 + 1.0) * size as f64
}

/// The characteristic polynomial of the matrix of the first columns of these rows, lowest
/// coefficient first, without the leading 1.
fn characteristic(rows: &[Vec<(usize, BigInt)>]) -> Vec<BigInt> {
    let size = rows.len();
    // A coefficient is a sum of minors: all together are below the product of the rows' sums.
    let sum = |row: &Vec<(usize, BigInt)>| row.iter().map(|(_, a)| a.abs()).sum::<BigInt>() + 1u8;
    let bound: f64 = rows.iter().map(|row| log2_above(&sum(row))).sum();
    let enough = BigInt::one() << (bound.to_u64().unwrap_or(u64::MAX).saturating_add(3));
    let (mut found, mut modulus) = (vec![BigInt::zero(); size], BigInt::one());
    let mut candidate = (1u64 << 61) + 1;
    while modulus < enough {
        candidate -= 2;
        if Modulus::new(candidate).is_none() {
            continue;
        }
        let p = BigInt::from(candidate);
        let mut dense = vec![vec![0; size]; size];
        for (into, row) in dense.iter_mut().zip(rows) {
            for (j, a) in row {
                if let Some(place) = into.get_mut(*j) {
                    *place = residue(a, candidate);
                }
            }
        }
        let lift = inverse(residue(&modulus, candidate), candidate);
        for (x, image) in found.iter_mut().zip(characteristic_modulo(dense, candidate)) {
            let behind =
                multiply(subtract(image, residue(x, candidate), candidate), lift, candidate);
            *x += &modulus * behind;
        }
        modulus *= p;
    }
    let half = &modulus >> 1u8;
    found.into_iter().map(|x| if x > half { x - &modulus } else { x }).collect()
}

fn residue(a: &BigInt, p: u64) -> u64 {
    a.mod_floor(&p.into()).to_u64().unwrap_or(0)
}

fn multiply(a: u64, b: u64, p: u64) -> u64 {
    // A remainder of p fits.
    (u128::from(a) * u128::from(b) % u128::from(p)) as u64
}

fn subtract(a: u64, b: u64, p: u64) -> u64 {
    if a >= b { a - b } else { a + (p - b) }
}

/// Fermat: the inverse of what is not 0.
fn inverse(a: u64, p: u64) -> u64 {
    let (mut square, mut result, mut exponent) = (a, 1, p - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = multiply(result, square, p);
        }
        square = multiply(square, square, p);
        exponent >>= 1;
    }
    result
}

/// By Hessenberg's form: similar transformations that leave nothing below the first subdiagonal,
/// then the polynomials of its leading blocks one after the other.
fn characteristic_modulo(mut h: Vec<Vec<u64>>, p: u64) -> Vec<u64> {
    let size = h.len();
    for k in 1..size {
        let Some(pivot) = (k..size).find(|&i| h[i][k - 1] != 0) else { continue };
        h.swap(pivot, k);
        h.iter_mut().for_each(|row| row.swap(pivot, k));
        let scale = inverse(h[k][k - 1], p);
        for i in k + 1..size {
            let factor = multiply(h[i][k - 1], scale, p);
            if factor == 0 {
                continue;
            }
            let (upper, lower) = h.split_at_mut(i);
            for (x, &y) in lower[0].iter_mut().zip(&upper[k]) {
                *x = subtract(*x, multiply(factor, y, p), p);
            }
            for row in &mut h {
                let moved = multiply(factor, row[i], p);
                row[k] = subtract(row[k], p - moved, p);
            }
        }
    }
    // blocks[m] is the polynomial of the first m rows and columns.
    let mut blocks: Vec<Vec<u64>> = vec![vec![1]];
    for m in 0..size {
        let mut next = vec![0; m + 2];
        let mut take = |factor: u64, from: &[u64], shift: usize| {
            for (x, &y) in next.iter_mut().skip(shift).zip(from) {
                *x = subtract(*x, multiply(factor, y, p), p);
            }
        };
        take(p - 1, &blocks[m], 1);
        take(h[m][m], &blocks[m], 0);
        let mut chain = 1;
        for i in (0..m).rev() {
            chain = multiply(chain, h[i + 1][i], p);
            if chain == 0 {
                break;
            }
            take(multiply(chain, h[i][m], p), &blocks[i], 0);
        }
        blocks.push(next);
    }
    let mut polynomial = blocks.pop().unwrap_or_default();
    polynomial.pop();
    polynomial
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fast::multiply::NumBigint;
    use cordon_core::random::SplitMix;

    fn random(size: usize, seed: u64) -> Matrix {
        let mut random = SplitMix::new(seed);
        let mut entry = |j| {
            let a = i64::try_from(random.below(9)).unwrap_or_default() - 4;
            (a != 0).then(|| (j, BigInt::from(a)))
        };
        (0..size).map(|_| (0..size).filter_map(&mut entry).collect()).collect()
    }

    /// Cayley and Hamilton, on random matrices, some singular; and powers step by step.
    #[test]
    fn matrices_are_roots_of_their_polynomials() {
        let mut cases = 0;
        for (size, seed) in (1..9).flat_map(|size| (0..5).map(move |seed| (size, seed))) {
            let mut a = random(size, seed + 100 * size as u64);
            if seed == 4 && size > 1 {
                a[0] = a[1].clone();
            }
            let c = characteristic(&a);
            assert_eq!(c.len(), size);
            let mut x: Vec<BigInt> = (0..size).map(|i| BigInt::from(3 * i + 1)).collect();
            let start = x.clone();
            let mut sum = vec![BigInt::zero(); size];
            for c in c.iter().chain([&BigInt::one()]) {
                sum.iter_mut().zip(&x).for_each(|(s, x)| *s += c * x);
                x = times(&a, &x);
            }
            assert!(sum.iter().all(BigInt::is_zero), "{size} {seed}");
            // One number more, on which no other depends.
            let mut whole = a.clone();
            whole.push(vec![(size, BigInt::one())]);
            let mut stepped = start.clone();
            for k in 1..40 {
                stepped = times(&a, &stepped);
                let from: Vec<_> = start.iter().cloned().chain([BigInt::one()]).collect();
                let jumped = applied(&whole, &from, k, &NumBigint);
                assert_eq!(jumped[..size], stepped, "{size} {seed} {k}");
                cases += 1;
            }
        }
        assert_eq!(cases, 8 * 5 * 39);
    }
}
