#!/usr/bin/env bash
# Writes to stdout the Coq file that prints every listed statement, every
# definition, and what the listed theorems rest on.  check.sh compares the
# answers with statements.txt and assumptions.txt.
set -eu
export LC_ALL=C
cd "$(dirname "$0")"
modules() { grep '\.v$' _CoqProject | grep -vE '/(Vectors|Decide)\.v$' | sed 's,^theories/,,; s,/,.,g; s,\.v$,,'; }
echo 'From Coq Require Import ZArith QArith Reals List.'
modules | sed 's/.*/From Cordon Require Import &./'
echo 'Open Scope R_scope.'
echo 'Set Printing Width 100. Set Printing Depth 1000.'
say() { printf 'Goal True. idtac "%s". Abort.\n' "$1"; }
name() { printf '%s.%s' "$(sed 's,^theories/,Cordon.,; s,/,.,g; s,\.v$,,' <<< "$1")" "$2"; }

tail -n +2 theorems.tsv | while IFS=$'\t' read -r id form theorem file _; do
  say "== $id, $form"
  echo "Check $(name "$file" "$theorem")."
done
say '== definitions'
modules | sed 's,\.,/,g; s,.*,theories/&.v,' | while read -r file; do
  { grep -oE '^(#\[[a-z]+\] )?(Definition|Fixpoint|Record|Class|Inductive|Instance) [A-Za-z0-9_]+' "$file" || true; } |
    awk '{print $NF}' | while read -r item; do echo "Print $(name "$file" "$item")."; done
done

# One pass over all proofs, and one over those that rest on nothing.
conjunction() {
  printf 'Definition %s := ' "$1"
  awk '{printf "conj (%s) (", $0} END {printf "I"; for (i = 0; i < NR; i++) printf ")"; print "."}'
  echo "Print Assumptions $1."
}
say '== assumptions of what rests on nothing'
tail -n +2 theorems.tsv | while IFS=$'\t' read -r _ _ theorem file _; do
  if grep -qxF "closed: $theorem" assumptions.txt; then echo "@$(name "$file" "$theorem")"; fi
done | conjunction closed_theorems
say '== assumptions of all'
tail -n +2 theorems.tsv | while IFS=$'\t' read -r _ _ theorem file _; do
  echo "@$(name "$file" "$theorem")"
done | conjunction listed_theorems
