//! Sweeps that decide a theorem for all real starts at once.
//!
//! For given N, eps and k everything that the theorems 7.2 to 7.7 speak of (gaps, errors,
//! differences of sums at steps k, k+1, ...) is a linear functional of the start, and each
//! start set is spanned by finitely many generators with independent coefficients
//! ([`start_sets`](crate::start_sets)). Stepping the generators exactly and looking at signs therefore decides:
//!
//! * **7.2, 7.3, 7.4 (i), 7.5 (i)**: every gap > 0, every error >= 0, the sum of the errors
//!   >= 0, the increment of the sum >= 0, by the criteria of [`start_sets`](crate::start_sets), strictness included.
//! * **7.4 (ii)**: if the sum of the errors at k is >= 0 of every start, it is 0 exactly on the
//!   combinations of those generators where it is 0 (a face). There every error has to be 0,
//!   hence on each of these generators. The other direction is an identity.
//! * **7.5 (ii), 7.6 (i)**: the premise leaves one placement up to scale, all drones at their
//!   targets, and the conclusion is about what follows from it: one run decides.
//! * **7.6 (ii)**: if every increment of the sum over the span is >= 0, a constant sum means
//!   that all of them are 0, again a face; the errors at k have to be 0 on it.
//! * **7.7, sharp**: let the errors at k be >= 0 of every start, as 7.3 says. The increments
//!   c^{k+h+1} - c^{k+h} are linear in these errors. If a unit error of drone j leaves the sum
//!   until h = min(j, N-1-j) - 1 and increases it then, for each j, then nonnegative errors do
//!   so with the least h among the drones that are off their targets: the terms before that h
//!   are all 0, at that h some are positive and none is negative. So the runs from unit errors
//!   decide, k by k, by the sign of the errors there.
//! * **7.7, printed**: the premise (no increase at once, first drone off target at 3 or later)
//!   puts that least h at 1 or more, so that the sharp form's argument gives the increase. Where
//!   the errors at k have either sign (eps > 1/2), it is decided if the premise leaves a single
//!   unit error: errors of drones 3 and on that leave the sum at once, one of which cannot
//!   balance another.
//! * **7.8**: e' = A e with A symmetric, and the squared errors fall from every e but 0 iff
//!   I - A^2 is positive definite, decided on its leading minors; the rate follows from
//!   |A| w <= (1 - 8 eps/(N-1)^2) w ([`matrix`]).
//!
//! All this needs a step under which errors step to errors whatever the shift; that is checked
//! too, not assumed.
//!
//! Where a condition fails, a concrete start is built from the generators and the spec's own
//! predicate decides whether it violates the conclusion: only then is the theorem refuted.
//! Where neither is so the case is undecided, and the finding says why.

mod decide;
mod matrix;

use cordon_spec::theorems::{Setting, Verdict};
use num_bigint::BigInt;
use num_traits::Zero;

use super::config::Item;
use super::finding::{Counts, Finding, Witness};
use super::kernel::{Update, Window};
use super::run::starts;
use cordon_core::stencil::Stencil;
use cordon_core::{Evidence, Rational};
use decide::{Decider, Decision, Premise};

/// Decides a work item for all starts and the steps `0 ..= steps`.
pub fn complete(item: &Item, steps: usize) -> Finding {
    let mut decider = Decider::new(item);
    let mut counts = Counts { starts: decider.generator_count() as u64, ..Counts::default() };
    let mut counterexample = None;
    let mut undecided = None;
    let mut unknown_premise = None;
    for k in 0..=steps {
        if k > 0 {
            decider.advance();
        }
        counts.cases += 1;
        match decider.decide() {
            Decision::Holds(premise) => match premise {
                Premise::Met => counts.non_vacuous += 1,
                Premise::Never => {}
                Premise::Unknown => {
                    unknown_premise.get_or_insert(format!(
                        "step {k}: it is not known whether some start meets the premise"
                    ));
                }
            },
            Decision::Fails { candidates, why } => {
                match candidates.into_iter().find(|start| violates(item, k, start)) {
                    Some(start) => {
                        counts.violations += 1;
                        counts.non_vacuous += 1;
                        let start = start.into_iter().map(Rational::from_integer).collect();
                        counterexample = counterexample.or_else(|| item.refuted_by(start, k));
                    }
                    None => {
                        counts.undecided += 1;
                        undecided.get_or_insert(format!("step {k}: {why}"));
                    }
                }
            }
        }
    }
    let updates = decider.generator_count() * item.drones * (steps + decider.span());
    counts.updates = updates as u64;
    let reason = undecided.or(unknown_premise);
    let evidence = Evidence::CompleteForAllStarts;
    let counterexample = counterexample.as_ref().map(Witness::from);
    Finding { counterexample, reason, ..Finding::new(item, evidence, counts) }
}

/// Whether the spec's predicates say that a placement is a start and that its run violates the
/// conclusion about step k.
fn violates(item: &Item, k: usize, start: &[BigInt]) -> bool {
    let update = Update::of(&Stencil::of(&item.eps));
    let mut run = run_from(item, &update, start);
    let admitted = run.setting.min < run.setting.max
        && run.run.first().is_some_and(|x| starts(item).contains(&run.setting, x).is_true());
    if !admitted {
        return false;
    }
    for _ in 0..k {
        run.advance(&update);
    }
    matches!(run.verdict(item.theorem, item.form), Verdict::Violated(_))
}

/// The run from a placement that need not be a start; the segment is from its first drone to
/// its last.
fn run_from(item: &Item, update: &Update, placement: &[BigInt]) -> Window<BigInt> {
    let end = |x: Option<&BigInt>| x.cloned().unwrap_or_else(BigInt::zero);
    let setting = Setting {
        min: end(placement.first()),
        max: end(placement.last()),
        eps_num: item.eps.numer().clone(),
        eps_den: item.eps.denom().clone(),
    };
    let span = item.theorem.span(item.form, item.drones);
    Window::new(setting, placement.to_vec(), span, update)
}
