#!/usr/bin/env bash
# Mutation score of the checker: every mutant that `mutants/` makes has to be noticed by the checker's tests, or to stand in
# tests/equivalent-mutants.tsv with the reason for which nobody can. Ends with 1 where one is left over.
#
#   proofs/checker/mutants.sh [FOLDER [FILE.rs...]]     works in FOLDER [default: target/checker-mutants]; with files, judges theirs only
#
# One build has all mutants; `MUTANT=7` switches the seventh on. The first test that fails ends a run, the quick ones come
# first. FOLDER keeps what was noticed as long as the sources stay: a run that was stopped goes on, and after a new test only those
# left are judged again.
set -u
cd "$(dirname "$0")/../.." || exit 2
folder=$(realpath -m "${1:-target/checker-mutants}")
shift
files=${*:-.*}
files="^(${files// /|}): "
list=proofs/checker/tests/equivalent-mutants.tsv
crate=$folder/checker
# What the tests read, where they look for it.
rm -rf "$folder"/{checker,certificates,must-not-prove,second-checker,rocq} && mkdir -p "$crate/src" "$folder/rocq/theories" || exit 2
cp -r proofs/{certificates,must-not-prove,second-checker} "$folder" && cp proofs/rocq/theories/Kernel.v "$folder/rocq/theories" || exit 2
cp -r proofs/checker/{tests,RULES.md} Cargo.lock "$crate" || exit 2
cargo run --quiet --manifest-path proofs/checker/mutants/Cargo.toml --target-dir "$folder/tool" -- \
    proofs/checker/src "$crate/src" "$folder/mutants.txt" || exit 2
# The versions are those of the lock file.
cat > "$crate/Cargo.toml" <<EOF
[package]
name = "cordon-check"
version = "0.0.0"
edition = "2024"

[dependencies]
cordon-spec = { path = "$PWD/spec", features = ["rational"] }
num-bigint = "*"
num-rational = "*"
num-traits = "*"
serde = { version = "*", features = ["derive"] }
serde_json = "*"

[dev-dependencies]
assert_cmd = "*"

[profile.dev]
opt-level = 2
debug = false

[workspace]
EOF
build() { (cd "$crate" && cargo test --no-run --message-format short --target-dir "$folder/target" 2>&1); }
tests=$(build | sed -n 's/.*Executable tests.*(\(.*\))$/\1/p')
[ -x "$tests" ] || { build | grep error; exit 2; }
sources=$(cat proofs/checker/src/*.rs proofs/checker/src/*/*.rs "$folder/mutants.txt" | sha256sum)
[ "$(cat "$folder/sources" 2> /dev/null)" = "$sources" ] || : > "$folder/noticed"
echo "$sources" > "$folder/sources"
cd "$crate" || exit 2

# Tests by what they cost; those of the second checker alone are left out. A change after which they do not end is noticed too: CPU
# time is counted, and not the clock's.
passes() { (ulimit -t "$2" && MUTANT=$1 exec "$tests" --quiet "${@:3}") > "$folder/last.txt" 2>&1; }
survives() {
    passes "$1" 30 certificates:: work:: && passes "$1" 60 bridge:: meaning:: mutants:: cli:: &&
        passes "$1" 60 second::both && passes "$1" 200 hostile::
}
survives 0 || { cat "$folder/last.txt"; exit 2; }
: > "$folder/left.txt"
number=0 total=0
while IFS= read -r mutant; do
    number=$((number + 1))
    [[ $mutant =~ $files ]] || continue
    total=$((total + 1))
    grep -qx "$number" "$folder/noticed" && continue
    if survives "$number"; then echo "$mutant" >> "$folder/left.txt"; else echo "$number" >> "$folder/noticed"; fi
done < "$folder/mutants.txt"
cd - > /dev/null || exit 2
listed=$(tail -n +2 "$list" | cut -f1 | grep -E "$files" | sort)
unexplained=$(comm -23 <(sort "$folder/left.txt") - <<< "$listed")
stale=$(comm -13 <(sort "$folder/left.txt") - <<< "$listed")
left=$(wc -l < "$folder/left.txt")
missed=$(printf '%s' "$unexplained" | grep -c '')
[ -n "$unexplained" ] && printf 'not noticed, and not listed as equivalent:\n%s\n' "$unexplained"
[ -n "$stale" ] && printf 'listed as equivalent, and noticed or gone:\n%s\n' "$stale"
echo "$total mutants of the checker: $((total - left)) noticed, $((left - missed)) equivalent (listed), $missed unexplained"
[ -z "$unexplained$stale" ]
