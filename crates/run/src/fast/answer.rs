//! Exact positions over a common denominator.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{One, Zero};

use super::growth::Growth;
use super::multiply::Multiply;
use super::power;
use cordon_core::Rational;
use cordon_core::scalar::{Modulus, Residue};

/// The positions of all drones after k protocol steps: `numerators[i] / (base * den^k)`, not
/// in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The protocol steps made since the start.
    pub k: u64,
    /// Numerators over the common denominator, one a drone.
    pub numerators: Vec<BigInt>,
    /// Common denominator of the start and the resting places.
    pub base: BigInt,
    /// Common denominator of the weights.
    pub den: BigInt,
}

impl Answer {
    /// The common denominator `base * den^k`.
    pub fn denominator(&self, by: &dyn Multiply) -> BigInt {
        BigInt::from(power::natural(self.den.magnitude(), self.k, by)) * &self.base
    }

    /// Bits of all numerators and, once for each, of the common denominator: what a vector of
    /// fractions takes.
    pub fn bits(&self) -> u64 {
        let den = self.base.bits() + Growth::of(&self.den).bits(self.k);
        self.numerators.iter().map(|n| n.bits() + den).sum()
    }

    /// The positions in a prime field; `None` where the prime divides the denominator.
    pub fn residues(&self, p: Modulus) -> Option<Vec<Residue>> {
        let one = Rational::one();
        let den = Rational::from(self.den.clone());
        let inverse = p.reduce(&(&one / den))?.power(self.k, &p.reduce(&one)?);
        let scale = p.reduce(&(one / Rational::from(self.base.clone())))? * &inverse;
        self.numerators
            .iter()
            .map(|n| Some(p.reduce(&Rational::from(n.clone()))? * &scale))
            .collect()
    }

    /// The positions as fractions in lowest terms.
    pub fn positions(&self, by: &dyn Multiply) -> Vec<Rational> {
        let mut terms = Terms::of(self, power::natural(self.den.magnitude(), self.k, by).into());
        self.numerators.iter().map(|n| terms.lowest(n)).collect()
    }
}

/// Brings fractions over `base * den^k` to lowest terms, without a gcd of long numbers: what a
/// numerator has in common with the denominator is found by gcds with factors of `base * den`,
/// which are short.
pub struct Terms {
    /// `den^k`.
    power: BigInt,
    /// `base * den^k`.
    denominator: BigInt,
    base: BigInt,
    den: BigInt,
    k: u64,
    /// Pairwise coprime; every prime of the denominator divides one. Split as numerators show
    /// that they are composite.
    factors: Vec<BigUint>,
}

impl Terms {
    /// Of the positions of an answer whose `den^k` is `power`.
    pub fn of(answer: &Answer, power: BigInt) -> Self {
        let Answer { k, base, den, .. } = answer;
        let factors = coprime([base.magnitude().clone(), den.magnitude().clone()]);
        let (base, den) = (base.clone(), den.clone());
        Self { denominator: &power * &base, power, base, den, k: *k, factors }
    }

    /// The positive denominator that all numerators have in common; not in lowest terms.
    pub fn denominator(&self) -> &BigInt {
        &self.denominator
    }

    /// `n` over the common denominator, in lowest terms.
    pub fn lowest(&mut self, n: &BigInt) -> Rational {
        // Drones at rest: the quotient is short, whatever k is.
        let (whole, rest) = n.div_rem(&self.power);
        if rest.is_zero() {
            return Rational::new(whole, self.base.clone());
        }
        'split: loop {
            let mut num = n.magnitude().clone();
            let mut removed = BigUint::one();
            for (i, c) in self.factors.iter().enumerate() {
                let most = u64::from(valuation(self.base.magnitude(), c))
                    + u64::from(valuation(self.den.magnitude(), c)).saturating_mul(self.k);
                let (left, common, times) = without_powers(num, c, most);
                let shared = if times < most { (&left % c).gcd(c) } else { BigUint::one() };
                if !shared.is_one() {
                    // c is not prime: the numerator has a part of it.
                    let rest = c / &shared;
                    let others = self.factors.iter().enumerate().filter(|(j, _)| *j != i);
                    let others: Vec<_> = others.map(|(_, f)| f.clone()).collect();
                    self.factors = coprime(others.into_iter().chain([shared, rest]));
                    continue 'split;
                }
                num = left;
                removed *= common;
            }
            let num = BigInt::from_biguint(n.sign(), num);
            let den = &self.denominator / BigInt::from(removed);
            return Rational::new_raw(num, den);
        }
    }
}

