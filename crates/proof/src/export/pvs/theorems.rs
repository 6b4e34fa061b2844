//! The theorems as PVS statements.

use std::fmt::Write as _;

use cordon_core::theorems::{self, words};
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

/// The theory of the theorems: definitions, then every theorem in its sharp form, with the
/// paper's form and the erratum as comments.
pub(super) fn theory() -> String {
    let mut text = include_str!("definitions.pvs").to_owned();
    for theorem in Theorem::ALL {
        comment(theorem, &mut text);
        for statement in statements(theorem) {
            text.push_str(&statement);
            text.push('\n');
        }
    }
    text.push_str(COMPANIONS);
    text.push_str("END coverage_theorems\n");
    text
}

fn comment(theorem: Theorem, text: &mut String) {
    let t = words(theorem);
    wrapped(&format!("{} {}.", theorem.number(), t.name), text);
    for (label, form) in [("Paper", Form::Paper), ("Sharp", Form::Sharp)] {
        let h = theorem.hypothesis(form);
        let (weights, starts) = (theorems::weights(h.weights), theorems::starts(h.starts));
        wrapped(&format!("{label}: if {weights}; {starts} then {}.", t.conclusion(form)), text);
    }
    if let Some(erratum) = t.erratum {
        wrapped(&format!("Erratum: {erratum}."), text);
    }
}

/// Widest comment line.
const WIDTH: usize = 90;

fn wrapped(words: &str, text: &mut String) {
    let mut line = String::from("  %");
    for word in words.split_whitespace() {
        if line.len() + 1 + word.len() > WIDTH && line.len() > 3 {
            text.push_str(&line);
            line = String::from("\n  %  ");
        }
        line.push(' ');
        line.push_str(word);
    }
    text.push_str(&line);
    text.push('\n');
}

/// The weights of a hypothesis. No `_`: a new range needs its PVS twin.
fn weights(range: WeightRange) -> &'static str {
    match range {
        WeightRange::Any => "TRUE",
        WeightRange::Unit => "0 <= eps AND eps <= 1",
        WeightRange::BelowThird => "0 <= eps AND eps < 1/3",
        WeightRange::BelowHalf => "0 <= eps AND eps < 1/2",
        WeightRange::UpToHalf => "0 <= eps AND eps <= 1/2",
        WeightRange::UpToHalfOrOne => "0 <= eps AND (eps <= 1/2 OR (N = 3 AND eps <= 1))",
        WeightRange::PositiveUpToHalf => "0 < eps AND eps <= 1/2",
        WeightRange::BelowCritical => "0 < eps AND below_critical?",
    }
}

/// The starts of a hypothesis.
fn starts(set: StartSet) -> &'static str {
    match set {
        StartSet::Any => "anchored?(s)",
        StartSet::Ordered => "anchored?(s) AND ordered?(s)",
        StartSet::FirstSubsegment => "anchored?(s) AND ordered?(s) AND first_subsegment?(s)",
        StartSet::UpperBounded => "anchored?(s) AND upper_bounded?(s)",
    }
}

