//! The plant: a quadcopter, linearised around hover (PROTOCOL section 3).

use std::sync::OnceLock;

use super::body_variables::{self, Doubles};
use super::grid::Grid;
use super::physics::Body;
use super::unit::{
    Causality, Dimension, Kind, Resumable, Unit, UnitError, Value, Variable, at_variable,
    recalled_reals, wrong_kind,
};

/// How the plant advances by a communication step, with its inputs held constant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// One explicit Euler step, as in the authors' recorded runs.
    #[default]
    Euler,
    /// The exact solution (zero-order hold): for a chain of integrators a polynomial in time.
    Exact,
}

impl Integrator {
    /// Its name in scenario files and flags.
    pub fn name(self) -> &'static str {
        match self {
            Self::Euler => "euler",
            Self::Exact => "exact",
        }
    }

    /// The integrator with this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Euler, Self::Exact].into_iter().find(|i| i.name() == name)
    }
}

/// Indices of the plant's variables. The state has position, velocity, attitude and angular rates, in
/// this order, three components each.
pub mod var {
    /// Rotors 1 to 4 are at 0 to 3: deviations from hover in rad/s.
    pub const ROTORS: usize = 0;
    /// Position x in m; y and z follow.
    pub const X: usize = 4;
    /// Height z in m.
    pub const Z: usize = 6;
    /// Velocity along x in m/s; y and z follow.
    pub const VX: usize = 7;
    /// Roll phi in rad; pitch theta and yaw psi follow.
    pub const PHI: usize = 10;
    /// Pitch theta in rad.
    pub const THETA: usize = 11;
    /// Roll rate in rad/s; pitch and yaw follow.
    pub const VPHI: usize = 13;
    /// Pitch rate in rad/s.
    pub const VTHETA: usize = 14;
    /// Start along x in m; y and z follow.
    pub const X0: usize = 16;
    /// Start along z in m.
    pub const Z0: usize = 18;
    /// `euler` or `exact`.
    pub const INTEGRATOR: usize = 19;
    /// The parameters of the body.
    pub const BODY: usize = 20;
}

/// The twelve numbers of a rigid body's motion.
pub(super) const STATE: usize = 12;

/// The plant of one drone.
#[derive(Clone, Debug)]
pub struct Plant {
    name: String,
    rotors: [f64; 4],
    /// Position, velocity, attitude, angular rates.
    state: [f64; STATE],
    start: [f64; 3],
    integrator: Integrator,
    body: Body,
    dynamics: Dynamics,
}

/// A body and its derived coefficients, computed once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dynamics {
    body: Body,
    hover: f64,
    lift: f64,
    sin_yaw: f64,
    cos_yaw: f64,
}

impl Plant {
    /// A plant at rest at `start` (x, y, z).
    pub fn new(name: impl Into<String>, start: [f64; 3], integrator: Integrator) -> Self {
        let body = Body::default();
        let mut plant = Self {
            name: name.into(),
            rotors: [0.0; 4],
            state: [0.0; STATE],
            start,
            integrator,
            body,
            dynamics: Dynamics::of(&body),
        };
        plant.reset();
        plant
    }

    /// The plant with another body.
    #[must_use]
    pub fn with_body(mut self, body: Body) -> Self {
        self.body = body;
        self.reset();
        self
    }

    fn reset(&mut self) {
        let [x, y, z] = self.start;
        self.state = [x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        self.dynamics = Dynamics::of(&self.body);
    }
}

impl Dynamics {
    /// The coefficients of a body's equations of motion.
    pub(super) fn of(body: &Body) -> Self {
        Self {
            body: *body,
            hover: body.hover(),
            lift: body.lift(),
            sin_yaw: body.yaw.sin(),
            cos_yaw: body.yaw.cos(),
        }
    }

    /// The state after `t` seconds with constant rotor values.
    pub(super) fn after(
        &self,
        t: f64,
        integrator: Integrator,
        state: [f64; STATE],
        rotors: [f64; 4],
    ) -> [f64; STATE] {
        match integrator {
            Integrator::Euler => self.euler(t, state, rotors),
            Integrator::Exact => self.exact(t, state, rotors),
        }
    }

    /// phi'', theta'', psi'' and z'' from the rotors, in the order of operations of the recorded runs.
    fn accelerations(&self, [w1, w2, w3, w4]: [f64; 4]) -> ([f64; 3], f64) {
        let Self { body, hover, lift, .. } = self;
        let Body { arm, torque, inertia: [ixx, iyy, izz], .. } = body;
        let roll = arm * (hover * ((w2 - w4) / ixx));
        let pitch = arm * (hover * ((w3 - w1) / iyy));
        let yaw = torque * (hover * ((w1 + w3 - w2 - w4) / izz));
        ([roll, pitch, yaw], lift * (w1 + w2 + w3 + w4))
    }

    /// x'' and y'' for an attitude.
    fn horizontal(&self, phi: f64, theta: f64) -> [f64; 2] {
        let Self { sin_yaw, cos_yaw, .. } = self;
        let g = self.body.gravity;
        [g * (sin_yaw * phi + cos_yaw * theta), g * (sin_yaw * theta - cos_yaw * phi)]
    }

