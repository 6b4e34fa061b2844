//! Powers of the step as a circular convolution kernel.
//!
//! On a ring of `2m` places a step is the convolution with `side*z^-1 + centre + side*z`, so k
//! steps are the convolution with its k-th power modulo `z^(2m) - 1`, which repeated squaring
//! finds. Two facts make it fast:
//!
//! * Signs need no signed arithmetic. Where `side` and `centre` differ in sign, `z -> -z` (an
//!   automorphism, the ring being even) makes them agree: the magnitudes are a power of
//!   `|side|*z^-1 + |centre| + |side|*z` ([`Signs`] remembers the rest).
//! * Every power is a palindrome. A polynomial is squared by packing it into one long integer
//!   (Kronecker substitution). Slots *half* as wide as the coefficients of the square suffice:
//!   evaluating at 2^s and at 2^-s would give the low and the high halves, and for a palindrome
//!   both are the same integer (D. Harvey's reciprocal evaluation points). So one squaring of a
//!   number as long as the answer does a step of the power.

use num_bigint::{BigInt, BigUint};
use num_traits::Signed;

use super::growth::{Growth, limbs_for};
use super::limbs::{self, LIMB_BITS};
use super::line::Line;
use super::multiply::Multiply;

/// The signs of the coefficients of a power of the kernel.
#[derive(Clone, Copy, Debug)]
pub struct Signs {
    centre: bool,
    side: bool,
}

impl Signs {
    /// Whether the coefficient of `z^j` in the k-th power is negative (or 0).
    pub fn negative(self, k: u64, j: usize) -> bool {
        // (s z^-1 + c + s z)^k: every step keeps the place with c and changes its parity with s.
        let (all, odd) = match (self.centre, self.side) {
            (false, side) => (false, side),
            (true, true) => (true, false),
            (true, false) => (true, true),
        };
        (all && k % 2 == 1) ^ (odd && j % 2 == 1)
    }
}

/// How long coefficients are kept.
#[derive(Clone, Copy, Debug)]
enum Length {
    /// In full.
    Exact(Growth),
    /// As fractions of W^k, in so many limbs after the point, rounded down.
    Fixed(usize),
}

impl Length {
    /// A bound of the bits of the coefficients of a product of powers whose exponents sum to k.
    fn product_bits(self, k: u64) -> u64 {
        match self {
            Self::Exact(growth) => growth.bits(k),
            Self::Fixed(limbs) => 2 * LIMB_BITS * limbs as u64 + 1,
        }
    }
}

/// The k-th power: the magnitudes of its coefficients at 0 ..= m; the others mirror them.
#[derive(Clone)]
pub struct Kernel {
    coefficients: Vec<u64>,
    stride: usize,
    /// Half the length of the ring.
    half: usize,
    /// The exponent so far.
    k: u64,
    rule: Rule,
    /// The coefficients are too small by less than so many units of their last place.
    error: u128,
}

/// The magnitudes of the weights, and what they imply.
#[derive(Clone)]
struct Rule {
    side: Vec<u64>,
    centre: Vec<u64>,
    /// The sum of all: W.
    total: BigUint,
    length: Length,
    signs: Signs,
}

impl Kernel {
    /// The `k`-th power of the step of `line` on a ring of `2*half` places, `half >= 2`.
    pub fn power(line: &Line, half: usize, k: u64, by: &dyn Multiply) -> Self {
        Self::raise(line, half, k, Length::Exact(Growth::of(&line.growth())), by)
    }

    /// The `k`-th power over `W^k`, with W the sum of the weights' magnitudes, in fixed point:
    /// `limbs` limbs after the point, see [`Kernel::error`].
    pub fn fixed_power(line: &Line, half: usize, k: u64, limbs: usize, by: &dyn Multiply) -> Self {
        Self::raise(line, half, k, Length::Fixed(limbs), by)
    }

    fn raise(line: &Line, half: usize, k: u64, length: Length, by: &dyn Multiply) -> Self {
        let magnitude = |w: &BigInt| w.magnitude().to_u64_digits();
        let rule = Rule {
            side: magnitude(&line.side),
            centre: magnitude(&line.centre),
            total: line.growth().magnitude().clone(),
            length,
            signs: Signs { centre: line.centre.is_negative(), side: line.side.is_negative() },
        };
        // The power 0 is 1.
        let (stride, unit) = match length {
            Length::Exact(_) => (1, 0),
            Length::Fixed(limbs) => (limbs + 1, limbs),
        };
        let mut coefficients = vec![0; stride * (half + 1)];
        if let Some(one) = coefficients.get_mut(unit) {
            *one = 1;
        }
        let mut power = Self { coefficients, stride, half, k: 0, rule, error: 0 };
        for bit in (0..u64::BITS - k.leading_zeros()).rev() {
            if power.k > 0 {
                power.multiply(None, by);
            }
            if k >> bit & 1 == 1 {
                power.step();
            }
        }
        power
    }

    /// In fixed point: every true coefficient lies between the one here and that plus so many
    /// units of the last place. 0 for exact powers.
    pub fn error(&self) -> u128 {
        self.error
    }

