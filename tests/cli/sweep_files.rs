//! The result files of sweeps: continued, damaged, of another sweep.
use std::fs;
use std::path::Path;

use super::sweep::{SMALL, refused, sweep};

pub(super) fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

#[test]
fn a_killed_sweep_goes_on_where_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.jsonl");
    let args = format!("{SMALL} --out {}", path.display());
    let (_, report, _) = sweep(&args);
    let whole = text(&path);
    let header = whole.lines().next().unwrap().len() + 1;
    let mut resumed = 0;
    // Killed right after the header, within a line, before a line's end, after a line.
    let fifth: usize = whole.lines().take(5).map(|l| l.len() + 1).sum();
    for cut in [header, header + 1, fifth - 1, fifth, whole.len() - 1] {
        fs::write(&path, &whole[..cut]).unwrap();
        let (code, out, err) = sweep(&args);
        assert_eq!((code, &out), (1, &report), "{err}");
        assert_eq!(text(&path), whole, "cut at {cut}");
        resumed += usize::from(err.contains("work items were finished before"));
    }
    assert_eq!(resumed, 3);
    // A finished one is only reported.
    let (code, out, err) = sweep(&args);
    assert_eq!((code, out), (1, report));
    assert!(
        err.starts_with("resumed: 57 work items were finished before\n0 drone updates"),
        "{err}"
    );
    assert_eq!(text(&path), whole);
}

#[test]
fn another_configuration_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.jsonl");
    let out = format!("--out {}", path.display());
    sweep(&format!("7.2 --eps 1/3 --steps 5 {out}"));
    let before = text(&path);
    refused(
        &format!("7.2 --eps 1/3 --steps 6 {out}"),
        "holds another sweep: steps is 5 there and 6 here",
    );
    refused(&format!("7.2 --eps 1/4 --steps 5 {out}"), "holds another sweep: weights is ");
    refused(
        &format!("7.2 --eps 1/3 --steps 5 --shard 1/2 {out}"),
        "shard is 1/1 there and 1/2 here",
    );
    refused(&format!("7.3 --eps 1/3 --steps 5 {out}"), "holds another sweep: theorems is ");
    assert_eq!(text(&path), before);
}

#[test]
fn damaged_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.jsonl");
    let args = format!("7.2 --eps 1/4 --steps 5 --out {}", path.display());
    sweep(&args);
    let whole = text(&path);
    let lines: Vec<_> = whole.lines().collect();
    let check = |content: String, says: &str| {
        fs::write(&path, &content).unwrap();
        refused(&args, says);
        assert_eq!(text(&path), content);
    };
    check("hello\n".into(), "line 1: expected the header of a result file");
    check(
        "{\"schema\":\"cordon-sweep/2\"}\n".into(),
        "line 1: schema `cordon-sweep/2`: expected `cordon-sweep/1`",
    );
    check("{\"schema\":\"cordon-sweep/1\"}\n".into(), "line 1: bad header: missing field");
    check(format!("{}\n{{}}\n{}\n", lines[0], lines[1]), "line 2: expected a finding of a sweep");
    check(
        format!("{}\n{}\n", lines[0], lines[2]),
        "line 2: work item 1 is out of place: expected item 0",
    );
    check(
        format!("{}\n{}\n{}\n", lines[0], lines[1], lines[1]),
        "line 3: work item 0 is out of place: expected item 1",
    );
    check(format!("{whole}{}\n", lines[1]), "work item 0 is out of place: expected no more");
    // An empty file is a sweep not begun.
    fs::write(&path, "").unwrap();
    assert_eq!(sweep(&args).0, 0);
    assert_eq!(text(&path), whole);
}

