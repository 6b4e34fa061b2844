//! Users' own protocols, run by every engine: stepping, jumps and local machines do what the system
//! of the file does on fractions.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::path::Path;

use cordon_core::Rational;
use cordon_core::random::SplitMix;
use cordon_core::system::System;
use cordon_run::fast::{Course, Engine, Line, Motion, engine, jump, leap};
use cordon_run::scenario::{Own, Scenario, parse};
use cordon_run::trace::{Counted, Selection, select};
use cordon_run::{projection, protocol, simulate};

fn q(p: i64, q: u64) -> Rational {
    Rational::new(p.into(), q.into())
}

fn file(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/own");
    root.join(format!("{name}.toml")).display().to_string()
}

fn scenario(text: &str) -> Scenario {
    parse("test", text).unwrap().finish().unwrap()
}

fn rows(scenario: &Scenario, last: u64) -> Vec<Vec<Rational>> {
    let selection = Selection { unit: Counted::Steps, from: 0, to: last, every: 1 };
    select(scenario, selection).unwrap().map(|r| r.positions.lowest()).collect()
}

/// A system of random size, entries, constants and number of modes in turn, as a file.
fn random_file(random: &mut SplitMix) -> (String, usize) {
    let agents = 1 + random.below(5) as usize;
    let modes = 1 + random.below(3);
    let mut rules = |name: &str| {
        let mut text = format!("[{name}]\n");
        for i in 0..agents {
            let mut terms = Vec::new();
            for j in 0..agents {
                if random.below(3) > 0 {
                    let (p, q) = (random.below(13) as i64 - 6, 1 + random.below(6));
                    terms.push(format!("({p})/{q}*x{j}"));
                }
            }
            if random.below(3) == 0 {
                terms.push(format!("({})/{}", random.below(9) as i64 - 4, 1 + random.below(4)));
            }
            if terms.is_empty() {
                terms.push("0".to_owned());
            }
            text += &format!("{i} = \"{}\"\n", terms.join(" + "));
        }
        text
    };
    let body = match modes {
        1 => rules("rules"),
        _ => (0..modes).map(|m| rules(&format!("modes.m{m}"))).collect(),
    };
    let names: Vec<String> = (0..modes).map(|m| format!("\"m{m}\"")).collect();
    let turn = match modes {
        1 => String::new(),
        _ => format!("switching = [{}]\n", names.join(", ")),
    };
    let head = format!("title = \"random\"\nagents = {agents}\nclaims = [\"x0 >= 0\"]\n{turn}");
    (head + &body, agents)
}

