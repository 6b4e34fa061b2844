//! What commands say of protocol files, and how they end.
use crate::common::{cordon, run};

/// A file with this text.
fn written(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path = folder.path().join(format!("{name}.toml"));
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn a_grid_without_a_start_shows_nothing() {
    let file = "scenarios/own/coverage.toml";
    let sweep = |agents: &str| run(&["sweep", "--protocol", file, "--agents", agents]);
    let (code, out, _) = sweep("20");
    assert_eq!(code, 3);
    assert!(out.contains("is vacuous: no start on the grid meets the assumptions"), "{out}");
    assert!(!out.contains("holds"), "{out}");
    let (code, out, _) = sweep("5");
    assert!(code == 0 && out.contains("holds up to step 20"), "{out}");
}

#[test]
fn a_claim_about_later_steps_is_not_swept() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = 1\nclaims = [{ holds = \"x0 <= 2\", from = 9, until = 12 }]\n\
                start = [\"0 <= x[i] <= 1\"]\n[rules]\nall = \"x + 1/2\"\n";
    let file = written(&folder, "later", text);
    let sweep = |steps: &str| run(&["sweep", "--protocol", &file, "--complete", "--steps", steps]);
    let (code, out, _) = sweep("8");
    assert!(code == 3 && out.contains("from step 9, until step 12, is vacuous"), "{out}");
    let (code, out, _) = sweep("9");
    assert!(code == 1 && out.contains("fails: `x0 <= 2` at step 9"), "{out}");
}

#[test]
fn targets_that_a_step_moves_are_never_reached() {
    let folder = tempfile::tempdir().unwrap();
    let text = |rule: &str| {
        format!("agents = 3\nconverges = \"target\"\ntarget = \"i\"\n[rules]\nall = \"{rule}\"\n")
    };
    let moved = written(&folder, "moved", &text("x/2 + i"));
    let (code, out, _) = run(&["prove", "--protocol", &moved]);
    assert!(code == 1 && out.contains("a step takes the targets to 0,3/2,3"), "{out}");
    let fixed = written(&folder, "fixed", &text("x/2 + i/2"));
    let (code, out, _) = run(&["prove", "--protocol", &fixed]);
    assert!(code == 0 && out.contains("converges"), "{out}");
}

/// Claims up to a step: proved with a certificate where later ones fail, and refuted where those fail too.
#[test]
fn claims_are_proved_up_to_a_step() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = \"2..\"\nstart = [\"0 <= x[i] <= 1\"]\nclaims = [\"x[i] <= 3\"]\n\
                [rules]\nall = \"x + 1/2\"\n";
    let file = written(&folder, "drifts", text);
    let out_dir = folder.path().display().to_string();
    let upto =
        |steps: &str| run(&["prove", "--protocol", &file, "--steps", steps, "--out", &out_dir]);
    let (code, out, _) = upto("4");
    assert!(code == 0 && out.contains("hold at every step up to step 4 from every"), "{out}");
    let certificate = folder.path().join("drifts.json").display().to_string();
    assert_eq!(run(&["check", &certificate]).0, 0);
    let (code, out, _) = upto("5");
    assert!(code == 1 && out.contains("fails at step 5"), "{out}");
    let (code, _, err) = upto("150");
    assert!(code == 2 && err.contains("--steps: `150`: expected less than 150"), "{err}");
    let (code, _, err) = run(&["prove", "7.2", "--steps", "3"]);
    assert!(code == 2 && err.contains("--steps: expected --protocol with it"), "{err}");
}

/// A range so wide that its simple fractions are too many is refuted at an end, at once.
#[test]
fn wide_ranges_are_tried_at_their_ends() {
    let file = "scenarios/own/hasty-coverage.toml";
    for command in ["prove", "refute"] {
        let (code, out, err) = run(&[command, "--protocol", file, "--set", "eps=0..1000000000000"]);
        assert_eq!((code, err.as_str()), (1, ""), "{out}");
        assert!(out.contains("refuted at eps = 1000000000000: "), "{out}");
    }
    let args = ["refute", "--protocol", file, "--set", "eps=0..1000000", "--denominators", "3"];
    let (code, _, err) = run(&args);
    assert!(code == 2 && err.contains("--denominators: `3`: more than 2000"), "{err}");
}

/// Numbers of 2,000 digits end soon, and are not spelled out in the heading.
#[test]
fn long_weights_end_soon() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string("scenarios/own/weighted-coverage.toml").unwrap();
    let long = text.replace("eps/2*", &format!("1/{}*", "3".repeat(2_000)));
    assert_ne!(text, long);
    let file = written(&folder, "long", &long);
    let (code, out, _) = run(&["prove", "--protocol", &file]);
    assert_eq!(code, 3, "{out}");
    assert!(out.contains("longer numbers than a certificate may have"), "{out}");
    let (_, out, _) =
        run(&["theorems", "--protocol", &file, "--set", &format!("eps=1/{}", "7".repeat(900))]);
    assert!(out.contains("eps = 1/77777777777777777777777777777777777777...\n"), "{out}");
}