/// Every line is held against the configuration and against itself, in merging and resuming.
#[test]
fn lines_that_cannot_be_so_are_refused_by_their_number() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let sound = "7.3 --form sharp --drones 3..4 --eps 0,1/2 --grid 4 --steps 5";
    let refuted = "7.6ii --form paper --drones 3 --eps 0,1/5 --grid 4 --steps 5";
    let complete = "7.3 --form sharp --drones 3 --eps 1/2 --complete --steps 5";
    let sampled = "7.3 --form sharp --drones 3 --eps 1/2 --grid 9 --sample 20 --seed 1 --steps 5";
    let cases = [
        (sound, 2, "\"violations\":0", "\"violations\":7", "verdict `holds`: expected `refuted`"),
        (
            sound,
            3,
            "\"verdict\":\"holds\"",
            "\"verdict\":\"refuted\"",
            "verdict `refuted`: expected `holds`",
        ),
        (
            sound,
            3,
            "\"verdict\":\"holds\"",
            "\"verdict\":\"vacuous\"",
            "verdict `vacuous`: expected `holds`",
        ),
        (
            sound,
            2,
            "\"non_vacuous\":",
            "\"non_vacuous\":9",
            " non-vacuous and 0 undecided cases: expected at most ",
        ),
        (sound, 2, "\"undecided\":0", "\"undecided\":1", " non-vacuous and 1 undecided cases"),
        (
            sound,
            2,
            "\"violations\":0",
            "\"violations\":7777",
            "7777 violations: expected at most as many",
        ),
        (sound, 2, "\"cases\":", "\"cases\":1", " cases: expected "),
        (sound, 2, "\"starts\":", "\"starts\":1", " starts: expected "),
        (sound, 2, "\"updates\":", "\"updates\":999", " updates: expected at most "),
        (
            sound,
            2,
            "exhaustive on a grid",
            "complete for all starts",
            "evidence `complete for all starts`: expected `exhaustive on a grid`",
        ),
        (sound, 2, "\"segment\":", "\"segment\":1", "segment 1"),
        (
            refuted,
            2,
            "\"verdict\":\"refuted\"",
            "\"verdict\":\"holds\"",
            "verdict `holds`: expected `refuted`",
        ),
        (refuted, 2, "\"start\":[\"0\",\"", "\"start\":[\"0\",\"1/3", "counterexample: "),
        (refuted, 2, "\"violation\":\"", "\"violation\":\"not ", "counterexample: expected `"),
        (
            complete,
            2,
            "complete for all starts",
            "sampled",
            "evidence `sampled`: expected `complete for all starts`",
        ),
        (complete, 2, "\"cases\":6", "\"cases\":5", "5 cases: expected 6"),
        (complete, 2, "\"segment\":null", "\"segment\":4", "segment 4: expected none"),
        (sampled, 2, "\"starts\":20", "\"starts\":21", "21 starts: expected 20"),
    ];
    let mut refusals = 0;
    for (args, line, from, to, says) in cases {
        let file = at("part.jsonl");
        let _ = fs::remove_file(&file);
        let args = format!("{args} --out {file}");
        let (code, report, _) = sweep(&args);
        let whole = fs::read_to_string(&file).unwrap();
        let (again, merged, _) = sweep(&format!("merge {file} --audit 2"));
        assert_eq!((again, &merged), (code, &report));
        let mut lines: Vec<String> = whole.lines().map(str::to_owned).collect();
        let changed = lines[line - 1].replacen(from, to, 1);
        assert_ne!(changed, lines[line - 1], "{from}");
        lines[line - 1] = changed;
        let content = lines.join("\n") + "\n";
        fs::write(&file, &content).unwrap();
        for command in [args.as_str(), &format!("merge {file}")] {
            refused(command, &format!("line {line}: "));
            refused(command, says);
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), content);
        refusals += 1;
    }
    assert_eq!(refusals, 18);
    // What no look at the line shows, an audit does: one case of the premise more.
    let file = at("audited.jsonl");
    assert_eq!(
        sweep(&format!("7.4ii --form sharp --drones 3 --eps 1/2 --grid 4 --steps 5 --out {file}"))
            .0,
        0
    );
    let whole = fs::read_to_string(&file).unwrap();
    let at_count = whole.find("\"non_vacuous\":").unwrap() + "\"non_vacuous\":".len();
    let count: u64 = whole[at_count..].split(',').next().unwrap().parse().unwrap();
    let changed = whole.replacen(
        &format!("\"non_vacuous\":{count}"),
        &format!("\"non_vacuous\":{}", count + 1),
        1,
    );
    fs::write(&file, changed).unwrap();
    assert_eq!(sweep(&format!("merge {file}")).0, 0);
    refused(
        &format!("merge {file} --audit 1"),
        "--audit: work item 0 (7.4ii sharp, N = 3, eps = 1/2)",
    );
}

#[test]
fn a_stream_is_no_result_file() {
    refused("7.2 --form sharp --drones 3 --out -", "--out: `-`: expected a file");
    if cfg!(unix) {
        assert_eq!(sweep("7.2 --form sharp --drones 3 --out /dev/null").0, 0);
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}

#[test]
fn faults_of_files_have_their_own_code() {
    for args in ["7.2 --eps 1/3 --out /nonexistent/x", "merge /nonexistent/x"] {
        let (code, out, err) = sweep(args);
        assert_eq!((code, out.as_str()), (74, ""), "{err}");
        assert!(err.contains("/nonexistent/x`"), "{err}");
    }
}