/// Both engines on random systems, compared with the system on fractions.
#[test]
fn engines_run_random_systems_as_the_system_does() {
    let mut random = SplitMix::new(2026);
    let (mut compared, mut lines) = (0, 0);
    for _ in 0..200 {
        let (text, agents) = random_file(&mut random);
        let system = protocol::parse("random", &text).unwrap().system().unwrap();
        let start: Vec<Rational> =
            (0..agents).map(|_| q(random.below(11) as i64 - 5, 1 + random.below(5))).collect();
        let wanted = system.run(&[], &start, 40);
        let own =
            Own::new(("random".into(), String::new()), system, &BTreeMap::new(), None).unwrap();
        let maps = own.cycle().unwrap();
        let motion = match maps.as_slice() {
            [map] => Line::of_map(map, &start).map(Motion::Line),
            _ => None,
        };
        lines += usize::from(motion.is_some());
        let course = || Motion::Course(Course::in_turn(&maps, &start).into());
        let motion = motion.unwrap_or_else(course);
        let steps = [0, 1, 2, 3, 7, 39, 40, 7];
        let stepped = motion.positions(&steps, Engine::Step).unwrap();
        let by = engine::multiplier();
        let jumped = match &motion {
            Motion::Line(line) => jump::at(line, &steps, by).unwrap(),
            Motion::Course(course) => {
                steps.iter().map(|k| leap::after(course, *k, by).unwrap()).collect()
            }
        };
        let planned = motion.positions(&steps, Engine::Jump).unwrap();
        for answers in [stepped, jumped, planned] {
            for (k, answer) in steps.iter().zip(&answers) {
                assert_eq!(answer.positions(by), wanted[*k as usize], "{text} step {k}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 200 * 24);
    assert!(lines < 100, "{lines}");
}

/// Coverage and consensus written as files equal the built-in protocols, row by row.
#[test]
fn files_of_the_built_in_protocols_run_as_they_do() {
    let mut compared = 0;
    for (name, built_in) in [("coverage", "coverage"), ("consensus", "consensus")] {
        for count in [3, 4, 7, 12] {
            for eps in ["1/5", "1/2", "0.33", "0"] {
                let inner: Vec<String> =
                    (1..count - 1).map(|i| format!("\"{i}/{}\"", 2 * count)).collect();
                let start = format!("start = [0, {}, 1]\nweight = \"{eps}\"", inner.join(", "));
                let own = scenario(&format!("protocol = '{}'\n{start}", file(name)));
                let wanted = scenario(&format!("protocol = \"{built_in}\"\n{start}"));
                assert_eq!(rows(&own, 25), rows(&wanted, 25), "{name} {count} {eps}");
                compared += 26;
                let far = |s: &Scenario| {
                    let answers = Motion::of(s, 3000).unwrap().positions(&[3000], Engine::Jump);
                    answers.unwrap()[0].positions(engine::multiplier())
                };
                assert_eq!(far(&own), far(&wanted));
                let is_line = matches!(Motion::of(&own, 9).unwrap(), Motion::Line(_));
                assert!(is_line, "{name} {count} {eps}: the fast kernel");
            }
        }
    }
    assert_eq!(compared, 2 * 4 * 4 * 26);
}

fn read_system(name: &str, agents: usize) -> System {
    protocol::read(Path::new(&file(name))).unwrap().with_agents(agents).unwrap()
}

/// Delays, drawn choices and modes in turn: stepping on integers equals applying the maps on
/// fractions, and local machines equal the global run.
#[test]
fn choices_are_drawn_alike_by_all_engines_and_local_machines_follow() {
    let files = [
        ("coverage-late", 4, "weight = \"1/3\""),
        ("coverage-with-losses", 4, "weight = \"1/4\""),
        ("platoon", 10, ""),
        ("grid", 32, "weight = \"1/5\""),
        ("digraph", 5, "weight = \"1/4\""),
        ("ring-pulls", 6, "weight = \"1/4\""),
    ];
    let mut compared = 0;
    for (name, numbers, weight) in files {
        for seed in [None, Some(1), Some(2)] {
            let start: Vec<String> = (0..numbers).map(|i| (i % 3).to_string()).collect();
            let text = format!(
                "protocol = '{}'\nstart = [{}]\nperiod = 3\n{weight}",
                file(name),
                start.join(", ")
            );
            let mut draft = parse("test", &text).unwrap();
            draft.choices = seed;
            let s = draft.finish().unwrap();
            let shown = rows(&s, 12);
            let mut spec = simulate::run(&s).filter(|t| t.tick == 0 || t.state.timesteps == 0);
            for row in &shown {
                let mut wanted = spec.next().unwrap().state.drones;
                wanted.truncate(row.len());
                assert_eq!(*row, wanted, "{name} {seed:?}");
                compared += 1;
            }
            let setup = projection::Setup { ticks: 30, exchange_every: 1, ratio: None };
            let pairs = projection::run(&s, setup).unwrap();
            assert_eq!(pairs.len(), 31);
            assert!(pairs.iter().all(|p| p.difference().is_none()), "{name} {seed:?}");
            let seldom = projection::Setup { exchange_every: 31, ..setup };
            let differs = projection::run(&s, seldom).unwrap();
            assert!(differs.iter().any(|p| p.difference().is_some()), "{name} {seed:?}");
        }
    }
    assert_eq!(compared, 6 * 3 * 13);
    // Another seed gives another run.
    let own = |seed| {
        let file = read_system("coverage-late", 4);
        Own::new(("f".into(), String::new()), file, &BTreeMap::new(), seed).unwrap()
    };
    let differ = (1..20).filter(|k| own(Some(1)).map(*k) != own(Some(2)).map(*k)).count();
    assert!(differ > 10, "{differ}");
    assert!(own(None).choices().unwrap().contains("no message is late"));
}
