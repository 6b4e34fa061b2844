//! Combinations and forms as text, and what is reckoned with them.

use num_traits::{One, Zero};

use super::Names;
use crate::certificate::linear::form;
use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::linear::matrix::Matrix;
use cordon_core::system::expression::{add_term, or_zero};

/// Adds a number times factors to a sum.
pub(super) fn add(sum: &mut String, c: &Rational, factors: impl IntoIterator<Item = String>) {
    add_term(sum, c, &refs(&factors.into_iter().collect::<Vec<_>>()));
}

/// Borrowed, as clauses take them.
pub(super) fn refs(names: &[String]) -> Vec<&str> {
    names.iter().map(String::as_str).collect()
}

/// A combination, by the places of its variables.
pub(super) type Terms = Vec<(usize, Rational)>;

/// The entries that are not 0, with their places.
pub(super) fn sparse(row: &[Rational]) -> Vec<(usize, Rational)> {
    row.iter().cloned().enumerate().filter(|(_, c)| !c.is_zero()).collect()
}

pub(super) fn linear(entries: &[(usize, Rational)], names: &[String]) -> String {
    form(&Rational::zero(), entries.iter().map(|(j, c)| (names[*j].as_str(), c)))
}

/// z'mz, row by row.
pub(super) fn quadratic(m: &Matrix, names: &[String]) -> String {
    let two = Rational::from_integer(2.into());
    let mut text = String::new();
    for (i, row) in m.iter().enumerate() {
        let entries = row.iter().enumerate().skip(i).filter(|(_, c)| !c.is_zero());
        let entries: Vec<(usize, Rational)> =
            entries.map(|(j, c)| (j, if i == j { c.clone() } else { c * &two })).collect();
        match entries.as_slice() {
            [] => {}
            [(j, c)] => add_term(&mut text, c, &[&names[i], &names[*j]]),
            _ => add_term(
                &mut text,
                &Rational::one(),
                &[&names[i], &format!("({})", linear(&entries, names))],
            ),
        }
    }
    or_zero(text)
}

pub(super) fn matrix_times(c: &Rational, m: &Matrix) -> Matrix {
    m.iter().map(|row| row.iter().map(|x| c * x).collect()).collect()
}

pub(super) fn difference(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect()).collect()
}

/// A number, not below 0, times a factor.
pub(super) fn fraction_times(c: &Rational, factor: &str) -> String {
    if c.is_one() { factor.to_owned() } else { format!("{}*{factor}", fraction(c)) }
}

/// Variables of a clause, reals.
pub(super) fn reals(names: &[&Names]) -> String {
    names.iter().flat_map(|n| n.iter()).map(|n| format!("{n}:real")).collect::<Vec<_>>().join(" ")
}
