//! From the spec to clauses: what runs, and under which hypothesis.
//!
//! `exec_coverage` computes drone i from drones i-1, i, i+1, and branches on `i = 0` and `i + 1 =
//! count` only. For N >= 3 every drone is of one class: the first (i = 0), an inner (1 <= i <= N-2)
//! or the last (i = N-1). Two members of a class differ in i and N through `i` and `last` only, so
//! that the spec's own step, run on a row of symbols around one member, is the step of all.
//! The checker's tests confirm that by execution for every i and N up to 16.

use std::num::NonZeroU32;

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::tick;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::graph::Path;
use cordon_spec::local::{LocalParams, TickRatio, exchange, fmu_tick, project};
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};
use cordon_spec::{Params, Scalar, State};

use crate::expr::Relation::Zero;
use crate::expr::{Literal, Sort, Vars};
use crate::fault::{Result, ensure, fault};
use crate::format::System;
use crate::kernel::{Clause, Facts, Kernel};
use crate::poly::{Atom, Poly};

/// Drones in a row of symbols: two on either side of the one looked at.
const ROW: usize = 5;

/// The classes of drones: their name, and where in the row a member stands.
const CLASSES: [(&str, usize); 3] = [("first", 0), ("inner", 2), ("last", ROW - 1)];

/// The theorem of that number, in the form of that name.
///
/// # Errors
/// There is none.
pub fn named(theorem: &str, form: &str) -> Result<(Theorem, Form)> {
    let theorem = Theorem::ALL.into_iter().find(|t| t.number() == theorem);
    match (theorem, Form::ALL.into_iter().find(|f| f.label() == form)) {
        (Some(theorem), Some(form)) => Ok((theorem, form)),
        _ => fault("system", "no such theorem or form"),
    }
}

fn int(n: i32) -> Poly {
    Poly::from_int(n)
}

fn var(name: &str) -> Poly {
    Poly::var(name)
}

/// Literals given of what is said of the inner drones, and of their steps.
const INSIDE: &str = "i: i - 1 >= 0; n: last - 1 - i >= 0";
const INNER: &str = "k: k >= 0; i: i - 1 >= 0; n: last - 1 - i >= 0";

const BELOW_CRITICAL: [[&str; 4]; 5] = [
    ["weight.low", "", "", "eps > 0"],
    ["minor.0", "", "", "minor(0) = 0"],
    ["minor.1", "", "", "minor(1) = 1"],
    ["minor.step", "i", INSIDE, "minor(i+1) = 2*(1 - eps)*minor(i) - eps*eps*minor(i-1)"],
    ["minor.positive", "i", "i: i - 1 >= 0; n: last - i >= 0", "minor(i) > 0"],
];

/// Clauses of starts: the end drones stand at the ends; all are in order, in the first subsegment, or below their targets.
const STARTS: [[&str; 4]; 5] = [
    ["start.first", "", "", "x(0,0) = min"],
    ["start.last", "", "", "x(0,last) = max"],
    ["start.order", "i", "i: i >= 0; n: last - i - 1 >= 0", "x(0,i+1) - x(0,i) > 0"],
    ["start.segment", "i", INSIDE, "last*min + (max - min) - last*x(0,i) > 0"],
    [
        "start.bound",
        "i",
        "i: i >= 0; n: last - i >= 0",
        "last*min + i*(max - min) - last*x(0,i) >= 0",
    ],
];

/// The system as it is built.
struct Builder<'k> {
    kernel: &'k mut Kernel,
    last: Poly,
    words: Vec<String>,
    /// The weight of drone i in step k.
    weight: Poly,
}

/// One step of the protocol with everybody updating.
pub type Step = fn(&Params<Poly>, &State<Vec<Poly>>) -> State<Vec<Poly>>;

/// The next value of the drone at a place of a row of indices, from the parameters of its step.
type Next<'n> = dyn Fn(&Params<Poly>, &[Poly], usize) -> Result<Poly> + 'n;

