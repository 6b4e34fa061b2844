"""Runs an SSP archive in another tool's master, fixed step:

    python other_masters.py ecos|libcosim SYSTEM.ssp STEPS STEP --out RUN.csv

ecos is `ecospy` (PyPI, with `tbb`), which applies the parameters of the set `parameters`; libcosim is
`libcosimpy` (PyPI). Columns are those of `simulate_ssp.py`; row k has the outputs after step k + 1.
"""

import ctypes
import sys
import tempfile
import zipfile
from pathlib import Path

from fmpy import read_model_description
from fmpy.ssp.ssd import read_ssd


def outputs(archive):
    """Names of components with their FMU's path, and the columns: component and output."""
    components = read_ssd(archive).system.elements
    kinds = [(c.name, k.name) for c in components for k in c.connectors if k.kind == "output"]
    return components, [(c, o) for c, o in kinds if o in ("x_d", "x") and "control" not in c]


def ecos(archive, steps, step, columns, _):
    library = Path(sys.prefix) / "lib" / "libtbb.so.12"
    if library.exists():
        ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
    from ecospy import EcosSimulation

    with EcosSimulation(step_size=step, ssp_path=archive) as simulation:
        simulation.init(parameter_set="parameters")
        for _ in range(steps):
            simulation.step()
            yield [simulation.get_real(f"{c}::{o}") for c, o in columns]
        simulation.terminate()


def libcosim(archive, steps, step, columns, components):
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver

    with tempfile.TemporaryDirectory() as folder:
        zipfile.ZipFile(archive).extractall(folder)
        references = {}
        for c in components:
            description = read_model_description(str(Path(folder) / c.source))
            for v in description.modelVariables:
                references[c.name, v.name] = v.valueReference
        execution = CosimExecution.from_ssp_file(folder, step_size=round(step * 1e9))
        observer = CosimObserver.create_last_value()
        execution.add_observer(observer)
        index = {c.name: execution.slave_index_from_instance_name(c.name) for c in components}
        for _ in range(steps):
            execution.step()
            yield [
                observer.last_real_values(index[c], [references[c, o]])[0] for c, o in columns
            ]


def main():
    tool, archive, steps, step, _, out = sys.argv[1:]
    components, columns = outputs(archive)
    run = {"ecos": ecos, "libcosim": libcosim}[tool]
    with open(out, "w") as file:
        print(",".join(["time"] + [f"{{}}.{c}.{o}" for c, o in columns]), file=file)
        rows = run(archive, int(steps), float(step), columns, components)
        for k, row in enumerate(rows):
            print(",".join(repr(x) for x in [(k + 1) * float(step), *row]), file=file)


if __name__ == "__main__":
    main()
