//! Properties that every step preserves: 7.2, 7.3 and their companions.

use cordon_spec::theorems::{StartSet, Theorem};

use super::lemmas::{
    Family, Scope, Steps, UPPER, ends, of_any_start, start_below, theorem, weights,
};
use crate::certificate::theorem::Sheet;

/// 7.3: X_i <= T_i for all i and k.
pub fn upper(scope: &Scope, steps: Steps) -> Option<Sheet> {
    let mut sheet = theorem(Theorem::UpperBound, steps, scope);
    let known = weights(&mut sheet, Theorem::UpperBound, scope);
    let base = start_below(Theorem::UpperBound.hypothesis(scope.form).starts)?;
    ends(&mut sheet, steps)?;
    UPPER.prove(&mut sheet, "conclude", steps, base)?;
    (known.eps && known.half).then_some(sheet)
}

/// Families that hold at the start hold at every step.
pub fn assumed(scope: &Scope, steps: Steps, families: &[Family]) -> Option<Sheet> {
    let (mut sheet, known) = of_any_start(scope, steps)?;
    for f in families {
        let start = "assume @name.start(i) i: i >= 0, u: last - i >= 0 |- @f(0, i) @relation 0";
        let base = "by [h]\n  h = @name.start(i=i; i=[i], u=[u])";
        sheet.read(start, &f.terms("conclude", steps, base)).ok()?;
        f.prove(&mut sheet, "conclude", steps, base)?;
    }
    (known.eps && known.half).then_some(sheet)
}

/// 7.2: X_i < X_{i+1} for all i and k.
pub fn ordering(scope: &Scope, steps: Steps) -> Option<Sheet> {
    let mut sheet = theorem(Theorem::Ordering, steps, scope);
    let known = weights(&mut sheet, Theorem::Ordering, scope);
    let three = scope.drones == Some(3);
    let starts = Theorem::Ordering.hypothesis(scope.form).starts;
    if !(known.eps && known.one && (known.half || known.four || three))
        || starts != StartSet::Ordered
    {
        return None;
    }
    ends(&mut sheet, steps)?;
    let script = match steps {
        Steps::Activation => include_str!("scripts/ordering-active.proof"),
        _ => include_str!("scripts/ordering-full.proof"),
    };
    let half = if known.half { "[half]" } else { "[four]" };
    let four = if known.four { "four = weight.four(; four=[i] + [u])" } else { "" };
    // Of three drones there is no inner pair.
    let inner = if three { "absurd [i] + [u] - [drones]" } else { "@pairs" };
    sheet.read(script, &[("half", half), ("four", four), ("inner", inner)]).ok()?;
    Some(sheet)
}
