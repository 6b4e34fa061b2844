//! Theorems 7.2 to 7.8 as predicates, in the paper's form and in the sharp form.
//!
//! A theorem is a [`Hypothesis`] (which weights, which starts) and a conclusion about a *run*:
//! successive placements X^k, X^{k+1}, ... of which the conclusion reads [`Theorem::span`]
//! beyond the first. Sweeps, model checker and refutation search all call these functions;
//! nothing else states the theorems.
//!
//! The predicates are free of division and homogeneous in the positions: multiplying `min`,
//! `max` and every position by the same positive scalar changes no answer. A caller may
//! therefore evaluate them on integers over a common denominator.

mod fixed_point;
mod hypothesis;
mod increasing;
mod limit;
mod non_decreasing;
mod ordering;
mod sum;
mod upper_bound;
mod verdict;

pub use hypothesis::{Hypothesis, StartSet, WeightRange};
pub use non_decreasing::telescoping_residual;
pub use upper_bound::{above_targets, in_box};
pub use verdict::{Subject, Truth, Verdict, Violation};

#[cfg(feature = "contracts")]
use creusot_std::prelude::{Clone, PartialEq};

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::{DroneMap, Ordered, Params, Scalar};

/// What the theorems speak about: the segment's ends, and the weight as a quotient, so that
/// positions and weight may be measured in different units.
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct Setting<S> {
    /// Left end of the segment.
    pub min: S,
    /// Right end of the segment, above `min`.
    pub max: S,
    /// Numerator of the weight eps.
    pub eps_num: S,
    /// Denominator of the weight eps, positive.
    pub eps_den: S,
}

impl<S: Scalar> From<&Params<S>> for Setting<S> {
    #[cfg_attr(feature = "contracts", ensures(exact::<S>() ==> result.model().eps == p.eps.model() && result.min.model() == p.min.model() && result.max.model() == p.max.model()))]
    fn from(p: &Params<S>) -> Self {
        Self {
            min: p.min.clone(),
            max: p.max.clone(),
            eps_num: p.eps.clone(),
            eps_den: S::from_int(1),
        }
    }
}

/// Which reading of a theorem is meant.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(not(creusot), derive(Debug, Eq, PartialOrd, Ord, Hash))]
#[cfg_attr(creusot, derive(DeepModel))]
pub enum Form {
    /// As printed in the paper's section 7.
    Paper,
    /// Under the weakest known hypothesis (PROTOCOL section 2).
    Sharp,
}

impl Form {
    /// Both forms, the paper's first.
    pub const ALL: [Self; 2] = [Self::Paper, Self::Sharp];

    /// The form in a word.
    #[cfg_attr(feature = "contracts", trusted)]
    pub fn label(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Sharp => "sharp",
        }
    }
}

/// A theorem of the paper's section 7, its parts apart.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq, PartialOrd, Ord, Hash))]
pub enum Theorem {
    /// 7.2: drones never cross.
    Ordering,
    /// 7.3: no drone passes its target.
    UpperBound,
    /// 7.4 (i): the sum of the positions is bounded.
    SumBounded,
    /// 7.4 (ii): the bound is met exactly at the targets.
    SumMaximal,
    /// 7.5 (i): the sum never decreases.
    SumNonDecreasing,
    /// 7.5 (ii): at the targets the sum stays for a step.
    SumStationary,
    /// 7.6 (i): at the targets the sum stays for ever.
    TargetsFixed,
    /// 7.6 (ii): a constant sum means that all drones are at their targets.
    ConstantSum,
    /// 7.7: off the targets the sum will increase.
    GloballyIncreasing,
    /// 7.8: every drone converges to its target.
    Limit,
}

impl Theorem {
    /// Every theorem, in the paper's order.
    pub const ALL: [Self; 10] = [
        Self::Ordering,
        Self::UpperBound,
        Self::SumBounded,
        Self::SumMaximal,
        Self::SumNonDecreasing,
        Self::SumStationary,
        Self::TargetsFixed,
        Self::ConstantSum,
        Self::GloballyIncreasing,
        Self::Limit,
    ];

