//! The sum of the positions: 7.4 to 7.7, and consensus. Partial sums c(k,m) = x(k,0) + ... +
//! x(k,m-1); the whole sum is c(k,last+1).

use cordon_spec::theorems::Theorem;
use serde_json::{Value, json};

use super::builder::{
    Sheet, cases, clause, induction, instance, positivity, positivity_times, split,
};
use super::lemmas::{
    Scope, Steps, TARGET, Weights, by_class, ends, error, family_clause, family_proof, system,
    upper_bound, weights,
};

/// N*min + N(N-1)/2 * l: the sum of the targets.
const TARGETS: &str = "(last+1)*min + 1/2*(last+1)*(max - min)";

fn begin(theorem: Theorem, scope: &Scope) -> (Sheet, Weights) {
    let mut sheet = Sheet::new(system(Some(theorem), scope, Steps::Full, true));
    let known = weights(&mut sheet, theorem, scope);
    partial_sums(&mut sheet);
    (sheet, known)
}

fn partial_sums(sheet: &mut Sheet) {
    sheet.define("c", &["k", "m"], &["0"], "c(k,m) + x(k,m)", None);
}

/// c(k,m+1) = c(k,m) + x(k,m).
fn next(name: &str, k: &str, m: &str, from: &str) -> Value {
    instance(name, "c.step", &format!("k={k}, m={m}"), &format!("from={from}"))
}

fn ub(name: &str, k: &str, i: &str, given: &str) -> Value {
    instance(name, "UB", &format!("k={k}, i={i}"), given)
}

/// Step k of drones that average: `INC`, N-1 times the increase of the sum is eps (E_1 + E_{N-2}), by
/// way of the telescoping sum `TEL` and of `SUM`, the same in gaps.
fn increase(sheet: &mut Sheet) {
    let at =
        |n: &str, lemma: &str, k: &str| instance(n, lemma, &format!("k={k}"), &format!("k=[{k}]"));
    let zero = |n: &str, k: &str| instance(n, "c.0", &format!("k={k}"), "");
    sheet.lemma(
        clause(
            "TEL",
            "k m",
            &["k: k >= 0", "m: m >= 1", "u: last - m >= 0"],
            "c(k+1,m) - c(k,m) = eps*((x(k,m) - x(k,m-1)) - (x(k,1) - x(k,0)))",
        ),
        induction(
            "m",
            "m",
            "t",
            positivity(
                &[
                    next("p", "k + 1", "0", "0"),
                    next("q", "k", "0", "0"),
                    zero("y", "k + 1"),
                    zero("z", "k"),
                    at("s", "step.first", "k"),
                    at("e", "END0", "k"),
                ],
                "[p] - [q] + [y] - [z] + [s] - [e]",
            ),
            positivity(
                &[
                    next("p", "k + 1", "m", "[m] + 1"),
                    next("q", "k", "m", "[m] + 1"),
                    instance("h", "step.inner", "k=k, i=m", "k=[k], i=[m], n=[u]"),
                    instance("ih", "IH", "t=m, k=k", "k=[k], m=[m], u=[u] + 1, t=0"),
                ],
                "[p] - [q] + [h] + [ih]",
            ),
        ),
    );
    sheet.lemma(
        clause(
            "SUM",
            "k",
            &["k: k >= 0"],
            "c(k+1,last+1) - c(k,last+1) = eps*((x(k,last) - x(k,last-1)) - (x(k,1) - x(k,0)))",
        ),
        positivity(
            &[
                next("p", "k + 1", "last", "[last]"),
                next("q", "k", "last", "[last]"),
                instance("tel", "TEL", "k=k, m=last", "k=[k], m=[n] + 1, u=0"),
                at("s", "step.last", "k"),
                at("e", "ENDL", "k"),
            ],
            "[p] - [q] + [tel] + [s] - [e]",
        ),
    );
    let ends = format!("{} + {}", error("k", "1"), error("k", "last-1"));
    sheet.lemma(
        clause(
            "INC",
            "k",
            &["k: k >= 0"],
            &format!("last*(c(k+1,last+1) - c(k,last+1)) = eps*({ends})"),
        ),
        positivity(
            &[at("s", "SUM", "k"), at("e", "ENDL", "k"), at("z", "END0", "k")],
            "last*[s] + last*eps*[e] + last*eps*[z]",
        ),
    );
}

