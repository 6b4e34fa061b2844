#!/usr/bin/env python3
"""Prints the table of README.md: proves every file here and has the certificate judged again, now.

    cargo build --release && benchmarks/arch-comp/table.py
"""
import json
import pathlib
import re
import subprocess
import tempfile
import time
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
CORDON = HERE.parent.parent / "target/release/cordon"


def run(*args):
    started = time.monotonic()
    done = subprocess.run([CORDON, *args], capture_output=True, text=True)
    return done, time.monotonic() - started


print("| file | asked | certified | ellipsoids | size | found in | checked in |")
print("|---|---|---|---|---|---|---|")
for path in sorted(HERE.glob("*.toml")):
    asked = Fraction(re.search(r'claims = \["e\[i\] >= (-[0-9/]+)"\]', path.read_text())[1])
    with tempfile.TemporaryDirectory() as folder:
        done, found_in = run("prove", "--protocol", path, "--out", folder, "--format", "json")
        claims = json.loads(done.stdout)["claims"]
        row = [path.stem, f"{asked} m"]
        if claims["proved"]:
            checked, checked_in = run("check", claims["file"])
            if checked.returncode:
                raise SystemExit(checked.stdout + checked.stderr)
            certified = float(asked + Fraction(claims["spare"]))
            size = pathlib.Path(claims["file"]).stat().st_size
            row += [f"{certified:.2f} m", claims["ellipsoids"], f"{size / 1000:.1f} kB", f"{found_in:.1f} s", f"{checked_in * 1000:.0f} ms"]
        else:
            row += ["none", "-", "-", f"{found_in:.1f} s", "-"]
    print("|", " | ".join(map(str, row)), "|", flush=True)
