//! The selection of rows from a run, and their computation one by one.

use num_traits::ToPrimitive;

use super::positions::Positions;
use crate::fast::growth::MAX_STEPPING;
use crate::fast::{Answer, Course, Line, Motion, course, engine, jump, leap, step};
use crate::scenario::{Protocol, Scenario, Topology};
use crate::simulate;
use cordon_core::{Error, Rational, Result, progress};

/// What the rows count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// Protocol steps: one row per update.
    Steps,
    /// Ticks: one row per co-simulation step.
    Ticks,
}

impl Counted {
    /// The name of what is counted, for column heads and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Steps => "step",
            Self::Ticks => "tick",
        }
    }

    /// Tick and protocol step of the row numbered `at` in this unit. A step's row is the state right
    /// after its update; one whose tick exceeds 64 bits counts as the start.
    pub fn tick_and_step(self, scenario: &Scenario, at: u64) -> (u64, u64) {
        match self {
            Self::Ticks => (at, scenario.steps_until(at)),
            Self::Steps => (scenario.tick_of_step(at).unwrap_or(0), at),
        }
    }
}

/// The rows `from`, `from + every`, ... up to `to`, in the given unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// Whether rows are counted in protocol steps or in ticks.
    pub unit: Counted,
    /// The first row, from 0.
    pub from: u64,
    /// The last row, at least the first.
    pub to: u64,
    /// Distance between rows, at least 1.
    pub every: u64,
}

impl Selection {
    /// The number of rows.
    pub fn len(self) -> u64 {
        self.to.checked_sub(self.from).map_or(0, |span| span / self.every.max(1) + 1)
    }

    /// Whether there is no row.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// The protocol steps of the rows, in order.
    pub fn steps(self, scenario: &Scenario) -> impl Iterator<Item = u64> + '_ {
        let rows = (0..self.len()).map(move |i| self.from + i * self.every);
        rows.map(move |at| self.unit.tick_and_step(scenario, at).1)
    }

    /// The last of the rows.
    pub fn last(self) -> u64 {
        self.to - (self.to - self.from) % self.every
    }
}

/// The state of the swarm after a step or tick.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Ticks since the start.
    pub tick: u64,
    /// Protocol steps so far.
    pub step: u64,
    /// Ticks since the last update.
    pub timesteps: u32,
    /// Position of every drone.
    pub positions: Positions,
}

/// Most rows of one trace: more is a typing error, and would fill the memory.
const MAX_ROWS: u64 = 10_000_000;

/// The selected rows of the scenario's run, each computed on demand.
///
/// # Errors
/// A selection without rows, with too many, or of a run too long to step through.
pub fn select(scenario: &Scenario, selection: Selection) -> Result<Rows<'_>> {
    let Selection { unit, from, to, every } = selection;
    if every == 0 {
        return Err(Error::input("every: `0`: expected 1 or more"));
    }
    if from > to {
        return Err(Error::input(format!("from: `{from}`: expected at most the last row, {to}")));
    }
    if unit == Counted::Steps && to > 0 && scenario.tick_of_step(to).is_none() {
        return Err(Error::input(format!(
            "steps: `{to}`: expected a step whose tick, {} times as late, fits 64 bits",
            scenario.period
        )));
    }
    refuse_endless(scenario, unit, to)?;
    if selection.len() > MAX_ROWS {
        return Err(Error::input(format!(
            "every: `{every}`: expected at most {MAX_ROWS} rows between {from} and {to}"
        )));
    }
    let source = Source::of(scenario, selection)?;
    progress::expect(selection.len());
    Ok(Rows { scenario, selection, next: Some(from), source })
}

/// The rows of a trace, in order.
pub struct Rows<'s> {
    scenario: &'s Scenario,
    selection: Selection,
    next: Option<u64>,
    source: Source,
}

