//! The units as what is inside an FMU sees them: inputs, outputs, states, the rules of the standards.
use std::fs;
use std::path::Path;

use crate::common::schema::meets;
use cordon_cosim::fmi::interface::{FmiVersion, Model, Positions, START_INPUTS, TAU};
use cordon_cosim::fmi::slave::{Mode, Severity, Slave};
use cordon_cosim::unit::{Causality, Kind, Value};
use cordon_run::scenario::parse;

fn slave(model: &Model, version: FmiVersion) -> Slave {
    let resources = tempfile::tempdir().unwrap();
    for (name, text) in model.resources() {
        fs::write(resources.path().join(name), text).unwrap();
    }
    let token = model.token(version);
    let mut slave = Slave::instantiate(version, "it", &token, Some(resources.path())).unwrap();
    if let Model::Protocol(..) = model {
        // The platoon's leader does not move.
        slave.set(reference(model, "id"), &Value::Integer(1)).unwrap();
    }
    slave
}

/// Every unit that is exported; of the protocol files a platoon.
pub(super) fn models() -> Vec<Model> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/own/platoon.toml");
    let start = "start = [0, 0, 0.25, 0, 0, 0, 0, 0, 0, 0]";
    let text = format!("protocol = '{}'\n{start}\nperiod = 4", file.display());
    let platoon = parse("test", &text).unwrap().finish().unwrap();
    let platoon = Model::coordination(Positions::Exact, &platoon).unwrap();
    Model::PLAIN.into_iter().chain([platoon]).collect()
}

fn reference(model: &Model, name: &str) -> u32 {
    let index = model.variables().iter().position(|v| v.name == name);
    u32::try_from(index.expect("a variable")).unwrap()
}

fn begin(slave: &mut Slave) {
    slave.set_up(0.0, None).unwrap();
    slave.enter_initialisation().unwrap();
    slave.exit_initialisation().unwrap();
}

/// The values of all outputs, as text.
fn outputs(model: &Model, slave: &mut Slave) -> Vec<(String, String)> {
    let variables = model.variables();
    let outputs = variables.iter().zip(0..).filter(|(v, _)| v.causality == Causality::Output);
    outputs
        .map(|(v, reference)| {
            let value = match v.kind() {
                Kind::Real => format!("{:?}", slave.real(reference).unwrap()),
                _ => slave.text(reference).unwrap(),
            };
            (v.name.clone(), value)
        })
        .collect()
}

/// Another value of a parameter, in its range.
fn another(model: &Model, name: &str, value: &Value) -> Value {
    match (name, value) {
        (_, Value::Real(x)) => Value::Real(x + 0.5),
        (_, Value::Integer(n)) => Value::Integer(n + 1),
        (_, Value::Boolean(b)) => Value::Boolean(!b),
        ("integrator", _) => Value::Text("exact".into()),
        ("first_update", _) => Value::Text("last".into()),
        (_, Value::Exact(_)) => Value::Text("17/4".into()),
        (_, other) => panic!("{model:?}.{name}: {other}"),
    }
}

#[test]
fn initial_outputs_depend_on_the_stated_parameters_and_on_no_others() {
    let mut compared = 0;
    for model in &models() {
        let mut plain = slave(model, FmiVersion::V2);
        begin(&mut plain);
        let before = outputs(model, &mut plain);
        for v in model.variables().iter().filter(|v| v.causality == Causality::Parameter) {
            let mut changed = slave(model, FmiVersion::V2);
            let value = another(model, &v.name, &v.start);
            changed.set(reference(model, &v.name), &value).unwrap();
            begin(&mut changed);
            for ((name, x), (_, y)) in before.iter().zip(outputs(model, &mut changed)) {
                let depends = model.initial_dependencies(name).as_ref() == Some(&v.name);
                assert_eq!(*x != y, depends, "{model:?}: {name} on {}", v.name);
                compared += 1;
            }
        }
    }
    // Outputs times parameters: coordination 2*11, 1*11 twice, control 4*14, plant 12*15, the platoon 3*8.
    assert_eq!(compared, 22 + 11 + 11 + 56 + 180 + 24);
}

