//! Invariants of small systems as theorems: one for each way in which a run goes on.
use cordon_proof::certificate::linear::Invariance;
use serde_json::Value;

/// A system with a range, one with a chain before what recurs, one with modes in turn, one with any mode in each step.
const COMMITTED: [&str; 4] = ["averaging", "chain", "schedule", "switching"];

fn root(path: &str) -> String {
    format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))
}

fn invariance(name: &str) -> Invariance {
    let text = std::fs::read_to_string(root(&format!("tests/engines/invariants/{name}.json")));
    serde_json::from_str(&text.unwrap()).unwrap()
}

/// What the checker says is proved.
fn proved(page: &Value) -> Vec<String> {
    let verdict = cordon_check::check(&page.to_string());
    assert_eq!(verdict.code(), 0, "{verdict}");
    let words = verdict.to_string();
    let lines = words.lines().filter_map(|l| l.trim().strip_prefix("proved: "));
    let bare = |l: &str| {
        l.split(" (").filter(|part| !part.ends_with("obligations)")).collect::<Vec<_>>().join(" (")
    };
    lines.map(bare).collect()
}

#[test]
fn committed_certificates_are_written_again() {
    for name in COMMITTED {
        let page = format!("{:#}\n", invariance(name).certificate().unwrap());
        let path = root(&format!("proofs/certificates/invariance-{name}.json"));
        if std::env::var_os("CORDON_BLESS").is_some() {
            std::fs::write(&path, &page).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&path).unwrap(), page, "{name}");
    }
}

#[test]
fn claims_are_concluded_from_the_first_step_where_they_hold() {
    let chain = |change: &dyn Fn(&mut Invariance)| {
        let mut invariance = invariance("chain");
        change(&mut invariance);
        proved(&invariance.certificate().unwrap())
    };
    let every = "for all integers k, if k >= ";
    assert_eq!(
        chain(&|_| ()),
        [format!("{every}2 then 4 > x(k)"), format!("{every}0 then 8 >= x(k)")]
    );
    // A run that ends is spoken of step by step.
    let ended = chain(&|i| i.edges.truncate(2));
    assert_eq!(ended, ["4 > x(2)", "8 >= x(0)", "8 >= x(1)", "8 >= x(2)"]);
    // A claim that is missing at a step on the way.
    let gap = chain(&|i| _ = i.claims.remove(2));
    assert_eq!(
        gap,
        [format!("{every}2 then 4 > x(k)"), format!("{every}2 then 8 >= x(k)"), "8 >= x(0)".into()]
    );
}

/// What does not fit together is not written, and never accepted.
#[test]
fn invariants_that_are_none_are_refused() {
    type Change = fn(&mut Invariance);
    let cases: [(&str, Change, Option<&str>); 11] = [
        ("averaging", |i| i.start = "nowhere".into(), None),
        ("averaging", |i| i.edges[1].by = Some("none".into()), None),
        ("averaging", |i| _ = i.edges[1].multipliers[1].pop(), None),
        ("averaging", |i| _ = i.edges[1].multipliers.pop(), None),
        (
            "averaging",
            |i| i.edges[1].multipliers[0][0] = [(1, "1".into())].into(),
            Some("positivity"),
        ),
        (
            "averaging",
            |i| i.edges[1].multipliers[0][0] = [(0, "-1".into())].into(),
            Some("positivity"),
        ),
        ("averaging", |i| i.edges[1].multipliers[3][0] = [(0, "1".into())].into(), None),
        (
            "averaging",
            |i| _ = i.system.parameters.insert("eps".into(), ["0".into(), "1".into()]),
            Some("positivity"),
        ),
        ("averaging", |i| i.claims[0].holds = "x0 < x1".into(), Some("positivity")),
        ("switching", |i| i.nodes.get_mut("kept").unwrap()[0] = "x0*x1 = 3".into(), None),
        ("schedule", |i| i.edges[1].by = Some("double".into()), Some("positivity")),
    ];
    let mut refused = 0;
    for (name, change, rule) in cases {
        let mut wrong = invariance(name);
        change(&mut wrong);
        let said =
            wrong.certificate().map(|page| cordon_check::check(&page.to_string()).to_string());
        match (said, rule) {
            (None, None) => {}
            (Some(said), Some(rule)) => {
                assert!(
                    said.starts_with("invalid") && said.contains(&format!("rule {rule}")),
                    "{name}: {said}"
                );
            }
            (said, _) => panic!("{name}: {said:?}"),
        }
        refused += 1;
    }
    assert_eq!(refused, 11);
    // Without the edge of a mode the theorem is about runs without it, as it says.
    let mut alone = invariance("switching");
    alone.edges.remove(1);
    let said = cordon_check::check(&alone.certificate().unwrap().to_string()).to_string();
    assert!(
        said.contains("if k >= 0 then x2(1 + k) = x2(k)\n") && !said.contains("right"),
        "{said}"
    );
}
