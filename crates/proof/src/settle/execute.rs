//! The true settling step of one run, step by step.

use std::cmp::Ordering;

use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::scaled_error;
use cordon_spec::{Ordered, Params, State};
use num_bigint::BigInt;

use super::{beyond_half, ends};
use cordon_core::linear::perron::Perron;
use cordon_core::{Rational, progress};

/// The first step from which on every error of the run is at most `within`; `None` where the
/// scalars cannot tell, or the run is longer than `steps`; about `expected` are thought to be enough.
pub fn settling_step<S: Ordered>(
    start: &[Rational],
    eps: &Rational,
    within: &Rational,
    vector: &Perron,
    [expected, steps]: [u64; 2],
    scalar: impl Fn(&Rational) -> S,
) -> Option<u64> {
    let count = start.len();
    let (min, max) = ends(start);
    let params = Params { min: scalar(&min), max: scalar(&max), eps: scalar(eps), n: 0 };
    // Errors come multiplied by N-1.
    let bound = scalar(&(within * Rational::from_integer((count - 1).into())));
    let norm = NormBound::new(eps, vector, &bound, &scalar);
    let mut state = State { drones: start.iter().map(&scalar).collect::<Vec<S>>(), timesteps: 0 };
    let mut settled_from = 0;
    progress::expect(expected.min(steps));
    for k in 0..=steps {
        progress::advance(1);
        let errors = (1..count - 1)
            .map(|i| scaled_error(&params.min, &params.max, &state.drones, i))
            .collect::<Vec<S>>();
        if !all_at_most(&errors, |_| &bound)? {
            settled_from = k + 1;
        } else if norm.settles(&errors)? {
            return Some(settled_from);
        }
        state = exec_coverage(&params, &state);
    }
    None
}

/// |e_i| <= f w_i for all i, with f as large as keeps every f w_i within the distance. No step
/// leaves that region, whatever step it is met at.
struct NormBound<S> {
    /// Nothing to be checked beyond the distance itself: w = (1, ..., 1), for eps <= 1/2.
    weights: Option<Vec<S>>,
}

impl<S: Ordered> NormBound<S> {
    fn new(eps: &Rational, vector: &Perron, bound: &S, scalar: &impl Fn(&Rational) -> S) -> Self {
        if !beyond_half(eps) {
            return Self { weights: None };
        }
        let heaviest = vector.weights.iter().max().cloned().unwrap_or_default();
        let share = |w: &BigInt| scalar(&Rational::new(w.clone(), heaviest.clone()));
        let weights = vector.weights.iter().map(|w| share(w) * bound).collect();
        Self { weights: Some(weights) }
    }

    /// `Some(true)` only where the region is certainly met.
    fn settles(&self, errors: &[S]) -> Option<bool> {
        match &self.weights {
            None => Some(true),
            // An unknown answer means one more step, nothing worse.
            Some(weights) => Some(all_at_most(errors, |i| &weights[i]).unwrap_or(false)),
        }
    }
}

/// Whether |e_i| <= limit(i) for all i.
fn all_at_most<'a, S: Ordered + 'a>(errors: &[S], limit: impl Fn(usize) -> &'a S) -> Option<bool> {
    let mut all = Some(true);
    for (i, e) in errors.iter().enumerate() {
        let above = e.compare(limit(i));
        let below = (S::from_int(0) - e).compare(limit(i));
        for side in [above, below] {
            match side {
                Some(Ordering::Greater) => return Some(false),
                Some(_) => {}
                None => all = None,
            }
        }
    }
    all
}
