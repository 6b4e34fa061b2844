//! Systems of linear inequalities: a point that meets them, or multipliers that show that none
//! does (Farkas' lemma with strict inequalities, also called Motzkin's).

use num_traits::{One, Signed, Zero};

use super::affine::Affine;
use crate::Rational;
use crate::simplex::{Solution, feasible, maximise};

/// What is demanded of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// form > 0
    Positive,
    /// form >= 0
    NonNegative,
    /// form = 0
    Zero,
}

impl Sign {
    /// Whether `value` meets it.
    pub fn met_by(self, value: &Rational) -> bool {
        match self {
            Self::Positive => value.is_positive(),
            Self::NonNegative => !value.is_negative(),
            Self::Zero => value.is_zero(),
        }
    }
}

/// One demand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constraint {
    /// The form.
    pub form: Affine,
    /// What is demanded of it.
    pub sign: Sign,
}

/// A point in `variables` dimensions that meets all constraints. `None` where there is none,
/// or a form is not affine.
pub fn point(variables: usize, constraints: &[Constraint]) -> Option<Vec<Rational>> {
    // Columns: positive and negative part of every variable, the margin of the strict ones,
    // the slack of the margin's bound 1, the slacks of the inequalities.
    let (margin, slacks) = (2 * variables, 2 * variables + 2);
    let width = slacks + constraints.len();
    let mut rows = Vec::new();
    let mut constants = Vec::new();
    for (i, c) in constraints.iter().enumerate() {
        let (constant, coefficients) = c.form.parts()?;
        let mut row = vec![Rational::zero(); width];
        for (j, a) in coefficients.iter().enumerate() {
            *row.get_mut(j)? = a.clone();
            *row.get_mut(variables + j)? = -a;
        }
        if c.sign != Sign::Zero {
            row[slacks + i] = -Rational::one();
        }
        if c.sign == Sign::Positive {
            row[margin] = -Rational::one();
        }
        rows.push(row);
        constants.push(-constant);
    }
    let mut bound = vec![Rational::zero(); margin];
    bound.extend([Rational::one(), Rational::one()]);
    rows.push(bound);
    constants.push(Rational::one());
    let mut objective = vec![Rational::zero(); width];
    objective[margin] = Rational::one();
    let Solution::Optimal(x) = maximise(&objective, &rows, &constants) else {
        return None;
    };
    let found: Vec<Rational> = (0..variables).map(|j| &x[j] - &x[variables + j]).collect();
    // The margin may be zero at the optimum: then the strict constraints cannot be met.
    let met = |c: &Constraint| c.form.at(&found).is_some_and(|v| c.sign.met_by(&v));
    constraints.iter().all(met).then_some(found)
}

/// Multipliers m that show `goal` (`> 0` or `>= 0`) to follow from `given`:
/// `goal = sum of m_i given_i + rest`, with m_i >= 0 (of either sign for equations), a constant
/// rest >= 0, and for a strict goal the rest > 0 or some m_i > 0 of a strict constraint.
/// `None` where there are none; if `given` can be met at all, the goal then fails somewhere.
pub fn multipliers(given: &[Constraint], goal: &Constraint) -> Option<Vec<Rational>> {
    let (goal_constant, goal_coefficients) = goal.form.parts()?;
    let mut variables = goal_coefficients.len();
    for c in given {
        variables = variables.max(c.form.parts()?.1.len());
    }
    // Columns: one a constraint, the negative parts for the equations, the rest.
    let equations: Vec<usize> = (0..given.len()).filter(|&i| given[i].sign == Sign::Zero).collect();
    let rest = given.len() + equations.len();
    let mut rows = vec![vec![Rational::zero(); rest + 1]; variables + 1];
    for (i, c) in given.iter().enumerate() {
        let (constant, coefficients) = c.form.parts()?;
        let entries = coefficients.iter().enumerate().chain([(variables, constant)]);
        for (j, a) in entries {
            rows[j][i] = a.clone();
            if let Ok(place) = equations.binary_search(&i) {
                rows[j][given.len() + place] = -a;
            }
        }
    }
    rows[variables][rest] = Rational::one();
    let mut constants: Vec<Rational> = goal_coefficients.to_vec();
    constants.resize(variables, Rational::zero());
    constants.push(goal_constant.clone());
    let solution = if goal.sign == Sign::Positive {
        let strict = |i: usize| given.get(i).is_some_and(|c| c.sign == Sign::Positive) || i == rest;
        let objective: Vec<Rational> = (0..=rest)
            .map(|i| if strict(i) { Rational::one() } else { Rational::zero() })
            .collect();
        strictly(&objective, rows, constants)?
    } else {
        feasible(rest + 1, &rows, &constants)?
    };
    let mut m: Vec<Rational> = solution.get(..given.len())?.to_vec();
    for (place, &i) in equations.iter().enumerate() {
        m[i] -= solution.get(given.len() + place)?;
    }
    Some(m)
}

/// A solution with `objective . x > 0`.
fn strictly(
    objective: &[Rational],
    mut rows: Vec<Vec<Rational>>,
    mut constants: Vec<Rational>,
) -> Option<Vec<Rational>> {
    // Capped at 1, so that there is an optimum.
    let width = objective.len();
    for row in &mut rows {
        row.resize(width + 3, Rational::zero());
    }
    let one = Rational::one();
    // objective . x = reached + excess, reached + slack = 1.
    let mut total = objective.to_vec();
    total.extend([-one.clone(), -one.clone(), Rational::zero()]);
    let mut cap = vec![Rational::zero(); width];
    cap.extend([one.clone(), Rational::zero(), one.clone()]);
    rows.extend([total, cap]);
    constants.extend([Rational::zero(), one.clone()]);
    let mut wanted = vec![Rational::zero(); width + 3];
    wanted[width] = one;
    match maximise(&wanted, &rows, &constants) {
        Solution::Optimal(x) if x[width].is_positive() => Some(x),
        _ => None,
    }
}
