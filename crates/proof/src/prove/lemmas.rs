//! What every proof begins with: the range of weights, the ends, the targets as bounds; and two shapes of proofs.

use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};
use num_rational::BigRational as Rational;
use serde_json::Value;

use crate::certificate::theorem::{Sheet, absurd, cases, clause, instance, positivity, split};

/// How a step is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// Everybody updates.
    Full,
    /// Any subset updates.
    Activation,
    /// Neighbours are seen where they were at any earlier step.
    Delay,
}

/// What a claim is to be proved for.
#[derive(Clone, Debug)]
pub struct Scope {
    /// Which form.
    pub form: Form,
    /// An interval of weights in the place of the theorem's own range.
    pub weights: Option<(Rational, Rational)>,
    /// One N in the place of every N.
    pub drones: Option<u32>,
}

/// A certificate about coverage: that the segment has a length, what is known of who updates or of what is seen, and
/// the number of drones.
pub fn coverage(steps: Steps, weight: Option<&str>, scope: &Scope) -> Sheet {
    let (name, known) = match steps {
        Steps::Full => ("full", &[][..]),
        Steps::Activation => (
            "activation",
            &[
                ("active.low", "k i", "", "active(k,i) >= 0"),
                ("active.high", "k i", "", "1 - active(k,i) >= 0"),
            ][..],
        ),
        Steps::Delay => (
            "delay",
            &[
                ("seen.low", "k i j", "k: k >= 0", "seen(k,i,j) >= 0"),
                ("seen.high", "k i j", "k: k >= 0", "k - seen(k,i,j) >= 0"),
            ][..],
        ),
    };
    let mut sheet = Sheet::of("coverage", name, weight);
    sheet.assume(clause("segment", "", &[], "max > min"));
    for (name, vars, given, goal) in known {
        sheet.assume(clause(name, vars, &[given], goal));
    }
    number(&mut sheet, scope);
    sheet
}

/// Assumes the number of drones, where there is one.
pub fn number(sheet: &mut Sheet, scope: &Scope) {
    if let Some(n) = scope.drones {
        sheet.assume(clause("drones", "", &[], &format!("last + 1 = {n}")));
    }
}

/// A certificate of a theorem about coverage: of its range of weights, or an interval, and its starts.
pub fn theorem(theorem: Theorem, steps: Steps, scope: &Scope) -> Sheet {
    let mut sheet = coverage(steps, None, scope);
    let hypothesis = theorem.hypothesis(scope.form);
    range(&mut sheet, hypothesis.weights, scope);
    starts(&mut sheet, hypothesis.starts);
    sheet
}

/// Assumes that range of weights, but for an interval in its place; that below the critical weight by the leading minors of the
/// spec's `below_critical`, minor(i) being the one of i - 1 rows.
pub fn range(sheet: &mut Sheet, range: WeightRange, scope: &Scope) {
    let (low, high) = match (&scope.weights, range) {
        (None, WeightRange::Any) | (Some(_), _) => return,
        (None, WeightRange::Unit | WeightRange::UpToHalfOrOne) => ("eps >= 0", "1 >= eps"),
        (None, WeightRange::BelowThird) => ("eps >= 0", "1 - 3*eps > 0"),
        (None, WeightRange::BelowHalf) => ("eps >= 0", "1 - 2*eps > 0"),
        (None, WeightRange::UpToHalf) => ("eps >= 0", "1 - 2*eps >= 0"),
        (None, WeightRange::PositiveUpToHalf) => ("eps > 0", "1 - 2*eps >= 0"),
        (None, WeightRange::BelowCritical) => ("eps > 0", ""),
    };
    sheet.assume(clause("weight.low", "", &[], low));
    if range == WeightRange::BelowCritical {
        sheet.function("minor", 1, "real");
        let step = "minor(i+1) = 2*(1 - eps)*minor(i) - eps*eps*minor(i-1)";
        sheet.assume(clause("minor.0", "", &[], "minor(0) = 0"));
        sheet.assume(clause("minor.1", "", &[], "minor(1) = 1"));
        sheet.assume(clause("minor.step", "i", &INSIDE, step));
        let positive = ["i: i - 1 >= 0", "n: last - i >= 0"];
        sheet.assume(clause("minor.positive", "i", &positive, "minor(i) > 0"));
    } else {
        sheet.assume(clause("weight.high", "", &[], high));
    }
    if range == WeightRange::UpToHalfOrOne {
        sheet.assume(clause("weight.four", "", &["four: last - 3 >= 0"], "1 - 2*eps >= 0"));
    }
}

/// Assumes a start: the end drones stand at the ends; all are in order, in the first subsegment, or below their targets.
pub fn starts(sheet: &mut Sheet, starts: StartSet) {
    sheet.assume(clause("start.first", "", &[], "x(0,0) = min"));
    sheet.assume(clause("start.last", "", &[], "x(0,last) = max"));
    if matches!(starts, StartSet::Ordered | StartSet::FirstSubsegment) {
        let pairs = ["i: i >= 0", "n: last - i - 1 >= 0"];
        sheet.assume(clause("start.order", "i", &pairs, "x(0,i+1) - x(0,i) > 0"));
    }
    if starts == StartSet::FirstSubsegment {
        let within = "last*min + (max - min) - last*x(0,i) > 0";
        sheet.assume(clause("start.segment", "i", &INSIDE, within));
    }
    if starts == StartSet::UpperBounded {
        let (all, below) =
            (["i: i >= 0", "n: last - i >= 0"], "last*min + i*(max - min) - last*x(0,i) >= 0");
        sheet.assume(clause("start.bound", "i", &all, below));
    }
}

