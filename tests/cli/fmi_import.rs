//! FMUs in the place of units.
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::run;

const START: &str = "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n";

#[test]
fn an_fmu_in_the_place_of_any_unit_changes_no_double() {
    crate::common::fmu_binary();
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
    crate::common::fmu_binary();
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

#[test]
fn a_plant_of_another_tool_flies_among_ours() {
    let python = std::env::var("CORDON_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let ask = |code: &str| Command::new(&python).args(["-c", code]).output();
    // The FMU expects a process that has Python in it.
    let library = ask("import pythonfmu, sysconfig; v = sysconfig.get_config_var; \
         print(v('LIBDIR') + '/' + v('LDLIBRARY'))");
    let Some(library) = library.ok().filter(|o| o.status.success()) else {
        let required = std::env::var("CORDON_REQUIRE_TOOLS").is_ok_and(|v| v == "1");
        assert!(!required, "`{python}` cannot import pythonfmu, and tools are required");
        eprintln!("another tool's plant: NOT RUN: `{python}` cannot import pythonfmu");
        return;
    };
    let library = String::from_utf8(library.stdout).unwrap().trim().to_owned();
    let dir = tempfile::tempdir().unwrap();
    let built = Command::new(&python)
        .args(["-m", "pythonfmu", "build", "-f", "tests/fmpy/glider.py", "-d"])
        .arg(dir.path())
        .output()
        .unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    // Several at once, of which each wants its process to have one Python.
    let glider = |drone: usize| {
        format!("[[unit]]\ndrone = {drone}\nunit = \"plant\"\nfmu = \"Glider.fmu\"\n")
    };
    let text = format!("{START}{}{}{}", glider(0), glider(1), glider(2));
    fs::write(dir.path().join("s.toml"), text).unwrap();
    for mode in [&[][..], &["--in-process"]] {
        glides(&library, dir.path(), mode);
    }
}

/// Flies the scenario; drone 0 glides, and drone 3 flies on.
fn glides(library: &str, dir: &Path, mode: &[&str]) {
    let csv = dir.join("out.csv");
    let flown = crate::common::cordon()
        .env("LD_PRELOAD", library)
        .arg("cosim")
        .arg(dir.join("s.toml"))
        .args(mode)
        .args(["--duration", "1", "--out"])
        .arg(&csv)
        .output()
        .unwrap();
    assert!(flown.status.success(), "{}", String::from_utf8_lossy(&flown.stderr));
    let csv = fs::read_to_string(csv).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0][6]), (22, "x0"));
    let mut x = 0.0;
    for row in &rows[1..] {
        assert_eq!(row[6].parse(), Ok(x), "the glider");
        x += 0.05 * 1.0;
    }
    // Our drone 3 flies on as in the paper's table.
    assert!(rows[21][9].starts_with("30.32"), "{}", rows[21][9]);
}
