#!/usr/bin/env bash
# Mutation score of the spec: `cargo mutants` changes it, one expression at a time; the harness
# bodies have to notice, or the tests of the root, or the change has to stand in
# equivalent-mutants.tsv with the reason for which nobody can. Ends with 1 where one is left over.
#
#   kani/mutants.sh [FOLDER]     results go to FOLDER/mutants.out [default: target/mutants]
set -u
cd "$(dirname "$0")/.." || exit 2
folder=${1:-target/mutants}
list=kani/equivalent-mutants.tsv
mkdir -p "$folder" || exit 2
rm -rf "$folder/mutants.out" "$folder/mutants.out.old"
# Each change is built anew: fast builds, which the short tests outweigh.
export CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_DEBUG=0
export CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 CARGO_INCREMENTAL=1

count() { cat "$@" 2>/dev/null | wc -l; }
found=$folder/mutants.out

cargo mutants --package cordon-spec --jobs 2 --timeout 90 --output "$folder"
[ -f "$found/caught.txt" ] || { echo "cargo mutants did not run" >&2; exit 2; }
# A change after which a test never ends is noticed too.
bodies=$(count "$found/caught.txt" "$found/timeout.txt")
unviable=$(count "$found/unviable.txt")

if [ "$(count "$found/missed.txt")" -gt 0 ]; then
    cargo mutants --package cordon-spec --iterate --jobs 1 --timeout 300 --output "$folder" \
        --cargo-arg=--package=cordon --cargo-arg=--package=cordon-spec \
        -- --test protocol --test engines --test cli --test sweeps
fi
tests=$(count "$found/caught.txt" "$found/timeout.txt")
[ -d "$folder/mutants.out.old" ] || tests=0

# Without line and column, which move.
left=$(mktemp)
sed -E 's/:[0-9]+:[0-9]+:/:/' "$found/missed.txt" | sort > "$left"
unexplained=$(comm -23 "$left" <(tail -n +2 "$list" | cut -f1 | sort))
equivalent=$(($(count "$left") - $(printf '%s' "$unexplained" | grep -c '')))
rm -f "$left"
[ -n "$unexplained" ] && printf 'not noticed, and not listed as equivalent:\n%s\n' "$unexplained"
total=$((bodies + tests + equivalent + $(printf '%s' "$unexplained" | grep -c '')))
echo "$total mutants of the spec: $bodies noticed by harness bodies, $tests by tests of the root," \
    "$equivalent equivalent (listed), $((total - bodies - tests - equivalent)) unexplained;" \
    "$unviable more do not compile"
[ -z "$unexplained" ]
