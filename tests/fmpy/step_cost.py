"""Measures what an FMU costs a step: in a process of its own, in the program's process, and in FMPy.

    python tests/fmpy/step_cost.py target/release/cordon

Ten of our units (the controllers and plants of five drones) fly as FMUs. A short run is taken from a
long one, so that loading does not count; of five tries the shortest counts. Time is that of the processor, of
all processes together, so that what else the machine does counts little. Prints the rows of the table in
fmu/README.md, in microseconds a step and unit.
"""

import resource
import subprocess
import sys
import tempfile
from pathlib import Path

SHORT, LONG, TRIES, TAU, FMUS = 5, 205, 5, 0.05, 10
SCENARIO = "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n"


def seconds(command):
    def once():
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

    return min(once() for _ in range(TRIES))


def main():
    cordon = sys.argv[1]
    steps = (LONG - SHORT) / TAU
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        units = ""
        for unit in ("control", "plant"):
            fmu = folder / f"{unit}.fmu"
            out = ["--out", str(fmu)]
            subprocess.run([cordon, "fmu", "export", unit, *out], check=True, stdout=subprocess.DEVNULL)
            for drone in range(5):
                units += f'[[unit]]\ndrone = {drone}\nunit = "{unit}"\nfmu = "{fmu}"\n'
        here, foreign = folder / "here.toml", folder / "foreign.toml"
        here.write_text(SCENARIO)
        foreign.write_text(SCENARIO + units)

        def cost(scenario, *flags):
            times = [
                seconds([cordon, "cosim", str(scenario), "--duration", str(duration), *flags])
                for duration in (LONG, SHORT)
            ]
            return (times[0] - times[1]) / steps

        ours = cost(here)
        for name, flags in (("a process of its own", []), ("`--in-process`", ["--in-process"])):
            each = 1e6 * (cost(foreign, *flags) - ours) / FMUS
            print(f"| {name} | {each:.1f} |")

        def fmpy(duration):
            out = folder / f"mm{duration}"
            export = [cordon, "export", "into-cps", str(here), "--duration", str(duration)]
            subprocess.run([*export, "--out", str(out)], check=True, stdout=subprocess.DEVNULL)
            script = Path(__file__).parent / "multi_model.py"
            return seconds([sys.executable, str(script), str(out / "multi-model.json")])

        each = 1e6 * (fmpy(25) - fmpy(5)) / (20 / TAU) / 15
        print(f"| FMPy, all 15 units | {each:.1f} |")


if __name__ == "__main__":
    main()
