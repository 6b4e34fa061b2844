//! 7.8 for every N: convergence below the critical weight, and none from there on.
//!
//! The critical weight is met as the spec has it: by the leading minors, minor(i+1) =
//! (2-2eps) minor(i) - eps^2 minor(i-1). With p(i) = eps^i, v(i) = p(last-i) minor(i) solves
//! eps (v(i-1) + v(i+1)) = (2-2eps) v(i), and z the same with a one added. Then W(i) = z(last) v(i) - z(i) v(last)
//! is 0 at the ends, above 0 between, and |A| W = W - v(last) for eps >= 1/2: errors within M W shrink in every step.

use cordon_spec::theorems::{Form, Theorem};
use serde_json::{Value, json};

use super::builder::{
    Sheet, absurd, cases, clause, induction, instance, positivity, positivity_times, split,
};
use super::lemmas::{Scope, Steps, by_class, ends, error, system};

/// p(last-i) * minor(i).
fn v(i: &str) -> String {
    format!("p(last-({i}))*minor({i})")
}

/// z(last) v(i) - z(i) v(last), v(last) being minor(last).
fn w(i: &str) -> String {
    format!("(z(last)*{} - z({i})*minor(last))", v(i))
}

fn powers(sheet: &mut Sheet) {
    sheet.define("p", &["i"], &["1"], "eps*p(i)", None);
}

/// p(i) > 0, given the fact `eps`; and `REC`, the recurrence of v, the one of the minors being the instance `st`.
fn recurrence(sheet: &mut Sheet, st: &Value, given: &[&str]) {
    let step = |n: &str, i: &str, from: &str| {
        instance(n, "p.step", &format!("i={i}"), &format!("from={from}"))
    };
    sheet.lemma(
        clause("P", "i", &["i: i >= 0"], "p(i) > 0"),
        induction(
            "i",
            "i",
            "t",
            positivity(&[], "[p.0] + 1"),
            positivity(
                &[step("h", "i", "[i]"), instance("ih", "IH", "t=i", "i=[i], t=0")],
                "[h] + [eps]*[ih]",
            ),
        ),
    );
    sheet.lemma(
        clause(
            "REC",
            "i",
            given,
            &format!("eps*({} + {}) = (2 - 2*eps)*{}", v("i-1"), v("i+1"), v("i")),
        ),
        positivity(
            &[st.clone(), step("a", "last - i", "[u] + 1"), step("b", "last - i - 1", "[u]")],
            "eps*minor(i-1)*[a] - minor(i+1)*[b] + p(last-i)*[st]",
        ),
    );
}

const INNER: [&str; 2] = ["i: i >= 1", "u: last - 1 - i >= 0"];

/// Convergence: for eps <= 1/2 at the rate 1 - 8eps/(N-1)^2 in the norm of i(N-1-i), for 1/2 <= eps
/// below the critical weight at an explicit rate in the norm of W.
pub fn limit(scope: &Scope) -> Option<Sheet> {
    let mut sheet = Sheet::new(system(Some(Theorem::Limit), scope, Steps::Full, true));
    powers(&mut sheet);
    let sum = Some(("eps", "[weight.low]"));
    sheet.define("z", &["i"], &["0", "0"], "(2 - 2*eps)*z(i+1) - eps*z(i) + 1", sum);
    sheet.constant("rate", "real");
    sheet.define("r", &["k"], &["1"], "rate*r(k)", None);
    let sum = Some(("last*last", "[last]*[last]"));
    sheet.define("a", &["k"], &["1"], "(last*last - 8*eps)*a(k)", sum);
    sheet.assume(clause("RATE", "", &[], "z(last)*rate = z(last) - minor(last)"));
    let all = ["i: i >= 0", "u: last - i >= 0", "s: s*s = 1"];
    for (m, name, weight) in
        [("L", "SMALL.start", "i*(last-i)".to_owned()), ("M", "LARGE.start", w("i"))]
    {
        sheet.constant(m, "real");
        sheet.assume(clause(m, "", &[], &format!("{m} >= 0")));
        sheet.assume(clause(
            name,
            "i s:real",
            &all,
            &format!("{m}*{weight} - s*({}) >= 0", error("0", "i")),
        ));
    }
    sheet.lemma(clause("eps", "", &[], "eps > 0"), positivity(&[], "[weight.low]"));
    ends(&mut sheet, Steps::Full);
    small(&mut sheet);
    weight(&mut sheet);
    large(&mut sheet);
    (scope.form == Form::Sharp && scope.weights.is_none()).then_some(sheet)
}

