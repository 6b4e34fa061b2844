//! What is kept of a run: desired and actual positions at every grid point.

use super::collision::Event;
use cordon_core::Rational;

/// A recorded run.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// What was run, for people.
    pub title: String,
    /// Number of drones.
    pub count: usize,
    /// Grid points in seconds, ascending.
    pub times: Vec<f64>,
    /// Desired positions in m: `count` numbers a grid point.
    pub desired: Vec<f64>,
    /// Actual positions in m: `count` numbers a grid point.
    pub actual: Vec<f64>,
    /// Collisions and violations of the order, by time, where they were looked for.
    pub events: Option<Vec<Event>>,
    /// What the run was made with, where it is known.
    pub setup: Option<Setup>,
}

/// What a run was made with, in words and exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    /// `coverage`, `consensus` or `formation`.
    pub protocol: String,
    /// Ends of the segment in m, for coverage.
    pub segment: Option<(Rational, Rational)>,
    /// Weight eps.
    pub weight: Rational,
    /// Ticks from update to update.
    pub period: u32,
    /// Communication step in s.
    pub tau: Rational,
    /// `euler` or `exact`.
    pub integrator: String,
    /// `jacobi` or `gauss-seidel`.
    pub master: String,
}

impl Record {
    /// Desired positions at a grid point.
    pub fn desired_at(&self, row: usize) -> &[f64] {
        slice(&self.desired, self.count, row)
    }

    /// Actual positions at a grid point.
    pub fn actual_at(&self, row: usize) -> &[f64] {
        slice(&self.actual, self.count, row)
    }

    /// The number of grid points.
    pub fn rows(&self) -> usize {
        self.times.len()
    }
}

fn slice(numbers: &[f64], count: usize, row: usize) -> &[f64] {
    let from = row.saturating_mul(count);
    numbers.get(from..from.saturating_add(count)).unwrap_or_default()
}