/// Both sides of a bracket are certified, and the certificates are written.
#[test]
fn a_bracket_writes_the_certificates_of_both_sides() {
    let folder = tempfile::tempdir().unwrap();
    let out_dir = folder.path().display().to_string();
    let mut checked = 0;
    for (name, more) in [
        ("weighted-coverage", &["--set", "eps=0..1", "--digits", "2"][..]),
        ("digraph", &["--set", "eps=1/10..2", "--property", "convergence", "--digits", "2"][..]),
    ] {
        let file = format!("scenarios/own/{name}.toml");
        let args = [&["threshold", "--protocol", &file, "--out", &out_dir][..], more].concat();
        let (code, out, _) = run(&args);
        assert_eq!(code, 0, "{out}");
        for side in ["holds", "fails"] {
            let path = folder.path().join(format!("{name}-{side}.json")).display().to_string();
            assert!(out.contains(&format!("  wrote {path}\n")), "{out}");
            assert_eq!(run(&["check", &path]).0, 0, "{path}");
            checked += 1;
        }
    }
    assert_eq!(checked, 4);
}

/// `--protocol` takes names and files alike: what is wrong about one is said.
#[test]
fn names_of_protocols_are_told_from_files() {
    let (code, _, err) = run(&["prove", "--protocol", "coverage"]);
    assert!(code == 2 && err.contains("`coverage`: expected a protocol file here"), "{err}");
    let (code, _, err) = run(&["trace", "--protocol", "covrage"]);
    assert!(code == 2 && err.contains("`covrage` is unknown: expected `coverage`"), "{err}");
}

/// Of many choices in a step each is shown, below the states.
#[test]
fn many_choices_stand_below_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string("scenarios/own/coverage.toml").unwrap();
    let late = text.replace("3..", "4..") + "\n[departures]\nloss = \"one-sided\"\ndelay = 1\n";
    let file = written(&folder, "late", &late);
    let (code, out, _) = run(&["refute", "--protocol", &file, "--set", "eps=1"]);
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("\n  step 1 by link1from0 = ") && out.contains("x1ago1"), "{out}");
}

/// A claim that the start says only link by link is not shown for every number of agents: that is said.
#[test]
fn what_the_start_does_not_say_of_every_agent_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string("scenarios/own/coverage.toml").unwrap();
    let bounds = "0 <= x[i] <= 1";
    let less = text.replacen(&format!(", \"{bounds}\""), "", 1);
    assert!(text != less && less.contains(bounds));
    let file = written(&folder, "less", &less);
    let (code, out, _) = run(&["prove", "--protocol", &file]);
    assert!(code == 3 && out.contains("expected it there too"), "{out}");
}

/// The search for a proof may go further back than that for the smallest counterexample.
#[test]
fn what_the_search_for_a_proof_refutes_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = 2\nstart = [\"0 <= x[i] <= 1\"]\nclaims = [\"x0 <= 10\", \"x1 <= 100\"]\n\
                [rules]\nall = \"x + 1/2\"\n";
    let file = written(&folder, "drifts", text);
    let out_dir = folder.path().display().to_string();
    let (code, out, _) = run(&["prove", "--protocol", &file, "--out", &out_dir]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: `x0 <= 10` fails at step 19"), "{out}");
    let certificate = folder.path().join("drifts-refuted.json").display().to_string();
    assert_eq!(run(&["check", &certificate]).0, 0);
    let (code, out, _) = run(&["theorems", "--protocol", &file, "--check"]);
    assert_eq!(code, 1);
    assert!(out.contains("fails at step 19"), "{out}");
}

#[test]
fn long_numbers_are_shown_rounded_and_kept_exact() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = 1\nstart = [\"x0 = 1\"]\nclaims = [\"x0 < 9\"]\n[rules]\n\
                all = \"123457/97001*x + 1/7\"\n";
    let file = written(&folder, "grows", text);
    let (code, out, _) = run(&["refute", "--protocol", &file]);
    assert_eq!(code, 1);
    assert!(out.contains("exact; shown rounded") && out.contains("1.415597"), "{out}");
    let (_, exact, _) = run(&["refute", "--protocol", &file, "--format", "json"]);
    assert!(exact.contains("\"961200/679007\""), "{exact}");
}

#[test]
fn settling_writes_its_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let file = "scenarios/own/digraph.toml";
    let (code, said, _) = run(&["settle", "--protocol", file, "--within", "1/10", "--out", &out]);
    assert!(code == 0 && said.contains("wrote "), "{said}");
    let certificate = folder.path().join("digraph-converges.json").display().to_string();
    assert_eq!(run(&["check", &certificate]).0, 0);
}

