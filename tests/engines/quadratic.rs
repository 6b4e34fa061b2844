//! Quadratic forms as theorems: what the kernel makes of right ones and of wrong ones.

use std::collections::BTreeMap;

use cordon_check::Verdict;
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::scalar::Polynomial;
use cordon_core::system::System;
use cordon_proof::certificate::linear::LinearSystem;
use cordon_proof::certificate::quadratic::{Course, Quadratic};
use cordon_proof::claims::converge;
use serde_json::Value;

use crate::common::q;
use crate::prove::Source;

fn qs<const N: usize>(numbers: [&str; N]) -> Vec<Rational> {
    numbers.map(q).to_vec()
}

fn number(text: &str) -> Polynomial {
    Polynomial::constant(q(text))
}

fn modes<const N: usize>(
    modes: [(&str, &[(&str, &str)]); N],
) -> BTreeMap<String, BTreeMap<String, String>> {
    let rows =
        |rows: &[(&str, &str)]| rows.iter().map(|(v, row)| ((*v).into(), (*row).into())).collect();
    modes.into_iter().map(|(name, all)| (name.into(), rows(all))).collect()
}

fn of(state: &[&str], modes: BTreeMap<String, BTreeMap<String, String>>) -> LinearSystem {
    LinearSystem {
        state: state.iter().map(|v| (*v).into()).collect(),
        modes,
        ..LinearSystem::default()
    }
}

/// The state itself.
fn same(size: usize) -> Vec<Affine> {
    (0..size).map(Affine::variable).collect()
}

/// Two agents keep a distance of 1 to the one before, at any weight from 1/4 to 1/2.
fn contraction() -> Quadratic {
    let rows: &[(&str, &str)] =
        &[("x1", "x1 + eps*(x0 + 1 - x1)"), ("x2", "x2 + eps*(x1 + 1 - x2)")];
    let mut system = of(&["x0", "x1", "x2"], modes([("step", rows)]));
    system.parameters = [("eps".into(), ["1/4".into(), "1/2".into()])].into();
    let eps = Polynomial::variable(0);
    let kept = number("1") - &eps;
    Quadratic {
        system,
        readouts: [["-1", "1", "0"], ["-1", "0", "1"]]
            .iter()
            .zip(["-1", "-2"])
            .map(|(row, c)| Affine::new(q(c), row.map(q).to_vec()))
            .collect(),
        maps: [("step".into(), vec![[(0, kept.clone())].into(), [(0, eps), (1, kept)].into()])]
            .into(),
        parameters: vec!["eps".into()],
        forms: vec![vec![qs(["2", "-1/2"]), qs(["-1/2", "1"])]],
        course: Course::Falls(q("9/10")),
    }
}

/// Two modes, a form for each.
fn switching() -> Quadratic {
    let coast: &[(&str, &str)] = &[("x", "1/2*x + 1/2*v"), ("v", "1/2*v")];
    let hold: &[(&str, &str)] = &[("x", "1/2*x"), ("v", "1/2*x + 1/2*v")];
    let half = || number("1/2");
    let maps = [
        ("coast".to_owned(), vec![[(0, half()), (1, half())].into(), [(1, half())].into()]),
        ("hold".to_owned(), vec![[(0, half())].into(), [(0, half()), (1, half())].into()]),
    ];
    Quadratic {
        system: of(&["x", "v"], modes([("coast", coast), ("hold", hold)])),
        readouts: same(2),
        maps: maps.into(),
        parameters: Vec::new(),
        forms: vec![
            vec![qs(["1", "0"]), qs(["0", "1"])],
            vec![qs(["1", "1/10"]), qs(["1/10", "1"])],
        ],
        course: Course::Falls(q("9/10")),
    }
}

