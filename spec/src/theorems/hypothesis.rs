//! Which weights and which starts a theorem is about.

#[cfg(feature = "contracts")]
use creusot_std::prelude::Clone;

#[cfg(feature = "contracts")]
use crate::model::*;

use super::Setting;
use super::verdict::{Truth, at_most, equal, less};
use crate::Ordered;
use crate::placement::{gaps, scaled_error};

/// The hypothesis of a theorem: a range of weights and a set of starts.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct Hypothesis {
    /// The weights eps that the theorem is about.
    pub weights: WeightRange,
    /// The starts X^0 that the theorem is about.
    pub starts: StartSet,
}

impl Hypothesis {
    /// Whether weight and start meet the hypothesis. `start` has one position a drone, N >= 3.
    #[cfg_attr(feature = "contracts", requires(exact::<S>()))]
    #[cfg_attr(feature = "contracts", ensures(says(result, weighs(self.weights, setting.eps_num.model(), setting.eps_den.model(), start@.len()) && starts(self.starts, setting.model(), reals(start@)))))]
    pub fn met_by<S: Ordered>(&self, setting: &Setting<S>, start: &[S]) -> Truth {
        let weight = self.weights.contains(&setting.eps_num, &setting.eps_den, start.len());
        weight.and(self.starts.contains(setting, start))
    }
}

/// A range of weights eps, for N drones.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub enum WeightRange {
    /// Any weight at all.
    Any,
    /// `0 <= eps <= 1`: the paper's definition 6.
    Unit,
    /// `0 <= eps < 1/3`.
    BelowThird,
    /// `0 <= eps < 1/2`.
    BelowHalf,
    /// `0 <= eps <= 1/2`.
    UpToHalf,
    /// `0 <= eps <= 1/2`; for three drones `0 <= eps <= 1`.
    UpToHalfOrOne,
    /// `0 < eps <= 1/2`.
    PositiveUpToHalf,
    /// `0 < eps < eps*_N = 1/(1 + cos(pi/(N-1)))`.
    BelowCritical,
}

impl WeightRange {
    /// Whether the weight `num/den` (`den > 0`) is in the range for `count >= 3` drones.
    ///
    /// [`Self::BelowCritical`] multiplies N-2 times by numbers of the size of `den`: scalars
    /// of limited range have to allow for that.
    #[cfg_attr(feature = "contracts", requires(exact::<S>()))]
    #[cfg_attr(feature = "contracts", ensures(says(result, weighs(self, num.model(), den.model(), count@))))]
    pub fn contains<S: Ordered>(self, num: &S, den: &S, count: usize) -> Truth {
        let zero = S::from_int(0);
        let nonnegative = || at_most(&zero, num);
        let times = |n: i32| S::from_int(n) * num;
        match self {
            Self::Any => Truth::True,
            Self::Unit => nonnegative().and(at_most(num, den)),
            Self::BelowThird => nonnegative().and(less(&times(3), den)),
            Self::BelowHalf => nonnegative().and(less(&times(2), den)),
            Self::UpToHalf => nonnegative().and(at_most(&times(2), den)),
            Self::UpToHalfOrOne if count == 3 => nonnegative().and(at_most(num, den)),
            Self::UpToHalfOrOne => nonnegative().and(at_most(&times(2), den)),
            Self::PositiveUpToHalf => less(&zero, num).and(at_most(&times(2), den)),
            Self::BelowCritical => less(&zero, num).and(below_critical(num, den, count)),
        }
    }
}