/// Pairwise coprime numbers above 1 that together have the primes of the given ones.
fn coprime(numbers: impl IntoIterator<Item = BigUint>) -> Vec<BigUint> {
    let mut found: Vec<BigUint> = Vec::new();
    let mut left: Vec<BigUint> = numbers.into_iter().collect();
    while let Some(n) = left.pop() {
        if n.is_one() || n.is_zero() {
            continue;
        }
        let meeting = found.iter().map(|f| f.gcd(&n)).position(|g| !g.is_one());
        match meeting {
            None => found.push(n),
            Some(i) => {
                let f = found.swap_remove(i);
                let shared = f.gcd(&n);
                left.extend([f / &shared, n / &shared, shared]);
            }
        }
    }
    found
}

/// How often `c > 1` divides `n > 0`.
fn valuation(n: &BigUint, c: &BigUint) -> u32 {
    let (mut rest, mut times) = (n.clone(), 0);
    loop {
        let (quotient, remainder) = rest.div_rem(c);
        if !remainder.is_zero() {
            return times;
        }
        (rest, times) = (quotient, times + 1);
    }
}

/// `n` without the powers of `c` that divide it, `most` at most; their product and number.
fn without_powers(mut n: BigUint, c: &BigUint, most: u64) -> (BigUint, BigUint, u64) {
    if *c == BigUint::from(2u8) {
        let times = n.trailing_zeros().unwrap_or(0).min(most);
        return (n >> times, BigUint::one() << times, times);
    }
    // c, c^2, c^4, ...: as far as they divide, then downwards.
    let mut powers = vec![(c.clone(), 1)];
    let (mut common, mut times) = (BigUint::one(), 0);
    while let Some((power, exponent)) = powers.last().cloned() {
        let grows = times + 1 == exponent;
        if times + exponent <= most && power.bits() <= n.bits() {
            let (quotient, remainder) = n.div_rem(&power);
            if remainder.is_zero() {
                n = quotient;
                common *= &power;
                times += exponent;
                if grows {
                    powers.push((&power * &power, exponent * 2));
                }
                continue;
            }
        }
        powers.pop();
    }
    (n, common, times)
}

/// Exponentiation in a prime field.
trait Power {
    fn power(self, exponent: u64, one: &Residue) -> Residue;
}

impl Power for Residue {
    fn power(self, mut exponent: u64, one: &Residue) -> Residue {
        let (mut square, mut result) = (self, *one);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * &square;
            }
            square = square * &square;
            exponent >>= 1;
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use num_traits::Pow;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn lowest_terms_are_those_of_the_library(
            nums in prop::collection::vec((any::<i64>(), 0u32..40, 1u64..100), 1..4),
            base in prop_oneof![1u64..5000, Just(987_654_321_098_765_433)],
            den in prop_oneof![1u64..3000, Just(900), Just(1 << 12), Just(987_654_321_098_765_433)],
            k in 0u64..40,
        ) {
            // Numerators with powers of the denominator, and of a factor of it, in them.
            let power = |extra: u32, times: u64| Pow::pow(BigInt::from(den), extra) * times;
            let numerators: Vec<BigInt> =
                nums.iter().map(|&(n, extra, times)| power(extra, times) * n / 6).collect();
            let answer = Answer { k, numerators, base: base.into(), den: den.into() };
            let by = &super::super::multiply::NumBigint;
            let common = answer.denominator(by);
            let wanted: Vec<_> =
                answer.numerators.iter().map(|n| Rational::new(n.clone(), common.clone())).collect();
            prop_assert_eq!(answer.positions(by), wanted);
        }
    }

    #[test]
    fn composite_factors_are_split_where_it_matters() {
        // 6^k with numerators that have 2, 3 or 4 in common with it.
        let numerators = [2, 3, 4, 35, 0, -9].map(BigInt::from).to_vec();
        let answer = Answer { k: 5, numerators, base: 1.into(), den: 6.into() };
        let shown: Vec<_> = answer
            .positions(&super::super::multiply::NumBigint)
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(shown, ["1/3888", "1/2592", "1/1944", "35/7776", "0", "-1/864"]);
    }
}
