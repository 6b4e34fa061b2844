//! What is left of the theorems where messages are late, drones wait, or the weight changes.

use cordon_spec::theorems::{Form, StartSet, Theorem};
use num_rational::BigRational as Rational;

use super::lemmas::{
    ABOVE, BELOW, CELL, Scope, Steps, Weights, coverage, ends, of_any_start, starts, theorem,
    weights,
};
use crate::certificate::theorem::Sheet;

/// 7.2 where nothing is seen more than one step late: for weights up to 2/5 order is kept, and each gap
/// keeps the part 1 - 2 eps of itself in a step.
pub fn ordering_one_late(scope: &Scope) -> Option<Sheet> {
    let (zero, most) = (Rational::from_integer(0.into()), Rational::new(2.into(), 5.into()));
    let (from, to) = scope.weights.clone().unwrap_or((zero.clone(), most.clone()));
    let within = from >= zero && to <= most;
    let spare = Rational::from_integer(2.into()) - Rational::from_integer(5.into()) * &to;
    let scope = Scope { weights: Some((from, to)), ..scope.clone() };
    let mut sheet = theorem(Theorem::Ordering, Steps::Delay, &scope);
    weights(&mut sheet, Theorem::Ordering, &scope);
    ends(&mut sheet, Steps::Delay)?;
    sheet.read(include_str!("scripts/box.proof"), &[]).ok()?;
    for (bound, base) in [
        (ABOVE, "by [h]\n  h = above(i=i; i=[i], u=[u])"),
        (BELOW, "by [h]\n  h = below(j=last - i; j=[u], u=[i])"),
    ] {
        bound.prove(&mut sheet, "lemma", Steps::Delay, base)?;
    }
    let age = "assume AGE(k i j) k: k >= 0 |- seen(k,i,j) - k + 1 >= 0";
    let fifth = format!("lemma fifth |- 2 - 5*eps >= 0\n  by 5*[weight.to] + {spare}");
    for script in [age, &fifth, include_str!("scripts/one-late.proof")] {
        sheet.read(script, &[]).ok()?;
    }
    within.then_some(sheet)
}

/// 7.2 however late messages are, from a start with each drone in a cell of its own.
pub fn ordering_in_cells(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = of_any_start(scope, Steps::Delay)?;
    let shift = "constant shift: real\nassume shift.low |- shift >= 0\n\
                 assume shift.high |- max - min - last*shift > 0";
    sheet.read(shift, &[]).ok()?;
    let start = "assume @name.start(i) i: i >= 1, u: last - 1 - i >= 0 |- @f(0, i) @relation 0";
    let base = "class\n  by @slope*[start.first]@first\n  by @slope*[start.last]@last\n  by [h]\n    \
                h = @name.start(i=i; i=[i], u=[u])";
    for bound in CELL {
        let terms = bound.terms("conclude", Steps::Delay, base);
        sheet.read(start, &terms).ok()?;
        bound.prove(&mut sheet, "conclude", Steps::Delay, base)?;
    }
    sheet.read(include_str!("scripts/cells.proof"), &[]).ok()?;
    (known.eps && known.half).then_some(sheet)
}

/// 7.2 where a drone may wait: the gaps stay between the smallest and the largest of the start.
pub fn gaps_active(scope: &Scope) -> Option<Sheet> {
    then(of_any_start(scope, Steps::Activation)?, include_str!("scripts/gaps-active.proof"))
}

/// 7.8 where nothing is seen more than d steps late: the rate of prompt messages, once in d + 1 steps.
pub fn limit_late(scope: &Scope) -> Option<Sheet> {
    then(of_any_start(scope, Steps::Delay)?, include_str!("scripts/limit-late.proof"))
}

/// 7.8 where a drone may wait, but not for B steps on end: the rate of full steps, once in B steps.
pub fn limit_active(scope: &Scope) -> Option<Sheet> {
    then(of_any_start(scope, Steps::Activation)?, include_str!("scripts/limit-active.proof"))
}

/// 7.2 with another weight in each step: the gaps stay between the smallest and the largest of the start.
pub fn gaps_varying(scope: &Scope) -> Option<Sheet> {
    varying(scope, None, &[(include_str!("scripts/gaps-varying.proof"), "")])
}

/// 7.3 with another weight in each step; 7.4 follows.
pub fn upper_varying(scope: &Scope) -> Option<Sheet> {
    varying(scope, Some(Theorem::UpperBound), &[(BOUND, "conclude")])
}

/// 7.5 (i) with another weight in each step.
pub fn increasing_varying(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/increase-varying.proof");
    varying(scope, Some(Theorem::UpperBound), &[(BOUND, "lemma"), (script, "")])
}

/// 7.6 (i) with another weight in each step.
pub fn fixed_varying(scope: &Scope) -> Option<Sheet> {
    varying(scope, None, &[(include_str!("scripts/fixed-varying.proof"), "")])
}

/// 7.6 (ii) with another weight in each step, none of them 0.
pub fn constant_varying(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/constant-sum.proof");
    varying(scope, Some(Theorem::ConstantSum), &[(BOUND, "lemma"), (script, "")])
}

