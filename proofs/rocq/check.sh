#!/usr/bin/env bash
# Builds the development and checks what README.md promises of it.  Progress goes
# to stderr, results to stdout; the last line is `N passed, N failed`.
# Exit code: 0 all passed, 1 some check failed, 2 the tools are missing.
#
#   ./check.sh          everything but coqchk
#   ./check.sh --chk    coqchk as well: the kernel's independent re-check
set -u
export LC_ALL=C
cd "$(dirname "$0")" || exit 2
for tool in coqc coq_makefile make awk; do
  command -v "$tool" >/dev/null 2>&1 || {
    echo "\`$tool\` not found: install it with \`apt-get install coq\`" >&2
    exit 2
  }
done
with_chk=no
case "${1-}" in
  "") ;;
  --chk) with_chk=yes ;;
  *) echo "unknown argument \`$1\`: expected \`--chk\` or nothing" >&2; exit 2 ;;
esac

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

# Every file is compiled: the project file and the folder list the same files.
find theories -name '*.v' | sort > "$work/present"
grep '\.v$' _CoqProject | sort > "$work/listed"
comm -3 "$work/present" "$work/listed" | tr -d '\t' > "$work/findings"
verdict "_CoqProject lists exactly the files present"

# Nothing is assumed by hand and nothing is left open.  Section variables are
# discharged; used outside a section they would show up as assumptions below.
xargs grep -nwE 'Admitted|admit|give_up|bypass_check|Unset +(Guard|Positivity|Universe) +Check(ing)?' \
  < "$work/present" > "$work/findings"
xargs grep -nE '^[[:space:]]*((#\[[^]]*\]|Local|Global)[[:space:]]+)*(Axioms?|Parameters?|Conjectures?)([[:space:]]|$)' \
  < "$work/present" >> "$work/findings"
verdict "no Admitted, admit, Axiom, Parameter or switched-off check"

# The build.  Assumptions.v is compiled apart, below: its output is a result.
: > "$work/findings"
start=$(date +%s)
objects=$(grep '\.v$' _CoqProject | grep -v '/Assumptions\.v$' | sed 's/$/o/')
# shellcheck disable=SC2086 -- one argument a file
if ! { make CoqMakefile && make -f CoqMakefile $objects; } > "$work/build" 2>&1; then
  tail -n 30 "$work/build" > "$work/findings"
fi
echo "build: $(($(date +%s) - start)) s" >&2
verdict "every file compiles"

# The table: each row's theorem stands in its file and is among the assumptions.
: > "$work/findings"
tail -n +2 theorems.tsv > "$work/rows"
while IFS=$'\t' read -r id form theorem file statement; do
  [ -n "$statement" ] || echo "incomplete row: $id $form $theorem" >> "$work/findings"
  grep -qE "^(Theorem|Corollary|Lemma) $theorem( |\$)" "$file" 2>/dev/null ||
    echo "$id: no theorem \`$theorem\` in \`$file\`" >> "$work/findings"
  module=$(basename "$file" .v)
  echo "Print Assumptions Proofs.$module.$theorem."
done < "$work/rows" > "$work/wanted"
grep '^Print Assumptions' theories/Assumptions.v > "$work/asked"
diff "$work/wanted" "$work/asked" >> "$work/findings"
for id in 7.2 7.3 7.4i 7.4ii 7.5i 7.5ii 7.6i 7.6ii 7.7 7.8 projection activation consensus; do
  cut -f1 "$work/rows" | grep -qxF "$id" || echo "no row for $id" >> "$work/findings"
done
verdict "theorems.tsv names theorems that exist, all of them in Assumptions.v"

# No theorem is proved but unlisted.
: > "$work/findings"
cut -f3 "$work/rows" | sort > "$work/names"
grep -hoE '^(Theorem|Corollary) [A-Za-z0-9_]+' theories/Proofs/*.v | awk '{print $2}' | sort > "$work/proved"
comm -13 "$work/names" "$work/proved" > "$work/findings"
verdict "every Theorem and Corollary is listed"

# What each theorem rests on.
: > "$work/findings"
start=$(date +%s)
if coqc -R theories Cordon theories/Assumptions.v > "$work/assumptions" 2> "$work/errors"; then
  # An entry is a line `name : type`, or `name` with its type on the next lines.
  awk '/^[^ ]/ && !/^(Axioms:|Closed under)/ {print $1}' "$work/assumptions" | sort -u > "$work/used"
  grep -vE '^(#|$)' allowed-assumptions.txt | sort > "$work/allowed"
  comm -23 "$work/used" "$work/allowed" | sed 's/^/assumption not allowed: /' > "$work/findings"
  closed=$(grep -c '^Closed under' "$work/assumptions")
  resting=$(grep -c '^Axioms:' "$work/assumptions")
  [ $((closed + resting)) -eq "$(wc -l < "$work/rows")" ] ||
    echo "$closed + $resting answers for $(wc -l < "$work/rows") theorems" >> "$work/findings"
else
  cat "$work/errors" > "$work/findings"; closed=0; resting=0; : > "$work/used"
fi
echo "assumptions: $(($(date +%s) - start)) s" >&2
verdict "no theorem rests on anything outside allowed-assumptions.txt"

# The vectors: as many examples as rows of data.
: > "$work/findings"
rows=$(tail -n +2 vectors.tsv | wc -l)
examples=$(grep -c '^Example .* Qed\.$' theories/Vectors.v)
[ "$rows" -gt 0 ] || echo "no vectors" >> "$work/findings"
[ "$rows" -eq "$examples" ] || echo "$rows rows, $examples examples" >> "$work/findings"
verdict "every vector of vectors.tsv is executed"

# Definitions name Rust twins that exist (where the Rust is at hand).
if [ -d ../../spec/src ]; then
  : > "$work/findings"
  grep -rhoE '\(\* Rust: spec/src/[a-z_/]+\.rs [A-Za-z_:]+' theories/Spec |
    sed 's/^(\* Rust: //; s/:$//' | while read -r file item; do
      grep -qE "(fn|struct|enum|trait|type|const) ${item##*::}\b" "../../$file" 2>/dev/null ||
        echo "no \`$item\` in \`$file\`"
    done > "$work/findings"
  twins=$(grep -rhoE '\(\* Rust: ' theories/Spec | wc -l)
  [ "$twins" -gt 0 ] || echo "no twins named" >> "$work/findings"
  verdict "$twins definitions name Rust twins that exist"
else
  echo "not run: the Rust spec is not at ../../spec" >&2
fi

if [ "$with_chk" = yes ]; then
  : > "$work/findings"
  start=$(date +%s)
  modules=$(grep '\.v$' _CoqProject | sed 's,^theories/,Cordon.,; s,/,.,g; s,\.v$,,')
  # shellcheck disable=SC2086 -- one argument a module
  coqchk -silent -R theories Cordon -norec $modules > "$work/chk" 2>&1 ||
    tail -n 30 "$work/chk" > "$work/findings"
  echo "coqchk: $(($(date +%s) - start)) s" >&2
  verdict "coqchk accepts every module"
fi

lemmas=$(xargs grep -hE '^(Theorem|Corollary|Lemma|Example) ' < "$work/present" | wc -l)
echo "files: $(wc -l < "$work/present"); statements proved: $lemmas; listed theorems: $(wc -l < "$work/rows");" \
  "of these closed under the global context: $closed; over the reals' axioms: $resting; vectors: $examples"
sed 's/^/assumption: /' "$work/used"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
