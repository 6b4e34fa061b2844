//! Swarms of built-in units only, in one loop over plain arrays.
//!
//! Under a Jacobi master every unit reads the outputs of the previous grid point and steps. Where there
//! are no faults and positions are exchanged exactly, the desired positions are the protocol's global
//! run (the projection theorem), and controllers and plants are two functions. Operations and their
//! order are those of the units: a run is the same, byte for byte.

use super::control::{Gains, Law};
use super::coordination::{Exchange, own};
use super::cosimulation::Cosimulation;
use super::master::Algorithm;
use super::physics::Body;
use super::plant::{Dynamics, Integrator, STATE};
use super::record::Axis;
use cordon_core::exact;
use cordon_run::scenario::Scenario;
use cordon_run::trace::{self, Counted, Rows, Selection};

/// All drones at a grid point.
pub(super) struct Fleet<'s> {
    /// The desired positions along each axis.
    pub desired: Vec<Vec<f64>>,
    /// The motion of each drone: position, velocity, attitude, angular rates.
    pub states: Vec<[f64; STATE]>,
    rotors: Vec<[f64; 4]>,
    scenario: &'s Scenario,
    /// The global run from the next protocol step onwards.
    rows: Rows<'s>,
    /// For each axis, which of an agent's variables is the position, and how many there are.
    indices: Vec<usize>,
    variables: usize,
    updates: u64,
    z_d: f64,
    law: Law,
    dynamics: Dynamics,
    integrator: Integrator,
    tau: f64,
}

impl<'s> Fleet<'s> {
    /// The drones at their start; `None` where the swarm has FMUs, faults, or another master, order or
    /// exchange, or where variables inside units are recorded.
    pub(super) fn of(swarm: &'s Cosimulation) -> Option<Self> {
        let Cosimulation { scenario, grid, .. } = swarm;
        let plain = swarm.units.is_empty()
            && swarm.faults.is_empty()
            && swarm.order.is_none()
            && swarm.recorded_variables.is_empty()
            && swarm.algorithm == Algorithm::Jacobi
            && swarm.exchange == Exchange::Exact;
        if !plain {
            return None;
        }
        let last = scenario.steps_until(grid.steps());
        let selection = Selection { unit: Counted::Steps, from: 0, to: last, every: 1 };
        // Runs too long for this are left to the units, which run or refuse them.
        let rows = trace::select(scenario, selection).ok()?;
        let (mut indices, mut variables) = (vec![0], 1);
        if let Some(file) = scenario.own() {
            variables = file.system.variables.len();
            indices = vec![own::position_of(&file.system)];
            indices.extend(own::across_of(&file.system));
        }
        let state = |drone| {
            let place = |axis| exact::to_f64(&swarm.start_of(drone, axis));
            let mut state = [0.0; STATE];
            (state[0], state[1]) = (place(Axis::X), place(Axis::Y));
            state
        };
        let body = Body::default();
        let gains = Gains {
            position: exact::to_f64(&swarm.lambda_p),
            attitude: exact::to_f64(&swarm.lambda_a),
        };
        let mut fleet = Self {
            desired: indices.iter().map(|_| Vec::with_capacity(swarm.count())).collect(),
            states: (0..swarm.count()).map(state).collect(),
            rotors: vec![[0.0; 4]; swarm.count()],
            scenario,
            rows,
            indices,
            variables,
            updates: 0,
            z_d: exact::to_f64(&swarm.z_d),
            law: Law::new(&body, gains),
            dynamics: Dynamics::of(&body),
            integrator: swarm.integrator,
            tau: grid.tau_f64(),
        };
        fleet.update()?;
        Some(fleet)
    }

    /// The desired positions after the next protocol step; `None` where one is out of the range of
    /// doubles.
    fn update(&mut self) -> Option<()> {
        let positions = self.rows.next()?.positions.doubles();
        if !positions.iter().all(|x| x.is_finite()) {
            return None;
        }
        for (desired, index) in self.desired.iter_mut().zip(&self.indices) {
            desired.clear();
            desired.extend(positions.iter().skip(*index).step_by(self.variables));
        }
        Some(())
    }

