//! Linear programs over the rationals, solved exactly.
//!
//! Two-phase primal simplex with Bland's rule, which ends on every input. Fraction-free: the rows
//! of the tableau are sparse vectors of integers, known up to a positive factor, which changes
//! neither a sign nor a ratio. The integers are machine words as long as they fit one.

mod int;
mod row;

use std::cell::Cell;
use std::cmp::Ordering;

use num_traits::Zero;

use crate::Rational;
use int::Int;
use row::Row;

/// How a linear program ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Solution {
    /// A point that attains the largest value.
    Optimal(Vec<Rational>),
    /// No point meets the constraints.
    Infeasible,
    /// The objective has no upper bound.
    Unbounded,
}

/// A budget of work that does not depend on the machine. The unit is an entry of the tableau that a
/// pivot rewrites; an entry of more than 64 bits counts once per word.
#[derive(Debug)]
pub struct Work(Cell<u64>);

impl Work {
    /// A budget of this many units.
    pub fn limited(units: u64) -> Self {
        Self(Cell::new(units))
    }

    /// The units that are left.
    pub fn left(&self) -> u64 {
        self.0.get()
    }

    /// Spends units of work. Where fewer are left, spends these and returns false.
    fn spend(&self, units: u64) -> bool {
        let left = self.left().checked_sub(units);
        self.0.set(left.unwrap_or(0));
        left.is_some()
    }
}

/// A coefficient and the variable that it belongs to.
pub type Term = (usize, Rational);

/// Maximises `objective . x` over all `x >= 0`, `count` variables, with equations: each the sum of its
/// terms, in any order, no variable twice, and its constant. `None` where the work limit is exceeded.
///
/// An inequality is an equation with a slack variable. Of several optimal points, the one that Bland's
/// rule reaches is returned: variables named first are preferred.
pub fn maximise(
    count: usize,
    objective: &[Term],
    equations: &[(&[Term], &Rational)],
    work: &Work,
) -> Option<Solution> {
    let row = |&(terms, constant): &(&[Term], &Rational)| {
        Row::integral(entries(terms).chain([(count, constant)]))
    };
    let numbers = equations.iter().map(|(terms, _)| terms.len() + 1).sum();
    if !work.spend(Row::work_of_reading(numbers)) {
        return None;
    }
    let rows = equations.iter().map(row).collect();
    solved(count, Row::integral(entries(objective)), rows, work)
}

fn entries(terms: &[Term]) -> impl Iterator<Item = (usize, &Rational)> {
    terms.iter().map(|(j, x)| (*j, x))
}

/// The program with this objective and these equations, the constants in column `count`.
fn solved(count: usize, objective: Row, rows: Vec<Row>, work: &Work) -> Option<Solution> {
    let mut tableau = Tableau::new(count, rows);
    let cost = tableau.phase_one_cost();
    // The sum of the artificial variables is bounded below by 0.
    tableau.descend(cost, work)?;
    if !tableau.drop_artificial(work)? {
        return Some(Solution::Infeasible);
    }
    let cost = tableau.reduced(objective);
    let bounded = tableau.descend(cost, work)?;
    Some(if bounded { Solution::Optimal(tableau.point()) } else { Solution::Unbounded })
}

/// The rows hold the coefficients in the variables' columns and the constant in column `count`.
struct Tableau {
    /// Number of variables proper.
    count: usize,
    rows: Vec<Row>,
    /// The basic variable of each row; from `count` on, an artificial one, whose column is
    /// not stored because it never enters again.
    basis: Vec<usize>,
}

impl Tableau {
    fn new(count: usize, mut rows: Vec<Row>) -> Self {
        for row in rows.iter_mut().filter(|row| row.at(count).is_negative()) {
            row.negate();
        }
        let basis = (0..rows.len()).map(|i| count + i).collect();
        Self { count, rows, basis }
    }

    /// The cost row of "minimise the sum of the artificial variables".
    fn phase_one_cost(&self) -> Row {
        let mut cost = Row::default();
        for row in &self.rows {
            cost.combine(&Int::Small(1), row, &Int::Small(1));
        }
        cost
    }

    /// The cost row of "minimise `-objective . x`", basic variables eliminated.
    fn reduced(&self, objective: Row) -> Row {
        let mut cost = objective;
        cost.negate();
        for (row, &basic) in self.rows.iter().zip(&self.basis) {
            cost.eliminate(row, basic);
        }
        cost
    }

