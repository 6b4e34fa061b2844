//! Prime fields.

use cordon_spec::Scalar;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::ring_operators;
use crate::Rational;

/// An odd prime below 2^63, the modulus of a prime field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Modulus(u64);

impl Modulus {
    /// The modulus `p`, where `p` is an odd prime below 2^63.
    pub fn new(p: u64) -> Option<Self> {
        (p < 1 << 63 && p > 2 && is_prime(p)).then_some(Self(p))
    }

    /// The prime p, from 2^60 to 2^61 where it was drawn at random.
    pub fn prime(self) -> u64 {
        self.0
    }

    /// The image of a rational, unless the prime divides its denominator.
    pub fn reduce(self, x: &Rational) -> Option<Residue> {
        let p = num_bigint::BigInt::from(self.0);
        let num = x.numer().mod_floor(&p).to_u64()?;
        let den = x.denom().mod_floor(&p).to_u64()?;
        // Fermat: den^(p-2) is the inverse.
        (den != 0).then(|| {
            let inverse = power(den, self.0 - 2, self.0);
            Residue(Value::In { value: mul_mod(num, inverse, self.0), modulus: self })
        })
    }
}

/// An element of a prime field.
///
/// An embedded integer does not know its field until it meets an element that does, so a residue may
/// also be a small integer without a field.
#[derive(Clone, Copy, Debug)]
pub struct Residue(Value);

#[derive(Clone, Copy, Debug)]
enum Value {
    /// An integer that has not met a modulus.
    Integer(i128),
    In {
        value: u64,
        modulus: Modulus,
    },
}

impl Residue {
    /// The representative in `0 .. p`, or `None` for an integer without a field.
    pub fn value(self) -> Option<u64> {
        match self.0 {
            Value::Integer(_) => None,
            Value::In { value, .. } => Some(value),
        }
    }

    fn modulus(self) -> Option<Modulus> {
        match self.0 {
            Value::Integer(_) => None,
            Value::In { modulus, .. } => Some(modulus),
        }
    }

    fn value_in(self, m: Modulus) -> u64 {
        match self.0 {
            // The remainder is in 0 .. p, so it fits.
            Value::Integer(n) => n.rem_euclid(i128::from(m.0)) as u64,
            Value::In { value, .. } => value,
        }
    }
}

impl PartialEq for Residue {
    fn eq(&self, other: &Self) -> bool {
        match (self.modulus().or(other.modulus()), self.0, other.0) {
            (Some(m), ..) => self.value_in(m) == other.value_in(m),
            (None, Value::Integer(a), Value::Integer(b)) => a == b,
            (None, ..) => false,
        }
    }
}

/// `in_field` on residues; `on_integers` where neither operand has a field, which happens only for the
/// few constants of a formula (saturating: they are far below 128 bits).
fn combine(
    a: Residue,
    b: &Residue,
    in_field: impl Fn(u64, u64, u64) -> u64,
    on_integers: impl Fn(i128, i128) -> i128,
) -> Residue {
    match (a.modulus().or(b.modulus()), a.0, b.0) {
        (None, Value::Integer(x), Value::Integer(y)) => Residue(Value::Integer(on_integers(x, y))),
        (Some(m), ..) => {
            Residue(Value::In { value: in_field(a.value_in(m), b.value_in(m), m.0), modulus: m })
        }
        // No modulus means that both are integers.
        (None, ..) => a,
    }
}

ring_operators!(
    Residue,
    |a, b: &Residue| combine(a, b, |x, y, p| (x + y) % p, i128::saturating_add),
    |a, b: &Residue| combine(a, b, |x, y, p| (x + p - y) % p, i128::saturating_sub),
    |a, b: &Residue| combine(a, b, mul_mod, i128::saturating_mul)
);

impl Scalar for Residue {
    fn from_int(n: i32) -> Self {
        Self(Value::Integer(n.into()))
    }
}

/// `a*b mod p`, widened so that it cannot overflow.
fn mul_mod(a: u64, b: u64, p: u64) -> u64 {
    // The remainder is below p, so it fits.
    (u128::from(a) * u128::from(b) % u128::from(p)) as u64
}

fn power(base: u64, mut exponent: u64, p: u64) -> u64 {
    let (mut square, mut result) = (base % p, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = mul_mod(result, square, p);
        }
        square = mul_mod(square, square, p);
        exponent >>= 1;
    }
    result
}

/// Miller-Rabin with the first twelve primes as bases, which decides every 64-bit number.
fn is_prime(p: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if p < 2 || BASES.iter().any(|&b| p != b && p.is_multiple_of(b)) {
        return false;
    }
    let odd = (p - 1) >> (p - 1).trailing_zeros();
    BASES.iter().filter(|&&b| b < p).all(|&b| {
        let mut x = power(b, odd, p);
        if x == 1 || x == p - 1 {
            return true;
        }
        let mut exponent = odd;
        while exponent < (p - 1) / 2 {
            x = mul_mod(x, x, p);
            exponent *= 2;
            if x == p - 1 {
                return true;
            }
        }
        false
    })
}
