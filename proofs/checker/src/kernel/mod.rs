//! The kernel: clauses, and the six rules by which they are proved.
//!
//! A clause says that for all integers and reals in the place of its variables, wherever the
//! literals given hold, so does its goal. `proofs/rocq/theories/Kernel.v` proves the rules sound;
//! `RULES.md` sets them side by side.

mod definition;
mod rules;

use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

use crate::expr::{Literal, Signature, Sort, Vars, joined};
use crate::fault::{Result, ensure};
use crate::format;
use crate::number::spend;
use crate::poly::Poly;

/// A universally quantified implication.
#[derive(Clone, Debug)]
pub struct Clause {
    /// The variables.
    pub vars: Vars,
    /// The literals given, by name.
    pub given: Facts,
    /// The goal.
    pub goal: Literal,
}

/// Names and what the facts of these names say.
pub type Facts = BTreeMap<Rc<str>, Literal>;

impl Clause {
    /// That a literal holds.
    pub fn fact(goal: Literal) -> Self {
        Self { vars: Vars::new(), given: Facts::new(), goal }
    }

    /// The clause with polynomials in the place of variables.
    fn with(&self, value: &dyn Fn(&str) -> Option<Poly>) -> Self {
        let at = |p: &Poly| p.with(value);
        let given = self.given.iter().map(|(n, l)| (n.clone(), l.map(at))).collect();
        Self { vars: self.vars.clone(), given, goal: self.goal.map(at) }
    }

    /// The clause with a polynomial in the place of one variable, which is no variable then.
    fn at(&self, variable: &str, p: &Poly) -> Self {
        let mut clause = self.with(&|v| (*v == *variable).then(|| p.clone()));
        clause.vars.retain(|(v, _)| **v != *variable);
        clause
    }

    fn size(&self) -> u64 {
        let literals = self.given.values().chain([&self.goal]);
        self.vars.len() as u64 + literals.map(|l| 1 + l.poly.size()).sum::<u64>()
    }
}

impl fmt::Display for Clause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (sort, word) in [(Sort::Integer, "integers"), (Sort::Real, "reals")] {
            let names = joined(self.vars.iter().filter(|v| v.1 == sort).map(|v| &v.0), ", ");
            if !names.is_empty() {
                write!(f, "for all {word} {names}, ")?;
            }
        }
        let given = joined(self.given.values(), " and ");
        if !given.is_empty() {
            write!(f, "if {given} then ")?;
        }
        self.goal.fmt(f)
    }
}

/// What is proved or assumed so far.
#[derive(Default)]
pub struct Kernel {
    /// The names that clauses may use.
    pub signature: Signature,
    /// Clauses by name.
    pub lemmas: BTreeMap<Rc<str>, Clause>,
    /// Those without variables and literals given: facts everywhere.
    closed: Facts,
}

impl Kernel {
    /// A name for something new.
    ///
    /// # Errors
    /// It is no name, or taken.
    pub fn fresh(&self, name: &str, vars: &Vars) -> Result<Rc<str>> {
        spend(128 + vars.len() as u64)?;
        let letters = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.bytes().all(|b| b.is_ascii_alphanumeric());
        let taken = vars.iter().any(|(v, _)| **v == *name)
            || self.signature.constants.contains_key(name)
            || self.signature.functions.contains_key(name);
        ensure!(letters && !taken, "name", "`{name:.40}` is no name, or taken");
        Ok(name.into())
    }

    /// Adds a constant, or says which fault its name has.
    ///
    /// # Errors
    /// It is no name, or taken.
    pub fn constant(&mut self, name: &str, sort: Sort) -> Result<()> {
        let name = self.fresh(name, &Vars::new())?;
        self.signature.constants.insert(name, sort);
        Ok(())
    }

    /// Adds a function of so many integers, of which nothing is known.
    ///
    /// # Errors
    /// Its name is none, or taken.
    pub fn function(&mut self, name: &str, arity: usize, sort: Sort) -> Result<()> {
        let name = self.fresh(name, &Vars::new())?;
        self.signature.functions.insert(name, (arity, sort));
        Ok(())
    }

    /// Adds a clause that is assumed, or that has been proved.
    ///
    /// # Errors
    /// There is one of that name.
    pub fn add(&mut self, name: &str, clause: Clause) -> Result<()> {
        if clause.vars.is_empty() && clause.given.is_empty() {
            self.closed.insert(name.into(), clause.goal.clone());
        }
        let taken = self.lemmas.insert(name.into(), clause).is_some();
        ensure!(!taken, "name", "`{name:.40}` is there twice");
        Ok(())
    }

    /// Reads a clause.
    ///
    /// # Errors
    /// Names or expressions that are wrong.
    pub fn clause(&self, written: &format::Clause) -> Result<Clause> {
        let mut vars = Vars::new();
        for v in &written.r#for {
            vars.push((self.fresh(&v.name, &vars)?, v.sort));
        }
        let mut given = Facts::new();
        for g in &written.given {
            insert(&mut given, &g.name, self.signature.literal(&g.holds, &vars)?)?;
        }
        let goal = self.signature.literal(&written.goal, &vars)?;
        Ok(Clause { vars, given, goal })
    }
}

/// Adds a fact.
fn insert(facts: &mut Facts, name: &str, literal: Literal) -> Result<()> {
    let taken = facts.insert(name.into(), literal).is_some();
    ensure!(!taken, "name", "the fact `{name:.40}` is there twice");
    Ok(())
}
