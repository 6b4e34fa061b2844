//! One step k of a complete sweep: signs of functionals on generators.

use cordon_spec::placement::{gap, scaled_error, sum};
use cordon_spec::theorems::{Form, StartSet, Theorem, Verdict};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::matrix::ErrorMatrix;
use super::run_from;
use crate::start_sets::{
    Coefficient, Generator, base, generators, negative_at, plus, strictly_positive, targets,
    unit_error, witness,
};
use crate::sweep::config::Item;
use crate::sweep::kernel::{Update, Window, step};
use cordon_core::stencil::Stencil;

type Run = Window<BigInt>;

/// What is known of a theorem at one step, for all starts.
pub(super) enum Decision {
    /// The conclusion holds of every start.
    Holds(Premise),
    /// A condition for that fails.
    Fails {
        /// Starts that may violate the conclusion.
        candidates: Vec<Vec<BigInt>>,
        /// Which condition it is, for the case that none of them does.
        why: &'static str,
    },
}

/// Whether some start meets the conclusion's own premise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Premise {
    Met,
    Never,
    Unknown,
}

impl Premise {
    fn met(met: bool) -> Self {
        if met { Self::Met } else { Self::Never }
    }
}

/// The generators of a work item's start set, stepped along k.
pub(super) struct Decider<'a> {
    item: &'a Item,
    update: Update,
    generators: Vec<Generator>,
    runs: Vec<Run>,
    matrix: ErrorMatrix,
    /// The verdict on the run from all drones at their targets.
    at_targets: Verdict,
    units: Option<Units>,
    /// Whether the step has what all arguments build on ([`lawful`]).
    lawful: bool,
}

/// What 7.7 needs: runs from starts with one drone off its target, by 1 where l is 1.
struct Units {
    starts: Vec<Vec<BigInt>>,
    /// Their runs at the current step.
    runs: Vec<Run>,
    /// The verdicts on their runs from step 0.
    verdicts: Vec<Verdict>,
    /// Whether each leaves the sum for as long as the sharp form says and increases it then.
    rise_in_time: bool,
    /// Whether the printed premise leaves at most one of these errors, alone: no increase at
    /// once and drones 1 and 2 at their targets.
    one_error_left: bool,
}

impl<'a> Decider<'a> {
    pub(super) fn new(item: &'a Item) -> Self {
        let (theorem, form, count) = (item.theorem, item.form, item.drones);
        let stencil = Stencil::of(&item.eps);
        let update = Update::of(&stencil);
        let generators = generators(theorem.hypothesis(form).starts, count);
        let runs = generators.iter().map(|g| run_from(item, &update, &g.placement)).collect();
        let at_targets = run_from(item, &update, &targets(count)).verdict(theorem, form);
        let matrix = ErrorMatrix::of(&item.eps, count);
        let units = (theorem == Theorem::GloballyIncreasing).then(|| Units::new(item, &update));
        let lawful = lawful(&stencil, count);
        Self { item, update, generators, runs, matrix, at_targets, units, lawful }
    }

    pub(super) fn generator_count(&self) -> usize {
        self.generators.len()
    }

    pub(super) fn span(&self) -> usize {
        self.item.theorem.span(self.item.form, self.item.drones)
    }

    /// From step k to step k+1.
    pub(super) fn advance(&mut self) {
        let units = self.units.iter_mut().flat_map(|u| u.runs.iter_mut());
        for run in self.runs.iter_mut().chain(units) {
            run.advance(&self.update);
        }
    }

    /// Decides the current step.
    pub(super) fn decide(&self) -> Decision {
        let count = self.item.drones;
        if !self.lawful {
            return self.search("the step moves the targets, or does not move with a shift");
        }
        match self.item.theorem {
            Theorem::Ordering => self.all((0..count - 1).map(|i| self.gap(i)), true),
            Theorem::UpperBound => self.all((0..count).map(|i| self.error(i)), false),
            Theorem::SumBounded => self.all([self.error_sum()], false),
            Theorem::SumMaximal => self.only_at_targets(&[self.error_sum()]),
            Theorem::SumNonDecreasing => self.all([self.increment(0)], false),
            Theorem::SumStationary | Theorem::TargetsFixed => self.targets_stay(),
            Theorem::ConstantSum => {
                let increments: Vec<_> = (0..self.span()).map(|h| self.increment(h)).collect();
                self.only_at_targets(&increments)
            }
            Theorem::GloballyIncreasing => self.unit_errors_rise(),
            Theorem::Limit => self.contraction(),
        }
    }

    /// A functional on every generator.
    fn values(&self, f: impl Fn(&Run) -> BigInt) -> Vec<BigInt> {
        self.runs.iter().map(f).collect()
    }

    fn gap(&self, i: usize) -> Vec<BigInt> {
        self.values(|run| run.run.first().map_or_else(BigInt::zero, |x| gap(x, i)))
    }

    fn error(&self, i: usize) -> Vec<BigInt> {
        self.values(|run| error_of(run, i))
    }

