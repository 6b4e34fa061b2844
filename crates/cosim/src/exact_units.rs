//! Controller and plant along x in exact rationals.
//!
//! With psi_d = 0 gravity g and the constants C cancel in the closed loop (PROTOCOL section
//! 3): with a = g theta and j = g theta' the controller commands the snap
//! u = -(2 lA j + lA^2 (a - a_c)), a_c = -(2 lP v + lP^2 (x - x_d)), and the plant is a chain
//! of four integrators. Everything is rational in lambda_P, lambda_A and tau.

use std::sync::OnceLock;

use cordon_spec::Scalar;

use super::grid::Grid;
use super::plant::Integrator;
use super::quotient::Quotient;
use super::unit::{
    Causality, Dimension, Kind, Unit, UnitError, Value, Variable, no_such_variable, not_settable,
    wrong_kind,
};
use cordon_core::exact::Rational;

/// The plant's chain: position, velocity, acceleration, jerk.
const CHAIN: [(&str, Dimension); 4] = [
    ("x", Dimension::METRE),
    ("v", Dimension::METRE_PER_SECOND),
    ("a", Dimension::METRE_PER_SECOND_SQUARED),
    ("j", JERK),
];
const JERK: Dimension = Dimension("m/s3");
const SNAP: Dimension = Dimension("m/s4");

/// Indices of the controller's variables: the desired position, the chain, the command.
pub(super) mod control_var {
    pub(crate) const WANTED: usize = 0;
    pub(crate) const CHAIN: usize = 1;
    pub(crate) const SNAP: usize = 5;
}

/// Indices of the plant's variables: the command, the chain.
pub(super) mod plant_var {
    pub(crate) const SNAP: usize = 0;
    pub(crate) const X: usize = 1;
}

fn variable(name: &str, dimension: Dimension, causality: Causality) -> Variable {
    let zero = Value::Exact(Quotient::from_int(0));
    Variable::new(name, dimension, causality, zero, "along x, exact")
}

fn expect_exact(unit: &dyn Unit, index: usize, value: &Value) -> Result<Quotient, UnitError> {
    match value {
        Value::Exact(x) => Ok(x.clone()),
        other => Err(wrong_kind(unit, index, Kind::Exact, other)),
    }
}

/// The controller along x.
#[derive(Clone, Debug)]
pub struct ExactControl {
    name: String,
    /// The desired position, then the plant's chain.
    inputs: [Quotient; 5],
    snap: Quotient,
    /// 2 lP, lP^2, 2 lA, lA^2.
    gains: [Quotient; 4],
}

impl ExactControl {
    /// A controller with gains lambda_P and lambda_A in 1/s.
    pub fn new(name: impl Into<String>, lambda_p: &Rational, lambda_a: &Rational) -> Self {
        let two = Rational::from_integer(2.into());
        let gains = [&two * lambda_p, lambda_p * lambda_p, &two * lambda_a, lambda_a * lambda_a];
        Self {
            name: name.into(),
            inputs: std::array::from_fn(|_| Quotient::from_int(0)),
            snap: Quotient::from_int(0),
            gains: gains.each_ref().map(Quotient::from),
        }
    }
}

impl Unit for ExactControl {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        static TABLE: OnceLock<Vec<Variable>> = OnceLock::new();
        TABLE.get_or_init(|| {
            let mut table = vec![variable("x_d", Dimension::METRE, Causality::Input)];
            table.extend(CHAIN.map(|(n, d)| variable(n, d, Causality::Input)));
            table.push(variable("u", SNAP, Causality::Output));
            table
        })
    }

    fn set(&mut self, index: usize, value: &Value) -> Result<(), UnitError> {
        let x = expect_exact(self, index, value)?;
        match self.inputs.get_mut(index) {
            Some(input) => *input = x,
            None => return Err(not_settable(self, index)),
        }
        Ok(())
    }

    fn get(&self, index: usize) -> Result<Value, UnitError> {
        let number = match index {
            control_var::SNAP => Some(&self.snap),
            index => self.inputs.get(index),
        };
        number.cloned().map(Value::Exact).ok_or_else(|| no_such_variable(self, index))
    }

    fn initialise(&mut self, _: &Grid) -> Result<(), UnitError> {
        self.snap = Quotient::from_int(0);
        Ok(())
    }

    fn do_step(&mut self, _: &Grid, _: u64) -> Result<(), UnitError> {
        let [x_d, x, v, a, j] = self.inputs.clone();
        let [two_lp, lp2, two_la, la2] = self.gains.clone();
        let command = two_lp * &v + &(lp2 * &(x - &x_d));
        self.snap = Quotient::from_int(0) - &(two_la * &j + &(la2 * &(a + &command)));
        Ok(())
    }
}

/// The plant along x.
#[derive(Clone, Debug)]
pub struct ExactPlant {
    name: String,
    start: Quotient,
    snap: Quotient,
    chain: [Quotient; 4],
    integrator: Integrator,
    /// tau^k/k! for k = 1 .. 4.
    weights: [Quotient; 4],
}

impl ExactPlant {
    /// A plant at rest at `start`.
    pub fn new(name: impl Into<String>, start: &Rational, integrator: Integrator) -> Self {
        let zero = || Quotient::from_int(0);
        let start = Quotient::from(start);
        Self {
            name: name.into(),
            snap: zero(),
            chain: [start.clone(), zero(), zero(), zero()],
            start,
            integrator,
            weights: std::array::from_fn(|_| zero()),
        }
    }
}

impl Unit for ExactPlant {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        static TABLE: OnceLock<Vec<Variable>> = OnceLock::new();
        TABLE.get_or_init(|| {
            let mut table = vec![variable("u", SNAP, Causality::Input)];
            table.extend(CHAIN.map(|(n, d)| variable(n, d, Causality::Output)));
            table
        })
    }

    fn set(&mut self, index: usize, value: &Value) -> Result<(), UnitError> {
        if index != plant_var::SNAP {
            return Err(not_settable(self, index));
        }
        self.snap = expect_exact(self, index, value)?;
        Ok(())
    }

    fn get(&self, index: usize) -> Result<Value, UnitError> {
        let number = match index {
            plant_var::SNAP => Some(&self.snap),
            index => self.chain.get(index - plant_var::X),
        };
        number.cloned().map(Value::Exact).ok_or_else(|| no_such_variable(self, index))
    }

    fn initialise(&mut self, grid: &Grid) -> Result<(), UnitError> {
        let zero = || Quotient::from_int(0);
        self.chain = [self.start.clone(), zero(), zero(), zero()];
        let mut power = Rational::from_integer(1.into());
        for (weight, k) in self.weights.iter_mut().zip(1..) {
            power = power * grid.tau() / Rational::from_integer(k.into());
            // Euler's rule keeps only the first term of the series.
            let kept = k == 1 || self.integrator == Integrator::Exact;
            *weight = if kept { Quotient::from(&power) } else { zero() };
        }
        Ok(())
    }

    fn do_step(&mut self, _: &Grid, _: u64) -> Result<(), UnitError> {
        // x + v t + a t^2/2 + .., and likewise for every later member of the chain.
        let terms = match self.integrator {
            Integrator::Euler => 1,
            Integrator::Exact => self.weights.len(),
        };
        let series: Vec<Quotient> = self.chain.iter().chain([&self.snap]).cloned().collect();
        for (i, member) in self.chain.iter_mut().enumerate() {
            let rates = series.iter().skip(i + 1).zip(&self.weights).take(terms);
            for (rate, weight) in rates {
                *member = member.clone() + &(weight.clone() * rate);
            }
        }
        Ok(())
    }
}