    /// The paper's number, with the part: `7.4i`.
    #[cfg_attr(feature = "contracts", trusted)]
    pub fn number(self) -> &'static str {
        match self {
            Self::Ordering => "7.2",
            Self::UpperBound => "7.3",
            Self::SumBounded => "7.4i",
            Self::SumMaximal => "7.4ii",
            Self::SumNonDecreasing => "7.5i",
            Self::SumStationary => "7.5ii",
            Self::TargetsFixed => "7.6i",
            Self::ConstantSum => "7.6ii",
            Self::GloballyIncreasing => "7.7",
            Self::Limit => "7.8",
        }
    }

    /// Which weights and starts the theorem is about, in the given form.
    pub fn hypothesis(self, form: Form) -> Hypothesis {
        use StartSet::{Any, FirstSubsegment, Ordered, UpperBounded};
        use WeightRange as W;
        let (paper, sharp) = match self {
            Self::Ordering => ((W::BelowThird, Ordered), (W::UpToHalfOrOne, Ordered)),
            Self::UpperBound | Self::SumBounded | Self::SumMaximal | Self::SumNonDecreasing => {
                ((W::BelowHalf, FirstSubsegment), (W::UpToHalf, UpperBounded))
            }
            Self::SumStationary => ((W::Unit, FirstSubsegment), (W::Any, Any)),
            Self::TargetsFixed => ((W::BelowThird, FirstSubsegment), (W::Any, Any)),
            Self::ConstantSum => {
                ((W::BelowThird, FirstSubsegment), (W::PositiveUpToHalf, UpperBounded))
            }
            // Under assumption 3 the printed premise is never met.
            Self::GloballyIncreasing => {
                ((W::Unit, UpperBounded), (W::PositiveUpToHalf, UpperBounded))
            }
            Self::Limit => ((W::Unit, FirstSubsegment), (W::BelowCritical, Any)),
        };
        let (weights, starts) = match form {
            Form::Paper => paper,
            Form::Sharp => sharp,
        };
        Hypothesis { weights, starts }
    }

    /// How many placements beyond X^k the conclusion about step k reads, for `count` drones.
    ///
    /// Statements about *all* later steps are decided by finitely many: the increments of the
    /// sum obey a linear recurrence of order N-2 (Cayley-Hamilton on the internal drones), so
    /// N-2 zeros in a row mean zeros for ever.
    #[cfg_attr(feature = "contracts", ensures(result@ == steps_read(self, form, count@)))]
    pub fn span(self, form: Form, count: usize) -> usize {
        let internal = count.saturating_sub(2).max(1);
        match (self, form) {
            (Self::Ordering | Self::UpperBound | Self::SumBounded | Self::SumMaximal, _) => 0,
            (Self::SumNonDecreasing | Self::SumStationary | Self::Limit, _) => 1,
            (Self::TargetsFixed | Self::ConstantSum, Form::Paper) => internal,
            (Self::TargetsFixed | Self::ConstantSum, Form::Sharp) => internal.div_ceil(2),
            // An increase between steps k+1 and k+1+(N-2), or never.
            (Self::GloballyIncreasing, Form::Paper) => internal + 1,
            // h + 1 for the largest h: the drone nearest the middle.
            (Self::GloballyIncreasing, Form::Sharp) => count.saturating_sub(1) / 2,
        }
    }

    /// Whether the conclusion holds of the run `X^k, X^{k+1}, ...`, at least `span + 1`
    /// placements of N >= 3 drones each. Of a shorter run nothing is said: `Undecided`.
    #[cfg_attr(feature = "contracts", requires(exact::<S>() && forall<h> 0 <= h && h < run@.len() ==> run@[h].seq().len() == run@[0].seq().len()))]
    #[cfg_attr(feature = "contracts", requires(run@.len() > 0 ==> run@[0].seq().len() >= 3 && run@[0].seq().len() * run@[0].seq().len() <= usize::MAX@))]
    #[cfg_attr(feature = "contracts", ensures(decides(result, concludes(self, form, *setting, run@))))]
    pub fn conclusion<S: Ordered, M: DroneMap<S>>(
        self,
        form: Form,
        setting: &Setting<S>,
        run: &[M],
    ) -> Verdict {
        let Some(now) = run.first() else {
            return Verdict::Undecided;
        };
        let now = now.as_ref();
        let Some(later) = run.get(1..=self.span(form, now.len())) else {
            return Verdict::Undecided;
        };
        match self {
            Self::Ordering => ordering::conclusion(now),
            Self::UpperBound => upper_bound::conclusion(setting, now),
            Self::SumBounded => sum::bounded(setting, now),
            Self::SumMaximal => sum::maximal(setting, now),
            Self::SumNonDecreasing => non_decreasing::conclusion(now, later),
            Self::SumStationary => non_decreasing::stationary(setting, now, later),
            Self::TargetsFixed => fixed_point::targets_fixed(form, setting, now, later),
            Self::ConstantSum => fixed_point::constant_sum(setting, now, later),
            Self::GloballyIncreasing if form == Form::Paper => {
                increasing::as_printed(setting, now, later)
            }
            Self::GloballyIncreasing => increasing::exact(setting, now, later),
            Self::Limit => limit::conclusion(form, setting, now, later),
        }
    }
}
