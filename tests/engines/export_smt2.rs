//! The SMT-LIB export: the formulas say what the spec says (checked by evaluating them), and a
//! solver finds what is expected of it.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::process::{Command, Stdio};

use super::smt2_answers::answered;
use super::smt2_text::{parse, satisfied};
use crate::common::tools::{cordon, has_tool, stderr_of, stdout_of};
use cordon_core::Rational;
use cordon_proof::export::conjecture::Conjecture;
use cordon_proof::export::smt_model::{Response, read_answer};
use cordon_proof::export::smt2::{Obligation, Query, WeightDomain, has_beyond, obligations};
use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, StartSet, Truth, Verdict, telescoping_residual};
use cordon_spec::{Params, State};
use num_traits::Zero;

fn holds_directly(query: &Query, p: &Params<Rational>, start: &[Rational]) -> bool {
    let Query { claim, form, drones, .. } = *query;
    let setting = Setting::from(p);
    let mut run = vec![start.to_vec()];
    for _ in 0..10 {
        let s = State { drones: run.last().unwrap().clone(), timesteps: 0 };
        run.push(exec_coverage(p, &s).drones);
    }
    let span = claim.span(form, drones);
    let violated = |k: usize| match claim.conclusion(form, &setting, &run[k..=k + span]) {
        Verdict::Violated(_) => true,
        Verdict::Holds | Verdict::Vacuous => false,
        Verdict::Undecided => panic!("rationals decide everything"),
    };
    let invariant = |k: usize| claim.invariant(&setting, &run[k]) == Truth::True;
    let allowed = claim.allows(form, &setting, start) == Truth::True;
    let weights = query.asks_about(&setting);
    match query.obligation {
        Obligation::Initial => weights && allowed && !invariant(0),
        Obligation::Preserved => weights && invariant(0) && !invariant(1),
        Obligation::Concluded => weights && invariant(0) && violated(0),
        Obligation::Identity => {
            StartSet::Any.contains(&setting, start) == Truth::True
                && !telescoping_residual(&p.eps, &run[0], &run[1]).is_zero()
        }
        Obligation::Violated { steps } => weights && allowed && (0..=steps).any(violated),
    }
}

/// A small generator with a named seed: the test replays.
struct Lcg(u64);

