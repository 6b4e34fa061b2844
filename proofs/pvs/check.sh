#!/usr/bin/env bash
# Exports the theories and has PVS replay their proofs from the .prf files.  Progress
# goes to stderr, results to stdout; the last line is `N passed, N failed`.
# Exit code: 0 all passed, 1 some check failed, 2 the tools are missing.
set -u
export LC_ALL=C
cd "$(dirname "$0")" || exit 2
for tool in pvs proveit cargo; do
  command -v "$tool" >/dev/null 2>&1 || { echo "\`$tool\` not found" >&2; exit 2; }
done

passed=0
failed=0
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

# verdict NAME: passes when the file $work/findings is empty, else shows it.
verdict() {
  if [ -s "$work/findings" ]; then
    failed=$((failed + 1)); echo "FAILED $1"; sed 's/^/  /' "$work/findings"
  else
    passed=$((passed + 1)); echo "passed $1"
  fi
}

: > "$work/findings"
cargo run --quiet --release --manifest-path ../../Cargo.toml -- export pvs --out "$work/pvs" > "$work/files" ||
  echo "cordon export pvs failed" > "$work/findings"
verdict "the theories are exported"

# Nothing is assumed.
cat "$work"/pvs/*.pvs > "$work/text"
sed 's/%.*//' "$work/text" | grep -nwE 'AXIOM|POSTULATE|ASSUMPTION|ASSUMING' > "$work/findings"
verdict "no axiom and no assumption"

# The replay: scripts come from the .prf files, not from the comments.
start=$(date +%s)
(
  cd "$work/pvs" || exit 1
  echo 'top: THEORY BEGIN IMPORTING coverage_theorems, projection, consensus_path, coverage_scenario END top' > top.pvs
  proveit --importchain --no-scripts top.pvs > /dev/null 2>&1
  cat top.summary
) > "$work/summary"
echo "replay: $(($(date +%s) - start)) s" >&2
# Theory, formula and state, from lines `    name.....state   [SHOSTAK](0.01 s)`.
awk '/Proof summary for theory/ {theory = $NF}
  /^    [^ ]+\.\.+[a-z]/ {line = $0; sub(/ *\[.*/, "", line); name = $1; sub(/\.\..*/, "", name)
    sub(/^ *[^ ]*\.\./, "", line); sub(/^\.*/, "", line); print theory "\t" name "\t" line}' \
  "$work/summary" | sort -u > "$work/found"
open=$(sed 's/%.*//' "$work/text" | sed -n 's/^ *\([A-Za-z0-9_]*\): CONJECTURE.*/\1/p' | sort)
while IFS=$'\t' read -r theory name state; do
  [ "$state" = "proved - complete" ] || grep -qxF "$name" <<< "$open" || echo "$theory.$name: $state"
done < "$work/found" > "$work/findings"
[ -s "$work/found" ] || echo "no formula was tried" >> "$work/findings"
grep -hE '^(Error|\*\*\* Error)' "$work/summary" >> "$work/findings"
verdict "every formula is proved, down to its type-correctness conditions"

# The table: each row's theorem was proved, and every theorem stands in it.
: > "$work/findings"
tail -n +2 theorems.tsv > "$work/rows"
while IFS=$'\t' read -r id form theorem theory statement; do
  [ -n "$statement" ] || echo "incomplete row: $id $form $theorem"
  grep -qxF "$theory"$'\t'"$theorem"$'\t'"proved - complete" "$work/found" ||
    echo "$id: \`$theorem\` of \`$theory\` is not proved"
done < "$work/rows" > "$work/findings"
cut -f3 "$work/rows" | sort > "$work/names"
sed 's/%.*//' "$work/text" | sed -n 's/^ *\([A-Za-z0-9_]*\): THEOREM.*/\1/p' | sort -u |
  comm -23 - "$work/names" | sed 's/$/: not listed/' >> "$work/findings"
verdict "theorems.tsv lists what is proved"

proved=$(grep -c 'proved - complete$' "$work/found")
echo "formulas proved: $proved; listed theorems: $(wc -l < "$work/rows"); conjectures: $(grep -c . <<< "$open")"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