/// What is given of inner drones.
const INSIDE: [&str; 2] = ["i: i - 1 >= 0", "n: last - 1 - i >= 0"];

/// What is known of the weights: as lemmas `eps` (>= 0, or > 0), `one` (1 - eps >= 0) and `half` (1 - 2 eps >= 0).
#[derive(Clone, Copy, Debug, Default)]
pub struct Weights {
    /// `eps` is there.
    pub eps: bool,
    /// It says > 0.
    pub positive: bool,
    /// `one` is there.
    pub one: bool,
    /// `half` is there.
    pub half: bool,
    /// From four drones on `half` holds.
    pub four: bool,
}

/// Adds the lemmas about weights.
pub fn weights(sheet: &mut Sheet, theorem: Theorem, scope: &Scope) -> Weights {
    for (name, end, sign) in scope
        .weights
        .iter()
        .flat_map(|(from, to)| [("weight.from", from, ">="), ("weight.to", to, "<=")])
    {
        sheet.assume(clause(name, "", &[], &format!("eps {sign} {end}")));
    }
    let mut lemma = |name: &str, goal: &str, sum: &str| {
        sheet.lemma(clause(name, "", &[], goal), positivity(&[], sum))
    };
    let mut known = Weights::default();
    match &scope.weights {
        Some((from, to)) => {
            let int = |n: i64| Rational::from_integer(n.into());
            let half = Rational::new(1.into(), 2.into());
            known.positive = *from > int(0);
            known.eps = *from >= int(0);
            (known.one, known.half) = (*to <= int(1), *to <= half);
            let plus = |r: Rational| if r == int(0) { String::new() } else { format!(" + {r}") };
            if known.eps {
                let sign = if known.positive { ">" } else { ">=" };
                lemma(
                    "eps",
                    &format!("eps {sign} 0"),
                    &format!("[weight.from]{}", plus(from.clone())),
                );
            }
            if known.one {
                lemma("one", "1 - eps >= 0", &format!("[weight.to]{}", plus(int(1) - to)));
            }
            if known.half {
                lemma(
                    "half",
                    "1 - 2*eps >= 0",
                    &format!("2*[weight.to]{}", plus(int(1) - int(2) * to)),
                );
            }
        }
        None => {
            let range = theorem.hypothesis(scope.form).weights;
            known.eps = range != WeightRange::Any;
            known.positive =
                matches!(range, WeightRange::PositiveUpToHalf | WeightRange::BelowCritical);
            if known.eps {
                lemma("eps", if known.positive { "eps > 0" } else { "eps >= 0" }, "[weight.low]");
            }
            let (half, one) = match range {
                WeightRange::Any | WeightRange::BelowCritical => ("", ""),
                WeightRange::Unit | WeightRange::UpToHalfOrOne => ("", "[weight.high]"),
                WeightRange::BelowThird => ("2/3*[weight.high] + 1/3", "1/3*[weight.high] + 2/3"),
                WeightRange::BelowHalf | WeightRange::UpToHalf | WeightRange::PositiveUpToHalf => {
                    ("[weight.high]", "1/2*[weight.high] + 1/2")
                }
            };
            (known.half, known.one) = (!half.is_empty(), !one.is_empty());
            known.four = range == WeightRange::UpToHalfOrOne;
            if known.half {
                lemma("half", "1 - 2*eps >= 0", half);
            }
            if known.one {
                lemma("one", "1 - eps >= 0", one);
            }
        }
    }
    known
}

/// Any start with the ends in place, and the weights of 7.3: up to 1/2.
pub fn of_any_start(scope: &Scope, steps: Steps) -> Option<(Sheet, Weights)> {
    let mut sheet = coverage(steps, None, scope);
    range(&mut sheet, Theorem::UpperBound.hypothesis(scope.form).weights, scope);
    starts(&mut sheet, StartSet::Any);
    let known = weights(&mut sheet, Theorem::UpperBound, scope);
    ends(&mut sheet, steps)?;
    Some((sheet, known))
}

/// The end drones stay: lemmas `END0` and `ENDL`.
pub fn ends(sheet: &mut Sheet, steps: Steps) -> Option<()> {
    let script = if steps == Steps::Activation { "@endsactive" } else { "@ends" };
    sheet.read(script, &[]).ok()
}

/// Cases for a drone: the first, the last, inner ones. The literals are `i: i >= 0` and `u: last - i >= 0`; in the
/// inner case they are i - 1 >= 0 and last - 1 - i >= 0.
pub fn by_class(first: Value, last: Value, inner: Value) -> Value {
    cases("i", "i", first, cases("u", "i", last, inner))
}