    fn error_sum(&self) -> Vec<BigInt> {
        self.values(|run| (0..self.item.drones).map(|i| error_of(run, i)).sum())
    }

    fn increment(&self, h: usize) -> Vec<BigInt> {
        self.values(|run| increment_of(run, h))
    }

    /// Every functional >= 0 (or > 0) of every start.
    fn all(&self, functionals: impl IntoIterator<Item = Vec<BigInt>>, strictly: bool) -> Decision {
        let count = self.item.drones;
        for values in functionals {
            if let Some(at) = negative_at(&self.generators, &values) {
                let start = witness(&self.generators, &values, at, count);
                return Decision::Fails {
                    candidates: vec![start],
                    why: "a functional changes its sign",
                };
            }
            if strictly && !strictly_positive(&self.generators, &values) {
                return Decision::Fails {
                    candidates: vec![base(&self.generators, count)],
                    why: "a functional is zero of some start",
                };
            }
        }
        Decision::Holds(Premise::Met)
    }

    /// Functionals, all 0 of a start only if its drones are at their targets at step k.
    fn only_at_targets(&self, functionals: &[Vec<BigInt>]) -> Decision {
        if functionals.iter().any(|f| negative_at(&self.generators, f).is_some()) {
            return self.search("the functionals of the premise are not all of one sign");
        }
        let in_face = |r: usize| functionals.iter().all(|f| f.get(r).is_some_and(Zero::is_zero));
        let mut face = (0..self.generators.len()).filter(|r| in_face(*r));
        let positive = |r: &usize| {
            self.generators.get(*r).is_some_and(|g| g.coefficient == Coefficient::Positive)
        };
        if !(0..self.generators.len()).filter(positive).all(in_face) {
            return Decision::Holds(Premise::Never);
        }
        match face.find(|r| self.moves_errors(*r)) {
            None => Decision::Holds(Premise::Met),
            Some(r) => Decision::Fails {
                candidates: self.along(r, &[1, 2]),
                why: "the premise is met off the targets",
            },
        }
    }

    /// Whether a generator has errors at step k.
    fn moves_errors(&self, r: usize) -> bool {
        let run = self.runs.get(r);
        run.is_some_and(|run| (0..self.item.drones).any(|i| !error_of(run, i).is_zero()))
    }

    /// Starts along a generator.
    fn along(&self, r: usize, times: &[i32]) -> Vec<Vec<BigInt>> {
        let start = base(&self.generators, self.item.drones);
        let Some(g) = self.generators.get(r) else { return vec![start] };
        times.iter().map(|m| plus(&start, &(*m).into(), &g.placement)).collect()
    }

    /// Candidates where no condition points at one.
    fn search(&self, why: &'static str) -> Decision {
        let mut candidates = Vec::new();
        for r in 0..self.generators.len() {
            candidates.extend(self.along(r, &[0, 1, 5, 1000]));
        }
        Decision::Fails { candidates, why }
    }

    /// What is claimed of runs from the targets only.
    fn targets_stay(&self) -> Decision {
        let count = self.item.drones;
        match self.at_targets {
            Verdict::Holds => Decision::Holds(self.targets_reached()),
            _ => Decision::Fails {
                candidates: vec![targets(count)],
                why: "the run from the targets violates it",
            },
        }
    }

    /// Whether some start is at the targets at step k.
    fn targets_reached(&self) -> Premise {
        let starts = self.item.theorem.hypothesis(self.item.form).starts;
        let errors: Vec<_> = (0..self.item.drones).map(|i| self.error(i)).collect();
        let of_one_sign = |f: &Vec<BigInt>| {
            let negated: Vec<_> = f.iter().map(|x| -x).collect();
            [f, &negated].into_iter().any(|f| {
                negative_at(&self.generators, f).is_none() && strictly_positive(&self.generators, f)
            })
        };
        match starts {
            // The targets themselves are a start, and stay (the run from them was looked at).
            StartSet::Any | StartSet::UpperBounded | StartSet::Ordered => Premise::Met,
            StartSet::FirstSubsegment if errors.iter().flatten().all(Zero::is_zero) => Premise::Met,
            // No start of this set is at the targets, and no step takes others there.
            StartSet::FirstSubsegment if self.matrix.is_regular() => Premise::Never,
            StartSet::FirstSubsegment if errors.iter().any(of_one_sign) => Premise::Never,
            StartSet::FirstSubsegment => Premise::Unknown,
        }
    }