/// The step of a drone at an end: its error and its weight (0 as the sum `zero` says) are 0.
fn still(lemma: &str, zero: &str) -> Value {
    positivity(&[instance("z", lemma, "k=k + 1", "k=[k] + 1")], &format!("s*last*[z]{zero}"))
}

fn neighbour(n: &str, i: &str, s: &str, given: &str) -> Value {
    let given = format!("k=[k], t=0, s=[s], {given}");
    instance(n, "IH", &format!("t=k, i={i}, s={s}"), &given)
}

/// eps <= 1/2.
fn small(sheet: &mut Sheet) {
    let half = "half: 1 - 2*eps >= 0";
    sheet.conclude(
        clause("SMALL.rate", "", &[half], "last*last - 8*eps >= 0"),
        positivity(&[], "[n]*[n] + 4*[n] + 4*[half]"),
    );
    let kept = instance("kept", "SMALL.kept", "", "half=[half]");
    sheet.lemma(
        clause("SMALL.kept", "", &[half], "last*last - 8*eps >= 0"),
        positivity(&[], "[n]*[n] + 4*[n] + 4*[half]"),
    );
    let step = instance("as", "a.step", "k=k", "from=[k]");
    sheet.lemma(
        clause("A", "k", &["k: k >= 0", half], "a(k) >= 0"),
        induction(
            "k",
            "k",
            "t",
            positivity(&[], "[a.0] + 1"),
            positivity_times(
                &["last", "last"],
                &[step.clone(), kept, instance("ih", "IH", "t=k", "k=[k], t=0, half=[half]")],
                "[as] + [kept]*[ih]",
            ),
        ),
    );
    let used = [
        instance("h", "step.inner", "k=k, i=i", "k=[k], i=[i], n=[u]"),
        step,
        instance("ak", "A", "k=k", "k=[k], half=[half]"),
        neighbour("l", "i - 1", "s", "half=[half], i=[i], u=[u] + 2"),
        neighbour("o", "i", "s", "half=[half], i=[i] + 1, u=[u] + 1"),
        neighbour("r", "i + 1", "s", "half=[half], i=[i] + 2, u=[u]"),
    ];
    let with = |square: &str| {
        let average =
            "[last]*[last]*[eps]*[l] + [last]*[last]*[half]*[o] + [last]*[last]*[eps]*[r]";
        let sum = format!("{average} + last*last*s*last*[h] + L*i*(last-i)*[as] + {square}");
        positivity_times(&["last", "last"], &used, &sum)
    };
    let square = "2*[L]*[ak]*[eps]*([q]+1)*([q]+1)";
    let inner =
        split("q", "last - 2*i", [with(square), with("2*L*a(k)*eps*(last-2*i)*[q]"), with(square)]);
    let start = instance("h", "SMALL.start", "i=i, s=s", "i=[i], u=[u], s=[s]");
    sheet.conclude(
        clause(
            "SMALL",
            "k i s:real",
            &["k: k >= 0", "i: i >= 0", "u: last - i >= 0", "s: s*s = 1", half],
            &format!("L*a(k)*i*(last-i) - s*({}) >= 0", error("k", "i")),
        ),
        induction(
            "k",
            "k",
            "t",
            positivity(&[start], "[h] + L*i*(last-i)*[a.0]"),
            by_class(still("END0", ""), still("ENDL", ""), inner),
        ),
    );
}

