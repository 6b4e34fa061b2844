//! The impulse response of a drone along x, exactly (PROTOCOL section 3).
//!
//! All drones are the same linear system: actual gaps are the impulse response h of
//! (x_d -> x) applied to desired gaps, so that h >= 0 keeps drones apart. Evidence: exact
//! rationals, every sample up to a bound, and exact stability of the loop.
use crate::common::q;
use cordon_core::Rational;
use cordon_cosim::exact_units::{ExactControl, ExactPlant};
use cordon_cosim::grid::Grid;
use cordon_cosim::master::{Algorithm, Master};
use cordon_cosim::plant::Integrator;
use cordon_cosim::quotient::Quotient;
use cordon_cosim::unit::{Causality, Dimension, Unit, UnitError, Value, Variable};
use cordon_cosim::unit::{no_such_variable, not_settable};
use cordon_cosim::wiring::{Timing, Wiring};
use cordon_spec::Scalar;
use num_traits::{One, Signed, Zero};

/// A unit from outside: 1 m at the first grid point, 0 m from then on.
struct Pulse {
    table: Vec<Variable>,
    now: i32,
}

impl Pulse {
    fn new() -> Self {
        let start = Value::Exact(Quotient::from_int(1));
        let output =
            Variable::new("x_d", Dimension::METRE, Causality::Output, start, "a unit impulse");
        Self { table: vec![output], now: 1 }
    }
}

impl Unit for Pulse {
    fn name(&self) -> &str {
        "pulse"
    }
    fn variables(&self) -> &[Variable] {
        &self.table
    }
    fn set(&mut self, variable: usize, _: &Value) -> Result<(), UnitError> {
        Err(not_settable(self, variable))
    }
    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        match variable {
            0 => Ok(Value::Exact(Quotient::from_int(self.now))),
            _ => Err(no_such_variable(self, variable)),
        }
    }
    fn initialise(&mut self, _: &Grid) -> Result<(), UnitError> {
        self.now = 1;
        Ok(())
    }
    fn do_step(&mut self, _: &Grid, _: u64) -> Result<(), UnitError> {
        self.now = 0;
        Ok(())
    }
}

/// h_0, .., h_last. With the exchange delay the master is Jacobi, without it Gauss-Seidel.
fn response(
    gains: (&str, &str),
    tau: &str,
    integrator: Integrator,
    delayed: bool,
    last: u64,
) -> Vec<Rational> {
    let mut wiring = Wiring::default();
    let pulse = wiring.add(Box::new(Pulse::new()));
    let control = wiring.add(Box::new(ExactControl::new("control", &q(gains.0), &q(gains.1))));
    let plant = wiring.add(Box::new(ExactPlant::new("plant", &q("0"), integrator)));
    let port = |w: &Wiring, unit, name: &str| w.port(unit, name).unwrap();
    let (from, to) = (port(&wiring, pulse, "x_d"), port(&wiring, control, "x_d"));
    wiring.connect(from, to, Timing::Sampled);
    for name in ["x", "v", "a", "j"] {
        let (from, to) = (port(&wiring, plant, name), port(&wiring, control, name));
        wiring.connect(from, to, Timing::Sampled);
    }
    let (from, to) = (port(&wiring, control, "u"), port(&wiring, plant, "u"));
    wiring.connect(from, to, Timing::Immediate);
    let x = port(&wiring, plant, "x");
    let algorithm = if delayed { Algorithm::Jacobi } else { Algorithm::GaussSeidel };
    let mut master = Master::new(wiring, Grid::new(q(tau), last).unwrap(), algorithm).unwrap();
    let mut h = Vec::new();
    master
        .run(|master, _| {
            let Value::Exact(x) = master.value(x)? else { panic!("exact") };
            h.push(x.to_rational());
            Ok(())
        })
        .unwrap();
    h
}

const WAYS: [(Integrator, bool); 4] = [
    (Integrator::Euler, true),
    (Integrator::Euler, false),
    (Integrator::Exact, true),
    (Integrator::Exact, false),
];

/// Samples looked at: 20 s, in which the response has come and gone.
const LAST: u64 = 400;

