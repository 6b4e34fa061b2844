//! The closed loop of one drone along x as a linear system, identified from a run (PROTOCOL section 3).
//!
//! The exact units are run by the same master as in a flight. As many states of one run as the system
//! has dimensions determine it; further states of the run have to agree.

use num_traits::{One, Zero};

use super::exact_units::{ExactControl, ExactPlant, control_var, plant_var};
use super::grid::Grid;
use super::master::{Algorithm, Master};
use super::plant::Integrator;
use super::quotient::Quotient;
use super::unit::Value;
use super::wiring::{Port, Timing, Wiring};
use cordon_core::linear::matrix::{self, Matrix, applied};
use cordon_core::{Error, Rational, Result};

/// Names of the chain's members and of the command, in SI units: m, m/s, .., m/s4.
const STATE: [&str; 5] = ["x", "v", "a", "j", "u"];

/// Length of the plant's chain of integrators, and the indices of position and velocity in it.
const CHAIN: usize = 4;
const X: usize = 0;
const V: usize = 1;

/// States of a run that are checked beyond those that determine the system.
const UNSEEN: usize = 6;

/// The parameters of a drone's loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tuning {
    /// Gain lambda_P in 1/s.
    pub lambda_p: Rational,
    /// Gain lambda_A in 1/s.
    pub lambda_a: Rational,
    /// Communication step in s.
    pub tau: Rational,
    /// Integrator of the plant.
    pub integrator: Integrator,
    /// How values travel between controller and plant.
    pub algorithm: Algorithm,
}

/// A drone's loop along x: `state' = matrix state + command x_d` from grid point to grid point.
///
/// With x_d held at the drone's position the drone is at rest: `command = (1 - matrix) rest`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClosedLoop {
    /// Names of the state's members; the held command u is one of them under a Jacobi master.
    pub state: Vec<&'static str>,
    /// The state transition of one step.
    pub matrix: Matrix,
    /// What a desired position of 1 m adds in a step.
    pub command: Vec<Rational>,
    /// The state at rest at 1 m.
    pub rest: Vec<Rational>,
    /// Forms of the state, the first being x: at any time between two grid points the drone's position
    /// is a convex combination of them and of the next x.
    pub places: Matrix,
    /// What wind can add to the state in a step: a push of 1 m/s at its end and, unless the plant is
    /// evaluated at grid points only, at its beginning.
    pub pushes: Vec<Vec<Rational>>,
    /// The state in which a steady wind of 1 m/s2 leaves the drone at rest, x_d being 0.
    pub trim: Vec<Rational>,
}

impl ClosedLoop {
    /// The loop of a drone with this tuning.
    ///
    /// # Errors
    /// The step is not positive, or the units do not behave as this module assumes.
    pub fn of(tuning: &Tuning) -> Result<Self> {
        let size = match tuning.algorithm {
            Algorithm::Jacobi => STATE.len(),
            Algorithm::GaussSeidel => CHAIN,
        };
        let (zero, one) = (Rational::zero(), Rational::one());
        let states = |start, wanted| -> Result<Matrix> {
            let mut states = run(tuning, start, wanted, 2 * size + UNSEEN)?;
            states.iter_mut().for_each(|s| s.truncate(size));
            Ok(states)
        };
        let resting = states(&one, &one)?;
        let falling = states(&one, &zero)?;
        let rising = states(&zero, &one)?;
        let matrix = identified(&falling)?;
        let (Some(rest), Some(command)) = (resting.first(), rising.get(1)) else {
            return Err(not_linear());
        };
        let step = |s: &Vec<Rational>| -> Vec<Rational> {
            applied(&matrix, s).iter().zip(command).map(|(a, b)| a + b).collect()
        };
        let follows = |run: &Matrix| run.windows(2).all(|pair| step(&pair[0]) == pair[1]);
        if resting.iter().any(|s| s != rest) || !follows(&resting) || !follows(&rising) {
            return Err(not_linear());
        }
        let Motion { places, pushes } = motion(tuning, size)?;
        let mean = &tuning.tau / Rational::from_integer(pushes.len().into());
        let wind: Matrix =
            (0..size).map(|i| vec![pushes.iter().map(|p| &p[i] * &mean).sum()]).collect();
        let left: Matrix = matrix::unit(size)
            .iter()
            .zip(&matrix)
            .map(|(one, row)| one.iter().zip(row).map(|(a, b)| a - b).collect())
            .collect();
        let trim = matrix::solution(&left, &wind).ok_or_else(not_linear)?.concat();
        let state = STATE.iter().take(size).copied().collect();
        let (rest, command) = (rest.clone(), command.clone());
        Ok(Self { state, matrix, command, rest, places, pushes, trim })
    }
}

fn not_linear() -> Error {
    Error::internal("the exact units along x: expected a linear system that rests at x_d")
}

/// The matrix of the linear system that these states are a run of. All states have to agree with it.
fn identified(states: &Matrix) -> Result<Matrix> {
    let size = states.first().map_or(0, Vec::len);
    let (Some(from), Some(to)) = (states.get(..size), states.get(1..=size)) else {
        return Err(not_linear());
    };
    let found = matrix::solution(&from.to_vec(), &to.to_vec()).ok_or_else(not_linear)?;
    let matrix = matrix::transposed(&found);
    let follows = states.windows(2).all(|pair| applied(&matrix, &pair[0]) == pair[1]);
    follows.then_some(matrix).ok_or_else(not_linear)
}

