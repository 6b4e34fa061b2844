"""A plant of another tool: `pythonfmu build -f glider.py` (PyPI) makes an FMI 2.0 FMU of it. It
glides along x at 1 m/s whatever its rotors do."""

from pythonfmu import Fmi2Causality, Fmi2Slave, Real

class Glider(Fmi2Slave):
    description = "a drone that glides"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        for w in ("w1", "w2", "w3", "w4"):
            setattr(self, w, 0.0)
            self.register_variable(Real(w, causality=Fmi2Causality.input))
        for o in "x y z vx vy vz phi theta psi vphi vtheta vpsi".split():
            setattr(self, o, 0.0)
            self.register_variable(Real(o, causality=Fmi2Causality.output))

    def do_step(self, t, h):
        self.vx = 1.0
        self.x += h * self.vx
        return True
