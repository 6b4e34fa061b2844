//! The claims of a system tried from every start on a grid.
//!
//! The grid divides the range that each variable has in the start set into equal parts; of its points
//! those are starts that meet the assumptions. From each of them every run is followed: whichever mode acts,
//! and whatever varies at either end of its range.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, Zero};

use super::bounds::greatest;
use super::{PROOF, at};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::simplex::Work;
use cordon_core::system::{Map, Parameter, Schedule, System};
use cordon_core::{Error, Rational, Result};

/// Most starts on a grid.
pub const MOST_STARTS: usize = 100_000;

/// Most comparisons with the assumptions, of points of the grid and beginnings of points.
const MOST_COMPARISONS: u64 = 5_000_000;

/// Most images of states in all runs together: a state has one for each mode and corner that may act.
pub const MOST_STEPS: u64 = 400_000;

/// What fails from a start on the grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The constants.
    pub values: Vec<Rational>,
    /// The whole state at the start.
    pub start: Vec<Rational>,
    /// The step at which the claim fails.
    pub step: usize,
}

/// What was tried.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tried {
    /// Starts on the grid.
    pub starts: usize,
    /// States of their runs, the same state at the same step of the same run once.
    pub states: u64,
    /// Of each claim that fails, by its place, where it does so at the smallest step.
    pub failures: BTreeMap<usize, Failure>,
}

/// Tries every start on the grid with `parts` parts a variable, at these values of the constants, in
/// steps 0 to `steps`.
///
/// # Errors
/// The start set has no bound, or there are more starts or steps than [`MOST_STARTS`], [`MOST_STEPS`].
pub fn on_grid(
    system: &System,
    constants: &[Vec<Rational>],
    parts: u32,
    steps: usize,
) -> Result<Tried> {
    let starts = starts(system, parts)?;
    let mut tried = Tried { starts: starts.len(), states: 0, failures: BTreeMap::new() };
    let mut left = MOST_STEPS;
    for values in constants {
        let maps = maps(system, values);
        for start in &starts {
            let mut states = BTreeSet::from([start.clone()]);
            for step in 0..=steps {
                tried.states += states.len() as u64;
                for (index, claim) in system.claims.iter().enumerate() {
                    let earlier = |f: &Failure| f.step <= step;
                    let known = tried.failures.get(&index).is_some_and(earlier);
                    if claim.is_about(step)
                        && !known
                        && states.iter().any(|x| !claim.predicate.holds(x))
                    {
                        let failure =
                            Failure { values: values.clone(), start: start.clone(), step };
                        tried.failures.insert(index, failure);
                    }
                }
                if step < steps {
                    let acting = match &system.schedule {
                        Schedule::Any => (0..maps.len()).collect(),
                        Schedule::Cycle(list) => list
                            .get(step % list.len().max(1))
                            .copied()
                            .into_iter()
                            .collect::<Vec<_>>(),
                    };
                    let acting: Vec<&Map> =
                        acting.iter().filter_map(|&m| maps.get(m)).flatten().collect();
                    let work = (states.len() as u64).saturating_mul(acting.len() as u64);
                    left = left.checked_sub(work.max(1)).ok_or_else(|| {
                        Error::input(format!(
                            "grid: more than {MOST_STEPS} steps of all runs together: expected a coarser \
                             grid, fewer steps or fewer agents, or --complete"
                        ))
                    })?;
                    states =
                        acting.iter().flat_map(|map| states.iter().map(|x| map.apply(x))).collect();
                }
            }
        }
    }
    Ok(tried)
}

/// Of each mode its maps, one for each corner of what varies; those that are equal once.
fn maps(system: &System, values: &[Rational]) -> Vec<Vec<Map>> {
    let mut corners = vec![Vec::new()];
    for p in &at(system, values) {
        corners = corners
            .iter()
            .flat_map(|c: &Vec<Rational>| {
                Parameter::ends(p).into_iter().map(|end| c.iter().cloned().chain([end]).collect())
            })
            .collect();
        // More than can be followed: the limit of steps ends that.
        if corners.len() as u64 > MOST_STEPS {
            break;
        }
    }
    let of = |mode: &cordon_core::system::Mode| {
        let mut maps: Vec<Map> = Vec::new();
        for corner in &corners {
            let map = mode.at(corner);
            if !maps.contains(&map) {
                maps.push(map);
            }
        }
        maps
    };
    system.modes.iter().map(of).collect()
}