/// 7.5 identity: any start with the end drones in place.
pub fn identity(scope: &Scope) -> Option<Sheet> {
    let mut system = system(None, scope, Steps::Full, false);
    system["starts"] = json!({ "theorem": "7.8", "form": "sharp" });
    let mut sheet = Sheet::new(system);
    partial_sums(&mut sheet);
    ends(&mut sheet, Steps::Full);
    increase(&mut sheet);
    sheet.conclude(
        clause(
            "IDENTITY",
            "k",
            &["k: k >= 0"],
            "c(k+1,last+1) - c(k,last+1) = eps*((x(k,last) - x(k,last-1)) - (x(k,1) - x(k,0)))",
        ),
        positivity(&[instance("h", "SUM", "k=k", "k=[k]")], "[h]"),
    );
    Some(sheet)
}

/// m*(N-1)*min + m(m-1)/2 (max-min) - (N-1) c(k,m): the sum of the first m errors, times N-1.
fn deficit(k: &str, m: &str) -> String {
    format!("({m})*last*min + 1/2*({m})*(({m}) - 1)*(max - min) - last*c({k},{m})")
}

/// Partial sums of errors are >= 0, or 0 at the targets: lemma `PART`, where `each` says it of one.
fn parts(sheet: &mut Sheet, k: &str, relation: &str, each: Value) {
    let (vars, given): (&str, &[&str]) = match k {
        "k" => ("k m", &["k: k >= 0", "m: m >= 0", "u: last + 1 - m >= 0"]),
        _ => ("m", &["m: m >= 0", "u: last + 1 - m >= 0"]),
    };
    let (with, sums) = if k == "k" {
        ("t=m, k=k", "k=[k], m=[m], t=0, u=[u] + 1")
    } else {
        ("t=m", "m=[m], t=0, u=[u] + 1")
    };
    sheet.lemma(
        clause("PART", vars, given, &format!("{} {relation} 0", deficit(k, "m"))),
        induction(
            "m",
            "m",
            "t",
            positivity(&[instance("z", "c.0", &format!("k={k}"), "")], "-last*[z]"),
            positivity(
                &[instance("ih", "IH", with, sums), each, next("q", k, "m", "[m]")],
                "[ih] + [e] - last*[q]",
            ),
        ),
    );
}

/// 7.4 (i): the sum is at most that of the targets.
pub fn bounded(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = begin(Theorem::SumBounded, scope);
    upper_bound(&mut sheet, Theorem::SumBounded, scope, known).then_some(())?;
    parts(&mut sheet, "k", ">=", ub("e", "k", "m", "k=[k], i=[m], u=[u]"));
    sheet.conclude(
        clause("BOUND", "k", &["k: k >= 0"], &format!("c(k,last+1) <= {TARGETS}")),
        positivity_times(
            &["last"],
            &[instance("p", "PART", "k=k, m=last + 1", "k=[k], m=[last] + 1, u=0")],
            "[p]",
        ),
    );
    Some(sheet)
}

/// 7.4 (ii), only if: where the sum meets its bound all drones are at their targets.
pub fn maximal(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = begin(Theorem::SumMaximal, scope);
    upper_bound(&mut sheet, Theorem::SumMaximal, scope, known).then_some(())?;
    parts(&mut sheet, "k", ">=", ub("e", "k", "m", "k=[k], i=[m], u=[u]"));
    sheet.lemma(
        clause(
            "REST",
            "k j m",
            &["k: k >= 0", "j: j >= 0", "m: m >= 0", "u: last + 1 - j - m >= 0"],
            &format!("{} - ({}) >= 0", deficit("k", "j+m"), deficit("k", "j")),
        ),
        induction(
            "m",
            "m",
            "t",
            positivity(&[], "0"),
            positivity(
                &[
                    instance("ih", "IH", "t=m, k=k, j=j", "k=[k], j=[j], m=[m], t=0, u=[u] + 1"),
                    ub("e", "k", "j + m", "k=[k], i=[j] + [m], u=[u]"),
                    next("q", "k", "j + m", "[j] + [m]"),
                ],
                "[ih] + [e] - last*[q]",
            ),
        ),
    );
    let given =
        ["k: k >= 0", "i: i >= 0", "u: last - i >= 0", &format!("full: c(k,last+1) = {TARGETS}")];
    let e = error("k", "i");
    sheet.lemma(
        clause("NEG", "k i", &given, &format!("-({e}) >= 0")),
        positivity(
            &[
                instance("r", "REST", "k=k, j=i + 1, m=last - i", "k=[k], j=[i] + 1, m=[u], u=0"),
                instance("p", "PART", "k=k, m=i", "k=[k], m=[i], u=[u] + 1"),
                next("q", "k", "i", "[i]"),
            ],
            "[r] + [p] - last*[q] + last*[full]",
        ),
    );
    let neg = instance("neg", "NEG", "k=k, i=i", "k=[k], i=[i], u=[u], full=[full]");
    sheet.conclude(
        clause("ONLYIF", "k i", &given, &format!("{e} = 0")),
        equal(&e, neg, ub("ub", "k", "i", "k=[k], i=[i], u=[u]")),
    );
    Some(sheet)
}

