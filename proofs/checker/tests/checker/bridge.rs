//! The clauses that the checker reads off the spec say what the spec does: of every drone of every
//! swarm tried, of every start and of every weight tried.

use std::collections::{BTreeMap, BTreeSet};

use cordon_check::expr::{Relation, Sort};
use cordon_check::format::{Kind, System, read};
use cordon_check::kernel::Kernel;
use cordon_check::number::{Number, refill};
use cordon_check::poly::{Atom, Poly};
use cordon_check::system::{Step, install};
use cordon_check::{Verdict, assume, check_of};
use cordon_spec::activation::exec_coverage_active;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::graph::Path;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth};
use cordon_spec::{Params, Scalar, State};
use serde_json::{Value, json};

/// Largest swarm tried.
const MOST: usize = 16;

fn kernel(system: &Value) -> Kernel {
    refill();
    let system: System = serde_json::from_value(system.clone()).unwrap();
    let mut kernel = Kernel::default();
    kernel.function("w", 2, Sort::Real).unwrap();
    install(&system, &mut kernel, exec_coverage).unwrap();
    kernel
}

/// The polynomial of a clause's goal with numbers in the place of variables.
fn goal(kernel: &Kernel, name: &str, values: &[(&str, usize)]) -> Poly {
    let value = |a: &Atom| {
        let known = values.iter().find(|(v, _)| *a == Atom::Var((*v).into()));
        known.map(|(_, n)| Poly::from_index(*n))
    };
    kernel.lemmas.get(name).unwrap_or_else(|| panic!("{name}")).goal.poly.substitute(&value)
}

fn class(count: usize, i: usize) -> &'static str {
    match i {
        0 => "first",
        _ if i + 1 == count => "last",
        _ => "inner",
    }
}

fn x(k: &Poly, i: usize) -> Poly {
    Poly::app("x", &[k.clone(), Poly::from_index(i)])
}