/// Whether drone `i` updates in step k: `name` is the fact that active(k,i) is 1, or 0.
pub fn by_activity(name: &str, i: &str, on: Value, off: Value) -> Value {
    let at = |n: &str, sum: &str| {
        absurd(&[instance(n, &format!("active.{n}"), &format!("k=k, i={i}"), "")], sum)
    };
    split(
        name,
        &format!("active(k,{i})"),
        [
            split(
                &format!("{name}-1"),
                &format!("active(k,{i}) - 1"),
                [
                    at("high", &format!("[{name}-1] + [high]")),
                    on,
                    absurd(&[], &format!("[{name}] + [{name}-1]")),
                ],
            ),
            off,
            at("low", &format!("[{name}] + [low]")),
        ],
    )
}

/// A property of every drone: a linear function f of its position and index that the step averages
/// (`scripts/family.proof`).
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The name of the lemma.
    pub name: &'static str,
    /// The function at (k, i).
    of: &'static str,
    /// Its relation to 0.
    relation: &'static str,
    /// The factor of the position.
    slope: &'static str,
    /// What is added at drone 0 and at drone N-1 for f to be what it is there.
    ends: [&'static str; 2],
}

/// X_i <= T_i.
pub const UPPER: Family =
    Family { name: "UB", of: "@e(k, i)", relation: ">=", slope: "(-last)", ends: ["", ""] };

/// X_i >= T_i.
pub const LOWER: Family =
    Family { name: "LB", of: "-(@e(k, i))", relation: ">=", slope: "last", ends: ["", ""] };

/// X_i = T_i.
pub const TARGET: Family =
    Family { name: "AT", of: "@e(k, i)", relation: "=", slope: "(-last)", ends: ["", ""] };

/// X_i >= min.
pub const ABOVE: Family = Family {
    name: "MIN",
    of: "x(k,i) - min",
    relation: ">=",
    slope: "1",
    ends: ["", " + [segment]"],
};

/// X_i <= max.
pub const BELOW: Family = Family {
    name: "MAX",
    of: "max - x(k,i)",
    relation: ">=",
    slope: "(-1)",
    ends: [" + [segment]", ""],
};

/// Of a cell as wide as the targets are apart, shifted: that a drone is not beyond it, nor before it.
pub const CELL: [Family; 2] = [
    Family {
        name: "CELL.high",
        of: "@e(k, i) + last*shift",
        relation: ">=",
        slope: "(-last)",
        ends: [" + [last]*[shift.low]"; 2],
    },
    Family {
        name: "CELL.low",
        of: "max - min - last*shift - (@e(k, i))",
        relation: ">",
        slope: "last",
        ends: [" + [shift.high]"; 2],
    },
];

impl Family {
    /// The family in the terms of its script: `say` is `lemma` or `conclude`, `base` a proof of what it
    /// says of step 0.
    pub fn terms(
        &self,
        say: &'static str,
        steps: Steps,
        base: &'static str,
    ) -> Vec<(&'static str, &'static str)> {
        // What the family needs of the weights; an equation needs nothing.
        let (eps, half) =
            if self.relation == "=" { ("eps", "(1 - 2*eps)") } else { ("[eps]", "[half]") };
        let inner = match steps {
            Steps::Full => "@full",
            Steps::Activation => "@activation",
            Steps::Delay if self.relation == ">" => "@delaystrict",
            Steps::Delay => "@delay",
        };
        let [first, last] = self.ends;
        vec![
            ("say", say),
            ("name", self.name),
            ("f(k, i)", self.of),
            ("relation", self.relation),
            ("slope", self.slope),
            ("first", first),
            ("last", last),
            ("eps", eps),
            ("half", half),
            ("inner", inner),
            ("base", base),
            ("from", "0"),
            ("later", "[k]"),
        ]
    }

    /// It holds from step 0 on.
    pub fn prove(
        &self,
        sheet: &mut Sheet,
        say: &'static str,
        steps: Steps,
        base: &'static str,
    ) -> Option<()> {
        sheet.read("@family", &self.terms(say, steps, base)).ok()
    }
}

/// The start set implies X_i^0 <= T_i: the base of [`UPPER`].
pub fn start_below(starts: StartSet) -> Option<&'static str> {
    match starts {
        StartSet::UpperBounded => Some("by [h]\n  h = start.bound(i=i; i=[i], n=[u])"),
        StartSet::FirstSubsegment => Some(
            "class\n  by -last*[start.first]\n  by -last*[start.last]\n  by [h] + [i]*[segment]\n    \
             h = start.segment(i=i; i=[i], n=[u])",
        ),
        _ => None,
    }
}

/// X_i^k <= T_i for all i and k, as lemma `UB`, if the hypothesis gives it.
pub fn upper_bound(
    sheet: &mut Sheet,
    theorem: Theorem,
    scope: &Scope,
    known: Weights,
) -> Option<()> {
    let base = start_below(theorem.hypothesis(scope.form).starts)?;
    (known.eps && known.half).then_some(())?;
    ends(sheet, Steps::Full)?;
    UPPER.prove(sheet, "lemma", Steps::Full, base)
}
