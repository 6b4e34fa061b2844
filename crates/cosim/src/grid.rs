//! The communication grid: the times at which units exchange values.

use num_traits::{Signed, ToPrimitive};

use cordon_core::exact::{self, Rational};
use cordon_core::{Error, Result};

/// Longest run, in communication steps: about sixteen years in steps of 0.05 s.
const MAX_STEPS: u64 = 10_000_000_000;

/// Equidistant times `0, tau, 2 tau, ..` in seconds, as exact rationals: rounding errors do not
/// accumulate, however long the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    tau: Rational,
    steps: u64,
    /// The double nearest to tau, for units that compute in doubles.
    tau_f64: Bits,
}

/// A double that is compared by its bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bits(u64);

impl Grid {
    /// The grid of `steps` communication steps of `tau` seconds.
    ///
    /// # Errors
    /// `tau` is not positive, or there are more than ten billion steps.
    pub fn new(tau: Rational, steps: u64) -> Result<Self> {
        if !tau.is_positive() {
            return Err(Error::input(format!(
                "tau: `{tau}`: expected a positive number of seconds"
            )));
        }
        if steps > MAX_STEPS {
            return Err(Error::input(format!(
                "duration: {steps} steps of {tau} s: expected at most {MAX_STEPS} steps"
            )));
        }
        let tau_f64 = Bits(exact::to_f64(&tau).to_bits());
        Ok(Self { tau, steps, tau_f64 })
    }

    /// The grid that ends after `duration` seconds.
    ///
    /// # Errors
    /// `tau` does not divide `duration`, or as for [`Grid::new`].
    pub fn lasting(duration: &Rational, tau: Rational) -> Result<Self> {
        if duration.is_negative() {
            return Err(Error::input(format!(
                "duration: `{duration}`: expected 0 or more seconds"
            )));
        }
        if !tau.is_positive() {
            return Self::new(tau, 0);
        }
        match multiple(duration, &tau) {
            Some(steps) => Self::new(tau, steps),
            None => Err(Error::input(format!(
                "duration: `{duration}`: expected a whole multiple of the step tau, which is `{tau}` s, and at most {MAX_STEPS} steps"
            ))),
        }
    }

    /// The communication step in seconds.
    pub fn tau(&self) -> &Rational {
        &self.tau
    }

    /// The double nearest to the communication step.
    pub fn tau_f64(&self) -> f64 {
        f64::from_bits(self.tau_f64.0)
    }

    /// How many communication steps there are.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The time of grid point `step`, in seconds.
    pub fn time(&self, step: u64) -> Rational {
        &self.tau * Rational::from_integer(step.into())
    }

    /// The double nearest to the time of grid point `step`.
    pub fn time_f64(&self, step: u64) -> f64 {
        exact::to_f64(&self.time(step))
    }

    /// The number of communication steps in `seconds`, where that is an integer.
    pub fn steps_in(&self, seconds: &Rational) -> Option<u64> {
        multiple(seconds, &self.tau)
    }
}

/// `long/short`, where that is an integer that fits.
fn multiple(long: &Rational, short: &Rational) -> Option<u64> {
    let quotient = long / short;
    if quotient.is_integer() { quotient.to_integer().to_u64() } else { None }
}
