"""Runs an INTO-CPS multi-model or an SSP archive with FMPy: fixed step, Jacobi (read all
outputs, set all inputs, step all units).

    python multi_model.py MULTI_MODEL.json|SYSTEM.ssp [--out RUN.csv] [--time]

The FMUs of a multi-model are looked for beside the file. The columns are those of
`logVariables`, for an archive the outputs `x_d` and `x`; every double is written with the digits that read back as the same double. With `--time` the seconds that the
stepping took, without loading and initialising, go to stderr.
"""

import argparse
import json
import shutil
import sys
import time
from pathlib import Path
from xml.etree import ElementTree

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.ssp.ssd import read_ssd

TYPES = {
    "2.0": {"Real": "Real", "Integer": "Integer", "Boolean": "Boolean", "String": "String"},
    "3.0": {t: t for t in ("Float64", "Int64", "Boolean", "String")},
}


class Unit:
    """An instance of an FMU."""

    def __init__(self, name, description, folder):
        self.version = "3.0" if description.fmiVersion.startswith("3") else "2.0"
        self.variables = {v.name: v for v in description.modelVariables}
        kind = FMU3Slave if self.version == "3.0" else FMU2Slave
        self.fmu = kind(
            guid=description.guid if self.version == "2.0" else description.instantiationToken,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.fmu.instantiate(loggingOn=True)

    def _call(self, verb, name):
        variable = self.variables[name]
        kind = TYPES[self.version][variable.type]
        return getattr(self.fmu, verb + kind), [variable.valueReference], variable.type

    def get(self, name):
        getter, reference, kind = self._call("get", name)
        value = getter(reference)[0]
        if kind == "String" and isinstance(value, bytes):
            return value.decode()
        return value

    def set(self, name, value):
        setter, reference, kind = self._call("set", name)
        if kind in ("Real", "Float64"):
            value = float(value)
        elif kind in ("Integer", "Int64"):
            value = int(value)
        elif kind == "String":
            value = str(value)
        setter(reference, [value])

    def enter_initialisation(self):
        if self.version == "2.0":
            self.fmu.setupExperiment(startTime=0.0)
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(startTime=0.0)


def split(port):
    """`{fmu}.instance.variable` in its three parts; variables may have dots of their own."""
    fmu, rest = port.split("}.", 1)
    instance, variable = rest.split(".", 1)
    return fmu + "}", instance, variable


def from_ssp(path):
    """An SSP archive as a multi-model, and the folder that it was extracted to."""
    system = read_ssd(str(path)).system  # validates against the schema
    folder = Path(extract(str(path)))
    root = ElementTree.parse(folder / "SystemStructure.ssd").getroot()
    end = root.find("{*}DefaultExperiment").get("stopTime")
    model = {"fmus": {}, "connections": {}, "parameters": {}, "logVariables": {}}
    name = {}
    for c in system.elements:
        key = "{" + Path(c.source).stem + "}"
        model["fmus"][key] = c.source
        name[c.name] = f"{key}.{c.name}"
        for binding in c.parameterBindings:
            for values in binding.parameterValues:
                for p in values.parameters:
                    value = {"false": False, "true": True}.get(p.value, p.value)
                    model["parameters"][f"{name[c.name]}.{p.name}"] = value
        logged = [k.name for k in c.connectors if k.kind == "output" and k.name in ("x_d", "x")]
        if logged:
            model["logVariables"][name[c.name]] = logged
    for c in system.connections:
        source = f"{name[c.startElement]}.{c.startConnector}"
        target = f"{name[c.endElement]}.{c.endConnector}"
        model["connections"].setdefault(source, []).append(target)
    fmu = read_model_description(str(folder / system.elements[0].source))
    model["algorithm"] = {"size": float(fmu.defaultExperiment.stepSize)}
    model["endTime"] = float(end)
    return model, folder


def run(path, out):
    if path.suffix == ".ssp":
        model, base = from_ssp(path)
    else:
        model, base = json.loads(path.read_text()), path.parent
    ports = set(model["connections"]) | set(model["parameters"])
    ports |= {i for inputs in model["connections"].values() for i in inputs}
    names = sorted({split(p)[:2] for p in ports})
    fmus = {}
    for key, file in model["fmus"].items():
        folder = extract(str(base / file))
        fmus[key] = (read_model_description(folder), folder)
    units = {(key, name): Unit(name, *fmus[key]) for key, name in names}

    def unit(port):
        key, name, variable = split(port)
        return units[(key, name)], variable

    for port, value in model["parameters"].items():
        target, variable = unit(port)
        target.set(variable, value)
    for u in units.values():
        u.enter_initialisation()
    wires = [
        (unit(source), [unit(port) for port in targets])
        for source, targets in model["connections"].items()
    ]

    def exchange():
        sent = [source.get(variable) for (source, variable), _ in wires]
        for value, (_, targets) in zip(sent, wires):
            for target, variable in targets:
                target.set(variable, value)

    exchange()
    for u in units.values():
        u.fmu.exitInitializationMode()

    columns = [
        f"{key}.{variable}" for key, variables in model["logVariables"].items()
        for variable in variables
    ]
    logged = [unit(column) for column in columns]
    step = model["algorithm"]["size"]
    steps = round(model["endTime"] / step)
    rows = []
    began = time.perf_counter()
    for k in range(steps + 1):
        rows.append([k * step] + [u.get(variable) for u, variable in logged])
        if k == steps:
            break
        exchange()
        for u in units.values():
            u.fmu.doStep(currentCommunicationPoint=k * step, communicationStepSize=step)
    seconds = time.perf_counter() - began

    for u in units.values():
        u.fmu.terminate()
        u.fmu.freeInstance()
    folders = [folder for _, folder in fmus.values()]
    if path.suffix == ".ssp":
        folders.append(base)
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
    print(",".join(["time"] + columns), file=out)
    for row in rows:
        print(",".join(repr(x) for x in row), file=out)
    return seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("model", type=Path)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--time", action="store_true")
    arguments = parser.parse_args()
    if arguments.out:
        with arguments.out.open("w") as out:
            seconds = run(arguments.model, out)
    else:
        seconds = run(arguments.model, sys.stdout)
    if arguments.time:
        print(seconds, file=sys.stderr)


if __name__ == "__main__":
    main()
