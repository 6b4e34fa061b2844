//! The spec's machines behind a coordination unit.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::formation::exec_formation;
use cordon_spec::graph::Graph;
use cordon_spec::local::{LocalParams, LocalState, SimState, TickRatio, fmu_tick};
use cordon_spec::{Params, Phase, Scalar, State};

use super::own::OwnMachine;
use super::{Law, Settings};
use crate::quotient::Quotient;
use crate::unit::Value;

/// The state machine of one drone. A state is absent only while the spec computes the next one.
#[derive(Clone, Debug)]
pub(super) enum Machine {
    /// The paper's local machine (listing 6); no state before the first message.
    Local(Box<LocalParams<Quotient>>, Option<SimState<Quotient>>),
    /// Equations 6 and 8 from the point of view of one drone: the drone itself is number 0, followed by
    /// its neighbours, each linked with it alone.
    Star(Box<Star>, Option<State<Vec<Quotient>>>),
    /// A protocol file's rule.
    Own(Box<OwnMachine>),
}

#[derive(Clone, Debug)]
pub(super) struct Star {
    weight: Quotient,
    counter_limit: u32,
    /// For formation: the displacements, 0 for every agent except the drone itself.
    displacements: Option<Vec<Quotient>>,
}

/// Drone 0 linked with every other one.
struct Hub {
    count: usize,
}

impl Graph for Hub {
    fn count(&self) -> usize {
        self.count
    }

    fn linked(&self, i: usize, j: usize) -> bool {
        i != j && (i == 0 || j == 0) && i.max(j) < self.count
    }
}

impl Machine {
    pub(super) fn new(settings: &Settings) -> Self {
        let own = Quotient::from(&settings.start);
        let weight = Quotient::from(&settings.weight);
        // A period of 0 has been refused before.
        let counter_limit = settings.period.saturating_sub(1);
        let star = |neighbours: usize, displacement: Option<Quotient>| {
            let drones = vec![own.clone(); neighbours + 1];
            let displacements = displacement.map(|b| {
                let others = std::iter::repeat_n(Quotient::from_int(0), neighbours);
                std::iter::once(b).chain(others).collect()
            });
            let star = Star { weight: weight.clone(), counter_limit, displacements };
            Self::Star(Box::new(star), Some(State::initial(drones, counter_limit, settings.phase)))
        };
        match &settings.law {
            Law::Coverage { id, count, min, max } => {
                let params = LocalParams {
                    protocol: Params {
                        min: Quotient::from(min),
                        max: Quotient::from(max),
                        eps: weight,
                        n: counter_limit,
                    },
                    count: *count,
                    ratio: TickRatio::whole(counter_limit),
                };
                let timesteps = match settings.phase {
                    Phase::First => counter_limit,
                    Phase::Last => 0,
                };
                let st = LocalState { prec: own.clone(), own: own.clone(), foll: own, id: *id };
                Self::Local(Box::new(params), Some(SimState { timesteps, st }))
            }
            Law::Consensus { neighbours } => star(neighbours.len(), None),
            Law::Formation { neighbours, displacement } => {
                star(neighbours.len(), Some(Quotient::from(displacement)))
            }
            Law::Own(law) => {
                let machine = OwnMachine::new(law, own, counter_limit, settings.phase);
                Self::Own(Box::new(machine))
            }
        }
    }

    /// Whether the next tick is an update, in which the neighbours' positions are read.
    pub(super) fn fires(&self) -> bool {
        match self {
            Self::Local(params, _) => params.ratio.reached_by(self.counter()),
            Self::Star(star, _) => self.counter() == star.counter_limit,
            Self::Own(own) => own.fires(),
        }
    }

    /// Whether an update reads an input.
    pub(super) fn looks_at(&self, input: usize) -> bool {
        match self {
            Self::Own(own) => own.looks_at(input),
            Self::Local(..) | Self::Star(..) => true,
        }
    }

    /// One tick. `heard` has the neighbours' positions in order, or is empty where the tick is not an
    /// update.
    pub(super) fn tick(&mut self, heard: Vec<Quotient>) {
        match self {
            Self::Local(params, s) => {
                *s = s.take().map(|mut s| {
                    if let [prec, foll] = heard.as_slice() {
                        (s.st.prec, s.st.foll) = (prec.clone(), foll.clone());
                    }
                    fmu_tick(params, s)
                });
            }
            Self::Star(star, s) => {
                *s = s.take().map(|mut s| {
                    for (known, x) in s.drones.iter_mut().skip(1).zip(heard) {
                        *known = x;
                    }
                    let hub = Hub { count: s.drones.len() };
                    s.tick_with(star.counter_limit, |x| match &star.displacements {
                        None => exec_consensus(&star.weight, &hub, x),
                        Some(b) => exec_formation(&star.weight, &hub, x, b),
                    })
                });
            }
            Self::Own(own) => own.tick(&heard),
        }
    }

    /// The desired position; `None` before the first message.
    pub(super) fn position(&self) -> Option<&Quotient> {
        match self {
            Self::Local(_, s) => s.as_ref().map(|s| &s.st.own),
            Self::Star(_, s) => s.as_ref().and_then(|s| s.drones.first()),
            Self::Own(own) => own.position(),
        }
    }

    /// For a protocol file's machine, the value of a variable other than the position.
    pub(super) fn beside(&self, variable: usize) -> Option<&Quotient> {
        match self {
            Self::Own(own) => own.state.get(variable),
            Self::Local(..) | Self::Star(..) => None,
        }
    }

    /// The memory of the machine besides position and counter.
    pub(super) fn besides(&self) -> Vec<Value> {
        match self {
            Self::Own(own) => own.memory(),
            Self::Local(..) | Self::Star(..) => Vec::new(),
        }
    }

    /// Restores that memory; returns whether it fits.
    pub(super) fn recall_besides(&mut self, memory: &[Value]) -> bool {
        match self {
            Self::Own(own) => own.recall(memory),
            Self::Local(..) | Self::Star(..) => memory.is_empty(),
        }
    }

    /// Restores the position before the last update: the update is skipped.
    pub(super) fn put_back(&mut self, own: Quotient) {
        match self {
            Self::Local(_, s) => {
                if let Some(s) = s {
                    s.st.own = own;
                }
            }
            Self::Star(_, s) => {
                if let Some(first) = s.as_mut().and_then(|s| s.drones.first_mut()) {
                    *first = own;
                }
            }
            Self::Own(machine) => machine.put_back(own),
        }
    }

    /// Ticks since the last update.
    pub(super) fn counter(&self) -> u32 {
        match self {
            Self::Local(_, s) => s.as_ref().map_or(0, |s| s.timesteps),
            Self::Star(_, s) => s.as_ref().map_or(0, |s| s.timesteps),
            Self::Own(own) => own.counter,
        }
    }

    /// Resumes with the drone at `own` and the counter at `counter`.
    pub(super) fn resume(&mut self, own: Quotient, counter: u32) {
        self.put_back(own);
        match self {
            Self::Local(_, Some(s)) => s.timesteps = counter,
            Self::Star(_, Some(s)) => s.timesteps = counter,
            Self::Local(_, None) | Self::Star(_, None) => {}
            Self::Own(own) => own.counter = counter,
        }
    }
}
