//! The variables that plant and controller have in common: the parameters of the body.

use super::physics::Body;
use super::unit::{
    Causality, Dimension, Unit, UnitError, Value, Variable, at_variable, expect_real,
    no_such_variable, not_settable,
};

/// A unit whose variables are all doubles but one.
pub(super) trait Doubles: Unit + Sized {
    /// The value of a variable.
    fn double(&self, variable: usize) -> Option<f64>;

    /// The storage of a parameter or an input.
    fn slot_of(&mut self, variable: usize) -> Option<&mut f64>;

    /// [`Unit::get`] of a double.
    fn get_double(&self, variable: usize) -> Result<f64, UnitError> {
        self.double(variable).ok_or_else(|| no_such_variable(self, variable))
    }

    /// [`Unit::set`] of a double.
    fn set_double(&mut self, variable: usize, x: f64) -> Result<(), UnitError> {
        if let Some(slot) = self.slot_of(variable) {
            *slot = x;
            return Ok(());
        }
        Err(not_settable(self, variable))
    }

    /// [`Unit::set`] for a variable that has to be a double.
    fn set_value(&mut self, variable: usize, value: &Value) -> Result<(), UnitError> {
        let x = expect_real(self, variable, value)?;
        self.set_double(variable, x)
    }
}

/// [`Unit::get_reals`] and [`Unit::set_reals`] of such a unit.
macro_rules! doubles_at_once {
    () => {
        fn get_reals(&self, variables: &[usize], into: &mut [f64]) -> Result<(), UnitError> {
            for (&variable, x) in variables.iter().zip(into) {
                *x = self.get_double(variable)?;
            }
            Ok(())
        }

        fn set_reals(&mut self, variables: &[usize], values: &[f64]) -> Result<(), UnitError> {
            for (&variable, &x) in variables.iter().zip(values) {
                self.set_double(variable, x)?;
            }
            Ok(())
        }
    };
}
pub(super) use doubles_at_once;

/// How many parameters a [`Body`] has.
pub(super) const COUNT: usize = 9;

/// Gains and body as parameters of a unit, with their physical units.
pub(super) fn parameters() -> Vec<Variable> {
    let Body { gravity, mass, thrust, torque, arm, inertia: [ixx, iyy, izz], yaw } =
        Body::default();
    let table: [(_, _, _, &'static str); COUNT] = [
        ("g", Dimension::METRE_PER_SECOND_SQUARED, gravity, "gravity"),
        ("m", Dimension::KILOGRAM, mass, "mass"),
        ("Kf", Dimension::THRUST_FACTOR, thrust, "thrust factor"),
        ("Km", Dimension::TORQUE_FACTOR, torque, "torque factor"),
        ("arm", Dimension::METRE, arm, "length of an arm"),
        ("Ixx", Dimension::KILOGRAM_METRE_SQUARED, ixx, "moment of inertia, roll"),
        ("Iyy", Dimension::KILOGRAM_METRE_SQUARED, iyy, "moment of inertia, pitch"),
        ("Izz", Dimension::KILOGRAM_METRE_SQUARED, izz, "moment of inertia, yaw"),
        ("psi_d", Dimension::RADIAN, yaw, "wanted yaw"),
    ];
    let parameter = |(name, dimension, start, text)| {
        Variable::new(name, dimension, Causality::Parameter, Value::Real(start), text)
    };
    table.into_iter().map(parameter).collect()
}

/// The signals of the four rotors, `w1` to `w4`.
pub(super) fn rotors(causality: Causality) -> Vec<Variable> {
    let text = "speed of a rotor, as the deviation from hover";
    let zero = || Value::Real(0.0);
    let rotor = |name| Variable::new(name, Dimension::RADIAN_PER_SECOND, causality, zero(), text);
    ["w1", "w2", "w3", "w4"].map(rotor).into()
}

/// The twelve numbers of a motion: position, velocity, attitude, angular rates.
pub(super) fn motion(causality: Causality) -> Vec<Variable> {
    let groups = [
        (["x", "y", "z"], Dimension::METRE, "position"),
        (["vx", "vy", "vz"], Dimension::METRE_PER_SECOND, "velocity"),
        (["phi", "theta", "psi"], Dimension::RADIAN, "attitude: roll, pitch, yaw"),
        (["vphi", "vtheta", "vpsi"], Dimension::RADIAN_PER_SECOND, "turning"),
    ];
    let of = |(names, dimension, text): ([&'static str; 3], Dimension, &'static str)| {
        names.map(|n| Variable::new(n, dimension, causality, Value::Real(0.0), text))
    };
    groups.into_iter().flat_map(of).collect()
}

/// The parameter with this index in the table.
pub(super) fn slot(body: &mut Body, index: usize) -> Option<&mut f64> {
    let [ixx, iyy, izz] = &mut body.inertia;
    let slots: [&mut f64; COUNT] = [
        &mut body.gravity,
        &mut body.mass,
        &mut body.thrust,
        &mut body.torque,
        &mut body.arm,
        ixx,
        iyy,
        izz,
        &mut body.yaw,
    ];
    slots.into_iter().nth(index)
}

/// The value of the parameter with this index in the table.
pub(super) fn value(body: &Body, index: usize) -> Option<f64> {
    slot(&mut body.clone(), index).copied()
}

/// Refuses a body that could not fly.
pub(super) fn check(unit: &dyn Unit, body: &Body) -> Result<(), UnitError> {
    let refuse = |name: &str, x: f64, expected: &str| {
        let index = unit.variables().iter().position(|v| v.name == name).unwrap_or(usize::MAX);
        Err(at_variable(unit, index, format!("`{x}`: expected a {expected}")))
    };
    for (name, x) in body.positive() {
        if !(x.is_finite() && x > 0.0) {
            return refuse(name, x, "positive number");
        }
    }
    if !body.yaw.is_finite() {
        return refuse("psi_d", body.yaw, "finite number");
    }
    Ok(())
}
