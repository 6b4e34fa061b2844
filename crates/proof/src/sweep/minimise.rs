//! The simplest counterexample of a sweep, and the command that replays it.

use super::range::degree;
use cordon_spec::theorems::{Form, Theorem};

use super::config::{Item, form_of, theorem_of};
use super::exhaust::{Tally, engine};
use super::finding::Finding;
use super::grid::Grid;
use super::run::starts;
use cordon_core::{Rational, Result, exact};

/// A counterexample that cannot be made simpler within the sweep: fewest drones, then least k,
/// then the weight with the least denominator (then numerator), then the shortest segment, then
/// the first start in lexicographic order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Minimal {
    /// The refuted theorem.
    pub theorem: Theorem,
    /// Its form.
    pub form: Form,
    /// Number of drones N.
    pub drones: usize,
    /// The weight.
    pub eps: Rational,
    /// The step k whose conclusion fails.
    pub step: usize,
    /// Integer positions X^0, the segment from the first to the last.
    pub start: Vec<String>,
    /// What fails.
    pub violation: String,
}

/// Most drone updates that are spent on shorter segments; a counterexample stays as it was
/// found where these are not enough. Squares are slower.
const MOST_UPDATES: u64 = 100_000_000;
const MOST_UPDATES_OF_SQUARES: u64 = 5_000_000;

impl Minimal {
    /// The simplest among the counterexamples of these findings, all of one theorem and form.
    ///
    /// # Errors
    /// A finding that names no theorem, form or weight.
    pub fn of<'f>(findings: impl IntoIterator<Item = &'f Finding>) -> Result<Option<Self>> {
        let mut best: Option<Self> = None;
        for finding in findings {
            let Some(found) = &finding.counterexample else { continue };
            let candidate = Self {
                theorem: theorem_of(&finding.theorem)?,
                form: form_of(&finding.form)?,
                drones: finding.drones,
                eps: exact::parse("eps", &finding.eps)?,
                step: found.step,
                start: found.start.clone(),
                violation: found.violation.clone(),
            };
            if best.as_ref().is_none_or(|b| candidate.order() < b.order()) {
                best = Some(candidate);
            }
        }
        Ok(best.map(Self::shortened))
    }

    fn order(&self) -> impl Ord + '_ {
        (self.drones, self.step, self.eps.denom(), self.eps.numer())
    }

    /// The first start on the shortest segment that fails no later.
    fn shortened(self) -> Self {
        let item = Item {
            number: 0,
            theorem: self.theorem,
            form: self.form,
            drones: self.drones,
            eps: self.eps.clone(),
        };
        let Some(longest) = self.start.last().and_then(|x| x.parse::<i64>().ok()) else {
            return self;
        };
        let most = match degree(self.theorem) {
            1 => MOST_UPDATES,
            _ => MOST_UPDATES_OF_SQUARES,
        };
        let mut left = most;
        for length in 1..=longest {
            let Some(grid) = Grid::of_length(starts(&item), item.drones, length) else { break };
            let engine = engine(&item, self.step, length);
            let mut tally = Tally::default();
            grid.for_each(&grid.whole(), |start| {
                engine.start(start, false, &mut tally);
                tally.counts.updates < left
            });
            left = left.saturating_sub(tally.counts.updates.max(1));
            if let Some(found) = tally.counterexample() {
                return Self {
                    step: found.step,
                    start: found.start,
                    violation: found.violation,
                    ..self
                };
            }
            if left == 0 {
                break;
            }
        }
        self
    }

    /// The command that shows it.
    pub fn replay(&self) -> String {
        format!(
            "cordon trace --drones {} --start {} --eps {} --steps {} --check {} --form {}",
            self.drones,
            self.start.join(","),
            self.eps,
            self.step,
            self.theorem.number(),
            self.form.label()
        )
    }
}
