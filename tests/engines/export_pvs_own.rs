//! Protocol files as PVS theories: the step is the system's, every formula has its proof.
use crate::common::{q, run};
use cordon_core::Rational;
use cordon_core::scalar::Polynomial;
use cordon_core::system::System;
use cordon_core::system::expression::{Expression, Meaning};
use cordon_proof::claims;
use cordon_proof::export::pvs::{File, own};
use cordon_run::protocol::{parse, read};

/// A state and parameters, by the names that the theory has for them.
struct Point<'s>(&'s System, Vec<Rational>, Vec<Rational>);

impl Meaning for Point<'_> {
    fn name(&self, name: &str) -> Result<Polynomial, String> {
        let (of, name) = name.split_at(1);
        let (names, values) = match of {
            "s" => (self.0.state.clone(), &self.1),
            _ => (self.0.parameters.iter().map(|p| p.name.clone()).collect(), &self.2),
        };
        let index = names.iter().position(|n| n == name.trim_end_matches('_'));
        Ok(Polynomial::constant(values[index.ok_or_else(|| name.to_owned())?].clone()))
    }
}

/// The formulas of a theory, and those that a script follows.
fn formulas(file: &File) -> (Vec<String>, Vec<String>) {
    let name = |line: &str| line.trim().split(':').next().unwrap_or_default().to_owned();
    let kinds = [": LEMMA", ": THEOREM", ": CONJECTURE"];
    let stated = file.theories.lines().filter(|l| kinds.iter().any(|k| l.contains(k)));
    let proved =
        file.theories.lines().filter_map(|l| l.strip_prefix("%|- ")?.strip_suffix(" : PROOF"));
    (stated.map(name).collect(), proved.map(str::to_owned).collect())
}

#[test]
fn the_step_of_a_theory_is_the_step_of_the_system() {
    let mut compared = 0;
    for name in ["weighted-coverage", "coverage-with-losses", "one-step-late", "no-overshoot"] {
        let path = format!("scenarios/own/{name}.toml");
        let system = read(path.as_ref()).unwrap().system().unwrap();
        let file = own(&system, claims::prove(&system).as_ref()).unwrap();
        let number = |k: usize| Rational::new((7 * k as i64 % 11 - 4).into(), 3.into());
        let state: Vec<Rational> = (0..system.state.len()).map(number).collect();
        // What has one value stands in the theory as a number.
        let values = system.values(|p| q("1/3") * (&p.high - &p.low) + &p.low);
        let next = system.modes[0].at(&values).apply(&state);
        let point = Point(&system, state, values.clone());
        for (variable, next) in system.state.iter().zip(&next) {
            let line = file.theories.lines().find_map(|l| l.split_once(&format!("{variable} := ")));
            let text =
                line.unwrap().1.trim_end_matches(" #)").trim_end_matches(',').replace('`', "");
            let value = Expression::parse(&text).unwrap().value(&point).unwrap();
            assert_eq!(value, Polynomial::constant(next.clone()), "{name}: {variable} := {text}");
            compared += 1;
        }
    }
    assert_eq!(compared, 5 + 4 + 8 + 2);
}

#[test]
fn every_formula_of_a_proved_claim_has_its_script() {
    for name in ["coverage-with-losses", "coverage-heard-in-turn", "platoon"] {
        let path = format!("scenarios/own/{name}.toml");
        let system = read(path.as_ref()).unwrap().system().unwrap();
        let file = own(&system, claims::prove(&system).as_ref()).unwrap();
        let (stated, proved) = formulas(&file);
        assert_eq!(stated, proved, "{name}");
        assert!(stated.len() > 10 && !file.theories.contains("CONJECTURE"));
        for script in file.theories.split(" : PROOF\n").skip(1) {
            let script = script.split("QED").next().unwrap_or_default();
            let count = |c: char| script.chars().filter(|d| *d == c).count();
            assert!(count('(') == count(')') && count('"') % 2 == 0, "{name}: {script}");
        }
        for formula in &stated {
            assert!(file.proofs.contains(&format!("({formula} 0\n")), "{name}: {formula}");
        }
    }
}

#[test]
fn what_is_not_proved_stands_as_a_conjecture() {
    let system = read("scenarios/own/hasty-coverage.toml".as_ref()).unwrap().system().unwrap();
    let file = own(&system, None).unwrap();
    assert_eq!(formulas(&file).1, ["between_pos", "between_nonneg"]);
    assert!(
        file.theories.contains("No invariant was found")
            && file.theories.contains("always: CONJECTURE")
    );
}

#[test]
fn words_of_pvs_are_no_names() {
    let text = "agents = 1\nstate = \"o\"\nclaims = [\"0 <= o0 <= 1\"]\n[parameters]\nend = \"0..1\"\nreal = \"0..1\"\n\
                [rules]\nall = \"o*end*real\"\n";
    let system = parse("words", text).unwrap().system().unwrap();
    let file = own(&system, claims::prove(&system).as_ref()).unwrap();
    assert!(file.theories.contains("[# end_, real_: real #]"), "{}", file.theories);
    assert!(file.theories.contains("o0 := p`end_*p`real_*s`o0"), "{}", file.theories);
}

#[test]
fn the_command_writes_theory_and_proofs() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let call = |rest: &[&str]| run(&[&["export", "pvs", "--protocol"], rest].concat());
    let (code, said, _) = call(&["scenarios/own/rotation.toml", "--out", out]);
    assert_eq!((code, said.lines().count()), (0, 2), "{said}");
    let theory = std::fs::read_to_string(folder.path().join("own_protocol.pvs")).unwrap();
    assert!(theory.contains("always: THEOREM\n    run?(q, at, r) IMPLIES claimed?(at(k))(r(k))"));
    assert!(folder.path().join("own_protocol.prf").exists());
    assert_eq!(call(&["scenarios/own/rotation.toml"]).1, theory + "\n");
    let (code, _, error) = call(&["scenarios/own/second-order.toml"]);
    assert!(code == 2 && error.contains("claims: none in the protocol file"), "{error}");
    let (code, _, error) =
        call(&["scenarios/own/rotation.toml", "--scenario", "scenarios/paper.toml"]);
    assert!(code == 2 && error.contains("cannot be used with"), "{error}");
}
