//! Stepping a start along k and asking a theorem's conclusion at every step, on integers.
//!
//! A [`Window`] holds X^k .. X^{k+span} over the one denominator den^(k+span), and the
//! segment's ends over the same; the predicates of `cordon_spec` are homogeneous, so that
//! nothing is ever divided. Going from k to k+1 steps the last placement and multiplies the
//! others: no placement is computed twice, none is allocated.

use std::mem::replace;

use cordon_spec::Scalar;
use cordon_spec::theorems::{Form, Setting, Theorem, Verdict};

use super::machine::Widened;
use cordon_core::stencil::Stencil;

/// Storage for the positions of one placement: an array where N is known to the compiler, a
/// vector otherwise.
pub trait Shape {
    /// A placement of scalars `S`.
    type Of<S: Clone + Send + Sync>: AsRef<[S]> + AsMut<[S]> + Clone + Send + Sync;

    /// A placement of `count` drones, drone i at `f(i)`.
    fn build<S: Clone + Send + Sync>(count: usize, f: impl FnMut(usize) -> S) -> Self::Of<S>;
}

/// N drones, N known to the compiler; `count` is N.
pub struct Fixed<const N: usize>;

impl<const N: usize> Shape for Fixed<N> {
    type Of<S: Clone + Send + Sync> = [S; N];

    fn build<S: Clone + Send + Sync>(_count: usize, f: impl FnMut(usize) -> S) -> [S; N] {
        std::array::from_fn(f)
    }
}

/// Any number of drones.
pub struct Dynamic;

impl Shape for Dynamic {
    type Of<S: Clone + Send + Sync> = Vec<S>;

    fn build<S: Clone + Send + Sync>(count: usize, f: impl FnMut(usize) -> S) -> Vec<S> {
        (0..count).map(f).collect()
    }
}

/// One protocol step of the placement `x`, the result over `den` times the denominator that
/// `x`, `min` and `max` have. Every drone reads old positions only.
pub fn step<S: Scalar>(stencil: &Stencil<S>, min: &S, max: &S, x: &mut [S]) {
    let Some(last) = x.len().checked_sub(1) else { return };
    let internal = &stencil.internal;
    // The same for every internal drone.
    let ends = internal.min.clone() * min + &(internal.max.clone() * max);
    let mut prec = min.clone();
    for i in 0..=last {
        let next = if i == 0 || i == last {
            let foll = if i == last { max } else { &x[i + 1] };
            let weights = if i == 0 { &stencil.first } else { &stencil.last };
            weights.apply(min, max, &prec, &x[i], foll)
        } else {
            internal.prec.clone() * &prec
                + &(internal.own.clone() * &x[i])
                + &(internal.foll.clone() * &x[i + 1])
                + &ends
        };
        prec = replace(&mut x[i], next);
    }
}

/// X^k .. X^{k+span} and the segment over one denominator.
pub struct Window<S, M> {
    /// The segment over the placements' denominator; the weight as it is.
    pub setting: Setting<S>,
    /// The placements.
    pub run: Vec<M>,
}

impl<S: Scalar + Send + Sync, M: AsRef<[S]> + AsMut<[S]> + Clone> Window<S, M> {
    /// The window of step 0 for a start in a segment.
    pub fn new(setting: Setting<S>, start: M, span: usize, stencil: &Stencil<S>) -> Self {
        let mut window = Self { setting, run: Vec::with_capacity(span + 1) };
        window.run.push(start);
        for _ in 0..span {
            if let Some(newest) = window.run.last().cloned() {
                window.run.push(newest);
            }
            window.lift(stencil);
        }
        window
    }

    /// From step k to step k+1.
    pub fn advance(&mut self, stencil: &Stencil<S>) {
        let span = self.run.len().saturating_sub(1);
        for h in 0..span {
            if let [to, from, ..] = &mut self.run[h..] {
                to.clone_from(from);
            }
        }
        self.lift(stencil);
    }

    /// Steps the newest placement and brings all else to its denominator.
    fn lift(&mut self, stencil: &Stencil<S>) {
        let Setting { min, max, .. } = &mut self.setting;
        let Some((newest, older)) = self.run.split_last_mut() else { return };
        step(stencil, min, max, newest.as_mut());
        for x in older.iter_mut().flat_map(|m| m.as_mut().iter_mut()) {
            scale(x, &stencil.den);
        }
        scale(min, &stencil.den);
        scale(max, &stencil.den);
    }

    /// What a theorem says of this window.
    pub fn verdict(&self, theorem: Theorem, form: Form) -> Verdict
    where
        S: cordon_spec::Ordered,
    {
        theorem.conclusion(form, &self.setting, &self.run)
    }
}

fn scale<S: Scalar>(x: &mut S, by: &S) {
    *x = x.clone() * by;
}

/// The same window on wider integers.
pub fn widened<Sh: Shape, T, S>(
    window: &Window<T, Sh::Of<T>>,
    weight: (&S, &S),
) -> Window<S, Sh::Of<S>>
where
    T: Clone + Send + Sync,
    S: Widened<T> + Clone + Send + Sync,
{
    let convert = |m: &Sh::Of<T>| {
        let x = m.as_ref();
        Sh::build(x.len(), |i| S::widened(&x[i]))
    };
    Window {
        setting: Setting {
            min: S::widened(&window.setting.min),
            max: S::widened(&window.setting.max),
            eps_num: weight.0.clone(),
            eps_den: weight.1.clone(),
        },
        run: window.run.iter().map(convert).collect(),
    }
}