/// W is above 0 on the inner drones, at most z(last), and loses minor(last) in a step.
fn weight(sheet: &mut Sheet) {
    let ge = "ge: 2*eps - 1 >= 0";
    let minor =
        |n: &str, i: &str, given: &str| instance(n, "minor.positive", &format!("i={i}"), given);
    let st = instance("st", "minor.step", "i=i", "i=[i], n=[u]");
    recurrence(sheet, &st, &INNER);
    sheet.lemma(
        clause("UNIT", "", &[], "eps < 1"),
        positivity(
            &[minor("m", "2", "i=1, n=[n]"), instance("st", "minor.step", "i=1", "i=0, n=[n]")],
            "1/2*[m] - 1/2*[st] + 1/2*eps*eps*[minor.0] - (1-eps)*[minor.1]",
        ),
    );
    sheet.lemma(
        clause("PLE", "i", &["i: i >= 0"], "p(i) <= 1"),
        induction(
            "i",
            "i",
            "t",
            positivity(&[], "-[p.0]"),
            positivity(
                &[
                    instance("h", "p.step", "i=i", "from=[i]"),
                    instance("ih", "IH", "t=i", "i=[i], t=0"),
                ],
                "[UNIT] + [eps]*[ih] - [h]",
            ),
        ),
    );
    sheet.lemma(
        clause("MINOR", "i", &["i: i >= 0", "u: last - i >= 0"], "minor(i) >= 0"),
        cases(
            "i",
            "i",
            positivity(&[], "[minor.0]"),
            positivity(&[minor("m", "i", "i=[i], n=[u]")], "[m]"),
        ),
    );
    sheet.lemma(
        clause("MINORLE", "i", &["i: i >= 1", "u: last - i >= 0", ge], "minor(i) <= 1"),
        induction(
            "i",
            "i",
            "t",
            positivity(&[], "-[minor.1]"),
            positivity(
                &[
                    minor("m", "i", "i=[i], n=[u] + 1"),
                    instance("mm", "MINOR", "i=i - 1", "i=[i], u=[u] + 2"),
                    instance("st", "minor.step", "i=i", "i=[i], n=[u]"),
                    instance("ih", "IH", "t=i", "i=[i], t=0, u=[u] + 1, ge=[ge]"),
                ],
                "[ih] + [ge]*[m] + [eps]*[eps]*[mm] - [st]",
            ),
        ),
    );
    let upto = ["i: i >= 1", "u: last - i >= 0"];
    let p = |n: &str, lemma: &str, i: &str, given: &str| {
        instance(n, lemma, &format!("i={i}"), &format!("i={given}"))
    };
    sheet.lemma(
        clause("V", "i", &upto, &format!("{} > 0", v("i"))),
        positivity(&[minor("m", "i", "i=[i], n=[u]"), p("p", "P", "last - i", "[u]")], "[p]*[m]"),
    );
    sheet.lemma(
        clause("VLE", "i", &[upto[0], upto[1], ge], &format!("{} <= 1", v("i"))),
        positivity(
            &[
                p("p", "P", "last - i", "[u]"),
                p("q", "PLE", "last - i", "[u]"),
                instance("m", "MINORLE", "i=i", "i=[i], u=[u], ge=[ge]"),
            ],
            "[q] + [p]*[m]",
        ),
    );
    let vi = |n: &str, i: &str, given: &str| instance(n, "V", &format!("i={i}"), given);
    let zs = |n: &str, i: &str, from: &str| {
        instance(n, "z.step", &format!("i={i}"), &format!("from={from}"))
    };
    sheet.lemma(
        clause("D", "i", &INNER, &format!("z(i+1)*{} - z(i)*{} > 0", v("i"), v("i+1"))),
        induction(
            "i",
            "i",
            "t",
            positivity_times(
                &["eps"],
                &[vi("v", "1", "i=0, u=[u] + 1"), zs("zs", "0", "0")],
                &format!(
                    "[v] + {}*([zs] + (2-2*eps)*[z.1] - eps*[z.0]) - eps*{}*[z.1]",
                    v("1"),
                    v("2")
                ),
            ),
            positivity_times(
                &["eps"],
                &[
                    vi("v", "i + 1", "i=[i] + 1, u=[u] + 1"),
                    zs("zs", "i", "[i] + 1"),
                    instance("rec", "REC", "i=i + 1", "i=[i] + 1, u=[u]"),
                    instance("ih", "IH", "t=i", "i=[i], t=0, u=[u] + 1"),
                ],
                &format!("[v] + {}*[zs] - z(i+1)*[rec] + [eps]*[ih]", v("i+1")),
            ),
        ),
    );
    let (j, j1) = ("i + 1 + t", "i + 2 + t");
    sheet.lemma(
        clause(
            "RATIO",
            "i t",
            &["i: i >= 1", "t: t >= 0", "u: last - 1 - i - t >= 0"],
            &format!("z({j})*{} - z(i)*{} > 0", v("i"), v(j)),
        ),
        induction(
            "t",
            "t",
            "e",
            positivity(&[instance("d", "D", "i=i", "i=[i], u=[u]")], "[d]"),
            positivity_times(
                &["vj"],
                &[
                    vi("vi", "i", "i=[i], u=[u] + [t] + 2"),
                    vi("vj", j, "i=[i] + [t] + 1, u=[u] + 1"),
                    vi("vk", j1, "i=[i] + [t] + 2, u=[u]"),
                    instance("d", "D", &format!("i={j}"), "i=[i] + [t] + 1, u=[u]"),
                    instance("ih", "IH", "e=t, i=i", "i=[i], t=[t], e=0, u=[u] + 1"),
                ],
                "[vi]*[d] + [vk]*[ih]",
            ),
        ),
    );
    sheet.conclude(
        clause("WEIGHT", "i", &INNER, &format!("{} > 0", w("i"))),
        positivity(
            &[instance("h", "RATIO", "i=i, t=last - i - 1", "i=[i], t=[u], u=0")],
            "[h] + z(i)*minor(last)*[p.0]",
        ),
    );
    let first = |n: &str, t: &str, given: &str| {
        instance(n, "RATIO", &format!("i=1, t={t}"), &format!("i=0, {given}"))
    };
    sheet.lemma(
        clause("Z", "", &[], "z(last) > 0"),
        positivity_times(
            &["v"],
            &[vi("v", "1", "i=0, u=[n] + 1"), first("h", "last - 2", "t=[n], u=0")],
            &format!("[h] + {}*[z.1]", v("last")),
        ),
    );
    sheet.lemma(
        clause("ZNN", "i", &upto, "z(i) >= 0"),
        cases(
            "i",
            "i",
            positivity(&[], "[z.1]"),
            positivity_times(
                &["v"],
                &[vi("v", "1", "i=0, u=[n] + 1"), first("h", "i - 2", "t=[i], u=[u]")],
                &format!("[h] + {}*[z.1]", v("i")),
            ),
        ),
    );
    sheet.lemma(
        clause("WLE", "i", &[upto[0], upto[1], ge], &format!("{} <= z(last)", w("i"))),
        positivity(
            &[
                instance("v", "VLE", "i=i", "i=[i], u=[u], ge=[ge]"),
                instance("z", "ZNN", "i=i", "i=[i], u=[u]"),
                minor("m", "last", "i=[n] + 1, n=0"),
            ],
            "[Z]*[v] + [z]*[m]",
        ),
    );
    sheet.lemma(
        clause(
            "WREC",
            "i",
            &INNER,
            &format!("(2-2*eps)*{} - eps*({} + {}) = minor(last)", w("i"), w("i-1"), w("i+1")),
        ),
        positivity(
            &[instance("rec", "REC", "i=i", "i=[i], u=[u]"), zs("zs", "i - 1", "[i]")],
            "minor(last)*[zs] - z(last)*[rec]",
        ),
    );
    sheet.lemma(
        clause("WNN", "i", &["i: i >= 0", "u: last - i >= 0"], &format!("{} >= 0", w("i"))),
        by_class(
            positivity(&[], "z(last)*p(last)*[minor.0] - minor(last)*[z.0]"),
            positivity(&[], "z(last)*minor(last)*[p.0]"),
            positivity(
                &[instance("h", "RATIO", "i=i, t=last - i - 1", "i=[i], t=[u], u=0")],
                "[h] + z(i)*minor(last)*[p.0]",
            ),
        ),
    );
}

