#!/usr/bin/env bash
# Each definition of the spec that has a twin is changed once, as mutations.tsv
# says: some vector has to change with it, or the vectors say nothing about it.
# The change is made in a copy.  The last line is `N passed, N failed`.
set -u
export LC_ALL=C
cd "$(dirname "$0")/.." || exit 2
root=$PWD
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
git ls-files -z | tar --null --files-from=- -cf - | tar -xf - -C "$work" || exit 2
cd "$work" || exit 2
# Cargo goes by times, and an earlier copy may have been built.
find spec crates/core xtask/src -name '*.rs' -exec touch {} +

# A program with the vectors and nothing else, so that a change builds in seconds.
mkdir -p mutated/src
sed -i 's,^members = \[,members = ["mutated"\, ,' Cargo.toml
cat > mutated/Cargo.toml <<'EOF'
[package]
name = "mutated"
version = "0.0.0"
edition = "2024"

[dependencies]
cordon-core = { path = "../crates/core" }
cordon-spec = { path = "../spec", features = ["alloc"] }
serde_json = "1"
EOF
cat > mutated/src/main.rs <<'EOF'
#![allow(dead_code, unused_imports)]
#[path = "../../xtask/src/vectors/mod.rs"]
mod vectors;
fn main() {
    print!("{}", vectors::tsv(&vectors::vectors()));
}
EOF
export CARGO_TARGET_DIR="$root/target/mutate" RUSTFLAGS="-A warnings"
evaluate() { cargo run -q --offline -p mutated > "$1" 2> "$work/errors"; }

evaluate "$work/before" || { cat "$work/errors" >&2; exit 2; }
cmp -s "$work/before" proofs/rocq/vectors.tsv || { echo "vectors.tsv is not what the spec computes" >&2; exit 2; }
passed=0
failed=0
while IFS=$'\t' read -r file was becomes; do
  text=$(cat "spec/src/$file" && echo x)
  changed=${text/"$was"/"$becomes"}
  if [ "$text" = "$changed" ]; then
    failed=$((failed + 1)); echo "FAILED $file: no \`$was\`"; continue
  fi
  printf '%s' "${changed%x}" > "spec/src/$file"
  if evaluate "$work/after" && cmp -s "$work/before" "$work/after"; then
    failed=$((failed + 1)); echo "FAILED $file: no vector sees \`$becomes\`"
  elif grep -q '^error' "$work/errors"; then
    failed=$((failed + 1)); echo "FAILED $file: \`$becomes\` does not compile"
  else
    passed=$((passed + 1)); echo "passed $file: \`$becomes\`"
  fi
  printf '%s' "${text%x}" > "spec/src/$file"
done < <(tail -n +2 "$root/xtask/mutations.tsv")
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