/// The statements of a theorem, with the sharp hypothesis from the spec's data.
fn statements(theorem: Theorem) -> Vec<String> {
    let h = theorem.hypothesis(Form::Sharp);
    let given = |name: &str, variables: &str, conclusion: &str| {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "  {name}: THEOREM\n    FORALL (s: systemState):\n      ({}) AND {}\n      IMPLIES FORALL ({variables}):\n        {conclusion}\n",
            weights(h.weights),
            starts(h.starts)
        );
        text
    };
    let exact = |name: &str, premise: &str, start: &str, property: &str| {
        format!(
            "  {name}: THEOREM\n    {premise} IMPLIES\n      EXISTS (s: systemState): anchored?(s) AND {start}?(s) AND NOT {property}?(exec_coverage(s))\n"
        )
    };
    match theorem {
        Theorem::Ordering => vec![
            given("ordering", "k: nat", "ordered?(placement(s, k))"),
            given("ordering_in_ticks", "k: nat", "ordered?(kth_step(s, k))"),
            exact("ordering_is_exact", "N >= 4 AND eps > 1/2", "ordered", "ordered"),
        ],
        Theorem::UpperBound => vec![
            given("upper_bound", "k: nat", "upper_bounded?(placement(s, k))"),
            given("upper_bound_in_ticks", "k: nat", "upper_bounded?(kth_step(s, k))"),
            exact("upper_bound_is_exact", "eps > 1/2", "upper_bounded", "upper_bounded"),
        ],
        Theorem::SumBounded => vec![given(
            "sum_bounded",
            "k: nat",
            "sum_x(placement(s, k)) <= N * seg_min + N * (N - 1) / 2 * spacing",
        )],
        Theorem::SumMaximal => vec![given(
            "sum_maximal",
            "k: nat",
            "sum_x(placement(s, k)) = N * seg_min + N * (N - 1) / 2 * spacing IFF\n          at_targets?(placement(s, k))",
        )],
        Theorem::SumNonDecreasing => vec![
            "  telescoping: THEOREM\n    FORALL (s: systemState): anchored?(s) IMPLIES\n      sum_x(exec_coverage(s)) - sum_x(s) = eps * (gap(s, N - 2) - gap(s, 0))\n".to_owned(),
            given("sum_non_decreasing", "k: nat", "sum_x(placement(s, k)) <= sum_x(placement(s, k + 1))"),
        ],
        Theorem::SumStationary => vec![given(
            "sum_stationary",
            "k: nat",
            "at_targets?(placement(s, k)) IMPLIES\n          sum_x(placement(s, k + 1)) = sum_x(placement(s, k))",
        )],
        Theorem::TargetsFixed => vec![given(
            "targets_fixed",
            "k, h: nat",
            "at_targets?(placement(s, k)) IMPLIES at_targets?(placement(s, k + h))",
        )],
        Theorem::ConstantSum => vec![given(
            "constant_sum",
            "k: nat",
            "(FORALL (h: nat): 2 * h <= N - 1 IMPLIES\n           sum_x(placement(s, k + h)) = sum_x(placement(s, k)))\n          IMPLIES at_targets?(placement(s, k))",
        )],
        Theorem::GloballyIncreasing => vec![given(
            "globally_increasing",
            "k: nat, d: posnat",
            "off_target_depth?(placement(s, k), d) IMPLIES\n          (FORALL (h: nat): h < d IMPLIES\n             sum_x(placement(s, k + h)) = sum_x(placement(s, k))) AND\n          sum_x(placement(s, k + d)) > sum_x(placement(s, k + d - 1))",
        )],
        Theorem::Limit => vec![
            format!(
                "  limit: THEOREM\n    (FORALL (s: systemState): {} IMPLIES converges?(s)) IFF {}\n",
                starts(h.starts),
                weights(h.weights)
            ),
            "  rate: THEOREM\n    FORALL (s: systemState, m: nnreal):\n      0 < eps AND eps <= 1/2 AND anchored?(s) AND\n      (FORALL (j: drone_id): abs(err(s, j)) <= m * contraction_weight(j))\n      IMPLIES FORALL (k: nat, i: drone_id):\n        abs(err(placement(s, k), i)) <=\n          expt(1 - 8 * eps / (N - 1) / (N - 1), k) * m * contraction_weight(i)\n".to_owned(),
        ],
    }
}

/// The mirror image of 7.3 and the box, which the paper does not state.
const COMPANIONS: &str = "  % Companions of 7.3, not in the paper: the mirror image, and the box.
  mirror: THEOREM
    FORALL (s: systemState):
      0 <= eps AND eps <= 1/2 AND anchored?(s) AND
      (FORALL (i: drone_id): getx(s, i) >= target(i))
      IMPLIES FORALL (k: nat, i: drone_id): getx(placement(s, k), i) >= target(i)

  box: THEOREM
    FORALL (s: systemState):
      0 <= eps AND eps <= 1/2 AND anchored?(s) AND
      (FORALL (i: drone_id): seg_min <= getx(s, i) AND getx(s, i) <= seg_max)
      IMPLIES FORALL (k: nat, i: drone_id):
        seg_min <= getx(placement(s, k), i) AND getx(placement(s, k), i) <= seg_max

";
