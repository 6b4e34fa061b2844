//! The widths of the decimals of a trace, before its rows are computed.

use super::Selection;
use crate::scenario::{Protocol, Scenario};
use crate::swarm::Swarm;
use cordon_core::{Rational, exact};

/// The length of the longest decimal of every drone in the selected rows, with this many places; from a
/// run in doubles with a rigorous bound. `None` where the bound is not tight enough, and for protocols
/// other than coverage.
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
        // A decimal gets longer with its distance from 0, on either side.
        let one_side = below.starts_with('-') == above.starts_with('-');
        (one_side && below.len() == above.len()).then_some(below.len())
    };
    let last = scenario.count() - 1;
    let drone = |(i, (least, largest))| match scenario.start.get(i) {
        // The end drones do not move.
        Some(x) if i == 0 || i == last => Some(exact::decimal_string(x, digits).len()),
        _ => Some(width(least)?.max(width(largest)?)),
    };
    extremes.into_iter().enumerate().map(drone).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::select;
    use super::*;
    use crate::scenario::parse;

    fn scenario(start: &str, rest: &str) -> Scenario {
        parse("test", &format!("start = [{start}]\n{rest}")).unwrap().finish().unwrap()
    }

    #[test]
    fn widths_are_those_of_the_rows() {
        let mut known = 0;
        for (start, rest) in [
            ("0, 10, 20, 30, 100", "weight = 0.2\nperiod = 4\ntau = 0.05"),
            ("0, 10, 20, 30, 100", "weight = 0.6"),
            ("-500, 3, 9.9997, 10", "weight = 0.5"),
            ("0, 99.99996, 100.00004, 101", "weight = 0.01"),
            ("0, 0.000004, 1", "weight = 0"),
        ] {
            let s = scenario(start, rest);
            for (from, every) in [(0, 1), (7, 5)] {
                for unit in [super::super::Counted::Steps, super::super::Counted::Ticks] {
                    let selection = Selection { unit, from, to: 60, every };
                    let mut widths = vec![0; s.count()];
                    for row in select(&s, selection).unwrap() {
                        for (width, x) in widths.iter_mut().zip(row.positions.decimals(4)) {
                            *width = x.len().max(*width);
                        }
                    }
                    assert_eq!(decimal_widths(&s, selection, 4), Some(widths), "{start} {rest}");
                    known += 1;
                }
            }
        }
        assert_eq!(known, 20);
    }

    #[test]
    fn a_position_between_two_lengths_is_left_open() {
        let selection = Selection { unit: super::super::Counted::Steps, from: 0, to: 3, every: 1 };
        // A tie rounded to even, and a decimal that is not a double.
        for start in ["0, 9.99995, 20", "0, -0.00005, 20"] {
            let s = scenario(start, "weight = 0");
            assert_eq!(decimal_widths(&s, selection, 4), None, "{start}");
        }
        let other = scenario("0, 1, 2", "weight = 0.1\nprotocol = \"consensus\"");
        assert_eq!(decimal_widths(&other, selection, 4), None);
    }
}
