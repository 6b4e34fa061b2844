//! From the spec to clauses: what runs, and under which hypothesis.
//!
//! `exec_coverage` computes drone i from drones i-1, i, i+1, and branches on `i = 0` and `i + 1 =
//! count` only. For N >= 3 every drone is of one class: the first (i = 0), an inner (1 <= i <= N-2)
//! or the last (i = N-1). Two members of a class differ in i and N through `i` and `last` only, so
//! that the spec's own step, run on a row of symbols around one member, is the step of all.
//! The checker's tests confirm that by execution for every i and N up to 16.

use std::collections::BTreeSet;
use std::num::NonZeroU32;

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::tick;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::graph::Path;
use cordon_spec::local::{LocalParams, TickRatio, exchange, fmu_tick, project};
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};
use cordon_spec::{Params, Scalar, State};

use crate::expr::Relation::{NonNegative, Zero};
use crate::expr::{Literal, Sort, Vars};
use crate::fault::{Result, ensure, fault};
use crate::format::{Family, Range, System};
use crate::kernel::{Clause, Facts, Kernel};
use crate::number::Number;
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
    /// Whether clauses that are added are said in words.
    told: bool,
}

/// One step of the protocol with everybody updating.
pub type Step = fn(&Params<Poly>, &State<Vec<Poly>>) -> State<Vec<Poly>>;

/// Adds the system's constants, functions and clauses; gives its hypothesis in words.
///
/// # Errors
/// What is not known, or contradicts itself.
pub fn install(system: &System, kernel: &mut Kernel, step: Step) -> Result<String> {
    let mut b = Builder::new(system.drones, kernel)?;
    b.constant("eps", Sort::Real);
    b.function("x", 2, Sort::Real);
    if system.protocol != "consensus" {
        b.constant("min", Sort::Real);
        b.constant("max", Sort::Real);
        b.say(&[["segment", "", "", "max > min"]])?;
    }
    b.within("weight", "eps", &system.weights.from, &system.weights.to)?;
    if let Some(of) = &system.weights.of {
        let (theorem, form) = named(&of.theorem, &of.form)?;
        b.weights(theorem.hypothesis(form).weights)?;
    }
    if let Some(h) = &system.starts {
        ensure!(system.protocol != "consensus", "system", "starts of coverage only");
        let (theorem, form) = named(&h.theorem, &h.form)?;
        b.say(&STARTS[..2])?;
        b.say(match theorem.hypothesis(form).starts {
            StartSet::Any => &[],
            StartSet::Ordered => &STARTS[2..3],
            StartSet::FirstSubsegment => &STARTS[2..4],
            StartSet::UpperBounded => &STARTS[4..],
        })?;
    }
    // What the spec does is not repeated in words.
    b.told = false;
    match (system.protocol.as_str(), system.steps.as_str()) {
        ("coverage", steps) => b.coverage(steps, step)?,
        ("consensus", "full") => b.step("step", "x", &|row, at| {
            let path = Path { count: ROW };
            Ok(exec_consensus(&var("eps"), &path, &positions("x", row))[at].clone())
        })?,
        ("projection", "full") => b.projection()?,
        _ => return fault("system", "expected `coverage`, `consensus` or `projection`"),
    }
    Ok(b.said(&format!("{} with {} steps", system.protocol, system.steps), system.drones))
}

