//! Local machines of a protocol file: each knows its own variables and what it hears.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use cordon_spec::Phase;
use cordon_spec::local::TickRatio;

use crate::scenario::{Own, Scenario};
use cordon_core::Rational;
use cordon_core::system::Map;

/// The machine of one agent: only what the agent knows.
struct Machine {
    /// The indices of its own variables in the state.
    own: Range<usize>,
    /// What it knows, by index: its own variables, those it hears, and what it remembers of them.
    known: BTreeMap<usize, Rational>,
    timesteps: u32,
}

/// The machines of all agents.
pub(super) struct Machines<'s> {
    protocol: &'s Own,
    ratio: TickRatio,
    machines: Vec<Machine>,
    updates: u64,
}

impl<'s> Machines<'s> {
    /// The machines at the start, for a run of at most this many ticks.
    pub fn new(scenario: &Scenario, protocol: &'s Own, ratio: TickRatio, ticks: u64) -> Self {
        let start = scenario.whole_start();
        let per_agent = protocol.system.variables.len();
        let maps = protocol.cycle();
        let maps = maps.unwrap_or_else(|| (1..=ticks).map(|k| protocol.map(k)).collect());
        let timesteps = match scenario.phase {
            Phase::First => ratio.counter_limit(),
            Phase::Last => 0,
        };
        let machine = |i: usize| {
            let own = i * per_agent..(i + 1) * per_agent;
            let places = needed(&maps, own.clone(), protocol.columns().len());
            let known = places.into_iter().filter_map(|j| Some((j, start.get(j)?.clone())));
            Machine { own, known: known.collect(), timesteps }
        };
        let machines = (0..scenario.count()).map(machine).collect();
        Self { protocol, ratio, machines, updates: 0 }
    }

    /// One tick of every machine, independently.
    pub fn tick(&mut self) {
        let fires = self.machines.first().is_some_and(|m| self.ratio.reached_by(m.timesteps));
        self.updates += u64::from(fires);
        let map = fires.then(|| self.protocol.map(self.updates));
        let now = self.protocol.columns().len();
        for machine in &mut self.machines {
            match &map {
                Some(map) => machine.update(map, now),
                None => machine.timesteps += 1,
            }
        }
    }

    /// Every agent sends its own variables to those who hear them.
    pub fn exchange(&mut self) {
        let sent = self.own();
        for machine in &mut self.machines {
            let own = machine.own.clone();
            for (place, value) in machine.known.iter_mut().filter(|(j, _)| !own.contains(j)) {
                if let Some(sent) = sent.get(*place) {
                    value.clone_from(sent);
                }
            }
        }
    }

    /// The own variables of all machines, agent by agent.
    pub fn own(&self) -> Vec<Rational> {
        let own = |m: &Machine| -> Vec<Rational> {
            m.own.clone().filter_map(|j| m.known.get(&j).cloned()).collect()
        };
        self.machines.iter().flat_map(own).collect()
    }
}

impl Machine {
    /// One protocol step: the own variables are updated, memories age, what was heard stays.
    fn update(&mut self, map: &Map, now: usize) {
        let moves = |j: &usize| self.own.contains(j) || *j >= now;
        let next = |j: usize| {
            let (constant, row) = map.rows.get(j)?;
            row.iter().try_fold(constant.clone(), |sum, (c, a)| Some(sum + a * self.known.get(c)?))
        };
        let moved: Vec<(usize, Rational)> = (self.known.keys().copied())
            .filter(moves)
            .filter_map(|j| Some((j, next(j)?)))
            .collect();
        self.known.extend(moved);
        self.timesteps = 0;
    }
}

/// The indices read by the rows of an agent's own variables, including those read by its memory of
/// others.
fn needed(maps: &[Map], own: Range<usize>, now: usize) -> BTreeSet<usize> {
    let mut needed: BTreeSet<usize> = own.clone().collect();
    let mut open: Vec<usize> = own.collect();
    while let Some(place) = open.pop() {
        let rows = maps.iter().filter_map(|map| map.rows.get(place));
        for column in rows.flat_map(|(_, row)| row.iter().map(|(j, _)| *j)) {
            // Rules of others are not followed, only memories of them.
            if needed.insert(column) && column >= now {
                open.push(column);
            }
        }
    }
    needed
}
