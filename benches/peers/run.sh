#!/bin/sh
# Builds Cordon and those of its peers whose tools are installed, runs all on the same work,
# checks that their results are the same, and prints the tables in Markdown on stdout.
#
# Peers: Python 3 (also runs the comparison), FLINT and GMP (Debian: libflint-dev, libgmp-dev),
# SBCL. Set PEERS_LIMIT for another time limit of a run than 60 s. Arguments name tables: exact, products,
# processes, co-simulation, sweeps; what the others need is not built. With `--readme` each table replaces the
# one in the README.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root"
# Where cargo puts what it builds.
target=${CARGO_TARGET_DIR:-$root/target}
build="$target/peers"
mkdir -p "$build"

say() { echo "$*" >&2; }

wanted() { # a table, the arguments
    table=$1
    named=no
    shift
    for name; do
        [ "$name" = "$table" ] && return 0
        [ "$name" = --readme ] || named=yes
    done
    [ "$named" = no ]
}

if wanted exact "$@" || wanted processes "$@"; then
    cargo build --quiet --release --example at
    cp "$target/release/examples/at" "$build/"
fi
cargo build --quiet --release --bin cordon
cp "$target/release/cordon" "$build/"

compile() { # name, libraries, source, flags
    # shellcheck disable=SC2086
    if cc -O3 ${4:-} ${CPPFLAGS:-} ${LDFLAGS:-} -o "$build/$1" "$here/${3:-$1}.c" $2 2>"$build/$1.log"; then :; else
        say "without $1: its libraries are not installed ($build/$1.log)"
    fi
}
if wanted exact "$@" || wanted processes "$@"; then
    compile flint "-lflint -lgmp -lm"
    compile multiply "-lgmp"
    command -v sbcl >/dev/null || say "without SBCL: not installed"
fi
if wanted products "$@"; then
    cargo build --quiet --release --example product
    cp "$target/release/examples/product" "$build/"
    compile multiply "-lgmp"
    compile fft_small "-lflint -lgmp -lm" multiply "-march=x86-64-v3 -DFFT_SMALL"
fi
if wanted co-simulation "$@"; then compile swarm "-lm"; fi
if wanted sweeps "$@"; then
    compile sweep ""
    compile sweep-avx2 "" sweep -march=x86-64-v3
    compile sweep32 "" sweep -DNUMBER=int32_t
    compile sweep32-avx2 "" sweep "-march=x86-64-v3 -DNUMBER=int32_t"
fi
exec python3 "$here/run.py" "$build" "$@"
