//! Properties that every step preserves: 7.2, 7.3 and their companions.

use cordon_spec::theorems::{StartSet, Theorem};

use super::builder::{Sheet, absurd, cases, clause, induction, instance, positivity, split};
use super::lemmas::{
    Family, Scope, Steps, UPPER, by_activity, ends, family_clause, family_proof, start_below,
    system, weights,
};
use serde_json::Value;

/// 7.3: X_i <= T_i for all i and k.
pub fn upper(scope: &Scope, steps: Steps) -> Option<Sheet> {
    let mut sheet = Sheet::new(system(Some(Theorem::UpperBound), scope, steps, true));
    let known = weights(&mut sheet, Theorem::UpperBound, scope);
    let base = start_below(Theorem::UpperBound.hypothesis(scope.form).starts)?;
    ends(&mut sheet, steps);
    sheet.conclude(family_clause(&UPPER, "0"), family_proof(&UPPER, steps, base, "[k]"));
    (known.eps && known.half).then_some(sheet)
}

/// Families that hold at the start hold at every step.
pub fn assumed(scope: &Scope, steps: Steps, families: &[Family]) -> Option<Sheet> {
    let mut system = system(Some(Theorem::UpperBound), scope, steps, false);
    system["starts"] = serde_json::json!({ "theorem": "7.8", "form": "sharp" });
    let mut sheet = Sheet::new(system);
    let known = weights(&mut sheet, Theorem::UpperBound, scope);
    ends(&mut sheet, steps);
    for f in families {
        let start = format!("{}.start", f.name);
        let goal = format!("{} {} 0", (f.of)("0", "i"), f.relation);
        sheet.assume(clause(&start, "i", &["i: i >= 0", "u: last - i >= 0"], &goal));
        let base = positivity(&[instance("h", &start, "i=i", "i=[i], u=[u]")], "[h]");
        sheet.conclude(family_clause(f, "0"), family_proof(f, steps, base, "[k]"));
    }
    (known.eps && known.half).then_some(sheet)
}

