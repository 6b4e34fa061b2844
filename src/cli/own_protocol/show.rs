//! What all commands say of a system.

use cordon_core::Rational;
use cordon_core::exact::{fraction, shortened};
use cordon_core::system::{Claim, Parameter, ParameterKind, Schedule, System};

use super::abridged_words;
use crate::cli::table::counted;

/// A number that may be long, for people.
fn number(x: &Rational) -> String {
    shortened(&fraction(x))
}

/// The system in a line; `anew` says how often what varies does so.
pub fn headline(system: &System) -> String {
    headline_in(system, "in each step")
}

/// As [`headline`], with other words for when what varies does so.
pub fn headline_in(system: &System, anew: &str) -> String {
    let mut parts = vec![format!("{}: {}", system.title, counted(system.agents, "agent"))];
    let is_choice = |p: &&Parameter| p.kind == ParameterKind::Choice;
    for p in system.parameters.iter().filter(|p| !is_choice(p)) {
        parts.push(match (p.fixed(), p.kind) {
            (Some(value), _) => format!("{} = {}", p.name, number(value)),
            (None, ParameterKind::Varying) => format!(
                "{} anywhere in [{}, {}], anew {anew}",
                p.name,
                number(&p.low),
                number(&p.high)
            ),
            (None, _) => {
                format!("every {} in [{}, {}]", p.name, number(&p.low), number(&p.high))
            }
        });
    }
    match system.parameters.iter().filter(is_choice).count() {
        0 => {}
        n => parts.push(format!("{} {anew}", counted(n, "free choice"))),
    }
    match (&system.schedule, system.modes.len()) {
        (_, 1) => {}
        (Schedule::Any, n) => parts.push(format!("any of {n} modes {anew}")),
        (Schedule::Cycle(list), _) => {
            let names = list.iter().filter_map(|&m| system.modes.get(m)).map(|m| m.name.as_str());
            let names: Vec<&str> = names.collect();
            match names.as_slice() {
                [only] => parts.push(format!("mode {only} in every step")),
                _ => parts.push(format!("modes in turn: {}", abridged_words(&names))),
            }
        }
    }
    parts.join(", ")
}

/// `every step`, or less where claims are about certain steps only.
pub fn claimed_steps(system: &System) -> String {
    let first = system.claims.first().and_then(|c| c.until);
    match (system.claims.iter().all(|c| c.from == 0 && c.until == first), first) {
        (true, None) => "every step".to_owned(),
        (true, Some(last)) => format!("every step up to step {last}"),
        (false, _) => "every step that they are about".to_owned(),
    }
}

/// ` at eps = 1/3, gain = 2`: the constants, where there are some.
pub fn constants_text(system: &System, values: &[Rational]) -> String {
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let all = system.parameters.iter().zip(values).filter(constant);
    let all: Vec<String> = all.map(|(p, v)| format!("{} = {}", p.name, number(v))).collect();
    if all.is_empty() { String::new() } else { format!(" at {}", all.join(", ")) }
}

/// As [`constants_text`], or how many combinations were tried.
pub fn constants_tried(system: &System, all: &[Vec<Rational>]) -> String {
    match all {
        [one] => constants_text(system, one),
        many => format!(" at {} combinations of constants", many.len()),
    }
}

/// `, from step 3`, `, until step 9`.
pub fn when(claim: &Claim) -> String {
    let from = if claim.from > 0 { format!(", from step {}", claim.from) } else { String::new() };
    let until = claim.until.map_or_else(String::new, |last| format!(", until step {last}"));
    from + &until
}
