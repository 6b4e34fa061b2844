//! Counterexamples: by step, the smallest first, then by the simplicity of the constants.

use super::automaton::Automaton;
use super::search::{Answer, Choice, End, Limits, Proof, Search};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::linear::simplest::fractions_within;
use cordon_core::system::{Parameter, ParameterKind, System};

/// A run from an assumed start in which a claim fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The values of the parameters; those that vary as they are in the first step.
    pub values: Vec<Rational>,
    /// What was chosen, step by step.
    pub choices: Vec<Choice>,
    /// The step at which the claim fails, the last of the run.
    pub step: usize,
    /// The claim, by its place among the claims.
    pub claim: usize,
    /// The states.
    pub states: Vec<Vec<Rational>>,
}

/// Most combinations of constants that are searched.
pub const MOST_COMBINATIONS: usize = 2_000;

/// Most work in a search for a counterexample, at all constants together.
pub const WORK: u64 = 300_000_000;

/// The values of the constants that are searched: of each range both ends, and the fractions between
/// with denominators up to `denominators`; combined, the simplest first. Parameters that vary stand at
/// their least. `None` where there are more than [`MOST_COMBINATIONS`].
pub fn constants(system: &System, denominators: u32) -> Option<Vec<Vec<Rational>>> {
    let mut all: Vec<Vec<Rational>> = vec![Vec::new()];
    let most = Rational::from_integer(MOST_COMBINATIONS.into());
    for p in &system.parameters {
        let values = match (p.kind, p.fixed()) {
            (_, Some(value)) => vec![value.clone()],
            (ParameterKind::Constant, None) => {
                // Of a wide range the whole numbers alone are too many to list.
                if denominators > 0 && &p.high - &p.low > most {
                    return None;
                }
                let mut values = fractions_within(&p.low, &p.high, denominators);
                for end in p.ends() {
                    if !values.contains(&end) {
                        values.push(end);
                    }
                }
                values
            }
            (ParameterKind::Varying | ParameterKind::Choice, None) => vec![p.low.clone()],
        };
        if all.len().saturating_mul(values.len()) > MOST_COMBINATIONS {
            return None;
        }
        all = values
            .iter()
            .flat_map(|v| all.iter().map(move |a| a.iter().cloned().chain([v.clone()]).collect()))
            .collect();
    }
    Some(all)
}

/// As [`constants`], with the greatest denominators up to `denominators` of which they are not too many; where
/// the ends alone are, all constants at their least and all at their greatest.
pub fn constants_up_to(system: &System, denominators: u32) -> Vec<Vec<Rational>> {
    let highest = |p: &Parameter| match p.kind {
        ParameterKind::Constant => p.high.clone(),
        ParameterKind::Varying | ParameterKind::Choice => p.low.clone(),
    };
    let ends = || vec![system.values(|p| p.low.clone()), system.values(highest)];
    (0..=denominators).rev().find_map(|q| constants(system, q)).unwrap_or_else(ends)
}

/// The first counterexample up to step `steps`, among those with these values of the constants; `start`
/// restricts it to one start. The second part says up to which step there is none at any of them, from any
/// start: exactly `steps` where the search was complete.
pub fn refute(
    system: &System,
    constants: &[Vec<Rational>],
    start: Option<&[Rational]>,
    steps: usize,
) -> (Option<Run>, usize) {
    refute_with(system, constants, start, steps, &mut WORK.clone())
}

/// As [`refute`], with as much `work` as there is; what is left of it stays.
pub fn refute_with(
    system: &System,
    constants: &[Vec<Rational>],
    start: Option<&[Rational]>,
    steps: usize,
    left: &mut u64,
) -> (Option<Run>, usize) {
    let automaton = Automaton::of(system);
    let starts = match start {
        Some(x) => x.iter().enumerate().map(|(j, x)| equal(j, x)).collect(),
        None => system.start_constraints(),
    };
    let mut best: Option<Run> = None;
    let mut complete = steps;
    for (values, others) in constants.iter().zip((1..=constants.len() as u64).rev()) {
        let deepest = match &best {
            Some(run) => match run.step.checked_sub(1) {
                Some(before) => before,
                None => break,
            },
            None => steps,
        };
        // What the simple ones leave, the others may use.
        let mut work = *left / others;
        *left -= work;
        match sought(system, &automaton, values, starts.clone(), deepest, &mut work) {
            Sought::Fails(run) if best.as_ref().is_none_or(|b| run.step < b.step) => {
                best = Some(run);
            }
            Sought::Fails(_) | Sought::Never(_) => {}
            Sought::NotUpTo(depth, _) => {
                complete = complete.min(depth.max(if depth >= deepest { steps } else { 0 }))
            }
        }
        *left += work;
    }
    (best, complete)
}

/// What a search found at some values of the constants.
#[derive(Clone, Debug)]
pub enum Sought {
    /// A run in which a claim fails.
    Fails(Run),
    /// No claim ever fails.
    Never(Proof),
    /// None fails up to that step; the rest is open, by what ended the search.
    NotUpTo(usize, End),
}

/// Searches up to step `steps` at these values of the constants, with as much `work` as there is; what is
/// left of it stays.
pub fn sought(
    system: &System,
    automaton: &Automaton,
    values: &[Rational],
    starts: Vec<Constraint>,
    steps: usize,
    work: &mut u64,
) -> Sought {
    let limits = Limits { steps, half_spaces: 1_000, work: *work };
    let parameters = super::at(system, values);
    let mut search = Search::new(system, automaton, parameters, starts, &limits);
    let answer = search.run();
    *work = search.left();
    match answer {
        Answer::Refuted(start, choices) => match follow(system, values, &start, choices) {
            Some(run) => Sought::Fails(run),
            None => Sought::NotUpTo(0, End::Steps),
        },
        Answer::Proved(proof) => Sought::Never(proof),
        Answer::Open(depth, end) => Sought::NotUpTo(depth, end),
    }
}

fn equal(j: usize, x: &Rational) -> Constraint {
    Constraint { form: Affine::variable(j) - &Affine::constant(x.clone()), sign: Sign::Zero }
}

/// The run from a state with these choices, up to the first step at which a claim fails. `None` where
/// none does.
pub fn follow(
    system: &System,
    values: &[Rational],
    start: &[Rational],
    choices: Vec<Choice>,
) -> Option<Run> {
    let mut states = vec![start.to_vec()];
    for choice in &choices {
        let map = system.modes.get(choice.mode)?.at(&choice.values);
        states.push(map.apply(states.last()?));
    }
    let fails = |(step, x): (usize, &Vec<Rational>)| {
        let about = |c: &cordon_core::system::Claim| c.is_about(step) && !c.predicate.holds(x);
        system.claims.iter().position(about).map(|claim| (step, claim))
    };
    let (step, claim) = states.iter().enumerate().find_map(fails)?;
    states.truncate(step + 1);
    let choices = choices.into_iter().take(step).collect();
    Some(Run { values: values.to_vec(), choices, step, claim, states })
}