    fn euler(&self, t: f64, state: [f64; STATE], rotors: [f64; 4]) -> [f64; STATE] {
        let ([aphi, atheta, apsi], climb) = self.accelerations(rotors);
        let [.., vx, vy, vz, phi, theta, _, vphi, vtheta, vpsi] = state;
        let [ax, ay] = self.horizontal(phi, theta);
        let rates = [vx, vy, vz, ax, ay, climb, vphi, vtheta, vpsi, aphi, atheta, apsi];
        let mut next = state;
        for (x, rate) in next.iter_mut().zip(rates) {
            *x += rate * t;
        }
        next
    }

    fn exact(&self, t: f64, state: [f64; STATE], rotors: [f64; 4]) -> [f64; STATE] {
        let ([aphi, atheta, apsi], climb) = self.accelerations(rotors);
        let [x, y, z, vx, vy, vz, phi, theta, psi, vphi, vtheta, vpsi] = state;
        // x'' is a polynomial a0 + a1 t + a2 t^2/2 within the step.
        let a0 = self.horizontal(phi, theta);
        let a1 = self.horizontal(vphi, vtheta);
        let a2 = self.horizontal(aphi, atheta);
        let (t2, t3, t4) = (t * t / 2.0, t * t * t / 6.0, t * t * t * t / 24.0);
        let place = |x: f64, v: f64, i: usize| x + v * t + a0[i] * t2 + a1[i] * t3 + a2[i] * t4;
        let speed = |v: f64, i: usize| v + a0[i] * t + a1[i] * t2 + a2[i] * t3;
        let turned = |angle: f64, v: f64, a: f64| angle + v * t + a * t2;
        [
            place(x, vx, 0),
            place(y, vy, 1),
            z + vz * t + climb * t2,
            speed(vx, 0),
            speed(vy, 1),
            vz + climb * t,
            turned(phi, vphi, aphi),
            turned(theta, vtheta, atheta),
            turned(psi, vpsi, apsi),
            vphi + aphi * t,
            vtheta + atheta * t,
            vpsi + apsi * t,
        ]
    }
}

fn table() -> &'static [Variable] {
    static TABLE: OnceLock<Vec<Variable>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let mut table = body_variables::rotors(Causality::Input);
        table.extend(body_variables::motion(Causality::Output));
        table.extend(["x0", "y0", "z0"].map(|name| {
            let text = "position at the start";
            Variable::new(name, Dimension::METRE, Causality::Parameter, Value::Real(0.0), text)
        }));
        let euler = Value::Text(Integrator::Euler.name().into());
        let text = "`euler` or `exact`";
        table.push(Variable::new("integrator", Dimension::NONE, Causality::Parameter, euler, text));
        table.extend(body_variables::parameters());
        table
    })
}

impl Doubles for Plant {
    fn double(&self, variable: usize) -> Option<f64> {
        match variable {
            var::ROTORS..var::X => self.rotors.get(variable).copied(),
            var::X..var::X0 => self.state.get(variable - var::X).copied(),
            var::X0..=var::Z0 => self.start.get(variable - var::X0).copied(),
            var::BODY.. => body_variables::value(&self.body, variable - var::BODY),
            _ => None,
        }
    }

    fn slot_of(&mut self, variable: usize) -> Option<&mut f64> {
        match variable {
            var::ROTORS..var::X => self.rotors.get_mut(variable),
            var::X0..=var::Z0 => self.start.get_mut(variable - var::X0),
            var::BODY.. => body_variables::slot(&mut self.body, variable - var::BODY),
            _ => None,
        }
    }
}

impl Unit for Plant {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        table()
    }

    fn set(&mut self, variable: usize, value: &Value) -> Result<(), UnitError> {
        if variable == var::INTEGRATOR {
            let Value::Text(name) = value else {
                return Err(wrong_kind(self, variable, Kind::Text, value));
            };
            self.integrator = Integrator::named(name).ok_or_else(|| {
                at_variable(self, variable, format!("`{name}`: expected `euler` or `exact`"))
            })?;
            return Ok(());
        }
        self.set_value(variable, value)
    }

    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        match variable {
            var::INTEGRATOR => Ok(Value::Text(self.integrator.name().into())),
            _ => self.get_double(variable).map(Value::Real),
        }
    }

    body_variables::doubles_at_once!();

    fn initialise(&mut self, _: &Grid) -> Result<(), UnitError> {
        body_variables::check(self, &self.body)?;
        self.reset();
        Ok(())
    }

    fn do_step(&mut self, grid: &Grid, _: u64) -> Result<(), UnitError> {
        let (t, integrator) = (grid.tau_f64(), self.integrator);
        self.state = self.dynamics.after(t, integrator, self.state, self.rotors);
        Ok(())
    }
}

impl Resumable for Plant {
    fn memory(&self) -> Vec<Value> {
        self.state.map(Value::Real).into()
    }

    fn recall(&mut self, memory: &[Value]) -> Result<(), UnitError> {
        self.state = recalled_reals(self, memory)?;
        Ok(())
    }
}
