//! What is kept of a run: desired and actual positions at every grid point.

use super::collision::Event;
use cordon_core::Rational;

/// Desired and actual positions of a run at its grid points, and what happened.
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
    /// What the user should know besides: warnings of FMUs.
    pub notes: Vec<String>,
    /// Why the run ended before its time; what is here happened until then.
    pub broken_off: Option<String>,
}

/// What a run was made with, in words and exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    /// `coverage`, `consensus`, `formation` or a protocol file.
    pub protocol: String,
    /// Ends of the segment in m, for coverage.
    pub segment: Option<(Rational, Rational)>,
    /// Weight eps of the neighbours, dimensionless; `None` of a protocol file without one.
    pub weight: Option<Rational>,
    /// Ticks from update to update.
    pub period: u32,
    /// Communication step in s.
    pub tau: Rational,
    /// `euler` or `exact`.
    pub integrator: String,
    /// `jacobi` or `gauss-seidel`.
    pub master: String,
    /// In which order drones updated, where it was not all at once.
    pub order: Option<Vec<usize>>,
    /// Whether the arithmetic was that of the authors' recorded runs.
    pub recorded: bool,
    /// FMUs in the place of units.
    pub fmus: Vec<Flown>,
}

/// An FMU that flew in the place of a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flown {
    /// Name of the unit whose place it took: `plant2`.
    pub unit: String,
    /// Name of the FMU's file.
    pub fmu: String,
}

impl Setup {
    /// What moved the drones, in words: the plants, the master, and whatever is unusual.
    pub fn flown_with(&self) -> String {
        let mut text = format!("{} plant, {} master", self.integrator, self.master);
        if let Some(order) = &self.order {
            let first = order.iter().take(MOST_LISTED).map(usize::to_string);
            let first: Vec<_> = first.collect();
            let rest = if order.len() > MOST_LISTED { ", .." } else { "" };
            text.push_str(&format!(", updates in the order {}{rest}", first.join(", ")));
        }
        if self.recorded {
            text.push_str(", arithmetic of the recorded runs");
        }
        for (place, flown) in self.fmus.iter().enumerate() {
            match place {
                MOST_LISTED => {
                    text.push_str(&format!(", and {} more FMUs", self.fmus.len() - place));
                }
                p if p < MOST_LISTED => {
                    text.push_str(&format!(", {} is `{}`", flown.unit, flown.fmu));
                }
                _ => {}
            }
        }
        text
    }

    /// The weight in words, after a comma: `, eps = 1/5`.
    pub fn weighted(&self) -> String {
        self.weight.as_ref().map_or_else(String::new, |weight| format!(", eps = {weight}"))
    }

    /// How often drones update, in words.
    pub fn rhythm(&self) -> String {
        let period = match self.period {
            1 => "tick".to_owned(),
            ticks => format!("{ticks} ticks"),
        };
        format!("an update every {period} of {} s", self.tau)
    }
}

/// FMUs and drones that are listed in words.
const MOST_LISTED: usize = 6;

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
