//! Between which decimals the positions of a trace lie, before its rows are computed.

use super::Selection;
use crate::scenario::{Protocol, Scenario};
use crate::swarm::Swarm;
use cordon_core::{Rational, exact};

/// The characters of the longest decimal of every drone in the selected rows, with so many
/// places; from a run in doubles with a rigorous bound. `None` where those leave it open, and
/// for other protocols than coverage.
pub fn decimal_widths(
    scenario: &Scenario,
    selection: Selection,
    digits: usize,
) -> Option<Vec<usize>> {
    let Protocol::Coverage { .. } = scenario.protocol else { return None };
    let mut swarm = Swarm::new(&scenario.weight, &scenario.start).ok()?;
    let mut extremes = vec![(f64::INFINITY, f64::NEG_INFINITY); scenario.count()];
    for step in selection.steps(scenario) {
        swarm.advance(step - swarm.steps());
        for ((least, largest), &x) in extremes.iter_mut().zip(swarm.positions()) {
            (*least, *largest) = (least.min(x), largest.max(x));
        }
    }
    // The bound never shrinks.
    let error = Rational::from_float(swarm.error())?;
    let width = |x: f64| {
        let x = Rational::from_float(x)?;
        let [below, above] = [&x - &error, &x + &error].map(|x| exact::decimal_string(&x, digits));
        // A decimal grows with its distance from 0, on either side.
        let one_side = below.starts_with('-') == above.starts_with('-');
        (one_side && below.len() == above.len()).then_some(below.len())
    };
    extremes.into_iter().map(|(least, largest)| Some(width(least)?.max(width(largest)?))).collect()
}
