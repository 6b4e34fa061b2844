#!/usr/bin/env bash
# Mutation score of the checker: every mutant that `mutants/` makes has to be noticed by the checker's tests, or to stand in
# tests/equivalent-mutants.tsv with the reason for which nobody can. Ends with 1 where one is left over.
#
#   proofs/checker/mutants.sh [FOLDER]     works in FOLDER [default: target/checker-mutants]
#
# One build has all mutants; `MUTANT=7` switches the seventh on. Most are noticed by the certificates within a second, the others
# are shown to all tests.
set -u
cd "$(dirname "$0")/../.." || exit 2
folder=$(realpath -m "${1:-target/checker-mutants}")
list=proofs/checker/tests/equivalent-mutants.tsv
crate=$folder/checker
rm -rf "$crate" && mkdir -p "$crate/src" || exit 2
# What the tests read, where they look for it.
for name in certificates must-not-prove second-checker; do
    ln -sfn "$PWD/proofs/$name" "$folder/$name"
done
cp -r proofs/checker/tests Cargo.lock "$crate" || exit 2
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
opt-level = 1
debug = false

[workspace]
EOF
build() { (cd "$crate" && cargo test --no-run --message-format short --target-dir "$folder/target" 2>&1); }
tests=$(build | sed -n 's/.*Executable tests.*(\(.*\))$/\1/p')
[ -x "$tests" ] || { build | grep error; exit 2; }
cd "$crate" || exit 2
"$tests" --quiet > "$folder/unchanged.txt" 2>&1 || { cat "$folder/unchanged.txt"; exit 2; }

# A change after which a test never ends is noticed too.
survives() { MUTANT=$1 timeout "$2" "$tests" --quiet "${@:3}" > /dev/null 2>&1; }
: > "$folder/left.txt"
total=0
while IFS= read -r mutant; do
    total=$((total + 1))
    survives "$total" 120 certificates:: && survives "$total" 1200 && echo "$mutant" >> "$folder/left.txt"
done < "$folder/mutants.txt"
cd - > /dev/null || exit 2
unexplained=$(comm -23 <(sort "$folder/left.txt") <(tail -n +2 "$list" | cut -f1 | sort))
left=$(wc -l < "$folder/left.txt")
missed=$(printf '%s' "$unexplained" | grep -c '')
[ "$missed" -gt 0 ] && printf 'not noticed, and not listed as equivalent:\n%s\n' "$unexplained"
echo "$total mutants of the checker: $((total - left)) noticed, $((left - missed)) equivalent (listed), $missed unexplained"
[ "$missed" -eq 0 ]