/// Whether `num/den < 1/(1 + cos(pi/(N-1)))`, without the cosine.
///
/// The errors of the internal drones obey e' = A e with A = tridiag(eps, 1-2eps, eps), whose
/// least eigenvalue is 1 - 2eps(1 + cos(pi/(N-1))). It is above -1 exactly when I + A is
/// positive definite, that is when all leading minors of den*(I + A) are positive (Sylvester);
/// for a tridiagonal matrix they obey a three-term recurrence.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, minors_positive(num.model(), den.model(), count@ - 2))))]
fn below_critical<S: Ordered>(num: &S, den: &S, count: usize) -> Truth {
    let zero = S::from_int(0);
    let two = S::from_int(2);
    let diagonal = two.clone() * den - &(two * num);
    let off_squared = num.clone() * num;
    let (mut before, mut minor) = (zero.clone(), S::from_int(1));
    let mut answer = Truth::True;
    #[cfg_attr(creusot, invariant(minors_are(*num, *den, produced.len(), minor, before)))]
    #[cfg_attr(creusot, invariant(says(answer, minors_positive(num.model(), den.model(), produced.len()))))]
    for _ in 0..count.saturating_sub(2) {
        #[cfg(creusot)]
        let k = snapshot!(produced.len() - 1);
        #[cfg(creusot)]
        proof_assert!(*k >= 0 && minors_are(*num, *den, *k, minor, before));
        #[cfg(creusot)]
        proof_assert!(one_minor_more(*num, *den, *k, diagonal, off_squared, minor, before));
        let next = diagonal.clone() * &minor - &(off_squared.clone() * &before);
        (before, minor) = (minor, next);
        answer = answer.and(less(&zero, &minor));
    }
    answer
}

/// A set of starts. In each of them drones 0 and N-1 are at min and max (assumption 1).
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub enum StartSet {
    /// The internal drones anywhere.
    Any,
    /// Strictly ordered (assumption 2).
    Ordered,
    /// Strictly ordered, the internal drones before min + l (assumptions 2 and 3).
    FirstSubsegment,
    /// No drone beyond its target: X_i <= T_i (UB), which assumptions 2 and 3 imply.
    UpperBounded,
}

impl StartSet {
    /// Whether the start is in the set. It has one position a drone, N >= 3.
    #[cfg_attr(feature = "contracts", requires(exact::<S>()))]
    #[cfg_attr(feature = "contracts", ensures(says(result, starts(self, setting.model(), reals(start@)))))]
    pub fn contains<S: Ordered>(self, setting: &Setting<S>, start: &[S]) -> Truth {
        let anchored = match (start.first(), start.last()) {
            (Some(first), Some(last)) if start.len() > 1 => {
                equal(first, &setting.min).and(equal(last, &setting.max))
            }
            _ => Truth::False,
        };
        anchored.and(match self {
            Self::Any => Truth::True,
            Self::Ordered => ordered(start),
            Self::FirstSubsegment => ordered(start).and(in_first_subsegment(setting, start)),
            Self::UpperBounded => upper_bounded(setting, start),
        })
    }
}

/// X_i < X_{i+1} for all i.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, in_order(reals(x@)))))]
fn ordered<S: Ordered>(x: &[S]) -> Truth {
    Truth::all(x.len().saturating_sub(1), |i| less(&x[i], &x[i + 1]))
}

/// X_i < min + l for every internal i, multiplied by N-1.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, before_first_target(setting.model(), reals(x@)))))]
fn in_first_subsegment<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Truth {
    let scale = gaps::<S>(x);
    let bound = scale.clone() * &setting.min + &(setting.max.clone() - &setting.min);
    Truth::all(x.len().saturating_sub(2), |i| less(&(scale.clone() * &x[i + 1]), &bound))
}

/// X_i <= T_i for every i.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, behind(setting.model(), reals(x@)))))]
fn upper_bounded<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Truth {
    let zero = S::from_int(0);
    Truth::all(x.len(), |i| at_most(&zero, &scaled_error(&setting.min, &setting.max, x, i)))
}

/// X_i = T_i for every i.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, reach_targets(setting.model(), reals(x@)))))]
pub(super) fn at_targets<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Truth {
    Truth::all(x.len(), |i| at_target(setting, x, i))
}

/// X_i = T_i: drone `i` is at its target.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < x@.len()))]
#[cfg_attr(feature = "contracts", ensures(says(result, error(setting.min.model(), setting.max.model(), reals(x@), i@) == int(0))))]
pub(super) fn at_target<S: Ordered>(setting: &Setting<S>, x: &[S], i: usize) -> Truth {
    equal(&scaled_error(&setting.min, &setting.max, x, i), &S::from_int(0))
}
