//! How long numbers get, before they are computed.

use num_bigint::BigInt;
use num_traits::ToPrimitive;

use super::digits;
use super::limbs::LIMB_BITS;
use super::line::Line;
use cordon_core::{Error, Result};

/// Most bytes of an exact answer. The engines need up to six times as much while they work.
pub const MAX_ANSWER_BYTES: u64 = 1 << 30;

/// Most limb operations of a run that makes every step, about ten minutes. An exact run of k steps
/// with weight p/q makes numbers of k*log2(q) bits, hence N*k^2*log2(q)/128 limb operations.
pub const MAX_STEPPING: f64 = 1e12;

/// An upper bound of `log2 n` for n >= 1; 0 for n = 1.
pub fn log2_above(n: &BigInt) -> f64 {
    let bits = n.bits();
    let cut = bits.saturating_sub(53);
    // At most 53 bits are left, so the double is exact.
    let top = (n >> cut).to_f64().unwrap_or(f64::INFINITY);
    let above = if cut > 0 { top + 1.0 } else { top };
    above.log2() * (1.0 + 1e-14) + cut as f64
}

/// A bound of the bits of `n^t`.
#[derive(Clone, Copy, Debug)]
pub struct Growth {
    log2: f64,
}

impl Growth {
    /// For the powers of `n >= 1`.
    pub fn of(n: &BigInt) -> Self {
        Self { log2: log2_above(n) }
    }

    /// At least the bits of `n^t`; saturates far beyond any memory.
    pub fn bits(self, t: u64) -> u64 {
        // A double's relative error in the product is below 1e-12.
        ((self.log2 * t as f64 * (1.0 + 1e-12)) as u64).saturating_add(2)
    }
}

/// Limbs for numbers of so many bits.
pub fn limbs_for(bits: u64) -> usize {
    usize::try_from(bits.div_ceil(LIMB_BITS)).unwrap_or(usize::MAX)
}

/// Bits of the largest of some numbers.
pub fn longest<'n>(numbers: impl IntoIterator<Item = &'n BigInt>) -> u64 {
    numbers.into_iter().map(BigInt::bits).max().unwrap_or(0)
}

impl Line {
    /// A bound of the bits of every numerator after k steps, without its sign.
    pub fn numerator_bits(&self, k: u64) -> u64 {
        // |x_i^k| <= |T_i| Q^k + W^k max |d_j|, and Q <= W since the weights sum to Q.
        Growth::of(&self.growth())
            .bits(k)
            .saturating_add(longest(self.rest.iter().chain(&self.deviation)) + 1)
    }

    /// About how many bytes the numerators after k steps take.
    pub fn answer_bytes(&self, k: u64) -> u64 {
        (self.numerator_bits(k) / 8 + 8).saturating_mul(self.count() as u64)
    }

    /// Refuses answers beyond memory; `field` is what k was given for.
    ///
    /// # Errors
    /// The answer after k steps would be longer than `MAX_ANSWER_BYTES`: says how long.
    pub fn refuse_beyond_memory(&self, field: &str, k: u64) -> Result<()> {
        let bytes = self.answer_bytes(k);
        if bytes <= MAX_ANSWER_BYTES {
            return Ok(());
        }
        Err(Error::input(format!(
            "{field}: `{k}`: the exact positions of {} drones after so many steps take about {}: \
             expected at most {}{}",
            self.count(),
            readable(bytes),
            readable(MAX_ANSWER_BYTES),
            if self.count() > digits::MAX_DRONES {
                ""
            } else {
                " (digits that are certain, `--engine digits`, have no such limit)"
            }
        )))
    }
}

/// A size in bytes for people.
pub fn readable(bytes: u64) -> String {
    const UNITS: [&str; 7] = ["bytes", "KB", "MB", "GB", "TB", "PB", "EB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1024.0 && unit + 1 < UNITS.len() {
        value /= 1024.0;
        unit += 1;
    }
    let digits = usize::from(unit > 0 && value < 10.0);
    format!("{value:.digits$} {}", UNITS[unit])
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Pow;

    #[test]
    fn bounds_hold_and_are_close() {
        let mut cases = 0;
        for n in [1u64, 2, 3, 5, 7, 1000, 1 << 53, (1 << 53) + 1, u64::MAX] {
            for t in [0u64, 1, 2, 3, 64, 1000] {
                let exact = Pow::pow(BigInt::from(n), t).bits();
                let bound = Growth::of(&BigInt::from(n)).bits(t);
                assert!(bound >= exact && bound <= exact + 3, "{n}^{t}: {bound} for {exact}");
                cases += 1;
            }
        }
        assert_eq!(cases, 54);
    }

    #[test]
    fn sizes_read_well() {
        assert_eq!(readable(17), "17 bytes");
        assert_eq!(readable(1 << 30), "1.0 GB");
        assert_eq!(readable(u64::MAX), "16 EB");
    }
}
