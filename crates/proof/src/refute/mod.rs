//! The search for counterexamples: the smallest one, or the statement that there is none.
//!
//! For a fixed number of drones, weight and step, the placement is an affine function of the start, so
//! that extreme starts decide the linear theorems: if no counterexample is found there, none exists
//! from any start. If moreover a step maps the start set into itself, the same holds at every step.

mod conjunction;
pub mod departing;
mod energy;
mod exhaustive;
mod region;

use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, StartSet, Theorem, Truth, Verdict};
use cordon_spec::{Params, State};
use num_traits::{One, Zero};

use crate::counterexample::Counterexample;
use crate::symbolic::Symbol;
use conjunction::ways_to_fail;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::Sign;
use cordon_core::{Rational, progress};
use region::Region;

/// The space searched for counterexamples: swarms, weights, steps.
#[derive(Clone, Debug)]
pub struct SearchSpace {
    /// The theorem that is to be violated.
    pub theorem: Theorem,
    /// The form whose starts and conclusion are used: as printed, or sharp.
    pub form: Form,
    /// Numbers of drones, ascending.
    pub drones: Vec<usize>,
    /// Weights, the simplest first.
    pub weights: Vec<Rational>,
    /// Whether to search weights outside the theorem's own range as well.
    pub any_weight: bool,
    /// Last step examined.
    pub steps: usize,
}

impl SearchSpace {
    /// The weights to search for a number of drones.
    fn weights_for(&self, count: usize) -> Vec<Rational> {
        let range = self.theorem.hypothesis(self.form).weights;
        let searched = |eps: &&Rational| {
            let [num, den] = [eps.numer(), eps.denom()].map(|x| Rational::from_integer(x.clone()));
            self.any_weight || range.contains(&num, &den, count).is_true()
        };
        self.weights.iter().filter(searched).cloned().collect()
    }

    /// The number of pieces of work of the search, as counted in [`progress`]: for each number of
    /// drones and weight one, plus one for each step.
    pub fn pieces(&self) -> u64 {
        let weights = self.drones.iter().map(|&count| self.weights_for(count).len());
        weights.sum::<usize>() as u64 * self.pieces_of_one()
    }

    /// Whether the search usually takes more than a few seconds: conclusions that are not conjunctions
    /// of comparisons are decided by trying combinations.
    pub fn is_long(&self) -> bool {
        let most = self.drones.iter().max().copied().unwrap_or_default();
        let combined = !is_conjunction(self.theorem) && self.theorem != Theorem::Limit;
        (combined && most > 11) || self.pieces() > 100_000
    }

    fn pieces_of_one(&self) -> u64 {
        self.steps as u64 + 2
    }
}

/// How far the absence of a counterexample is established.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Extent {
    /// None was found for some starts, up to the last step.
    Tried,
    /// None exists from any start up to the last step.
    EveryStart,
    /// None exists from any start at any step.
    EveryStartAndStep,
}

/// A region of the search without a counterexample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage {
    /// Number of drones, at least 3.
    pub count: usize,
    /// The weight of the update.
    pub eps: Rational,
    /// The extent to which a counterexample is excluded.
    pub extent: Extent,
}

/// The result of a search.
#[derive(Clone, Debug)]
pub struct SearchResult {
    /// The smallest counterexample, by number of drones, then step, then weight.
    pub found: Option<Counterexample>,
    /// The regions without one: everything, or all smaller numbers of drones.
    pub covered: Vec<Coverage>,
}

/// Searches for the smallest counterexample: fewest drones first, then the earliest step.
pub fn search(space: &SearchSpace) -> SearchResult {
    let mut covered = Vec::new();
    for &count in &space.drones {
        let mut open = Vec::new();
        for eps in space.weights_for(count) {
            if impossible_at_every_step(space.theorem, space.form, count, &eps) {
                covered.push(Coverage { count, eps, extent: Extent::EveryStartAndStep });
                progress::advance(space.pieces_of_one());
            } else {
                open.push(Search::new(space, count, eps));
                progress::advance(1);
            }
        }
        for k in 0..=space.steps {
            for search in &mut open {
                if let Some(found) = search.at_step(k) {
                    return SearchResult { found: Some(found), covered };
                }
                progress::advance(1);
            }
        }
        covered.extend(open.into_iter().map(Search::covered));
    }
    SearchResult { found: None, covered }
}

/// Most drones that [`evident`] tries: the printed 7.7 needs one off its target with index 3.
const EVIDENT_DRONES: usize = 5;

/// A counterexample that is cheap to find: up to 5 drones (or the given number, if smaller), at the
/// ends and the middle of the weights (by default those of \[0, 1\] that are in the theorem's own
/// range), up to step 2. Worth a try before searching for a proof.
pub fn evident(
    theorem: Theorem,
    form: Form,
    drones: Option<usize>,
    weights: Option<&(Rational, Rational)>,
) -> Option<Counterexample> {
    let fewest = drones.unwrap_or(3);
    let most = drones.unwrap_or(EVIDENT_DRONES).min(EVIDENT_DRONES);
    let (from, to) = weights.cloned().unwrap_or((Rational::zero(), Rational::one()));
    let middle = (&from + &to) / Rational::from_integer(2.into());
    let space = SearchSpace {
        theorem,
        form,
        drones: (fewest..=most).collect(),
        weights: vec![from, to, middle],
        any_weight: weights.is_some(),
        steps: 2,
    };
    search(&space).found
}

/// The search for one number of drones and one weight, step by step.
struct Search<'q> {
    space: &'q SearchSpace,
    eps: Rational,
    region: Region,
    run: SymbolicRun,
    extent: Extent,
}

