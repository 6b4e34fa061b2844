//! Random protocols: what the engines say of them, held against exact runs.
use std::cell::Cell;

use crate::common::{for_cases, q};
use cordon_check::Verdict;
use cordon_core::Rational;
use cordon_core::system::{ParameterKind, System};
use cordon_proof::claims::certificate::certificate;
use cordon_proof::claims::search::{Choice, Limits};
use cordon_proof::claims::{constants, follow, is_vacuous, prove_within, refute};
use cordon_run::protocol::parse;
use proptest::prelude::*;

/// Two or three agents with small rational coefficients, some that keep still or hear nobody; starts
/// in a box, closed or open, some on a plane, some none at all; one or two claims.
pub fn random_protocol(kinds: std::ops::Range<u8>) -> impl Strategy<Value = String> {
    (2usize..=3).prop_flat_map(move |n| {
        let entry = (-2i32..=2, 4i32..=6);
        let row = (prop::collection::vec(entry, n + 1), 0u8..8);
        let claim = (prop::collection::vec(-2i32..=2, n), 0i32..=4, 0u8..5);
        let claims = prop::collection::vec(claim, 1..=2);
        (prop::collection::vec(row, n), claims, kinds.clone(), 0u8..8)
            .prop_map(move |(rows, claims, kind, start)| text(&rows, &claims, kind, start))
    })
}

type Row = (Vec<(i32, i32)>, u8);

/// No start meets the assumptions of this kind.
const EMPTY: u8 = 7;

/// Kind 0 has no parameter, 1 a constant with a range, 2 agents that may skip, 3 one that varies.
fn text(rows: &[Row], claims: &[(Vec<i32>, i32, u8)], kind: u8, start: u8) -> String {
    let n = rows.len();
    let start = match start {
        0 => "\"-1 < x[i] < 1\"",
        1 => "\"-1 <= x[i] <= 1\", \"x0 = 1/3\"",
        2 => "\"-1 <= x[i] <= 1\", \"x0 < x1\", \"x0 <= x1\"",
        EMPTY => "\"-1 <= x[i] <= 1\", \"x0 < x1\", \"x1 <= x0\"",
        _ => "\"-1 <= x[i] <= 1\"",
    };
    let mut text = format!("agents = {n}\nstart = [{start}]\nclaims = [");
    for (normal, bound, sign) in claims {
        let sum: Vec<String> =
            normal.iter().enumerate().map(|(i, c)| format!("({c})*x{i}")).collect();
        let sign = ["<", "<", "<=", "<=", "="][usize::from(*sign)];
        text += &format!("\"{} {sign} {bound}\", ", sum.join(" + "));
    }
    text += "]\n";
    text += match kind {
        1 => "[parameters]\neps = \"1/4..1/2\"\n",
        2 => "[departures]\nskip = true\n",
        3 => "[parameters]\neps = { varying = \"1/4..1/2\" }\n",
        _ => "",
    };
    text += "[rules]\n";
    for (i, (row, degenerate)) in rows.iter().enumerate() {
        let mut terms: Vec<String> =
            row.iter().take(n).enumerate().map(|(j, (a, d))| format!("({a})/({d})*x{j}")).collect();
        let (a, d) = row[n];
        if kind % 2 == 1 {
            terms.push(format!("eps*({a})/({d})*x0"));
        } else {
            terms.push(format!("({a})/({})", 4 * d));
        }
        let rule = match degenerate {
            0 => "0".to_owned(),
            1 => format!("x{i}"),
            2 => format!("x{i}/2"),
            _ => terms.join(" + "),
        };
        text += &format!("{i} = \"{rule}\"\n");
    }
    text
}

