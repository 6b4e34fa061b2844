//! What every proof begins with: the range of weights, the ends, the targets as bounds.

use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};
use num_rational::BigRational as Rational;
use serde_json::{Map, Value, json};

use super::builder::{Sheet, absurd, cases, clause, induction, instance, positivity, split};

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

/// `(N-1) * e_i` at step `k`.
pub fn error(k: &str, i: &str) -> String {
    format!("last*min + ({i})*(max - min) - last*x({k},{i})")
}

/// The system of a theorem.
pub fn system(theorem: Option<Theorem>, scope: &Scope, steps: Steps, starts: bool) -> Value {
    let mut body = Map::new();
    let steps = match steps {
        Steps::Full => "full",
        Steps::Activation => "activation",
        Steps::Delay => "delay",
    };
    body.insert("protocol".into(), json!("coverage"));
    body.insert("steps".into(), json!(steps));
    let of = theorem.map(|t| json!({ "theorem": t.number(), "form": scope.form.label() }));
    match (&scope.weights, &of) {
        (Some((from, to)), _) => {
            body.insert(
                "weights".into(),
                json!({ "from": from.to_string(), "to": to.to_string() }),
            );
        }
        (None, Some(of)) => _ = body.insert("weights".into(), json!({ "of": of })),
        (None, None) => {}
    }
    if let Some(of) = of.filter(|_| starts) {
        body.insert("starts".into(), of);
    }
    if let Some(n) = scope.drones {
        body.insert("drones".into(), json!(n));
    }
    Value::Object(body)
}

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

