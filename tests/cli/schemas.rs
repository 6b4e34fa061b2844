//! Every JSON that a command writes meets its schema in `schemas/`.
use std::fs;
use std::path::PathBuf;

use crate::common::run;
use crate::common::schema::{Schema, meets, parsed, path_of};

#[test]
fn what_commands_print_meets_its_schema() {
    let own = first_own_protocol();
    let calls = [
        "trace scenarios/paper.toml --steps 2",
        "trace scenarios/paper-unstable.toml --steps 9 --check 7.2,7.3",
        "trace scenarios/consensus.toml --steps 2",
        "trace scenarios/paper.toml --at 3,1000 --engine digits",
        "trace scenarios/paper.toml --at 3,1000 --verify 2 --seed 1",
        "errata",
        "local scenarios/paper.toml --ticks 20",
        "local scenarios/paper.toml --ratio 7/2 --ticks 20",
        &format!("prove --protocol {own}"),
        &format!("refute --protocol {own}"),
        "prove --protocol scenarios/own/digraph.toml",
        "prove --protocol scenarios/own/hasty-coverage.toml",
        "threshold --protocol scenarios/own/hasty-coverage.toml --digits 2",
        "threshold --protocol scenarios/own/coverage.toml --set eps=0..1/2",
        "prove --protocol benchmarks/pushed-spring.toml",
        "settle --protocol scenarios/own/digraph.toml --within 1/10",
        "sweep --protocol scenarios/own/hasty-coverage.toml --grid 10 --steps 2",
        "sweep --protocol scenarios/own/coverage.toml --complete --steps 2",
        "theorems --protocol scenarios/own/digraph.toml",
        "theorems --protocol scenarios/own/digraph.toml --check",
        "theorems --protocol scenarios/own/hasty-coverage.toml --check",
        "prove 7.2",
        "prove 7.2 --drones 4 --eps 0..1",
        "prove 7.8 --form paper",
        "refute 7.2 --drones 4 --eps 3/5",
        "refute 7.2 --drones 3",
        "refute all --activation --drones 3 --steps 2",
        "refute 7.2 --delay 1 --drones 4 --eps 3/5",
        "settle --drones 5 --eps 1/4 --within 0.01",
        "settle --drones 5 --eps 0.6 --within 0.01",
        "settle --drones 3 --eps 1 --within 10",
        "settle --drones 3 --eps 1 --within 10 --start 0,1,2",
        "settle --drones 3 --eps 1 --within 0.1 --start 0,1,4",
        "swarm --drones 1000 --steps 5",
        "sweep 7.2,7.6ii --form both --drones 3 --grid 4 --steps 3",
        "sweep 7.8 --form paper --drones 4 --eps 2/3 --complete --steps 3",
        "sweep 7.2 --drones 3 --sample 5 --seed 1 --eps 1/3 --steps 3",
        "theorems",
        "threshold --property ordering --drones 5",
        "threshold --property ordering --drones 4 --delay 1",
        "threshold --property convergence --drones 5",
        "threshold --property separation --digits 1",
        "separation scenarios/paper.toml",
        "separation scenarios/paper.toml --wind 1/2",
        "separation scenarios/quick.toml",
        "separation scenarios/paper-unstable.toml",
        "check proofs/certificates/7.2-sharp.json Cargo.toml no-such-file",
        "cosim scenarios/paper.toml --duration 1",
        "cosim scenarios/paper-unstable.toml --duration 15",
    ];
    let mut formats = Vec::new();
    for call in calls {
        let args: Vec<&str> = call.split(' ').chain(["--format", "json"]).collect();
        let page = parsed(&run(&args).1);
        let format = page["schema"].as_str().unwrap_or_else(|| panic!("{call}")).to_owned();
        meets(&format, &page, call);
        formats.push(format);
    }
    formats.sort();
    formats.dedup();
    assert_eq!(formats.len(), 15, "{formats:?}");
}

fn first_own_protocol() -> String {
    let mut files: Vec<_> =
        fs::read_dir("scenarios/own").unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    files.sort();
    files[0].display().to_string()
}

#[test]
fn what_commands_write_meets_its_schema() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let csv = at("run.csv");
    assert_eq!(run(&["cosim", "scenarios/paper.toml", "--duration", "1", "--out", &csv]).0, 0);
    let companion = parsed(&fs::read_to_string(at("run.csv.json")).unwrap());
    meets("cordon-cosim-companion/1", &companion, "companion");
    let mut lines = 0;
    for args in [
        "7.2,7.6ii --form both --drones 3 --grid 4 --steps 3",
        "7.2 --drones 3 --complete --steps 3",
        "7.8 --form paper --drones 4 --eps 2/3 --complete --steps 3",
        "7.2 --drones 3 --sample 5 --seed 1 --eps 1/3 --steps 3",
    ] {
        let file = at("sweep.jsonl");
        let _ = fs::remove_file(&file);
        let args: Vec<&str> =
            ["sweep"].into_iter().chain(args.split(' ')).chain(["--out", &file]).collect();
        run(&args);
        for (i, line) in fs::read_to_string(&file).unwrap().lines().enumerate() {
            let format = if i == 0 { "cordon-sweep/1" } else { "cordon-sweep-finding/1" };
            meets(format, &parsed(line), line);
            lines += 1;
        }
    }
    assert!(lines > 20, "{lines}");
}

