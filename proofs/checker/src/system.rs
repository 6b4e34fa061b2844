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
use cordon_spec::placement::error_at;
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};
use cordon_spec::{Params, Scalar, State};

use crate::expr::Relation::{self, NonNegative, Positive, Zero};
use crate::expr::{Literal, Sort};
use crate::fault::{Result, fault};
use crate::format::{self, Family, System};
use crate::kernel::{Clause, Kernel};
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

/// The system as it is built: clauses, and those that make up its hypothesis.
struct Builder<'k> {
    kernel: &'k mut Kernel,
    last: Poly,
    words: Vec<String>,
    /// How the names of clauses begin that the words are made of.
    told: &'static [&'static str],
}

/// One step of the protocol with everybody updating.
pub type Step = fn(&Params<Poly>, &State<Vec<Poly>>) -> State<Vec<Poly>>;

/// Adds the system's constants, functions and clauses; gives its hypothesis in words.
///
/// # Errors
/// What is not known, or contradicts itself.
pub fn install(system: &System, kernel: &mut Kernel, step: Step) -> Result<String> {
    let mut b = Builder::new(system.drones, kernel)?;
    b.told = &["weight", "segment", "start", "minor"];
    b.constant("eps", Sort::Real);
    b.function("x", 2, Sort::Real);
    if system.protocol != "consensus" {
        b.constant("min", Sort::Real);
        b.constant("max", Sort::Real);
        b.add("segment", &[], &[], var("max") - &var("min"), Positive)?;
    }
    b.weights(&system.weights)?;
    match (system.protocol.as_str(), system.steps.as_str()) {
        ("coverage", steps) => b.coverage(steps, step)?,
        ("consensus", "full") => b.consensus()?,
        ("projection", "full") => b.projection()?,
        _ => return fault("system", "expected `coverage`, `consensus` or `projection`"),
    }
    match &system.starts {
        None => {}
        Some(_) if system.protocol == "consensus" => {
            return fault("system", "starts of coverage only");
        }
        Some(h) => {
            let (theorem, form) = named(&h.theorem, &h.form)?;
            b.starts(theorem.hypothesis(form).starts)?;
        }
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
    b.told = &[""];
    let none = Vec::new();
    for (name, range) in &f.parameters.0 {
        b.kernel.fresh(name, &none)?;
        b.constant(name, Sort::Real);
        if let Some(from) = &range.from {
            let poly = var(name) - &Poly::constant(from.clone());
            b.add(&format!("{name}.from"), &[], &[], poly, NonNegative)?;
        }
        if let Some(to) = &range.to {
            let poly = Poly::constant(to.clone()) - &var(name);
            b.add(&format!("{name}.to"), &[], &[], poly, NonNegative)?;
        }
    }
    for name in &f.state {
        b.kernel.fresh(name, &none)?;
        b.function(name, 2, Sort::Real);
    }
    let ring = match f.topology.as_str() {
        "line" => false,
        "ring" => true,
        _ => return fault("system", "expected `line` or `ring`"),
    };
    let classes: &[&str] = if ring { &["all"] } else { &["first", "inner", "last"] };
    let named =
        f.rules.0.len() == classes.len() && classes.iter().all(|c| f.rules.0.contains_key(*c));
    if !named
        || f.rules
            .0
            .values()
            .flat_map(|r| r.0.keys())
            .any(|v| !b.kernel.signature.functions.contains_key(&**v))
    {
        return fault("system", format!("expected rules for {}, of variables", classes.join(", ")));
    }
    let (k, i, last) = (var("k"), var("i"), b.last.clone());
    let vars = ["k", "i"].map(|v| (v.into(), Sort::Integer)).to_vec();
    for (class, at) in CLASSES {
        let own = b.row(at)[at].clone();
        // Where agent i, and where its neighbours are.
        let before = if at > 0 { Some(own.clone() - &int(1)) } else { ring.then(|| last.clone()) };
        let beyond = if at < ROW - 1 { Some(own.clone() + &int(1)) } else { ring.then(|| int(0)) };
        let places = [
            (i.clone() - &int(1), before),
            (i.clone(), Some(own.clone())),
            (i.clone() + &int(1), beyond),
        ];
        for name in &f.state {
            let rules = f.rules.0.get(if ring { "all" } else { class });
            let kept = format!("{name}(k,i)");
            let text = rules.and_then(|r| r.0.get(name)).unwrap_or(&kept);
            let rule = b.kernel.poly(text, &vars, false)?;
            let place = |a: &Atom| match a {
                Atom::App(f, terms) if terms[0] == k => {
                    let found = places.iter().find(|(written, _)| *written == terms[1])?;
                    Some(Poly::app(f, &[k.clone(), found.1.clone()?]))
                }
                _ => None,
            };
            if rule.any(&|a| matches!(a, Atom::App(..)) && place(a).is_none()) {
                return fault("system", format!("`{text:.60}` speaks of other agents or steps"));
            }
            let own_index = |a: &Atom| (*a == Atom::Var("i".into())).then(|| own.clone());
            let next = rule.substitute(&|a| place(a).or_else(|| own_index(a)));
            let now = Poly::app(name, &[k.clone() + &int(1), own.clone()]);
            b.of_class(&format!("step.{name}"), class, now - &next)?;
        }
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
        let mut b = Self { kernel, last, words: Vec::new(), told: &[] };
        if drones.is_none() {
            b.constant("last", Sort::Integer);
        }
        b.add("n", &[], &[], b.last.clone() - &int(2), NonNegative)?;
        b.add("last", &[], &[], b.last.clone(), Positive)?;
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

    /// Adds a clause over integers, its literals given all >= 0.
    fn add(
        &mut self,
        name: &str,
        vars: &[&str],
        given: &[(&str, Poly)],
        poly: Poly,
        relation: Relation,
    ) -> Result<()> {
        let given = given
            .iter()
            .map(|(n, p)| ((*n).into(), Literal { poly: p.clone(), relation: NonNegative }));
        let vars = vars.iter().map(|v| ((*v).into(), Sort::Integer)).collect();
        let clause = Clause { vars, given: given.collect(), goal: Literal { poly, relation } };
        if self.told.iter().any(|beginning| name.starts_with(beginning)) {
            self.words.push(clause.to_string());
        }
        self.kernel.add(name, clause)
    }

    /// The range of weights in literals; that below the critical weight by the leading minors of the spec's
    /// `below_critical`: minor(i) is the one of i - 1 rows.
    fn weights(&mut self, weights: &format::Weights) -> Result<()> {
        let eps = || var("eps");
        let below = |n: i32| int(1) - &(int(n) * &eps());
        if let Some(from) = &weights.from {
            self.add("weight.from", &[], &[], eps() - &Poly::constant(from.clone()), NonNegative)?;
        }
        if let Some(to) = &weights.to {
            self.add("weight.to", &[], &[], Poly::constant(to.clone()) - &eps(), NonNegative)?;
        }
        let Some(of) = &weights.of else { return Ok(()) };
        let (theorem, form) = named(&of.theorem, &of.form)?;
        let (low, high) = match theorem.hypothesis(form).weights {
            WeightRange::Any => (None, None),
            WeightRange::Unit | WeightRange::UpToHalfOrOne => {
                (Some(NonNegative), Some((1, NonNegative)))
            }
            WeightRange::BelowThird => (Some(NonNegative), Some((3, Positive))),
            WeightRange::BelowHalf => (Some(NonNegative), Some((2, Positive))),
            WeightRange::UpToHalf => (Some(NonNegative), Some((2, NonNegative))),
            WeightRange::PositiveUpToHalf => (Some(Positive), Some((2, NonNegative))),
            WeightRange::BelowCritical => (Some(Positive), None),
        };
        if let Some(relation) = low {
            self.add("weight.low", &[], &[], eps(), relation)?;
        }
        if let Some((n, relation)) = high {
            self.add("weight.high", &[], &[], below(n), relation)?;
        }
        match theorem.hypothesis(form).weights {
            WeightRange::UpToHalfOrOne => {
                let four = [("four", self.last.clone() - &int(3))];
                self.add("weight.four", &[], &four, below(2), NonNegative)
            }
            WeightRange::BelowCritical => {
                self.function("minor", 1, Sort::Real);
                let minor = |o: i32| Poly::app("minor", &[var("i") + &int(o)]);
                let at = |i: i32| Poly::app("minor", &[int(i)]);
                let inside = |upto: i32| {
                    [("i", var("i") - &int(1)), ("n", self.last.clone() - &var("i") - &int(upto))]
                };
                let (from, reach) = (inside(1), inside(0));
                let step =
                    minor(1) - &(int(2) * &below(1) * &minor(0)) + &(eps() * &eps() * &minor(-1));
                self.add("minor.0", &[], &[], at(0), Zero)?;
                self.add("minor.1", &[], &[], at(1) - &int(1), Zero)?;
                self.add("minor.step", &["i"], &from, step, Zero)?;
                self.add("minor.positive", &["i"], &reach, minor(0), Positive)
            }
            _ => Ok(()),
        }
    }

    /// The start set in literals.
    fn starts(&mut self, set: StartSet) -> Result<()> {
        let (i, last) = (var("i"), self.last.clone());
        let x = |i: &Poly| Poly::app("x", &[int(0), i.clone()]);
        let upto = |o: i32| ("n", last.clone() - &i - &int(o));
        self.add("start.first", &[], &[], x(&int(0)) - &var("min"), Zero)?;
        self.add("start.last", &[], &[], x(&last) - &var("max"), Zero)?;
        if matches!(set, StartSet::Ordered | StartSet::FirstSubsegment) {
            let gap = x(&(i.clone() + &int(1))) - &x(&i);
            self.add("start.order", &["i"], &[("i", i.clone()), upto(1)], gap, Positive)?;
        }
        match set {
            StartSet::Any | StartSet::Ordered => Ok(()),
            StartSet::FirstSubsegment => {
                // X_i < min + l, N-1 times: the error of drone 1 at that position.
                let room = error_at(&var("min"), &var("max"), &last, &int(1), &x(&i));
                let inner = [("i", i.clone() - &int(1)), upto(1)];
                self.add("start.segment", &["i"], &inner, room, Positive)
            }
            StartSet::UpperBounded => {
                let error = error_at(&var("min"), &var("max"), &last, &i, &x(&i));
                self.add("start.bound", &["i"], &[("i", i.clone()), upto(0)], error, NonNegative)
            }
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

    /// Adds, for each class, `now` = the polynomial that `next` gives of the row of indices and the place in it.
    fn step(
        &mut self,
        of: &str,
        now: &dyn Fn(&Poly) -> Poly,
        next: &dyn Fn(&[Poly], usize) -> Result<Poly>,
    ) -> Result<()> {
        for (class, at) in CLASSES {
            let row = self.row(at);
            let poly = now(&row[at]) - &next(&row, at)?;
            self.of_class(of, class, poly)?;
        }
        Ok(())
    }

    /// Adds that a polynomial is 0 for every step k and every drone i of a class.
    fn of_class(&mut self, of: &str, class: &str, poly: Poly) -> Result<()> {
        let k = ("k", var("k"));
        let (low, high) = (var("i") - &int(1), self.last.clone() - &var("i") - &int(1));
        let name = format!("{of}.{class}");
        match class {
            "inner" => self.add(&name, &["k", "i"], &[k, ("i", low), ("n", high)], poly, Zero),
            _ => self.add(&name, &["k"], &[k], poly, Zero),
        }
    }

    fn coverage(&mut self, steps: &str, step: Step) -> Result<()> {
        let params = || Params { min: var("min"), max: var("max"), eps: var("eps"), n: 0 };
        let (k, pair) = (var("k"), ["k", "i"]);
        let state = |row: &[Poly]| State { drones: positions("x", row), timesteps: 0 };
        let after = |i: &Poly| Poly::app("x", &[var("k") + &int(1), i.clone()]);
        match steps {
            "full" => self.step("step", &after, &|row, at| {
                Ok(step(&params(), &state(row)).drones[at].clone())
            }),
            "activation" => {
                // active(k,i) = 1 where drone i updates in step k, 0 where it does not.
                self.function("active", 2, Sort::Integer);
                let active = |i: &Poly| Poly::app("active", &[var("k"), i.clone()]);
                self.add("active.low", &pair, &[], active(&var("i")), NonNegative)?;
                self.add("active.high", &pair, &[], int(1) - &active(&var("i")), NonNegative)?;
                self.step("step", &after, &|row, at| {
                    let with = |yes: bool| {
                        exec_coverage_active(&params(), &state(row), |j| yes || j != at).drones[at]
                            .clone()
                    };
                    let share = active(&row[at]);
                    Ok(share.clone() * &with(true) + &((int(1) - &share) * &with(false)))
                })
            }
            "delay" => {
                // Drone i sees drone j in step k where it was at step seen(k,i,j).
                self.function("seen", 3, Sort::Integer);
                let seen =
                    |i: &Poly, j: &Poly| Poly::app("seen", &[var("k"), i.clone(), j.clone()]);
                let given = [("k", k.clone())];
                let some = seen(&var("i"), &var("j"));
                self.add("seen.low", &["k", "i", "j"], &given, some.clone(), NonNegative)?;
                self.add("seen.high", &["k", "i", "j"], &given, k - &some, NonNegative)?;
                self.step("step", &after, &|row, at| {
                    let late: Vec<Poly> = row
                        .iter()
                        .map(|j| Poly::app("x", &[seen(&row[at], j), j.clone()]))
                        .collect();
                    Ok(exec_coverage_delayed(&params(), &state(row), |_, j| &late[j]).drones[at]
                        .clone())
                })
            }
            _ => fault("system", "expected `full`, `activation` or `delay`"),
        }
    }

    fn consensus(&mut self) -> Result<()> {
        let after = |i: &Poly| Poly::app("x", &[var("k") + &int(1), i.clone()]);
        self.step("step", &after, &|row, at| {
            let path = Path { count: ROW };
            Ok(exec_consensus(&var("eps"), &path, &positions("x", row))[at].clone())
        })
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
        let after =
            |f: &'static str| move |i: &Poly| Poly::app(f, &[var("k") + &int(1), i.clone()]);
        // Machines with these fields, seen from a row.
        let machines = |row: &[Poly], timesteps, fields: [&dyn Fn(&Poly) -> Poly; 3]| {
            let mut all: Vec<_> =
                (0..ROW).map(|i| project(&p, &global(row, timesteps), i)).collect();
            for (m, i) in all.iter_mut().zip(row) {
                (m.st.own, m.st.prec, m.st.foll) = (fields[0](i), fields[1](i), fields[2](i));
            }
            all
        };
        let now = |f: &'static str| move |i: &Poly| Poly::app(f, &[var("k"), i.clone()]);
        let (own, prec, foll) = (now("own"), now("prec"), now("foll"));
        // In ticks that move, and in those that wait.
        let ticks = |[moving, waiting]: [Poly; 2]| {
            let share = Poly::app("moves", &[var("k")]);
            share.clone() * &moving + &((int(1) - &share) * &waiting)
        };
        self.step("step", &after("x"), &|row, at| {
            Ok(ticks([n, n - 1].map(|t| tick(&p, global(row, t)).drones[at].clone())))
        })?;
        self.step("own", &after("own"), &|row, at| {
            let moved = [n, n - 1]
                .map(|t| fmu_tick(&local, machines(row, t, [&own, &prec, &foll])[at].clone()));
            let counted = [n, n - 1].map(|t| tick(&p, global(row, t)).timesteps);
            if moved.iter().zip(counted).any(|(m, c)| m.timesteps != c || m.st.id != at) {
                return fault("system", "counters or identifiers differ");
            }
            Ok(ticks(moved.map(|m| m.st.own)))
        })?;
        let exchanged = |row: &[Poly], at: usize| {
            exchange(&machines(row, n, [&after("own"), &prec, &foll]))[at].st.clone()
        };
        self.step("prec", &after("prec"), &|row, at| Ok(exchanged(row, at).prec))?;
        self.step("foll", &after("foll"), &|row, at| Ok(exchanged(row, at).foll))?;
        let start = |p: &Poly| p.substitute(&|a| (*a == Atom::Var("k".into())).then(Poly::default));
        for (class, at) in CLASSES {
            let row = self.row(at);
            let st = project(&p, &global(&row, 0), at).st;
            let i = [("i", var("i") - &int(1)), ("n", self.last.clone() - &var("i") - &int(1))];
            let (vars, given): (&[&str], &[_]) = if at == 2 { (&["i"], &i) } else { (&[], &[]) };
            for (f, field) in [("own", st.own), ("prec", st.prec), ("foll", st.foll)] {
                let goal = Poly::app(f, &[int(0), row[at].clone()]) - &start(&field);
                self.add(&format!("{f}.start.{class}"), vars, given, goal, Zero)?;
            }
        }
        Ok(())
    }
}

/// The values of a function at step k, drone by drone.
fn positions(function: &str, row: &[Poly]) -> Vec<Poly> {
    row.iter().map(|i| Poly::app(function, &[var("k"), i.clone()])).collect()
}
