//! Residues modulo four primes, as integers in doubles, and their exact products.

/// A prime p = 1 modulo 2^36, a little below 0.99*2^50, and its inverse as a double.
#[derive(Clone, Copy)]
pub(super) struct Lane {
    pub(super) p: f64,
    inverse: f64,
}

/// The primes, each with a quadratic non-residue.
pub(super) const PRIMES: [(u64, u64); 4] = [
    (0x3_f580_0000_0001, 3),
    (0x3_f490_0000_0001, 3),
    (0x3_f3a0_0000_0001, 3),
    (0x3_f2a0_0000_0001, 19),
];

pub(super) const LANES: [Lane; 4] = {
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
    pub(super) fn times(self, a: f64, b: f64, fused: bool) -> f64 {
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
    pub(super) fn reduce(self, a: f64, fused: bool) -> f64 {
        let q = nearest(a * self.inverse, fused);
        if fused { (-q).mul_add(self.p, a) } else { a - q * self.p }
    }
}

/// A coefficient modulo each of the primes.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Row(pub(super) [f64; 4]);

/// A row in memory, as the bits of its residues: so numbers and rows can take each other's place.
pub(super) type Words = [u64; 4];

pub(super) const ZERO: Row = Row([0.0; 4]);

impl Row {
    #[inline(always)]
    pub(super) fn load(words: &Words) -> Self {
        let [a, b, c, d] = *words;
        Self([f64::from_bits(a), f64::from_bits(b), f64::from_bits(c), f64::from_bits(d)])
    }

    #[inline(always)]
    pub(super) fn store(self, words: &mut Words) {
        let [a, b, c, d] = self.0;
        *words = [a.to_bits(), b.to_bits(), c.to_bits(), d.to_bits()];
    }

    /// `f` of each pair of residues.
    #[inline(always)]
    pub(super) fn with(self, other: Self, f: impl Fn(Lane, f64, f64) -> f64) -> Self {
        let mut result = ZERO;
        for (((x, lane), a), b) in result.0.iter_mut().zip(LANES).zip(self.0).zip(other.0) {
            *x = f(lane, a, b);
        }
        result
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        self.with(other, |_, a, b| a + b)
    }

    #[inline(always)]
    pub(super) fn minus(self, other: Self) -> Self {
        self.with(other, |_, a, b| a - b)
    }

    #[inline(always)]
    pub(super) fn times(self, other: Self, fused: bool) -> Self {
        self.with(other, |lane, a, b| lane.times(a, b, fused))
    }

    #[inline(always)]
    pub(super) fn reduced(self, fused: bool) -> Self {
        self.with(self, |lane, a, _| lane.reduce(a, fused))
    }

    /// What `make` returns for each prime and its non-residue.
    pub(super) fn of(make: impl Fn(u64, u64) -> u64) -> Self {
        Self(PRIMES.map(|(p, non_residue)| balanced(make(p, non_residue), p)))
    }
}

/// `x` below p as the nearest of its residues to 0.
fn balanced(x: u64, p: u64) -> f64 {
    if x > p / 2 { -((p - x) as f64) } else { x as f64 }
}

pub(super) fn power(mut base: u64, mut exponent: u64, p: u64) -> u64 {
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

pub(super) fn inverse(x: u64, p: u64) -> u64 {
    power(x % p, p - 2, p)
}

#[cfg(test)]
mod tests {
    use super::super::LONGEST;
    use super::super::digits::DIGIT;
    use super::super::tests::random;
    use super::*;

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
}