/// Runs controller and plant, the plant at rest at `start` and the desired position held: chain and
/// command at every grid point.
fn run(tuning: &Tuning, start: &Rational, wanted: &Rational, steps: usize) -> Result<Matrix> {
    let mut wiring = Wiring::default();
    let control = ExactControl::new("control", &tuning.lambda_p, &tuning.lambda_a);
    let control = wiring.add(Box::new(control));
    let plant = wiring.add(Box::new(ExactPlant::new("plant", start, tuning.integrator)));
    let x_d = wiring.port(control, "x_d")?;
    wiring.hold(x_d, Value::Exact(Quotient::from(wanted)));
    for k in 0..CHAIN {
        let from = Port { unit: plant, variable: plant_var::X + k };
        let to = Port { unit: control, variable: control_var::CHAIN + k };
        wiring.connect(from, to, Timing::Sampled);
    }
    let command = Port { unit: control, variable: control_var::SNAP };
    let input = Port { unit: plant, variable: plant_var::SNAP };
    wiring.connect(command, input, Timing::Immediate);
    let chain = (0..CHAIN).map(|k| Port { unit: plant, variable: plant_var::X + k });
    let ports: Vec<Port> = chain.chain([command]).collect();
    watched(wiring, &tuning.tau, tuning.algorithm, steps, &ports)
}

/// The values at these ports, at every grid point.
fn watched(
    wiring: Wiring,
    tau: &Rational,
    algorithm: Algorithm,
    steps: usize,
    ports: &[Port],
) -> Result<Matrix> {
    let grid = Grid::new(tau.clone(), steps as u64)?;
    let mut seen = Vec::new();
    Master::new(wiring, grid, algorithm)?.run(|master, _| {
        let values = ports.iter().map(|port| match master.value(*port)? {
            Value::Exact(x) => Ok(x.to_rational()),
            _ => Err(Error::internal("expected an exact value")),
        });
        seen.push(values.collect::<Result<_>>()?);
        Ok(())
    })?;
    Ok(seen)
}

/// The motion between two grid points.
struct Motion {
    places: Matrix,
    pushes: Vec<Vec<Rational>>,
}

/// The plant's motion within a step: with the Euler integrator a straight line, otherwise a polynomial
/// of degree 4 with the positions as its Bernstein coefficients.
fn motion(tuning: &Tuning, size: usize) -> Result<Motion> {
    let unit = |i: usize| -> Vec<Rational> { matrix::unit(size).swap_remove(i) };
    if tuning.integrator == Integrator::Euler {
        return Ok(Motion { places: vec![unit(X)], pushes: vec![unit(V)] });
    }
    // The plant with the command held at 1, on quarters of the step.
    let degree = STATE.len() - 1;
    let whole = |n: usize| Rational::from_integer(n.into());
    let mut wiring = Wiring::default();
    let plant = ExactPlant::new("plant", &Rational::zero(), tuning.integrator);
    let plant = wiring.add(Box::new(plant));
    let port = |k| Port { unit: plant, variable: k };
    wiring.hold(port(plant_var::SNAP), Value::Exact(Quotient::from(&Rational::one())));
    let ports: Vec<Port> = (0..CHAIN).map(|k| port(plant_var::X + k)).collect();
    let quarter = &tuning.tau / whole(degree);
    let steps = 2 * STATE.len() + UNSEEN;
    let mut states = watched(wiring, &quarter, tuning.algorithm, steps, &ports)?;
    states.iter_mut().for_each(|s| s.push(Rational::one()));
    let quarter = identified(&states)?;
    let mut powers = vec![matrix::unit(STATE.len())];
    for k in 0..degree {
        powers.push(matrix::product(&quarter, &powers[k]));
    }
    let sampled: Matrix = powers.iter().map(|p| p[X].clone()).collect();
    // x at i/4 = sum over j of C(4, j) (i/4)^j (1 - i/4)^(4-j) B_j.
    let weight = |i: usize, j: usize| {
        let choices = (0..j).fold(Rational::one(), |c, t| c * whole(degree - t) / whole(t + 1));
        let power = |base: usize, exponent: usize| {
            (0..exponent).fold(Rational::one(), |p, _| p * whole(base) / whole(degree))
        };
        choices * power(i, j) * power(degree - i, degree - j)
    };
    let weights: Matrix =
        (0..=degree).map(|i| (0..=degree).map(|j| weight(i, j)).collect()).collect();
    let mut places = matrix::solution(&weights, &sampled).ok_or_else(not_linear)?;
    // The last one is the next x, and the others do not depend on the command.
    places.truncate(degree);
    if places.iter().any(|place| place.last().is_none_or(|u| !u.is_zero())) {
        return Err(not_linear());
    }
    places.iter_mut().for_each(|place| place.truncate(size));
    let early = powers[degree].iter().take(size).map(|row| row[V].clone()).collect();
    Ok(Motion { places, pushes: vec![unit(V), early] })
}