    /// How many places of the ring may have coefficients other than 0.
    pub fn support(&self) -> usize {
        if self.is_full() { 2 * self.half } else { 2 * self.degree() + 1 }
    }

    /// Whether the coefficient at place `j` of the ring, `0 <= j <= 2*half`, may be other than 0.
    pub fn reaches(&self, j: usize) -> bool {
        j.min(2 * self.half - j) <= self.degree()
    }

    /// Limbs of a coefficient.
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// The magnitude of the coefficient at place `j` of the ring, `0 <= j <= 2*half`.
    pub fn coefficient(&self, j: usize) -> &[u64] {
        let j = if j > self.half { 2 * self.half - j } else { j };
        &self.coefficients[j * self.stride..(j + 1) * self.stride]
    }

    /// Whether the coefficient of `z^j` is negative (or 0).
    pub fn negative(&self, j: usize) -> bool {
        self.rule.signs.negative(self.k, j)
    }

    /// The largest place that is not 0 for sure.
    fn degree(&self) -> usize {
        usize::try_from(self.k).unwrap_or(usize::MAX).min(self.half)
    }

    /// Multiplies by the kernel once.
    fn step(&mut self) {
        let k = self.k + 1;
        let stride = match self.rule.length {
            Length::Exact(growth) => limbs_for(growth.bits(k)),
            Length::Fixed(_) => self.stride,
        };
        // Room for the weights before the division by their sum.
        let mut sum = vec![0; stride + limbs_for(self.rule.total.bits())];
        let mut next = vec![0; stride * (self.half + 1)];
        let places = next.chunks_exact_mut(stride).enumerate();
        for (j, into) in places.take(self.degree() + 2) {
            // The coefficient at -1 is that at 1; beyond `half` the ring folds back.
            let (before, after) = (j.abs_diff(1), j + 1);
            sum.fill(0);
            for (from, weight) in
                [(before, &self.rule.side), (j, &self.rule.centre), (after, &self.rule.side)]
            {
                limbs::accumulate(&mut sum, limbs::trimmed(self.coefficient(from)), weight, false);
            }
            match self.rule.length {
                Length::Exact(_) => {
                    limbs::add(into, limbs::trimmed(&sum), false);
                }
                Length::Fixed(_) => {
                    // A mean of numbers too small by the same error, then rounded down.
                    let mean = limbs::natural(&sum) / &self.rule.total;
                    limbs::write(into, &mean.into());
                }
            }
        }
        if let Length::Fixed(_) = self.rule.length {
            self.error += 1;
        }
        (self.coefficients, self.stride, self.k) = (next, stride, k);
    }

    /// The steps of this power and those of another, of the same line and ring.
    pub fn then(&self, other: &Self, by: &dyn Multiply) -> Self {
        let mut both = self.clone();
        both.multiply(Some(other), by);
        both
    }

    /// The steps of this power twice.
    pub fn twice(&self, by: &dyn Multiply) -> Self {
        let mut both = self.clone();
        both.multiply(None, by);
        both
    }

    /// Multiplies by another power, or by itself.
    fn multiply(&mut self, other: Option<&Self>, by: &dyn Multiply) {
        let k = self.k + other.map_or(self.k, |o| o.k);
        let degree = self.degree() + other.map_or(self.degree(), Self::degree);
        let doublings =
            u32::from(self.is_full()) + u32::from(other.map_or(self.is_full(), Self::is_full));
        let bits = self.rule.length.product_bits(k) + u64::from(doublings);
        let slot = limbs_for((bits + 1).div_ceil(2));
        let room = if other.is_none() { by.room(self.packed_length(slot)) } else { 0 };
        let packed = self.pack(slot, room);
        let stride = limbs_for(bits);
        let half_length = stride * (self.half + 1);
        // Free the old coefficients before the product needs memory.
        self.coefficients = Vec::new();
        let product = match other {
            None => by.square(packed),
            Some(other) => by.product(&packed, &other.pack(slot, 0)),
        };
        let mut next = vec![0; half_length];
        let mut palindrome = Palindrome::new(&product, slot, 2 * degree);
        for below in (0..=degree).rev() {
            // The coefficient of z^-below, and of z^below.
            let index = if below > self.half { 2 * self.half - below } else { below };
            let into = &mut next[index * stride..(index + 1) * stride];
            let coefficient = limbs::trimmed(palindrome.next());
            limbs::add(into, coefficient, false);
            // Both of them fall on the places that mirror themselves.
            if below > 0 && (index == 0 || index == self.half) {
                limbs::add(into, coefficient, false);
            }
        }
        for row in next.chunks_exact_mut(stride) {
            limbs::shift_right(row, doublings);
        }
        (self.coefficients, self.stride, self.k) = (next, stride, k);
        if let Length::Fixed(limbs) = self.rule.length {
            self.round_down(limbs, other.map_or(self.error, |o| o.error));
        }
    }