#[test]
fn too_many_differences_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = 202\ntopology = \"ring\"\nconverges = \"agreement\"\n[rules]\n\
                all = \"(x + next.x)/2\"\n";
    let file = written(&folder, "many", text);
    let (code, out, _) = run(&["prove", "--protocol", &file]);
    assert_eq!(code, 3);
    assert!(out.contains("201 differences have to vanish: expected at most 200"), "{out}");
}

#[test]
fn a_flag_about_ranges_needs_one() {
    let file = "scenarios/own/weighted-coverage.toml";
    for one in [vec!["--protocol", file, "--set", "eps=1/3"], vec!["7.2", "--eps", "1/3"]] {
        let line = [&["refute", "--denominators", "5"], one.as_slice()].concat();
        let (code, out, error) = run(&line);
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(error.contains("denominators: `5`: expected a range"), "{error}");
    }
}

#[test]
fn wide_runs_show_what_the_claim_is_about() {
    let folder = tempfile::tempdir().unwrap();
    let text = "agents = 100\ntopology = \"line\"\nstart = [\"x0 = 0\", \"x[N-1] = 1\", \"x[i] < x[i+1]\"]\n\
                claims = [\"x60 < x61\"]\n[rules]\nfirst = \"0\"\nlast = \"1\"\n\
                inner = \"x + 3/5*sum(their.x - x)\"\n";
    let file = written(&folder, "wide", text);
    let (code, out, _) = run(&["refute", "--protocol", &file]);
    assert_eq!(code, 1, "{out}");
    let head = out.lines().find(|l| l.trim_start().starts_with("step ")).unwrap();
    assert!(["x0 ", "x59 ", "x60 ", "x61 ", "... "].iter().all(|w| head.contains(w)), "{head}");
    assert!(head.len() <= 170, "{head}");
    let start: Vec<String> = (0..100).map(|i| format!("{i}/99")).collect();
    let line = ["trace", "--protocol", &file, "--start", &start.join(","), "--steps", "1"];
    let (code, out, _) = run(&line);
    assert_eq!(code, 0);
    assert!(out.lines().all(|l| l.chars().count() <= 200), "{out}");
    assert!(
        out.contains("x99") && out.contains("are left out here: --format csv has all"),
        "{out}"
    );
    let csv = run(&[&line[..], &["--format", "csv"]].concat()).1;
    assert_eq!(csv.lines().next().unwrap().split(',').count(), 202);
}

#[test]
fn certain_digits_have_their_title() {
    let line = "trace --protocol scenarios/own/coverage.toml --start 0,1/10,1/5,3/10,1 --eps 1/5 --at 7 --engine digits";
    let (code, out, _) = run(&line.split(' ').collect::<Vec<_>>());
    assert!(code == 0 && out.starts_with("coverage\n"), "{out}");
}

#[test]
fn in_continuous_time_the_fewest_agents_are_said_to_be_meant() {
    let folder = tempfile::tempdir().unwrap();
    let spring = std::fs::read_to_string("benchmarks/pushed-spring.toml").unwrap();
    let file = written(&folder, "springs", &spring.replace("agents = 1\n", "agents = \"1..\"\n"));
    let said = "the fewest agents of the file";
    let (_, out, _) = run(&["prove", "--protocol", &file]);
    assert!(out.contains(said), "{out}");
    let (_, out, _) = run(&["prove", "--protocol", &file, "--agents", "1"]);
    assert!(!out.contains(said), "{out}");
}

#[cfg(unix)]
#[test]
fn help_that_cannot_be_written_is_no_success() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let program = cordon().get_program().to_owned();
    let status = std::process::Command::new(program).arg("--help").stdout(full).status().unwrap();
    assert_eq!(status.code(), Some(74));
}

/// What text says of both ends of a range, JSON says too.
#[test]
fn ends_without_a_bracket_are_told_apart() {
    let known = |set: &str| {
        let own = "scenarios/own/coverage.toml";
        let line = ["threshold", "--protocol", own, "--agents", "4", "--set", set];
        let (code, out, _) = run(&[&line[..], &["--format", "json"]].concat());
        assert_eq!(code, 3, "{out}");
        let page: serde_json::Value = serde_json::from_str(&out).unwrap();
        (run(&line).1, page["threshold"]["ends"].clone())
    };
    let end = |value: &str, known: &str| serde_json::json!({ "value": value, "known": known });
    let (text, ends) = known("eps=1/4..1/2");
    assert!(text.contains("it holds at the lower end of eps and holds at the upper end"), "{text}");
    assert_eq!(ends, serde_json::json!([end("1/4", "holds"), end("1/2", "holds")]));
    let (text, ends) = known("eps=3/5..1");
    assert!(text.contains("it fails at the lower end of eps and fails at the upper end"), "{text}");
    assert_eq!(ends, serde_json::json!([end("3/5", "fails"), end("1", "fails")]));
    let bracketed =
        "threshold --protocol scenarios/own/coverage.toml --agents 4 --set eps=0..1 --digits 1";
    let line: Vec<_> = bracketed.split(' ').chain(["--format", "json"]).collect();
    let page: serde_json::Value = serde_json::from_str(&run(&line).1).unwrap();
    assert_eq!(
        page["threshold"]["ends"],
        serde_json::json!([end("0", "holds"), end("1", "fails")])
    );
}