/// A term that is at most 0 (the instance `neg`) and at least 0 (`ub`) is 0.
fn equal(term: &str, neg: Value, ub: Value) -> Value {
    let against = |used: Value, sum: &str| json!({ "absurd": positivity_times(&["s"], &[used], sum)["positivity"] });
    split("s", term, [against(neg, "[neg]"), positivity(&[], "[s]"), against(ub, "[ub]")])
}

/// All drones at their targets at step K.
fn at_targets(sheet: &mut Sheet) {
    sheet.constant("K", "integer");
    sheet.assume(clause("K", "", &[], "K >= 0"));
    let goal = format!("{} = 0", error("K", "i"));
    sheet.assume(clause("TARGETS", "i", &["i: i >= 0", "u: last - i >= 0"], &goal));
}

/// 7.4 (ii), if: at the targets the sum meets its bound.
pub fn met(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, _) = begin(Theorem::SumMaximal, scope);
    at_targets(&mut sheet);
    parts(&mut sheet, "K", "=", instance("e", "TARGETS", "i=m", "i=[m], u=[u]"));
    sheet.conclude(
        clause("IF", "", &[], &format!("c(K,last+1) = {TARGETS}")),
        positivity_times(
            &["last"],
            &[instance("p", "PART", "m=last + 1", "m=[last] + 1, u=0")],
            "-[p]",
        ),
    );
    Some(sheet)
}

/// 7.5 (i): the sum never decreases.
pub fn non_decreasing(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = begin(Theorem::SumNonDecreasing, scope);
    upper_bound(&mut sheet, Theorem::SumNonDecreasing, scope, known).then_some(())?;
    increase(&mut sheet);
    sheet.conclude(
        clause("INCREASE", "k", &["k: k >= 0"], "c(k+1,last+1) >= c(k,last+1)"),
        positivity_times(
            &["last"],
            &[
                instance("h", "INC", "k=k", "k=[k]"),
                ub("a", "k", "1", "k=[k], i=1, u=[n] + 1"),
                ub("b", "k", "last - 1", "k=[k], i=[n] + 1, u=1"),
            ],
            "[h] + [eps]*[a] + [eps]*[b]",
        ),
    );
    Some(sheet)
}

/// 7.5 (ii): at the targets the sum stays in the next step.
pub fn stationary(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, _) = begin(Theorem::SumStationary, scope);
    at_targets(&mut sheet);
    ends(&mut sheet, Steps::Full);
    increase(&mut sheet);
    let target = |n: &str, i: &str, given: &str| instance(n, "TARGETS", &format!("i={i}"), given);
    sheet.conclude(
        clause("STATIONARY", "", &[], "c(K+1,last+1) = c(K,last+1)"),
        positivity_times(
            &["last"],
            &[
                instance("h", "INC", "k=K", "k=[K]"),
                target("a", "1", "i=1, u=[n] + 1"),
                target("b", "last - 1", "i=[n] + 1, u=1"),
            ],
            "[h] + eps*[a] + eps*[b]",
        ),
    );
    Some(sheet)
}