    /// After a product in fixed point: drops the limbs that it has too many. `other_error` is
    /// the error of the other factor.
    fn round_down(&mut self, limbs: usize, other_error: u128) {
        let kept = limbs + 1;
        let rows = self.coefficients.chunks_exact(self.stride);
        let cut =
            |row: &[u64]| (0..kept).map(|i| row.get(limbs + i).copied().unwrap_or(0)).collect();
        self.coefficients = rows.flat_map::<Vec<u64>, _>(cut).collect();
        self.stride = kept;
        // With c <= true < c + e, sums of c at most 1 and 2m places, a product is too small by
        // less than e + e' + 2m e e' (in units of the last place; the caller has chosen that
        // unit so small that the third term is below 1), and by less than 1 for rounding.
        self.error += other_error + 2;
    }

    /// Whether the place `half`, its own mirror image, is reached: a palindrome of twice the
    /// coefficients then counts it half at either end.
    fn is_full(&self) -> bool {
        self.degree() == self.half
    }

    fn packed_length(&self, slot: usize) -> usize {
        slot * 2 * self.degree() + self.stride + 2
    }

    /// The palindrome `z^-degree ..= z^degree` at `z = 2^(64 slot)`, twice if [`Self::is_full`], in
    /// memory for `room` limbs at least.
    fn pack(&self, slot: usize, room: usize) -> Vec<u64> {
        let (degree, doubled) = (self.degree(), self.is_full());
        let length = self.packed_length(slot);
        let mut packed = Vec::with_capacity(room.max(length));
        packed.resize(length, 0);
        for index in 0..=2 * degree {
            let j = index.abs_diff(degree);
            let coefficient = limbs::trimmed(self.coefficient(j));
            let into = &mut packed[index * slot..];
            limbs::add(into, coefficient, false);
            if doubled && j < degree {
                limbs::add(into, coefficient, false);
            }
        }
        packed
    }
}

/// Reads the coefficients of a palindromic polynomial of nonnegative coefficients b_i below
/// 2^(128 slot - 1), i = 0 ..= degree, off its value at 2^(64 slot).
///
/// With `b_i = low_i + high_i*2^(64 slot)` digit i of the value is `low_i + high_{i-1}` and a
/// carry. From the bottom, where `high_{i-1}` is known, digit i tells `low_i`; from the top,
/// where `low_{i-1}` is known, digit `degree+1-i` tells `high_i = high_{degree-i}`. The carry
/// into that digit shows in the digit below it: it is smaller than the `low` in it.
struct Palindrome<'p> {
    value: &'p [u64],
    slot: usize,
    degree: usize,
    next: usize,
    /// `low_i` then `high_i`, of the coefficient returned last.
    coefficient: Vec<u64>,
    /// The carry into digit `next`, from below.
    carry: bool,
    scratch: Vec<u64>,
}

impl<'p> Palindrome<'p> {
    fn new(value: &'p [u64], slot: usize, degree: usize) -> Self {
        let coefficient = vec![0; 2 * slot];
        Self { value, slot, degree, next: 0, coefficient, carry: false, scratch: vec![0; slot] }
    }

    /// The next coefficient, from the lowest (which is the highest too) to the middle one.
    fn next(&mut self) -> &[u64] {
        let (i, slot) = (self.next, self.slot);
        self.next += 1;
        let (low, high) = self.coefficient.split_at_mut(slot);
        // From the top; the carry into this digit comes later, the one out of it is a multiple
        // of the base and drops out.
        let upper = &mut self.scratch;
        upper.fill(0);
        limbs::add(upper, digit(self.value, slot, self.degree + 1 - i), false);
        limbs::sub(upper, low, false);
        // From the bottom.
        low.fill(0);
        limbs::add(low, digit(self.value, slot, i), false);
        self.carry = limbs::sub(low, high, self.carry);
        let carried = limbs::less(digit(self.value, slot, self.degree - i), low);
        limbs::sub(upper, &[], carried);
        high.copy_from_slice(upper);
        &self.coefficient
    }
}

/// Digit `i` of `value` in base 2^(64 slot); high limbs that are 0 may be missing.
fn digit(value: &[u64], slot: usize, i: usize) -> &[u64] {
    let from = (i * slot).min(value.len());
    let to = (from + slot).min(value.len());
    &value[from..to]
}

#[cfg(test)]
mod tests {
    use num_bigint::BigUint;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn palindromes_are_read_back(
            half in prop::collection::vec(prop_oneof![
                any::<u128>(), Just(0), Just(u128::MAX), Just(1 << 64), Just((1 << 64) - 1)
            ], 1..8)
        ) {
            // Coefficients below 2^127, slots of one limb.
            let half: Vec<u128> = half.iter().map(|b| b >> 1).collect();
            let degree = 2 * (half.len() - 1);
            let at = |i: usize| half[i.min(degree - i)];
            let value = (0..=degree)
                .fold(BigUint::default(), |sum, i| sum + (BigUint::from(at(i)) << (64 * i)));
            let value: Vec<u64> = value.iter_u64_digits().collect();
            let mut reader = Palindrome::new(&value, 1, degree);
            for (i, &wanted) in half.iter().enumerate() {
                let got = limbs::natural(reader.next());
                prop_assert_eq!(got, BigUint::from(wanted), "coefficient {}", i);
            }
        }
    }
}