/// Assumed starts on a grid of the box, ends included.
pub fn grid(system: &System) -> Vec<Vec<Rational>> {
    let (values, n) = (["-1", "-1/3", "1/3", "1"].map(q), system.agents);
    (0..4usize.pow(n as u32))
        .map(|code| (0..n).map(|i| values[code / 4usize.pow(i as u32) % 4].clone()).collect())
        .filter(|start: &Vec<Rational>| system.starts.iter().all(|p| p.holds(start)))
        .collect()
}

/// Choices of six steps, by a number: constants stay, what varies takes its ends.
pub fn choices(system: &System, eps: &Rational, code: usize) -> Vec<Choice> {
    let values = |step: usize| {
        let mut bits = (code * 2_654_435_761) >> step;
        let mut value = |p: &cordon_core::system::Parameter| {
            bits >>= 3;
            match p.kind {
                ParameterKind::Constant => eps.clone(),
                _ if bits & 1 == 0 => p.low.clone(),
                _ => p.high.clone(),
            }
        };
        system.parameters.iter().map(&mut value).collect()
    };
    (0..6).map(|step| Choice { mode: 0, values: values(step) }).collect()
}

/// A system, unless no start meets its assumptions.
pub fn read(text: &str) -> Result<Option<System>, TestCaseError> {
    let fail = |e: cordon_core::Error| TestCaseError::fail(e.to_string());
    let system = parse("random", text).map_err(fail)?.system().map_err(fail)?;
    let empty = text.contains("\"x1 <= x0\"");
    prop_assert_eq!(is_vacuous(&system), empty, "{}", text);
    Ok((!empty).then_some(system))
}

/// Whenever a proof is found exact runs keep the claims, whenever a counterexample is found it replays,
/// and where neither is found none is on the grid up to the step that was said.
pub fn agree(cases: u32) {
    let (proved, refuted, open, empty) = (Cell::new(0), Cell::new(0), Cell::new(0), Cell::new(0));
    for_cases(cases, random_protocol(0..4), |text| {
        let Some(system) = read(&text)? else {
            empty.set(empty.get() + 1);
            return Ok(());
        };
        let limits = Limits { steps: 30, half_spaces: 60, work: 1_000_000 };
        let proof = prove_within(&system, &limits);
        let (found, complete) = refute(&system, &constants(&system, 4).unwrap(), None, 4);
        prop_assert!(proof.is_err() || found.is_none(), "both proved and refuted:\n{}", text);
        if let Ok(found) = proof {
            let certificate = certificate(&found.system, &found.proof).unwrap();
            let verdict = cordon_check::check(&certificate.to_string());
            prop_assert!(matches!(verdict, Verdict::Valid { .. }), "{}\n{}", verdict, text);
            // Constants of its own, starts of its own, choices of its own.
            for (code, eps) in ["1/4", "3/10", "1/2"].map(q).into_iter().enumerate() {
                for (n, start) in grid(&system).into_iter().enumerate() {
                    let by = choices(&system, &eps, 7 * n + code);
                    prop_assert_eq!(follow(&system, &[], &start, by), None, "{}", text);
                }
            }
            proved.set(proved.get() + 1);
        } else if let Some(run) = found {
            // Executed anew: an assumed start, the claims kept before the step and broken at it.
            let again = follow(&system, &run.values, &run.states[0], run.choices.clone());
            prop_assert_eq!(again.as_ref(), Some(&run));
            prop_assert!(system.starts.iter().all(|c| c.holds(&run.states[0])));
            refuted.set(refuted.get() + 1);
        } else {
            // Not refuted up to a step is complete for all starts: none on the grid fails.
            for (n, start) in grid(&system).into_iter().enumerate() {
                let mut by = choices(&system, &q("1/4"), n);
                by.truncate(complete);
                prop_assert_eq!(follow(&system, &[], &start, by), None, "{}", text);
            }
            open.set(open.get() + 1);
        }
        Ok(())
    });
    assert_eq!(proved.get() + refuted.get() + open.get() + empty.get(), cases);
    let least = cases / 10;
    assert!(proved.get() >= least && refuted.get() >= least && empty.get() > 0);
}
