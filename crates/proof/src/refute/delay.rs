//! Stale messages: each drone sees each neighbour with a delay of its own, constant during the
//! run (PROTOCOL section 2). Before the first message has arrived it sees the start.

use cordon_spec::State;
use cordon_spec::coverage::getx;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::Truth;
use num_traits::One;

use super::activation::single_placement;
use super::conjunction::ways_to_fail;
use super::region::Region;
use super::{
    Coverage, Extent, SearchResult, SearchSpace, params, symbolic_setting, violating_start,
};
use crate::certificate::Departure;
use crate::counterexample::Counterexample;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::{Error, Rational, Result, progress};

/// Most delay patterns at one number of drones and one weight.
const MOST_PATTERNS: usize = 100_000;

/// The links of which the delay matters: from internal drone to internal neighbour, as
/// (who sees, who is seen). The end drones do not move.
fn links(count: usize) -> Vec<(usize, usize)> {
    (1..count.saturating_sub(2)).flat_map(|i| [(i, i + 1), (i + 1, i)]).collect()
}

/// Searches over all delays up to `longest` steps.
///
/// # Errors
/// The theorem reads more than one placement, or there are too many patterns of delays.
pub fn search(space: &SearchSpace, longest: usize) -> Result<SearchResult> {
    if !single_placement(space.theorem, space.form) {
        return Err(Error::input(format!(
            "theorem: `{}` with stale messages: expected 7.2, 7.3 or 7.4i",
            space.theorem.number()
        )));
    }
    let mut covered = Vec::new();
    for &count in &space.drones {
        let weights = space.weights_for(count);
        let (closed, open): (Vec<_>, Vec<_>) =
            weights.into_iter().partition(|eps| kept_whatever_is_seen(space, count, eps));
        let close = |eps| Coverage { count, eps, extent: Extent::EveryStartAndStep };
        progress::advance(closed.len() as u64 * space.pieces_of_one());
        covered.extend(closed.into_iter().map(close));
        if open.is_empty() {
            continue;
        }
        let patterns = patterns(links(count).len(), longest)?;
        let mut best: Option<Counterexample> = None;
        for eps in &open {
            for delays in &patterns {
                let last = match &best {
                    None => space.steps,
                    Some(found) if found.step == 0 => break,
                    Some(found) => found.step - 1,
                };
                best = along(space, count, eps, delays, last).or(best);
            }
            progress::advance(space.pieces_of_one());
        }
        if best.is_some() {
            return Ok(SearchResult { found: best, covered });
        }
        let extent = Extent::EveryStart;
        covered.extend(open.into_iter().map(|eps| Coverage { count, eps, extent }));
    }
    Ok(SearchResult { found: None, covered })
}

/// All delays of the links, the smallest total first.
fn patterns(links: usize, longest: usize) -> Result<Vec<Vec<usize>>> {
    let mut all = vec![Vec::new()];
    for _ in 0..links {
        if all.len().saturating_mul(longest + 1) > MOST_PATTERNS {
            return Err(Error::input(format!(
                "delay: `{longest}` on {links} links: expected at most {MOST_PATTERNS} patterns of delays"
            )));
        }
        let extended = |p: &Vec<usize>| -> Vec<Vec<usize>> {
            (0..=longest).map(|d| p.iter().copied().chain([d]).collect()).collect()
        };
        all = all.iter().flat_map(extended).collect();
    }
    all.sort_by_key(|p: &Vec<usize>| (p.iter().sum::<usize>(), p.clone()));
    Ok(all)
}

/// How old what drone i sees of drone j is in the step from time t.
fn age(links: &[(usize, usize)], delays: &[usize], t: usize, i: usize, j: usize) -> usize {
    let place = links.iter().position(|&link| link == (i, j));
    place.and_then(|p| delays.get(p)).map_or(0, |&d| d.min(t))
}

/// The first counterexample with these delays up to step `last`.
fn along(
    space: &SearchSpace,
    count: usize,
    eps: &Rational,
    delays: &[usize],
    last: usize,
) -> Option<Counterexample> {
    let (theorem, form) = (space.theorem, space.form);
    let set = theorem.hypothesis(form).starts;
    let region = Region::of(set, count);
    let params = params(eps, Affine::constant);
    let links = links(count);
    let mut history: Vec<State<Vec<Affine>>> = Vec::new();
    let mut state = State { drones: region.placement(), timesteps: 0 };
    for k in 0..=last {
        let now = std::slice::from_ref(&state.drones);
        if let (Some(start), _) = violating_start(theorem, form, set, &region, eps, now) {
            let stale = |t: usize| -> Vec<(usize, usize, usize)> {
                let mut list: Vec<_> = links
                    .iter()
                    .map(|&(i, j)| (i, j, age(&links, delays, t, i, j)))
                    .filter(|&(.., age)| age > 0)
                    .collect();
                list.sort_unstable();
                list
            };
            let departure = Departure::Delay((0..k).map(stale).collect());
            let start = region.start(&start);
            let found = Counterexample::replay_departing(theorem, form, eps, start, k, departure);
            if found.is_some() {
                return found;
            }
        }
        history.push(state);
        let present = history.last()?;
        let seen = |i: usize, j: usize| {
            let age = age(&links, delays, k, i, j);
            getx(history.get(k - age).unwrap_or(present), j)
        };
        state = exec_coverage_delayed(&params, present, seen);
    }
    None
}

/// Whether the start set is kept in a step in which every drone sees *any* earlier placements
/// of its neighbours, each from the start set: then it is kept under every pattern of delays,
/// bounded or not, constant or not.
///
/// Every position seen is an indeterminate of its own. That is only tried for sets given by a
/// bound on each drone alone (theorem 7.3, and 7.4 (i) through it).
fn kept_whatever_is_seen(space: &SearchSpace, count: usize, eps: &Rational) -> bool {
    let set = space.theorem.hypothesis(space.form).starts;
    let region = Region::of(set, count);
    let start = region.placement();
    let (violation, complete) =
        violating_start(space.theorem, space.form, set, &region, eps, std::slice::from_ref(&start));
    if violation.is_some() || !complete || region.open {
        return false;
    }
    // Variables: the positions, then what drone i sees of drone i-1, then of drone i+1.
    let internal = count - 2;
    let seen: Vec<Vec<Affine>> = [internal, 2 * internal]
        .iter()
        .map(|from| {
            let own = |i: usize| match i {
                0 => Affine::constant(Rational::from_integer(0.into())),
                i if i + 1 == count => Affine::constant(Rational::one()),
                i => Affine::variable(from + i - 1),
            };
            (0..count).map(own).collect()
        })
        .collect();
    let params = params(eps, Affine::constant);
    let state = State { drones: start, timesteps: 0 };
    let next = exec_coverage_delayed(&params, &state, |i, j| {
        // A position is named after the drone that it is of.
        &seen[usize::from(j > i)][j]
    });
    let setting = symbolic_setting(eps);
    let ways = ways_to_fail(
        &[next.drones],
        |run| run.first().map_or(Truth::Unknown, |x| set.contains(&setting, x)),
        |t| *t == Truth::False,
    );
    let product = region.repeated(3);
    let impossible = |way: &Constraint| {
        debug_assert!(way.sign != Sign::NonNegative);
        product.point_with(way).is_none()
    };
    ways.iter().all(impossible)
}
