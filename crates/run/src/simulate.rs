//! The simulation engine: the spec, executed tick by tick on exact rationals.

use cordon_spec::State;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::formation::exec_formation;

use crate::scenario::{Protocol, Scenario};
use cordon_core::Rational;

/// The state of the swarm after some ticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Snapshot {
    /// Ticks since the start.
    pub tick: u64,
    /// Protocol steps so far.
    pub step: u64,
    /// Placement (for a protocol file the whole state) and tick counter.
    pub state: State<Vec<Rational>>,
}

/// The run of a scenario: the initial state, then the state after every tick, without end.
#[derive(Clone, Debug)]
pub struct Run<'s> {
    scenario: &'s Scenario,
    next: Option<Snapshot>,
}

/// Starts the run of a scenario.
pub fn run(scenario: &Scenario) -> Run<'_> {
    Run { scenario, next: Some(Snapshot { tick: 0, step: 0, state: scenario.initial() }) }
}

impl Iterator for Run<'_> {
    type Item = Snapshot;

    fn next(&mut self) -> Option<Snapshot> {
        let now = self.next.take()?;
        let fires = now.state.timesteps == self.scenario.counter_limit();
        self.next = Some(Snapshot {
            tick: now.tick.checked_add(1)?,
            step: now.step + u64::from(fires),
            state: now.state.clone().tick_with(self.scenario.counter_limit(), |x| {
                step(self.scenario, now.step + 1, x.clone())
            }),
        });
        Some(now)
    }
}

/// Protocol step `k >= 1` of the scenario, on the [whole](Scenario::whole_start) state.
pub fn step(scenario: &Scenario, k: u64, x: Vec<Rational>) -> Vec<Rational> {
    let eps = &scenario.weight;
    match &scenario.protocol {
        Protocol::Coverage { min, max } => {
            let p = scenario.coverage_params(min, max);
            exec_coverage(&p, &State { drones: x, timesteps: 0 }).drones
        }
        Protocol::Consensus { graph } => exec_consensus(eps, graph, &x),
        Protocol::Formation { graph, displacement } => exec_formation(eps, graph, &x, displacement),
        Protocol::Own(own) => own.map(k).apply(&x),
    }
}
