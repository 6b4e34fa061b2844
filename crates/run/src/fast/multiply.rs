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
    /// given back or used before the product needs it.
    fn square(&self, a: Vec<u64>) -> Vec<u64>;

    /// The capacity that the square of so many limbs is computed in, if its argument has it.
    fn room(&self, limbs: usize) -> usize {
        limbs
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

    fn square(&self, a: Vec<u64>) -> Vec<u64> {
        let a = natural(&a);
        (&a * &a).iter_u64_digits().collect()
    }
}