#[test]
fn records_of_the_repository_meet_their_schemas() {
    for (file, format) in
        [("kani/run.json", "cordon-kani/1"), ("proofs/records.json", "cordon-records/1")]
    {
        meets(format, &parsed(&fs::read_to_string(file).unwrap()), file);
    }
}

/// Editors that know the schema of protocol files accept those that are here, and notice a slip.
#[test]
fn protocol_files_meet_their_schema() {
    let schema = Schema::of("cordon-protocol/1");
    let mut files = 0;
    for file in fs::read_dir("scenarios/own").unwrap().map(|e| e.unwrap().path()) {
        if file.extension().is_some_and(|e| e == "toml") {
            let mut page: serde_json::Value =
                toml::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
            schema.accepts(&page).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
            page["rulez"] = serde_json::json!({});
            assert!(schema.accepts(&page).is_err());
            files += 1;
        }
    }
    assert!(files >= 18, "{files}");
}

/// Of every kind, by whichever command wrote it; and what is no certificate meets no schema.
#[test]
fn certificates_meet_their_schema() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    for args in [
        "settle --drones 5 --eps 1/4 --within 0.01",
        "settle --drones 5 --eps 0.6 --within 0.01",
        "threshold --property bound --drones 5",
        "prove 7.8 --form paper",
        "prove --protocol scenarios/own/weighted-coverage.toml",
        "prove --protocol scenarios/own/ring-pulls.toml",
        "prove --protocol scenarios/own/digraph.toml",
        "prove --protocol scenarios/own/digraph.toml --set eps=2",
        "prove --protocol scenarios/own/two-modes.toml",
        "prove --protocol scenarios/own/hasty-coverage.toml",
    ] {
        run(&args.split(' ').chain(["--out", &out]).collect::<Vec<_>>());
    }
    for (way, name) in [("--activation", "activation.json"), ("--delay=1", "delay.json")] {
        let file = folder.path().join(name).display().to_string();
        run(&["refute", "7.2", "--drones", "4", "--eps", "3/5", way, "--out", &file]);
    }
    let mut kinds = std::collections::BTreeMap::new();
    for folder in [folder.path(), "proofs/certificates".as_ref()] {
        for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
            if path.extension().is_none_or(|e| e != "json") {
                continue;
            }
            let page = parsed(&fs::read_to_string(&path).unwrap());
            meets("cordon-certificate/2", &page, &path.display().to_string());
            for (kind, body) in page["certificate"].as_object().unwrap() {
                let departs = ["activation", "delay"].iter().find(|d| body.get(**d).is_some());
                let kind = departs.map_or_else(|| kind.clone(), |d| format!("{kind}, {d}"));
                *kinds.entry(kind).or_insert(0) += 1;
            }
        }
    }
    let found: Vec<_> = kinds.keys().map(String::as_str).collect();
    let expected = [
        "contraction",
        "counterexample",
        "ellipsoid",
        "growth",
        "refutation",
        "refutation, activation",
        "refutation, delay",
        "theorem",
    ];
    assert_eq!(found, expected);
    assert!(kinds["theorem"] >= 30, "{kinds:?}");
}

/// A schema that no test reads would not be kept true.
#[test]
fn every_schema_is_read_by_a_test() {
    let files = fs::read_dir("schemas").unwrap();
    let names: Vec<_> = files.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    // 15 that are printed, 3 that are written, 2 records, certificates, the state of an FMU
    // (fmu.rs), 3 of `cargo xtask` (xtask/tests/schemas.rs), protocol files; and the page about them.
    assert_eq!(names.len(), 15 + 3 + 2 + 1 + 1 + 3 + 1 + 1, "{names:?}");
    for name in names.iter().filter(|n| n.ends_with(".json")) {
        let schema = parsed(&fs::read_to_string(format!("schemas/{name}")).unwrap());
        assert_eq!(path_of(schema["title"].as_str().unwrap()), PathBuf::from("schemas").join(name));
        let said = schema["description"].as_str().unwrap();
        assert!(said.contains("Written by `") || said.contains("Read by `"), "{name}");
    }
}
