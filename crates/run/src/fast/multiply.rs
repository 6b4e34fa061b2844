//! Long multiplication, behind one small trait: the only thing that the jump engine asks of
//! a library of big integers.

use super::limbs::natural;

/// Multiplies natural numbers, given and returned as little-endian 64-bit limbs.
pub trait Multiply: Sync {
    /// The name of the backend, for people and benchmarks.
    fn name(&self) -> &'static str;

    /// `a * b`; high limbs that are 0 may be missing.
    fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64>;

    /// `a * a`; high limbs that are 0 may be missing. Takes `a`, so that its memory can be
    /// given back before the product needs it.
    fn square(&self, a: Vec<u64>) -> Vec<u64>;
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

    fn square(&self, a: Vec<u64>) -> Vec<u64> {
        let a = natural(&a);
        (&a * &a).iter_u64_digits().collect()
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
        let [a, b] = [a, b].map(|x| rug::Integer::from_digits(x, rug::integer::Order::Lsf));
        gmp_limbs(&rug::Integer::from(&a * &b))
    }

    fn square(&self, a: Vec<u64>) -> Vec<u64> {
        let a = rug::Integer::from_digits(&a, rug::integer::Order::Lsf);
        gmp_limbs(&rug::Integer::from(a.square_ref()))
    }
}

#[cfg(feature = "gmp")]
fn gmp_limbs(x: &rug::Integer) -> Vec<u64> {
    let mut limbs = vec![0; x.significant_digits::<u64>()];
    x.write_digits(&mut limbs, rug::integer::Order::Lsf);
    limbs
}
