//! One scenario as a PVS theory, with positions for PVSio to replay.

use std::fmt::Write as _;

use cordon_spec::coverage::kth_step;
use cordon_spec::{Params, State};
use num_traits::Signed;

use cordon_core::Rational;

/// What of a scenario the export needs: the coverage protocol with numbers in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instance {
    /// What the scenario is about, for people.
    pub title: String,
    /// Segment, weight and counter limit.
    pub params: Params<Rational>,
    /// The initial state, three drones or more.
    pub initial: State<Vec<Rational>>,
}

/// How many updates the replayed positions span.
const UPDATES: u64 = 5;

impl Instance {
    /// The ticks whose positions the theory states: the start, and the first [`UPDATES`]
    /// updates, one period apart.
    fn ticks(&self) -> Vec<u64> {
        let period = u64::from(self.params.n) + 1;
        (0..=UPDATES).map(|u| u * period).collect()
    }

    pub(super) fn theory(&self) -> String {
        let Params { min, max, eps, n } = &self.params;
        let drones = self.initial.drones.len();
        let actuals = format!("{drones}, {n}, {}, {}, {}", real(min), real(max), real(eps));
        let mut text = String::new();
        let title: String = self.title.chars().filter(|c| !c.is_control()).collect();
        let lines = [
            format!("% Scenario: {title}."),
            "%".to_owned(),
            "% In PVSio: `positions(4);` for the positions after 4 ticks, `replays;` for TRUE if PVS".to_owned(),
            "% computes the positions that cordon-spec computed.".to_owned(),
            "coverage_scenario: THEORY".to_owned(),
            "BEGIN".to_owned(),
            String::new(),
            format!("  IMPORTING coverage_table[{actuals}]"),
            format!("  IMPORTING coverage_theorems[{actuals}]"),
            format!("  IMPORTING projection[{actuals}]"),
            String::new(),
            "  start(i: drone_id): real =".to_owned(),
        ];
        for line in lines {
            text.push_str(&line);
            text.push('\n');
        }
        text.push_str(&self.start());
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "
  initial: systemState =
    (# drones := LAMBDA (i: drone_id): (# self := (# x := start(i) #), id := i #),
       timesteps := {} #)

  % The positions after k ticks, at a cost linear in k.
  positions(k: nat): list[real] = kth_table(tabulated(initial), k)`row

  replays: bool =
",
            self.initial.timesteps
        );
        let rows: Vec<_> = self.ticks().iter().map(|&k| self.row(k)).collect();
        text.push_str(&rows.join(" AND\n"));
        text.push_str("\n\n  replay: CONJECTURE replays\n\nEND coverage_scenario\n");
        text
    }

    fn start(&self) -> String {
        let mut text = String::from("    ");
        let last = self.initial.drones.len() - 1;
        for (i, x) in self.initial.drones.iter().enumerate() {
            let _ = if i < last {
                writeln!(text, "IF i = {i} THEN {}", real(x)).and_then(|()| write!(text, "    ELS"))
            } else {
                // The last position ends the chain `IF .. ELSIF .. ELSE`.
                writeln!(text, "E {}\n    ENDIF", real(x))
            };
        }
        text
    }

    fn row(&self, tick: u64) -> String {
        let state = kth_step(&self.params, self.initial.clone(), tick);
        let row: Vec<_> = state.drones.iter().map(real).collect();
        format!("    positions({tick}) = (: {} :)", row.join(", "))
    }
}

/// A rational as a PVS expression.
fn real(x: &Rational) -> String {
    let magnitude = x.abs().to_string();
    if x.is_negative() { format!("-({magnitude})") } else { magnitude }
}
