//! Exact fractions that are not reduced to lowest terms.

use std::cell::RefCell;
use std::fmt;
use std::sync::Arc;

use cordon_spec::Scalar;
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::One;

use cordon_core::exact::{self, Rational};
use cordon_core::scalar::ring_operators;

/// An exact fraction, cheap to clone, with any positive denominator that the computation led to.
///
/// The units of a swarm multiply by the same few constants step after step, so that their denominators
/// are equal or divide one another; reducing every result (as [`Rational`] does) would cost far more
/// than it saves. Equal denominators are mostly shared in memory. Equality is that of the numbers.
#[derive(Clone, Debug)]
pub struct Quotient(Arc<Terms>);

#[derive(Debug)]
struct Terms {
    num: BigInt,
    /// The denominator, always positive.
    den: Arc<BigUint>,
}

impl Quotient {
    fn new(num: BigInt, den: Arc<BigUint>) -> Self {
        Self(Arc::new(Terms { num, den }))
    }

    fn den(&self) -> BigInt {
        BigUint::clone(&self.0.den).into()
    }

    /// The number in lowest terms.
    pub fn to_rational(&self) -> Rational {
        Rational::new(self.0.num.clone(), self.den())
    }

    /// The nearest double, ties to even.
    pub fn to_f64(&self) -> f64 {
        exact::nearest_f64(&self.0.num, &self.0.den)
    }

    /// `double(numerator)/double(denominator)` of the fraction in lowest terms: three roundings, as in
    /// the recorded runs.
    pub fn to_f64_by_terms(&self) -> f64 {
        let x = self.to_rational();
        let double = |n: &BigInt| exact::to_f64(&Rational::from_integer(n.clone()));
        double(x.numer()) / double(x.denom())
    }

    /// The distance of a double from this number, rounded once; infinite where the double is not
    /// finite.
    pub fn distance_from(&self, x: f64) -> f64 {
        let Some(x) = Self::from_f64(x) else {
            return f64::INFINITY;
        };
        // Over the product of the denominators: reducing it first would cost more.
        let (a, b) = (&*self.0, &*x.0);
        let scaled = |num: &BigInt, den: &BigUint| num * BigInt::from(den.clone());
        let num = scaled(&a.num, &b.den) - scaled(&b.num, &a.den);
        Self::new(num, Arc::new(&*a.den * &*b.den)).to_f64().abs()
    }

    /// The first convergent of a double that rounds to it, a simple fraction: `1/3` for
    /// `0.3333333333333333`, `1/5` for `0.2`. `None` where the double is not finite.
    ///
    /// This recovers parameters that were fractions before they travelled as doubles.
    pub fn simplest_of(x: f64) -> Option<Self> {
        let exact = Rational::from_float(x)?;
        // Convergents of the continued fraction: the first that rounds to the double.
        let (mut rest, mut before, mut last) =
            (exact.clone(), (BigInt::default(), BigInt::one()), (BigInt::one(), BigInt::default()));
        loop {
            let whole = rest.floor().to_integer();
            let num = &whole * &last.0 + &before.0;
            let den = &whole * &last.1 + &before.1;
            let convergent = Rational::new(num.clone(), den.clone());
            if exact::to_f64(&convergent) == x || rest.is_integer() {
                return Some(Self::from(&convergent));
            }
            rest = (rest - Rational::from_integer(whole)).recip();
            before = std::mem::replace(&mut last, (num, den));
        }
    }

    /// The exact value of a double; `None` where it is not finite.
    pub fn from_f64(x: f64) -> Option<Self> {
        Rational::from_float(x).map(|r| Self::from(&r))
    }
}

impl From<&Rational> for Quotient {
    fn from(x: &Rational) -> Self {
        Self::new(x.numer().clone(), Arc::new(x.denom().magnitude().clone()))
    }
}

impl fmt::Display for Quotient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_rational().fmt(f)
    }
}

