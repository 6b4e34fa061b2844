//! From the spec to clauses: what runs.
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
use cordon_spec::{Params, Scalar, State};

use crate::expr::Relation::{NonNegative, Positive, Zero};
use crate::expr::{Literal, Sort};
use crate::fault::{Result, ensure, fault};
use crate::format::System;
use crate::kernel::{Clause, Facts, Kernel};
use crate::poly::Poly;

/// Drones in a row of symbols: two on either side of the one looked at.
const ROW: usize = 5;

/// One step of the protocol with everybody updating.
pub type Step = fn(&Params<Poly>, &State<Vec<Poly>>) -> State<Vec<Poly>>;

/// A value of the drone at a place of a row of indices, from the parameters of its step.
type Value<'v> = dyn Fn(&Params<Poly>, &[Poly], usize) -> Poly + 'v;

fn int(n: i32) -> Poly {
    Poly::from_int(n)
}

fn var(name: &str) -> Poly {
    Poly::var(name)
}

/// The values of a function at a step, drone by drone.
fn positions(function: &str, step: &Poly, row: &[Poly]) -> Vec<Poly> {
    row.iter().map(|i| Poly::app(function, &[step.clone(), i.clone()])).collect()
}

/// The one with that share, else the other.
fn mixed(share: &Poly, [one, other]: [Poly; 2]) -> Poly {
    share.clone() * &one + &((int(1) - share) * &other)
}

/// The system as it is built.
struct Builder<'k> {
    kernel: &'k mut Kernel,
    /// The weight of drone i in step k.
    weight: Poly,
}

/// Adds the constants and functions of what runs, that N >= 3, and what a step makes of a drone of each class; says what it is.
///
/// # Errors
/// What is not known, or contradicts itself.
pub fn install(system: &System, kernel: &mut Kernel, step: Step) -> Result<String> {
    kernel.constant("last", Sort::Integer)?;
    for (name, less, relation) in [("n", 2, NonNegative), ("last", 0, Positive)] {
        let poly = var("last") - &int(less);
        kernel.add(name, Clause::fact(Literal { poly, relation }))?;
    }
    kernel.constant("eps", Sort::Real)?;
    let vars = ["k", "i"].map(|v| (v.into(), Sort::Integer)).to_vec();
    let weight = system.weight.as_deref().unwrap_or("eps");
    let weight = kernel.signature.poly(weight, &vars, false)?;
    kernel.constant("min", Sort::Real)?;
    kernel.constant("max", Sort::Real)?;
    kernel.function("x", 2, Sort::Real)?;
    let of = system.weight.as_ref().map_or(String::new(), |_| format!(" of weight {weight}"));
    let mut builder = Builder { kernel, weight };
    let after = var("k") + &int(1);
    let now = |row: &[Poly]| State { drones: positions("x", &var("k"), row), timesteps: 0 };
    match (system.protocol.as_str(), system.steps.as_str()) {
        ("coverage", "full") => {
            builder.clauses("step", "x", &after, &|p, row, at| {
                step(p, &now(row)).drones[at].clone()
            })?;
        }
        ("coverage", "activation") => {
            // active(k,i) is 1 where drone i updates in step k, 0 where it does not.
            builder.kernel.function("active", 2, Sort::Integer)?;
            builder.clauses("step", "x", &after, &|p, row, at| {
                let next = |yes| exec_coverage_active(p, &now(row), |j| yes || j != at).drones;
                let share = Poly::app("active", &[var("k"), row[at].clone()]);
                mixed(&share, [true, false].map(|yes| next(yes)[at].clone()))
            })?;
        }
        ("coverage", "delay") => {
            // Drone i sees drone j in step k where it was at step seen(k,i,j).
            builder.kernel.function("seen", 3, Sort::Integer)?;
            builder.clauses("step", "x", &after, &|p, row, at| {
                let when = |j: &Poly| Poly::app("seen", &[var("k"), row[at].clone(), j.clone()]);
                let late = |j: &Poly| Poly::app("x", &[when(j), j.clone()]);
                let late: Vec<Poly> = row.iter().map(late).collect();
                exec_coverage_delayed(p, &now(row), |_, j| &late[j]).drones[at].clone()
            })?;
        }
        ("consensus", "full") => builder.clauses("step", "x", &after, &|p, row, at| {
            exec_consensus(&p.eps, &Path { count: ROW }, &now(row).drones)[at].clone()
        })?,
        ("projection", "full") => builder.projection()?,
        _ => {
            let what = "expected `coverage` with `full`, `activation` or `delay`, `consensus` or `projection` with `full`";
            return fault("system", what);
        }
    }
    let what = format!("{} with {} steps{of}", system.protocol, system.steps);
    Ok(format!("{what}, every N >= 3, last = N - 1"))
}