/// Adds the constants, functions and clauses of what runs, or of N alone; gives what it is and its hypothesis in words.
///
/// # Errors
/// What is not known, or contradicts itself.
pub fn install(system: Option<&System>, kernel: &mut Kernel, step: Step) -> Result<String> {
    let drones = system.and_then(|s| s.drones);
    let (last, count) = match drones {
        None => (var("last"), "every N >= 3".to_owned()),
        Some(n @ 3..) => (Poly::from_index(n as usize - 1), format!("N = {n}")),
        Some(n) => return fault("system", format!("{n} drones: expected 3 or more")),
    };
    if drones.is_none() {
        kernel.constant("last", Sort::Integer)?;
    }
    kernel.signature.last = Some(last.clone());
    let mut b = Builder { kernel, last, words: Vec::new(), weight: var("eps") };
    b.say(&[["n", "", "", "last - 2 >= 0"], ["last", "", "", "last > 0"]])?;
    b.words.clear();
    let what = match system {
        None => "a system of agents".to_owned(),
        Some(system) => b.protocol(system, step)?,
    };
    let hypothesis = match b.words.as_slice() {
        [] => String::new(),
        words => format!("\n  given: {}", words.join("; ")),
    };
    Ok(format!("{what}, {count}, last = N - 1{hypothesis}"))
}

impl<'k> Builder<'k> {
    /// Adds a protocol of the spec.
    fn protocol(&mut self, system: &System, step: Step) -> Result<String> {
        self.kernel.constant("eps", Sort::Real)?;
        if let Some(weight) = &system.weight {
            let vars = ["k", "i"].map(|v| (v.into(), Sort::Integer)).to_vec();
            self.weight = self.kernel.signature.poly(weight, &vars, false)?;
        }
        self.kernel.function("x", 2, Sort::Real)?;
        if system.protocol != "consensus" {
            self.kernel.constant("min", Sort::Real)?;
            self.kernel.constant("max", Sort::Real)?;
            self.say(&[["segment", "", "", "max > min"]])?;
        }
        if let Some(of) = &system.weights {
            let (theorem, form) = named(&of.theorem, &of.form)?;
            self.weights(theorem.hypothesis(form).weights)?;
        }
        if let Some(of) = &system.starts {
            ensure!(system.protocol != "consensus", "system", "starts of coverage only");
            let (theorem, form) = named(&of.theorem, &of.form)?;
            self.say(&STARTS[..2])?;
            self.say(match theorem.hypothesis(form).starts {
                StartSet::Any => &[],
                StartSet::Ordered => &STARTS[2..3],
                StartSet::FirstSubsegment => &STARTS[2..4],
                StartSet::UpperBounded => &STARTS[4..],
            })?;
        }
        // What the spec does is not repeated in words.
        let told = self.words.len();
        match (system.protocol.as_str(), system.steps.as_str()) {
            ("coverage", steps) => self.coverage(steps, step)?,
            ("consensus", "full") => self.step("step", "x", &|p, row, at| {
                let path = Path { count: ROW };
                Ok(exec_consensus(&p.eps, &path, &positions("x", row))[at].clone())
            })?,
            ("projection", "full") if system.weight.is_none() => self.projection()?,
            _ => return fault("system", "expected `coverage`, `consensus` or `projection`"),
        }
        self.words.truncate(told);
        let weight = match &system.weight {
            None => String::new(),
            Some(_) => format!(" of weight {}", self.weight),
        };
        Ok(format!("{} with {} steps{weight}", system.protocol, system.steps))
    }

    fn add(&mut self, name: &str, clause: Clause) -> Result<()> {
        if !clause.is_vacuous() {
            self.words.push(clause.to_string());
        }
        self.kernel.add(name, clause)
    }

    /// Integer variables, and literals given about them: `name: literal; ...`.
    fn given(&self, vars: &str, given: &str) -> Result<(Vars, Facts)> {
        let vars: Vars = vars.split_whitespace().map(|v| (v.into(), Sort::Integer)).collect();
        let mut facts = Facts::new();
        for (name, holds) in given.split("; ").filter_map(|g| g.split_once(": ")) {
            facts.insert(name.into(), self.kernel.signature.literal(holds, &vars)?);
        }
        Ok((vars, facts))
    }

    /// Adds clauses over integers: name, variables, literals given, goal.
    fn say(&mut self, clauses: &[[&str; 4]]) -> Result<()> {
        for [name, vars, given, goal] in clauses {
            let (vars, given) = self.given(vars, given)?;
            let goal = self.kernel.signature.literal(goal, &vars)?;
            self.add(name, Clause { vars, given, goal })?;
        }
        Ok(())
    }