impl Iterator for Rows<'_> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        let at = self.next.filter(|&at| at <= self.selection.to)?;
        self.next = at.checked_add(self.selection.every);
        let (tick, step) = self.selection.unit.tick_and_step(self.scenario, at);
        let timesteps = self.scenario.timesteps_at(tick);
        let positions = self.source.after(self.scenario, step);
        progress::advance(1);
        Some(Row { tick, step, timesteps, positions })
    }
}

/// The engine that computes the positions; steps are requested in increasing order.
enum Source {
    /// A line of drones, step by step.
    Step(Box<step::Run>),
    /// A line of drones, without the steps in between.
    Jump(Box<Line>),
    /// A protocol file, step by step.
    March(Box<course::Run>),
    /// A protocol file, without the steps in between.
    Leap(Box<Course>),
    /// Another protocol or graph: the spec on fractions.
    Spec { k: u64, drones: Vec<Rational> },
}

impl Source {
    fn of(scenario: &Scenario, selection: Selection) -> Result<Self> {
        let is_fast = match &scenario.protocol {
            Protocol::Coverage { .. } => true,
            Protocol::Consensus { graph } => matches!(graph, Topology::Path(_)),
            Protocol::Formation { .. } => false,
            Protocol::Own(_) => true,
        };
        if !is_fast {
            return Ok(Self::Spec { k: 0, drones: scenario.start.clone() });
        }
        let (_, last) = selection.unit.tick_and_step(scenario, selection.last());
        let motion = Motion::of(scenario, last)?;
        motion.refuse_beyond_memory(selection.unit.name(), last)?;
        let jumps = motion.jump_is_faster(last, selection.steps(scenario));
        Ok(match motion {
            Motion::Line(line) if jumps => Self::Jump(line.into()),
            Motion::Line(line) => Self::Step(step::Run::new(line, last).into()),
            Motion::Course(course) if jumps => Self::Leap(course),
            Motion::Course(course) => Self::March(course::Run::new(*course, last).into()),
        })
    }

    fn after(&mut self, scenario: &Scenario, wanted: u64) -> Positions {
        match self {
            Self::Step(run) => run.advance_to(wanted).answer().into(),
            Self::Jump(line) => jump::after(line, wanted, engine::multiplier()).into(),
            Self::March(run) => shown(scenario, run.advance_to(wanted).answer()),
            // Only courses that can be jumped over get here.
            Self::Leap(course) => leap::after(course, wanted, engine::multiplier())
                .map_or_else(|| Vec::new().into(), |answer| shown(scenario, answer)),
            Self::Spec { k, drones } => {
                while *k < wanted {
                    *k += 1;
                    *drones = simulate::step(scenario, *k, std::mem::take(drones));
                }
                drones.clone().into()
            }
        }
    }
}

/// The positions of an answer, without a protocol file's memory of the past.
pub fn shown(scenario: &Scenario, mut answer: Answer) -> Positions {
    answer.numerators.truncate(scenario.start.len());
    answer.into()
}

fn refuse_endless(scenario: &Scenario, unit: Counted, to: u64) -> Result<()> {
    let last = unit.tick_and_step(scenario, to).1;
    if scenario.own().is_some() {
        return refuse_endless_course(scenario, unit, to, last);
    }
    let steps = last as f64;
    let drones = scenario.count() as f64;
    let bits = scenario.weight.denom().to_f64().unwrap_or(f64::MAX).log2().max(1.0);
    if drones * steps * (steps * bits / 128.0 + 1.0) <= MAX_STEPPING {
        return Ok(());
    }
    let name = unit.name();
    Err(Error::input(format!(
        "{name}s: `{to}`: expected fewer: {} drones with weight {} make numbers of {:.0} bits by then",
        scenario.count(),
        scenario.weight,
        steps * bits
    )))
}

