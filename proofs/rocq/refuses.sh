#!/usr/bin/env bash
# check.sh can fail: each fault below, put into a copy, has to be refused for
# the reason it names.  Run after check.sh, which builds; the last line is
# `N passed, N failed`.
set -u
export LC_ALL=C
cd "$(dirname "$0")" || exit 2
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# refused NAME REASON: the copy's check fails, and says REASON.
refused() {
  if (cd "$work/copy" && ./check.sh) > "$work/answer" 2> /dev/null; then
    failed=$((failed + 1)); echo "FAILED $1: accepted"
  elif ! grep -qF "$2" "$work/answer"; then
    failed=$((failed + 1)); echo "FAILED $1: refused for another reason"; grep -A3 '^FAILED' "$work/answer"
  else
    passed=$((passed + 1)); echo "passed $1"
  fi
}
fresh() { rm -rf "$work/copy"; cp -a . "$work/copy"; }
ticks=theories/Proofs/Ticks.v

fresh
refused_twin=$( (cd "$work/copy" && ./check.sh) 2> /dev/null | tail -n 1)
case "$refused_twin" in
  *", 0 failed") passed=$((passed + 1)); echo "passed the copy without a fault is accepted" ;;
  *) failed=$((failed + 1)); echo "FAILED the copy without a fault: $refused_twin" ;;
esac

fresh
sed -i '/^Corollary sum_bounded_ticks/s/forall p (s : State R),/forall p (s : State R), 0 = 1 ->/' "$work/copy/$ticks"
refused "a hypothesis that is never met" "FAILED every listed statement and every definition is what statements.txt says"

fresh
sed -i '/^Corollary sum_bounded_ticks/,/^Proof/d' "$work/copy/$ticks"
sed -i '/sum_bounded_ticks/d' "$work/copy/theorems.tsv"
refused "a theorem that has gone with its row" "FAILED every listed statement and every definition is what statements.txt says"

fresh
sed -i '/^execution/d' "$work/copy/theorems.tsv"
refused "no row about the execution" "no row for execution"

fresh
sed -i 's/^Definition tick_error (p : Params R) (s : State R) (k i : nat) : R :=/Definition tick_error (p : Params R) (s : State R) (k i : nat) : R := 0 +/; s/unfold tick_error, error;/unfold tick_error, error; rewrite Rplus_0_l;/' "$work/copy/$ticks"
sed -i 's/:= 0 +$/:= 0 + (/; /:= 0 + ($/{n;s/\.$/)./}' "$work/copy/$ticks"
refused "a definition that has changed" "FAILED every listed statement and every definition is what statements.txt says"

fresh
printf 'Hypothesis zero_is_one : 0 = 1.\n' >> "$work/copy/$ticks"
refused "a hypothesis outside a section" "outside a section: Hypothesis zero_is_one"

fresh
printf 'Lemma open_end : 0 = 1.\nProof. Admitted.\n' >> "$work/copy/$ticks"
refused "an open proof" "assumes: Admitted"

fresh
sed -i '1i closed: ordering_sharp' "$work/copy/assumptions.txt"
refused "a theorem said to rest on nothing" "FAILED the theorems rest on what assumptions.txt says, and on nothing else"

fresh
sed -i '/sig_not_dec/d' "$work/copy/assumptions.txt"
refused "an axiom that is not named" "FAILED the theorems rest on what assumptions.txt says, and on nothing else"

fresh
sed -i '1i -arg -type-in-type' "$work/copy/_CoqProject"
refused "a flag that weakens the kernel" "FAILED _CoqProject passes no other flag"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
