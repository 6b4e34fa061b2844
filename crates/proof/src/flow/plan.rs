//! Which ellipsoids are wanted, and from which to which a mode leads.

use cordon_core::Rational;
use cordon_core::system::{Flow, Schedule, Switching};

/// From an ellipsoid to one while a mode acts, for a time or for ever.
pub(super) struct Way {
    pub(super) from: usize,
    pub(super) mode: usize,
    pub(super) to: usize,
    pub(super) time: Option<Rational>,
}

/// The ellipsoids wanted, and the ways between them.
pub(super) struct Plan {
    pub(super) names: Vec<String>,
    pub(super) start: Vec<usize>,
    pub(super) ways: Vec<Way>,
}

impl Plan {
    /// The nodes and edges of a way of switching; `parts` ellipsoids follow each other while a mode acts for a time.
    pub(super) fn of(flow: &Flow, parts: usize) -> Self {
        let modes = &flow.system.modes;
        let name = |mode: usize| modes.get(mode).map_or("", |m| m.name.as_str());
        let mut plan = Self { names: Vec::new(), start: vec![0], ways: Vec::new() };
        let part = |time: &Rational| time / Rational::from_integer(parts.into());
        match &flow.switching {
            Switching::Any => {
                plan.names.push("kept".to_owned());
                plan.ways.extend((0..modes.len()).map(|mode| Way {
                    from: 0,
                    mode,
                    to: 0,
                    time: None,
                }));
            }
            Switching::Every(time) => {
                let cycle = match &flow.system.schedule {
                    Schedule::Cycle(list) => list.clone(),
                    Schedule::Any => (0..modes.len()).collect(),
                };
                let count = cycle.len() * parts;
                for (turn, mode) in cycle.iter().enumerate() {
                    for k in 0..parts {
                        let from = plan.names.len();
                        plan.names.push(format!("{}.{}", name(*mode), turn * parts + k));
                        let to = (from + 1) % count;
                        plan.ways.push(Way { from, mode: *mode, to, time: Some(part(time)) });
                    }
                }
            }
            Switching::Dwell(time) => {
                plan.names.extend((0..modes.len()).map(|m| name(m).to_owned()));
                plan.start = (0..modes.len()).collect();
                plan.ways.extend((0..modes.len()).map(|mode| Way {
                    from: mode,
                    mode,
                    to: mode,
                    time: None,
                }));
                for before in 0..modes.len() {
                    for mode in (0..modes.len()).filter(|m| *m != before) {
                        let mut from = before;
                        for k in 1..=parts {
                            let to = if k == parts { mode } else { plan.names.len() };
                            if k < parts {
                                plan.names.push(format!(
                                    "{}.after.{}.{k}",
                                    name(mode),
                                    name(before)
                                ));
                            }
                            plan.ways.push(Way { from, mode, to, time: Some(part(time)) });
                            from = to;
                        }
                    }
                }
            }
        }
        plan
    }
}