    /// 7.7: decided on unit errors where the errors at k have one sign.
    fn unit_errors_rise(&self) -> Decision {
        let starts = self.item.theorem.hypothesis(self.item.form).starts;
        let Some(units) = self.units.as_ref().filter(|_| starts == StartSet::UpperBounded) else {
            return self.search("no complete method for this start set");
        };
        if units.verdicts.iter().any(|v| matches!(v, Verdict::Violated(_))) {
            return Decision::Fails {
                candidates: units.starts.clone(),
                why: "it is violated at step 0, but not by these starts at this step",
            };
        }
        let met = |run: &Run| run.verdict(self.item.theorem, self.item.form) == Verdict::Holds;
        let met = units.runs.iter().any(met);
        let mut errors = (0..self.item.drones).map(|i| self.error(i));
        let of_one_sign = errors.all(|f| negative_at(&self.generators, &f).is_none());
        if of_one_sign && units.rise_in_time {
            return Decision::Holds(Premise::met(met));
        }
        if self.item.form == Form::Paper && units.one_error_left {
            let possible = units.verdicts.contains(&Verdict::Holds);
            return Decision::Holds(match (met, possible) {
                (true, _) => Premise::Met,
                (false, true) => Premise::Unknown,
                (false, false) => Premise::Never,
            });
        }
        self.search("the errors at this step are not all of one sign")
    }

    /// 7.8: decided on the error matrix.
    fn contraction(&self) -> Decision {
        if self.matrix.contracts() && self.matrix.keeps_rate(self.item.form) {
            let moves = (0..self.generators.len()).any(|r| self.moves_errors(r));
            return Decision::Holds(Premise::met(moves));
        }
        let count = self.item.drones;
        let mut candidates = Vec::new();
        for e in self.matrix.stubborn_errors() {
            // All drones at their targets, moved by these errors; where the start set wants
            // it, far enough inside: scaled down against the segment, around its base.
            let errors = (1..count - 1).zip(&e);
            let offset = errors.fold(vec![BigInt::zero(); count], |sum, (i, e)| {
                plus(&sum, e, &unit_error(count, i))
            });
            let largest = e.iter().map(Signed::abs).max().unwrap_or_default();
            let room = (largest + 1) * BigInt::from(2 * count * count);
            candidates.push(plus(&offset, &1.into(), &targets(count)));
            candidates.push(plus(&offset, &room, &base(&self.generators, count)));
        }
        if let Decision::Fails { candidates: more, .. } = self.search("") {
            candidates.extend(more);
        }
        Decision::Fails { candidates, why: "I - A^2 is not positive definite, or the rate fails" }
    }
}

impl Units {
    fn new(item: &Item, update: &Update) -> Self {
        let count = item.drones;
        let starts: Vec<_> = (1..count - 1)
            .map(|j| plus(&targets(count), &1.into(), &unit_error(count, j)))
            .collect();
        let runs: Vec<_> = starts.iter().map(|x| run_from(item, update, x)).collect();
        let verdicts = runs.iter().map(|run| run.verdict(item.theorem, item.form)).collect();
        let sharp = |run: &Run| run.verdict(item.theorem, Form::Sharp) == Verdict::Holds;
        let rise_in_time = runs.iter().all(sharp);
        // Drones 1 and 2 are the first two runs.
        let late = runs.get(2..).unwrap_or_default();
        let silent = late.iter().filter(|run| increment_of(run, 0).is_zero()).count();
        let one_error_left = silent <= 1 && late.len() - silent <= 1;
        Self { starts, runs, verdicts, rise_in_time, one_error_left }
    }
}

/// Whether a step keeps all drones at their targets, wherever the segment is: then errors step
/// to errors, and starts matter up to a shift.
fn lawful(stencil: &Stencil, count: usize) -> bool {
    let here = targets(count);
    let shifted: Vec<_> = here.iter().map(|x| x + 1).collect();
    [here, shifted].into_iter().all(|x| {
        let (Some(min), Some(max)) = (x.first(), x.last()) else { return false };
        let mut after = x.clone();
        step(&Update::of(stencil), min, max, &x, &mut after);
        after.iter().zip(&x).all(|(after, x)| *after == x * &stencil.den)
    })
}

/// N-1 times the error of drone `i` at step k.
fn error_of(run: &Run, i: usize) -> BigInt {
    let (min, max) = (&run.setting.min, &run.setting.max);
    run.run.first().map_or_else(BigInt::zero, |x| scaled_error(min, max, x, i))
}

/// c^{k+h+1} - c^{k+h}.
fn increment_of(run: &Run, h: usize) -> BigInt {
    match run.run.get(h..h + 2) {
        Some([before, after]) => sum::<BigInt>(after) - &sum(before),
        _ => BigInt::zero(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cordon_core::Rational;

    #[test]
    fn only_the_protocols_step_is_lawful() {
        let stencil = Stencil::of(&Rational::new(2.into(), 7.into()));
        assert!(lawful(&stencil, 6));
        let broken = |change: fn(&mut Stencil)| {
            let mut other = stencil.clone();
            change(&mut other);
            !lawful(&other, 6)
        };
        assert!(broken(|s| s.internal.own += 1));
        assert!(broken(|s| {
            s.internal.prec += 1;
            s.internal.own -= 1;
        }));
        assert!(broken(|s| {
            s.internal.min += 1;
            s.internal.own -= 1;
        }));
        assert!(broken(|s| std::mem::swap(&mut s.first, &mut s.last)));
        assert!(broken(|s| s.den += 1));
    }
}
