//! Literals about agents, at every step.

use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::Polynomial;
use cordon_core::{Error, Result, exact};
use cordon_spec::Scalar;
use serde_json::Value;

use super::text::{Literal, Place, Reader, Symbol, Symbols};
use crate::certificate::theorem::clause;

/// A literal about agents, at every step: known, assumed of the start, or to be proved.
#[derive(Clone, Debug)]
pub struct Clause {
    pub name: String,
    pub literal: Literal,
    /// If it is about every i: the furthest neighbour, so that i runs from 0 to `last` minus that.
    pub reach: Option<i64>,
}

/// The literal of a text, by that name.
///
/// # Errors
/// It is none, or speaks of other agents than i and i+1, or of their products.
pub fn read_clause(reader: &Reader<'_>, name: String, text: &str) -> Result<Clause> {
    let literal = reader.literal(text)?;
    let agents = reader.symbols.agents(&literal.poly);
    let fail = |expected: &str| {
        Err(Error::input(format!("`{}`: expected {expected}", exact::shortened(text))))
    };
    let several = |m| {
        let all = reader.symbols.factors(m);
        all.iter().filter(|s| matches!(s, Symbol::At(..))).count() > 1
    };
    if agents.is_empty() || literal.poly.terms().any(|(m, _)| several(m)) {
        return fail("agents, and no products of them");
    }
    let inner: Vec<i64> = agents
        .iter()
        .filter_map(|(_, place)| if let Place::Inner(o) = place { Some(*o) } else { None })
        .collect();
    let reach = inner.iter().max().copied();
    match (inner.iter().min(), reach) {
        (None, None) | (Some(0), Some(0 | 1)) => Ok(Clause { name, literal, reach }),
        _ => fail("agents i, or i and i+1"),
    }
}

/// The literal in the checker's words, agents at a step.
pub fn goal(symbols: &Symbols, literal: &Literal, time: &str) -> String {
    let sign = match literal.sign {
        Sign::Positive => ">",
        Sign::NonNegative => ">=",
        Sign::Zero => "=",
    };
    format!("{} {sign} 0", symbols.write(&literal.poly, time))
}

impl Clause {
    /// As a clause of the certificate, for every step or about one.
    pub fn written(&self, symbols: &Symbols, time: &str, every_step: bool) -> Value {
        let mut given = Vec::new();
        if every_step {
            given.push("k: k >= 0".to_owned());
        }
        if let Some(reach) = self.reach {
            given.push("i: i >= 0".to_owned());
            given.push(format!("u: last - {reach} - i >= 0"));
        }
        let vars = [every_step.then_some("k"), self.reach.map(|_| "i")];
        let vars: Vec<&str> = vars.into_iter().flatten().collect();
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        clause(&self.name, &vars.join(" "), &given, &goal(symbols, &self.literal, time))
    }

    /// The polynomial with the agents of i at a place.
    pub fn at(&self, symbols: &Symbols, place: Place) -> Polynomial {
        symbols.with(&self.literal.poly, &|s| moved(symbols, s, place))
    }
}

/// The symbol with a place for agent i.
pub fn moved(symbols: &Symbols, symbol: &Symbol, place: Place) -> Polynomial {
    let index = |p: Place| match p {
        Place::First(o) => Polynomial::from_int(i32::try_from(o).unwrap_or(0)),
        Place::Inner(o) => {
            symbols.variable(Symbol::Name("i".into()))
                + &Polynomial::from_int(i32::try_from(o).unwrap_or(0))
        }
        Place::Last(o) => {
            symbols.variable(Symbol::Name("last".into()))
                + &Polynomial::from_int(i32::try_from(o).unwrap_or(0))
        }
    };
    match symbol {
        Symbol::At(name, Place::Inner(o)) => {
            symbols.variable(Symbol::At(name.clone(), place.plus(*o)))
        }
        Symbol::Name(name) if name == "i" => index(place),
        other => symbols.variable(other.clone()),
    }
}