#[test]
fn classes_stand_for_every_drone_of_every_swarm() {
    let k = Poly::var("k");
    let mut compared = 0;
    let systems = [
        ("coverage", "full"),
        ("coverage", "activation"),
        ("coverage", "delay"),
        ("consensus", "full"),
    ];
    // Of one weight, and of one for each drone and step.
    for ((protocol, steps), own) in systems.into_iter().flat_map(|s| [(s, false), (s, true)]) {
        let mut system = json!({ "protocol": protocol, "steps": steps });
        if own {
            system["weight"] = json!("w(k,i)");
        }
        let kernel = kernel(&system);
        for count in 3..=MOST {
            refill();
            let state =
                State { drones: (0..count).map(|i| x(&k, i)).collect::<Vec<_>>(), timesteps: 0 };
            for i in 0..count {
                let weight = Poly::app("w", &[k.clone(), Poly::from_index(i)]);
                let eps = if own { weight } else { Poly::var("eps") };
                let params = Params { min: Poly::var("min"), max: Poly::var("max"), eps, n: 0 };
                let name = format!("step.{}", class(count, i));
                let clause = goal(&kernel, &name, &[("i", i), ("last", count - 1)]);
                let after = x(&(k.clone() + &Poly::whole(1)), i);
                // Each way to take the step, with what the clause's functions are in it.
                let ways: Vec<(Poly, Vec<(Atom, Poly)>)> = match (protocol, steps) {
                    ("consensus", _) => {
                        let path = Path { count };
                        vec![(exec_consensus(&params.eps, &path, &state.drones)[i].clone(), vec![])]
                    }
                    (_, "activation") => [true, false]
                        .map(|on| {
                            let next = exec_coverage_active(&params, &state, |j| on == (j == i));
                            let terms = vec![k.clone(), Poly::from_index(i)];
                            let share = Poly::from_int(i32::from(on));
                            (
                                next.drones[i].clone(),
                                vec![(Atom::App("active".into(), terms.into()), share)],
                            )
                        })
                        .to_vec(),
                    (_, "delay") => {
                        let seen = |j: usize| {
                            Poly::app(
                                "seen",
                                &[k.clone(), Poly::from_index(i), Poly::from_index(j)],
                            )
                        };
                        let late: Vec<Poly> = (0..count).map(|j| x(&seen(j), j)).collect();
                        let next = exec_coverage_delayed(&params, &state, |_, j| &late[j]);
                        vec![(next.drones[i].clone(), vec![])]
                    }
                    _ => vec![(exec_coverage(&params, &state).drones[i].clone(), vec![])],
                };
                for (next, values) in ways {
                    let value =
                        |a: &Atom| values.iter().find(|(b, _)| a == b).map(|(_, p)| p.clone());
                    let clause = clause.substitute(&value);
                    assert_eq!(clause, after.clone() - &next, "{protocol} {steps} {i} of {count}");
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, 10 * (3..=MOST).sum::<usize>());
}

/// Whether a clause about the start and eps holds: for all i for which its literals given do.
fn holds(kernel: &Kernel, name: &str, setting: &Setting<Number>, start: &[Number]) -> bool {
    let clause = kernel.lemmas.get(name).unwrap();
    let last = start.len() - 1;
    let number = |p: &Poly, i: usize| -> Number {
        let value = |a: &Atom| {
            let constant = |n: &Number| Some(Poly::constant(n.clone()));
            match a {
                Atom::Var(v) => match &**v {
                    "min" => constant(&setting.min),
                    "max" => constant(&setting.max),
                    "eps" => constant(&setting.eps_num),
                    "last" => Some(Poly::from_index(last)),
                    _ => Some(Poly::from_index(i)),
                },
                Atom::App(_, terms) => {
                    let at = |j: usize| Poly::from_index(j);
                    let place = terms[1].substitute(&|a| match a {
                        Atom::Var(v) if **v == *"last" => Some(at(last)),
                        _ => Some(at(i)),
                    });
                    (0..=last).find(|&j| at(j) == place).and_then(|j| constant(&start[j]))
                }
                Atom::Fact(_) => None,
            }
        };
        p.substitute(&value).terms().next().map_or(Number::whole(0), |(_, c)| c.clone())
    };
    (0..=last).all(|i| {
        let given = clause.given.values().all(|l| number(&l.poly, i) >= Number::whole(0));
        if !given {
            return true;
        }
        let value = number(&clause.goal.poly, i);
        match clause.goal.relation {
            Relation::Positive => value.is_positive(),
            Relation::NonNegative => value >= Number::whole(0),
            Relation::Zero => value.is_zero(),
        }
    })
}

#[test]
fn hypotheses_are_those_of_the_spec() {
    let mut answers: BTreeMap<bool, usize> = BTreeMap::new();
    let mut seed = 1_usize;
    let mut below = move |n: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % n
    };
    let mut theorems = 0;
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            let name = format!("{}-{}", theorem.number(), form.label());
            let path = format!("{}/../certificates/{name}.json", env!("CARGO_MANIFEST_DIR"));
            // As printed three are refuted.
            let Ok(Kind::Theorem(t)) = read(&std::fs::read_to_string(path).unwrap()) else {
                continue;
            };
            refill();
            let mut kernel = Kernel::default();
            assume(&t.statement, &mut kernel, exec_coverage).unwrap();
            theorems += 1;
            let there = |names: &[&'static str]| -> Vec<&'static str> {
                names.iter().copied().filter(|n| kernel.lemmas.contains_key(*n)).collect()
            };
            let weights = there(&["weight.low", "weight.high", "weight.four"]);
            let starts = there(&[
                "start.first",
                "start.last",
                "start.order",
                "start.segment",
                "start.bound",
            ]);
            for _ in 0..200 {
                refill();
                let count = 3 + below(3);
                let part = |n: usize, d: usize| Number::read(&quotient(n, d)).unwrap();
                let setting = Setting {
                    min: Number::whole(0),
                    max: Number::whole(i64::try_from(count - 1).unwrap()),
                    eps_num: part(below(8), 6) - &part(1, 6),
                    eps_den: Number::whole(1),
                };
                let mut start: Vec<Number> =
                    (0..count).map(|_| part(below(4 * count), 4)).collect();
                if below(2) == 0 {
                    start.sort();
                }
                if below(4) > 0 {
                    (start[0], start[count - 1]) = (setting.min.clone(), setting.max.clone());
                }
                let hypothesis = theorem.hypothesis(form);
                let both =
                    |names: &[&str]| names.iter().all(|n| holds(&kernel, n, &setting, &start));
                let found = both(&starts);
                assert_eq!(
                    found,
                    hypothesis.starts.contains(&setting, &start) == Truth::True,
                    "{theorem:?} {start:?}"
                );
                *answers.entry(found).or_default() += 1;
                // Below the critical weight there are minors, which are no numbers here.
                if !kernel.lemmas.contains_key("minor.step") {
                    let eps = &setting.eps_num;
                    let met =
                        hypothesis.weights.contains(eps, &setting.eps_den, count) == Truth::True;
                    assert_eq!(both(&weights), met, "{theorem:?} {eps}");
                    *answers.entry(met).or_default() += 1;
                }
            }
        }
    }
    assert_eq!(theorems, 17);
    assert!(answers[&true] > 1_000 && answers[&false] > 1_000, "{answers:?}");
}

/// A fact more would be believed by every proof: the clauses of a system are those of FORMAT.md's table, and no others.
#[test]
fn systems_have_the_clauses_of_the_format_and_no_others() {
    let step = |f: &str| ["first", "inner", "last"].map(|class| format!("{f}.{class}"));
    let local = ["step", "own", "prec", "foll", "own.start", "prec.start", "foll.start"];
    for (protocol, steps, functions) in [
        ("coverage", "full", &local[..1]),
        ("coverage", "activation", &local[..1]),
        ("coverage", "delay", &local[..1]),
        ("projection", "full", &local[..]),
        ("consensus", "full", &local[..1]),
    ] {
        let kernel = kernel(&json!({ "protocol": protocol, "steps": steps }));
        let steps: BTreeSet<String> = functions.iter().flat_map(|f| step(f)).collect();
        let expected: BTreeSet<&str> =
            steps.iter().map(String::as_str).chain(["n", "last"]).collect();
        let found: BTreeSet<&str> = kernel.lemmas.keys().map(|n| &**n).collect();
        assert_eq!(found, expected, "{protocol}");
    }
}

/// Without a system nothing is known but what the statement says.
#[test]
fn without_a_system_nothing_is_known() {
    let mut kernel = Kernel::default();
    let statement = json!({ "constants": { "last": "real" }, "conclusions": [] });
    let statement = serde_json::from_value(statement).unwrap();
    let words = assume(&statement, &mut kernel, exec_coverage).unwrap();
    assert_eq!(words, ["for all reals last"]);
    assert!(kernel.lemmas.is_empty());
}

fn quotient(n: usize, d: usize) -> String {
    let divisor =
        (1..=n.max(1)).rev().find(|g| n.is_multiple_of(*g) && d.is_multiple_of(*g)).unwrap();
    match (n / divisor, d / divisor) {
        (0, _) => "0".into(),
        (n, 1) => n.to_string(),
        (n, d) => format!("{n}/{d}"),
    }
}

type Row = State<Vec<Poly>>;

/// The protocol with another mean on the inner drones: own weight, and the drone in the predecessor's place.
fn inner(p: &Params<Poly>, s: &Row, own: &Poly, sign: i64, before: usize) -> Row {
    let mut after = exec_coverage(p, s);
    let x = &s.drones;
    for i in 1..x.len() - 1 {
        after.drones[i] = p.eps.clone() * &x[i.saturating_sub(before)]
            + &(own.clone() * &x[i])
            + &(Poly::whole(sign) * &p.eps * &x[i + 1]);
    }
    after
}

fn below(n: i64, p: &Params<Poly>) -> Poly {
    Poly::whole(1) - &(Poly::whole(n) * &p.eps)
}

const WRONG: [(&str, Step); 6] = [
    ("neighbour off by one", |p, s| inner(p, s, &below(2, p), 1, 2)),
    ("weight 1-eps", |p, s| inner(p, s, &below(1, p), 1, 1)),
    ("weight turned", |p, s| inner(p, s, &below(2, p), -1, 1)),
    ("first drone moving", |p, s| {
        let mut after = exec_coverage(p, s);
        after.drones[0] = p.min.clone() + &p.eps;
        after
    }),
    ("last drone following", |p, s| {
        let mut after = exec_coverage(p, s);
        let last = s.drones.len() - 1;
        after.drones[last] = s.drones[last - 1].clone();
        after
    }),
    ("nobody moves", |_, s| s.clone()),
];

/// What is proved of the protocol is not proved of one with a fault, and the rule that says so is the one that
/// compares with the step.
#[test]
fn a_wrong_protocol_breaks_the_certificates() {
    let right: Step = |p, s| inner(p, s, &below(2, p), 1, 1);
    let theorems = ["7.2", "7.3", "7.4i", "7.5i", "7.5ii", "7.6i", "7.6ii", "7.7", "7.8"];
    let files = theorems.map(|n| (format!("{n}-sharp"), "positivity")).into_iter().chain([
        ("7.8-beyond".to_owned(), "positivity"),
        ("7.8-contraction-n4-eps-3_5".to_owned(), "contraction"),
        ("7.8-contraction-n5-eps-4_7".to_owned(), "contraction"),
    ]);
    let mut broken = 0;
    for (file, expected) in files {
        let path = format!("{}/../certificates/{file}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).unwrap();
        assert_eq!(check_of(&text, right).code(), 0, "{file}");
        for (what, step) in WRONG {
            let verdict = check_of(&text, step);
            let refused = matches!(&verdict, Verdict::Invalid { rule, .. } if *rule == expected);
            assert!(refused, "{file}, {what}: {verdict}");
            broken += 1;
        }
    }
    assert_eq!(broken, 72);
}
