"""Drives exported FMUs through FMPy: several instances in one process, states to go back to,
clean errors through the logger.

    python one_unit.py PLANT.fmu COORDINATION.fmu

Prints `ok: N checks` and ends with 0 where all of them held.
"""

import shutil
import sys

from fmpy import extract, read_model_description
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

TAU = 0.05
checks = 0


def check(holds, what):
    global checks
    checks += 1
    if not holds:
        sys.exit(f"failed: {what}")


class Fmu:
    """An extracted FMU that makes instances."""

    def __init__(self, path):
        self.folder = extract(path)
        self.description = read_model_description(self.folder)
        self.three = self.description.fmiVersion.startswith("3")
        self.reference = {v.name: v.valueReference for v in self.description.modelVariables}

    def instance(self, name, token=None):
        d = self.description
        kind = FMU3Slave if self.three else FMU2Slave
        made = kind(
            guid=token or (d.instantiationToken if self.three else d.guid),
            unzipDirectory=self.folder,
            modelIdentifier=d.coSimulation.modelIdentifier,
            instanceName=name,
        )
        made.instantiate(loggingOn=True)
        return made

    def real(self, instance, name):
        get = instance.getFloat64 if self.three else instance.getReal
        return get([self.reference[name]])[0]

    def set_real(self, instance, name, value):
        put = instance.setFloat64 if self.three else instance.setReal
        put([self.reference[name]], [value])

    def set_text(self, instance, name, value):
        instance.setString([self.reference[name]], [value])

    def begin(self, instance):
        if self.three:
            instance.enterInitializationMode(startTime=0.0)
        else:
            instance.setupExperiment(startTime=0.0)
            instance.enterInitializationMode()
        instance.exitInitializationMode()

    def step(self, instance, k, size=TAU):
        instance.doStep(currentCommunicationPoint=k * TAU, communicationStepSize=size)

    def end(self, *instances):
        for instance in instances:
            instance.terminate()
            instance.freeInstance()


def refused(call):
    try:
        call()
    except FMICallException:
        return True
    except Exception as e:
        return "null" in str(e).lower() or "instantiate" in str(e).lower()
    return False


def plants(path):
    """Instances do not know of each other; states can be gone back to, in memory and as bytes."""
    fmu = Fmu(path)
    a, b = fmu.instance("a"), fmu.instance("b")
    fmu.set_real(a, "x0", 3.0)
    fmu.set_real(b, "x0", -7.5)
    for plant in (a, b):
        fmu.begin(plant)
    check(fmu.real(a, "x") == 3.0 and fmu.real(b, "x") == -7.5, "two starts in one process")
    for k in range(40):
        fmu.set_real(a, "w3", 0.001)
        fmu.set_real(a, "w1", -0.001)
        fmu.step(a, k)
        fmu.step(b, k)
    check(fmu.real(a, "x") != 3.0, "a plant moves under its rotors")
    check(fmu.real(b, "x") == -7.5, "a plant without rotors stays")

    get = a.getFMUState if fmu.three else a.getFMUstate
    put = a.setFMUState if fmu.three else a.setFMUstate
    free = a.freeFMUState if fmu.three else a.freeFMUstate
    serialize = a.serializeFMUState if fmu.three else a.serializeFMUstate
    restore = a.deserializeFMUState if fmu.three else a.deSerializeFMUstate
    kept = get()
    taken = serialize(kept)
    outputs = [v.name for v in fmu.description.modelVariables if v.causality == "output"]
    at_40 = [fmu.real(a, o) for o in outputs]

    def ten_more():
        for k in range(40, 50):
            fmu.step(a, k)
        return [fmu.real(a, o) for o in outputs]

    at_50 = ten_more()
    check(at_50 != at_40, "ten more steps move the plant")
    put(kept)
    check([fmu.real(a, o) for o in outputs] == at_40, "back at the state")
    check(ten_more() == at_50, "the same ten steps, to the last bit")
    from_bytes = restore(taken)
    put(from_bytes)
    check(ten_more() == at_50, "the same from the serialised state")
    free(kept)
    free(from_bytes)
    check(refused(lambda: restore(b"{}")), "bytes that are no state are refused")

    check(refused(lambda: fmu.step(a, 49)), "a step from another time is refused")
    check(refused(lambda: fmu.step(a, 50, 0.07)), "a step that tau does not divide is refused")
    check(refused(lambda: fmu.set_real(a, "w1", float("nan"))), "NaN is refused")
    check(refused(lambda: fmu.set_real(a, "x0", 1.0)), "a parameter is refused during the run")
    check(refused(lambda: fmu.set_real(a, "x", 1.0)), "an output is refused")
    fmu.step(a, 50, 4 * TAU)
    check(fmu.real(a, "x") != at_50[outputs.index("x")], "a multiple of tau is a step")
    a.reset()
    fmu.begin(a)
    check(fmu.real(a, "x") == 0.0, "a reset plant has its start values")
    fmu.end(a, b)
    check(refused(lambda: fmu.instance("c", "another-identifier")), "a foreign identifier")
    shutil.rmtree(fmu.folder, ignore_errors=True)


def coordination(path):
    """Parameters are checked when the initialisation ends; texts hold exact numbers."""
    fmu = Fmu(path)
    a = fmu.instance("a")
    fmu.set_text(a, "start", "1/3")
    fmu.begin(a)
    check(fmu.real(a, "x_d") == 1 / 3, "an exact start")
    fmu.end(a)
    b = fmu.instance("b")
    check(refused(lambda: fmu.set_text(b, "weight", "a fifth")), "a weight that is no number")
    put = b.setInt64 if fmu.three else b.setInteger
    put([fmu.reference["id"]], [9])
    check(refused(lambda: fmu.begin(b)), "drone 9 of 5 is refused")
    b.freeInstance()
    shutil.rmtree(fmu.folder, ignore_errors=True)


if __name__ == "__main__":
    plants(sys.argv[1])
    coordination(sys.argv[2])
    print(f"ok: {checks} checks")
