//! The indeterminates of the proofs, and facts about them.

use cordon_spec::Scalar;

use cordon_core::Rational;
use cordon_core::scalar::Polynomial;

/// Indeterminates of which there is one each, by number: the names that certificates use.
const NAMES: [&str; 14] =
    ["eps", "min", "max", "last", "i", "x1", "x(N-2)", "c", "c'", "E", "E'", "M", "H", "j"];

/// Rows of positions start at these numbers; in the middle of each is offset 0.
const ROWS: [(&str, u32); 2] = [("x", 100), ("y", 200)];

/// Indeterminates that count or weigh; every other one is a length along the segment.
const WITHOUT_UNIT: [&str; 5] = ["eps", "last", "i", "H", "j"];

/// Half the length of a row.
const REACH: i32 = 50;

/// The number of a name.
fn number(name: &str) -> Option<u32> {
    NAMES.iter().position(|&n| n == name).and_then(|n| u32::try_from(n).ok())
}

/// The indeterminate of that name; names are the program's own.
pub fn named(name: &'static str) -> Polynomial {
    number(name).map_or_else(Polynomial::default, Polynomial::variable)
}

/// The number of the indeterminate `x[offset]` or `y[offset]`.
fn cell_number(row: &str, offset: i32) -> Option<u32> {
    let &(_, first) = ROWS.iter().find(|(name, _)| *name == row)?;
    u32::try_from(offset + REACH).ok().map(|o| first + o)
}

/// The position of drone i + offset, as it is (`x`) or as it is seen (`y`).
pub fn cell(row: &'static str, offset: i32) -> Polynomial {
    cell_number(row, offset).map_or_else(Polynomial::default, Polynomial::variable)
}

/// How certificates write an indeterminate.
pub fn name(v: u32) -> String {
    for (row, first) in ROWS {
        if (first..first + 100).contains(&v) {
            return format!("{row}[{}]", i64::from(v - first) - i64::from(REACH));
        }
    }
    NAMES.get(v as usize).map_or_else(|| format!("?{v}"), |n| (*n).to_owned())
}

/// Whether an indeterminate is a length along the segment.
pub fn is_length(v: u32) -> bool {
    !NAMES.get(v as usize).is_some_and(|n| WITHOUT_UNIT.contains(n))
}

/// The integer as a polynomial.
pub fn int(n: i32) -> Polynomial {
    Polynomial::from_int(n)
}

/// The polynomial with other polynomials in the place of some named indeterminates.
pub fn substitute(p: &Polynomial, values: &[(Polynomial, Polynomial)]) -> Polynomial {
    p.terms().fold(int(0), |sum, (monomial, c)| {
        let mut product = Polynomial::constant(c.clone());
        for (v, exponent) in monomial.powers() {
            let variable = Polynomial::variable(v);
            let value = values.iter().find(|(of, _)| *of == variable).map(|(_, value)| value);
            for _ in 0..exponent {
                product = product * value.unwrap_or(&variable);
            }
        }
        sum + &product
    })
}

/// What is known, or wanted, of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero.
    Zero,
}

/// A hypothesis by the name that certificates use.
#[derive(Clone, Debug)]
pub struct Fact {
    /// Its name.
    pub name: String,
    /// The polynomial.
    pub poly: Polynomial,
    /// What it is.
    pub sign: Sign,
}

/// The fact that `label` has a sign.
pub fn fact(label: impl AsRef<str>, poly: Polynomial, sign: Sign) -> Fact {
    let relation = match sign {
        Sign::Positive => "> 0",
        Sign::NonNegative => ">= 0",
        Sign::Zero => "= 0",
    };
    Fact { name: format!("{} {relation}", label.as_ref()), poly, sign }
}

/// Something to be proved from facts.
#[derive(Clone, Debug)]
pub struct Goal {
    /// Its name: the checker has the same.
    pub name: String,
    /// What is known.
    pub facts: Vec<Fact>,
    /// The polynomial.
    pub poly: Polynomial,
    /// What it is to be.
    pub sign: Sign,
}

/// Whether all lengths in the polynomial occur to one power, and to which: the unit of what it
/// measures. Only products of the goal's own unit can add up to it.
pub fn unit(p: &Polynomial) -> Option<u32> {
    let mut units = p.terms().map(|(monomial, _)| {
        monomial.powers().filter(|&(v, _)| is_length(v)).map(|(_, e)| e).sum::<u32>()
    });
    let first = units.next().unwrap_or(0);
    units.all(|u| u == first).then_some(first)
}

/// The constant.
pub fn constant(c: &Rational) -> Polynomial {
    Polynomial::constant(c.clone())
}
