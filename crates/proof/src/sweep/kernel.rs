//! Stepping a start along k and asking a theorem's conclusion at every step, on integers.
//!
//! A [`Window`] holds X^k .. X^{k+span} over the one denominator den^(k+span), and the
//! segment's ends over the same; the predicates of `cordon_spec` are homogeneous, so that
//! nothing is ever divided. Going from k to k+1 steps the last placement and multiplies the
//! others: no placement is computed twice, none is allocated.

use std::mem::replace;

use cordon_spec::theorems::{Form, Setting, Theorem, Verdict};
use cordon_spec::{DroneMap, Scalar};

use num_bigint::BigInt;
use num_traits::Zero;

use super::machine::Widened;
use cordon_core::stencil::{Role, Stencil, Weights};

/// Storage for the positions of one placement: an array where N is known to the compiler, a
/// vector otherwise.
pub trait Shape {
    /// A placement of scalars `S`.
    type Of<S: Clone + Send + Sync>: DroneMap<S> + AsMut<[S]> + Clone + Send + Sync;

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

/// The weights of a [`Stencil`] that are not 0.
#[derive(Clone, Debug)]
pub struct Update<S = BigInt> {
    /// The common denominator.
    pub den: S,
    /// Of drone 0, of every drone between, of drone N-1.
    roles: [Weights<Option<S>>; 3],
}

impl Update {
    /// The weights of a stencil.
    pub fn of(stencil: &Stencil) -> Self {
        let other = |w: &BigInt| (!w.is_zero()).then(|| w.clone());
        let roles = Role::ALL.map(|role| stencil.weights(role).map(other));
        Self { den: stencil.den.clone(), roles }
    }

    /// The same weights as numbers of another kind.
    ///
    /// # Errors
    /// The first that `f` reports.
    pub fn try_map<U, E>(&self, f: impl Fn(&BigInt) -> Result<U, E>) -> Result<Update<U>, E> {
        let role = |w: &Weights<Option<BigInt>>| w.try_map(|w| w.as_ref().map(&f).transpose());
        let [first, internal, last] = &self.roles;
        let roles = [role(first)?, role(internal)?, role(last)?];
        Ok(Update { den: f(&self.den)?, roles })
    }
}

/// The sum of weights times positions.
#[inline(always)]
fn weighted<S: Scalar, const T: usize>(terms: [(&Option<S>, &S); T]) -> Option<S> {
    let mut sum: Option<S> = None;
    for (weight, x) in terms {
        let Some(weight) = weight else { continue };
        let term = weight.clone() * x;
        sum = Some(match sum {
            Some(sum) => sum + &term,
            None => term,
        });
    }
    sum
}

/// One protocol step of the placement `x`, the result over `den` times the denominator that
/// `x`, `min` and `max` have. Every drone reads old positions only.
#[inline(always)]
pub fn step<S: Scalar>(update: &Update<S>, min: &S, max: &S, x: &mut [S]) {
    let Some(last) = x.len().checked_sub(1) else { return };
    let [first, internal, end] = &update.roles;
    // The same for every internal drone.
    let ends = weighted([(&internal.min, min), (&internal.max, max)]);
    let mut prec = min.clone();
    for i in 0..=last {
        let next = if i == 0 || i == last {
            let foll = if i == last { max } else { &x[i + 1] };
            let w = if i == 0 { first } else { end };
            weighted([
                (&w.min, min),
                (&w.max, max),
                (&w.prec, &prec),
                (&w.own, &x[i]),
                (&w.foll, foll),
            ])
        } else {
            let w = internal;
            let line = weighted([(&w.prec, &prec), (&w.own, &x[i]), (&w.foll, &x[i + 1])]);
            match (line, &ends) {
                (Some(line), Some(ends)) => Some(line + ends),
                (line, ends) => line.or_else(|| ends.clone()),
            }
        };
        prec = replace(&mut x[i], next.unwrap_or_else(|| S::from_int(0)));
    }
}

/// X^k .. X^{k+span} and the segment over one denominator.
pub struct Window<S, M> {
    /// The segment over the placements' denominator; the weight as it is.
    pub setting: Setting<S>,
    /// The placements.
    pub run: Vec<M>,
}

impl<S: Scalar + Send + Sync, M: DroneMap<S> + AsMut<[S]> + Clone> Window<S, M> {
    /// The window of step 0 for a start in a segment.
    pub fn new(setting: Setting<S>, start: M, span: usize, update: &Update<S>) -> Self {
        let mut window = Self { setting, run: Vec::with_capacity(span + 1) };
        window.run.push(start);
        for _ in 0..span {
            if let Some(newest) = window.run.last().cloned() {
                window.run.push(newest);
            }
            window.lift(update);
        }
        window
    }

    /// From step k to step k+1.
    #[inline(always)]
    pub fn advance(&mut self, update: &Update<S>) {
        let span = self.run.len().saturating_sub(1);
        for h in 0..span {
            if let [to, from, ..] = &mut self.run[h..] {
                to.clone_from(from);
            }
        }
        self.lift(update);
    }

    /// Steps the newest placement and brings all else to its denominator.
    #[inline(always)]
    fn lift(&mut self, update: &Update<S>) {
        let Setting { min, max, .. } = &mut self.setting;
        let Some((newest, older)) = self.run.split_last_mut() else { return };
        step(update, min, max, newest.as_mut());
        for x in older.iter_mut().flat_map(|m| m.as_mut().iter_mut()) {
            scale(x, &update.den);
        }
        scale(min, &update.den);
        scale(max, &update.den);
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
