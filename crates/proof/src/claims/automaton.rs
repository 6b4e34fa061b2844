//! When which mode acts, and which claims are about when: a finite graph of moments.

use cordon_core::system::{Schedule, System};

/// A step from a moment to a moment by a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Moment before.
    pub from: usize,
    /// The mode that acts.
    pub mode: usize,
    /// Moment after.
    pub to: usize,
}

/// Moments of a run and the steps between them. Moment 0 is the start; where claims are about certain
/// steps only, moments count steps up to the last step named, and after that they recur.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Automaton {
    /// The name of each moment.
    pub names: Vec<String>,
    /// The steps.
    pub edges: Vec<Edge>,
    /// Of each moment, the claims that are about it.
    pub claims: Vec<Vec<usize>>,
}

impl Automaton {
    /// The moments of a system's runs.
    pub fn of(system: &System) -> Self {
        let cycle = match &system.schedule {
            Schedule::Any => vec![(0..system.modes.len()).collect()],
            Schedule::Cycle(list) => list.iter().map(|&m| vec![m]).collect::<Vec<_>>(),
        };
        // Steps from which on the claims are the same in every step.
        let settled = |c: &cordon_core::system::Claim| c.until.map_or(c.from, |last| last + 1);
        let counted = system.claims.iter().map(settled).max().unwrap_or(0);
        let ends = !system.claims.is_empty() && system.claims.iter().all(|c| c.until.is_some());
        let length = cycle.len();
        let recurring = if ends { 0 } else { length };
        let count = counted + recurring;
        let next = |moment: usize| match moment + 1 {
            after if after < count => Some(after),
            // The recurring moments are those of steps counted, counted + 1, ...
            _ if recurring > 0 => Some(counted),
            _ => None,
        };
        let mut automaton = Self { names: Vec::new(), edges: Vec::new(), claims: Vec::new() };
        for moment in 0..count {
            automaton.names.push(match (moment < counted, length) {
                (true, _) => format!("step{moment}"),
                (false, 1) => "kept".to_owned(),
                (false, _) => format!("kept{}", moment - counted),
            });
            let about = system.claims.iter().enumerate().filter(|(_, c)| c.is_about(moment));
            automaton.claims.push(about.map(|(j, _)| j).collect());
            if let Some(to) = next(moment) {
                let modes = cycle.get(moment % length).into_iter().flatten();
                automaton.edges.extend(modes.map(|&mode| Edge { from: moment, mode, to }));
            }
        }
        automaton
    }

    /// The steps that end in a moment.
    pub fn into(&self, moment: usize) -> impl Iterator<Item = (usize, &Edge)> {
        self.edges.iter().enumerate().filter(move |(_, e)| e.to == moment)
    }
}