    /// Advances to grid point `tick`, the next one. `None` where a number is not finite; the units can
    /// then name the drone.
    pub(super) fn advance_to(&mut self, tick: u64) -> Option<()> {
        let nothing = Vec::new();
        let (x, y) = (self.desired.first()?, self.desired.get(1).unwrap_or(&nothing));
        let across = y.iter().copied().chain(std::iter::repeat(0.0));
        let drones = self.states.iter_mut().zip(&mut self.rotors).zip(x).zip(across);
        let mut finite = true;
        for (((state, rotors), x_d), y_d) in drones {
            let commanded = self.law.rotors([*x_d, y_d, self.z_d], *state);
            *state = self.dynamics.after(self.tau, self.integrator, *state, *rotors);
            *rotors = commanded;
            finite &= state.iter().chain(&*rotors).all(|x| x.is_finite());
        }
        let updates = self.scenario.steps_until(tick);
        if updates > self.updates {
            self.updates = updates;
            self.update()?;
        }
        finite.then_some(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::run;
    use cordon_run::scenario::{Flight, parse};

    fn swarm(text: &str, flight: Flight) -> Cosimulation {
        let scenario = parse("test", text).unwrap().finish().unwrap();
        Cosimulation::new(scenario, flight).unwrap()
    }

    fn file(name: &str) -> String {
        let own = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/own/");
        format!("protocol = '{own}{name}'\ntau = 0.05\n")
    }

    /// Numbers, events and texts of a run are those of the units under their master.
    #[test]
    fn the_loop_flies_what_the_units_fly() {
        let five = "start = [0, 10, 20, 30, 100]\nweight = 0.2\ntau = 0.05\n";
        let many: Vec<_> = (0..400).map(|i| (i * i % 977).to_string()).collect();
        let grid: Vec<_> =
            (0..16).flat_map(|i| [(i % 4 * 10).to_string(), (i / 4 * 7).to_string()]).collect();
        let scenarios = [
            format!("{five}period = 4"),
            format!("{five}period = 4\nphase = \"last\""),
            "start = [-5, 10, 9, 30, 120]\nweight = 0.3\nmin = -5\nmax = 120\nperiod = 3"
                .to_owned(),
            "start = [0, 1, 2, 3, 10]\nweight = \"3/4\"\nperiod = 1".to_owned(),
            format!("{five}protocol = \"consensus\"\ngraph = \"ring\"\nperiod = 2"),
            format!("{five}protocol = \"formation\"\ndisplacement = [1, 0, 2, 0, -1]"),
            format!("start = [{}]\nweight = \"2/7\"\nperiod = 2", many.join(", ")),
            format!(
                "{}start = [0, 0, 0.25, 0, -0.25, 0, 0.25, 0, 0, 0]\nperiod = 2",
                file("platoon.toml")
            ),
            format!("{}start = [{}]\nweight = 0.2\nperiod = 4", file("grid.toml"), grid.join(", ")),
            format!("{}start = [0, 1, 2, 3, 10]\nweight = 0.2", file("digraph.toml")),
        ];
        let mut compared = 0;
        for text in &scenarios {
            for integrator in ["euler", "exact"] {
                let flight = Flight {
                    duration: Some(cordon_core::Rational::from_integer(6.into())),
                    integrator: Some(integrator.to_owned()),
                    z_d: Some(cordon_core::Rational::new(3.into(), 7.into())),
                    ..Flight::default()
                };
                let swarm = swarm(text, flight);
                assert!(Fleet::of(&swarm).is_some(), "{text}");
                let (record, ended) = run::by_units(&swarm).unwrap();
                ended.unwrap();
                assert_eq!(run::run(&swarm).unwrap(), record, "{text}, {integrator}");
                assert_eq!(record.rows(), 121);
                compared += 1;
            }
        }
        assert_eq!(compared, 20);
    }

    /// Numbers that are not finite are reported as by the units.
    #[test]
    fn what_is_not_finite_is_left_to_the_units() {
        let text = "start = [0, 10, 100]\nweight = 0.2\ntau = 0.05\n";
        let gain = cordon_core::exact::parse("gain", "1e200").unwrap();
        let flight = Flight { lambda_p: Some(gain), ..Flight::default() };
        let swarm = swarm(text, flight);
        let mut fleet = Fleet::of(&swarm).unwrap();
        assert!((1..40).any(|tick| fleet.advance_to(tick).is_none()));
        let said = run::run(&swarm).unwrap_err().to_string();
        assert!(said.contains("expected a finite number"), "{said}");
    }

    #[test]
    fn disturbed_swarms_are_left_to_the_units() {
        let text = "start = [0, 10, 100]\nweight = 0.2\ntau = 0.05\n";
        let with = |change: &dyn Fn(&mut Cosimulation)| {
            let mut swarm = swarm(text, Flight::default());
            change(&mut swarm);
            Fleet::of(&swarm).is_some()
        };
        assert!(with(&|_| ()));
        assert!(!with(&|s| s.order = Some(vec![0, 1, 2])));
        assert!(!with(&|s| s.algorithm = Algorithm::GaussSeidel));
        assert!(!with(&|s| s.exchange = Exchange::Double));
        assert!(!with(&|s| s.recorded_variables = vec!["*.z".to_owned()]));
    }
}
