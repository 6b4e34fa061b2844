//! Files that are read: huge ones, other kinds, marks, characters that are not shown.
use std::fs;
use std::io::Write;
use std::path::Path;

use super::files::Folder;
use crate::common::{cordon, run};
use cordon_core::text::is_harmful;

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
    // A run that was recorded elsewhere: its page shows none.
    let (recorded, page) = (folder.name("run.json"), folder.name("page.html"));
    assert_eq!(run(&["cosim", "scenarios/paper.toml", "--duration", "1", "--out", &recorded]).0, 0);
    let mut json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&recorded).unwrap()).unwrap();
    json["title"] = serde_json::json!("x\u{202e}y\u{1b}[31m");
    fs::write(&recorded, json.to_string()).unwrap();
    let (code, out, err) = run(&["replay", &recorded, "--out", &page]);
    assert!(code == 0 && clean(&out) && clean(&err), "{out}{err}");
    let shown = fs::read_to_string(&page).unwrap();
    assert!(clean(&shown) && shown.contains("x\u{fffd}y\u{fffd}[31m"));
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
