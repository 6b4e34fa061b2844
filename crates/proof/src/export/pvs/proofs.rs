//! Proof files.
//!
//! A formula is followed by its proof, in comments: a ProofLite script, which `proveit` reads
//! where it stands. PVS itself looks for proofs in a file beside the theories, which holds the
//! same scripts.

use std::fmt::Write as _;

/// What a line of a script begins with.
const MARK: &str = "%|-";

/// The `.prf` file of a file of theories: theory by theory the scripts of its formulas.
pub(super) fn proofs(theories: &str) -> String {
    let mut text = String::new();
    let mut entries = String::new();
    let mut formula = None;
    for line in theories.lines() {
        let command = line.trim_start().strip_prefix(MARK).map(str::trim);
        match (command, formula) {
            (Some("QED"), _) => {
                // The whole script is one command at the root of the proof.
                entries.push_str("\n    nil nil) nil nil))");
                formula = None;
            }
            (Some(command), Some(_)) => {
                let _ = write!(entries, "\n    {command}");
            }
            (Some(command), None) => {
                formula = command.strip_suffix(": PROOF").map(str::trim);
                let name = formula.unwrap_or_default();
                // The number of the default proof; then its name, remark and date.
                let _ = write!(entries, "\n ({name} 0\n  ({name}-1 nil 0\n   (\"\"");
            }
            (None, _) => {}
        }
        if let Some(theory) = line.strip_prefix("END ")
            && !entries.is_empty()
        {
            let _ = writeln!(text, "({}{entries})", theory.trim());
            entries.clear();
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::proofs;

    #[test]
    fn scripts_stand_under_their_theory_and_their_formula() {
        let theories = "a: THEORY
BEGIN
  one: LEMMA 1 = 1
%|- one : PROOF
%|- (then (skeep)
%|-   (assert))
%|- QED
  two: LEMMA 2 = 2
END a
b: THEORY
BEGIN
END b
c: THEORY
BEGIN
  three: LEMMA 3 = 3
%|- three : PROOF
%|- (grind)
%|- QED
END c
";
        let expected = "(a
 (one 0
  (one-1 nil 0
   (\"\"
    (then (skeep)
    (assert))
    nil nil) nil nil)))
(c
 (three 0
  (three-1 nil 0
   (\"\"
    (grind)
    nil nil) nil nil)))
";
        assert_eq!(proofs(theories), expected);
    }
}
