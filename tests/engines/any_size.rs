//! Users' protocols, proved for every number of agents.
use cordon_check::Verdict;
use cordon_core::Rational;
use cordon_proof::prove::any_size::{AnySize, any_size};
use cordon_run::protocol::{Family, FamilyClaim};

fn range(from: &str, to: &str) -> [Option<Rational>; 2] {
    [from, to].map(|end| (!end.is_empty()).then(|| end.parse().unwrap()))
}

fn texts(all: &[&str]) -> Vec<String> {
    all.iter().map(|t| (*t).to_owned()).collect()
}

fn rules(all: &[(&str, &[(&str, &str)])]) -> Vec<(String, Vec<(String, String)>)> {
    let rule = |(v, t): &(&str, &str)| ((*v).to_owned(), (*t).to_owned());
    all.iter().map(|(c, r)| ((*c).to_owned(), r.iter().map(rule).collect())).collect()
}

fn family(
    is_ring: bool,
    eps: [&str; 2],
    of: &[(&str, &[(&str, &str)])],
    start: &[&str],
    claims: &[&str],
) -> Family {
    let state = if of.iter().any(|(_, r)| r.iter().any(|(v, _)| *v == "v")) {
        &["x", "v"][..]
    } else {
        &["x"]
    };
    Family {
        is_ring,
        state: texts(state),
        parameters: [
            ("eps".to_owned(), range(eps[0], eps[1])),
            ("min".to_owned(), range("", "")),
            ("max".to_owned(), range("", "")),
        ]
        .into(),
        rules: rules(of).into_iter().map(|(c, r)| (c, r.into_iter().collect())).collect(),
        given: texts(&["min < max"]),
        start: texts(start),
        claims: claims
            .iter()
            .map(|c| FamilyClaim { text: (*c).to_owned(), literals: Ok(texts(&[*c])) })
            .collect(),
    }
}

const AVERAGE: &str = "eps*x(i-1) + (1 - 2*eps)*x(i) + eps*x(i+1)";
const COVERAGE: [(&str, &[(&str, &str)]); 3] =
    [("first", &[("x", "min")]), ("inner", &[("x", AVERAGE)]), ("last", &[("x", "max")])];
const CONSENSUS: [(&str, &[(&str, &str)]); 3] = [
    ("first", &[("x", "x(i) + eps*(x(i+1) - x(i))")]),
    ("inner", &[("x", AVERAGE)]),
    ("last", &[("x", "x(i) + eps*(x(i-1) - x(i))")]),
];
const CHAIN: [(&str, &[(&str, &str)]); 3] = [
    ("first", &[]),
    ("inner", &[("x", "x(i) + eps*(x(i-1) - x(i))")]),
    ("last", &[("x", "x(i) + eps*(x(i-1) - x(i))")]),
];
/// Second order: the position follows the speed, the speed the neighbour's position.
const FOLLOWING: [(&str, &[(&str, &str)]); 1] =
    [("all", &[("x", "x(i) + eps*(v(i) - x(i))"), ("v", "v(i) + eps*(x(i-1) - v(i))")])];
const PULLED: [(&str, &[(&str, &str)]); 1] = [("all", &[("x", "x(i) + eps*(x(i+1) - x(i))")])];
const ORDER: &str = "x(i) < x(i+1)";
const WEAK: &str = "x(i) <= x(i+1)";
const BOX: [&str; 2] = ["min <= x(i)", "x(i) <= max"];
const BOTH: [&str; 4] = ["min <= x(i)", "x(i) <= max", "min <= v(i)", "v(i) <= max"];
const ENDS: [&str; 2] = ["x(0) = min", "x(last) = max"];

fn cases() -> Vec<(&'static str, Family, bool)> {
    let (line, ring) = (false, true);
    let ordered = [&ENDS[..], &[ORDER]].concat();
    let half = ["0", "1/2"];
    vec![
        ("coverage order", family(line, half, &COVERAGE, &ordered, &[ORDER]), true),
        ("coverage box", family(line, half, &COVERAGE, &BOX, &BOX), true),
        ("consensus order", family(line, half, &CONSENSUS, &[ORDER], &[WEAK]), true),
        ("consensus strict", family(line, ["0", "1/3"], &CONSENSUS, &[ORDER], &[ORDER]), true),
        ("consensus box", family(line, half, &CONSENSUS, &BOX, &BOX), true),
        (
            "chain",
            family(
                line,
                ["0", "1"],
                &CHAIN,
                &["x(i+1) <= x(i)", "x(i) <= x(0)"],
                &["x(i+1) <= x(i)", "x(i) <= x(0)"],
            ),
            true,
        ),
        ("chain box", family(line, ["0", "1"], &CHAIN, &BOX, &BOX), true),
        ("ring box", family(ring, ["0", "1"], &PULLED, &BOX, &BOX), true),
        ("ring of two variables", family(ring, ["0", "1"], &FOLLOWING, &BOTH, &BOTH), true),
        ("ring of two, half claimed", family(ring, ["0", "1"], &FOLLOWING, &BOTH, &BOX), true),
        ("ring of two beyond 1", family(ring, ["0", "2"], &FOLLOWING, &BOTH, &BOTH), false),
        ("coverage beyond 1/2", family(line, ["0", "3/5"], &COVERAGE, &BOX, &BOX), false),
        ("coverage order beyond", family(line, ["0", "3/5"], &COVERAGE, &ordered, &[ORDER]), false),
        ("consensus beyond", family(line, ["0", "3/5"], &CONSENSUS, &[WEAK], &[WEAK]), false),
        ("ring beyond 1", family(ring, ["0", "11/10"], &PULLED, &BOX, &BOX), false),
        ("ring below 0", family(ring, ["-1/10", "1"], &PULLED, &BOX, &BOX), false),
        ("chain, order turned", family(line, ["0", "1"], &CHAIN, &[], &[WEAK]), false),
        ("coverage of any start", family(line, half, &COVERAGE, &[], &BOX), false),
    ]
}