/// eps >= 1/2.
fn large(sheet: &mut Sheet) {
    let ge = "ge: 2*eps - 1 >= 0";
    let weight = |n: &str, i: &str, given: &str| instance(n, "WNN", &format!("i={i}"), given);
    let minor = instance("m", "minor.positive", "i=last", "i=[n] + 1, n=0");
    let nonnegative = positivity_times(
        &["Z"],
        &[
            instance("le", "WLE", "i=1", "i=0, u=[n] + 1, ge=[ge]"),
            instance("rec", "WREC", "i=1", "i=0, u=[n]"),
            weight("a", "0", "i=0, u=[last]"),
            weight("b", "1", "i=1, u=[n] + 1"),
            weight("c", "2", "i=2, u=[n]"),
        ],
        "[RATE] + [le] + [rec] + [ge]*[b] + [eps]*[a] + [eps]*[c]",
    );
    sheet.lemma(clause("RATENN", "", &[ge], "rate >= 0"), nonnegative.clone());
    sheet.conclude(clause("LARGE.nonnegative", "", &[ge], "rate >= 0"), nonnegative);
    sheet.conclude(
        clause("LARGE.rate", "", &[], "rate < 1"),
        positivity_times(&["Z"], std::slice::from_ref(&minor), "[m] - [RATE]"),
    );
    let step = instance("rs", "r.step", "k=k", "from=[k]");
    sheet.lemma(
        clause("R", "k", &["k: k >= 0", ge], "r(k) >= 0"),
        induction(
            "k",
            "k",
            "t",
            positivity(&[], "[r.0] + 1"),
            positivity(
                &[
                    step.clone(),
                    instance("nn", "RATENN", "", "ge=[ge]"),
                    instance("ih", "IH", "t=k", "k=[k], t=0, ge=[ge]"),
                ],
                "[rs] + [nn]*[ih]",
            ),
        ),
    );
    let inner = positivity_times(
        &["Z"],
        &[
            instance("h", "step.inner", "k=k, i=i", "k=[k], i=[i], n=[u]"),
            step,
            minor,
            instance("rk", "R", "k=k", "k=[k], ge=[ge]"),
            instance("rec", "WREC", "i=i", "i=[i], u=[u]"),
            instance("le", "WLE", "i=i", "i=[i], u=[u] + 1, ge=[ge]"),
            neighbour("l", "i - 1", "s", "ge=[ge], i=[i], u=[u] + 2"),
            neighbour("o", "i", "-s", "ge=[ge], i=[i] + 1, u=[u] + 1"),
            neighbour("r", "i + 1", "s", "ge=[ge], i=[i] + 2, u=[u]"),
        ],
        &format!(
            "[Z]*[eps]*[l] + [Z]*[eps]*[r] + [Z]*[ge]*[o] + z(last)*(s*last*[h] + M*{0}*[rs] + M*r(k)*[rec]) \
             + [M]*[rk]*[m]*[le] + M*r(k)*{0}*[RATE]",
            w("i")
        ),
    );
    let start = instance("h", "LARGE.start", "i=i, s=s", "i=[i], u=[u], s=[s]");
    sheet.conclude(
        clause(
            "LARGE",
            "k i s:real",
            &["k: k >= 0", "i: i >= 0", "u: last - i >= 0", "s: s*s = 1", ge],
            &format!("M*r(k)*{} - s*({}) >= 0", w("i"), error("k", "i")),
        ),
        induction(
            "k",
            "k",
            "t",
            positivity(&[start], &format!("[h] + M*{}*[r.0]", w("i"))),
            by_class(
                still("END0", " + M*r(k+1)*(z(last)*p(last)*[minor.0] - minor(last)*[z.0])"),
                still("ENDL", " + M*r(k+1)*z(last)*minor(last)*[p.0]"),
                inner,
            ),
        ),
    );
}