    /// The range of weights in literals; that below the critical weight by the leading minors of the spec's
    /// `below_critical`: minor(i) is the one of i - 1 rows.
    fn weights(&mut self, range: WeightRange) -> Result<()> {
        let (low, high) = match range {
            WeightRange::Any => return Ok(()),
            WeightRange::Unit | WeightRange::UpToHalfOrOne => ("eps >= 0", "1 >= eps"),
            WeightRange::BelowThird => ("eps >= 0", "1 - 3*eps > 0"),
            WeightRange::BelowHalf => ("eps >= 0", "1 - 2*eps > 0"),
            WeightRange::UpToHalf => ("eps >= 0", "1 - 2*eps >= 0"),
            WeightRange::PositiveUpToHalf => ("eps > 0", "1 - 2*eps >= 0"),
            WeightRange::BelowCritical => {
                self.kernel.function("minor", 1, Sort::Real)?;
                return self.say(&BELOW_CRITICAL);
            }
        };
        self.say(&[["weight.low", "", "", low], ["weight.high", "", "", high]])?;
        match range {
            WeightRange::UpToHalfOrOne => {
                self.say(&[["weight.four", "", "four: last - 3 >= 0", "1 - 2*eps >= 0"]])
            }
            _ => Ok(()),
        }
    }

    /// The index of each drone of a row in which the one at `at` is of that class.
    fn row(&self, at: usize) -> Vec<Poly> {
        let base = match at {
            0 => int(0),
            2 => var("i") - &int(2),
            _ => self.last.clone() - &Poly::from_index(at),
        };
        (0..ROW).map(|j| base.clone() + &Poly::from_index(j)).collect()
    }

    /// Adds, for each class and every step k, what f is at step k+1: the polynomial that `next` gives of the
    /// parameters, the weight being that of the drone looked at, the row of indices and the place in it.
    fn step(&mut self, of: &str, f: &str, next: &Next<'_>) -> Result<()> {
        for (class, at) in CLASSES {
            let row = self.row(at);
            let eps = self.weight.with(&|v| (v == "i").then(|| row[at].clone()));
            let params = Params { min: var("min"), max: var("max"), eps, n: 0 };
            let now = Poly::app(f, &[var("k") + &int(1), row[at].clone()]);
            let goal = Literal { poly: now - &next(&params, &row, at)?, relation: Zero };
            let (vars, given) = if at == 2 { ("k i", INNER) } else { ("k", "k: k >= 0") };
            let (vars, given) = self.given(vars, given)?;
            self.add(&format!("{of}.{class}"), Clause { vars, given, goal })?;
        }
        Ok(())
    }

    fn coverage(&mut self, steps: &str, step: Step) -> Result<()> {
        let state = |row: &[Poly]| State { drones: positions("x", row), timesteps: 0 };
        match steps {
            "full" => {
                self.step("step", "x", &|p, row, at| Ok(step(p, &state(row)).drones[at].clone()))
            }
            "activation" => {
                // active(k,i) = 1 where drone i updates in step k, 0 where it does not.
                self.kernel.function("active", 2, Sort::Integer)?;
                self.say(&[
                    ["active.low", "k i", "", "active(k,i) >= 0"],
                    ["active.high", "k i", "", "1 - active(k,i) >= 0"],
                ])?;
                self.step("step", "x", &|p, row, at| {
                    let next = |yes: bool| {
                        exec_coverage_active(p, &state(row), |j| yes || j != at).drones[at].clone()
                    };
                    let share = Poly::app("active", &[var("k"), row[at].clone()]);
                    Ok(mixed(&share, [next(true), next(false)]))
                })
            }
            "delay" => {
                // Drone i sees drone j in step k where it was at step seen(k,i,j).
                self.kernel.function("seen", 3, Sort::Integer)?;
                self.say(&[
                    ["seen.low", "k i j", "k: k >= 0", "seen(k,i,j) >= 0"],
                    ["seen.high", "k i j", "k: k >= 0", "k - seen(k,i,j) >= 0"],
                ])?;
                self.step("step", "x", &|p, row, at| {
                    let seen = |j: &Poly| {
                        let when = Poly::app("seen", &[var("k"), row[at].clone(), j.clone()]);
                        Poly::app("x", &[when, j.clone()])
                    };
                    let late: Vec<Poly> = row.iter().map(seen).collect();
                    Ok(exec_coverage_delayed(p, &state(row), |_, j| &late[j]).drones[at].clone())
                })
            }
            _ => fault("system", "expected `full`, `activation` or `delay`"),
        }
    }