#[test]
fn right_ones_are_proved_for_every_number_and_wrong_ones_are_not() {
    let mut proved = 0;
    for (name, family, expected) in cases() {
        let found = any_size(&family).unwrap();
        assert_eq!(found.open.is_empty(), expected, "{name}");
        if let AnySize { certificate: Some(certificate), .. } = found {
            let verdict = cordon_check::check(&certificate.to_string());
            assert!(matches!(verdict, Verdict::Valid { .. }), "{name}: {verdict}\n{certificate:#}");
            proved += 1;
        }
    }
    assert_eq!(proved, 10);
}

/// The committed ones are found again, byte for byte (`CORDON_BLESS=1` writes them).
#[test]
fn committed_certificates_are_found_again() {
    let committed = [
        ("family-coverage-order", "coverage order"),
        ("family-leader", "chain"),
        ("family-ring-box", "ring box"),
        ("family-two-variables", "ring of two, half claimed"),
    ];
    for (file, case) in committed {
        let (_, family, _) = cases().into_iter().find(|(name, ..)| *name == case).unwrap();
        let page = format!("{:#}\n", any_size(&family).unwrap().certificate.unwrap());
        let path = format!("{}/proofs/certificates/{file}.json", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("CORDON_BLESS").is_some() {
            std::fs::write(&path, &page).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&path).unwrap(), page, "{file}");
    }
}

/// Proofs have variables of their own: a protocol may use their names.
#[test]
fn names_of_a_protocol_are_no_variables_of_its_proof() {
    let mut accepted = 0;
    for (case, family, _) in cases() {
        if any_size(&family).unwrap().certificate.is_none() {
            continue;
        }
        for name in ["t", "s"] {
            let renamed = |text: &String| text.replace("eps", name);
            let mut family = family.clone();
            family.parameters =
                family.parameters.into_iter().map(|(p, r)| (renamed(&p), r)).collect();
            for rule in family.rules.values_mut().flat_map(|rows| rows.values_mut()) {
                *rule = renamed(rule);
            }
            for text in family.start.iter_mut().chain(&mut family.given) {
                *text = renamed(text);
            }
            for literals in family.claims.iter_mut().filter_map(|c| c.literals.as_mut().ok()) {
                literals.iter_mut().for_each(|l| *l = renamed(l));
            }
            let page = any_size(&family).unwrap().certificate.unwrap();
            let verdict = cordon_check::check(&page.to_string());
            assert_eq!(verdict.code(), 0, "{case} with {name}: {verdict}");
            accepted += 1;
        }
    }
    assert!(accepted >= 20, "{accepted}");
}

#[test]
fn what_the_strategy_does_not_read_is_named() {
    let with = |claim: &str| family(false, ["0", "1"], &CHAIN, &[], &[claim]);
    let wrong = [
        ("x(i)", "expected `<`, `<=`, `=`, `>=` or `>`"),
        ("x(i) < y(i)", "expected sums and products of numbers, parameters and agents"),
        ("x(j) < 1", "agents like `x(i-1)`, at `)"),
        ("x(i)*x(i+1) < 1", "expected agents, and no products of them"),
        ("min < max", "expected agents, and no products of them"),
        ("x(i-1) < 1", "expected agents i, or i and i+1"),
        ("x(i) < x(i+2)", "expected agents i, or i and i+1"),
    ];
    for (claim, expected) in wrong {
        let found = any_size(&with(claim)).unwrap();
        assert!(found.certificate.is_none());
        assert!(found.open[0].1.contains(expected), "{claim}: {:?}", found.open);
    }
}

/// A claim that is open leaves the others proved.
#[test]
fn what_is_proved_of_several_claims_is_concluded() {
    let both = family(false, ["0", "1/2"], &COVERAGE, &BOX, &[BOX[0], WEAK, BOX[1]]);
    let found = any_size(&both).unwrap();
    // It does not hold of all of these starts either.
    let [(1, why)] = found.open.as_slice() else { panic!("{:?}", found.open) };
    assert!(why.starts_with("it does not follow of the start"), "{why}");
    let certificate = found.certificate.unwrap();
    let verdict = cordon_check::check(&certificate.to_string()).to_string();
    assert!(verdict.contains("x(k,i)") && !verdict.contains("x(k,1 + i) >= x(k,i)"), "{verdict}");
    let one = family(false, ["0", "1/2"], &COVERAGE, &BOX, &[WEAK]);
    assert!(any_size(&one).unwrap().certificate.is_none());
}
