//! The proofs that are the same for every protocol.

/// A script as comments.
pub(super) fn proof(name: &str, script: &str) -> String {
    let mut text = format!("%|- {name} : PROOF\n");
    script.lines().for_each(|line| text.push_str(&format!("%|- {line}\n")));
    text + "%|- QED\n"
}

/// What is positive at both ends of a range is positive between.
pub(super) const BETWEEN: &str = r#"
  between_pos: LEMMA
    FORALL (a, b, lo, hi, e: real):
      lo <= e AND e <= hi AND a + lo * b > 0 AND a + hi * b > 0 IMPLIES a + e * b > 0
%|- between_pos : PROOF
%|- (then (skeep) (lemma "pos_times_ge" ("x" "e - lo" "y" "b"))
%|-   (lemma "pos_times_ge" ("x" "hi - e" "y" "-b")) (ground))
%|- QED

  between_nonneg: LEMMA
    FORALL (a, b, lo, hi, e: real):
      lo <= e AND e <= hi AND a + lo * b >= 0 AND a + hi * b >= 0 IMPLIES a + e * b >= 0
%|- between_nonneg : PROOF
%|- (then (skeep) (lemma "pos_times_ge" ("x" "e - lo" "y" "b"))
%|-   (lemma "pos_times_ge" ("x" "hi - e" "y" "-b")) (ground))
%|- QED
"#;

pub(super) const START_MEETS: &str =
    r#"(then (skeep) (expand "start?") (expand "invariant?") (flatten) (ground))"#;

pub(super) const FOLLOWS: &str =
    r#"(then (skeep) (expand "invariant?") (expand "claimed?") (lift-if) (ground))"#;

pub(super) const MOVES: &str =
    r#"(then (skeep) (expand "run?") (flatten) (inst -3 "k") (flatten) (ground))"#;

pub(super) const KEPT: &str = r#"(spread (induct "k")
  ((then (skeep) (expand "run?") (flatten) (lemma "start_meets" ("s" "r(0)")) (assert))
   (then (skolem 1 "j") (flatten) (skeep) (inst -1 "q" "at" "r")
     (lemma "moves" ("q" "q" "at" "at" "r" "r" "k" "j"))
     (lemma "keeps" ("p" "q(j)" "m" "at(j)" "s" "r(j)" "n" "at(j + 1)" "t" "r(j + 1)"))
     (ground))))"#;

pub(super) const ALWAYS: &str = r#"(then (skeep) (lemma "kept") (inst -1 "k" "q" "at" "r")
  (lemma "follows" ("m" "at(k)" "s" "r(k)")) (assert))"#;
