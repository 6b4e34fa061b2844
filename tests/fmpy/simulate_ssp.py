"""Runs an SSP archive with FMPy's own `simulate_ssp` and the archive's one file of parameters.

    python simulate_ssp.py SYSTEM.ssp STOP STEP --out RUN.csv

Row k has the outputs after step k + 1; columns are those of the outputs `x_d` and `x`.
"""

import sys
from pathlib import Path

from fmpy import extract
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import read_ssv

archive, stop, step, _, out = sys.argv[1:]
parameters = read_ssv(str(Path(extract(archive)) / "resources" / "parameters.ssv"))
result = simulate_ssp(
    archive, stop_time=float(stop), step_size=float(step), parameter_set=parameters
)
names = [n for n in result.dtype.names if n.endswith(".x_d") or n.endswith(".x")]
names = [n for n in names if not n.startswith("control")]
with open(out, "w") as file:
    print(",".join(["time"] + ["{}." + n for n in names]), file=file)
    for row in result:
        print(",".join(repr(float(row[n])) for n in ["time"] + names), file=file)