#[test]
fn the_response_is_nowhere_negative_for_the_papers_gains() {
    let mut samples = 0;
    for gains in [("0.4", "4"), ("0.4", "2")] {
        for (integrator, delayed) in WAYS {
            let h = response(gains, "0.05", integrator, delayed, LAST);
            for (k, hk) in h.iter().enumerate() {
                assert!(!hk.is_negative(), "{gains:?} {integrator:?} {delayed}: h_{k} < 0");
                samples += 1;
            }
            assert!(h.iter().filter(|hk| hk.is_positive()).count() > 380);
            // The sum tends to 1: what is left is below a hundredth.
            let missing = Rational::one() - h.iter().sum::<Rational>();
            assert!(missing.is_positive() && missing < q("1/100"), "{gains:?} {integrator:?}");
        }
    }
    assert_eq!(samples, 8 * (LAST + 1));
}

#[test]
fn the_response_is_somewhere_negative_for_quick_positions() {
    for (integrator, delayed) in WAYS {
        let h = response(("1", "4"), "0.05", integrator, delayed, 300);
        let first = h.iter().position(Signed::is_negative);
        assert!(first.is_some_and(|k| k > 20), "{integrator:?} {delayed}: {first:?}");
    }
}

#[test]
fn a_quick_attitude_is_unstable_at_this_step_with_the_exchange_delay() {
    let stable = |tau, delayed, integrator| {
        let h = response(("1", "10"), tau, integrator, delayed, 24);
        schur_cohn(&characteristic(&h, if delayed { 5 } else { 4 }))
    };
    for integrator in [Integrator::Euler, Integrator::Exact] {
        assert!(!stable("0.05", true, integrator), "{integrator:?}");
        assert!(stable("0.01", true, integrator), "{integrator:?}");
    }
    let calm = response(("0.4", "4"), "0.05", Integrator::Euler, true, 24);
    assert!(schur_cohn(&characteristic(&calm, 5)));
    // And the unstable response does grow.
    let h = response(("1", "10"), "0.05", Integrator::Euler, true, 600);
    assert!(h.iter().any(|hk| hk.abs() > q("1000")));
}

/// The monic polynomial of degree `order` whose recurrence the response satisfies, from its
/// own samples: a linear system, solved exactly, and checked on samples that it has not seen.
fn characteristic(h: &[Rational], order: usize) -> Vec<Rational> {
    // From the sample on at which the impulse is over.
    let from = 2;
    let row =
        |k: usize| -> Vec<Rational> { (0..=order).map(|i| h[from + k + i].clone()).collect() };
    let mut rows: Vec<_> = (0..order).map(row).collect();
    for column in 0..order {
        let pivot = (column..order).find(|r| !rows[*r][column].is_zero()).expect("full order");
        rows.swap(column, pivot);
        let lead = rows[column][column].clone();
        rows[column].iter_mut().for_each(|c| *c /= &lead);
        for r in (0..order).filter(|r| *r != column) {
            let factor = rows[r][column].clone();
            let pivot = rows[column].clone();
            rows[r].iter_mut().zip(&pivot).for_each(|(c, p)| *c -= &factor * p);
        }
    }
    let mut p: Vec<_> = rows.iter().map(|r| -r[order].clone()).collect();
    p.push(Rational::one());
    let unseen = order..h.len() - from - order;
    assert!(unseen.len() > 5);
    for k in unseen {
        let sum: Rational = row(k).iter().zip(&p).map(|(h, c)| h * c).sum();
        assert!(sum.is_zero(), "sample {k}");
    }
    p
}

/// Schur and Cohn: all roots of the polynomial (from the constant upward) are inside the unit
/// circle.
fn schur_cohn(p: &[Rational]) -> bool {
    let (Some(first), Some(last)) = (p.first(), p.last()) else {
        return true;
    };
    if p.len() == 1 {
        return true;
    }
    if first.abs() >= last.abs() {
        return false;
    }
    let reversed = p.iter().rev();
    let reduced: Vec<_> = p.iter().zip(reversed).map(|(a, b)| last * a - first * b).collect();
    schur_cohn(&reduced[1..])
}

#[test]
fn the_stability_test_knows_both_answers() {
    let p = |list: &str| crate::common::qs(list);
    assert!(schur_cohn(&p("-1/2,1")) && !schur_cohn(&p("-1,1")) && !schur_cohn(&p("2,1")));
    assert!(schur_cohn(&p("1/4,0,1")) && !schur_cohn(&p("1,0,1")) && !schur_cohn(&p("0,-5/2,1")));
    assert!(schur_cohn(&p("-1/8,3/4,-3/2,1")));
}