impl PartialEq for Quotient {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || {
            let scaled = |num: &BigInt, den: &BigUint| num * BigInt::from(den.clone());
            scaled(&self.0.num, &other.0.den) == scaled(&other.0.num, &self.0.den)
        }
    }
}

impl Eq for Quotient {}

/// Both numerators over a common denominator, multiplied only where necessary.
fn combined(
    a: &Quotient,
    b: &Quotient,
    operation: impl Fn(&BigInt, &BigInt) -> BigInt,
) -> Quotient {
    let (a, b) = (&*a.0, &*b.0);
    if Arc::ptr_eq(&a.den, &b.den) || a.den == b.den {
        return Quotient::new(operation(&a.num, &b.num), a.den.clone());
    }
    let times = |num: &BigInt, factor: BigUint| num * BigInt::from(factor);
    let (small, large) = if a.den < b.den { (a, b) } else { (b, a) };
    let (factor, rest) = match small.den.is_one() {
        true => (BigUint::clone(&large.den), BigUint::default()),
        false => large.den.div_rem(&small.den),
    };
    if rest == BigUint::default() {
        let (x, y) = if a.den < b.den {
            (times(&a.num, factor), b.num.clone())
        } else {
            (a.num.clone(), times(&b.num, factor))
        };
        return Quotient::new(operation(&x, &y), large.den.clone());
    }
    let common = a.den.lcm(&b.den);
    let x = times(&a.num, &common / &*a.den);
    let y = times(&b.num, &common / &*b.den);
    Quotient::new(operation(&x, &y), Arc::new(common))
}

fn product(a: &Quotient, b: &Quotient) -> Quotient {
    Quotient::new(&a.0.num * &b.0.num, product_of_denominators(&a.0.den, &b.0.den))
}

thread_local! {
    /// The last two denominators and their product: the units of a swarm ask for the same one after
    /// another.
    static LAST: RefCell<Option<[Arc<BigUint>; 3]>> = const { RefCell::new(None) };

    /// 0, 1 and 2, which every update needs.
    static SMALL: [Quotient; 3] = [0, 1, 2].map(whole);
}

fn whole(n: i32) -> Quotient {
    Quotient::new(n.into(), Arc::new(BigUint::one()))
}

fn product_of_denominators(a: &Arc<BigUint>, b: &Arc<BigUint>) -> Arc<BigUint> {
    for (one, other) in [(a, b), (b, a)] {
        if one.is_one() {
            return other.clone();
        }
    }
    LAST.with_borrow_mut(|last| {
        if let Some([x, y, product]) = last
            && (Arc::ptr_eq(x, a) || x == a)
            && (Arc::ptr_eq(y, b) || y == b)
        {
            return product.clone();
        }
        let product = Arc::new(&**a * &**b);
        *last = Some([a.clone(), b.clone(), product.clone()]);
        product
    })
}

ring_operators!(
    Quotient,
    |a: Quotient, b: &Quotient| combined(&a, b, |x, y| x + y),
    |a: Quotient, b: &Quotient| combined(&a, b, |x, y| x - y),
    |a: Quotient, b: &Quotient| product(&a, b)
);

impl Scalar for Quotient {
    fn from_int(n: i32) -> Self {
        let small = usize::try_from(n).ok();
        SMALL.with(|known| small.and_then(|n| known.get(n)).cloned()).unwrap_or_else(|| whole(n))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn fractions_survive_the_way_through_doubles() {
        let mut compared = 0;
        for den in 1..=60 {
            for num in -120..=120 {
                let fraction = Rational::new(num.into(), den.into());
                let back = Quotient::simplest_of(exact::to_f64(&fraction)).unwrap();
                assert_eq!(back.to_rational(), fraction);
                compared += 1;
            }
        }
        assert_eq!(compared, 60 * 241);
        for x in [0.1 + 0.2, f64::MIN_POSITIVE, 1e300, -7.25e-9, std::f64::consts::PI] {
            assert_eq!(Quotient::simplest_of(x).unwrap().to_f64(), x);
        }
        assert_eq!(Quotient::simplest_of(f64::NAN), None);
    }
}