/// The starts on the grid, whole states, in order.
fn starts(system: &System, parts: u32) -> Result<Vec<Vec<Rational>>> {
    let now = system.state.len() - system.past.len();
    let constraints: Vec<Constraint> = system.starts.iter().map(|p| p.is.clone()).collect();
    let work = Work::limited(PROOF.work);
    let mut ranges = Vec::new();
    for (v, name) in system.state.iter().take(now).enumerate() {
        let form = Affine::variable(v);
        let negated = Affine::constant(Rational::zero()) - &form;
        let most = |form| greatest(form, &constraints, now, &work);
        let (Some(high), Some(low)) = (most(&form), most(&negated)) else {
            return Err(Error::input(format!(
                "start: `{name}` has no bound: expected `start` in the file to bound every variable"
            )));
        };
        ranges.push([-low, high]);
    }
    // Where each assumption bounds one variable, ends excluded or not, it is known at once how many starts there are
    // at least.
    let bounds_one = |c: &Constraint| {
        c.form.parts().is_some_and(|(_, a)| a.iter().filter(|a| !a.is_zero()).count() <= 1)
    };
    let is_strict = constraints.iter().any(|c| c.sign == Sign::Positive);
    let inside = if is_strict { parts.saturating_sub(1) } else { parts.saturating_add(1) } as usize;
    let wide = ranges.iter().filter(|[low, high]| low != high);
    let least = wide.fold(1_usize, |count, _| count.saturating_mul(inside));
    if least > MOST_STARTS && constraints.iter().all(bounds_one) {
        return Err(too_many());
    }
    let (chosen, found, left) = (Vec::new(), Vec::new(), MOST_COMPARISONS);
    let mut search = Points { parts, ranges, constraints, chosen, left, found };
    search.go()?;
    Ok(search.found.iter().filter_map(|start| system.at_rest(start)).collect())
}

fn too_many() -> Error {
    Error::input(format!(
        "grid: more than {MOST_STARTS} starts: expected a coarser grid or fewer agents"
    ))
}

/// The points of the grid, one variable after the other.
struct Points {
    parts: u32,
    ranges: Vec<[Rational; 2]>,
    constraints: Vec<Constraint>,
    chosen: Vec<Rational>,
    /// Comparisons that may still be made.
    left: u64,
    found: Vec<Vec<Rational>>,
}

impl Points {
    fn go(&mut self) -> Result<()> {
        self.left = self.left.checked_sub(1 + self.constraints.len() as u64).ok_or_else(|| {
            Error::input(
                "grid: too many points for as many comparisons in `start`: expected a coarser grid, fewer agents \
                 or --complete",
            )
        })?;
        if !self.constraints.iter().all(|c| self.may_meet(c)) {
            return Ok(());
        }
        let Some([low, high]) = self.ranges.get(self.chosen.len()).cloned() else {
            if self.found.len() >= MOST_STARTS {
                return Err(too_many());
            }
            self.found.push(self.chosen.clone());
            return Ok(());
        };
        let parts = if low == high { 0 } else { self.parts };
        for k in 0..=parts {
            let share = Rational::new(k.into(), parts.max(1).into());
            self.chosen.push(&low + (&high - &low) * share);
            self.go()?;
            self.chosen.pop();
        }
        Ok(())
    }

    /// Whether the variables that are open can make up for those that are chosen.
    fn may_meet(&self, c: &Constraint) -> bool {
        let Some((constant, coefficients)) = c.form.parts() else { return false };
        let (mut least, mut most) = (constant.clone(), constant.clone());
        for (j, a) in coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            match (self.chosen.get(j), self.ranges.get(j)) {
                (Some(x), _) => (least, most) = (least + a * x, most + a * x),
                (None, Some([low, high])) => {
                    let (low, high) = if a.is_negative() { (high, low) } else { (low, high) };
                    (least, most) = (least + a * low, most + a * high);
                }
                (None, None) => return false,
            }
        }
        match c.sign {
            Sign::Zero => !least.is_positive() && !most.is_negative(),
            sign => sign.met_by(&most),
        }
    }
}