impl Lcg {
    fn below(&mut self, n: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}

const SEED: u64 = 20_211;

fn rational(num: i64, den: i64) -> Rational {
    Rational::new(num.into(), den.into())
}

/// A random instance on a coarse grid (so that equalities happen), mostly with the end drones
/// in place.
fn instance(random: &mut Lcg, drones: usize) -> (Params<Rational>, Vec<Rational>) {
    let eps =
        [(0, 1), (1, 4), (1, 3), (1, 2), (2, 3), (1, 1), (3, 2), (-1, 4)][random.below(8) as usize];
    let max = drones as i64 - 1;
    let mut start: Vec<_> = (0..drones as i64)
        .map(|i| {
            // Close to the targets, where hypotheses are met and conclusions tight.
            let shift = [0, 0, 0, -1, -1, -2, 1, -6][random.below(8) as usize];
            rational(2 * i + shift, 2)
        })
        .collect();
    if random.below(8) > 0 {
        start[0] = Rational::zero();
        start[drones - 1] = rational(max, 1);
    }
    let p =
        Params { min: Rational::zero(), max: rational(max, 1), eps: rational(eps.0, eps.1), n: 0 };
    (p, start)
}

#[test]
fn formulas_agree_with_the_spec_at_random_points() {
    let mut random = Lcg(SEED);
    let (mut compared, mut queries) = (0, 0);
    let mut met = BTreeMap::new();
    for claim in Conjecture::ALL {
        for form in Form::ALL {
            for drones in 3..=5 {
                // Without restriction of the weights something is to be found.
                let wide = cordon_core::range::Interval {
                    low: rational(-1, 1),
                    low_closed: true,
                    high: rational(2, 1),
                    high_closed: false,
                };
                let mut list = obligations(claim, form, drones, &WeightDomain::OfHypothesis);
                list.extend(obligations(
                    claim,
                    form,
                    drones,
                    &WeightDomain::Interval(wide.clone()),
                ));
                let violated = Obligation::Violated { steps: 1 };
                for weights in [WeightDomain::Beyond, WeightDomain::Interval(wide)] {
                    list.push(Query { claim, form, drones, obligation: violated, weights });
                }
                for query in list {
                    queries += 1;
                    let script = parse(&query.text());
                    for _ in 0..60 {
                        let (p, start) = instance(&mut random, drones);
                        let mut values = vec![p.min.clone(), p.max.clone(), p.eps.clone()];
                        values.extend(start.iter().cloned());
                        let expected = holds_directly(&query, &p, &start);
                        assert_eq!(
                            satisfied(&script, &values),
                            expected,
                            "{}: {p:?} {start:?}",
                            query.name()
                        );
                        compared += 1;
                        *met.entry(query.obligation.label()).or_insert(0) += usize::from(expected);
                    }
                }
            }
        }
    }
    assert_eq!(queries, 444, "queries compared");
    assert_eq!(compared, queries * 60);
    // The agreement is not one on `no` alone.
    assert!(met["preserved"] > 50 && met["concluded"] > 50 && met["violated"] > 200, "{met:?}");
}

#[test]
fn steps_in_the_text_are_those_of_the_spec() {
    let text = stdout_of(&["export", "smt2", "7.2", "--drones", "4"]);
    // Equation 10 for an internal drone, in the order in which exec_cvg computes it.
    assert!(text.contains(
        "(define-fun x1_1 () Real (+ (+ (* eps x0_0) (* (- 1.0 (* 2.0 eps)) x1_0)) (* eps x2_0)))"
    ));
    assert!(text.contains("(define-fun x0_1 () Real min)"));
    assert!(text.contains("(define-fun x3_1 () Real max)"));
}

#[test]
fn the_default_covers_every_claim_for_three_to_six_drones() {
    let text = stdout_of(&["export", "smt2"]);
    // 11 claims, two obligations each, and the identity of 7.5, for four numbers of drones.
    assert_eq!(text.matches("(check-sat)").count(), (11 * 2 + 1) * 4);
    assert_eq!(text.matches("(reset)").count(), (11 * 2 + 1) * 4 - 1);
    let paper = stdout_of(&["export", "smt2", "--form", "paper"]);
    // Where the paper assumes more than the invariant, that it implies it is a query of its own.
    assert_eq!(paper.matches("; initial of").count(), 7 * 4);
    assert_eq!(paper.matches("(check-sat)").count(), (11 * 2 + 7) * 4);
}

#[test]
fn writes_files_whole() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("q.smt2");
    let shown = stdout_of(&["export", "smt2", "7.3", "--out", path.to_str().unwrap()]);
    assert_eq!(shown, "");
    let text = std::fs::read_to_string(&path).unwrap();
    assert_eq!(text, stdout_of(&["export", "smt2", "7.3"]));
    #[cfg(unix)]
    {
        // As open as any other file that the user writes.
        use std::os::unix::fs::PermissionsExt;
        let plain = dir.path().join("plain");
        std::fs::write(&plain, "").unwrap();
        let mode = |p| std::fs::metadata(p).unwrap().permissions().mode();
        assert_eq!(mode(&path), mode(&plain));
    }
    let nowhere = dir.path().join("no/such/q.smt2");
    let error = stderr_of(&["export", "smt2", "7.3", "--out", nowhere.to_str().unwrap()], 74);
    assert!(error.starts_with("error: cannot write `"), "{error}");
}

#[test]
fn bad_input_is_named() {
    for (args, said) in [
        (
            &["9.9"][..],
            "error: theorem: `9.9` is unknown here: expected `all` or some of 7.2, 7.3,",
        ),
        (&["7.8"], "error: theorem: `7.8` is unknown here (a limit has no inductive step)"),
        (
            &["--drones", "2"],
            "error: --drones: `2`: expected a number from 3 to 9, or a range like 3..7",
        ),
        (&["--drones", "3..10"], "error: --drones: `3..10`: expected"),
        (&["--drones", "5..4"], "error: --drones: `5..4`: expected"),
        (&["--drones", "many"], "error: --drones: `many`: expected"),
        (&["--eps-range", "0,1"], "error: --eps-range: `0,1` is not a number"),
        (
            &["--eps-range", "[1,0]"],
            "error: --eps-range: `[1,0]`: expected a range that is not empty",
        ),
        (
            &["--eps-range", "(1,1]"],
            "error: --eps-range: `(1,1]`: expected a range that is not empty",
        ),
        (&["--eps-range", "[a,1]"], "error: --eps-range: `a` is not a number"),
        (
            &["7.2", "--negate", "--drones", "3"],
            "error: --negate: 7.2 with 3 drones holds for all 0 <= eps <= 1",
        ),
        (&["--steps", "2"], "error: --steps: expected --negate with it"),
        (&["7.2", "--negate", "--steps", "9"], "error: invalid value '9'"),
    ] {
        let mut full = vec!["export", "smt2"];
        full.extend(args);
        let error = stderr_of(&full, 2);
        assert!(error.starts_with(said), "{args:?}: {error}");
    }
}

// ---- a solver

/// Longest time a solver may take for one query, in seconds.
const SOLVER_SECONDS: u32 = 30;

fn solved(query: &Query) -> Response {
    read_answer(query, &solver_output(&query.text()))
        .unwrap_or_else(|e| panic!("{}: {e}", query.name()))
}

