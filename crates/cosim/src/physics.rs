//! The body of a quadcopter: the constants of PROTOCOL section 3.

/// Physical parameters of a drone. Rotor values are deviations from hover, so that gravity appears only
/// where a tilt turns lift into a horizontal force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Gravity g in m/s2.
    pub gravity: f64,
    /// Mass m in kg.
    pub mass: f64,
    /// Thrust factor Kf in kg m.
    pub thrust: f64,
    /// Torque factor Km in kg m2.
    pub torque: f64,
    /// Length of an arm in m.
    pub arm: f64,
    /// Moments of inertia Ixx, Iyy, Izz in kg m2.
    pub inertia: [f64; 3],
    /// Desired yaw psi_d in rad.
    pub yaw: f64,
}

impl Default for Body {
    /// The drone of the paper's runs.
    fn default() -> Self {
        Self {
            gravity: 9.81,
            mass: 1.0,
            thrust: 1.0,
            torque: 1.0,
            arm: 0.3,
            inertia: [0.001; 3],
            yaw: 0.0,
        }
    }
}

impl Body {
    /// sqrt(m g Kf): half the change of thrust per deviation of a rotor from hover, to first order.
    pub fn hover(&self) -> f64 {
        (self.mass * self.gravity * self.thrust).sqrt()
    }

    /// The distance of two drones' centres at which their arms touch, in m.
    pub fn touching(&self) -> f64 {
        2.0 * self.arm
    }

    /// C_z = 2 sqrt(Kf g/m): lift to vertical acceleration.
    pub fn lift(&self) -> f64 {
        2.0 * (self.thrust * self.gravity / self.mass).sqrt()
    }

    /// The body with every parameter rounded to single precision.
    #[must_use]
    pub fn in_single_precision(&self) -> Self {
        Self {
            gravity: single(self.gravity),
            mass: single(self.mass),
            thrust: single(self.thrust),
            torque: single(self.torque),
            arm: single(self.arm),
            inertia: self.inertia.map(single),
            yaw: single(self.yaw),
        }
    }

    /// The parameters that must be positive, with the names of their variables.
    pub(super) fn positive(&self) -> [(&'static str, f64); 8] {
        let [ixx, iyy, izz] = self.inertia;
        [
            ("g", self.gravity),
            ("m", self.mass),
            ("Kf", self.thrust),
            ("Km", self.torque),
            ("arm", self.arm),
            ("Ixx", ixx),
            ("Iyy", iyy),
            ("Izz", izz),
        ]
    }
}

/// `x` rounded to single precision and back.
pub(super) fn single(x: f64) -> f64 {
    f64::from(x as f32)
}
