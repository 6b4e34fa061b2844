//! One way in which a system may step.

use std::collections::BTreeMap;

use cordon_spec::Scalar;
use num_traits::Zero;

use super::{Map, Parameter};
use crate::scalar::Polynomial;
use crate::{Error, Rational, Result};

/// A row of a mode: the constant and the nonzero coefficients, by column; polynomials in the
/// parameters, of degree at most one in each.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Row {
    constant: Polynomial,
    entries: BTreeMap<usize, Polynomial>,
}

/// An affine map of the state whose coefficients depend on the parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mode {
    /// Its name in the protocol.
    pub name: String,
    rows: Vec<Row>,
}

impl Mode {
    /// The mode of a step, found by executing it once on symbols. `step` is given the embedding of
    /// numbers, the parameters and the state.
    ///
    /// # Errors
    /// The step is not affine in the state, or of a degree above one in a parameter; or it does not
    /// have as many components as the state.
    pub fn executed(
        name: &str,
        variables: usize,
        parameters: &[Parameter],
        step: impl FnOnce(fn(&Rational) -> Polynomial, &[Polynomial], &[Polynomial]) -> Vec<Polynomial>,
    ) -> Result<Self> {
        let symbol = |v: usize| Polynomial::variable(u32::try_from(v).unwrap_or(u32::MAX));
        let state: Vec<Polynomial> = (0..variables).map(symbol).collect();
        let symbols: Vec<Polynomial> =
            (0..parameters.len()).map(|p| symbol(variables + p)).collect();
        let next = step(|c| Polynomial::constant(c.clone()), &symbols, &state);
        if next.len() != variables {
            return Err(Error::input(format!(
                "step: {} components: expected {variables}, one a state variable",
                next.len()
            )));
        }
        Self::read(name, &next, variables, parameters)
    }

    /// The mode with these next values: polynomials in the state (indeterminates `0 .. variables`)
    /// and the parameters (those after).
    ///
    /// # Errors
    /// As for [`executed`](Self::executed).
    pub fn read(
        name: &str,
        next: &[Polynomial],
        variables: usize,
        parameters: &[Parameter],
    ) -> Result<Self> {
        let rows = next.iter().map(|p| row(p, variables, parameters)).collect::<Result<_>>()?;
        Ok(Self { name: name.to_owned(), rows })
    }

    /// The step on any scalars.
    pub fn step<S: Scalar>(
        &self,
        number: &impl Fn(&Rational) -> S,
        parameters: &[S],
        x: &[S],
    ) -> Vec<S> {
        let value = |p: &Polynomial| {
            p.terms().fold(S::from_int(0), |sum, (m, c)| {
                let factors = m.powers().filter_map(|(v, _)| parameters.get(v as usize));
                sum + &factors.fold(number(c), |product, f| product * f)
            })
        };
        let next = |row: &Row| {
            let terms = row.entries.iter().filter_map(|(j, a)| Some(value(a) * x.get(*j)?));
            terms.fold(value(&row.constant), |sum, term| sum + &term)
        };
        self.rows.iter().map(next).collect()
    }

    /// The map for these values of the parameters.
    pub fn at(&self, values: &[Rational]) -> Map {
        let value = |p: &Polynomial| {
            p.evaluate(|v| values.get(v as usize).cloned().unwrap_or_else(Rational::zero))
        };
        let row = |row: &Row| {
            let entries = row.entries.iter().map(|(j, a)| (*j, value(a)));
            (value(&row.constant), entries.filter(|(_, a)| !a.is_zero()).collect())
        };
        Map { rows: self.rows.iter().map(row).collect() }
    }

    /// The constant of a row and its coefficients by column, polynomials in the parameters.
    pub fn row(&self, row: usize) -> Option<(&Polynomial, &BTreeMap<usize, Polynomial>)> {
        self.rows.get(row).map(|r| (&r.constant, &r.entries))
    }

    /// The parameters that the next value of the form `sum of coefficients[j] * x_j` depends on,
    /// ascending, after terms have cancelled.
    pub fn parameters_in(&self, coefficients: &[Rational]) -> Vec<usize> {
        let mut sums: BTreeMap<Option<usize>, Polynomial> = BTreeMap::new();
        for (c, row) in coefficients.iter().zip(&self.rows).filter(|(c, _)| !c.is_zero()) {
            let entries = row.entries.iter().map(|(j, a)| (Some(*j), a));
            for (column, a) in entries.chain([(None, &row.constant)]) {
                let sum = sums.remove(&column).unwrap_or_default();
                sums.insert(column, sum + &(Polynomial::constant(c.clone()) * a));
            }
        }
        let mut found: Vec<usize> = sums
            .values()
            .flat_map(Polynomial::terms)
            .flat_map(|(m, _)| m.powers().map(|(v, _)| v as usize))
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Which agent's next state depends on which others, as (listener, speaker).
    pub(super) fn links(&self, agents: usize, per_agent: usize) -> Vec<(usize, usize)> {
        let pairs = self.rows.iter().enumerate().flat_map(|(r, row)| {
            row.entries.keys().map(move |j| (r / per_agent.max(1), j / per_agent.max(1)))
        });
        let mut links: Vec<_> = pairs.filter(|(i, j)| i != j && *i.max(j) < agents).collect();
        links.sort_unstable();
        links.dedup();
        links
    }

    /// The next value of each state variable, in words: variables and parameters by name.
    pub fn updates(&self, state: &[String], parameters: &[Parameter]) -> Vec<String> {
        let named = |v: usize| parameters.get(v).map_or("?", |p| p.name.as_str());
        self.rows
            .iter()
            .map(|row| {
                let constant = row.constant.terms().map(|(m, c)| (m, None, c));
                let entries = row.entries.iter().flat_map(|(j, a)| {
                    a.terms().map(move |(m, c)| (m, state.get(*j).map(String::as_str), c))
                });
                let terms = entries.chain(constant).map(|(m, variable, c)| {
                    let factors = m.powers().map(|(v, _)| named(v as usize)).chain(variable);
                    (c, factors.collect::<Vec<_>>())
                });
                super::expression::sum_text(terms)
            })
            .collect()
    }
}

fn row(next: &Polynomial, variables: usize, parameters: &[Parameter]) -> Result<Row> {
    let mut constant = Polynomial::default();
    let mut entries: BTreeMap<usize, Polynomial> = BTreeMap::new();
    for (monomial, c) in next.terms() {
        let mut column = None;
        let mut rest = Polynomial::constant(c.clone());
        for (v, power) in monomial.powers() {
            let v = v as usize;
            match v.checked_sub(variables) {
                None if power > 1 || column.is_some() => {
                    return Err(Error::input("a product of state variables: expected none"));
                }
                None => column = Some(v),
                Some(p) if power > 1 => {
                    let name = parameters.get(p).map_or("?", |p| p.name.as_str());
                    return Err(Error::input(format!(
                        "`{name}` to the power {power}: expected no higher power than the first"
                    )));
                }
                Some(p) => {
                    let p = u32::try_from(p).unwrap_or(u32::MAX);
                    rest = rest * &Polynomial::variable(p);
                }
            }
        }
        match column {
            None => constant = constant + &rest,
            Some(j) => {
                let sum = entries.remove(&j).unwrap_or_default();
                entries.insert(j, sum + &rest);
            }
        }
    }
    Ok(Row { constant, entries })
}
