//! The cascaded controller: position commands attitude, attitude commands rotors
//! (PROTOCOL section 3; equations 3 and 4 of the paper, corrected).

use std::sync::OnceLock;

use super::body_variables::{self, Doubles};
use super::grid::Grid;
use super::physics::{Body, single};
use super::unit::{
    Causality, Dimension, Kind, Resumable, Unit, UnitError, Value, Variable, at_variable,
    recalled_reals, wrong_kind,
};

/// Gains of the controller, per second: how fast the error falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains {
    /// lambda_P, of the position.
    pub position: f64,
    /// lambda_A, of the attitude.
    pub attitude: f64,
}

impl Default for Gains {
    /// The gains of the paper's runs.
    fn default() -> Self {
        Self { position: 0.4, attitude: 4.0 }
    }
}

/// Indices of the controller's variables.
pub mod var {
    /// Desired position x_d in m.
    pub const X_D: usize = 0;
    /// Desired position y_d in m.
    pub const Y_D: usize = 1;
    /// Desired position z_d in m.
    pub const Z_D: usize = 2;
    /// The plant's twelve outputs, in the plant's order.
    pub const STATE: usize = 3;
    /// Rotors 1 to 4: deviations from hover in rad/s.
    pub const ROTORS: usize = 15;
    /// Gain lambda_P in 1/s.
    pub const LAMBDA_P: usize = 19;
    /// Gain lambda_A in 1/s.
    pub const LAMBDA_A: usize = 20;
    /// Whether constants are in single precision, as in the recorded runs.
    pub const SINGLE: usize = 21;
    /// The parameters of the body.
    pub const BODY: usize = 22;
}

/// The controller of one drone.
#[derive(Clone, Debug)]
pub struct Control {
    name: String,
    wanted: [f64; 3],
    /// The plant's state as last read.
    state: [f64; 12],
    rotors: [f64; 4],
    gains: Gains,
    single_precision: bool,
    body: Body,
    law: Law,
}

/// The constants of the control law, computed once.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Law {
    position: f64,
    attitude: f64,
    /// C_z, C_phi, C_theta, C_psi.
    climb: f64,
    roll: f64,
    pitch: f64,
    turn: f64,
    /// sin psi_d/g and cos psi_d/g.
    sin_over_g: f64,
    cos_over_g: f64,
    yaw: f64,
}

impl Law {
    pub(super) fn new(body: &Body, gains: Gains) -> Self {
        let [ixx, iyy, izz] = body.inertia;
        let hover = body.hover();
        Self {
            position: gains.position,
            attitude: gains.attitude,
            climb: body.lift(),
            roll: body.arm * hover / ixx,
            pitch: body.arm * hover / iyy,
            turn: body.torque * hover / izz,
            sin_over_g: body.yaw.sin() / body.gravity,
            cos_over_g: body.yaw.cos() / body.gravity,
            yaw: body.yaw,
        }
    }

    /// The law of the recorded runs: doubles computed from single-precision constants, except that C_z
    /// and C_phi were computed before rounding. The desired yaw was not a constant but an input, a
    /// double.
    fn recorded(body: &Body, gains: Gains) -> Self {
        let nominal = Self::new(body, gains);
        let rounded = Gains { position: single(gains.position), attitude: single(gains.attitude) };
        Self {
            climb: single(nominal.climb),
            roll: single(nominal.roll),
            ..Self::new(&Body { yaw: body.yaw, ..body.in_single_precision() }, rounded)
        }
    }

    /// Rotor values. The order of operations is that of the recorded runs, for equal rounding.
    pub(super) fn rotors(&self, wanted: [f64; 3], state: [f64; 12]) -> [f64; 4] {
        let [x_d, y_d, z_d] = wanted;
        let [x, y, z, vx, vy, vz, phi, theta, psi, vphi, vtheta, vpsi] = state;
        let (lp, la) = (self.position, self.attitude);
        let u_x = 2.0 * lp * vx + lp * lp * (x - x_d);
        let u_y = 2.0 * lp * vy + lp * lp * (y - y_d);
        let phi_c = -u_x * self.sin_over_g + u_y * self.cos_over_g;
        let theta_c = -u_x * self.cos_over_g - u_y * self.sin_over_g;
        let w_z = -vz * 2.0 * lp / self.climb - (z - z_d) * lp * lp / self.climb;
        let attitude = |angle: f64, wanted: f64, speed: f64, c: f64| {
            -speed * 2.0 * la / c - (angle - wanted) * la * la / c
        };
        let w_phi = attitude(phi, phi_c, vphi, self.roll);
        let w_theta = attitude(theta, theta_c, vtheta, self.pitch);
        let w_psi = attitude(psi, self.yaw, vpsi, self.turn);
        [
            w_z / 4.0 - w_theta / 2.0 + w_psi / 4.0,
            w_z / 4.0 + w_phi / 2.0 - w_psi / 4.0,
            w_z / 4.0 + w_theta / 2.0 + w_psi / 4.0,
            w_z / 4.0 - w_phi / 2.0 - w_psi / 4.0,
        ]
    }
}

impl Control {
    /// A controller whose rotors are at hover until its first step.
    pub fn new(name: impl Into<String>, gains: Gains) -> Self {
        let body = Body::default();
        Self {
            name: name.into(),
            wanted: [0.0; 3],
            state: [0.0; 12],
            rotors: [0.0; 4],
            gains,
            single_precision: false,
            body,
            law: Law::new(&body, gains),
        }
    }