/// 7.7 with another weight in each step, none of them 0.
pub fn increasing_in_time_varying(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/globally-increasing.proof");
    varying(scope, Some(Theorem::GloballyIncreasing), &[(BOUND, "lemma"), (script, "")])
}

/// 7.8 with another weight in each step: the rate that each has.
pub fn limit_varying(scope: &Scope) -> Option<Sheet> {
    varying(scope, None, &[(include_str!("scripts/limit-varying.proof"), "")])
}

/// X_i <= T_i with another weight in each step.
const BOUND: &str = include_str!("scripts/bound-varying.proof");

/// One weight w(k) for all drones, another in each step, from the starts of a theorem or from any. The scripts, each with
/// what it is to say.
fn varying(scope: &Scope, theorem: Option<Theorem>, scripts: &[(&str, &str)]) -> Option<Sheet> {
    let positive = matches!(theorem, Some(Theorem::ConstantSum | Theorem::GloballyIncreasing));
    let mut sheet = weighted(scope, theorem, "w(k)")?;
    let least = [("relation", if positive { ">" } else { ">=" })];
    sheet.read(include_str!("scripts/varying.proof"), &least).ok()?;
    for (script, say) in scripts {
        let script = format!("{}{script}", include_str!("scripts/varying-weight.proof"));
        sheet.read(&script, &[("say", say)]).ok()?;
    }
    Some(sheet)
}

/// The protocol with that weight of drone i in step k, from the starts of a theorem or any with the ends in place.
fn weighted(scope: &Scope, theorem: Option<Theorem>, weight: &str) -> Option<Sheet> {
    let mut sheet = coverage(Steps::Full, Some(weight), scope);
    starts(&mut sheet, theorem.map_or(StartSet::Any, |t| t.hypothesis(Form::Sharp).starts));
    ends(&mut sheet, Steps::Full)?;
    scope.weights.is_none().then_some(sheet)
}

/// 7.2 where messages are lost, each way by itself, for any weights up to one below 1/2: strict order, the
/// part 1 - 2 eps of each gap, the hull.
pub fn ordering_with_losses(scope: &Scope) -> Option<Sheet> {
    alone(scope, Sheet::of_three(), include_str!("scripts/loss.proof"))
}

/// 7.2 and 7.3 where each drone has a weight of its own in each step, any from 0 to 1/2.
pub fn gaps_held(scope: &Scope) -> Option<Sheet> {
    let mut sheet = weighted(scope, None, "w(k,i)")?;
    sheet.read(include_str!("scripts/hold.proof"), &[]).ok()?;
    Some(sheet)
}

/// Strict order where each drone has a weight of its own and those of neighbours add up to 1 at most.
pub fn ordering_held(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/hold-sums.proof");
    let mut sheet = weighted(scope, Some(Theorem::Ordering), "w(k,i)")?;
    sheet.read(script, &[]).ok()?;
    Some(sheet)
}

/// There is none where they add up to more.
pub fn ordering_held_exact(scope: &Scope) -> Option<Sheet> {
    let sheet = coverage(Steps::Full, Some("w(k,i)"), scope);
    alone(scope, sheet, include_str!("scripts/hold-exact.proof"))
}

/// Weak order where messages are lost, as long as what neighbours take of each other adds up to 1 at most.
pub fn weak_ordering_with_losses(scope: &Scope) -> Option<Sheet> {
    alone(scope, Sheet::of_three(), include_str!("scripts/loss-sums.proof"))
}

/// There is none where it adds up to more.
pub fn weak_ordering_with_losses_exact(scope: &Scope) -> Option<Sheet> {
    alone(scope, Sheet::of_three(), include_str!("scripts/loss-exact.proof"))
}

/// 7.8 does not hold where another weight in each step is such that the sum of all is finite.
pub fn limit_exact(scope: &Scope) -> Option<Sheet> {
    varying(scope, None, &[(include_str!("scripts/limit-exact.proof"), "")])
}

/// Order where agents join and leave.
pub fn ordering_joining(scope: &Scope) -> Option<Sheet> {
    alone(scope, Sheet::of_three(), include_str!("scripts/joining.proof"))
}

/// Rendez-vous with weights of their own from 0 to 1/2: nobody leaves the hull of the start.
pub fn rendezvous(scope: &Scope) -> Option<Sheet> {
    let sheet = Sheet::of("consensus", "full", Some("w(k,i)"));
    alone(scope, sheet, include_str!("scripts/rendez-vous.proof"))
}

/// The script, which says itself what is assumed of the weights, for every N.
fn alone(scope: &Scope, mut sheet: Sheet, script: &str) -> Option<Sheet> {
    sheet.read(script, &[]).ok()?;
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// The script, for weights from 0 to 1/2.
fn then((mut sheet, known): (Sheet, Weights), script: &str) -> Option<Sheet> {
    sheet.read(script, &[]).ok()?;
    (known.eps && known.half).then_some(sheet)
}