/// As [`refuse_endless`], for a protocol file.
fn refuse_endless_course(scenario: &Scenario, unit: Counted, to: u64, last: u64) -> Result<()> {
    let Some(own) = scenario.own() else { return Ok(()) };
    let start = scenario.whole_start();
    let field = format!("{}s", unit.name());
    match own.cycle() {
        Some(maps) => Course::in_turn(&maps, &start).refuse_endless(&field, to, last),
        None => Course::refuse_endless_draws(own, &start, &field, to, last),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::scenario::parse;

    fn scenario(rest: &str) -> Scenario {
        let text = format!("start = [0, 10, 20, 30, 100]\nweight = 0.2\n{rest}");
        parse("test", &text).unwrap().finish().unwrap()
    }

    /// Compared with the spec, tick by tick.
    #[test]
    fn rows_are_the_run() {
        let mut compared = 0;
        for rest in [
            "",
            "period = 3",
            "period = 4\nphase = \"last\"",
            "protocol = \"consensus\"\nperiod = 2",
            "protocol = \"consensus\"\ngraph = \"ring\"\nperiod = 2\nphase = \"last\"",
            "protocol = \"formation\"\ndisplacement = [1, 0, 2, 0, -1]",
        ] {
            let s = scenario(rest);
            let ticks: Vec<_> = simulate::run(&s).take(40).collect();
            for (from, every) in [(0, 1), (3, 7)] {
                let wanted = ticks.iter().skip(from).step_by(every);
                let selection = Selection {
                    unit: Counted::Ticks,
                    from: from as u64,
                    to: 39,
                    every: every as u64,
                };
                let rows: Vec<_> = select(&s, selection).unwrap().collect();
                assert_eq!(rows.len() as u64, selection.len());
                for (row, t) in rows.iter().zip(wanted) {
                    assert_eq!((row.tick, row.step), (t.tick, t.step), "{rest}");
                    assert_eq!(row.timesteps, t.state.timesteps, "{rest}, tick {}", t.tick);
                    assert_eq!(row.positions.lowest(), t.state.drones, "{rest}");
                    compared += 1;
                }
            }
            let selection = Selection { unit: Counted::Steps, from: 0, to: 9, every: 2 };
            for row in select(&s, selection).unwrap() {
                let of_step = ticks.iter().find(|t| t.step == row.step).unwrap();
                assert_eq!((row.tick, row.timesteps), (of_step.tick, of_step.state.timesteps));
                assert_eq!(row.positions.lowest(), of_step.state.drones);
                compared += 1;
            }
        }
        assert_eq!(compared, 6 * (40 + 6 + 5));
    }

    #[test]
    fn ticks_are_counted_without_walking_them() {
        let s = scenario("period = 4_000_000_000\nphase = \"last\"");
        let selection = Selection { unit: Counted::Steps, from: 1, to: 9, every: 4 };
        let ticks: Vec<_> = select(&s, selection).unwrap().map(|r| r.tick).collect();
        assert_eq!(ticks, [4_000_000_000, 20_000_000_000, 36_000_000_000]);
        let selection =
            Selection { unit: Counted::Ticks, from: 0, to: 9_000_000_001, every: 9_000_000_000 };
        let rows: Vec<_> = select(&s, selection).unwrap().collect();
        assert_eq!((rows[1].step, rows[1].timesteps), (2, 1_000_000_000));
        assert_eq!((rows[0].step, rows[0].timesteps), (0, 0));
        let beyond = Selection { unit: Counted::Steps, from: u64::MAX, to: u64::MAX, every: 1 };
        let said = select(&s, beyond).err().unwrap().to_string();
        assert!(said.contains("expected a step whose tick"), "{said}");
    }

    #[test]
    fn far_rows_are_jumped_to_and_near_ones_stepped_to() {
        let s = scenario("");
        let source = |from, to, every| {
            Source::of(&s, Selection { unit: Counted::Steps, from, to, every }).unwrap()
        };
        assert!(matches!(source(200_000, 200_000, 1), Source::Jump(_)));
        assert!(matches!(source(0, 200_000, 200_000), Source::Jump(_)));
        assert!(matches!(source(0, 200, 1), Source::Step(_)));
        assert!(matches!(source(0, 200_000, 1), Source::Step(_)));
    }
}