/// Every message about a protocol file names line and column, or the key that is missing.
#[test]
fn what_is_wrong_with_a_protocol_file_has_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let whole = "agents = 3\ntopology = \"line\"\nstart = [\"x0 = 0\"]\nclaims = [\"x0 = 0\"]\n\
                 [parameters]\neps = \"0..1\"\n[rules]\nfirst = \"x\"\ninner = \"x\"\nlast = \"x\"\n";
    let continuous = "time = \"continuous\"\n";
    let changes: [(&str, &str, &[&str], &str); 12] = [
        // Of three agents there is one.
        (
            "agents = 3\ntopology = \"line\"\nstart = [\"x0 = 0\"]",
            "agents = \"3..\"\ntopology = \"line\"\nstart = [\"x0 = 0\", \"x[i] + 1 <= x[i+1]\", \"x[N-1] <= 5\"]",
            &["prove"],
            ":3:9: start: no start of 7 agents meets the assumptions",
        ),
        (
            "\"x0 = 0\"]\nclaims",
            "\"x0 = 0\", \"x0 = 1\"]\nclaims",
            &["prove"],
            ":3:9: start: no start meets",
        ),
        (
            "start = [\"x0 = 0\"]\nclaims = [\"x0 = 0\"]",
            "claims = [\"x0 = 0\", \"x0 = 1\"]",
            &["prove"],
            ":3:10: claims: no start",
        ),
        (
            "inner = \"x\"\n",
            "",
            &["prove"],
            ":7:1: rules: agent 1 has no rule: expected `all`, `inner` or `1`",
        ),
        ("last = \"x\"\n", "", &["prove"], ": agent 2 has no rule: expected `all`, `last` or `2`"),
        (
            "claims = [\"x0 = 0\"]\n",
            "",
            &["prove"],
            ": claims: none: expected `claims` or `converges`",
        ),
        (
            "claims = [\"x0 = 0\"]\n",
            "converges = \"agreement\"\n",
            &["refute"],
            ": claims: none: expected",
        ),
        (
            "claims = [\"x0 = 0\"]\n",
            "converges = \"agreement\"\n",
            &["sweep"],
            ": claims: none: expected",
        ),
        ("agents = 3\n", "", &["prove"], ": agents: is missing: expected their number"),
        (
            "agents",
            "time = \"continuous\"\nagents",
            &["sweep"],
            ":1:8: time: `continuous`: expected a protocol that acts in steps",
        ),
        (
            "claims = [\"x0 = 0\"]",
            "claims = [{ holds = \"x0 < 1\", from = 3 }]\ntime = \"continuous\"",
            &["prove"],
            ":4:11: claims: expected no `from`",
        ),
        (
            "last = \"x\"\n",
            "last = \"x\"\n[departures]\nskip = true\n",
            &["prove"],
            ":13:8: departures.skip: expected none",
        ),
    ];
    for (from, to, command, said) in changes {
        let text = match to.contains("skip") {
            true => format!("{continuous}{}", whole.replacen(from, to, 1)),
            false => whole.replacen(from, to, 1),
        };
        assert!(text != whole);
        let file = written(&folder, "p", &text);
        let (code, out, err) = run(&[command, &["--protocol", &file]].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{to}: {err}");
        assert!(err.starts_with(&format!("error: {file}")) && err.contains(said), "{to}: {err}");
    }
    let file = written(&folder, "p", whole);
    assert_eq!(run(&["prove", "--protocol", &file]).0, 0);
}

/// A title with nothing in it is none.
#[test]
fn an_empty_title_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string("scenarios/own/ring-pulls.toml").unwrap();
    let at = text.find("title = ").unwrap();
    let end = at + text[at..].find('\n').unwrap();
    for title in ["title = \"\"", "title = \" \""] {
        let file = written(&folder, "p", &format!("{}{title}{}", &text[..at], &text[end..]));
        let (_, out, err) = run(&["theorems", "--protocol", &file]);
        assert!(out.starts_with(&format!("{file}: ")), "{out}{err}");
    }
}
