//! The bounds of 7.2 and 7.3 are exact, and local machines compute the global run.

use serde_json::json;

use super::builder::{Sheet, cases, clause, induction, instance, positivity};
use super::lemmas::{Scope, by_class, error};

/// Beyond 1/2 a start in 7.2's set, given by formula, crosses at step 1, for every N >= 4.
pub fn ordering_exact(scope: &Scope) -> Option<Sheet> {
    let mut sheet =
        beyond_half("eps - 1/2", "1/2 + eps + last*(eps - 1/2)", "1/2 + eps + i*(eps - 1/2)");
    sheet.assume(clause("four", "", &[], "last >= 3"));
    let later = |n: &str, i: &str, i_given: &str, u: &str| {
        instance(n, "X", &format!("i={i}"), &format!("i={i_given}, u={u}"))
    };
    ends(&mut sheet);
    sheet.conclude(
        clause("ORDER", "i", &["i: i >= 0", "u: last - 1 - i >= 0"], "x(0,i+1) > x(0,i)"),
        cases(
            "i",
            "i",
            positivity(&[], "[X1] - [X0] + 1/2*[beyond]"),
            cases(
                "i",
                "i",
                positivity(&[later("b", "2", "0", "[four] + 1")], "[b] - [X1] + [beyond] + 1"),
                positivity(
                    &[later("b", "i + 1", "[i] + 1", "[u]"), later("a", "i", "[i]", "[u] + 1")],
                    "[b] - [a] + 1/2*[beyond]",
                ),
            ),
        ),
    );
    let step = |n: &str, i: &str, given: &str| {
        instance(n, "step.inner", &format!("k=0, i={i}"), &format!("k=0, {given}"))
    };
    sheet.conclude(
        clause("CROSS", "", &[], "x(1,1) >= x(1,2)"),
        positivity(
            &[
                step("p", "1", "i=0, n=[n]"), step("q", "2", "i=1, n=[four]"),
                later("b", "2", "0", "[four] + 1"), later("d", "3", "1", "[four]"),
            ],
            "[p] - [q] + eps*[X0] + (1 - 3*eps)*[X1] + (3*eps - 1)*[b] - eps*[d] + 1/2*[beyond] + 1/2*[beyond]*[beyond]",
        ),
    );
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// Beyond 1/2 a start in 7.3's set, given by formula, overtakes a target at step 1, for every N >= 3.
pub fn upper_exact(scope: &Scope) -> Option<Sheet> {
    let mut sheet = beyond_half("0", "last", "i");
    ends(&mut sheet);
    let later = |n: &str, i: &str, i_given: &str, u: &str| {
        instance(n, "X", &format!("i={i}"), &format!("i={i_given}, u={u}"))
    };
    sheet.conclude(
        clause(
            "BELOW",
            "i",
            &["i: i >= 0", "u: last - i >= 0"],
            &format!("{} >= 0", error("0", "i")),
        ),
        cases(
            "i",
            "i",
            positivity(&[], "last*[left] - last*[X0]"),
            cases(
                "i",
                "i",
                positivity(&[], "(last - 1)*[left] + [right] - last*[X1] + [last]"),
                positivity(
                    &[later("a", "i", "[i]", "[u]")],
                    "(last - i)*[left] + i*[right] - last*[a]",
                ),
            ),
        ),
    );
    sheet.conclude(
        clause("OVER", "", &[], &format!("{} < 0", error("1", "1"))),
        positivity(
            &[instance("p", "step.inner", "k=0, i=1", "k=0, i=0, n=[n]"), later("b", "2", "0", "[n]")],
            "last*[p] + last*eps*[X0] + last*(1 - 2*eps)*[X1] + last*eps*[b] - (last - 1)*[left] - [right] + [last]*[beyond]",
        ),
    );
    (scope.weights.is_none() && scope.drones.is_none()).then_some(sheet)
}

/// Weights above 1/2; the start x(0,0) = 0, x(0,1), and a formula for every later drone.
fn beyond_half(second: &str, right: &str, later: &str) -> Sheet {
    let mut sheet = Sheet::new(json!({ "protocol": "coverage", "steps": "full" }));
    for (name, goal) in [
        ("beyond", "2*eps > 1"),
        ("left", "min = 0"),
        ("right", &format!("max = {right}")),
        ("X0", "x(0,0) = 0"),
        ("X1", &format!("x(0,1) = {second}")),
    ] {
        sheet.assume(clause(name, "", &[], goal));
    }
    sheet.assume(clause(
        "X",
        "i",
        &["i: i >= 2", "u: last - i >= 0"],
        &format!("x(0,i) = {later}"),
    ));
    sheet
}

/// The start has its ends at min and max.
fn ends(sheet: &mut Sheet) {
    sheet.conclude(clause("FIRST", "", &[], "x(0,0) = min"), positivity(&[], "[X0] - [left]"));
    sheet.conclude(
        clause("LAST", "", &[], "x(0,last) = max"),
        positivity(&[instance("a", "X", "i=last", "i=[n], u=0")], "[a] - [right]"),
    );
}

/// N local machines that exchange positions after every tick hold what the global run has.
pub fn projection(scope: &Scope) -> Option<Sheet> {
    let mut system = json!({ "protocol": "projection", "steps": "full" });
    if let Some(n) = scope.drones {
        system["drones"] = json!(n);
    }
    let mut sheet = Sheet::new(system);
    let start = |f: &str, class: &str| match class {
        "inner" => instance("h", &format!("{f}.start.inner"), "i=i", "i=[i], n=[u]"),
        _ => instance("h", &format!("{f}.start.{class}"), "", ""),
    };
    let all = ["i: i >= 0", "u: last - i >= 0"];
    let own0 = |class: &str| match class {
        "inner" => positivity(&[start("own", "inner")], "[h]"),
        _ => positivity(&[], &format!("[own.start.{class}]")),
    };
    sheet.lemma(
        clause("OWN0", "i", &all, "own(0,i) = x(0,i)"),
        by_class(own0("first"), own0("last"), own0("inner")),
    );
    // What a machine holds of a neighbour is what the neighbour holds of itself.
    for (name, f, i, u, end, on, own) in [
        ("BEFORE", "prec", "i: i >= 1", "u: last - i >= 0", "last", "u", "i - 1"),
        ("BEHIND", "foll", "i: i >= 0", "u: last - 1 - i >= 0", "first", "i", "i + 1"),
    ] {
        let own0 = |i: &str, given: &str| instance("o", "OWN0", &format!("i={i}"), given);
        let (at_end, inside) = match f {
            "prec" => (own0("last - 1", "i=[n] + 1, u=1"), own0("i - 1", "i=[i], u=[u] + 2")),
            _ => (own0("1", "i=1, u=[n] + 1"), own0("i + 1", "i=[i] + 2, u=[u]")),
        };
        let then = |class: &str, with: &str, given: &str| {
            positivity(
                &[instance(
                    "h",
                    &format!("{f}.{class}"),
                    &format!("k=k - 1{with}"),
                    &format!("k=[k]{given}"),
                )],
                "[h]",
            )
        };
        sheet.lemma(
            clause(name, "k i", &["k: k >= 0", i, u], &format!("{f}(k,i) = own(k,{own})")),
            cases(
                "k",
                "k",
                cases(
                    on,
                    "i",
                    positivity(&[at_end], &format!("[{f}.start.{end}] - [o]")),
                    positivity(&[start(f, "inner"), inside], "[h] - [o]"),
                ),
                cases(on, "i", then(end, "", ""), then("inner", ", i=i", ", i=[i], n=[u]")),
            ),
        );
    }
    let ih = |n: &str, i: &str, given: &str| {
        instance(n, "IH", &format!("t=k, i={i}"), &format!("k=[k], t=0, {given}"))
    };
    let both = |class: &str, with: &str, given: &str| {
        [("o", "own"), ("s", "step")].map(|(n, f)| {
            instance(n, &format!("{f}.{class}"), &format!("k=k{with}"), &format!("k=[k]{given}"))
        })
    };
    let end = |class: &str, i: &str, given: &str| {
        positivity(
            &[&both(class, "", "")[..], &[ih("w", i, given)]].concat(),
            "[o] - [s] + (1 - moves(k))*[w]",
        )
    };
    let held = |n: &str, lemma: &str, given: &str| {
        instance(n, lemma, "k=k, i=i", &format!("k=[k], {given}"))
    };
    let inner = positivity(
        &[
            &both("inner", ", i=i", ", i=[i], n=[u]")[..],
            &[
                held("p", "BEFORE", "i=[i], u=[u] + 1"),
                held("f", "BEHIND", "i=[i] + 1, u=[u]"),
                ih("l", "i - 1", "i=[i], u=[u] + 2"),
                ih("w", "i", "i=[i] + 1, u=[u] + 1"),
                ih("r", "i + 1", "i=[i] + 2, u=[u]"),
            ],
        ]
        .concat(),
        "[o] - [s] + moves(k)*eps*([p] + [l] + [f] + [r]) + (1 - 2*eps*moves(k))*[w]",
    );
    sheet.conclude(
        clause("OWN", "k i", &["k: k >= 0", all[0], all[1]], "own(k,i) = x(k,i)"),
        induction(
            "k",
            "k",
            "t",
            positivity(&[instance("h", "OWN0", "i=i", "i=[i], u=[u]")], "[h]"),
            by_class(
                end("first", "0", "i=0, u=[last]"),
                end("last", "last", "i=[last], u=0"),
                inner,
            ),
        ),
    );
    for (name, lemma, f, i, u, other, given) in [
        ("PREC", "BEFORE", "prec", "i: i >= 1", "u: last - i >= 0", "i - 1", "i=[i], u=[u] + 1"),
        (
            "FOLL",
            "BEHIND",
            "foll",
            "i: i >= 0",
            "u: last - 1 - i >= 0",
            "i + 1",
            "i=[i] + 1, u=[u]",
        ),
    ] {
        sheet.conclude(
            clause(name, "k i", &["k: k >= 0", i, u], &format!("{f}(k,i) = x(k,{other})")),
            positivity(
                &[
                    held("h", lemma, "i=[i], u=[u]"),
                    instance("o", "OWN", &format!("k=k, i={other}"), &format!("k=[k], {given}")),
                ],
                "[h] + [o]",
            ),
        );
    }
    scope.weights.is_none().then_some(sheet)
}
