//! 7.8 for every N: convergence below the critical weight, and none from there on. The critical weight is met as
//! the spec has it: by the leading minors.

use cordon_spec::theorems::{Form, StartSet, Theorem};

use super::lemmas::{Scope, Steps, coverage, starts, theorem};
use crate::certificate::theorem::Sheet;

/// Convergence: for eps <= 1/2 at the rate 1 - 8eps/(N-1)^2 in the norm of i(N-1-i), for 1/2 <= eps
/// below the critical weight at an explicit rate in the norm of `w` (`scripts/terms.proof`).
pub fn limit(scope: &Scope) -> Option<Sheet> {
    let mut sheet = theorem(Theorem::Limit, Steps::Full, scope);
    let minors = ("st", "minor.step(i=i; i=[i], n=[u])");
    sheet.read(include_str!("scripts/limit.proof"), &[minors]).ok()?;
    (scope.form == Form::Sharp && scope.weights.is_none()).then_some(sheet)
}

/// No convergence from the critical weight on.
pub fn beyond(scope: &Scope) -> Option<Sheet> {
    let mut sheet = at_every_weight(scope);
    let minors = ("st", "minor.step(i=i - 1; from=[i])");
    sheet.read(include_str!("scripts/beyond.proof"), &[minors]).ok()?;
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// No convergence for eps <= 0.
pub fn low(scope: &Scope) -> Option<Sheet> {
    let mut sheet = at_every_weight(scope);
    sheet.read(include_str!("scripts/low.proof"), &[]).ok()?;
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

fn at_every_weight(scope: &Scope) -> Sheet {
    let mut sheet = coverage(Steps::Full, None, scope);
    starts(&mut sheet, StartSet::Any);
    sheet
}