    /// Pivots until no column lowers the cost; false if the cost has no lower bound, `None` if the work
    /// limit is exceeded.
    fn descend(&mut self, mut cost: Row, work: &Work) -> Option<bool> {
        while let Some(entering) = cost.first_negative(self.count) {
            let Some(leaving) = self.leaving(entering) else {
                return Some(false);
            };
            self.pivot(leaving, entering, work)?;
            cost.eliminate(&self.rows[leaving], entering);
        }
        Some(true)
    }

    /// The row that limits the entering variable first; the smallest basic variable in a tie.
    fn leaving(&self, entering: usize) -> Option<usize> {
        let mut best: Option<(usize, &Int, &Int)> = None;
        for (i, row) in self.rows.iter().enumerate() {
            let pivot = row.at(entering);
            if !pivot.is_positive() {
                continue;
            }
            let constant = row.at(self.count);
            let better = best.is_none_or(|(b, other_constant, other_pivot)| {
                match Int::compare_products(constant, other_pivot, other_constant, pivot) {
                    Ordering::Less => true,
                    Ordering::Equal => self.basis[i] < self.basis[b],
                    Ordering::Greater => false,
                }
            });
            if better {
                best = Some((i, constant, pivot));
            }
        }
        best.map(|(i, ..)| i)
    }

    fn pivot(&mut self, leaving: usize, entering: usize, work: &Work) -> Option<()> {
        let pivot_row = std::mem::take(&mut self.rows[leaving]);
        let mut written = 0;
        for row in &mut self.rows {
            if row.eliminate(&pivot_row, entering) {
                written += row.work();
            }
        }
        self.rows[leaving] = pivot_row;
        self.basis[leaving] = entering;
        // Scanning the rows is work too.
        work.spend(written + self.rows.len() as u64).then_some(())
    }

    /// After phase one: false if an artificial variable is not zero; otherwise makes every basic
    /// variable a proper one and drops redundant rows.
    fn drop_artificial(&mut self, work: &Work) -> Option<bool> {
        let mut i = 0;
        while i < self.rows.len() {
            if self.basis[i] < self.count {
                i += 1;
                continue;
            }
            if !self.rows[i].at(self.count).is_zero() {
                return Some(false);
            }
            let entry = self.rows[i].entries().next().map(|(j, x)| (j, x.is_negative()));
            match entry {
                Some((entering, negative)) => {
                    if negative {
                        // The constant is 0: the row may be negated.
                        self.rows[i].negate();
                    }
                    self.pivot(i, entering, work)?;
                    i += 1;
                }
                None => {
                    self.rows.swap_remove(i);
                    self.basis.swap_remove(i);
                }
            }
        }
        Some(true)
    }

    fn point(&self) -> Vec<Rational> {
        let mut x = vec![Rational::zero(); self.count];
        for (row, &basic) in self.rows.iter().zip(&self.basis) {
            x[basic] = Rational::new(row.at(self.count).to_big(), row.at(basic).to_big());
        }
        x
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]

    use num_traits::Signed;

    use super::*;

    fn q(n: i64, d: i64) -> Rational {
        Rational::new(n.into(), d.into())
    }

    fn row(v: &[i64]) -> Vec<Rational> {
        v.iter().map(|&n| q(n, 1)).collect()
    }

    /// The solution, of rows with a coefficient for each variable; missing ones at the end are 0.
    fn maximised(
        objective: &[Rational],
        equations: &[Vec<Rational>],
        constants: &[Rational],
    ) -> Solution {
        let terms = |row: &[Rational]| row.iter().cloned().enumerate().collect::<Vec<Term>>();
        let rows: Vec<Vec<Term>> = equations.iter().map(|row| terms(row)).collect();
        let equations: Vec<_> = rows.iter().map(Vec::as_slice).zip(constants).collect();
        let work = Work::limited(1_000_000);
        maximise(objective.len(), &terms(objective), &equations, &work).unwrap()
    }