/// 7.2: X_i < X_{i+1} for all i and k.
pub fn ordering(scope: &Scope, steps: Steps) -> Option<Sheet> {
    let mut sheet = Sheet::new(system(Some(Theorem::Ordering), scope, steps, true));
    let known = weights(&mut sheet, Theorem::Ordering, scope);
    let three = scope.drones == Some(3);
    let starts = Theorem::Ordering.hypothesis(scope.form).starts;
    if !(known.eps && known.one && (known.half || known.four || three))
        || starts != StartSet::Ordered
    {
        return None;
    }
    ends(&mut sheet, steps);
    let base = positivity(&[instance("h", "start.order", "i=i", "i=[i], n=[u]")], "[h]");
    let gap = |n: &str, at: &str, given: &str| {
        instance(n, "IH", &format!("t=k, i={at}"), &format!("k=[k], t=0, {given}"))
    };
    let step = |n: &str, at: &str, given: &str| {
        instance(n, "step.inner", &format!("k=k, i={at}"), &format!("k=[k], {given}"))
    };
    let moved = |i: &str| format!("(eps*x(k,{i}-1) - 2*eps*x(k,{i}) + eps*x(k,{i}+1))");
    let end = |n: &str, lemma: &str, k: &str| {
        instance(n, lemma, &format!("k={k}"), if k == "k" { "k=[k]" } else { "k=[k] + 1" })
    };
    // The first pair and the last: the gap to the end drone is (1-eps) g + eps g', g' the next gap.
    let convex = |used: &[Value], rest: &str| {
        let with = |sum: &str| positivity(used, &format!("{sum}{rest}"));
        let low = with("[s]*[g] + 1/2*[g] + [eps]*[m]");
        split(
            "s",
            "eps - 1/2",
            [
                with("[one]*[g] + [s]*[m] + 1/2*[m]"),
                with("1/2*[g] + 1/2*[m] - [s]*[g] + [s]*[m]"),
                low,
            ],
        )
    };
    let at_end = |inner: &str, end_lemma: &str, given: &str, g: Value, m: Value, sign: &str| {
        let used = [
            step("h", inner, given),
            end("e", end_lemma, "k + 1"),
            end("z", end_lemma, "k"),
            g.clone(),
            m,
        ];
        let rest = format!(" {sign} [h] {} [e] {sign} [z]", if sign == "+" { "-" } else { "+" });
        match steps {
            Steps::Activation => {
                let still = [
                    step("h", inner, given),
                    end("e", end_lemma, "k + 1"),
                    end("z", end_lemma, "k"),
                    g,
                ];
                let off = format!(
                    "[g] {sign} [h] {0} [e] {sign} [z] {sign} {1}*[a]",
                    if sign == "+" { "-" } else { "+" },
                    moved(inner)
                );
                by_activity(
                    "a",
                    inner,
                    convex(&used, &format!("{rest} {sign} {}*[a-1]", moved(inner))),
                    positivity(&still, &off),
                )
            }
            _ => convex(&used, &rest),
        }
    };
    let (own, left, right) = ("i=[i] + 1, u=[u] + 1", "i=[i], u=[u] + 2", "i=[i] + 2, u=[u]");
    let first = at_end(
        "1",
        "END0",
        "i=0, n=[n]",
        gap("g", "0", "i=0, u=[n] + 1"),
        gap("m", "1", "i=1, u=[n]"),
        "+",
    );
    let last = at_end(
        "last - 1",
        "ENDL",
        "i=[n], n=0",
        gap("g", "last - 1", "i=[n] + 1, u=0"),
        gap("m", "last - 2", "i=[n], u=1"),
        "-",
    );
    let inner = if three {
        absurd(&[], "[i] + [u]")
    } else {
        let mut used =
            vec![step("p", "i + 1", "i=[i] + 1, n=[u]"), step("q", "i", "i=[i], n=[u] + 1")];
        used.extend([gap("g", "i", own), gap("l", "i - 1", left), gap("r", "i + 1", right)]);
        let half = if known.half { "[half]" } else { "[four]" };
        if known.four {
            used.push(instance("four", "weight.four", "", "four=[i] + [u]"));
        }
        let pair = |high: &str, low: &str, rest: &str| {
            let with = |sum: String| positivity(&used, &format!("{sum} + [p] - [q]{rest}"));
            match (high, low) {
                ("on", "on") => split(
                    "s",
                    "eps - 1/4",
                    [
                        with(format!("{half}*[g] + [s]*[l] + 1/4*[l] + [eps]*[r]")),
                        with(format!("{half}*[g] + [s]*[l] + 1/4*[l] + [eps]*[r]")),
                        with("2*[s]*[g] + 1/2*[g] + [eps]*[l] + [eps]*[r]".into()),
                    ],
                ),
                ("on", _) => with(format!("1/2*{half}*[g] + 1/2*[g] + [eps]*[r]")),
                (_, "on") => with(format!("1/2*{half}*[g] + 1/2*[g] + [eps]*[l]")),
                _ => with("[g]".into()),
            }
        };
        match steps {
            Steps::Activation => {
                let rest = |a: &str, b: &str| {
                    format!(" + {}*[{a}] - {}*[{b}]", moved("(i+1)"), moved("i"))
                };
                by_activity(
                    "a",
                    "i + 1",
                    by_activity(
                        "b",
                        "i",
                        pair("on", "on", &rest("a-1", "b-1")),
                        pair("on", "off", &rest("a-1", "b")),
                    ),
                    by_activity(
                        "b",
                        "i",
                        pair("off", "on", &rest("a", "b-1")),
                        pair("off", "off", &rest("a", "b")),
                    ),
                )
            }
            _ => pair("on", "on", ""),
        }
    };
    sheet.conclude(
        clause(
            "ORDER",
            "k i",
            &["k: k >= 0", "i: i >= 0", "u: last - 1 - i >= 0"],
            "x(k,i+1) - x(k,i) > 0",
        ),
        induction("k", "k", "t", base, cases("i", "i", first, cases("u", "i", last, inner))),
    );
    Some(sheet)
}