/// 7.6 (i): at the targets the drones stay, and so does the sum.
pub fn targets_fixed(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, _) = begin(Theorem::TargetsFixed, scope);
    at_targets(&mut sheet);
    ends(&mut sheet, Steps::Full);
    increase(&mut sheet);
    let base = positivity(&[instance("h", "TARGETS", "i=i", "i=[i], u=[u]")], "[h]");
    sheet.conclude(
        family_clause(&TARGET, "K"),
        family_proof(&TARGET, Steps::Full, base, "[k] + [K]"),
    );
    let target = |n: &str, i: &str, given: &str| instance(n, "AT", &format!("k=k, i={i}"), given);
    sheet.conclude(
        clause("STAYS", "k", &["k: k >= K"], "c(k,last+1) = c(K,last+1)"),
        induction(
            "k",
            "k",
            "t",
            positivity(&[], "0"),
            positivity_times(
                &["last"],
                &[
                    instance("h", "INC", "k=k", "k=[k] + [K]"),
                    target("a", "1", "k=[k], i=1, u=[n] + 1"),
                    target("b", "last - 1", "k=[k], i=[n] + 1, u=1"),
                    instance("ih", "IH", "t=k", "k=[k], t=0"),
                ],
                "[h] + eps*[a] + eps*[b] + last*[ih]",
            ),
        ),
    );
    Some(sheet)
}

/// 7.6 (ii): a sum that stays for H >= (N-2)/2 steps from step K on means that all drones are at their
/// targets. The errors of drones m and N-1-m are 0 at steps K .. K+H-m: induction over m (`PULL`).
pub fn constant_sum(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = begin(Theorem::ConstantSum, scope);
    upper_bound(&mut sheet, Theorem::ConstantSum, scope, known).then_some(())?;
    known.positive.then_some(())?;
    increase(&mut sheet);
    for (name, goal) in [("K", "K >= 0"), ("H", "2*H >= last - 1")] {
        sheet.constant(name, "integer");
        sheet.assume(clause(name, "", &[], goal));
    }
    sheet.assume(clause(
        "CONSTANT",
        "m",
        &["m: m >= 0", "u: H - 1 - m >= 0"],
        "c(K+m+1,last+1) = c(K+m,last+1)",
    ));
    let k = "k=[K] + [t]";
    for (name, drone, other, ub_other, mine, outer) in [
        ("LEFT", "m", "last - 1", "i=[n] + 1, u=1", "i=[m] + 1, u=[v] + 2", "i=[m], u=[v] + 3"),
        ("RIGHT", "last - m", "1", "i=1, u=[n] + 1", "i=[v] + 2, u=[m] + 1", "i=[v] + 3, u=[m]"),
    ] {
        let step = if name == "LEFT" { "i=[m], n=[v] + 1" } else { "i=[v] + 1, n=[m]" };
        let before = if name == "LEFT" { "m - 1" } else { "last - m + 1" };
        sheet.lemma(
            clause(
                name,
                "m t",
                &["m: m >= 1", "v: last - 1 - m >= 0", "t: t >= 0", "u: H - m - t >= 0"],
                &format!("-({}) >= 0", error("K+t", drone)),
            ),
            induction(
                "m",
                "m",
                "e",
                positivity_times(
                    &["eps"],
                    &[
                        instance("h", "INC", "k=K + t", k),
                        instance("s", "CONSTANT", "m=t", "m=[t], u=[u]"),
                        ub("o", "K + t", other, &format!("{k}, {ub_other}")),
                    ],
                    "[eps]*[o] + [h] - last*[s]",
                ),
                positivity_times(
                    &["eps"],
                    &[
                        instance(
                            "h",
                            "step.inner",
                            &format!("k=K + t, i={drone}"),
                            &format!("{k}, {step}"),
                        ),
                        instance(
                            "ih",
                            "IH",
                            "e=m, t=t + 1",
                            "m=[m], v=[v] + 1, t=[t] + 1, u=[u], e=0",
                        ),
                        ub("o", "K + t", before, &format!("{k}, {outer}")),
                        ub("w", "K + t", drone, &format!("{k}, {mine}")),
                    ],
                    "[ih] + [eps]*[o] + [half]*[w] - last*[h]",
                ),
            ),
        );
    }
    let e = error("K", "i");
    let given = ["i: i >= 0", "u: last - i >= 0"];
    let end = |lemma: &str, sum: &str| positivity(&[instance("z", lemma, "k=K", "k=[K]")], sum);
    let pull = |lemma: &str, m: &str, given: &str, u: &str| {
        positivity(
            &[instance("p", lemma, &format!("m={m}, t=0"), &format!("{given}, t=0, u={u}"))],
            "[p]",
        )
    };
    let left = |u: &str| pull("LEFT", "i", "m=[i], v=[u]", u);
    sheet.lemma(
        clause("NEG", "i", &given, &format!("-({e}) >= 0")),
        by_class(
            end("END0", "last*[z]"),
            end("ENDL", "last*[z]"),
            split(
                "s",
                "H - i",
                [
                    left("[s] + 1"),
                    left("[s]"),
                    pull("RIGHT", "last - i", "m=[u], v=[i]", "[H] + [s]"),
                ],
            ),
        ),
    );
    let neg = instance("neg", "NEG", "i=i", "i=[i], u=[u]");
    sheet.conclude(
        clause("TARGET", "i", &given, &format!("{e} = 0")),
        equal(&e, neg, ub("ub", "K", "i", "k=[K], i=[i], u=[u]")),
    );
    Some(sheet)
}

