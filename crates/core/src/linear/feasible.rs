//! Systems of linear inequalities: a point that satisfies them, or multipliers that prove that there is
//! none (Farkas' lemma with strict inequalities, also called Motzkin's).

use num_traits::{One, Signed, Zero};

use super::affine::Affine;
use crate::Rational;
use crate::simplex::{Solution, Term, Work, maximise};

/// The sign required of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// The form is above 0.
    Positive,
    /// The form is 0 or above.
    NonNegative,
    /// The form is 0.
    Zero,
}

impl Sign {
    /// Whether `value` has this sign.
    pub fn met_by(self, value: &Rational) -> bool {
        match self {
            Self::Positive => value.is_positive(),
            Self::NonNegative => !value.is_negative(),
            Self::Zero => value.is_zero(),
        }
    }
}

/// A linear inequality or equation, strict or not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constraint {
    /// The affine form that is compared with 0.
    pub form: Affine,
    /// The sign required of it.
    pub sign: Sign,
}

/// A point in `variables` dimensions that satisfies all constraints. `None` where there is none, or a
/// form is not affine.
pub fn point(variables: usize, constraints: &[Constraint]) -> Option<Vec<Rational>> {
    point_within(variables, constraints, &Work::limited(u64::MAX))
}

/// As [`point`]; also `None` where the work limit is exceeded.
pub fn point_within(
    variables: usize,
    constraints: &[Constraint],
    work: &Work,
) -> Option<Vec<Rational>> {
    // Columns: positive and negative part of every variable, the margin of the strict ones,
    // the slack of the margin's bound 1, the slacks of the inequalities.
    let (margin, slacks) = (2 * variables, 2 * variables + 2);
    let one = Rational::one();
    let mut rows: Vec<Vec<Term>> = Vec::new();
    let mut constants = Vec::new();
    for (i, c) in constraints.iter().enumerate() {
        let (constant, coefficients) = c.form.parts()?;
        if coefficients.len() > variables {
            return None;
        }
        let parts = |(j, a): (usize, &Rational)| [(j, a.clone()), (variables + j, -a)];
        let mut row: Vec<Term> = coefficients.iter().enumerate().flat_map(parts).collect();
        if c.sign != Sign::Zero {
            row.push((slacks + i, -one.clone()));
        }
        if c.sign == Sign::Positive {
            row.push((margin, -one.clone()));
        }
        rows.push(row);
        constants.push(-constant);
    }
    rows.push(vec![(margin, one.clone()), (margin + 1, one.clone())]);
    constants.push(one.clone());
    let equations: Vec<_> = rows.iter().map(Vec::as_slice).zip(&constants).collect();
    let width = slacks + constraints.len();
    let Some(Solution::Optimal(x)) = maximise(width, &[(margin, one)], &equations, work) else {
        return None;
    };
    let found: Vec<Rational> = (0..variables).map(|j| &x[j] - &x[variables + j]).collect();
    // The margin may be zero at the optimum: then the strict constraints cannot be met.
    let met = |c: &Constraint| c.form.at(&found).is_some_and(|v| c.sign.met_by(&v));
    constraints.iter().all(met).then_some(found)
}

/// Constraints from which others may follow.
#[derive(Clone, Debug)]
pub struct Premises<'g> {
    given: &'g [Constraint],
    /// The given equations: their multipliers may have either sign.
    equations: Vec<usize>,
    /// For each variable, and last for the constant: its coefficients in the premises, by the column of
    /// the multiplier.
    rows: Vec<Vec<Term>>,
}

impl<'g> Premises<'g> {
    /// The constraints `given`; `None` where a form is not affine.
    pub fn new(given: &'g [Constraint]) -> Option<Self> {
        let is_equation = |&i: &usize| given[i].sign == Sign::Zero;
        let equations: Vec<usize> = (0..given.len()).filter(is_equation).collect();
        let parts = given.iter().map(|c| c.form.parts()).collect::<Option<Vec<_>>>()?;
        let variables = parts.iter().map(|(_, c)| c.len()).max().unwrap_or(0);
        // Columns: one per constraint, the negative parts for the equations, the rest.
        let mut rows = vec![Vec::new(); variables + 1];
        for (i, (constant, coefficients)) in parts.into_iter().enumerate() {
            let negative = equations.binary_search(&i).ok().map(|index| given.len() + index);
            let entries = coefficients.iter().enumerate().chain([(variables, constant)]);
            for (j, a) in entries.filter(|(_, a)| !a.is_zero()) {
                rows[j].push((i, a.clone()));
                rows[j].extend(negative.map(|column| (column, -a)));
            }
        }
        rows[variables].push((given.len() + equations.len(), Rational::one()));
        Some(Self { given, equations, rows })
    }

    /// Multipliers m that show `goal` (`> 0` or `>= 0`) to follow from the premises (Farkas):
    /// `goal = sum of m_i given_i + rest`, with m_i >= 0 (of either sign for equations), a
    /// constant rest >= 0, and for a strict goal the rest > 0 or some m_i > 0 of a strict
    /// constraint. `None` where there are none; if the premises can be met at all, the goal then
    /// fails somewhere.
    pub fn multipliers(&self, goal: &Constraint) -> Option<Vec<Rational>> {
        self.multipliers_within(goal, &Work::limited(u64::MAX))
    }

    /// As [`multipliers`](Self::multipliers); also `None` where the work limit is exceeded.
    pub fn multipliers_within(&self, goal: &Constraint, work: &Work) -> Option<Vec<Rational>> {
        let (goal_constant, coefficients) = goal.form.parts()?;
        let (last, rows) = self.rows.split_last()?;
        if coefficients.len() > rows.len() {
            // A variable that no premise mentions.
            return None;
        }
        let (zero, one) = (Rational::zero(), Rational::one());
        let wanted = (0..rows.len()).map(|j| coefficients.get(j).unwrap_or(&zero));
        let mut equations: Vec<_> = rows.iter().map(Vec::as_slice).zip(wanted).collect();
        equations.push((last, goal_constant));
        let rest = self.given.len() + self.equations.len();
        let solution = if goal.sign == Sign::Positive {
            // What makes the goal strict is maximised, and capped at 1, so that there is an
            // optimum: total = reached + excess, reached + slack = 1.
            let strict = (0..self.given.len()).filter(|&i| self.given[i].sign == Sign::Positive);
            let [reached, excess, slack] = [rest + 1, rest + 2, rest + 3];
            let mut total: Vec<Term> = strict.chain([rest]).map(|i| (i, one.clone())).collect();
            total.extend([(reached, -one.clone()), (excess, -one.clone())]);
            let cap = [(reached, one.clone()), (slack, one.clone())];
            equations.extend([(total.as_slice(), &zero), (&cap, &one)]);
            match maximise(rest + 4, &[(reached, one.clone())], &equations, work)? {
                Solution::Optimal(x) if x[reached].is_positive() => x,
                _ => return None,
            }
        } else {
            match maximise(rest + 1, &[], &equations, work)? {
                Solution::Optimal(x) => x,
                _ => return None,
            }
        };
        let mut m: Vec<Rational> = solution.get(..self.given.len())?.to_vec();
        for (index, &i) in self.equations.iter().enumerate() {
            m[i] -= solution.get(self.given.len() + index)?;
        }
        Some(m)
    }
}