    /// Local machines (own, prec, foll) that start as projections of the global state x, both run
    /// tick by tick: moves(k) = 1 in ticks with an update, 0 in those that only count. What a machine
    /// makes of its own fields, and what the exchange makes of all machines', are executed apart. The
    /// counters agree, as is checked here for one below the limit and at it: `timesteps >= num/den` and
    /// `timesteps = n` say the same of every integer up to n, n being the quotient rounded up.
    fn projection(&mut self) -> Result<()> {
        for (name, arity) in [("own", 2), ("prec", 2), ("foll", 2), ("moves", 1)] {
            self.kernel.function(name, arity, Sort::Real)?;
        }
        let ratio = TickRatio { num: 3, den: NonZeroU32::MIN.saturating_add(1) };
        let n = ratio.counter_limit();
        let p = Params { min: var("min"), max: var("max"), eps: var("eps"), n };
        let local = LocalParams { protocol: p.clone(), count: ROW, ratio };
        let global = |row: &[Poly], timesteps| State { drones: positions("x", row), timesteps };
        // Machines with these fields, seen from a row.
        let machines = |row: &[Poly], timesteps, fields: [&dyn Fn(&Poly) -> Poly; 3]| {
            let mut all: Vec<_> =
                (0..ROW).map(|i| project(&p, &global(row, timesteps), i)).collect();
            for (m, i) in all.iter_mut().zip(row) {
                (m.st.own, m.st.prec, m.st.foll) = (fields[0](i), fields[1](i), fields[2](i));
            }
            all
        };
        let field =
            |f: &'static str, k: Poly| move |i: &Poly| Poly::app(f, &[k.clone(), i.clone()]);
        let [own, prec, foll] = ["own", "prec", "foll"].map(|f| field(f, var("k")));
        // In ticks that move, and in those that wait.
        let share = Poly::app("moves", &[var("k")]);
        self.step("step", "x", &|_, row, at| {
            Ok(mixed(&share, [n, n - 1].map(|t| tick(&p, global(row, t)).drones[at].clone())))
        })?;
        self.step("own", "own", &|_, row, at| {
            let moved = [n, n - 1]
                .map(|t| fmu_tick(&local, machines(row, t, [&own, &prec, &foll])[at].clone()));
            let counted = [n, n - 1].map(|t| tick(&p, global(row, t)).timesteps);
            let agree = moved.iter().zip(counted).all(|(m, c)| m.timesteps == c && m.st.id == at);
            ensure!(agree, "system", "counters or identifiers differ");
            Ok(mixed(&share, moved.map(|m| m.st.own)))
        })?;
        let after = field("own", var("k") + &int(1));
        let exchanged = |row: &[Poly], at: usize| {
            exchange(&machines(row, n, [&after, &prec, &foll]))[at].st.clone()
        };
        self.step("prec", "prec", &|_, row, at| Ok(exchanged(row, at).prec))?;
        self.step("foll", "foll", &|_, row, at| Ok(exchanged(row, at).foll))?;
        let start = |p: &Poly| p.substitute(&|a| (*a == Atom::Var("k".into())).then(Poly::default));
        for (class, at) in CLASSES {
            let row = self.row(at);
            let st = project(&p, &global(&row, 0), at).st;
            let (vars, given) = if at == 2 { ("i", INSIDE) } else { ("", "") };
            let (vars, given) = self.given(vars, given)?;
            for (f, field) in [("own", st.own), ("prec", st.prec), ("foll", st.foll)] {
                let poly = Poly::app(f, &[int(0), row[at].clone()]) - &start(&field);
                let goal = Literal { poly, relation: Zero };
                let clause = Clause { vars: vars.clone(), given: given.clone(), goal };
                self.add(&format!("{f}.start.{class}"), clause)?;
            }
        }
        Ok(())
    }
}

/// The values of a function at step k, drone by drone.
fn positions(function: &str, row: &[Poly]) -> Vec<Poly> {
    row.iter().map(|i| Poly::app(function, &[var("k"), i.clone()])).collect()
}

/// The one with that share, else the other.
fn mixed(share: &Poly, [one, other]: [Poly; 2]) -> Poly {
    share.clone() * &one + &((int(1) - share) * &other)
}