/// 7.7: let d be the least depth min(j, N-1-j) of a drone off its target at step K. At step K+t, t < d, all drones of
/// depth below d-t are at their targets (`RETREAT`), and of the two of depth d-t one is before its own
/// (`ADVANCE`). So the sum stays up to step K+d-1 and increases in the next.
pub fn globally_increasing(scope: &Scope) -> Option<Sheet> {
    let (mut sheet, known) = begin(Theorem::GloballyIncreasing, scope);
    upper_bound(&mut sheet, Theorem::GloballyIncreasing, scope, known).then_some(())?;
    known.positive.then_some(())?;
    increase(&mut sheet);
    for (name, goal) in [("K", "K >= 0"), ("d", "d >= 1")] {
        sheet.constant(name, "integer");
        sheet.assume(clause(name, "", &[], goal));
    }
    sheet.assume(clause("DEPTH", "", &[], "last >= 2*d"));
    let both = |k: &str, l: &str, r: &str| format!("{} + {}", error(k, l), error(k, r));
    for (name, at) in [("NEAR", "j"), ("FAR", "last-j")] {
        sheet.assume(clause(
            name,
            "j",
            &["j: j >= 0", "u: d - 1 - j >= 0"],
            &format!("{} = 0", error("K", at)),
        ));
    }
    sheet.assume(clause("OFF", "", &[], &format!("{} > 0", both("K", "d", "last-d"))));
    let k = "k=[K] + [t]";
    for (name, base, at, end) in
        [("RETREAT.L", "NEAR", "j", "END0"), ("RETREAT.R", "FAR", "last-j", "ENDL")]
    {
        let deep = "[DEPTH] + [u] + [t] + [d] + 2";
        let side = if at == "j" { format!("i=[j], n={deep}") } else { format!("i={deep}, n=[j]") };
        let ih = |n: &str, j: &str, given: &str| {
            instance(n, "IH", &format!("e=t, j={j}"), &format!("t=[t], e=0, {given}"))
        };
        let (step, used) = (format!("k=K + t, i={at}"), format!("{k}, {side}"));
        sheet.lemma(
            clause(
                name,
                "t j",
                &["t: t >= 0", "j: j >= 0", "u: d - 1 - t - j >= 0"],
                &format!("{} = 0", error("K+t", at)),
            ),
            induction(
                "t",
                "t",
                "e",
                positivity(&[instance("h", base, "j=j", "j=[j], u=[u]")], "[h]"),
                cases(
                    "j",
                    "j",
                    positivity(
                        &[instance("z", end, "k=K + t + 1", &format!("{k} + 1"))],
                        "-last*[z]",
                    ),
                    positivity(
                        &[
                            instance("h", "step.inner", &step, &used),
                            ih("o", "j - 1", "j=[j], u=[u] + 2"),
                            ih("w", "j", "j=[j] + 1, u=[u] + 1"),
                            ih("r", "j + 1", "j=[j] + 2, u=[u]"),
                        ],
                        "eps*[o] + (1 - 2*eps)*[w] + eps*[r] - last*[h]",
                    ),
                ),
            ),
        );
    }
    let far = "[DEPTH] + [d] + [t]";
    sheet.lemma(
        clause("ADVANCE", "t", &["t: t >= 0", "u: d - 1 - t >= 0"], &format!("{} > 0", both("K+t", "d-t", "last-d+t"))),
        induction(
            "t", "t", "e", positivity(&[], "[OFF]"),
            positivity(
                &[
                    instance("l", "step.inner", "k=K + t, i=d - t - 1", &format!("{k}, i=[u], n={far} + 1")),
                    instance("r", "step.inner", "k=K + t, i=last - d + t + 1", &format!("{k}, i={far} + 1, n=[u]")),
                    instance("ih", "IH", "e=t", "t=[t], e=0, u=[u] + 1"),
                    ub("a", "K + t", "d - t - 2", &format!("{k}, i=[u], u={far} + 3")), ub("b", "K + t", "d - t - 1", &format!("{k}, i=[u] + 1, u={far} + 2")),
                    ub("f", "K + t", "last - d + t + 2", &format!("{k}, u=[u], i={far} + 3")), ub("g", "K + t", "last - d + t + 1", &format!("{k}, u=[u] + 1, i={far} + 2")),
                ],
                "[eps]*[ih] + [eps]*[a] + [half]*[b] + [eps]*[f] + [half]*[g] - last*[l] - last*[r]",
            ),
        ),
    );
    let retreat = |n: &str, side: &str| instance(n, side, "t=t, j=1", "t=[t], j=1, u=[u]");
    sheet.conclude(
        clause(
            "STAYS",
            "t",
            &["t: t >= 0", "u: d - 2 - t >= 0"],
            "c(K+t+1,last+1) = c(K+t,last+1)",
        ),
        positivity_times(
            &["last"],
            &[
                instance("h", "INC", "k=K + t", k),
                retreat("a", "RETREAT.L"),
                retreat("b", "RETREAT.R"),
            ],
            "[h] + eps*[a] + eps*[b]",
        ),
    );
    sheet.conclude(
        clause("INCREASE", "", &[], "c(K+d,last+1) > c(K+d-1,last+1)"),
        positivity_times(
            &["last"],
            &[
                instance("h", "INC", "k=K + d - 1", "k=[K] + [d]"),
                instance("a", "ADVANCE", "t=d - 1", "t=[d], u=0"),
            ],
            "[h] + [eps]*[a]",
        ),
    );
    Some(sheet)
}

