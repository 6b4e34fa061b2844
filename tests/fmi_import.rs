//! FMUs in the place of units: `cargo test --features fmi-import --test fmi_import`.
#![cfg(feature = "fmi-import")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::fs;

use common::run;

const START: &str = "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n";

#[test]
fn an_fmu_in_the_place_of_any_unit_changes_no_double() {
    common::fmu_binary();
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (plain, scenario) = (path("plain.csv"), path("s.toml"));
    fs::write(&scenario, START).unwrap();
    assert_eq!(run(&["cosim", &scenario, "--out", &plain]).0, 0);
    let mut replaced = 0;
    for version in ["2", "3"] {
        for unit in ["coordination", "control", "plant"] {
            let fmu = format!("{unit}{version}.fmu");
            let args = ["fmu", "export", unit, "--fmi", version, "--out", &path(&fmu)];
            assert_eq!(run(&args).0, 0);
            // Parameters by name go to the FMU: drone 3 is neither the model's start nor its id.
            let names: &[&str] = match unit {
                "coordination" => {
                    &["id", "count", "min", "max", "weight", "start", "period", "first_update"]
                }
                "control" => &["lambda_P", "lambda_A"],
                _ => &["x0"],
            };
            let names: String = names.iter().map(|n| format!("{n} = \"{n}\"\n")).collect();
            let text = format!(
                "{START}[[unit]]\ndrone = 3\nunit = \"{unit}\"\nfmu = \"{fmu}\"\n[unit.names]\n{names}"
            );
            fs::write(&scenario, text).unwrap();
            let out = path("out.csv");
            let (code, _, err) = run(&["cosim", &scenario, "--out", &out]);
            assert_eq!(code, 0, "{unit}, FMI {version}: {err}");
            assert_eq!(fs::read(&plain).unwrap(), fs::read(&out).unwrap(), "{unit} {version}");
            replaced += 1;
        }
    }
    assert_eq!(replaced, 6);
}

#[test]
fn what_an_fmu_says_about_a_failure_is_in_the_error() {
    common::fmu_binary();
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    for version in ["2", "3"] {
        let fmu = path("plant.fmu");
        assert_eq!(run(&["fmu", "export", "plant", "--fmi", version, "--out", &fmu]).0, 0);
        // The FMU is made for steps of 0.05 s.
        let text = "start = [0, 1, 3]\nweight = 0.5\ntau = 0.03\n\
                    [[unit]]\ndrone = 1\nunit = \"plant\"\nfmu = \"plant.fmu\"\n";
        fs::write(path("s.toml"), text).unwrap();
        let (code, out, err) = run(&["cosim", &path("s.toml")]);
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(err.contains("unit `plant1`: `") && err.contains("plant.fmu"), "{err}");
        assert!(err.contains("a step of `0.03` s: expected a whole multiple"), "{err}");
    }
}