#[test]
fn a_state_that_went_through_bytes_goes_on_as_before() {
    let mut moved = 0;
    for model in &models() {
        let mut a = slave(model, FmiVersion::V3);
        let inputs: Vec<u32> = (0..)
            .zip(&model.variables())
            .filter(|(_, v)| v.causality == Causality::Input)
            .map(|(reference, _)| reference)
            .collect();
        let exact = model.exact_numbers();
        let feed = |slave: &mut Slave, k: u32| {
            for reference in &inputs {
                let x = f64::from((k * 7 + reference * 3) % 11) / 8.0;
                let value = if exact { Value::Text(x.to_string().into()) } else { Value::Real(x) };
                slave.set(*reference, &value).unwrap();
            }
            slave.do_step(f64::from(k) * 0.05, 0.05).unwrap();
        };
        begin(&mut a);
        for k in 0..10 {
            feed(&mut a, k);
        }
        let bytes = a.save().unwrap().to_bytes();
        let page = serde_json::from_slice(&bytes).unwrap();
        meets("cordon-fmu-state/1", &page, "the state of an FMU");
        let at_10 = outputs(model, &mut a);
        for k in 10..20 {
            feed(&mut a, k);
        }
        let at_20 = outputs(model, &mut a);
        moved += usize::from(at_10 != at_20);

        let mut b = slave(model, FmiVersion::V3);
        let state = b.snapshot_from_bytes(&bytes).unwrap();
        b.restore(&state).unwrap();
        assert_eq!(b.save().unwrap(), state);
        assert_eq!(outputs(model, &mut b), at_10);
        for k in 10..20 {
            feed(&mut b, k);
        }
        assert_eq!(outputs(model, &mut b), at_20, "{model:?}");

        let cut = &bytes[..bytes.len() / 2];
        assert!(b.snapshot_from_bytes(cut).unwrap_err().message.contains("cannot be read"));
        let other = &Model::PLAIN[usize::from(*model == Model::PLAIN[0])];
        let refused = slave(other, FmiVersion::V3).snapshot_from_bytes(&bytes).unwrap_err();
        assert!(refused.message.contains("expected `cordon-fmi3.0:"), "{}", refused.message);
    }
    assert_eq!(moved, 6, "models that the steps moved");
}

/// What is set between the initialisation and the first step is not heard, where a parameter says so.
#[test]
fn the_first_step_takes_the_start_values_of_the_inputs_on_request() {
    let model = &Model::Coordination(Positions::Double);
    let mut heard = Vec::new();
    for start_inputs in [false, true] {
        let mut s = slave(model, FmiVersion::V3);
        let prec = reference(model, "prec");
        s.set(reference(model, START_INPUTS), &Value::Boolean(start_inputs)).unwrap();
        s.set(prec, &Value::Real(2.0)).unwrap();
        begin(&mut s);
        s.set(prec, &Value::Real(0.0)).unwrap();
        assert!(s.set(prec, &Value::Boolean(true)).is_err());
        s.do_step(0.0, 0.05).unwrap();
        let bytes = s.save().unwrap().to_bytes();
        let state = s.snapshot_from_bytes(&bytes).unwrap();
        s.restore(&state).unwrap();
        heard.push(s.real(reference(model, "x_d")).unwrap());
        s.set(prec, &Value::Real(1.0)).unwrap();
        assert_eq!(s.real(prec), Ok(1.0), "only the first step");
    }
    // 10 + 1/5 (prec - 10), without the follower's pull: at its start the drone is at its place.
    assert_eq!(heard, [8.0, 8.4]);
}

#[test]
fn the_rules_of_the_standards_hold() {
    let model = &Model::Plant;
    let (x0, w1, tau) = (reference(model, "x0"), reference(model, "w1"), reference(model, TAU));
    let mut s = slave(model, FmiVersion::V2);
    let refused = |fault: Result<(), cordon_cosim::fmi::slave::Refusal>, part: &str| {
        let fault = fault.unwrap_err();
        assert!(fault.message.contains(part), "{}", fault.message);
        assert_eq!(fault.severity, Severity::Error);
    };
    refused(s.do_step(0.0, 0.05), "the instance is not initialised");
    refused(s.exit_initialisation(), "the instance is not initialised");
    refused(s.set_up(f64::NAN, None), "expected times in order");
    refused(s.set(tau, &Value::Real(0.0)), "expected a positive number of seconds");
    refused(s.set(99, &Value::Real(0.0)), "value reference 99: expected less than 31");
    refused(s.set(x0, &Value::Boolean(true)), "expected real, found boolean");
    let mut endless = slave(model, FmiVersion::V2);
    begin(&mut endless);
    for seconds in [1e300, f64::INFINITY, 4e8] {
        refused(endless.do_step(0.0, seconds), " s: expected ");
    }
    assert_eq!(endless.time(), 0.0);
    endless.do_step(0.0, 50.0).unwrap();
    s.set_up(2.0, Some(2.5)).unwrap();
    s.enter_initialisation().unwrap();
    s.set(tau, &Value::Real(1.0 / 30.0)).unwrap();
    s.set(x0, &Value::Real(4.0)).unwrap();
    s.exit_initialisation().unwrap();
    assert_eq!(s.mode(), Mode::Step);
    refused(s.set(x0, &Value::Real(1.0)), "setting `x0`: the instance is running");
    refused(s.set(w1, &Value::Real(f64::INFINITY)), "expected a finite number");
    refused(s.do_step(0.0, 1.0 / 30.0), "expected `2` s");
    for k in 0..15 {
        // As an importer adds up its doubles.
        s.do_step(2.0 + f64::from(k) * (1.0 / 30.0), 1.0 / 30.0).unwrap();
    }
    assert_eq!(s.time(), 2.5);
    refused(s.do_step(2.5, 1.0 / 30.0), "goes beyond the end of the run");
    assert_eq!(s.real(reference(model, "x")).unwrap(), 4.0);
    assert_eq!(s.real(31).unwrap(), 2.5, "the time follows the variables");
    assert!(s.integer(w1).unwrap_err().message.contains("its type is real"));
    s.terminate().unwrap();
    refused(s.do_step(2.5, 1.0 / 30.0), "the instance is terminated");
    s.give_up();
    assert_eq!(s.reset().unwrap_err().severity, Severity::Fatal);
}