/// The end drones stay: lemmas `END0` and `ENDL`.
pub fn ends(sheet: &mut Sheet, steps: Steps) {
    for (name, class, at, place) in [("END0", "first", "0", "min"), ("ENDL", "last", "last", "max")]
    {
        let rest = if steps == Steps::Activation {
            format!(" + (1 - active(k,{at}))*[ih]")
        } else {
            String::new()
        };
        let mut used = vec![instance("h", &format!("step.{class}"), "k=k", "k=[k]")];
        if steps == Steps::Activation {
            used.push(instance("ih", "IH", "t=k", "k=[k], t=0"));
        }
        sheet.lemma(
            clause(name, "k", &["k: k >= 0"], &format!("x(k,{at}) = {place}")),
            induction(
                "k",
                "k",
                "t",
                positivity(&[], &format!("[start.{class}]")),
                positivity(&used, &format!("[h]{rest}")),
            ),
        );
    }
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

/// A property of every drone: a linear function of its position and index that the step averages.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The name of the lemma.
    pub name: &'static str,
    /// The function at (k, i).
    pub of: fn(&str, &str) -> String,
    /// Its relation to 0.
    pub relation: &'static str,
    /// The factor of the position.
    pub slope: &'static str,
    /// What it is at drone 0 and at drone N-1, as sums of facts.
    pub ends: [&'static str; 2],
}

/// X_i <= T_i.
pub const UPPER: Family =
    Family { name: "UB", of: |k, i| error(k, i), relation: ">=", slope: "(-last)", ends: ["", ""] };

/// X_i >= T_i.
pub const LOWER: Family = Family {
    name: "LB",
    of: |k, i| format!("-({})", error(k, i)),
    relation: ">=",
    slope: "last",
    ends: ["", ""],
};

/// X_i = T_i.
pub const TARGET: Family =
    Family { name: "AT", of: |k, i| error(k, i), relation: "=", slope: "(-last)", ends: ["", ""] };

/// X_i >= min.
pub const ABOVE: Family = Family {
    name: "MIN",
    of: |k, i| format!("x({k},{i}) - min"),
    relation: ">=",
    slope: "1",
    ends: ["", " + [segment]"],
};

/// X_i <= max.
pub const BELOW: Family = Family {
    name: "MAX",
    of: |k, i| format!("max - x({k},{i})"),
    relation: ">=",
    slope: "(-1)",
    ends: [" + [segment]", ""],
};

/// The clause that a family holds from step `from` on.
pub fn family_clause(f: &Family, from: &str) -> Value {
    let given = [&format!("k: k >= {from}"), "i: i >= 0", "u: last - i >= 0"];
    clause(f.name, "k i", &given, &format!("{} {} 0", (f.of)("k", "i"), f.relation))
}

/// A family holds from step `from` on (which is known to be at least 0 as the sum `later` of facts, k - `from` being
/// the fact `k`), as `base` says of that step: induction over steps, by class of drone.
pub fn family_proof(f: &Family, steps: Steps, base: Value, later: &str) -> Value {
    let slope = f.slope;
    let end = |n: &str, lemma: &str, sum: &str| {
        let k = format!("k={later} + 1");
        positivity(&[instance("z", lemma, "k=k + 1", &k)], &format!("{n}*[z]{sum}"))
    };
    let h = |with: &str| instance("h", "step.inner", with, &format!("k={later}, i=[i], n=[u]"));
    let ih = |name: &str, at: &str, given: &str| {
        instance(name, "IH", &format!("t=k, i={at}"), &format!("k=[k], t=0, {given}"))
    };
    let own = ih("o", "i", "i=[i] + 1, u=[u] + 1");
    let (left, right) = ("i=[i], u=[u] + 2", "i=[i] + 2, u=[u]");
    // What the family needs of the weights; an equation needs nothing.
    let (eps, half) = if f.relation == "=" { ("eps", "(1 - 2*eps)") } else { ("[eps]", "[half]") };
    let average = format!("{eps}*[l] + {half}*[o] + {eps}*[r] + {slope}*[h]");
    let neighbours = [own.clone(), ih("l", "i - 1", left), ih("r", "i + 1", right)];
    let inner = match steps {
        Steps::Full => positivity(&[&[h("k=k, i=i")], &neighbours[..]].concat(), &average),
        Steps::Activation => {
            let all = [&[h("k=k, i=i")], &neighbours[..]].concat();
            let active = |rest: &str| {
                format!(
                    "{average} + {slope}*(eps*x(k,i-1) - 2*eps*x(k,i) + eps*x(k,i+1))*[a{rest}]"
                )
            };
            by_activity(
                "a",
                "i",
                positivity(&all, &active("-1")),
                positivity(
                    &[h("k=k, i=i"), own],
                    &format!(
                        "[o] + {slope}*[h] + {slope}*(eps*x(k,i-1) - 2*eps*x(k,i) + eps*x(k,i+1))*[a]"
                    ),
                ),
            )
        }
        Steps::Delay => {
            let seen = |j: &str| format!("seen(k,i,{j})");
            let mut all = vec![h("k=k, i=i"), own];
            for (n, j, given) in [("l", "i - 1", left), ("r", "i + 1", right)] {
                let with = format!("k=k, i=i, j={j}");
                all.push(instance(&format!("{n}low"), "seen.low", &with, &format!("k={later}")));
                all.push(instance(&format!("{n}high"), "seen.high", &with, &format!("k={later}")));
                let given = format!("k=[{n}low], t=[{n}high], {given}");
                all.push(instance(n, "IH", &format!("t={}, i={j}", seen(j)), &given));
            }
            positivity(&all, &average)
        }
    };
    induction(
        "k",
        "k",
        "t",
        base,
        by_class(end(slope, "END0", f.ends[0]), end(slope, "ENDL", f.ends[1]), inner),
    )
}

/// The start set implies X_i^0 <= T_i: the base of [`UPPER`].
pub fn start_below(starts: StartSet) -> Option<Value> {
    match starts {
        StartSet::UpperBounded => {
            Some(positivity(&[instance("h", "start.bound", "i=i", "i=[i], n=[u]")], "[h]"))
        }
        StartSet::FirstSubsegment => Some(by_class(
            positivity(&[], "-last*[start.first]"),
            positivity(&[], "-last*[start.last]"),
            positivity(
                &[instance("h", "start.segment", "i=i", "i=[i], n=[u]")],
                "[h] + [i]*[segment]",
            ),
        )),
        _ => None,
    }
}

/// X_i^k <= T_i for all i and k, as lemma `UB`, if the hypothesis gives it.
pub fn upper_bound(sheet: &mut Sheet, theorem: Theorem, scope: &Scope, known: Weights) -> bool {
    let base = start_below(theorem.hypothesis(scope.form).starts);
    match base.filter(|_| known.eps && known.half) {
        Some(base) => {
            ends(sheet, Steps::Full);
            sheet.lemma(family_clause(&UPPER, "0"), family_proof(&UPPER, Steps::Full, base, "[k]"));
            true
        }
        None => false,
    }
}