/// One direction grows, beside one that shrinks.
fn growth() -> Quadratic {
    let step: &[(&str, &str)] = &[("x", "2*x + v"), ("v", "1/2*v")];
    Quadratic {
        system: of(&["x", "v"], modes([("step", step)])),
        readouts: same(2),
        maps: [(
            "step".into(),
            vec![[(0, number("2")), (1, number("1"))].into(), [(1, number("1/2"))].into()],
        )]
        .into(),
        parameters: Vec::new(),
        forms: vec![vec![qs(["1", "0"]), qs(["0", "-2"])]],
        course: Course::Stays(qs(["2", "1"])),
    }
}

fn verdict(page: &Value) -> Verdict {
    cordon_check::check(&page.to_string())
}

/// The committed ones, byte for byte (`CORDON_BLESS=1` writes them).
#[test]
fn committed_certificates_of_forms_are_written_again() {
    let all = [("contraction", contraction()), ("growth", growth()), ("switching", switching())];
    for (name, quadratic) in all {
        let page = format!("{:#}\n", quadratic.certificate().unwrap());
        let path =
            format!("{}/proofs/certificates/quadratic-{name}.json", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("CORDON_BLESS").is_some() {
            std::fs::write(&path, &page).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&path).unwrap(), page, "{name}");
        assert_eq!(verdict(&serde_json::from_str(&page).unwrap()).code(), 0, "{name}");
    }
}

/// Evidence that shows nothing becomes no certificate.
#[test]
fn forms_that_do_not_show_it_are_not_written() {
    let with = |mut quadratic: Quadratic, change: fn(&mut Quadratic)| {
        change(&mut quadratic);
        quadratic.certificate()
    };
    type Change = fn(&mut Quadratic);
    let wrong: [(&str, Quadratic, Change); 6] = [
        ("too fast", contraction(), |c| c.course = Course::Falls(q("3/5"))),
        ("indefinite", contraction(), |c| c.forms[0][0][0] = q("1/8")),
        ("a longer form", switching(), |c| c.forms[1][0][0] = q("9")),
        ("a form too many", switching(), |c| c.forms.push(c.forms[0].clone())),
        ("from 0", growth(), |c| c.course = Course::Stays(qs(["0", "0"]))),
        ("growth over a range", contraction(), |c| c.course = Course::Stays(qs(["0", "0", "1"]))),
    ];
    for (name, quadratic, change) in wrong {
        assert!(with(quadratic, change).is_none(), "{name}");
    }
}