impl<'q> Search<'q> {
    fn new(space: &'q SearchSpace, count: usize, eps: Rational) -> Self {
        let region = Region::of(space.theorem.hypothesis(space.form).starts, count);
        let run = SymbolicRun::new(&region, &eps);
        Self { space, eps, region, run, extent: Extent::EveryStart }
    }

    fn at_step(&mut self, k: usize) -> Option<Counterexample> {
        let (theorem, form) = (self.space.theorem, self.space.form);
        let (start, complete) = if theorem == Theorem::Limit {
            (energy::violating_start(form, &self.region, &self.eps, k), false)
        } else {
            let span = theorem.span(form, self.region.count);
            let placements = self.run.placements(k, span);
            let set = theorem.hypothesis(form).starts;
            violating_start(theorem, form, set, &self.region, &self.eps, placements)
        };
        if !complete {
            self.extent = Extent::Tried;
        }
        let start = self.region.start(&start?);
        // The spec decides; a start that it does not confirm is not a counterexample, and the search is
        // then incomplete.
        let found = Counterexample::replay(theorem, form, &self.eps, start, k);
        if found.is_none() {
            self.extent = Extent::Tried;
        }
        found
    }

    fn covered(self) -> Coverage {
        Coverage { count: self.region.count, eps: self.eps, extent: self.extent }
    }
}

/// The placements X^0, X^1, ... as forms in the start.
struct SymbolicRun {
    params: Params<Affine>,
    placements: Vec<Vec<Affine>>,
}

impl SymbolicRun {
    fn new(region: &Region, eps: &Rational) -> Self {
        Self { params: params(eps, Affine::constant), placements: vec![region.placement()] }
    }

    /// The placements X^k to X^{k+span}.
    fn placements(&mut self, k: usize, span: usize) -> &[Vec<Affine>] {
        while self.placements.len() <= k + span {
            let drones = self.placements.last().cloned().unwrap_or_default();
            let next = exec_coverage(&self.params, &State { drones, timesteps: 0 });
            self.placements.push(next.drones);
        }
        self.placements.get(k..=k + span).unwrap_or_default()
    }
}

/// Parameters on the segment \[0, 1\].
fn params<S>(eps: &Rational, scalar: impl Fn(Rational) -> S) -> Params<S> {
    Params {
        min: scalar(Rational::zero()),
        max: scalar(Rational::one()),
        eps: scalar(eps.clone()),
        n: 0,
    }
}

fn symbolic_setting(eps: &Rational) -> Setting<Symbol<Affine>> {
    Setting::from(&params(eps, |x| Symbol::constant(Affine::constant(x))))
}

/// Whether the conclusion is a conjunction of comparisons, each of which can be violated on its own.
fn is_conjunction(theorem: Theorem) -> bool {
    matches!(
        theorem,
        Theorem::Ordering | Theorem::UpperBound | Theorem::SumBounded | Theorem::SumNonDecreasing
    )
}

/// A start of the set, given by its region, from which the conclusion is violated on the placements,
/// and whether finding none would be conclusive.
fn violating_start(
    theorem: Theorem,
    form: Form,
    set: StartSet,
    region: &Region,
    eps: &Rational,
    placements: &[Vec<Affine>],
) -> (Option<Vec<Rational>>, bool) {
    let setting = symbolic_setting(eps);
    let conclusion = |run: &[Vec<Symbol<Affine>>]| theorem.conclusion(form, &setting, run);
    if is_conjunction(theorem) {
        let is_false = |v: &Verdict| matches!(v, Verdict::Violated(_));
        let mut ways = ways_to_fail(placements, conclusion, is_false);
        // Drones that cross are a clearer violation than drones that meet.
        ways.sort_by_key(|way| way.sign == Sign::Zero);
        (ways.iter().find_map(|way| region.point_with(way)), true)
    } else {
        exhaustive::violation(set, region, &setting, placements, conclusion)
    }
}

/// Whether no counterexample exists at this weight from any start at any step, because a set that
/// contains the starts is kept by a step and contains no violation.
fn impossible_at_every_step(theorem: Theorem, form: Form, count: usize, eps: &Rational) -> bool {
    if theorem == Theorem::Limit {
        return energy::always_falls(form, count, eps);
    }
    let starts = theorem.hypothesis(form).starts;
    let supersets = match starts {
        StartSet::FirstSubsegment => {
            vec![StartSet::Ordered, StartSet::UpperBounded, StartSet::Any]
        }
        StartSet::Ordered | StartSet::UpperBounded => vec![starts, StartSet::Any],
        StartSet::Any => vec![StartSet::Any],
    };
    supersets.into_iter().any(|set| {
        let region = Region::of(set, count);
        let mut run = SymbolicRun::new(&region, eps);
        let span = theorem.span(form, count);
        let (start, complete) =
            violating_start(theorem, form, set, &region, eps, run.placements(0, span));
        start.is_none()
            && complete
            && leaving_start(set, &region, eps, run.placements(1, 0)).is_none()
    })
}

/// A start in the region from which the placement is outside the start set.
fn leaving_start(
    set: StartSet,
    region: &Region,
    eps: &Rational,
    placement: &[Vec<Affine>],
) -> Option<Vec<Rational>> {
    let setting = symbolic_setting(eps);
    let contains = |run: &[Vec<Symbol<Affine>>]| {
        run.first().map_or(Truth::Unknown, |x| set.contains(&setting, x))
    };
    let ways = ways_to_fail(placement, contains, |t| *t == Truth::False);
    ways.iter().find_map(|way| region.point_with(way))
}
