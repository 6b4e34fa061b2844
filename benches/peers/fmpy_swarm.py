"""How much faster `cordon cosim` is than FMPy running the same 15 FMUs.

    python benches/peers/fmpy_swarm.py [--cordon target/release/cordon] [--runs 5]

Needs FMPy (`pip install fmpy`) and the built program with its FMU binary
(`cargo build --release -p cordon -p cordon-fmu`). Both fly scenarios/paper.toml: 5 drones, 25 s,
501 grid points. FMPy is timed while stepping only; cordon from start to end of its process, with
reading the scenario, collision search and writing the run. The least of the runs counts.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENARIO = ROOT / "scenarios" / "paper.toml"
MASTER = ROOT / "tests" / "fmpy" / "multi_model.py"


def run(command):
    return subprocess.run(command, check=True, capture_output=True, text=True)


def timed(command):
    began = time.perf_counter()
    run(command)
    return time.perf_counter() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cordon", default=str(ROOT / "target" / "release" / "cordon"))
    parser.add_argument("--runs", type=int, default=5)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        ours = str(Path(folder) / "ours.csv")
        theirs = str(Path(folder) / "theirs.csv")
        cosim = [arguments.cordon, "cosim", str(SCENARIO), "--out", ours]
        cordon = min(timed(cosim) for _ in range(arguments.runs))
        print(f"cordon cosim, whole process:  {1000 * cordon:8.1f} ms")
        for version in ("2", "3"):
            system = str(Path(folder) / version)
            run([arguments.cordon, "export", "into-cps", str(SCENARIO), "--fmi", version,
                 "--out", system])
            fly = [sys.executable, str(MASTER), f"{system}/multi-model.json", "--time",
                   "--out", theirs]
            fmpy = min(float(run(fly).stderr.split()[-1]) for _ in range(arguments.runs))
            print(f"FMPy, FMI {version}.0, stepping only: {1000 * fmpy:8.1f} ms, "
                  f"{fmpy / cordon:.0f} times as long")


if __name__ == "__main__":
    main()