/// No convergence from the critical weight on: where minor(j+1) is the first that is not above 0, errors g(i) v(i) up
/// to drone j, g alternating, stay at least so large.
pub fn beyond(scope: &Scope) -> Option<Sheet> {
    let mut sheet = Sheet::new(json!({
        "protocol": "coverage", "steps": "full", "starts": { "theorem": "7.8", "form": "sharp" },
    }));
    sheet.define("minor", &["i"], &["0", "1"], "2*(1-eps)*minor(i+1) - eps*eps*minor(i)", None);
    powers(&mut sheet);
    sheet.define("g", &["i"], &["1"], "-g(i)", None);
    sheet.constant("j", "integer");
    for (name, goal) in [
        ("half", "2*eps >= 1"),
        ("j", "j >= 1"),
        ("room", "last - 1 - j >= 0"),
        ("crossed", "minor(j+1) <= 0"),
    ] {
        sheet.assume(clause(name, "", &[], goal));
    }
    sheet.assume(clause("before", "i", &["i: i >= 1", "u: j - i >= 0"], "minor(i) > 0"));
    sheet.assume(clause(
        "near",
        "i",
        &["i: i >= 0", "u: j - i >= 0"],
        &format!("{} = g(i)*{}", error("0", "i"), v("i")),
    ));
    sheet.assume(clause(
        "far",
        "i",
        &["i: i >= j + 1", "u: last - i >= 0"],
        &format!("{} = 0", error("0", "i")),
    ));
    sheet.lemma(clause("eps", "", &[], "eps > 0"), positivity(&[], "1/2*[half] + 1/2"));
    ends(&mut sheet, Steps::Full);
    recurrence(&mut sheet, &instance("st", "minor.step", "i=i - 1", "from=[i]"), &INNER);
    let turn = |n: &str, i: &str, from: &str| {
        instance(n, "g.step", &format!("i={i}"), &format!("from={from}"))
    };
    sheet.lemma(
        clause("G", "i", &["i: i >= 0"], "g(i)*g(i) = 1"),
        induction(
            "i",
            "i",
            "t",
            positivity(&[], "(g(0) + 1)*[g.0]"),
            positivity(
                &[turn("h", "i", "[i]"), instance("ih", "IH", "t=i", "i=[i], t=0")],
                "(g(i+1) - g(i))*[h] + [ih]",
            ),
        ),
    );
    let power = |i: &str, given: &str| instance("p", "P", &format!("i={i}"), &format!("i={given}"));
    sheet.lemma(
        clause("V", "i", &["i: i >= 0", "u: j - i >= 0"], &format!("{} >= 0", v("i"))),
        cases(
            "i",
            "i",
            positivity(&[], "p(last)*[minor.0]"),
            positivity(
                &[
                    power("last - i", "[u] + [room] + 1"),
                    instance("m", "before", "i=i", "i=[i], u=[u]"),
                ],
                "[p]*[m]",
            ),
        ),
    );
    sheet.conclude(
        clause("AWAY", "", &[], &format!("{} > 0", v("1"))),
        positivity(
            &[power("last - 1", "[n] + 1"), instance("m", "before", "i=1", "i=0, u=[j]")],
            "[p]*[m]",
        ),
    );
    // With m = 1, up to drone j, at least v; with m = 0, everywhere, at least 0.
    let at = |n: &str, i: &str, m: &str, given: &str| {
        instance(n, "IH", &format!("t=k, i={i}, m={m}"), &format!("k=[k], t=0, {given}"))
    };
    let (zero, one) = ("m=0, e=1, b=0", "m=1, e=0");
    let signs = |i: &str| {
        let (before, here) = (error("k", &format!("{i}-1")), error("k", i));
        format!("eps*({before})*([ga] - [gb]) + (1-2*eps)*({here})*[ga] - last*g(k+{i}+1)*[h]")
    };
    let step = |i: &str, signs: &str, rest: [Value; 3], more: &[Value], sum: &str| {
        let mut used = vec![
            instance(
                "h",
                "step.inner",
                &format!("k=k, i={i}"),
                if i == "j" { "k=[k], i=[j], n=[room]" } else { "k=[k], i=[i], n=[u]" },
            ),
            turn(
                "ga",
                &format!("k + {i}"),
                if i == "j" { "[k] + [j] + 1" } else { "[k] + [i] + 1" },
            ),
            turn("gb", &format!("k + {i} - 1"), if i == "j" { "[k] + [j]" } else { "[k] + [i]" }),
        ];
        used.extend(rest);
        used.extend_from_slice(more);
        positivity(&used, &format!("[eps]*[l] + [half]*[o] + [eps]*[r] + {signs}{sum}"))
    };
    let none = by_class(
        positivity(&[instance("z", "END0", "k=k + 1", "k=[k] + 1")], "-last*g(k+1)*[z]"),
        positivity(&[instance("z", "ENDL", "k=k + 1", "k=[k] + 1")], "-last*g(k+1+last)*[z]"),
        step(
            "i",
            &signs("i"),
            [
                at("l", "i - 1", "0", &format!("{zero}, i=[i], u=[u] + 2")),
                at("o", "i", "0", &format!("{zero}, i=[i] + 1, u=[u] + 1")),
                at("r", "i + 1", "0", &format!("{zero}, i=[i] + 2, u=[u]")),
            ],
            &[],
            "",
        ),
    );
    let rec = |i: &str, given: &str| instance("rec", "REC", &format!("i={i}"), given);
    let some = cases(
        "i",
        "i",
        positivity(
            &[instance("z", "END0", "k=k + 1", "k=[k] + 1")],
            "-last*g(k+1)*[z] - p(last)*[minor.0]",
        ),
        cases(
            "b",
            "i",
            step(
                "j",
                &signs("j"),
                [
                    at("l", "j - 1", "1", &format!("{one}, b=1, i=[j], u=[room] + 2")),
                    at("o", "j", "1", &format!("{one}, b=0, i=[j] + 1, u=[room] + 1")),
                    at("r", "j + 1", "0", &format!("{zero}, i=[j] + 2, u=[room]")),
                ],
                &[rec("j", "i=[j], u=[room]"), power("last - j - 1", "[room]")],
                " + [rec] + [eps]*[p]*[crossed]",
            ),
            step(
                "i",
                &signs("i"),
                [
                    at("l", "i - 1", "1", &format!("{one}, b=[b] + 2, i=[i], u=[u] + 2")),
                    at("o", "i", "1", &format!("{one}, b=[b] + 1, i=[i] + 1, u=[u] + 1")),
                    at("r", "i + 1", "1", &format!("{one}, b=[b], i=[i] + 2, u=[u]")),
                ],
                &[rec("i", "i=[i], u=[u]")],
                " + [rec]",
            ),
        ),
    );
    let some = cases("u", "i", absurd(&[], "[b] + [room]"), some);
    let gone = absurd(&[], "[m] + [e]");
    let g = instance("g", "G", "i=i", "i=[i]");
    let near = [
        instance("h", "near", "i=i", "i=[i], u=[s]"),
        g.clone(),
        instance("v", "V", "i=i", "i=[i], u=[s]"),
    ];
    let base = cases(
        "m",
        "m",
        split(
            "s",
            "j - i",
            [
                positivity(
                    &[
                        instance("h", "near", "i=i", "i=[i], u=[s] + 1"),
                        g.clone(),
                        instance("v", "V", "i=i", "i=[i], u=[s] + 1"),
                    ],
                    &format!("g(i)*[h] + {}*[g] + [v]", v("i")),
                ),
                positivity(&near, &format!("g(i)*[h] + {}*[g] + [v]", v("i"))),
                positivity(&[instance("h", "far", "i=i", "i=[s], u=[u]")], "g(i)*[h]"),
            ],
        ),
        cases(
            "e",
            "m",
            positivity(
                &[instance("h", "near", "i=i", "i=[i], u=[b]"), g],
                &format!("g(i)*[h] + {}*[g]", v("i")),
            ),
            gone.clone(),
        ),
    );
    let goal = |m: &str| format!("g(k+i)*({}) - {m}{} >= 0", error("k", "i"), v("i"));
    sheet.lemma(
        clause(
            "BOTH",
            "k i m",
            &[
                "k: k >= 0",
                "i: i >= 0",
                "u: last - i >= 0",
                "m: m >= 0",
                "e: 1 - m >= 0",
                "b: m*(j - i) >= 0",
            ],
            &goal("m*"),
        ),
        induction("k", "k", "t", base, cases("m", "m", none, cases("e", "m", some, gone))),
    );
    sheet.conclude(
        clause("STAYS", "k i", &["k: k >= 0", "i: i >= 0", "u: j - i >= 0"], &goal("")),
        positivity(
            &[instance(
                "h",
                "BOTH",
                "k=k, i=i, m=1",
                "k=[k], i=[i], u=[u] + [room] + 1, m=1, e=0, b=[u]",
            )],
            "[h]",
        ),
    );
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// No convergence for eps <= 0: errors of alternating signs do not shrink.
pub fn low(scope: &Scope) -> Option<Sheet> {
    let mut sheet = Sheet::new(json!({
        "protocol": "coverage", "steps": "full", "starts": { "theorem": "7.8", "form": "sharp" },
    }));
    sheet.define("g", &["i"], &["1"], "-g(i)", None);
    sheet.assume(clause("low", "", &[], "eps <= 0"));
    let all = ["i: i >= 0", "u: last - i >= 0"];
    let start = format!("{} = g(i)*i*(last-i)", error("0", "i"));
    sheet.assume(clause("start", "i", &all, &start));
    ends(&mut sheet, Steps::Full);
    let turn = |n: &str, i: &str, from: &str| {
        instance(n, "g.step", &format!("i={i}"), &format!("from={from}"))
    };
    sheet.lemma(
        clause("G", "i", &["i: i >= 0"], "g(i)*g(i) = 1"),
        induction(
            "i",
            "i",
            "t",
            positivity(&[], "(g(0) + 1)*[g.0]"),
            positivity(
                &[turn("h", "i", "[i]"), instance("ih", "IH", "t=i", "i=[i], t=0")],
                "(g(i+1) - g(i))*[h] + [ih]",
            ),
        ),
    );
    let end = |lemma: &str, i: &str| {
        positivity(&[instance("z", lemma, "k=k + 1", "k=[k] + 1")], &format!("-last*g({i})*[z]"))
    };
    let at = |n: &str, i: &str, given: &str| {
        instance(n, "IH", &format!("t=k, i={i}"), &format!("k=[k], t=0, {given}"))
    };
    let inner = positivity(
        &[
            instance("h", "step.inner", "k=k, i=i", "k=[k], i=[i], n=[u]"),
            turn("ga", "i - 1", "[i]"),
            turn("gb", "i", "[i] + 1"),
            at("l", "i - 1", "i=[i], u=[u] + 2"),
            at("o", "i", "i=[i] + 1, u=[u] + 1"),
            at("r", "i + 1", "i=[i] + 2, u=[u]"),
        ],
        &format!(
            "[low]*[l] + [low]*[r] + [o] + 2*[low]*[o] + [low]*(4*[i]*[u] + 4*[i] + 4*[u] + 2) \
             + eps*({})*[ga] + eps*({})*[gb] - last*g(i)*[h]",
            error("k", "i-1"),
            error("k", "i+1")
        ),
    );
    let base = positivity(
        &[instance("h", "start", "i=i", "i=[i], u=[u]"), instance("g", "G", "i=i", "i=[i]")],
        "g(i)*[h] + i*(last-i)*[g]",
    );
    sheet.conclude(
        clause(
            "STAYS",
            "k i",
            &["k: k >= 0", all[0], all[1]],
            &format!("g(i)*({}) >= i*(last-i)", error("k", "i")),
        ),
        induction("k", "k", "t", base, by_class(end("END0", "0"), end("ENDL", "last"), inner)),
    );
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}
