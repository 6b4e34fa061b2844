#!/usr/bin/env bash
# Builds the development and checks what README.md promises of it.  Progress goes
# to stderr, results to stdout; the last line is `N passed, N failed`.
# Exit code: 0 all passed, 1 some check failed, 2 the tools are missing.
#
#   ./check.sh          everything but coqchk
#   ./check.sh --chk    coqchk as well: the kernel's independent re-check
#   ./check.sh --pin    builds and writes statements.txt and assumptions.txt anew
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
pin=no
case "${1-}" in
  "") ;;
  --chk) with_chk=yes ;;
  --pin) pin=yes ;;
  *) echo "unknown argument \`$1\`: expected \`--chk\`, \`--pin\` or nothing" >&2; exit 2 ;;
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

# The flags are those of a plain build: none of them weakens the kernel.
grep -v '^theories/.*\.v$' _CoqProject | grep -vxE '(-R theories Cordon)?' > "$work/findings"
verdict "_CoqProject passes no other flag"

# Nothing is assumed by hand and nothing is left open: sentence by sentence, with
# comments and strings gone.  Variables of a section are discharged at its end.
while read -r file; do awk -v file="$file" -f sentences.awk "$file"; done < "$work/present" > "$work/findings"
verdict "no axiom, no open proof, no switched-off check; variables in sections only"

# The build.
: > "$work/findings"
start=$(date +%s)
if ! { make CoqMakefile && make -f CoqMakefile; } > "$work/build" 2>&1; then
  tail -n 30 "$work/build" > "$work/findings"
fi
echo "build: $(($(date +%s) - start)) s" >&2
verdict "every file compiles"

# The table: each row's theorem stands in its file, and nothing has left it whole.
: > "$work/findings"
tail -n +2 theorems.tsv > "$work/rows"
while IFS=$'\t' read -r id form theorem file statement; do
  [ -n "$statement" ] || echo "incomplete row: $id $form $theorem" >> "$work/findings"
  grep -qE "^(Theorem|Corollary|Lemma) $theorem( |\$)" "$file" 2>/dev/null ||
    echo "$id: no theorem \`$theorem\` in \`$file\`" >> "$work/findings"
done < "$work/rows"
cut -f1,2 "$work/rows" | sort | uniq -d | sed 's/^/twice: /' >> "$work/findings"
for id in 7.2 7.3 7.4i 7.4ii 7.5 7.5i 7.5ii 7.6i 7.6ii 7.7 7.8 certificate ticks projection \
  activation delay consensus formation execution finite kernel; do
  cut -f1 "$work/rows" | grep -qxF "$id" || echo "no row for $id" >> "$work/findings"
done
verdict "theorems.tsv names theorems that exist, about everything that is claimed"

# No theorem is proved but unlisted.
: > "$work/findings"
cut -f3 "$work/rows" | sort > "$work/names"
grep -hoE '^(Theorem|Corollary) [A-Za-z0-9_]+' theories/Proofs/*.v | awk '{print $2}' | sort > "$work/proved"
comm -13 "$work/names" "$work/proved" > "$work/findings"
verdict "every Theorem and Corollary is listed"

# What the theorems say, what their words mean, and what they rest on: as printed.
start=$(date +%s)
if ./listed.sh > "$work/Listed.v" &&
  coqc -R theories Cordon "$work/Listed.v" > "$work/printed" 2> "$work/errors"; then
  awk '/^== assumptions of what/ {exit} {print}' "$work/printed" > "$work/statements"
  { grep '^closed: ' assumptions.txt
    awk '/^== assumptions of what/ {found = 1} found {print}' "$work/printed"; } > "$work/assumptions"
  if [ "$pin" = yes ]; then
    cp "$work/statements" statements.txt; cp "$work/assumptions" assumptions.txt
    echo "statements.txt and assumptions.txt written: read the difference before it is committed" >&2
  fi
  diff statements.txt "$work/statements" > "$work/findings"
  verdict "every listed statement and every definition is what statements.txt says"
  diff assumptions.txt "$work/assumptions" > "$work/findings"
  grep '^closed: ' assumptions.txt | sed 's/^closed: //' | grep -vxFf "$work/names" |
    sed 's/$/: closed, but not listed/' >> "$work/findings"
  verdict "the theorems rest on what assumptions.txt says, and on nothing else"
else
  cat "$work/errors" > "$work/findings"
  verdict "every listed statement and every definition prints"
fi
echo "statements: $(($(date +%s) - start)) s" >&2
closed=$(grep -c '^closed: ' assumptions.txt)

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
  "of these closed under the global context: $closed; vectors: $examples"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
