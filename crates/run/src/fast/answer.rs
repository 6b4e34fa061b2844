//! Exact positions over a common denominator.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::multiply::Multiply;
use super::power;
use cordon_core::Rational;
use cordon_core::scalar::{Modulus, Residue};

/// The positions of all drones after k protocol steps: `numerators[i] / (base * den^k)`, not
/// in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Protocol steps.
    pub k: u64,
    /// One a drone.
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
        let den = self.base.bits() + (self.den.bits().saturating_sub(1)).saturating_mul(self.k);
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
        let denominator = self.denominator(by);
        let primes = Primes::of(&[&self.base, &self.den]);
        self.numerators.iter().map(|n| primes.lowest(n, &denominator)).collect()
    }
}

/// Primes below this are found by trial; a denominator with larger ones is reduced by gcd.
const TRIAL: u64 = 1 << 12;

/// The primes of a denominator, if they are all small: then fractions are brought to lowest
/// terms by a few exact divisions instead of a gcd of long numbers.
struct Primes {
    primes: Vec<BigUint>,
    complete: bool,
}

impl Primes {
    fn of(numbers: &[&BigInt]) -> Self {
        let mut primes = Vec::new();
        let mut complete = true;
        for n in numbers {
            let mut rest = n.magnitude().clone();
            for p in 2..TRIAL {
                if rest.is_one() {
                    break;
                }
                if (&rest % p).is_zero() {
                    primes.push(BigUint::from(p));
                    while (&rest % p).is_zero() {
                        rest /= p;
                    }
                }
            }
            complete &= rest.to_u64().is_some_and(|r| r < TRIAL * TRIAL);
            if !rest.is_one() {
                // Without factors below TRIAL it is prime if it is below TRIAL squared.
                primes.push(rest);
            }
        }
        primes.sort_unstable();
        primes.dedup();
        Self { primes, complete }
    }

    fn lowest(&self, num: &BigInt, den: &BigInt) -> Rational {
        if num.is_zero() {
            return Rational::zero();
        }
        if !self.complete {
            return Rational::new(num.clone(), den.clone());
        }
        let (mut n, mut d) = (num.magnitude().clone(), den.magnitude().clone());
        for p in &self.primes {
            (n, d) = without_common(n, d, p);
        }
        let n = BigInt::from(n) * num.signum();
        Rational::new_raw(n, d.into())
    }
}

/// `n` and `d` without the powers of `p` that divide both.
fn without_common(mut n: BigUint, mut d: BigUint, p: &BigUint) -> (BigUint, BigUint) {
    // p, p^2, p^4, ...: as far as they divide both, then downwards.
    let mut powers = Vec::new();
    let mut q = p.clone();
    while let Some((a, b)) = divided(&n, &d, &q) {
        (n, d) = (a, b);
        let square = &q * &q;
        powers.push(q);
        q = square;
    }
    for q in powers.iter().rev() {
        while let Some((a, b)) = divided(&n, &d, q) {
            (n, d) = (a, b);
        }
    }
    (n, d)
}

fn divided(n: &BigUint, d: &BigUint, q: &BigUint) -> Option<(BigUint, BigUint)> {
    if n.bits() < q.bits() || d.bits() < q.bits() {
        return None;
    }
    let (a, rest) = n.div_rem(q);
    if !rest.is_zero() {
        return None;
    }
    let (b, rest) = d.div_rem(q);
    rest.is_zero().then_some((a, b))
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
            num in any::<i64>(), extra in 0u32..40, base in 1u64..5000, den in 1u64..3000, k in 0u64..40
        ) {
            let num = BigInt::from(num) * Pow::pow(BigInt::from(den), extra);
            let answer = Answer { k, numerators: vec![num.clone()], base: base.into(), den: den.into() };
            let by = &super::super::multiply::NumBigint;
            let wanted = Rational::new(num, answer.denominator(by));
            prop_assert_eq!(answer.positions(by), vec![wanted]);
        }
    }
}
