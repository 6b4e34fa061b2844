//! Stepping a start along k and asking a theorem's conclusion at every step, on integers.
//!
//! A [`Window`] holds X^k .. X^{k+span} over the one denominator den^(k+span), and the
//! segment's ends over the same; the predicates of `cordon_spec` are homogeneous, so that
//! nothing is ever divided. Going from k to k+1 steps the last placement and multiplies the
//! others: no placement is computed twice, none is allocated.

use std::mem::swap;

use cordon_spec::theorems::{Form, Setting, Theorem, Verdict};
use num_bigint::BigInt;
use num_traits::Zero;

use super::machine::Machine;
use cordon_core::stencil::{Role, Stencil, Weights};

/// The weights of a [`Stencil`]; those that are 0 are left out where that saves work.
#[derive(Clone, Debug)]
pub struct Update<W = BigInt> {
    /// The common denominator.
    pub den: W,
    /// Of drone 0 and of drone N-1.
    outer: [Weights<Option<W>>; 2],
    /// Of every drone between: of the drone before, its own, of the drone after.
    near: [W; 3],
    /// Of every drone between: of the segment's ends.
    far: [Option<W>; 2],
}

impl Update {
    /// The weights of a stencil.
    pub fn of(stencil: &Stencil) -> Self {
        let other = |w: &BigInt| (!w.is_zero()).then(|| w.clone());
        let Weights { min, max, prec, own, foll } = stencil.weights(Role::Internal);
        Self {
            den: stencil.den.clone(),
            outer: [Role::First, Role::Last].map(|role| stencil.weights(role).map(other)),
            near: [prec, own, foll].map(Clone::clone),
            far: [min, max].map(other),
        }
    }

    /// The same weights as numbers of another kind; `None` where `f` has none for one of them.
    pub fn try_map<U>(&self, f: impl Fn(&BigInt) -> Option<U>) -> Option<Update<U>> {
        let other = |w: &Option<BigInt>| match w {
            Some(w) => f(w).map(Some),
            None => Some(None),
        };
        let outer = |w: &Weights<Option<BigInt>>| w.try_map(|w| other(w).ok_or(())).ok();
        let [first, last] = &self.outer;
        let [prec, own, foll] = &self.near;
        let [min, max] = &self.far;
        Some(Update {
            den: f(&self.den)?,
            outer: [outer(first)?, outer(last)?],
            near: [f(prec)?, f(own)?, f(foll)?],
            far: [other(min)?, other(max)?],
        })
    }
}

/// The sum of weights times positions, of those weights that there are.
#[inline(always)]
fn weighted<S: Machine, const T: usize>(terms: [(&Option<S::Weight>, &S); T]) -> Option<S> {
    let mut sum: Option<S> = None;
    for (weight, x) in terms {
        let Some(weight) = weight else { continue };
        let term = S::weigh([(weight, x)]);
        sum = Some(match sum {
            Some(sum) => sum + &term,
            None => term,
        });
    }
    sum
}

/// The next position of a drone at an end of the line, from the segment's ends and the three
/// positions near it.
#[inline(always)]
fn outer<S: Machine>(weights: &Weights<Option<S::Weight>>, x: [&S; 5]) -> S {
    let [min, max, prec, own, foll] = weights.as_array();
    let [a, b, c, d, e] = x;
    let sum = weighted([(min, a), (max, b), (prec, c), (own, d), (foll, e)]);
    sum.unwrap_or_else(|| S::from_int(0))
}

/// One protocol step of the placement `x`, written to `next`, over `den` times the denominator
/// that `x`, `min` and `max` have.
#[inline(always)]
pub fn step<S: Machine>(update: &Update<S::Weight>, min: &S, max: &S, x: &[S], next: &mut [S]) {
    let [prec, own, foll] = &update.near;
    let internal = next.iter_mut().skip(1).zip(x.windows(3));
    for (next, near) in internal {
        if let [before, here, after] = near {
            *next = S::weigh([(prec, before), (own, here), (foll, after)]);
        }
    }
    let [of_min, of_max] = &update.far;
    if let (Some(ends), [_, internal @ .., _]) =
        (weighted([(of_min, min), (of_max, max)]), &mut *next)
    {
        internal.iter_mut().for_each(|x| *x = x.clone() + &ends);
    }
    let [first, last] = &update.outer;
    if let ([here, after, ..], Some(next)) = (x, next.first_mut()) {
        *next = outer(first, [min, max, min, here, after]);
    }
    if let ([.., before, here], Some(next)) = (x, next.last_mut()) {
        *next = outer(last, [min, max, before, here, max]);
    }
}

/// X^k .. X^{k+span} and the segment over one denominator.
pub struct Window<S> {
    /// The segment over the placements' denominator; the weight as it is.
    pub setting: Setting<S>,
    /// The placements.
    pub run: Vec<Vec<S>>,
    /// Room for one more.
    spare: Vec<S>,
}

impl<S: Machine> Window<S> {
    /// The window of step 0 for a start in a segment.
    pub fn new(
        setting: Setting<S>,
        start: Vec<S>,
        span: usize,
        update: &Update<S::Weight>,
    ) -> Self {
        let mut window = Self { setting, run: vec![start.clone(); span + 1], spare: start };
        for _ in 0..span {
            window.advance(update);
        }
        window
    }

    /// From step k to step k+1: steps the newest placement, forgets the oldest and brings all
    /// others to the new denominator.
    #[inline(always)]
    pub fn advance(&mut self, update: &Update<S::Weight>) {
        let Setting { min, max, .. } = &mut self.setting;
        let Some((newest, older)) = self.run.split_last_mut() else { return };
        step(update, min, max, newest, &mut self.spare);
        swap(newest, &mut self.spare);
        if let Some(oldest) = older.first_mut() {
            swap(oldest, &mut self.spare);
            older.rotate_left(1);
        }
        let ends = [min, max].into_iter();
        for x in older.iter_mut().flatten().chain(ends) {
            *x = S::weigh([(&update.den, x)]);
        }
    }

    /// What a theorem says of this window.
    pub fn verdict(&self, theorem: Theorem, form: Form) -> Verdict {
        theorem.conclusion(form, &self.setting, &self.run)
    }

    /// The same window on other integers, the weight being given in them.
    pub fn map<T>(&self, weight: (&T, &T), f: impl Fn(&S) -> T) -> Window<T>
    where
        T: Clone,
    {
        let placement = |x: &Vec<S>| x.iter().map(&f).collect();
        Window {
            setting: Setting {
                min: f(&self.setting.min),
                max: f(&self.setting.max),
                eps_num: weight.0.clone(),
                eps_den: weight.1.clone(),
            },
            run: self.run.iter().map(placement).collect(),
            spare: placement(&self.spare),
        }
    }
}
