//! A line of drones with drawn positions and weight.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::Setting;
use cordon_spec::{Ordered, Params, Scalar, State};

use crate::bounds::{Bounds, Weights};
use crate::fraction::Fraction;
use crate::source::{Domain, Source};

/// N drones, the first and the last at the ends of the segment.
#[derive(Clone, Debug)]
pub struct Line<const N: usize> {
    /// Of the protocol; every tick is a protocol step.
    pub params: Params<Fraction>,
    /// Of the theorems: the weight as a quotient of integers.
    pub setting: Setting<Fraction>,
    /// The drawn placement.
    pub state: State<[Fraction; N]>,
}

impl<const N: usize> Line<N> {
    /// Draws positions and weight; `min < max` is assumed, as the theorems do.
    ///
    /// Positions are measured from drone 0. That loses nothing: a step commutes with a
    /// translation and the predicates do not see one, which the harnesses
    /// `positions::translation_*` say. It spares the solver a free number in every sum.
    pub fn draw<S: Source>(source: &mut S, bounds: &Bounds) -> Option<Self> {
        let drones = core::array::from_fn(|i| match i {
            0 => 0,
            _ => source.integer(bounds.positions),
        });
        let weight = bounds.weights.draw(source);
        Self::new(source, drones, weight)
    }

    /// Draws the gaps, the first drone being at 0, and the weight: where a violation takes a wide
    /// gap beside narrow ones, few placements show it. There is a gap less than drones.
    pub fn from_gaps<const G: usize, S: Source>(
        source: &mut S,
        gaps: [Domain; G],
        weights: Weights,
    ) -> Option<Self> {
        let mut at = 0;
        let drones = core::array::from_fn(|i| {
            if let Some(gap) = i.checked_sub(1).and_then(|before| gaps.get(before)) {
                at += source.integer(*gap);
            }
            at
        });
        let weight = weights.draw(source);
        Self::new(source, drones, weight)
    }

    fn new<S: Source>(source: &mut S, drones: [i32; N], weight: (i32, i32)) -> Option<Self> {
        source.assume(drones[0] < drones[N - 1])?;
        Some(Self::at(drones, weight))
    }

    /// The line with the drones at these positions and this weight, numerator and denominator.
    pub fn at(drones: [i32; N], (num, den): (i32, i32)) -> Self {
        let drones = drones.map(Fraction::from_int);
        let (min, max) = (drones[0], drones[N - 1]);
        Self {
            params: Params { min, max, eps: Fraction::quotient(num, den), n: 0 },
            setting: Setting {
                min,
                max,
                eps_num: Fraction::from_int(num),
                eps_den: Fraction::from_int(den),
            },
            state: State { drones, timesteps: 0 },
        }
    }

    /// The drawn placement X^0.
    pub fn start(&self) -> &[Fraction; N] {
        &self.state.drones
    }

    /// X^1.
    pub fn next(&self) -> [Fraction; N] {
        exec_coverage(&self.params, &self.state).drones
    }

    /// X^0, ..., X^{K-1}.
    pub fn run<const K: usize>(&self) -> [[Fraction; N]; K] {
        let mut state = self.state.clone();
        core::array::from_fn(|k| {
            if k > 0 {
                state = exec_coverage(&self.params, &state);
            }
            state.drones
        })
    }
}

/// Whether two placements are the same.
pub fn same<S: Ordered>(a: &[S], b: &[S]) -> bool {
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| a.compare(b) == Some(core::cmp::Ordering::Equal))
}
