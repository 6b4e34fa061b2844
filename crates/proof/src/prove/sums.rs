//! The sum of the positions: 7.4 to 7.7, and consensus. Partial sums c(k,m) = x(k,0) + ... +
//! x(k,m-1); the whole sum is c(k,last+1).

use cordon_spec::theorems::{StartSet, Theorem};

use super::lemmas::{
    Scope, Steps, TARGET, Weights, coverage, number, starts, theorem, upper_bound, weights,
};
use crate::certificate::theorem::Sheet;

/// The proof in a script, for weights of which nothing but the range is needed.
fn proof(theorem: Theorem, scope: &Scope, script: &str, given: &[(&str, &str)]) -> Option<Sheet> {
    let (mut sheet, _) = begin(theorem, scope);
    sheet.read(script, given).ok()?;
    Some(sheet)
}

/// The proof in a script that rests on X_i <= T_i, for weights that `suffice`.
fn below(
    theorem: Theorem,
    scope: &Scope,
    script: &str,
    suffice: impl Fn(Weights) -> bool,
) -> Option<Sheet> {
    let (mut sheet, known) = begin(theorem, scope);
    upper_bound(&mut sheet, theorem, scope, known)?;
    sheet.read(script, &[]).ok()?;
    suffice(known).then_some(sheet)
}

fn begin(of: Theorem, scope: &Scope) -> (Sheet, Weights) {
    let mut sheet = theorem(of, Steps::Full, scope);
    let known = weights(&mut sheet, of, scope);
    (sheet, known)
}

/// 7.4 (i): the sum is at most that of the targets.
pub fn bounded(scope: &Scope) -> Option<Sheet> {
    below(Theorem::SumBounded, scope, include_str!("scripts/bounded.proof"), |_| true)
}

/// 7.4 (ii): the sum meets its bound just where all drones are at their targets.
pub fn maximal(scope: &Scope) -> Option<Sheet> {
    below(Theorem::SumMaximal, scope, include_str!("scripts/maximal.proof"), |_| true)
}

/// 7.5 identity: any start with the end drones in place.
pub fn identity(scope: &Scope) -> Option<Sheet> {
    let mut sheet = coverage(Steps::Full, None, scope);
    starts(&mut sheet, StartSet::Any);
    sheet.read(include_str!("scripts/identity.proof"), &[]).ok()?;
    Some(sheet)
}

/// 7.5 (i): the sum never decreases.
pub fn non_decreasing(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/non-decreasing.proof");
    below(Theorem::SumNonDecreasing, scope, script, |_| true)
}

/// 7.5 (ii): at the targets the sum stays in the next step.
pub fn stationary(scope: &Scope) -> Option<Sheet> {
    proof(Theorem::SumStationary, scope, include_str!("scripts/stationary.proof"), &[])
}

/// 7.6 (i): at the targets the drones stay, and so does the sum.
pub fn targets_fixed(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/targets-fixed.proof");
    let base = "by [h]\n  h = TARGETS(i=i; i=[i], u=[u])";
    let mut given = TARGET.terms("conclude", Steps::Full, base);
    given.extend([("from", "K"), ("later", "[k] + [K]")]);
    proof(Theorem::TargetsFixed, scope, script, &given)
}

/// 7.6 (ii): while the sum stays for long enough, all drones are at their targets.
pub fn constant_sum(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/constant-sum.proof");
    below(Theorem::ConstantSum, scope, script, |known| known.positive)
}

/// 7.7: off the targets the sum increases within so many steps as the least depth of a drone off its own.
pub fn globally_increasing(scope: &Scope) -> Option<Sheet> {
    let script = include_str!("scripts/globally-increasing.proof");
    below(Theorem::GloballyIncreasing, scope, script, |known| known.positive)
}

/// Equation 6 on a path: consensus preserves the sum of the positions.
pub fn consensus(scope: &Scope) -> Option<Sheet> {
    let mut sheet = Sheet::of("consensus", "full", None);
    number(&mut sheet, scope);
    sheet.read(include_str!("scripts/consensus.proof"), &[]).ok()?;
    scope.weights.is_none().then_some(sheet)
}
