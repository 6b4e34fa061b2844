//! The projection engine: N local machines beside the global protocol.
//!
//! The projection theorem (PROTOCOL section 1) says that local machines that exchange their positions
//! after every tick compute exactly the global `kth_step`. This engine runs both forms of the spec side
//! by side and reports the first difference; exchanging less often, or counting against another
//! quotient, shows why the theorem's conditions are needed.

mod own;

use cordon_spec::coverage::tick;
use cordon_spec::local::{LocalParams, SimState, TickRatio, exchange, fmu_tick, project};
use cordon_spec::{DroneMap, Params, Phase, State};

use self::own::Machines;
use crate::scenario::{Own, Scenario};
use crate::simulate;
use cordon_core::{Error, Rational, Result, progress};

/// How the local machines are run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setup {
    /// How many ticks to run.
    pub ticks: u64,
    /// Ticks from one exchange to the next, at least 1. The theorem holds for 1.
    pub exchange_every: u64,
    /// The quotient that the local machines count against; by default the global counter limit, for
    /// which the theorem holds.
    pub ratio: Option<TickRatio>,
}

/// The states of both forms after some tick.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// Ticks since the start.
    pub tick: u64,
    /// Positions of the local machines; for a protocol file all state variables.
    pub local: Vec<Rational>,
    /// Positions of the global protocol.
    pub global: Vec<Rational>,
}

impl Pair {
    /// The first drone whose two positions differ; for a protocol file the first state variable.
    pub fn difference(&self) -> Option<usize> {
        self.local.iter().zip(&self.global).position(|(a, b)| a != b)
    }
}

/// Runs both forms for the given number of ticks.
///
/// # Errors
/// The protocol is neither coverage nor a protocol file, or the machines never exchange.
pub fn run(scenario: &Scenario, setup: Setup) -> Result<Vec<Pair>> {
    if setup.exchange_every == 0 {
        return Err(Error::input("exchange-every: `0`: expected 1 or more ticks"));
    }
    if let Some(own) = scenario.own() {
        return Ok(run_own(scenario, own, setup));
    }
    let Some(params) = scenario.params() else {
        return Err(Error::input(format!(
            "protocol: `{}`: expected `coverage` or a protocol file, which have a local form",
            scenario.protocol.name()
        )));
    };
    let local_params = LocalParams {
        count: scenario.count(),
        ratio: setup.ratio.unwrap_or(TickRatio::whole(params.n)),
        protocol: params.clone(),
    };
    let mut global = scenario.initial();
    let mut local = machines(&params, &local_params, &global, scenario.phase);
    progress::expect(setup.ticks);
    let mut pairs = vec![pair(0, &local, &global)];
    for t in 1..=setup.ticks {
        global = tick(&params, global);
        local = local.lambda(|i| fmu_tick(&local_params, local[i].clone()));
        if t.is_multiple_of(setup.exchange_every) {
            local = exchange(&local);
        }
        pairs.push(pair(t, &local, &global));
        progress::advance(1);
    }
    Ok(pairs)
}

fn run_own(scenario: &Scenario, own: &Own, setup: Setup) -> Vec<Pair> {
    let ratio = setup.ratio.unwrap_or(TickRatio::whole(scenario.counter_limit()));
    let mut machines = Machines::new(scenario, own, ratio, setup.ticks);
    progress::expect(setup.ticks);
    let mut pairs = Vec::new();
    for (t, snapshot) in (0..=setup.ticks).zip(simulate::run(scenario)) {
        if t > 0 {
            machines.tick();
            if t.is_multiple_of(setup.exchange_every) {
                machines.exchange();
            }
            progress::advance(1);
        }
        let mut global = snapshot.state.drones;
        global.truncate(scenario.start.len());
        pairs.push(Pair { tick: t, local: machines.own(), global });
    }
    pairs
}

/// Machines that agree with the global start, with their counters set according to the phase.
fn machines(
    params: &Params<Rational>,
    local: &LocalParams<Rational>,
    global: &State<Vec<Rational>>,
    phase: Phase,
) -> Vec<SimState<Rational>> {
    let timesteps = match phase {
        Phase::First => local.ratio.counter_limit(),
        Phase::Last => 0,
    };
    let machine = |i| SimState { timesteps, ..project(params, global, i) };
    (0..local.count).map(machine).collect()
}

fn pair(tick: u64, local: &[SimState<Rational>], global: &State<Vec<Rational>>) -> Pair {
    Pair {
        tick,
        local: local.iter().map(|m| m.st.own.clone()).collect(),
        global: global.drones.clone(),
    }
}
