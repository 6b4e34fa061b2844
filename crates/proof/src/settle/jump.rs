//! The true settling step of one run without executing every step, for eps <= 1/2.
//!
//! Continued oddly beyond both ends, e_{-i} = -e_i and e_{2(N-1)-i} = -e_i, the errors of the
//! drones are a sequence of period M = 2(N-1), and a step is the cyclic convolution with the
//! kernel (eps, 1-2eps, eps): the end drones stay at 0 by symmetry. Steps compose as kernels
//! do, so that k steps take about 2 log2 k convolutions. The kernels are nonnegative with sum
//! 1; their entries are rounded down, and what the sum then lacks bounds every error that this
//! makes. No step increases the largest error, so that bisection finds the settling step.

use cordon_spec::placement::scaled_error;
use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::{beyond_half, ends};
use cordon_core::Rational;
use cordon_core::linear::errors;

/// Bits after the point of kernel entries.
const BITS: usize = 256;

/// 32-bit words a slot: room for a sum of 2^31 products of two numbers of `BITS` bits.
const WORDS: usize = 2 * BITS / 32 + 1;

/// Most doublings: 2^40 steps.
const MOST_DOUBLINGS: usize = 40;

/// The first step from which on every error is at most `within`. `None` beyond eps = 1/2, for
/// fewer than five drones, and where rounding leaves the answer open.
pub fn settling_step(start: &[Rational], eps: &Rational, within: &Rational) -> Option<u64> {
    if beyond_half(eps) || eps.is_negative() || start.len() < 5 {
        return None;
    }
    let target = Target::new(start, within)?;
    let identity = Kernel::identity(start.len());
    if target.met_after(&identity)? {
        return Some(0);
    }
    let mut doublings = vec![Kernel::one_step(start.len(), eps)?];
    loop {
        let last = doublings.last()?;
        if target.met_after(last)? || doublings.len() > MOST_DOUBLINGS {
            break;
        }
        let next = last.then(last);
        doublings.push(next);
    }
    // The largest number of steps after which the target is not met, by binary digits.
    let (mut kernel, mut steps) = (identity, 0_u64);
    for (digit, power) in doublings.iter().enumerate().rev() {
        let further = kernel.then(power);
        if !target.met_after(&further)? {
            kernel = further;
            steps += 1 << digit;
        }
    }
    // Beyond the last doubling nothing is known.
    (steps + 1 < 1 << MOST_DOUBLINGS).then_some(steps + 1)
}

/// Entries of a kernel times 2^BITS, rounded down.
struct Kernel {
    entries: Vec<BigUint>,
    /// By how much their sum falls short of 2^BITS.
    lacking: BigUint,
}

impl Kernel {
    fn new(entries: Vec<BigUint>) -> Self {
        let sum: BigUint = entries.iter().sum();
        // Entries rounded down of a kernel with sum 1.
        let whole = BigUint::one() << BITS;
        let lacking = if sum <= whole { whole - sum } else { BigUint::zero() };
        Self { entries, lacking }
    }

    fn identity(count: usize) -> Self {
        let mut entries = vec![BigUint::zero(); 2 * (count - 1)];
        entries[0] = BigUint::one() << BITS;
        Self::new(entries)
    }

    /// One step as the spec makes it: what the error of an inner drone gives to itself and to
    /// its neighbours.
    fn one_step(count: usize, eps: &Rational) -> Option<Self> {
        let mut unit = vec![Rational::zero(); count];
        unit[2] = Rational::one();
        let after = errors::step(eps, &unit);
        let scale = Rational::from_integer(BigInt::one() << BITS);
        let entry = |i: usize| (&after[i] * &scale).floor().to_integer().to_biguint();
        let period = 2 * (count - 1);
        let mut entries = vec![BigUint::zero(); period];
        entries[0] = entry(2)?;
        entries[1] = entry(3)?;
        entries[period - 1] = entry(1)?;
        Some(Self::new(entries))
    }

    /// First these steps, then those of the other.
    fn then(&self, other: &Self) -> Self {
        let product =
            convolved(&packed(&self.entries), &packed(&other.entries), self.entries.len());
        Self::new(product.into_iter().map(|x| x >> BITS).collect())
    }
}

/// The errors at the start, oddly continued, as integers over a common denominator; and the
/// distance in the same unit.
struct Target {
    positive: BigUint,
    negative: BigUint,
    period: usize,
    largest: BigInt,
    within: Rational,
}

impl Target {
    /// `None` where the integers are too long for the slots.
    fn new(start: &[Rational], within: &Rational) -> Option<Self> {
        let (min, max) = ends(start);
        let count = start.len();
        let errors: Vec<Rational> =
            (0..count).map(|i| scaled_error(&min, &max, start, i)).collect();
        let common = errors.iter().fold(BigInt::one(), |lcm, e| lcm.lcm(e.denom()));
        let scale = Rational::from_integer(common);
        let whole: Vec<BigInt> = errors.iter().map(|e| (e * &scale).to_integer()).collect();
        let period = 2 * (count - 1);
        let at = |i: usize| if i < count { whole[i].clone() } else { -&whole[period - i] };
        let side = |sign: Sign| -> Vec<BigUint> {
            let part =
                |e: BigInt| if e.sign() == sign { e.magnitude().clone() } else { BigUint::zero() };
            (0..period).map(at).map(part).collect()
        };
        let largest = whole.iter().map(Signed::abs).max()?;
        if largest.bits() > BITS as u64 {
            return None;
        }
        let gaps = Rational::from_integer((count - 1).into());
        Some(Self {
            positive: packed(&side(Sign::Plus)),
            negative: packed(&side(Sign::Minus)),
            period,
            largest,
            within: within * gaps * scale,
        })
    }

    /// Whether every error is within the distance after the steps of the kernel.
    fn met_after(&self, kernel: &Kernel) -> Option<bool> {
        let packed = packed(&kernel.entries);
        let plus = convolved(&packed, &self.positive, self.period);
        let minus = convolved(&packed, &self.negative, self.period);
        let differences = plus.into_iter().zip(minus);
        let errors = differences.map(|(a, b)| (BigInt::from(a) - BigInt::from(b)).abs());
        let largest = errors.max()?;
        // Mass that rounding has lost may sit on the largest error, with either sign.
        let doubt = BigInt::from(kernel.lacking.clone()) * &self.largest;
        let bound = &self.within * Rational::from_integer(BigInt::one() << BITS);
        let at_most = |x: BigInt| Rational::from_integer(x) <= bound;
        match (at_most(&largest + &doubt), at_most(&largest - &doubt)) {
            (true, _) => Some(true),
            (false, false) => Some(false),
            (false, true) => None,
        }
    }
}

/// The numbers side by side in one, so that a product of two such numbers is a convolution.
fn packed(numbers: &[BigUint]) -> BigUint {
    let mut digits = vec![0_u32; numbers.len() * WORDS];
    for (slot, number) in digits.chunks_exact_mut(WORDS).zip(numbers) {
        for (digit, value) in slot.iter_mut().zip(number.iter_u32_digits()) {
            *digit = value;
        }
    }
    BigUint::new(digits)
}

/// The cyclic convolution of two packed sequences.
fn convolved(a: &BigUint, b: &BigUint, period: usize) -> Vec<BigUint> {
    let digits = (a * b).to_u32_digits();
    let mut sums = vec![BigUint::zero(); period];
    for (i, slot) in digits.chunks(WORDS).enumerate() {
        if let Some(sum) = sums.get_mut(i % period) {
            *sum += BigUint::from_slice(slot);
        }
    }
    sums
}