/// Adds a user's system: its constants and functions, a range for each constant, and for each class of
/// agents a clause a variable. A rule speaks of agent i and its neighbours i-1 and i+1 at step k. On a line the first
/// and the last have one neighbour; on a ring the last is the one before the first, and the rule is the same for all.
///
/// # Errors
/// What is not known, or speaks of other agents.
pub fn family(f: &Family, kernel: &mut Kernel) -> Result<String> {
    let mut b = Builder::new(f.drones, kernel)?;
    for (name, Range { from, to }) in &f.parameters.0 {
        b.kernel.constant(name, Sort::Real)?;
        b.within(name, name, from, to)?;
    }
    for name in &f.state {
        b.kernel.fresh(name, &Vars::new())?;
        b.function(name, 2, Sort::Real);
    }
    let classes = match f.topology.as_str() {
        "line" => CLASSES.map(|(class, _)| class),
        "ring" => ["all"; 3],
        _ => return fault("system", "expected `line` or `ring`"),
    };
    let ring = f.topology == "ring";
    let classes_of = if ring { "all" } else { "first, inner, last" };
    let complete = BTreeSet::from(classes).into_iter().eq(f.rules.0.keys().map(String::as_str));
    let functions = &b.kernel.signature.functions;
    let variables =
        f.rules.0.values().flat_map(|r| r.0.keys()).all(|v| functions.contains_key(v.as_str()));
    ensure!(complete && variables, "system", "expected rules for {classes_of}, of variables");
    let (k, i, one, last) = (var("k"), var("i"), int(1), b.last.clone());
    let vars = ["k", "i"].map(|v| (v.into(), Sort::Integer)).to_vec();
    for name in &f.state {
        let kept = format!("{name}(k,i)");
        let read = |class| {
            let text = f.rules.0.get(class).and_then(|r| r.0.get(name)).unwrap_or(&kept);
            Ok((text, b.kernel.signature.poly(text, &vars, false)?))
        };
        let rules = classes.into_iter().map(read).collect::<Result<Vec<_>>>()?;
        b.step(&format!("step.{name}"), name, &|row, at| {
            let own = &row[at];
            // Where agent i, and where its neighbours are.
            let before = if at > 0 { Some(own.clone() - &one) } else { ring.then(|| last.clone()) };
            let beyond = if at < ROW - 1 { Some(own.clone() + &one) } else { ring.then(|| int(0)) };
            let places = [
                (i.clone() - &one, before),
                (i.clone(), Some(own.clone())),
                (i.clone() + &one, beyond),
            ];
            let place = |a: &Atom| match a {
                Atom::App(f, terms) if terms[0] == k => {
                    let found = places.iter().find(|(written, _)| *written == terms[1])?;
                    Some(Poly::app(f, &[k.clone(), found.1.clone()?]))
                }
                _ => None,
            };
            let (text, rule) = &rules[at / 2];
            let strange = rule.any(&|a| matches!(a, Atom::App(..)) && place(a).is_none());
            ensure!(!strange, "system", "`{text:.60}` speaks of other agents or steps");
            let own_index = |a: &Atom| (*a == Atom::Var("i".into())).then(|| own.clone());
            Ok(rule.substitute(&|a| place(a).or_else(|| own_index(a))))
        })?;
    }
    Ok(b.said(&format!("agents on a {}", f.topology), f.drones))
}

impl<'k> Builder<'k> {
    /// N, or one N, and nothing that runs yet.
    fn new(drones: Option<u32>, kernel: &'k mut Kernel) -> Result<Self> {
        let last = match drones {
            None => var("last"),
            Some(n @ 3..) => Poly::from_index(n as usize - 1),
            Some(n) => return fault("system", format!("{n} drones: expected 3 or more")),
        };
        kernel.signature.last = Some(last.clone());
        let mut b = Self { kernel, last, words: Vec::new(), told: false };
        if drones.is_none() {
            b.constant("last", Sort::Integer);
        }
        b.say(&[["n", "", "", "last - 2 >= 0"], ["last", "", "", "last > 0"]])?;
        b.told = true;
        Ok(b)
    }

    /// The system in words.
    fn said(&self, what: &str, drones: Option<u32>) -> String {
        let drones = drones.map_or("every N >= 3".into(), |n| format!("N = {n}"));
        let hypothesis = match self.words.as_slice() {
            [] => String::new(),
            words => format!("\n  given: {}", words.join("; ")),
        };
        format!("{what}, {drones}, last = N - 1{hypothesis}")
    }

    fn constant(&mut self, name: &str, sort: Sort) {
        self.kernel.signature.constants.insert(name.into(), sort);
    }