/// Of what is written each part is needed, and what it says is judged.
#[test]
fn tampered_certificates_of_forms_are_rejected() {
    let at = |page: &Value, list: &str, name: &str| -> String {
        let all = page
            .pointer(&format!("/certificate/theorem/{list}"))
            .and_then(Value::as_array)
            .unwrap();
        let named = |entry: &Value| entry["name"] == name || entry["clause"]["name"] == name;
        let index = all.iter().position(named).unwrap_or_else(|| panic!("{list}: no {name}"));
        format!("/certificate/theorem/{list}/{index}")
    };
    // The page, the list and the name in it, the field, what is replaced by what, the clause and the rule that fail.
    let cases = [
        (
            contraction(),
            "statement/definitions",
            "r",
            "/step",
            "81/100",
            "80/100",
            "statement",
            "expression",
        ),
        (
            contraction(),
            "statement/definitions",
            "r",
            "/step",
            "81/100",
            "4/5",
            "falls",
            "positivity",
        ),
        (
            contraction(),
            "statement/definitions",
            "V",
            "/step",
            "2*y1(k)*y1(k)",
            "3*y1(k)*y1(k)",
            "step",
            "positivity",
        ),
        (
            contraction(),
            "statement/definitions",
            "y0",
            "/step",
            "- 1",
            "- 2",
            "next.y0",
            "positivity",
        ),
        (
            contraction(),
            "statement/assumptions",
            "high.eps",
            "/goal",
            "1/2",
            "3/4",
            "step",
            "positivity",
        ),
        (
            contraction(),
            "statement/assumptions",
            "step.x2",
            "/goal",
            "+ x2(k)",
            "+ 2*x2(k)",
            "next.y1",
            "positivity",
        ),
        (
            contraction(),
            "statement/conclusions",
            "tends",
            "/goal",
            "(y0",
            "2*(y0",
            "tends",
            "positivity",
        ),
        (
            contraction(),
            "proof/lemmas",
            "vertex1.0",
            "/clause/name",
            "vertex1.0",
            "another",
            "mixed.0",
            "instance",
        ),
        (
            contraction(),
            "proof/lemmas",
            "vertex0.0",
            "/clause/goal",
            ">=",
            "<=",
            "vertex0.0",
            "positivity",
        ),
        (
            switching(),
            "statement/assumptions",
            "acts.hold",
            "/goal",
            ">= 0",
            ">= 0 - 1",
            "step",
            "positivity",
        ),
        (
            switching(),
            "proof/lemmas",
            "mixed.1",
            "/clause/name",
            "mixed.1",
            "another",
            "step",
            "instance",
        ),
        (growth(), "statement/assumptions", "start.x", "/goal", "2", "1", "start.y0", "positivity"),
        (
            growth(),
            "statement/conclusions",
            "stays",
            "/goal",
            ">= 2",
            ">= 3",
            "stays",
            "positivity",
        ),
        (
            growth(),
            "statement/assumptions",
            "step.x",
            "/goal",
            "2*x(k)",
            "x(k)",
            "next.y0",
            "positivity",
        ),
    ];
    for (quadratic, list, name, field, old, new, step, rule) in cases {
        let mut page = quadratic.certificate().unwrap();
        assert_eq!(verdict(&page).code(), 0, "{name}");
        let text = page.pointer_mut(&(at(&page, list, name) + field)).unwrap();
        let changed = text.as_str().unwrap().replacen(old, new, 1);
        assert_ne!(*text, changed, "{name}: {text}");
        *text = changed.into();
        let said = verdict(&page);
        let Verdict::Invalid { step: found, rule: broken, .. } = &said else {
            panic!("{name}: {said}")
        };
        assert_eq!((found.as_str(), *broken), (step, rule), "{name}{field}: {said}");
    }
}

/// Random systems of two variables, with a range or a second mode: those of which a form is found are certified, and none that
/// grow are.
#[test]
fn forms_of_random_systems_are_certified() {
    let mut source = Source(20);
    let (mut falls, mut stays) = (0, 0);
    for round in 0..60 {
        let mut entry = || format!("({}/10)", source.below(17) as i64 - 8);
        let row = |entry: &mut dyn FnMut() -> String| format!("{}*x + {}*v", entry(), entry());
        let (x, v) = (row(&mut entry), row(&mut entry));
        let text = match round % 3 {
            0 => format!("[rules]\nall = {{ x = \"{x}\", v = \"{v}\" }}\n"),
            1 => format!(
                "[parameters]\np = \"0..1/4\"\n[rules]\nall = {{ x = \"{x} + p*v\", v = \"{v} - p*x\" }}\n"
            ),
            _ => format!(
                "[modes.a]\nall = {{ x = \"{x}\", v = \"{v}\" }}\n[modes.b]\nall = {{ x = \"{}\", v = \"v/2\" }}\n",
                row(&mut entry)
            ),
        };
        let head = "agents = 1\nstate = \"x, v\"\nstart = [\"-1 <= x[i] <= 1\", \"-1 <= v[i] <= 1\"]\n\
                    converges = \"target\"\ntarget = { x = \"0\", v = \"0\" }\n";
        let system: System = cordon_run::protocol::parse("own", &(head.to_owned() + &text))
            .unwrap()
            .system()
            .unwrap();
        let found = converge::contraction(&system).unwrap();
        let grows = converge::grows(&system).unwrap();
        assert!(found.is_none() || grows.is_none(), "{text}");
        let pages =
            found.into_iter().map(|f| f.certificate).chain(grows.clone().map(|g| g.certificate));
        for page in pages {
            assert_eq!(verdict(&page).code(), 0, "{text}");
            if grows.is_some() { stays += 1 } else { falls += 1 }
        }
    }
    assert!(falls > 40 && stays > 3, "{falls} {stays}");
}
