//! Files as users have them: links, pipes, read-only ones, huge ones, with marks and control
//! characters inside.
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::common::{cordon, run};
use cordon_core::text::is_harmful;
use tempfile::TempDir;

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn with(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        let path = self.at(name);
        fs::write(&path, content).unwrap();
        path.display().to_string()
    }

    fn name(&self, name: &str) -> String {
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
fn reading_has_a_limit() {
    let folder = Folder::new();
    let path = folder.name("big.toml");
    fs::File::create(&path).unwrap().set_len(200_000_000).unwrap();
    let files = if cfg!(unix) { vec![path.as_str(), "/dev/zero"] } else { vec![path.as_str()] };
    for file in files {
        for (command, what) in
            [("trace", "a scenario of at most 64 MiB"), ("prove", "a protocol of at most 4 MiB")]
        {
            let args: &[&str] =
                if command == "prove" { &["prove", "--protocol", file] } else { &["trace", file] };
            let (code, out, err) = run(args);
            assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
            assert!(err.contains(&format!("`{file}`: expected {what}")), "{err}");
        }
    }
    let mut program = fs::File::create(folder.at("program")).unwrap();
    program.write_all(b"\x7fELF").unwrap();
    program.set_len(200_000_000).unwrap();
    let (_, _, err) = run(&["trace", &folder.name("program")]);
    assert!(
        err.contains("program`: a program or library: expected a scenario of at most"),
        "{err}"
    );
    // What is not too large is read, from a pipe too.
    let mut child = std::process::Command::new(cordon().get_program())
        .args(["trace", "-", "--steps", "1"])
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&fs::read("scenarios/paper.toml").unwrap()).unwrap();
    assert!(child.wait_with_output().unwrap().status.success());
}

#[test]
fn what_is_not_shown_steers_no_terminal() {
    let folder = Folder::new();
    let clean = |text: &str| !text.chars().any(|c| c != '\n' && is_harmful(c));
    let scenario = |title: &str| {
        format!("title = \"{title}\"\nstart = [0, 10, 20, 30, 100]\nweight = \"1/5\"\n")
    };
    let protocol = |title: &str| {
        let text = fs::read_to_string("scenarios/own/two-modes.toml").unwrap();
        let (before, _) = text.split_once("title = ").unwrap();
        let after = text.split_once("title = ").unwrap().1.split_once('\n').unwrap().1;
        format!("{before}title = \"{title}\"\n{after}")
    };
    let mut refused = 0;
    for (hidden, name) in [
        ("\\u001b[31m", "U+001B"),
        ("\\u009b", "U+009B"),
        ("\\u202e", "U+202E"),
        ("\u{202e}", "U+202E"),
        ("\u{2066}", "U+2066"),
        ("\u{200b}", "U+200B"),
        ("\\U000E0041", "U+E0041"),
    ] {
        let title = format!("x{hidden}y");
        let page = folder.name("page.html");
        let s = folder.with("s.toml", scenario(&title));
        let p = folder.with("p.toml", protocol(&title));
        let calls: [&[&str]; 4] = [
            &["trace", &s],
            &["replay", &s, "--out", &page],
            &["prove", "--protocol", &p],
            &["trace", "--protocol", &p, "--start", "0,0,0"],
        ];
        for call in calls {
            let (code, out, err) = run(call);
            assert_eq!((code, out.as_str()), (2, ""), "{call:?}");
            let place = err.contains("s.toml:1:") || err.contains("p.toml:");
            assert!(place && err.contains(name) && clean(&err), "{err}");
            refused += 1;
        }
        assert!(!Path::new(&page).exists());
    }
    assert_eq!(refused, 7 * 4);
    // In names, in comments, and a title that would look like lines of its own.
    let named = scenario("x") + "[parameters]\n\"a\\u202eb\" = 1\n";
    for (text, said) in [
        (named, ":5:1: a key: U+202E"),
        (scenario("x") + "# a\u{202e}b\n", ":4:4: U+202E"),
        (scenario("x\\n  proved"), ":1:9: title: expected one line"),
    ] {
        let (code, _, err) = run(&["trace", &folder.with("s.toml", &text)]);
        assert!(code == 2 && err.contains(said), "{text}: {err}");
    }
    // Twins that are accepted: letters of any script, and what joins them.
    for title in ["Größe 中 \u{645}\u{6cc}\u{200c}\u{62e}", "x"] {
        let (code, out, err) = run(&["trace", &folder.with("s.toml", scenario(title))]);
        assert!(code == 0 && out.starts_with(&format!("{title}\n")), "{out}{err}");
    }
    // What is typed is shown without it.
    for args in [
        &["trace", "no-\u{1b}[31m-such.toml"][..],
        &["trace", "no-\u{202e}-such.toml"],
        &["trace", "--start", "0,\u{202e}1,2", "--eps", "1/3"],
        &["prove", "7.2\u{202e}"],
        &["tr\u{202e}ace"],
        &["trace", "--\u{202e}"],
    ] {
        let (code, out, err) = run(args);
        assert!((code == 2 || code == 74) && out.is_empty(), "{args:?}");
        assert!(clean(&err) && err.contains('\u{fffd}'), "{args:?}: {err}");
    }
}

