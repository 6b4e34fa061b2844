//! Mistakes in a protocol file.

use crate::common::run;

#[test]
fn mistakes_are_named_with_file_line_column_and_key() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.toml");
    let good = "agents = 2\ntopology = \"line\"\nclaims = [\"x0 < x1\"]\n[parameters]\neps = 1\n\
                [rules]\nall = \"x + eps*sum(their.x - x)\"\n";
    let rule = |text: &str| good.replace("x + eps*sum(their.x - x)", text);
    let cases = [
        (
            good.replace("agents = 2", "agents = 0"),
            "p.toml:1:10: agents: `0`: expected a number from 1",
        ),
        (good.replace("agents = 2", "agents = \"x..\""), "p.toml:1:10: agents: `x..`"),
        (
            good.replace("agents = 2", "drones = 2"),
            "p.toml:1:1: drones: is no longer a key: expected `agents = 5`",
        ),
        (good.replace("topology", "graph"), "graph: is no longer a key: expected `topology`"),
        (good.replace("claims", "claim"), "claim: is no longer a key: expected `claims`"),
        (
            good.replace("eps = 1", "eps = \"1/0\""),
            "p.toml:5:7: parameters.eps: `1/0` divides by zero",
        ),
        (
            good.replace("eps = 1", "eps = \"1..0\""),
            "p.toml:5:7: parameters.eps: `1..0`: expected a range",
        ),
        (good.replace("eps = 1", "x = 1"), "p.toml:5:1: parameters.x: expected a name"),
        (
            good.replace("eps = 1\n", ""),
            "rules.all (agent 0): `eps` is not a state variable, parameter",
        ),
        (good.replace("line", "lines"), "p.toml:2:12: topology: `lines`: expected `line`, `ring`"),
        (
            good.replace("\"line\"", "[[0, 1], [1, 0]]"),
            "topology: `[1, 0]`: agent 0 hears agent 1 twice",
        ),
        (rule("eps*eps*x"), "rules.all (agent 0): `eps` to the power 2"),
        (rule("x*x"), "rules.all (agent 0): a product of state variables"),
        (
            rule("prev.x").replace("agents = 2", "agents = 1").replace("line", "ring"),
            "rules.all (agent 0): `prev`: expected a ring of two agents or more",
        ),
        (
            good.replace("\"x0 < x1\"", "{ holds = \"x0 < x1\", from = 1001 }"),
            "p.toml:3:11: claims: `from = 1001`: expected a step from 0 to 1000",
        ),
        (
            good.replace("x0 < x1", "2 < 1"),
            "p.toml:3:10: claims: no start meets the claims, which are assumed where",
        ),
        (rule("x +"), "p.toml:7:11: rules.all: expected a number, a name or `(`, found the end"),
        (
            rule("prev.x"),
            "rules.all (agent 0): agent 0 has no `prev`: expected a rule of its own for `first`",
        ),
        (rule("x[5]"), "`5` is not an agent: expected 0 to 1"),
        (
            good.replace("all =", "7 ="),
            "p.toml:7:1: rules.7: expected `all`, `first`, `inner`, `last` or an agent",
        ),
        (good.replace("all =", "first ="), "p.toml:6:1: rules: agent 1 has no rule"),
        (
            good.replace("x0 < x1", "x0 < x2"),
            "p.toml:3:17: claims: `2` is not an agent: expected 0 to 1",
        ),
        (good.replace("x0 < x1", "x0 * x1 < 1"), "claims: expected no product"),
        (good.replace("x0 < x1", "eps < x1"), "claims: `eps`: expected a state variable"),
        (
            good.replace("x0 < x1", "x0"),
            "claims: expected `<`, `<=`, `=`, `>=` or `>`, found the end",
        ),
        (good.replace("x0 < x1", "x0 < 1/0"), "claims: a division by zero"),
        (
            good.replace("[\"x0 < x1\"]", "[]"),
            "p.toml:3:10: claims: none: expected `claims` or `converges`",
        ),
        (good.replace("rules", "rulez"), "unknown field `rulez`"),
        (good.replace("x0 < x1", "x0 < x0"), "no start meets the claims, which are assumed"),
        (good.replace("x0 < x1", &"(".repeat(500)), "claims: is nested too deeply"),
        (
            rule(&format!("{}x", "x + ".repeat(20_000))),
            "rules.all: expected at most 2000 numbers and names",
        ),
        (good.replace("eps = 1", "eps = 1\nx1ago1 = 1"), "parameters.x1ago1: expected a name"),
        (
            good.replace("eps = 1", "eps = 1\nlink0with1 = 1"),
            "parameters.link0with1: expected a name",
        ),
        (
            good.replace(
                "claims = [\"x0 < x1\"]",
                "start = [\"x0 < x1\"]\nconverges = \"agreement\"",
            ),
            "p.toml: claims: none: expected `claims`",
        ),
    ];
    for (text, expected) in &cases {
        std::fs::write(&path, text).unwrap();
        let (code, out, err) = run(&["refute", "--protocol", path.to_str().unwrap()]);
        assert_eq!((code, out.as_str()), (2, ""), "{text}\n{err}");
        assert!(err.contains(expected), "expected `{expected}` in `{err}`");
    }
    assert_eq!(cases.len(), 34);
    // A file without a claim runs, though there is nothing to decide.
    std::fs::write(&path, good.replace("[\"x0 < x1\"]", "[]")).unwrap();
    let line = ["trace", "--protocol", path.to_str().unwrap(), "--start", "0,1", "--steps", "1"];
    let (code, out, err) = run(&line);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("step"), "{out}");
    let (code, _, err) = run(&[&line[..], &["--check", "all"]].concat());
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("claim"), "{err}");
    std::fs::write(&path, good).unwrap();
    let with = |flags: &[&str]| {
        let file = path.to_str().unwrap();
        run(&[&["refute", "--protocol", file, "--steps", "1"], flags].concat())
    };
    assert_eq!(with(&["--start", "0,1"]).0, 1, "they swap at eps = 1");
    assert_eq!(with(&["--start", "1,0"]).0, 2, "not an assumed start");
    assert_eq!(with(&["--start", "0"]).0, 2, "too short");
    assert!(
        with(&["--set", "gain=1"])
            .2
            .contains("set: `gain` is not a parameter: expected one of eps")
    );
    assert!(with(&["--set", "eps=1", "--set", "eps=0"]).2.contains("set: `eps` occurs twice"));
    assert!(with(&["--set", "eps"]).2.contains("set: `eps`: expected a parameter and its value"));
}