    /// The controller with the constants of the recorded runs, in single precision.
    #[must_use]
    pub fn as_recorded(mut self) -> Self {
        self.single_precision = true;
        self
    }

    /// The controller for another body.
    #[must_use]
    pub fn with_body(mut self, body: Body) -> Self {
        self.body = body;
        self
    }
}

fn table() -> &'static [Variable] {
    static TABLE: OnceLock<Vec<Variable>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let real = |name: &str, dimension, causality, start, text| {
            Variable::new(name, dimension, causality, Value::Real(start), text)
        };
        let wanted = |n| real(n, Dimension::METRE, Causality::Input, 0.0, "wanted position");
        let mut table: Vec<_> = ["x_d", "y_d", "z_d"].map(wanted).into();
        table.extend(body_variables::motion(Causality::Input));
        table.extend(body_variables::rotors(Causality::Output));
        let Gains { position, attitude } = Gains::default();
        for (name, start, text) in [
            ("lambda_P", position, "gain of the position"),
            ("lambda_A", attitude, "gain of the attitude"),
        ] {
            table.push(real(name, Dimension::PER_SECOND, Causality::Parameter, start, text));
        }
        table.push(Variable::new(
            "single_precision",
            Dimension::NONE,
            Causality::Parameter,
            Value::Boolean(false),
            "constants in single precision, as in the recorded runs",
        ));
        table.extend(body_variables::parameters());
        table
    })
}

impl Doubles for Control {
    fn double(&self, variable: usize) -> Option<f64> {
        match variable {
            var::X_D..var::STATE => self.wanted.get(variable).copied(),
            var::STATE..var::ROTORS => self.state.get(variable - var::STATE).copied(),
            var::ROTORS..var::LAMBDA_P => self.rotors.get(variable - var::ROTORS).copied(),
            var::LAMBDA_P => Some(self.gains.position),
            var::LAMBDA_A => Some(self.gains.attitude),
            var::BODY.. => body_variables::value(&self.body, variable - var::BODY),
            _ => None,
        }
    }

    fn slot_of(&mut self, variable: usize) -> Option<&mut f64> {
        match variable {
            var::X_D..var::STATE => self.wanted.get_mut(variable),
            var::STATE..var::ROTORS => self.state.get_mut(variable - var::STATE),
            var::LAMBDA_P => Some(&mut self.gains.position),
            var::LAMBDA_A => Some(&mut self.gains.attitude),
            var::BODY.. => body_variables::slot(&mut self.body, variable - var::BODY),
            _ => None,
        }
    }
}

impl Unit for Control {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        table()
    }

    fn set(&mut self, variable: usize, value: &Value) -> Result<(), UnitError> {
        if variable == var::SINGLE {
            let Value::Boolean(single) = value else {
                return Err(wrong_kind(self, variable, Kind::Boolean, value));
            };
            self.single_precision = *single;
            return Ok(());
        }
        self.set_value(variable, value)
    }

    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        match variable {
            var::SINGLE => Ok(Value::Boolean(self.single_precision)),
            _ => self.get_double(variable).map(Value::Real),
        }
    }

    body_variables::doubles_at_once!();

    fn initialise(&mut self, _: &Grid) -> Result<(), UnitError> {
        body_variables::check(self, &self.body)?;
        let Gains { position, attitude } = self.gains;
        for (index, gain) in [(var::LAMBDA_P, position), (var::LAMBDA_A, attitude)] {
            if !gain.is_finite() {
                let what = format!("`{gain}`: expected a finite number");
                return Err(at_variable(self, index, what));
            }
        }
        self.rotors = [0.0; 4];
        self.law = if self.single_precision {
            Law::recorded(&self.body, self.gains)
        } else {
            Law::new(&self.body, self.gains)
        };
        Ok(())
    }

    fn do_step(&mut self, _: &Grid, _: u64) -> Result<(), UnitError> {
        self.rotors = self.law.rotors(self.wanted, self.state);
        Ok(())
    }
}

impl Resumable for Control {
    fn memory(&self) -> Vec<Value> {
        self.rotors.map(Value::Real).into()
    }

    fn recall(&mut self, memory: &[Value]) -> Result<(), UnitError> {
        self.rotors = recalled_reals(self, memory)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    /// A drone at rest with the desired yaw, which is not a single-precision number, has nothing to
    /// correct.
    #[test]
    fn the_wanted_yaw_of_the_recorded_arithmetic_is_a_double() {
        let grid = Grid::new(cordon_core::Rational::new(1.into(), 20.into()), 1).unwrap();
        let mut rotors = Vec::new();
        for actual in [0.1, f64::from(0.1f32)] {
            let body = Body { yaw: 0.1, ..Body::default() };
            let mut control = Control::new("c", Gains::default()).with_body(body).as_recorded();
            control.set(var::STATE + 8, &Value::Real(actual)).unwrap();
            control.initialise(&grid).unwrap();
            control.do_step(&grid, 0).unwrap();
            rotors.push(control.rotors);
        }
        assert!(rotors[0].iter().all(|w| *w == 0.0), "{rotors:?}");
        assert!(rotors[1].iter().all(|w| *w != 0.0), "{rotors:?}");
    }
}
