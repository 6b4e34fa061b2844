//! FMUs and multi-models from the command line, without other tools: round trips and bad input.
use std::fs;
use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};

use super::slave::models;
use crate::common::run;
use cordon_cosim::fmi::interface::{FmiVersion, Model};
use cordon_cosim::fmi::slave::Slave;
use tempfile::TempDir;
use zip::{ZipArchive, ZipWriter, write::SimpleFileOptions};

fn fresh() -> (TempDir, impl Fn(&str) -> String) {
    let dir = tempfile::tempdir().unwrap();
    let root = dir.path().to_owned();
    (dir, move |name: &str| root.join(name).to_str().unwrap().to_owned())
}

/// Asserts that a command fails with this code, names what it should, and writes nothing.
fn fails(args: &[&str], code: i32, parts: &[&str]) {
    let (found, out, err) = run(args);
    assert_eq!((found, out.as_str()), (code, ""), "{args:?}: {err}");
    for part in parts {
        assert!(err.contains(part), "{args:?}: `{part}` is not in {err}");
    }
}

#[test]
fn an_export_is_the_same_every_time_and_appears_whole_or_not_at_all() {
    crate::common::fmu_binary();
    let (dir, path) = fresh();
    let export = |out: &str| run(&["fmu", "export", "control", "--fmi", "3", "--out", out]);
    assert_eq!(export(&path("a.fmu")).0, 0);
    assert_eq!(export(&path("b.fmu")).0, 0);
    assert_eq!(fs::read(path("a.fmu")).unwrap(), fs::read(path("b.fmu")).unwrap());
    let missing = path("no-such-folder/c.fmu");
    fails(&["fmu", "export", "plant", "--out", &missing], 74, &["cannot write", &missing]);
    let nowhere = path("no-binary.so");
    let out = path("d.fmu");
    let args = ["fmu", "export", "plant", "--out", &out, "--binary", &nowhere];
    fails(&args, 74, &["cannot read", &nowhere]);
    // Neither another file nor this very program is the library.
    for other in ["Cargo.toml", env!("CARGO_BIN_EXE_cordon")] {
        let args = ["fmu", "export", "plant", "--out", &out, "--binary", other];
        fails(&args, 2, &[other, "expected the compiled crate `cordon-fmu`, version"]);
    }
    let left: Vec<_> = fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

#[test]
fn the_binary_that_is_missing_is_named_with_the_command_that_builds_it() {
    let (_dir, path) = fresh();
    // Away from cargo and from the folder where it puts binaries.
    let alone = path("cordon");
    fs::copy(env!("CARGO_BIN_EXE_cordon"), &alone).unwrap();
    let out = std::process::Command::new(&alone)
        .args(["fmu", "export", "plant", "--out", &path("x.fmu")])
        .env_remove("CARGO")
        .output()
        .unwrap();
    let err = String::from_utf8(out.stderr).unwrap();
    assert_eq!(out.status.code(), Some(2));
    assert!(err.contains("build it with `cargo build --release -p cordon-fmu`"), "{err}");
    assert!(!Path::new(&path("x.fmu")).exists());
}

#[test]
fn a_multi_model_that_was_written_is_read_as_the_same_scenario() {
    crate::common::fmu_binary();
    let three =
        ["--tau", "1/30", "--eps", "1/3", "--integrator", "exact", "--phase", "last", "--exchange"];
    let [exact, double] = ["exact", "double"].map(|e| [&three[..], &[e]].concat());
    let cases: [(&str, &[&str]); 4] = [
        ("scenarios/paper.toml", &["--exchange", "exact"]),
        ("scenarios/paper-unstable.toml", &["--exchange", "double", "--duration", "10"]),
        ("scenarios/three.toml", &exact),
        ("scenarios/three.toml", &double),
    ];
    for (scenario, flags) in cases {
        let (_dir, path) = fresh();
        let folder = path("system");
        let (code, _, err) =
            run(&[&["export", "into-cps", scenario, "--out", &folder], flags].concat());
        assert_eq!(code, 0, "{err}");
        let model = path("system/multi-model.json");
        let (a, b) = (path("a.csv"), path("b.csv"));
        assert_eq!(run(&[&["cosim", scenario, "--out", &a], flags].concat()).0, 0);
        let (code, _, err) = run(&["cosim", &model, "--out", &b]);
        assert_eq!(code, 0, "{err}");
        assert_eq!(fs::read(&a).unwrap(), fs::read(&b).unwrap(), "{scenario}");
        // It is flown for a page as well, and neither it nor its FMUs are written over.
        let page = path("page.html");
        let (code, _, err) = run(&["replay", &model, "--out", &page]);
        assert_eq!(code, 0, "{err}");
        let before = fs::read(&model).unwrap();
        let in_place: [&[&str]; 2] = [
            &["export", "into-cps", &model, "--out", &folder],
            &["replay", &model, "--out", &path("system/cordon_plant.fmu")],
        ];
        for call in in_place {
            fails(call, 2, &["out: `", "expected a file other than the inputs of the command"]);
        }
        assert_eq!(fs::read(&model).unwrap(), before);
        // Read and written again it is the same file.
        let again = path("again");
        assert_eq!(run(&["export", "into-cps", &model, "--out", &again]).0, 0);
        let text = |folder: &str| fs::read_to_string(path(folder).as_str()).unwrap();
        if flags.contains(&"double") {
            // Doubles are what is exported where nothing is said.
            let flags: Vec<&str> =
                flags.iter().copied().filter(|f| !["--exchange", "double"].contains(f)).collect();
            let default = path("default");
            let export = ["export", "into-cps", scenario, "--out", &default];
            assert_eq!(run(&[&export[..], &flags].concat()).0, 0);
            assert_eq!(text("system/multi-model.json"), text("default/multi-model.json"));
        }
        assert_eq!(text("system/multi-model.json"), text("again/multi-model.json"));
    }
}

#[test]
fn what_is_no_swarm_is_refused_by_name() {
    crate::common::fmu_binary();
    let (_dir, path) = fresh();
    let scenario = "scenarios/paper.toml";
    let export = ["export", "into-cps", scenario, "--exchange", "exact", "--out", &path("")];
    assert_eq!(run(&export).0, 0);
    let model = path("multi-model.json");
    let text = fs::read_to_string(&model).unwrap();
    let mut tried = 0;
    let mut with = |from: &str, to: &str, parts: &[&str]| {
        assert!(text.contains(from), "{from}");
        fs::write(&model, text.replacen(from, to, 1)).unwrap();
        fails(&["cosim", &model], 2, &[&[model.as_str()], parts].concat());
        tried += 1;
    };
    with(r#""size": 0.05"#, r#""size": 0.1"#, &["of size 0.1: expected `fixed-step` of size 0.05"]);
    with(r#""endTime": 25.0"#, r#""endTime": 25.01"#, &["a run from 0 to 25.01 s"]);
    with(
        r#""{cordon_control}.control1.z_d": 1.0"#,
        r#""{cordon_control}.control1.z_d": 2.0"#,
        &["control1.z_d: `2.0`: expected `1`"],
    );
    with(
        r#""{cordon_coordination}.coordination2.id": 2"#,
        r#""{cordon_coordination}.coordination2.id": 3"#,
        &["id: `3` is that of", "too: expected different ones"],
    );
    with(
        r#""{cordon_plant}.plant1.w1""#,
        r#""{cordon_plant}.plant1.w2""#,
        &["a connection from", "control1.w1` to", "plant1.w1` is missing"],
    );
    with(
        r#""{cordon_plant}.plant3.x0": 30.0"#,
        r#""{cordon_plant}.plant3.arm": 0.4"#,
        &["plant3.arm: `0.4`: expected `the start value`"],
    );
    with(r#""{cordon_plant}.plant3.x0""#, r#""{other}.plant3.x0""#, &["expected an FMU among"]);
    with(r#""fmus""#, r#""units""#, &["expected an INTO-CPS multi-model: missing field `fmus`"]);
    fs::write(&model, &text[..text.len() / 2]).unwrap();
    fails(&["cosim", &model], 2, &[&model, "expected an INTO-CPS multi-model: EOF"]);
    fs::write(&model, &text).unwrap();
    fs::remove_file(path("cordon_plant.fmu")).unwrap();
    fails(&["cosim", &model], 74, &["cannot read", "cordon_plant.fmu"]);
    assert_eq!(tried, 8);
}

/// Archives come back as the scenario that they were, protocol files and all; what a system may have
/// besides, and would change the run, is refused by name.
#[test]
fn ssp_archives_are_read_back_or_refused_by_name() {
    crate::common::fmu_binary();
    let (dir, path) = fresh();
    let (a, b, ssp) = (path("a.csv"), path("b.csv"), path("swarm.ssp"));
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/own/weighted-coverage.toml");
    let own = format!(
        "protocol = '{}'\nstart = [0, 0.1, 0.2, 0.3, 1]\nperiod = 2\nphase = \"last\"\n\
         [parameters]\neps = \"1/7\"\n[flight]\nstart = [0, 0.2, 0.3, 0.4, 1]\n",
        file.display()
    );
    fs::write(path("own.toml"), own).unwrap();
    for scenario in [&path("own.toml"), "scenarios/paper.toml"] {
        for exchange in ["exact", "double"] {
            let flags = ["--duration", "3", "--exchange", exchange, "--out"];
            assert_eq!(run(&[&["cosim", scenario], &flags[..], &[&a]].concat()).0, 0);
            let exported = run(&[&["export", "ssp", scenario], &flags[..], &[&ssp]].concat());
            assert_eq!(exported.0, 0, "{}", exported.2);
            let (code, _, err) = run(&["cosim", &ssp, "--out", &b]);
            assert_eq!(code, 0, "{err}");
            assert_eq!(fs::read(&a).unwrap(), fs::read(&b).unwrap(), "{scenario} {exchange}");
        }
    }
    let other = path("other.ssp");
    let with = |from: &str, to: &str| {
        changed(&ssp, Path::new(&other), |name, bytes| {
            let text = || String::from_utf8(bytes.clone()).unwrap();
            let found = name != "SystemStructure.ssd" || text().contains(from);
            assert!(found, "{from}");
            let edit = || text().replacen(from, to, 1).into_bytes();
            let is_text = name == "SystemStructure.ssd";
            Some((name.to_owned(), if is_text { edit() } else { bytes.clone() }))
        });
        run(&["cosim", &other, "--out", &b])
    };
    // Parameters from a file are as good, with a prefix too; nothing said means the default length.
    let component = r#"<ssd:Component name="plant0""#;
    let bound = "<ssd:ParameterBindings><ssd:ParameterBinding source=\"resources/parameters.ssv\"/>\
                 </ssd:ParameterBindings><ssd:Connections>";
    assert_eq!(with("<ssd:Connections>", bound).0, 0);
    assert_eq!(fs::read(&a).unwrap(), fs::read(&b).unwrap());
    assert_eq!(with(r#"stopTime="3""#, "").0, 0);
    assert_eq!(fs::read_to_string(&b).unwrap().lines().count(), 502);
    let mut refused = 0;
    for (from, to, part) in [
        ("<ssd:Elements>", r#"<ssd:Elements><ssd:System name="inner"/>"#, "system `inner`"),
        (
            "<ssd:Elements>",
            r#"<ssd:Elements><ssd:SignalDictionaryReference name="bus"/>"#,
            "signal dictionary `bus`",
        ),
        (
            "application/x-fmu-sharedlibrary",
            "application/x-ssp-package",
            "component `coordination0`: type",
        ),
        (r#""CoSimulation""#, r#""ModelExchange""#, "implementation `ModelExchange`"),
        (
            "resources/cordon_plant.fmu",
            "../plant.fmu",
            "source `../plant.fmu`: expected a file in the archive",
        ),
        ("resources/cordon_plant.fmu", "https://a/b.fmu", "source `https://a/b.fmu`"),
        (component, r#"<ssd:Component name="control0""#, "component `control0` occurs twice"),
        (
            r#"endConnector="w1"/>"#,
            r#"endConnector="w1"><ssc:LinearTransformation factor="2"/></ssd:Connection>"#,
            "plant0.w1`: LinearTransformation: expected none",
        ),
        (
            "<ssd:ParameterValues>",
            "<ssd:ParameterMapping/><ssd:ParameterValues>",
            "ParameterMapping: expected parameters by their own names",
        ),
        (r#"startElement="control0""#, "", "`the system.w1`: expected a connector of a component"),
        ("<ssd:Connections>", &bound.replace("parameters.ssv", "none.ssv"), "resources/none.ssv`"),
        (
            "<ssd:Connections>",
            &bound.replace(" source=", " prefix=\"a.\" source="),
            "`a.coordination0",
        ),
        ("<ssv:Real value=\"", "<ssv:Real value=\"inf\" was=\"", "a finite number"),
        (
            r#"<ssd:DefaultExperiment startTime="0""#,
            r#"<ssd:DefaultExperiment startTime="1""#,
            "a run from 1 to 3 s",
        ),
    ] {
        let (code, out, err) = with(from, to);
        assert_eq!((code, out.as_str()), (2, ""), "{to}: {err}");
        assert!(err.contains(&other) && err.contains(part), "{to}: {err}");
        refused += 1;
    }
    assert_eq!(refused, 14);
    fs::write(&other, "no archive").unwrap();
    fails(&["cosim", &other], 2, &["expected an SSP archive, a whole zip archive"]);
    drop(dir);
}

#[test]
fn an_fmu_carries_protocol_files_only() {
    crate::common::fmu_binary();
    let (_dir, path) = fresh();
    let export = ["fmu", "export", "coordination", "--out", &path("c.fmu")];
    fn with<'a>(export: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
        [export, more].concat()
    }
    fails(&with(&export, &["scenarios/paper.toml"]), 2, &["protocol: expected a protocol file"]);
    fails(
        &with(&export, &["scenarios/consensus.toml"]),
        2,
        &["protocol: `consensus`: expected `coverage`"],
    );
    let ranged = with(&export, &["--protocol", "scenarios/own/digraph.toml"]);
    fails(&ranged, 2, &["parameters.eps: `1/10..1/3`: expected one value in a run"]);
    let plant =
        ["fmu", "export", "plant", "--protocol", "scenarios/own/platoon.toml", "--out", "x"];
    fails(&plant, 2, &["protocol: expected a protocol file"]);
    assert_eq!(run(&[&ranged[..], &["--set", "eps=1/5"]].concat()).0, 0);
    let token =
        Model::PLAIN[0].token(FmiVersion::V2).replace("cordon_coordination", "cordon_protocol");
    let refused = Slave::instantiate(FmiVersion::V2, "it", &token, None).err().unwrap();
    assert!(refused.message.contains("did not say where the resources are"), "{}", refused.message);
    let resources = tempfile::tempdir().unwrap();
    let platoon = models().pop().unwrap();
    for (name, text) in platoon.resources() {
        fs::write(resources.path().join(name), text.replace("4/5", "3/5")).unwrap();
    }
    let token = platoon.token(FmiVersion::V2);
    let at = Some(resources.path());
    let refused = Slave::instantiate(FmiVersion::V2, "it", &token, at).err().unwrap();
    assert!(refused.message.contains("no unit of this binary has it"), "{}", refused.message);
}

#[test]
fn what_other_tools_do_not_have_is_not_exported() {
    crate::common::fmu_binary();
    let (dir, path) = fresh();
    let out = path("x.ssp");
    let consensus = ["export", "ssp", "scenarios/consensus.toml", "--out", &out];
    fails(&consensus, 2, &["protocol: `consensus`: expected `coverage`"]);
    let seidel =
        ["export", "ssp", "scenarios/paper.toml", "--master", "gauss-seidel", "--out", &out];
    fails(&seidel, 2, &["master: `gauss-seidel`: expected `jacobi`"]);
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}

/// An FMU with one file changed, or left out.
fn changed(fmu: &str, out: &Path, change: impl Fn(&str, Vec<u8>) -> Option<(String, Vec<u8>)>) {
    let mut from = ZipArchive::new(Cursor::new(fs::read(fmu).unwrap())).unwrap();
    let mut to = ZipWriter::new(Cursor::new(Vec::new()));
    for i in 0..from.len() {
        let mut file = from.by_index(i).unwrap();
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).unwrap();
        if let Some((name, bytes)) = change(file.name(), bytes) {
            to.start_file(name, SimpleFileOptions::default()).unwrap();
            to.write_all(&bytes).unwrap();
        }
    }
    fs::write(out, to.finish().unwrap().into_inner()).unwrap();
}

#[test]
fn an_fmu_that_cannot_take_a_units_place_is_named_with_the_reason() {
    crate::common::fmu_binary();
    let (dir, path) = fresh();
    let good = path("plant.fmu");
    assert_eq!(run(&["fmu", "export", "plant", "--out", &good]).0, 0);
    let control = path("control.fmu");
    assert_eq!(run(&["fmu", "export", "control", "--out", &control]).0, 0);
    let file = |name: &str| -> PathBuf { dir.path().join(name) };
    let bytes = fs::read(&good).unwrap();
    fs::write(file("cut.fmu"), &bytes[..bytes.len() / 2]).unwrap();
    changed(&good, &file("old.fmu"), |name, bytes| {
        let text = || String::from_utf8(bytes.clone()).unwrap();
        let old = || text().replace(r#"fmiVersion="2.0""#, r#"fmiVersion="1.0""#).into_bytes();
        Some((name.to_owned(), if name.ends_with(".xml") { old() } else { bytes.clone() }))
    });
    changed(&good, &file("windows.fmu"), |name, bytes| {
        Some((name.replace("linux64", "win64").replace(".so", ".dll"), bytes))
    });
    changed(&good, &file("bare.fmu"), |name, bytes| {
        (!name.ends_with(".xml")).then(|| (name.to_owned(), bytes))
    });
    changed(&good, &file("feet.fmu"), |name, bytes| {
        let feet =
            || String::from_utf8_lossy(&bytes).replace(r#"Real unit="m"/"#, r#"Real unit="ft"/"#);
        let xml = name.ends_with(".xml");
        Some((name.to_owned(), if xml { feet().into_bytes() } else { bytes.clone() }))
    });
    let cases: [(&str, i32, &str); 7] = [
        ("none.fmu", 74, "cannot read"),
        ("cut.fmu", 2, "expected an FMU, a whole zip archive"),
        ("old.fmu", 2, "fmiVersion `1.0`: expected 2.0 or 3.0"),
        ("windows.fmu", 2, "a binary for this platform; it has binaries for win64"),
        ("bare.fmu", 2, "expected an FMU with a `modelDescription.xml`"),
        ("control.fmu", 2, "variable `w1`"),
        ("feet.fmu", 2, "`x` is in `ft`: expected `m`"),
    ];
    let run_csv = path("run.csv");
    let scenario = path("s.toml");
    for (name, code, part) in cases {
        let text = format!(
            "start = [0, 1, 3]\nweight = 0.5\n[[unit]]\ndrone = 1\nunit = \"plant\"\nfmu = \"{name}\"\n"
        );
        fs::write(&scenario, text).unwrap();
        fails(&["cosim", &scenario, "--out", &run_csv], code, &[name, part]);
        assert!(!Path::new(&run_csv).exists());
    }
    let unknown =
        "start = [0, 1, 3]\nweight = 0.5\n[[unit]]\ndrone = 1\nunit = \"rotor\"\nfmu = \"x\"\n";
    fs::write(&scenario, unknown).unwrap();
    fails(&["cosim", &scenario], 2, &["s.toml:5:8: unit: `rotor` is unknown"]);
    let beyond = "start = [0, 1, 3]\nweight = 0.5\n[[unit]]\ndrone = 7\nunit = \"plant\"\nfmu = \"plant.fmu\"\n";
    fs::write(&scenario, beyond).unwrap();
    fails(&["cosim", &scenario], 2, &["s.toml:3:1: unit 1: drone `7`: expected 0 to 2"]);
}