#[test]
fn byte_order_marks_are_no_columns() {
    let folder = Folder::new();
    let (_, csv, _) = run(&["cosim", "scenarios/paper.toml", "--format", "csv"]);
    let run_file = folder.with("run.csv", format!("\u{feff}{csv}"));
    assert_eq!(run(&["replay", &run_file, "--out", &folder.name("page.html")]).0, 0);
    let scenario = fs::read_to_string("scenarios/paper.toml").unwrap();
    let marked = folder.with("marked.toml", format!("\u{feff}{scenario}"));
    assert_eq!(run(&["trace", &marked]).0, 0);
}

#[test]
fn numbers_of_any_size_are_read_exactly() {
    let folder = Folder::new();
    let large = format!("1{}", "0".repeat(309));
    let text = format!(
        "start = [0, 1e309, 0x{}, -0.5e-400, {large}]\nweight = 0.2\nprotocol = \"consensus\"\n",
        "f".repeat(40)
    );
    let path = folder.with("large.toml", text);
    let (code, out, err) =
        run(&["trace", &path, "--steps", "0", "--format", "csv", "--numbers", "fraction"]);
    assert_eq!(code, 0, "{err}");
    let row = out.lines().last().unwrap();
    assert!(row.contains(&format!(",{large},")), "{row}");
    // 16^40 - 1, and 5/10^401 in lowest terms.
    assert!(row.contains(",1461501637330902918203684832716283019655932542975,"), "{row}");
    assert!(row.contains(&format!(",-1/2{},", "0".repeat(400))), "{row}");
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

/// What was found, and what was expected.
#[test]
fn another_kind_of_file_is_named() {
    let folder = Folder::new();
    let fmu = folder.with("own.fmu", b"PK\x03\x04\x14\x00\xff\xfe");
    let program = folder.with("program", b"\x7fELF\x02\x01\x00\x00");
    let other = folder.with("other", b"a\x00\x01\xff");
    let empty = folder.with("empty.toml", " \n");
    let table = folder.with("run.csv", "time,x0,x1\n0,1,2\n");
    let page = folder.with("page.html", "<!doctype html>");
    let json = folder.with("json.toml", "{ \"schema\": \"cordon-certificate/2\" }");
    let directory = folder.0.path().display().to_string();
    let (scenario, protocol) = ("scenarios/paper.toml", "scenarios/own/coverage.toml");
    let mut tried = 0;
    for (file, found) in [
        (fmu.as_str(), "a zip archive, as FMUs are"),
        (&program, "a program or library"),
        (&other, "a binary file"),
        (&empty, "empty"),
        (&table, "a table in CSV"),
        (&page, "XML or HTML"),
        (&json, "JSON"),
        (&directory, "a folder"),
    ] {
        for (call, expected) in [
            (vec!["trace", file], "expected a scenario"),
            (vec!["prove", "--protocol", file], "expected a protocol"),
        ] {
            let (code, out, err) = run(&call);
            assert!((code == 2 || code == 74) && out.is_empty(), "{call:?}");
            assert!(err.contains(&format!("{found}: {expected}")), "{call:?}: {err}");
            tried += 1;
        }
    }
    assert_eq!(tried, 16);
    // Files that only programs write.
    let start = "start = [0, 1, 3]\nweight = 0.5\n[[unit]]\ndrone = 1\nunit = \"plant\"\nfmu = ";
    let unit = |fmu: &str| folder.with("unit.toml", format!("{start}'{fmu}'\n"));
    let html = folder.name("page.html");
    let system = folder.with("x.ssp", "no archive");
    let model = folder.with("model.json", "title = 1");
    let nothing = folder.with("nothing.json", "");
    fs::create_dir(folder.at("folder.ssp")).unwrap();
    let folder_as_system = folder.name("folder.ssp");
    for (call, said) in [
        (vec!["cosim", &system], "x.ssp`: no zip archive: expected an SSP archive"),
        (vec!["cosim", &folder_as_system], "folder.ssp`: a folder: expected an SSP archive"),
        (vec!["cosim", &unit(&table)], "run.csv`: no zip archive: expected an FMU"),
        (vec!["cosim", &model], "model.json`: no JSON: expected a multi-model"),
        (vec!["cosim", &nothing], "nothing.json`: empty: expected a multi-model"),
        (vec!["replay", &nothing, "--out", &html], "nothing.json`: empty: expected a whole run"),
        (vec!["check", protocol], "coverage.toml`: expected a certificate, which is JSON"),
    ] {
        let (code, _, err) = run(&call);
        assert!((code == 2 || code == 74) && err.contains(said), "{call:?}: {err}");
    }
    let (_, _, err) = run(&["cosim", protocol]);
    assert!(err.contains("coverage.toml: a protocol file: expected a scenario"), "{err}");
    let start_only = folder.with("s.toml", "start = [0, 1, 2]\neps = 0.2\n");
    for file in [scenario, &start_only] {
        let (code, _, err) = run(&["prove", "--protocol", file]);
        assert!(code == 2 && err.contains(": a scenario: expected a protocol file"), "{err}");
    }
}
