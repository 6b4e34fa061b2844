//! Users' protocols on a line or a ring, for every number of agents at once.
//!
//! Candidates are the claims and what is assumed of the start. Each is tried by induction over the
//! steps, with cases over the agents (the first, the last, those between): the literal one step later is a sum of
//! products of what is known of the neighbours now, of what has been proved already, and of the ranges of the parameters. What
//! holds strictly may need cases over a parameter too. Whatever comes out, the checker judges.

mod clause;
mod search;
mod sums;
mod text;

use std::collections::BTreeMap;

use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::Polynomial;
use cordon_core::simplex::Work;
use cordon_core::{Error, Result, exact};
use cordon_run::protocol::Family;
use cordon_spec::Scalar;
use serde_json::Value;

use crate::certificate::theorem::{Sheet, clause, instance, positivity};
use crate::claims::search::End;
use clause::{Clause, goal, read_clause};
use search::Search;
use sums::Fact;
use text::{Literal, Reader, Symbol, Symbols};

/// Most work that the linear programs of a search may take.
const WORK: u64 = 200_000_000;

/// What was found.
#[derive(Clone, Debug)]
pub struct AnySize {
    /// The certificate, with the claims that are proved as conclusions; none where no claim is.
    pub certificate: Option<Value>,
    /// How many clauses make up the invariant, the claims among them.
    pub invariant: usize,
    /// The claims that are not proved, by their places, with the reason.
    pub open: Vec<(usize, String)>,
}

/// A certificate for every N of the claims for which the strategy finds one. That it finds none does not
/// mean that a claim is false.
///
/// # Errors
/// A rule or an assumption is no expression, or speaks of agents or powers that the strategy has no cases
/// for.
pub fn any_size(family: &Family) -> Result<AnySize> {
    let symbols = Symbols::default();
    let known = |name: &str| family.parameters.contains_key(name);
    let reader = Reader { symbols: &symbols, state: &family.state, constants: &known };
    let clauses = |prefix: &str, from: usize, texts: &[String]| -> Result<Vec<Clause>> {
        let named = (from..).zip(texts).map(|(j, t)| (format!("{prefix}{j}"), t));
        named.map(|(name, t)| read_clause(&reader, name, t)).collect()
    };
    let mut rules = BTreeMap::new();
    for (class, of) in &family.rules {
        for (variable, text) in of {
            rules.insert((class.as_str(), variable.as_str()), reader.polynomial(text)?);
        }
    }
    let starts = clauses("S", 0, &family.start)?;
    let mut count = 0;
    let mut claims: Vec<std::result::Result<Vec<Clause>, String>> = Vec::new();
    for claim in &family.claims {
        claims.push(claim.literals.clone().and_then(|literals| {
            let read = clauses("C", count, &literals).map_err(|e| e.to_string())?;
            count += read.len();
            Ok(read)
        }));
    }
    let mut candidates: Vec<Clause> = claims.iter().flatten().flatten().cloned().collect();
    for s in &starts {
        if !candidates.iter().any(|c| c.literal == s.literal && c.reach == s.reach) {
            candidates.push(s.clone());
        }
    }
    for (j, c) in candidates.iter_mut().enumerate() {
        c.name = format!("L{j}");
    }
    let mut sheet = Sheet::of_three();
    let mut about_constants = Vec::new();
    let mut assume = |sheet: &mut Sheet, name: String, literal: Literal| {
        sheet.assume(clause(&name, "", &[], &goal(&symbols, &literal, "k")));
        about_constants.push(Fact { name, literal });
    };
    for (name, ends) in &family.parameters {
        sheet.constant(name, "real");
        for (end, value, sign) in [("from", &ends[0], 1), ("to", &ends[1], -1)] {
            if let Some(value) = value {
                let variable = symbols.variable(Symbol::Name(name.clone()));
                let poly =
                    (variable - &Polynomial::constant(value.clone())) * &Polynomial::from_int(sign);
                let literal = Literal { poly, sign: Sign::NonNegative };
                assume(&mut sheet, format!("{name}.{end}"), literal);
            }
        }
    }
    for (j, text) in family.given.iter().enumerate() {
        let literal = reader.literal(text)?;
        if !symbols.agents(&literal.poly).is_empty() {
            return Err(Error::input(format!("`{}`: expected no agents", exact::shortened(text))));
        }
        assume(&mut sheet, format!("G{j}"), literal);
    }
    let degree = rules.values().map(|p| degree(&symbols, p)).max().unwrap_or(0);
    let mut search = Search {
        family,
        symbols: &symbols,
        rules,
        starts,
        about_constants,
        degree,
        work: Work::limited(WORK),
        proved: Vec::new(),
    };
    search.assume_steps(&mut sheet);
    for s in &search.starts {
        sheet.assume(s.written(&symbols, "0", false));
    }
    // Claims that rest on others wait for them.
    loop {
        let before = candidates.len();
        let mut open = Vec::new();
        for candidate in candidates {
            match search.proof(&candidate) {
                Some(proof) => {
                    sheet.lemma(candidate.written(&symbols, "k", true), proof);
                    search.proved.push(candidate);
                }
                None => open.push(candidate),
            }
        }
        candidates = open;
        if candidates.len() == before && !search.mutual(&mut candidates, &mut sheet) {
            break;
        }
    }
    let lemma = |claim: &Clause| {
        let same = |l: &&Clause| l.literal == claim.literal && l.reach == claim.reach;
        search.proved.iter().find(same)
    };
    let why = |claim: &[Clause]| match search.work.left() {
        0 => End::Work.to_string(),
        _ if claim.iter().any(|c| search.of_start(c).is_none()) => NOT_OF_THE_START.to_owned(),
        _ => NO_INDUCTION.to_owned(),
    };
    let mut open = Vec::new();
    for (place, claim) in claims.into_iter().enumerate() {
        let with_lemma = |c: Clause| lemma(&c).map(|lemma| (c, lemma));
        let found = claim.and_then(|own| {
            let all = own.iter().cloned().map(with_lemma).collect::<Option<Vec<_>>>();
            all.ok_or_else(|| why(&own))
        });
        match found {
            Err(why) => open.push((place, why)),
            Ok(found) => {
                for (claim, lemma) in found {
                    let (with, given) = match claim.reach {
                        Some(_) => ("k=k, i=i", "k=[k], i=[i], u=[u]"),
                        None => ("k=k", "k=[k]"),
                    };
                    let proof = positivity(&[instance("c", &lemma.name, with, given)], "[c]");
                    sheet.conclude(claim.written(&symbols, "k", true), proof);
                }
            }
        }
    }
    Ok(AnySize {
        certificate: (open.len() < family.claims.len()).then(|| sheet.certificate()),
        invariant: search.proved.len(),
        open,
    })
}

/// Why a claim is open that was tried to the end.
const NOT_OF_THE_START: &str = "it does not follow of the start, agent by agent, from what `start` says: expected it there too";
const NO_INDUCTION: &str = "no induction over the steps was found";

/// The power of the constants together.
fn degree(symbols: &Symbols, p: &Polynomial) -> usize {
    let names = |m| symbols.factors(m).iter().filter(|s| matches!(s, Symbol::Name(_))).count();
    p.terms().map(|(m, _)| names(m)).max().unwrap_or(0)
}
