//! Long multiplication, behind one small trait: the only thing that the jump engine asks of
//! a library of big integers.

use super::limbs::natural;

/// Multiplies natural numbers, given and returned as little-endian 64-bit limbs.
pub trait Multiply: Sync {
    /// The name of the backend, for people and benchmarks.
    fn name(&self) -> &'static str;

    /// `a * b`; high limbs that are 0 may be missing.
    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64>;

    /// `a * a`; high limbs that are 0 may be missing.
    fn square(&self, a: &[u64]) -> Vec<u64> {
        self.product(a, a)
    }
}

/// `num-bigint`: schoolbook, Karatsuba and Toom-3.
#[derive(Clone, Copy, Debug, Default)]
pub struct NumBigint;

impl Multiply for NumBigint {
    fn name(&self) -> &'static str {
        "num-bigint"
    }

    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
        (natural(a) * natural(b)).iter_u64_digits().collect()
    }

    fn square(&self, a: &[u64]) -> Vec<u64> {
        let a = natural(a);
        (&a * &a).iter_u64_digits().collect()
    }
}

/// `dashu`: schoolbook, Karatsuba and Toom-3, in assembly-free Rust.
#[cfg(feature = "dashu")]
#[derive(Clone, Copy, Debug, Default)]
pub struct Dashu;

#[cfg(feature = "dashu")]
impl Multiply for Dashu {
    fn name(&self) -> &'static str {
        "dashu"
    }

    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
        let [a, b] = [a, b].map(dashu_int::UBig::from_words);
        (a * b).as_words().to_vec()
    }

    fn square(&self, a: &[u64]) -> Vec<u64> {
        dashu_int::UBig::from_words(a).sqr().as_words().to_vec()
    }
}

/// GMP, through `rug`.
#[cfg(feature = "gmp")]
#[derive(Clone, Copy, Debug, Default)]
pub struct Gmp;

#[cfg(feature = "gmp")]
impl Multiply for Gmp {
    fn name(&self) -> &'static str {
        "gmp"
    }

    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
        use rug::{Integer, integer::Order};
        let [a, b] = [a, b].map(|x| Integer::from_digits(x, Order::Lsf));
        Integer::from(&a * &b).to_digits(Order::Lsf)
    }

    fn square(&self, a: &[u64]) -> Vec<u64> {
        use rug::{Integer, integer::Order};
        let square = { Integer::from(Integer::from_digits(a, Order::Lsf).square_ref()) };
        square.to_digits(Order::Lsf)
    }
}