/// Equation 6 on a path: consensus preserves the sum of the positions.
pub fn consensus(scope: &Scope) -> Option<Sheet> {
    let mut system = json!({ "protocol": "consensus", "steps": "full" });
    if let Some(n) = scope.drones {
        system["drones"] = json!(n);
    }
    let mut sheet = Sheet::new(system);
    partial_sums(&mut sheet);
    let zero = |n: &str, k: &str| instance(n, "c.0", &format!("k={k}"), "");
    let at = |n: &str, class: &str| instance(n, &format!("step.{class}"), "k=k", "k=[k]");
    sheet.lemma(
        clause(
            "TEL",
            "k m",
            &["k: k >= 0", "m: m >= 1", "u: last - m >= 0"],
            "c(k+1,m) - c(k,m) = eps*(x(k,m) - x(k,m-1))",
        ),
        induction(
            "m",
            "m",
            "t",
            positivity(
                &[
                    next("p", "k + 1", "0", "0"),
                    next("q", "k", "0", "0"),
                    zero("y", "k + 1"),
                    zero("z", "k"),
                    at("s", "first"),
                ],
                "[p] - [q] + [y] - [z] + [s]",
            ),
            positivity(
                &[
                    next("p", "k + 1", "m", "[m] + 1"),
                    next("q", "k", "m", "[m] + 1"),
                    instance("h", "step.inner", "k=k, i=m", "k=[k], i=[m], n=[u]"),
                    instance("ih", "IH", "t=m, k=k", "k=[k], m=[m], u=[u] + 1, t=0"),
                ],
                "[p] - [q] + [h] + [ih]",
            ),
        ),
    );
    sheet.conclude(
        clause("AVERAGE", "k", &["k: k >= 0"], "c(k+1,last+1) = c(k,last+1)"),
        positivity(
            &[
                next("p", "k + 1", "last", "[last]"),
                next("q", "k", "last", "[last]"),
                instance("tel", "TEL", "k=k, m=last", "k=[k], m=[n] + 1, u=0"),
                at("s", "last"),
            ],
            "[p] - [q] + [tel] + [s]",
        ),
    );
    scope.weights.is_none().then_some(sheet)
}