    fn function(&mut self, name: &str, arity: usize, sort: Sort) {
        self.kernel.signature.functions.insert(name.into(), (arity, sort));
    }

    fn add(&mut self, name: &str, clause: Clause) -> Result<()> {
        if self.told && !clause.is_vacuous() {
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

    /// Adds that a constant is in a range.
    fn within(
        &mut self,
        of: &str,
        name: &str,
        from: &Option<Number>,
        to: &Option<Number>,
    ) -> Result<()> {
        let at = |n: &Number| Poly::constant(n.clone());
        let low = from.as_ref().map(|n| ("from", var(name) - &at(n)));
        let high = to.as_ref().map(|n| ("to", at(n) - &var(name)));
        for (end, poly) in low.into_iter().chain(high) {
            let goal = Literal { poly, relation: NonNegative };
            self.add(&format!("{of}.{end}"), Clause::fact(goal))?;
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
                self.function("minor", 1, Sort::Real);
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
    /// row of indices and the place in it.
    fn step(
        &mut self,
        of: &str,
        f: &str,
        next: &dyn Fn(&[Poly], usize) -> Result<Poly>,
    ) -> Result<()> {
        for (class, at) in CLASSES {
            let row = self.row(at);
            let now = Poly::app(f, &[var("k") + &int(1), row[at].clone()]);
            let goal = Literal { poly: now - &next(&row, at)?, relation: Zero };
            let (vars, given) = if at == 2 { ("k i", INNER) } else { ("k", "k: k >= 0") };
            let (vars, given) = self.given(vars, given)?;
            self.add(&format!("{of}.{class}"), Clause { vars, given, goal })?;
        }
        Ok(())
    }

    fn coverage(&mut self, steps: &str, step: Step) -> Result<()> {
        let params = Params { min: var("min"), max: var("max"), eps: var("eps"), n: 0 };
        let state = |row: &[Poly]| State { drones: positions("x", row), timesteps: 0 };
        match steps {
            "full" => {
                self.step("step", "x", &|row, at| Ok(step(&params, &state(row)).drones[at].clone()))
            }
            "activation" => {
                // active(k,i) = 1 where drone i updates in step k, 0 where it does not.
                self.function("active", 2, Sort::Integer);
                self.say(&[
                    ["active.low", "k i", "", "active(k,i) >= 0"],
                    ["active.high", "k i", "", "1 - active(k,i) >= 0"],
                ])?;
                self.step("step", "x", &|row, at| {
                    let next = |yes: bool| {
                        exec_coverage_active(&params, &state(row), |j| yes || j != at).drones[at]
                            .clone()
                    };
                    let share = Poly::app("active", &[var("k"), row[at].clone()]);
                    Ok(mixed(&share, [next(true), next(false)]))
                })
            }
            "delay" => {
                // Drone i sees drone j in step k where it was at step seen(k,i,j).
                self.function("seen", 3, Sort::Integer);
                self.say(&[
                    ["seen.low", "k i j", "k: k >= 0", "seen(k,i,j) >= 0"],
                    ["seen.high", "k i j", "k: k >= 0", "k - seen(k,i,j) >= 0"],
                ])?;
                self.step("step", "x", &|row, at| {
                    let seen = |j: &Poly| {
                        let when = Poly::app("seen", &[var("k"), row[at].clone(), j.clone()]);
                        Poly::app("x", &[when, j.clone()])
                    };
                    let late: Vec<Poly> = row.iter().map(seen).collect();
                    Ok(exec_coverage_delayed(&params, &state(row), |_, j| &late[j]).drones[at]
                        .clone())
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
            self.function(name, arity, Sort::Real);
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
        self.step("step", "x", &|row, at| {
            Ok(mixed(&share, [n, n - 1].map(|t| tick(&p, global(row, t)).drones[at].clone())))
        })?;
        self.step("own", "own", &|row, at| {
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
        self.step("prec", "prec", &|row, at| Ok(exchanged(row, at).prec))?;
        self.step("foll", "foll", &|row, at| Ok(exchanged(row, at).foll))?;
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
