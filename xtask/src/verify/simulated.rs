//! The shipped scenarios, simulated and checked step by step.

use std::time::Instant;

use cordon_spec::theorems::{Form, Theorem};

use super::{Evidence, Status, Tier, TierVerdict, this_program};
use cordon_core::Result;
use cordon_run::scenario::Scenario;
use cordon_run::{scenario, trace};

/// Random exact runs of the spec.
#[derive(Clone, Copy, Debug)]
pub struct Simulated;

/// Shipped coverage scenarios, and one that starts at the targets: no other run here meets the premises
/// about drones at their targets.
const SCENARIOS: [(&str, &str); 4] = [
    ("paper", include_str!("../../../scenarios/paper.toml")),
    ("recorded", include_str!("../../../scenarios/recorded.toml")),
    ("three", include_str!("../../../scenarios/three.toml")),
    ("at the targets", "start = [0, 25, 50, 75, 100]\nweight = \"1/2\"\nsteps = 20\n"),
];

impl Tier for Simulated {
    fn name(&self) -> &'static str {
        "simulated"
    }

    fn kind(&self) -> Evidence {
        Evidence::Sampled
    }

    fn tool(&self) -> String {
        this_program()
    }

    fn sources(&self) -> &'static [&'static str] {
        &[
            "spec/src",
            "scenarios",
            "crates/scenario/src/scenario",
            "crates/run/src/simulate.rs",
            "crates/run/src/trace",
        ]
    }

    fn status(&self, theorem: Theorem) -> Status {
        let started = Instant::now();
        let mut seen = Seen::default();
        let verdict =
            match SCENARIOS.iter().try_for_each(|&(name, text)| seen.look(name, text, theorem)) {
                Err(e) => TierVerdict::Inconclusive(e.to_string()),
                Ok(()) => match (seen.violation, seen.met) {
                    (Some(violation), _) => TierVerdict::Refuted(violation),
                    (None, 0) => TierVerdict::Inconclusive("no scenario meets its premise".into()),
                    (None, _) => TierVerdict::Holds,
                },
            };
        let scope = format!(
            "scenarios {}: {} steps, {} that meet its premise",
            seen.scenarios.join(", "),
            seen.steps,
            seen.met
        );
        Status::Run { verdict, scope, seconds: started.elapsed().as_secs_f64() }
    }
}

#[derive(Default)]
struct Seen {
    scenarios: Vec<&'static str>,
    steps: usize,
    met: usize,
    violation: Option<String>,
}

impl Seen {
    fn look(&mut self, name: &'static str, text: &str, theorem: Theorem) -> Result<()> {
        let scenario: Scenario = scenario::parse(name, text)?.finish()?;
        let Some(setting) = scenario.setting() else {
            return Ok(());
        };
        if !theorem.hypothesis(Form::Sharp).met_by(&setting, &scenario.start).is_true() {
            return Ok(());
        }
        for checked in trace::check(&scenario, &[theorem], Form::Sharp, scenario.steps)? {
            self.steps += checked.verdicts.len();
            self.met += checked.met();
            if let Some((step, what)) = &checked.first_violation {
                self.violation.get_or_insert(format!("scenario {name}, step {step}: {what}"));
            }
        }
        self.scenarios.push(name);
        Ok(())
    }
}
