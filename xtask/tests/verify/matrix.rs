//! The matrix: verdicts, exit codes, JSON.

use cordon_core::{Evidence, Outcome};
use cordon_spec::theorems::Theorem;
use serde_json::Value;
use xtask::verify::matrix::{Cell, collect};
use xtask::verify::record::Records;
use xtask::verify::show::json;
use xtask::verify::{Context, NAMES, Status, Tier, TierVerdict, tiers};

use super::cell;

/// A tier that says what it is told to.
struct Told(&'static str, fn(Theorem) -> Status, Vec<TierVerdict>);

impl Tier for Told {
    fn name(&self) -> &'static str {
        self.0
    }

    fn kind(&self) -> Evidence {
        Evidence::Sampled
    }

    fn tool(&self) -> String {
        "told 1".into()
    }

    fn sources(&self) -> &'static [&'static str] {
        &["src"]
    }

    fn status(&self, theorem: Theorem) -> Status {
        (self.1)(theorem)
    }

    fn problems(&self) -> Vec<TierVerdict> {
        self.2.clone()
    }
}

fn ran(verdict: TierVerdict) -> Status {
    Status::Run { verdict, scope: "a <scope> & \"more\"".into(), seconds: 0.5 }
}

fn mixed(theorem: Theorem) -> Status {
    match theorem {
        Theorem::Ordering => ran(TierVerdict::Holds),
        Theorem::UpperBound => ran(TierVerdict::Refuted("x < y".into())),
        Theorem::SumBounded => ran(TierVerdict::Rejected("\u{1}bad".into())),
        Theorem::SumMaximal => ran(TierVerdict::Inconclusive("unknown".into())),
        Theorem::Limit => Status::NotClaimed("a limit".into()),
        _ => Status::NotRun("no time".into()),
    }
}

fn matrix_of(told: Vec<Told>) -> xtask::verify::matrix::Matrix {
    let dir = tempfile::tempdir().unwrap();
    let records = Records::read(dir.path()).unwrap();
    let tiers: Vec<Box<dyn Tier>> = told.into_iter().map(|t| Box::new(t) as _).collect();
    collect(dir.path(), &tiers, &records, &Theorem::ALL, |_| {})
}

#[test]
fn the_worst_verdict_decides() {
    let one =
        |e: fn(Theorem) -> Status, problems| matrix_of(vec![Told("t", e, problems)]).outcome();
    assert_eq!(one(|_| ran(TierVerdict::Holds), vec![]), Outcome::Holds);
    assert_eq!(one(|_| ran(TierVerdict::Inconclusive("?".into())), vec![]), Outcome::Holds);
    assert_eq!(one(|_| ran(TierVerdict::Refuted("!".into())), vec![]), Outcome::Refuted);
    assert_eq!(one(|_| ran(TierVerdict::Rejected("!".into())), vec![]), Outcome::Rejected);
    assert_eq!(one(|_| Status::NotRun("".into()), vec![]), Outcome::Inconclusive);
    assert_eq!(one(|_| Status::NotClaimed("".into()), vec![]), Outcome::Inconclusive);
    let rejected = || vec![TierVerdict::Rejected("!".into())];
    assert_eq!(one(|_| ran(TierVerdict::Holds), rejected()), Outcome::Rejected);
    assert_eq!(one(|_| ran(TierVerdict::Refuted("!".into())), rejected()), Outcome::Rejected);
}

#[test]
fn json_has_every_cell() {
    let page: Value =
        serde_json::from_str(&json(&matrix_of(vec![Told("told", mixed, vec![])]))).unwrap();
    assert_eq!(page["exit"], 4);
    assert_eq!(page["tiers"][0]["cells"].as_array().unwrap().len(), Theorem::ALL.len());
    assert_eq!(cell(&page, "told", "7.8")["status"], "not claimed");
    assert_eq!(cell(&page, "told", "7.3")["detail"], "x < y (a <scope> & \"more\")");
}

#[test]
fn the_names_are_those_of_the_tiers() {
    let dir = tempfile::tempdir().unwrap();
    let tiers = tiers(Context { root: dir.path(), run: &[] });
    assert_eq!(tiers.iter().map(|t| t.name()).collect::<Vec<_>>(), NAMES);
    // In a place with nothing in it every tier answers, and none panics.
    let records = Records::read(dir.path()).unwrap();
    let outside: Vec<_> = tiers.into_iter().filter(|t| t.name() != "smt").collect();
    let matrix = collect(dir.path(), &outside, &records, &[Theorem::Ordering], |_| {});
    let run = matrix.columns.iter().filter(|c| matches!(c.cells[0], Cell::Run { .. })).count();
    assert_eq!(run, 3, "simulated, grid, complete");
}
