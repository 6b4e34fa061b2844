//! A theorem's statement says what the spec's own conclusion says: of every run tried, with every value of the
//! statement's constants, the conclusions hold where the assumptions do just if the spec does not answer a violation.

use std::collections::BTreeMap;
use std::fs;

use cordon_check::assume;
use cordon_check::expr::{Literal, Relation};
use cordon_check::format::{Kind, Theorem as Written, read};
use cordon_check::kernel::{Clause, Kernel};
use cordon_check::number::{Number, refill};
use cordon_check::poly::{Atom, Poly};
use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};
use cordon_spec::{Params, State};

/// A run with the values of its parameters, as numbers for the clauses.
struct Run {
    setting: Setting<Number>,
    placements: Vec<Vec<Number>>,
}

type Integers = BTreeMap<String, i64>;

impl Run {
    fn last(&self) -> i64 {
        i64::try_from(self.placements[0].len() - 1).unwrap()
    }

    /// The value of a polynomial; none where it reads placements beyond the run, or drones that there are none.
    fn value(&self, p: &Poly, integers: &Integers) -> Option<Number> {
        p.terms().try_fold(Number::whole(0), |sum, (monomial, c)| {
            let product =
                monomial.iter().try_fold(c.clone(), |p, a| Some(p * &self.atom(a, integers)?));
            Some(sum + &product?)
        })
    }

    fn atom(&self, a: &Atom, integers: &Integers) -> Option<Number> {
        match a {
            Atom::Var(v) => match &**v {
                "eps" => Some(self.setting.eps_num.clone()),
                "min" => Some(self.setting.min.clone()),
                "max" => Some(self.setting.max.clone()),
                "last" => Some(Number::whole(self.last())),
                name => integers.get(name).map(|n| Number::whole(*n)),
            },
            Atom::App(f, terms) => {
                let index = |t: &Poly| -> Option<usize> {
                    let value = self.value(t, integers)?;
                    (0..100).find(|n| Number::whole(*n) == value)?.try_into().ok()
                };
                let (k, m) = (index(&terms[0])?, index(&terms[1])?);
                let row = self.placements.get(k)?;
                match &**f {
                    "x" => row.get(m).cloned(),
                    // The sum of the first m positions.
                    "c" => Some(row.get(..m)?.iter().fold(Number::whole(0), |sum, x| sum + x)),
                    _ => panic!("{f}"),
                }
            }
            Atom::Fact(_) => panic!("a fact in a statement"),
        }
    }

    fn literal(&self, l: &Literal, integers: &Integers) -> Option<bool> {
        let value = self.value(&l.poly, integers)?;
        Some(match l.relation {
            Relation::Positive => value.is_positive(),
            Relation::NonNegative => value >= Number::whole(0),
            Relation::Zero => value.is_zero(),
        })
    }

    /// Whether a clause holds for all values of its variables, as far as the run reaches.
    fn holds(&self, clause: &Clause, constants: &Integers) -> bool {
        let names: Vec<&str> = clause.vars.iter().map(|(v, _)| &**v).collect();
        assignments(&names, self.last().max(3) + 1, constants).iter().all(|integers| {
            let given = clause.given.values().map(|l| self.literal(l, integers));
            // What cannot be evaluated is of no drone or no step of this run.
            given.collect::<Option<Vec<bool>>>().is_none_or(|all| all.contains(&false))
                || self.literal(&clause.goal, integers) != Some(false)
        })
    }
}

fn assignments(names: &[&str], upto: i64, start: &Integers) -> Vec<Integers> {
    names.iter().fold(vec![start.clone()], |all, name| {
        let with = |old: &Integers, n: i64| {
            let mut new = old.clone();
            new.insert((*name).to_owned(), n);
            new
        };
        all.iter().flat_map(|old| (0..=upto).map(move |n| with(old, n))).collect()
    })
}

