//! The bounds of 7.2 and 7.3 are exact, and local machines compute the global run.

use super::lemmas::{Scope, Steps, coverage, number};
use crate::certificate::theorem::Sheet;

/// Beyond 1/2 a start in 7.2's set, given by formula, crosses at step 1, for every N >= 4.
pub fn ordering_exact(scope: &Scope) -> Option<Sheet> {
    beyond_half(scope, include_str!("scripts/ordering-exact.proof"))
}

/// Beyond 1/2 a start in 7.3's set, given by formula, overtakes a target at step 1, for every N >= 3.
pub fn upper_exact(scope: &Scope) -> Option<Sheet> {
    beyond_half(scope, include_str!("scripts/upper-exact.proof"))
}

fn beyond_half(scope: &Scope, script: &str) -> Option<Sheet> {
    let mut sheet = coverage(Steps::Full, None, scope);
    sheet.read(script, &[]).ok()?;
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// N local machines that exchange positions after every tick hold what the global run has.
pub fn projection(scope: &Scope) -> Option<Sheet> {
    let mut sheet = Sheet::of("projection", "full", None);
    number(&mut sheet, scope);
    sheet.read(include_str!("scripts/projection.proof"), &[]).ok()?;
    scope.weights.is_none().then_some(sheet)
}
