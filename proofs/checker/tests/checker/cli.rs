//! The program `cordon-check` from the command line.

use assert_cmd::Command;

fn cordon_check(files: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("cordon-check")
        .unwrap()
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .args(files)
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

const GOOD: &str = "certificates/7.3-sharp.json";
const INVALID: &str = "must-not-prove/positivity-sides-differ.json";
const UNREADABLE: &str = "must-not-prove/format-schema.json";

/// How many verdicts there are: what is proved has further lines, which are indented.
fn verdicts(out: &str) -> usize {
    out.lines().filter(|line| !line.starts_with("  ")).count()
}

#[test]
fn each_verdict_has_its_exit_code() {
    let cases = [(GOOD, 0), (UNREADABLE, 2), (INVALID, 4)];
    for (file, code) in cases {
        let (status, out, err) = cordon_check(&[file]);
        assert_eq!((status, err.as_str()), (code, ""), "{file}");
        assert!(out.starts_with(&format!("{file}: ")) && verdicts(&out) == 1, "{out}");
    }
    let (status, out, err) = cordon_check(&["no-such-file.json"]);
    assert_eq!((status, out.as_str()), (74, ""));
    assert!(err.contains("cannot read `no-such-file.json`"), "{err}");
}

#[test]
fn the_worst_verdict_decides() {
    assert_eq!(cordon_check(&[GOOD, UNREADABLE, GOOD]).0, 2);
    assert_eq!(cordon_check(&[GOOD, INVALID, UNREADABLE]).0, 4);
    let (status, out, _) = cordon_check(&[INVALID, "no-such-file.json", GOOD]);
    assert_eq!((status, verdicts(&out)), (74, 2));
}

#[test]
fn the_step_and_the_rule_are_named() {
    let (_, out, _) = cordon_check(&[INVALID]);
    assert!(out.contains("invalid: GOAL: rule positivity: the sides differ"), "{out}");
}

#[test]
fn usage_goes_to_stderr() {
    for arguments in [&[][..], &["--help"][..]] {
        let (status, out, err) = cordon_check(arguments);
        assert_eq!((status, out.as_str()), (2, ""));
        assert!(err.contains("usage: cordon-check FILE..."));
    }
}

#[cfg(unix)]
#[test]
fn an_endless_file_is_not_read_to_its_end() {
    let (status, out, _) = cordon_check(&["/dev/zero"]);
    assert_eq!(status, 2, "{out}");
    assert!(out.contains("at most 4194304 are read"), "{out}");
}