impl Builder<'_> {
    /// Adds, for each class of drones and every k, what f is at that step: the polynomial that `value` gives of the
    /// parameters, the weight being that of the drone looked at, the row of indices and the place in it.
    fn clauses(&mut self, name: &str, f: &str, step: &Poly, value: &Value<'_>) -> Result<()> {
        for (class, at, here) in
            [("first", 0, int(0)), ("inner", 2, var("i")), ("last", ROW - 1, var("last"))]
        {
            let place = |j| here.clone() + &Poly::from_index(j) - &Poly::from_index(at);
            let row: Vec<Poly> = (0..ROW).map(place).collect();
            let eps = self.weight.with(&|v| (v == "i").then(|| here.clone()));
            let params = Params { min: var("min"), max: var("max"), eps, n: 0 };
            let there = Poly::app(f, &[step.clone(), here.clone()]);
            let goal = Literal { poly: there - &value(&params, &row, at), relation: Zero };
            let bound = |poly| Literal { poly, relation: NonNegative };
            let mut vars = vec![("k".into(), Sort::Integer)];
            let mut given = Facts::from([("k".into(), bound(var("k")))]);
            if class == "inner" {
                vars.push(("i".into(), Sort::Integer));
                given.insert("i".into(), bound(here.clone() - &int(1)));
                given.insert("n".into(), bound(var("last") - &int(1) - &here));
            }
            self.kernel.add(&format!("{name}.{class}"), Clause { vars, given, goal })?;
        }
        Ok(())
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
        let (k, after, share) = (var("k"), var("k") + &int(1), Poly::app("moves", &[var("k")]));
        let of = |p: &Params<Poly>| Params { n, ..p.clone() };
        let global = |step: &Poly, row: &[Poly], timesteps| State {
            drones: positions("x", step, row),
            timesteps,
        };
        // Machines with these fields, seen from a row, their own position being that of a step.
        let machines = |p: &Params<Poly>, step: &Poly, row: &[Poly], timesteps| -> Vec<_> {
            let machine = |(i, here): (usize, &Poly)| {
                let mut m = project(&of(p), &global(&k, row, timesteps), i);
                let field = |f, step: &Poly| Poly::app(f, &[step.clone(), here.clone()]);
                m.st.own = field("own", step);
                (m.st.prec, m.st.foll) = (field("prec", &k), field("foll", &k));
                m
            };
            row.iter().enumerate().map(machine).collect()
        };
        let ticked = |p: &Params<Poly>, row: &[Poly], at: usize, timesteps| {
            let local = LocalParams { protocol: of(p), count: ROW, ratio };
            fmu_tick(&local, machines(p, &k, row, timesteps)[at].clone())
        };
        // In ticks that move, and in those that wait.
        self.clauses("step", "x", &after, &|p, row, at| {
            let next = |t| tick(&of(p), global(&k, row, t)).drones[at].clone();
            mixed(&share, [n, n - 1].map(next))
        })?;
        self.clauses("own", "own", &after, &|p, row, at| {
            mixed(&share, [n, n - 1].map(|t| ticked(p, row, at, t).st.own))
        })?;
        let exchanged = |p: &Params<Poly>, row: &[Poly], at: usize| {
            exchange(&machines(p, &after, row, n))[at].st.clone()
        };
        self.clauses("prec", "prec", &after, &|p, row, at| exchanged(p, row, at).prec)?;
        self.clauses("foll", "foll", &after, &|p, row, at| exchanged(p, row, at).foll)?;
        let start =
            |p: &Params<Poly>, row: &[Poly], at| project(p, &global(&int(0), row, 0), at).st;
        self.clauses("own.start", "own", &int(0), &|p, row, at| start(p, row, at).own)?;
        self.clauses("prec.start", "prec", &int(0), &|p, row, at| start(p, row, at).prec)?;
        self.clauses("foll.start", "foll", &int(0), &|p, row, at| start(p, row, at).foll)?;
        let params = Params { min: var("min"), max: var("max"), eps: var("eps"), n };
        let row: Vec<Poly> = (0..ROW).map(Poly::from_index).collect();
        let agree = |t| {
            let counted = tick(&params, global(&k, &row, t)).timesteps;
            let machine = |i| ticked(&params, &row, i, t);
            (0..ROW).all(|i| machine(i).timesteps == counted && machine(i).st.id == i)
        };
        ensure!([n, n - 1].into_iter().all(agree), "system", "counters or identifiers differ");
        Ok(())
    }
}
