//! Files that are written as users have them: links, pipes, read-only ones, inputs.
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::{cordon, run};
use tempfile::TempDir;

pub(super) struct Folder(pub(super) TempDir);

impl Folder {
    pub(super) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(super) fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(super) fn with(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        let path = self.at(name);
        fs::write(&path, content).unwrap();
        path.display().to_string()
    }

    pub(super) fn name(&self, name: &str) -> String {
        self.at(name).display().to_string()
    }
}

fn export(out: &str) -> (i32, String, String) {
    run(&["export", "smt2", "7.2", "--drones", "3", "--out", out])
}

fn exported() -> String {
    run(&["export", "smt2", "7.2", "--drones", "3"]).1
}

#[cfg(unix)]
fn mode(path: &Path) -> u32 {
    use std::os::unix::fs::PermissionsExt;
    fs::metadata(path).unwrap().permissions().mode() & 0o777
}

#[cfg(unix)]
fn set_mode(path: &Path, mode: u32) {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_modes_kept() {
    let folder = Folder::new();
    fs::create_dir(folder.at("sub")).unwrap();
    std::os::unix::fs::symlink("sub/real", folder.at("link")).unwrap();
    std::os::unix::fs::symlink("link", folder.at("link-to-link")).unwrap();
    // The end of the links need not exist.
    assert_eq!(export(&folder.name("link-to-link")).0, 0);
    assert_eq!(fs::read_to_string(folder.at("sub/real")).unwrap(), exported());
    set_mode(&folder.at("sub/real"), 0o600);
    fs::write(folder.at("sub/real"), "old").unwrap();
    assert_eq!(export(&folder.name("link")).0, 0);
    assert_eq!(fs::read_to_string(folder.at("sub/real")).unwrap(), exported());
    assert_eq!(mode(&folder.at("sub/real")), 0o600);
    assert!(fs::symlink_metadata(folder.at("link")).unwrap().is_symlink());
    std::os::unix::fs::symlink("round", folder.at("round")).unwrap();
    assert_eq!(export(&folder.name("round")).0, 74);
    assert_eq!(fs::read_dir(folder.0.path()).unwrap().count(), 4, "nothing temporary is left");
}

#[cfg(unix)]
#[test]
fn a_read_only_file_is_refused_before_any_work() {
    let folder = Folder::new();
    let out = folder.with("kept", "old");
    set_mode(&folder.at("kept"), 0o444);
    let (code, printed, err) = export(&out);
    assert_eq!((code, printed.as_str()), (74, ""));
    assert!(err.contains("cannot write") && err.contains("read-only"), "{err}");
    assert_eq!(fs::read_to_string(&out).unwrap(), "old");
    let (code, ..) = run(&["sweep", "7.2", "--drones", "3", "--out", &out]);
    assert_eq!(code, 74);
    set_mode(&folder.at("kept"), 0o644);
    assert_eq!(export(&out).0, 0);
}

#[cfg(unix)]
#[test]
fn pipes_and_devices_are_written_through() {
    let folder = Folder::new();
    let pipe = folder.name("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = {
        let pipe = pipe.clone();
        std::thread::spawn(move || fs::read_to_string(pipe).unwrap())
    };
    assert_eq!(export(&pipe).0, 0);
    assert_eq!(reader.join().unwrap(), exported());
    assert!(!fs::symlink_metadata(&pipe).unwrap().is_file());
    assert_eq!(export("/dev/null").0, 0);
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
    assert_eq!(export("/dev/full").0, 74);
}

#[test]
fn stdout_is_a_dash_and_carries_the_file_alone() {
    let whole = run(&["cosim", "scenarios/paper.toml", "--format", "csv"]);
    let names = if cfg!(unix) { &["-", "/dev/stdout"][..] } else { &["-"] };
    for name in names {
        let (code, out, err) = run(&["cosim", "scenarios/paper.toml", "--out", name]);
        assert_eq!((code, &out), (0, &whole.1), "{name}");
        assert!(err.contains("the paper's coverage run"), "{err}");
    }
    // Redirected to a file, `/dev/stdout` is that file, and is not replaced.
    if cfg!(unix) {
        let folder = Folder::new();
        let file = fs::File::create(folder.at("out.csv")).unwrap();
        let args = ["cosim", "scenarios/paper.toml", "--out", "/dev/stdout"];
        let mut command = std::process::Command::new(cordon().get_program());
        command.args(args).stdout(file);
        assert!(command.stderr(std::process::Stdio::null()).status().unwrap().success());
        assert_eq!(fs::read_to_string(folder.at("out.csv")).unwrap(), whole.1);
    }
    let (code, _, err) = run(&["figures", "8", "--out", "-"]);
    assert_eq!(code, 2);
    assert!(err.contains("--out: `-`: expected a folder"), "{err}");
}

#[test]
fn an_input_is_never_the_output() {
    let folder = Folder::new();
    let scenario = fs::read("scenarios/paper.toml").unwrap();
    let input = folder.with("self.toml", &scenario);
    let other = format!(
        "{}/../{}/self.toml",
        folder.0.path().display(),
        folder.0.path().file_name().unwrap().to_str().unwrap()
    );
    let run_file = folder.name("run.csv");
    assert_eq!(run(&["cosim", &input, "--out", &run_file]).0, 0);
    let merged = folder.name("sweep.jsonl");
    assert_eq!(
        run(&[
            "sweep", "7.2", "--form", "sharp", "--drones", "3", "--grid", "2", "--steps", "2",
            "--out", &merged
        ])
        .0,
        0
    );
    let calls: [&[&str]; 5] = [
        &["cosim", &input, "--out", &input],
        &["cosim", &input, "--out", &other],
        &["replay", &input, "--out", &input],
        &["replay", &run_file, "--out", &run_file],
        &["sweep", "merge", &merged, "--out", &merged],
    ];
    for call in calls {
        let (code, out, err) = run(call);
        assert_eq!((code, out.as_str()), (2, ""), "{call:?}");
        assert!(
            err.contains("--out: `") && err.contains("expected another file than the input"),
            "{err}"
        );
    }
    assert_eq!(fs::read(&input).unwrap(), scenario);
}

/// What a scenario names is an input too, by whichever name, and so is what stands beside a run.
#[test]
fn what_a_scenario_names_is_never_the_output() {
    let folder = Folder::new();
    let fmu = folder.with("glider.csv", "no FMU, and not looked at before the output is");
    let scenario = "start = [0, 10, 20, 30, 100]\nweight = 0.2\n[[unit]]\ndrone = 1\nunit = \"plant\"\nfmu = \"glider.csv\"\n";
    let input = folder.with("s.toml", scenario);
    // The companion of `s.csv` would be `s.csv.json`.
    let companion = folder.with("s.csv.json", "a file that is no input");
    let beside = folder.with("t.csv.json", "{\"fmus\": {}, \"connections\": {}}");
    let page = folder.name("page.html");
    let calls: [&[&str]; 3] = [
        &["cosim", &input, "--out", &fmu],
        &["cosim", &input, "--format", "json", "--out", &fmu],
        &["replay", &input, "--out", &fmu],
    ];
    for call in calls {
        let (code, out, err) = run(call);
        assert_eq!((code, out.as_str()), (2, ""), "{call:?}");
        assert!(err.contains("--out: `") && err.contains("inputs of the command"), "{err}");
    }
    assert!(fs::read_to_string(&fmu).unwrap().starts_with("no FMU"));
    // Twins that are accepted: another file; a companion that nobody reads.
    let (code, _, err) = run(&["replay", &input, "--out", &page]);
    assert!(code == 2 && err.contains("expected an FMU, a whole zip archive"), "{err}");
    let own = folder.with("own.toml", "start = [0, 10, 20, 30, 100]\nweight = 0.2\n");
    assert_eq!(run(&["cosim", &own, "--out", &folder.name("s.csv")]).0, 0);
    assert!(fs::read_to_string(companion).unwrap().contains("cordon-cosim-companion/1"));
    // A multi-model beside the run that would take its place.
    let (code, _, _) = run(&["cosim", &beside, "--out", &folder.name("t.csv")]);
    assert_eq!(code, 2);
    assert!(fs::read_to_string(&beside).unwrap().contains("fmus"));
}

#[test]
fn the_name_of_a_run_file_says_its_form() {
    let folder = Folder::new();
    let flown = |name: &str, more: &[&str]| {
        let out = folder.name(name);
        run(&[&["cosim", "scenarios/paper.toml", "--duration", "1", "--out", &out], more].concat())
    };
    assert_eq!(flown("run.JSON", &[]).0, 0);
    assert!(fs::read_to_string(folder.at("run.JSON")).unwrap().contains("cordon-cosim/1"));
    assert_eq!(run(&["replay", &folder.name("run.JSON"), "--out", &folder.name("p.html")]).0, 0);
    let (code, _, err) = flown("run.txt", &[]);
    assert_eq!((code, folder.at("run.txt").exists()), (2, false));
    assert!(err.contains("run.txt`: expected a name that ends in .csv, .json or"), "{err}");
    assert_eq!(flown("run.txt", &["--format", "csv"]).0, 0);
    assert_eq!(flown("run", &[]).0, 0);
    assert!(fs::read_to_string(folder.at("run")).unwrap().starts_with("time,"));
}

#[test]
fn a_replay_line_can_be_pasted_into_a_shell() {
    let folder = Folder::new();
    let text = fs::read("scenarios/own/hasty-coverage.toml").unwrap();
    let path = folder.with("it's hasty.toml", text);
    let (code, out, err) = run(&["refute", "--protocol", &path]);
    assert_eq!(code, 1, "{err}");
    let line = out.lines().find_map(|l| l.trim().strip_prefix("replay: cordon ")).unwrap();
    let program = cordon().get_program().to_owned();
    let shell = format!("exec \"$0\" {line}");
    let again =
        std::process::Command::new("sh").arg("-c").arg(shell).arg(program).output().unwrap();
    assert_eq!(again.status.code(), Some(1), "{}", String::from_utf8_lossy(&again.stderr));
}

/// What refutes an own protocol is a file that the independent checker runs again.
#[test]
fn counterexamples_of_own_protocols_are_certificates() {
    let folder = Folder::new();
    let cases = [
        // A constant; skipped updates and lost links, chosen in each step; late messages.
        ("hasty-coverage.toml", "", "in every step eps = "),
        ("coverage-with-losses.toml", "eps=3/5", "in every step eps = 3/5"),
        ("coverage-late.toml", "eps=3/5", "assuming of the start: "),
        ("weighted-coverage.toml", "eps=2", "refuted at step 1: "),
    ];
    for (name, set, said) in cases {
        let (own, file) = (format!("scenarios/own/{name}"), folder.name("refuted.json"));
        let set = if set.is_empty() { vec![] } else { vec!["--set", set] };
        let mut line = vec!["refute", "--protocol", &own, "--out", &file];
        line.extend(&set);
        let (code, out, err) = run(&line);
        assert_eq!(code, 1, "{name}: {out}{err}");
        assert!(out.ends_with(&format!("\n  wrote {file}\n")), "{name}: {out}");
        let (code, out, err) = run(&["check", &file]);
        assert_eq!(code, 0, "{name}: {out}{err}");
        assert!(out.contains(": valid: a linear system of ") && out.contains(said), "{out}");
        assert!(out.contains("\n  refuted at step "), "{out}");
        // The claim as it fails, turned round, does not fail.
        let text = fs::read_to_string(&file).unwrap();
        let mut page: serde_json::Value = serde_json::from_str(&text).unwrap();
        let claim = &mut page["certificate"]["counterexample"]["claim"];
        let is = claim.as_str().unwrap();
        let turned = match is.strip_suffix(">= 0") {
            Some(form) => format!("{form}< 0"),
            None => is.replace("> 0", "<= 0"),
        };
        *claim = serde_json::json!(turned);
        let forged = folder.with("forged.json", page.to_string());
        let (code, out, _) = run(&["check", &forged]);
        assert_eq!(code, 4, "{out}");
        assert!(out.contains("the claim holds"), "{out}");
        // In JSON the file is named.
        line.extend(["--format", "json"]);
        let page: serde_json::Value = serde_json::from_str(&run(&line).1).unwrap();
        assert_eq!(page["claims"]["file"], file);
        if !["hasty-coverage.toml", "weighted-coverage.toml"].contains(&name) {
            continue;
        }
        // What is searched where a proof is missing goes into the folder of `prove`.
        let proofs = folder.name("proofs");
        let mut line = vec!["prove", "--protocol", &own, "--out", &proofs];
        line.extend(&set);
        let (code, out, err) = run(&line);
        assert_eq!(code, 1, "{name}: {out}{err}");
        let file = format!("{proofs}/{}-refuted.json", name.trim_end_matches(".toml"));
        assert!(out.contains(&format!("  wrote {file}\n")), "{out}");
        assert_eq!(run(&["check", &file]).0, 0);
    }
    // Where nothing is refuted nothing is written.
    let file = folder.name("none.json");
    let own = "scenarios/own/weighted-coverage.toml";
    let (code, out, _) = run(&["refute", "--protocol", own, "--out", &file]);
    assert_eq!(code, 3, "{out}");
    assert!(!std::path::Path::new(&file).exists());
    let nowhere = folder.name("no/such/folder.json");
    let own = "scenarios/own/hasty-coverage.toml";
    let (code, out, err) = run(&["refute", "--protocol", own, "--out", &nowhere]);
    assert_eq!((code, out.as_str()), (74, ""), "{err}");
}

/// Nothing is said of what could not be written: neither where that is seen before any work, nor after it.
#[cfg(unix)]
#[test]
fn what_cannot_be_written_leaves_stdout_empty() {
    let folder = Folder::new();
    let file = folder.with("file", "not a folder");
    let (within, missing) = (folder.name("file/within"), folder.name("no/such/x.csv"));
    let own = ["--protocol", "scenarios/own/hasty-coverage.toml"];
    let converges = ["--protocol", "scenarios/own/digraph.toml"];
    // The command, whether it writes a folder.
    let calls: [(&[&str], bool); 14] = [
        (&["refute", own[0], own[1]], false),
        (&["refute", "7.2", "--eps", "3/5", "--drones", "4"], false),
        (&["cosim", "scenarios/paper.toml", "--duration", "1"], false),
        (&["replay", "scenarios/paper.toml"], false),
        (&["export", "smt2", "7.2", "--drones", "3"], false),
        (&["sweep", "7.2", "--drones", "3", "--grid", "2", "--steps", "2"], false),
        (&["prove", own[0], own[1]], true),
        (&["prove", "7.2"], true),
        (&["threshold", own[0], own[1], "--digits", "1"], true),
        (&["threshold", "--property", "ordering", "--drones", "4"], true),
        (&["settle", converges[0], converges[1], "--within", "1/10"], true),
        (&["separation", "scenarios/paper.toml"], true),
        (&["export", "pvs"], true),
        (&["sweep", "7.2", "--drones", "3", "--submit", "slurm", "--shards", "1"], true),
    ];
    for (call, is_folder) in calls {
        let out_to = |out: &str| run(&[call, &["--out", out]].concat());
        let (code, out, err) = out_to(if is_folder { &file } else { &missing });
        assert_eq!(out, "", "{call:?}");
        let why = if is_folder { "a file: expected a folder" } else { "there is no such folder" };
        assert!(code == 74 && err.contains(why), "{call:?}: {code}: {err}");
        let (code, out, err) = out_to(&within);
        assert!(code != 0 && out.is_empty() && err.contains("file/within"), "{call:?}: {err}");
        // Found out after the work. A sweep's result file is no device.
        if !is_folder && call[0] != "sweep" {
            let (code, out, err) = out_to("/dev/full");
            assert_eq!((code, out.as_str()), (74, ""), "{call:?}: {err}");
        }
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "not a folder");
    // The twin.
    let written = folder.name("new/folder");
    let (code, out, _) = run(&["prove", own[0], own[1], "--out", &written]);
    assert!(code == 1 && out.contains("  wrote "), "{out}");
    // A folder where a file is expected.
    let (code, out, err) = run(&["refute", own[0], own[1], "--out", &written]);
    assert_eq!((code, out.as_str()), (74, ""));
    assert!(err.contains("a folder: expected a file"), "{err}");
}