fn statement(name: &str) -> Written {
    let path = format!("{}/../certificates/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let Ok(Kind::Theorem(t)) = read(&fs::read_to_string(path).unwrap()) else { panic!("{name}") };
    *t
}

/// Whether the statement says of the run that it is impossible.
fn denied(name: &str, run: &Run) -> bool {
    refill();
    let t = statement(name).statement;
    let mut kernel = Kernel::default();
    assume(&t, &mut kernel, exec_coverage).unwrap();
    let clauses = |all: &[cordon_check::format::Clause]| -> Vec<Clause> {
        all.iter().map(|c| kernel.clause(c).unwrap()).collect()
    };
    // Of the hypothesis the spec's conclusion says nothing.
    let mut own = t.assumptions.clone();
    own.retain(|a| !["segment", "weight.", "start."].iter().any(|of| a.name.starts_with(of)));
    let (assumptions, conclusions) = (clauses(&own), clauses(&t.conclusions));
    let names: Vec<&str> = t.constants.0.keys().map(String::as_str).collect();
    let mut constants = assignments(&names, run.last(), &Integers::new());
    // The placements of the run are those from step K on.
    constants.retain(|c| c.get("K").is_none_or(|k| *k == 0));
    constants.iter().any(|constants| {
        assumptions.iter().all(|a| run.holds(a, constants))
            && !conclusions.iter().all(|c| run.holds(c, constants))
    })
}

struct Source(u64);

impl Source {
    fn below(&mut self, n: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    /// A start of small numbers, often at its targets in part; `eps` in thirds and quarters.
    fn run(&mut self, count: usize, steps: usize) -> Run {
        let last = i64::try_from(count - 1).unwrap();
        let eps = ["0", "1/4", "1/3", "1/2", "3/5", "1"][usize::try_from(self.below(6)).unwrap()];
        let setting = Setting {
            min: Number::whole(0),
            max: Number::whole(last),
            eps_num: Number::read(eps).unwrap(),
            eps_den: Number::whole(1),
        };
        let params = Params {
            min: Number::whole(0),
            max: Number::whole(last),
            eps: setting.eps_num.clone(),
            n: 0,
        };
        let exactly = self.below(3);
        let mut drones: Vec<Number> = (0..=last)
            .map(|i| match self.below(3 + 2 * exactly) {
                0 => Number::whole(i64::try_from(self.below(5)).unwrap() - 1),
                1 => Number::whole(i) - &Number::read("1/2").unwrap(),
                2 if exactly == 0 => Number::whole(i) + &Number::whole(1),
                _ => Number::whole(i),
            })
            .collect();
        (drones[0], drones[count - 1]) = (Number::whole(0), Number::whole(last));
        let mut placements = vec![drones];
        for t in 0..steps {
            let state = State { drones: placements[t].clone(), timesteps: 0 };
            placements.push(exec_coverage(&params, &state).drones);
        }
        Run { setting, placements }
    }
}

#[test]
fn statements_say_what_the_conclusions_of_the_spec_say() {
    let mut source = Source(11);
    // That of 7.8 speaks of a rate for all steps, the spec's conclusion of one step.
    let files: [(Theorem, &[&str]); 9] = [
        (Theorem::Ordering, &["7.2-sharp"]),
        (Theorem::UpperBound, &["7.3-sharp"]),
        (Theorem::SumBounded, &["7.4i-sharp"]),
        (Theorem::SumMaximal, &["7.4ii-sharp"]),
        (Theorem::SumNonDecreasing, &["7.5i-sharp"]),
        (Theorem::SumStationary, &["7.5ii-sharp"]),
        (Theorem::TargetsFixed, &["7.6i-sharp"]),
        (Theorem::ConstantSum, &["7.6ii-sharp"]),
        (Theorem::GloballyIncreasing, &["7.7-sharp"]),
    ];
    for (theorem, names) in files {
        let mut answers = [0; 2];
        for _ in 0..150 {
            let count = usize::try_from(3 + source.below(3)).unwrap();
            refill();
            let mut run = source.run(count, theorem.span(Form::Sharp, count));
            // No run violates these two: a last placement that is no step's result does.
            let kept = matches!(theorem, Theorem::SumStationary | Theorem::TargetsFixed);
            if kept && source.below(2) == 0 {
                run.placements.pop();
                run.placements.push(source.run(count, 0).placements.remove(0));
            }
            let hypothesis = theorem.hypothesis(Form::Sharp);
            let start = hypothesis.starts.contains(&run.setting, &run.placements[0]) == Truth::True;
            // Of runs from other starts these two say nothing alike: the sums may cancel.
            if !start && matches!(theorem, Theorem::ConstantSum | Theorem::GloballyIncreasing) {
                continue;
            }
            let said = theorem.conclusion(Form::Sharp, &run.setting, &run.placements);
            let violated = matches!(said, Verdict::Violated(_));
            let denied = names.iter().any(|n| denied(n, &run));
            assert_eq!(denied, violated, "{theorem:?} {said:?} {:?}", run.placements);
            answers[usize::from(violated)] += 1;
        }
        assert!(answers[0] > 20 && answers[1] > 5, "{theorem:?} {answers:?}");
    }
}