    #[test]
    fn a_textbook_program_has_its_known_optimum() {
        // max 3x + 5y, x <= 4, 2y <= 12, 3x + 2y <= 18: 36 at (2, 6).
        let a = [row(&[1, 0, 1, 0, 0]), row(&[0, 2, 0, 1, 0]), row(&[3, 2, 0, 0, 1])];
        let solution = maximised(&row(&[3, 5, 0, 0, 0]), &a, &row(&[4, 12, 18]));
        assert_eq!(solution, Solution::Optimal(row(&[2, 6, 2, 0, 0])));
    }

    #[test]
    fn infeasible_and_unbounded_are_told_apart() {
        assert_eq!(maximised(&row(&[1]), &[row(&[1])], &row(&[-1])), Solution::Infeasible);
        assert_eq!(maximised(&row(&[1, 0]), &[row(&[1, -1])], &row(&[0])), Solution::Unbounded);
        assert_eq!(maximised(&row(&[1]), &[], &[]), Solution::Unbounded);
        assert_eq!(maximised(&row(&[-1]), &[], &[]), Solution::Optimal(row(&[0])));
    }

    #[test]
    fn redundant_and_contradicting_equations() {
        let twice = [row(&[1, 1]), row(&[2, 2])];
        let Solution::Optimal(x) = maximised(&row(&[0, 1]), &twice, &row(&[3, 6])) else {
            panic!("feasible")
        };
        assert_eq!(x, row(&[0, 3]));
        assert_eq!(maximised(&row(&[0, 1]), &twice, &row(&[3, 7])), Solution::Infeasible);
    }

    #[test]
    fn bland_does_not_cycle_on_beales_example() {
        let a = [
            vec![q(1, 4), q(-60, 1), q(-1, 25), q(9, 1), q(1, 1)],
            vec![q(1, 2), q(-90, 1), q(-1, 50), q(3, 1), q(0, 1), q(1, 1)],
            row(&[0, 0, 1, 0, 0, 0, 1]),
        ];
        let c = [q(3, 4), q(-150, 1), q(1, 50), q(-6, 1), q(0, 1), q(0, 1), q(0, 1)];
        let Solution::Optimal(x) = maximised(&c, &a, &row(&[0, 0, 1])) else { panic!("bounded") };
        let value: Rational = c.iter().zip(&x).map(|(c, x)| c * x).sum();
        assert_eq!(value, q(1, 20));
    }

    #[test]
    fn every_answer_meets_its_constraints() {
        // Small programs with entries from a fixed generator; an optimum must be feasible and
        // not below any of the grid points that are.
        let mut state: u64 = 20_240_601;
        let mut next = |range: i64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            i64::try_from(state >> 33).unwrap() % (2 * range + 1) - range
        };
        let (mut optimal, mut infeasible, mut unbounded) = (0, 0, 0);
        for _ in 0..300 {
            let a: Vec<Vec<i64>> = (0..2).map(|_| (0..4).map(|_| next(3)).collect()).collect();
            let (b, c): (Vec<_>, Vec<_>) =
                ((0..2).map(|_| next(4)).collect(), (0..4).map(|_| next(3)).collect());
            let rows: Vec<_> = a.iter().map(|r| row(r)).collect();
            let grid = (0..6i64.pow(4)).map(|n| [n % 6, n / 6 % 6, n / 36 % 6, n / 216]);
            let dot = |r: &[i64], x: &[i64; 4]| r.iter().zip(x).map(|(a, x)| a * x).sum::<i64>();
            let mut points = grid.filter(|x| (0..2).all(|i| dot(&a[i], x) == b[i]));
            match maximised(&row(&c), &rows, &row(&b)) {
                Solution::Optimal(x) => {
                    optimal += 1;
                    assert!(x.iter().all(|x| !x.is_negative()));
                    for (r, b) in rows.iter().zip(&b) {
                        let left: Rational = r.iter().zip(&x).map(|(a, x)| a * x).sum();
                        assert_eq!(left, q(*b, 1));
                    }
                    let value: Rational = row(&c).iter().zip(&x).map(|(c, x)| c * x).sum();
                    assert!(points.all(|p| q(dot(&c, &p), 1) <= value));
                }
                Solution::Infeasible => {
                    infeasible += 1;
                    assert_eq!(points.next(), None);
                }
                Solution::Unbounded => unbounded += 1,
            }
        }
        assert!(
            optimal > 20 && infeasible > 20 && unbounded > 20,
            "{optimal} {infeasible} {unbounded}"
        );
    }
}