/// What z3 prints.
fn solver_output(text: &str) -> String {
    let mut child = Command::new("z3")
        .args(["-in", &format!("-T:{SOLVER_SECONDS}")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap()
}

#[test]
fn a_solver_proves_every_obligation_of_the_sharp_forms() {
    if !has_tool("z3", "SMT tier") {
        return;
    }
    let mut proved = 0;
    for claim in Conjecture::ALL {
        for drones in 3..=6 {
            for query in obligations(claim, Form::Sharp, drones, &WeightDomain::OfHypothesis) {
                assert_eq!(solved(&query), Response::Unsat, "{}", query.name());
                proved += 1;
            }
        }
    }
    assert_eq!(proved, 92);
}

#[test]
fn a_solver_finds_the_errata_of_the_paper_forms_and_no_others() {
    if !has_tool("z3", "SMT tier") {
        return;
    }
    let (mut refuted, mut proved) = (Vec::new(), 0);
    for claim in Conjecture::ALL {
        for drones in 3..=6 {
            for query in obligations(claim, Form::Paper, drones, &WeightDomain::OfHypothesis) {
                match solved(&query) {
                    Response::Unsat => proved += 1,
                    Response::Sat(_) => refuted.push(query.name()),
                    Response::Unknown(why) => panic!("{}: {why}", query.name()),
                }
            }
        }
    }
    assert_eq!(proved, 106);
    assert_eq!(
        refuted,
        [
            // False at eps = 0 (erratum 10).
            "7.6ii-paper-n3-concluded",
            "7.6ii-paper-n4-concluded",
            "7.6ii-paper-n5-concluded",
            "7.6ii-paper-n6-concluded",
            // 0 <= eps <= 1: beyond 1/2 the upper bound is not kept, and at eps = 0 nothing
            // moves. Three and four drones have no j >= 3 inside: vacuous there.
            "7.7-paper-n3-preserved",
            "7.7-paper-n4-preserved",
            "7.7-paper-n5-preserved",
            "7.7-paper-n5-concluded",
            "7.7-paper-n6-preserved",
            "7.7-paper-n6-concluded",
        ]
    );
}

#[test]
fn beyond_the_range_a_solver_finds_models_that_replay() {
    if !has_tool("z3", "SMT tier") {
        return;
    }
    let (mut found, mut none) = (Vec::new(), Vec::new());
    let (mut outside, mut replayed) = (0, 0);
    for claim in Conjecture::ALL {
        for drones in 3..=6 {
            if !has_beyond(claim, drones) {
                outside += 1;
                continue;
            }
            let obligation = Obligation::Violated { steps: 3 };
            let query = Query {
                claim,
                form: Form::Sharp,
                drones,
                obligation,
                weights: WeightDomain::Beyond,
            };
            let name = format!("{claim} {drones}");
            // As a user would: the solver's output goes back into the program, and the line it
            // prints is run.
            let output = solver_output(&query.text());
            let n = drones.to_string();
            let args =
                ["export", "smt2", claim.number(), "--drones", &n, "--negate", "--steps", "3"];
            let (code, said, _) = answered(&args, &output);
            match code {
                Some(1) => {
                    let line =
                        said.lines().find_map(|l| l.strip_prefix("replay: cordon ")).unwrap();
                    let traced = cordon(&line.split(' ').collect::<Vec<_>>());
                    let checked = matches!(claim, Conjecture::Theorem(_));
                    assert_eq!(traced.status.code(), Some(i32::from(checked)), "{name}: {line}");
                    replayed += usize::from(checked);
                    found.push(name);
                }
                Some(0) => none.push(name),
                other => panic!("{name}: {other:?} {said}"),
            }
        }
    }
    // 7.5ii and 7.6i hold for every weight, 7.2 for three drones up to 1.
    assert_eq!(outside, 4 + 4 + 1);
    assert_eq!(found.len(), 31);
    // `cordon trace` checks theorems; mirror and box (7 of the 31) it only shows.
    assert_eq!(replayed, 24);
    // Where the range is sufficient and not exact within three steps: the sum of four drones
    // obeys e_1 + e_2 -> (1 - eps)(e_1 + e_2), nonnegative up to eps = 1; so does the box of
    // three, and e -> (1 - 2 eps) e of three drones keeps being zero.
    assert_eq!(none, ["7.4i 4", "7.4ii 3", "7.5i 4", "box 3"]);
}

#[test]
fn the_whole_script_runs_in_one_solver() {
    if !has_tool("z3", "SMT tier") {
        return;
    }
    let text = stdout_of(&["export", "smt2", "7.3,box", "--drones", "3..4"]);
    assert_eq!(solver_output(&text), "unsat\n".repeat(8));
    // And by the program itself, as a user would.
    let negated = cordon(&["export", "smt2", "7.3", "--negate", "--drones", "4"]);
    assert!(
        String::from_utf8(negated.stdout)
            .unwrap()
            .ends_with("(check-sat)\n(get-value (min max eps x0_0 x1_0 x2_0 x3_0))\n")
    );
}
