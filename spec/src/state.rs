//! Parameters and state of the swarm (Listing 3 and the paper's theory `initial`).

#[cfg(feature = "contracts")]
use crate::model::*;

/// What stays the same during a run.
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct Params<S> {
    /// Left end of the segment: the place of drone 0, in the unit of the positions.
    pub min: S,
    /// Right end of the segment: the place of drone N-1.
    pub max: S,
    /// Weight of the neighbours in the update, dimensionless. The paper has it in \[0, 1\];
    /// the protocol is defined for any value.
    pub eps: S,
    /// Largest value of the tick counter: an update every `n + 1` ticks (PROTOCOL section 1;
    /// the paper's text says every n, its Listing 4 every n + 1).
    pub n: u32,
}

/// What changes from tick to tick: the paper's `systemState`.
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct State<M> {
    /// Position of every drone, in the order of their identifiers.
    pub drones: M,
    /// Ticks since the last update, in `0 ..= n` (the paper's type `upto(n)`).
    pub timesteps: u32,
}

/// Where the tick counter starts, hence in which tick the first update falls.
#[derive(Clone, Copy, Default)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub enum Phase {
    /// Counter starts at `n`: first update in the first tick (the authors' recorded runs).
    #[default]
    First,
    /// Counter starts at 0: first update in tick `n + 1` (Listing 4 as printed).
    Last,
}

impl<M> State<M> {
    /// The initial state: `drones` in place, the counter as `phase` wants it.
    #[cfg_attr(feature = "contracts", ensures(result.timesteps == match phase { Phase::First => n, Phase::Last => 0u32 }))]
    #[cfg_attr(feature = "contracts", ensures(result.drones == drones))]
    pub fn initial(drones: M, n: u32, phase: Phase) -> Self {
        let timesteps = match phase {
            Phase::First => n,
            Phase::Last => 0,
        };
        Self { drones, timesteps }
    }

    /// One tick of any protocol: `protocol` moves the drones when the counter has reached `n`,
    /// otherwise only the counter moves (Listing 4, `tick`, with the protocol left open as in
    /// Listing 2).
    #[cfg_attr(feature = "contracts", requires(self.timesteps@ <= n@ && protocol.precondition((&self.drones,))))]
    #[cfg_attr(feature = "contracts", ensures(result.timesteps@ <= n@))]
    #[cfg_attr(feature = "contracts", ensures(self.timesteps == n ==> result.timesteps@ == 0 && protocol.postcondition_once((&self.drones,), result.drones)))]
    #[cfg_attr(feature = "contracts", ensures(self.timesteps@ < n@ ==> result.timesteps@ == self.timesteps@ + 1 && result.drones == self.drones))]
    pub fn tick_with(self, n: u32, protocol: impl FnOnce(&M) -> M) -> Self {
        if self.timesteps == n {
            Self { drones: protocol(&self.drones), timesteps: 0 }
        } else {
            // Never saturates: below n there is room for one more. Total all the same.
            Self { timesteps: self.timesteps.saturating_add(1), ..self }
        }
    }
}
