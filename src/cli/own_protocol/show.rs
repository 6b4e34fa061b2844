//! What all commands say of a system.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::system::{Claim, Parameter, ParameterKind, Schedule, System};

use super::abridged_words;

/// The schema of these commands' JSON.
pub const SCHEMA: &str = "cordon-own-protocol/2";

/// The fields that every page has.
pub fn head(system: &System) -> BTreeMap<&'static str, Value> {
    let range = |p: &Parameter| (p.name.clone(), json!([fraction(&p.low), fraction(&p.high)]));
    BTreeMap::from([
        ("schema", json!(SCHEMA)),
        ("title", json!(system.title)),
        ("agents", json!(system.agents)),
        (
            "parameters",
            system.parameters.iter().map(range).collect::<serde_json::Map<_, _>>().into(),
        ),
    ])
}

/// The system in a line; `anew` says how often what varies does so.
pub fn headline(system: &System) -> String {
    headline_in(system, "in each step")
}

/// As [`headline`], with other words for when what varies does so.
pub fn headline_in(system: &System, anew: &str) -> String {
    let agents = if system.agents == 1 { "agent" } else { "agents" };
    let mut parts = vec![format!("{}: {} {agents}", system.title, system.agents)];
    let is_choice = |p: &&Parameter| p.kind == ParameterKind::Choice;
    for p in system.parameters.iter().filter(|p| !is_choice(p)) {
        parts.push(match (p.fixed(), p.kind) {
            (Some(value), _) => format!("{} = {}", p.name, fraction(value)),
            (None, ParameterKind::Varying) => {
                format!(
                    "{} anywhere in [{}, {}], anew {anew}",
                    p.name,
                    fraction(&p.low),
                    fraction(&p.high)
                )
            }
            (None, _) => {
                format!("every {} in [{}, {}]", p.name, fraction(&p.low), fraction(&p.high))
            }
        });
    }
    match system.parameters.iter().filter(is_choice).count() {
        0 => {}
        n => parts.push(format!("{n} free choice{} {anew}", if n == 1 { "" } else { "s" })),
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
pub fn claimed_steps(system: &System) -> &'static str {
    let always = system.claims.iter().all(|c| c.from == 0 && c.until.is_none());
    if always { "every step" } else { "every step that they are about" }
}

/// ` at eps = 1/3, gain = 2`: the constants, where there are some.
pub fn constants_text(system: &System, values: &[Rational]) -> String {
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let all = system.parameters.iter().zip(values).filter(constant);
    let all: Vec<String> = all.map(|(p, v)| format!("{} = {}", p.name, fraction(v))).collect();
    if all.is_empty() { String::new() } else { format!(" at {}", all.join(", ")) }
}

/// `, from step 3`, `, until step 9`.
pub fn when(claim: &Claim) -> String {
    let from = if claim.from > 0 { format!(", from step {}", claim.from) } else { String::new() };
    let until = claim.until.map_or_else(String::new, |last| format!(", until step {last}"));
    from + &until
}
