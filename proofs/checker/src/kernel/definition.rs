//! The rule that adds a function.

use std::collections::BTreeSet;

use cordon_spec::Scalar;

use crate::expr::Relation::{NonNegative, Positive, Zero};
use crate::expr::{Literal, Sort, Vars, joined};
use crate::fault::{Result, ensure, fault};
use crate::format::Definition;
use crate::kernel::{Clause, Facts, Kernel};
use crate::poly::{Atom, Poly};

const RULE: &str = "definition";

impl Kernel {
    /// Rule *definition*: there is a function with the given first values and, from
    /// them on, `scale` times the next value equal to `step` wherever `scale` is above 0; `step` reads `base.len()` values
    /// before it; nothing was known of its name. Gives the definition in words.
    ///
    /// # Errors
    /// A name that is taken, or values of other arguments.
    pub fn define(&mut self, d: &Definition) -> Result<String> {
        let (name, none) = (self.fresh(&d.name, &Vars::new())?, Vars::new());
        let mut vars = Vars::new();
        for argument in &d.of {
            vars.push((self.fresh(argument, &vars)?, Sort::Integer));
        }
        // The last argument counts, from `start` on.
        let Some((last, parameters)) = vars.split_last() else {
            return fault(RULE, "recursion without an argument");
        };
        let (parameters, here) = (parameters.to_vec(), Poly::var(&last.0));
        let start = self.signature.poly(&d.from, &none, false)?;
        ensure!(self.signature.is_integer(&start, &none), RULE, "`from` is no integer");
        let value = |at: &Poly, j: usize| {
            let mut terms: Vec<Poly> = parameters.iter().map(|(p, _)| Poly::var(p)).collect();
            terms.push(at.clone() + &Poly::from_index(j));
            Poly::app(&name, &terms)
        };
        let from = Literal { poly: here.clone() - &start, relation: NonNegative };
        let mut given = Facts::from([("from".into(), from)]);
        let scale = self.signature.poly(d.scale.as_deref().unwrap_or("1"), &vars, false)?;
        if d.scale.is_some() {
            given.insert("scale".into(), Literal { poly: scale.clone(), relation: Positive });
        }
        let mut clauses = Vec::new();
        for (j, base) in d.base.iter().enumerate() {
            let poly = value(&start, j) - &self.signature.poly(base, &parameters, false)?;
            let goal = Literal { poly, relation: Zero };
            let clause = Clause { vars: parameters.clone(), given: Facts::new(), goal };
            clauses.push((format!("{name}.{j}"), clause));
        }
        self.signature.functions.insert(name.clone(), (vars.len(), Sort::Real));
        let step = self.signature.poly(&d.step, &vars, false)?;
        let known: BTreeSet<Poly> = (0..d.base.len()).map(|j| value(&here, j)).collect();
        let other = |a: &Atom| {
            matches!(a, Atom::App(f, _) if *f == name) && !known.contains(&Poly::atom(a.clone()))
        };
        ensure!(!step.any(&other), RULE, "`step` reads `{name}` at other arguments");
        let poly = scale * &value(&here, d.base.len()) - &step;
        let goal = Literal { poly, relation: Zero };
        clauses.push((format!("{name}.step"), Clause { vars, given, goal }));
        let words = joined(clauses.iter().map(|(_, clause)| clause), " and ");
        for (name, clause) in clauses {
            self.add(&name, clause)?;
        }
        Ok(words)
    }
}
