//! Steps in which any subset of the drones may skip its update.

use std::collections::BTreeSet;

use cordon_spec::State;
use cordon_spec::activation::exec_coverage_active;
use cordon_spec::theorems::{Form, Theorem};

use super::region::Region;
use super::{
    Coverage, Extent, SearchResult, SearchSpace, is_conjunction, leaving_start, params,
    violating_start,
};
use crate::certificate::Departure;
use crate::counterexample::Counterexample;
use cordon_core::linear::affine::Affine;
use cordon_core::{Error, Rational, Result, progress};

/// Most drones: every step has 2^(N-2) patterns.
pub const MOST: usize = 12;

/// Most symbolic placements kept at one step: beyond that the search is not complete.
const MOST_PLACEMENTS: usize = 3_000;

/// Searches over all activation patterns of every step.
///
/// # Errors
/// The theorem reads more than one placement, or there are more than [`MOST`] drones.
pub fn search(space: &SearchSpace) -> Result<SearchResult> {
    let number = space.theorem.number();
    if !single_placement(space.theorem, space.form) {
        return Err(Error::input(format!(
            "theorem: `{number}` with skipped updates: expected 7.2, 7.3 or 7.4i"
        )));
    }
    if let Some(count) = space.drones.iter().find(|&&n| n > MOST) {
        return Err(Error::input(format!(
            "drones: `{count}` with skipped updates: expected at most {MOST}"
        )));
    }
    let mut covered = Vec::new();
    for &count in &space.drones {
        let mut open = Vec::new();
        for eps in space.weights_for(count) {
            if kept_by_every_pattern(space, count, &eps) {
                covered.push(Coverage { count, eps, extent: Extent::EveryStartAndStep });
                progress::advance(space.pieces_of_one());
            } else {
                open.push(Patterns::new(space, count, eps));
                progress::advance(1);
            }
        }
        for k in 0..=space.steps {
            for patterns in &mut open {
                if let Some(found) = patterns.at_step(k) {
                    return Ok(SearchResult { found: Some(found), covered });
                }
                progress::advance(1);
            }
        }
        covered.extend(open.into_iter().map(|p| Coverage { count, eps: p.eps, extent: p.extent }));
    }
    Ok(SearchResult { found: None, covered })
}

/// Whether the conclusion is about one placement and made of comparisons.
pub fn single_placement(theorem: Theorem, form: Form) -> bool {
    is_conjunction(theorem) && theorem.span(form, 3) == 0
}

/// All subsets of the internal drones, all of them first, then by number and lexicographic.
fn subsets(count: usize) -> Vec<Vec<usize>> {
    let internal = count - 2;
    let mut all: Vec<Vec<usize>> = (0..1_usize << internal)
        .map(|bits| (0..internal).filter(|i| bits >> i & 1 == 1).map(|i| i + 1).collect())
        .collect();
    all.sort_by_key(|s: &Vec<usize>| (internal - s.len(), s.clone()));
    all
}

fn step(eps: &Rational, placement: &[Affine], active: &[usize]) -> Vec<Affine> {
    let params = params(eps, Affine::constant);
    let state = State { drones: placement.to_vec(), timesteps: 0 };
    exec_coverage_active(&params, &state, |i| active.contains(&i)).drones
}

/// Whether every pattern takes the start set into itself and no start in it is a violation.
fn kept_by_every_pattern(space: &SearchSpace, count: usize, eps: &Rational) -> bool {
    let set = space.theorem.hypothesis(space.form).starts;
    let region = Region::of(set, count);
    let start = region.placement();
    let (violation, complete) =
        violating_start(space.theorem, space.form, set, &region, eps, std::slice::from_ref(&start));
    let kept = |active: &Vec<usize>| {
        leaving_start(set, &region, eps, &[step(eps, &start, active)]).is_none()
    };
    violation.is_none() && complete && subsets(count).iter().all(kept)
}

/// Every placement that patterns can lead to, step after step.
struct Patterns<'q> {
    space: &'q SearchSpace,
    eps: Rational,
    region: Region,
    subsets: Vec<Vec<usize>>,
    /// The distinct placements at the present step with the first pattern that leads there.
    placements: Vec<(Vec<Affine>, Vec<Vec<usize>>)>,
    extent: Extent,
}

impl<'q> Patterns<'q> {
    fn new(space: &'q SearchSpace, count: usize, eps: Rational) -> Self {
        let region = Region::of(space.theorem.hypothesis(space.form).starts, count);
        let placements = vec![(region.placement(), Vec::new())];
        let subsets = subsets(count);
        Self { space, eps, region, subsets, placements, extent: Extent::EveryStart }
    }

    fn at_step(&mut self, k: usize) -> Option<Counterexample> {
        if k > 0 {
            self.advance();
        }
        let (theorem, form) = (self.space.theorem, self.space.form);
        let set = theorem.hypothesis(form).starts;
        for (placement, pattern) in &self.placements {
            let run = std::slice::from_ref(placement);
            let (start, complete) =
                violating_start(theorem, form, set, &self.region, &self.eps, run);
            let Some(start) = start else {
                if !complete {
                    self.extent = Extent::Tried;
                }
                continue;
            };
            let start = self.region.start(&start);
            let departure = Departure::Activation(pattern.clone());
            let found =
                Counterexample::replay_departing(theorem, form, &self.eps, start, k, departure);
            if found.is_some() {
                return found;
            }
            self.extent = Extent::Tried;
        }
        None
    }

    fn advance(&mut self) {
        let mut seen = BTreeSet::new();
        let mut next = Vec::new();
        for (placement, pattern) in &self.placements {
            for active in &self.subsets {
                let after = step(&self.eps, placement, active);
                if !seen.insert(key(&after)) {
                    continue;
                }
                if next.len() == MOST_PLACEMENTS {
                    self.extent = Extent::Tried;
                    self.placements = next;
                    return;
                }
                let mut pattern = pattern.clone();
                pattern.push(active.clone());
                next.push((after, pattern));
            }
        }
        self.placements = next;
    }
}

/// Something ordered that identifies a placement.
fn key(placement: &[Affine]) -> Vec<Vec<Rational>> {
    let flat = |form: &Affine| {
        form.parts().map_or_else(Vec::new, |(constant, coefficients)| {
            std::iter::once(constant).chain(coefficients).cloned().collect()
        })
    };
    placement.iter().map(flat).collect()
}
