//! Every start of a grid, at every step.
//!
//! A start is stepped on 64-bit integers as long as [`Range`] proves that they hold every
//! number, then on 128-bit, 256-bit and big integers, each taking over where the narrower one
//! ends. Nothing wraps, nothing is checked at run time, nothing is rounded.

use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};
use num_bigint::BigInt;

use super::config::Item;
use super::finding::Counts;
use super::grid::{Grid, Piece};
use super::kernel::{Dynamic, Fixed, Shape, Window, widened};
use super::machine::{Machine, Wide, Widened};
use super::range::Range;
use crate::counterexample::Counterexample;
use cordon_core::Rational;
use cordon_core::stencil::Stencil;

/// Counts, and the first violation: least k, then first in the order of the starts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Starts, cases and violations so far.
    pub counts: Counts,
    /// The first violation: its step k and its start.
    pub first: Option<(usize, Vec<i64>)>,
}

impl Tally {
    /// Both together; which side comes first does not matter.
    pub fn merge(mut self, other: Self) -> Self {
        self.counts = self.counts.plus(other.counts);
        self.first = match (self.first, other.first) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        self
    }

    fn add(&mut self, verdict: Verdict, k: usize, start: &[i64], times: u64) {
        self.counts.cases += times;
        match verdict {
            Verdict::Holds => self.counts.non_vacuous += times,
            Verdict::Vacuous => {}
            Verdict::Undecided => self.counts.undecided += times,
            Verdict::Violated(_) => {
                self.counts.non_vacuous += times;
                self.counts.violations += times;
                self.violated(k, start);
            }
        }
    }

    #[cold]
    fn violated(&mut self, k: usize, start: &[i64]) {
        let earlier = |(step, first): &(usize, Vec<i64>)| (*step, first.as_slice()) <= (k, start);
        if !self.first.as_ref().is_some_and(earlier) {
            self.first = Some((k, start.to_vec()));
        }
    }

    /// The first violation, run again by the spec; `None` too where the spec does not confirm
    /// it.
    pub fn counterexample(&self, item: &Item) -> Option<Counterexample> {
        let (step, start) = self.first.as_ref()?;
        item.refuted_by(start.iter().map(|&x| Rational::from_integer(x.into())).collect(), *step)
    }
}

/// A work item made ready to run on starts of integers up to a length.
pub struct Exhaust<Sh: Shape> {
    theorem: Theorem,
    form: Form,
    count: usize,
    steps: usize,
    span: usize,
    length: i64,
    mirrored: bool,
    narrow: Stage<i64>,
    double: Stage<i128>,
    wide: Stage<Wide>,
    big: Stage<BigInt>,
    shape: std::marker::PhantomData<fn() -> Sh>,
}

/// The steps that one kind of integers runs.
struct Stage<S> {
    /// Stencil and weight (numerator, denominator) in these integers, and the last step they
    /// hold; `None` where they hold no step.
    ready: Option<(Stencil<S>, (S, S), usize)>,
}

impl<S: Machine> Stage<S> {
    fn new(item: &Item, range: &Range, steps: usize) -> Self {
        let ready = || {
            let last = range.last_step::<S>(steps)?;
            // Weights that are themselves too large leave the work to wider integers.
            let narrow = |x: &BigInt| S::narrow(x).ok_or(());
            let stencil = Stencil::of(&item.eps).try_map(narrow).ok()?;
            let weight = (S::narrow(item.eps.numer())?, S::narrow(item.eps.denom())?);
            Some((stencil, weight, last))
        };
        Self { ready: ready() }
    }

    /// The window of step 0, where these integers hold it.
    fn start<Sh: Shape>(&self, case: &Case<'_>) -> Option<Window<S, Sh::Of<S>>> {
        let (stencil, (num, den), _) = self.ready.as_ref()?;
        let setting = Setting {
            min: S::from_i64(0),
            max: S::from_i64(case.length),
            eps_num: num.clone(),
            eps_den: den.clone(),
        };
        let x = case.start;
        let start = Sh::build(x.len(), |i| S::from_i64(x[i]));
        Some(Window::new(setting, start, case.span, stencil))
    }

    /// The window that narrower integers have left behind, or else that of step 0.
    fn take_over<Sh: Shape, T>(
        &self,
        before: Option<Window<T, Sh::Of<T>>>,
        case: &Case<'_>,
    ) -> Option<Window<S, Sh::Of<S>>>
    where
        T: Clone + Send + Sync,
        S: Widened<T>,
    {
        match (before, &self.ready) {
            (Some(window), Some((_, (num, den), _))) => {
                Some(widened::<Sh, T, S>(&window, (num, den)))
            }
            _ => self.start::<Sh>(case),
        }
    }

    /// Asks for every step from `case.next` on that these integers hold; the window is that of
    /// the step before, or of step 0 if no step was asked yet.
    fn run<M: AsRef<[S]> + AsMut<[S]> + Clone>(
        &self,
        window: Option<&mut Window<S, M>>,
        case: &mut Case<'_>,
        tally: &mut Tally,
    ) {
        let (Some((stencil, _, last)), Some(window)) = (&self.ready, window) else { return };
        let from = case.next;
        for k in from..=*last {
            if k > 0 {
                window.advance(stencil);
            }
            let verdict = window.verdict(case.theorem, case.form);
            tally.add(verdict, k, case.start, case.times);
        }
        case.next = from.max(last + 1);
    }
}

/// One start on its way through the steps.
struct Case<'a> {
    theorem: Theorem,
    form: Form,
    span: usize,
    length: i64,
    start: &'a [i64],
    /// How many starts it stands for.
    times: u64,
    /// The first step not yet asked.
    next: usize,
}

impl<Sh: Shape> Exhaust<Sh> {
    /// Prepares a work item for the steps `0 ..= steps` and for starts on a segment of the
    /// given length (integers from 0 to `length`).
    pub fn new(item: &Item, steps: usize, length: i64) -> Self {
        let (theorem, form, count) = (item.theorem, item.form, item.drones);
        let range = Range::new(theorem, form, count, &item.eps, &length.into());
        Self {
            theorem,
            form,
            count,
            steps,
            span: theorem.span(form, count),
            length,
            mirrored: Grid::mirrored(theorem, theorem.hypothesis(form).starts),
            narrow: Stage::new(item, &range, steps),
            double: Stage::new(item, &range, steps),
            wide: Stage::new(item, &range, steps),
            big: Stage::new(item, &range, steps),
            shape: std::marker::PhantomData,
        }
    }

    /// Tries one start, if the theorem's start set contains it: every step from 0 to the last.
    /// Of a mirror pair of starts only the smaller is run, and counted twice; `whole` turns
    /// that off.
    pub fn start(&self, start: &[i64], whole: bool, tally: &mut Tally) {
        let times = if self.mirrored && !whole { Grid::mirror_weight(start) } else { 1 };
        if times == 0 || !self.admits(start) {
            return;
        }
        tally.counts.starts += times;
        tally.counts.updates += (self.count * (self.steps + self.span)) as u64;
        let case = &mut Case {
            theorem: self.theorem,
            form: self.form,
            span: self.span,
            length: self.length,
            start,
            times,
            next: 0,
        };
        let mut narrow = self.narrow.start::<Sh>(case);
        self.narrow.run(narrow.as_mut(), case, tally);
        if case.next > self.steps {
            return;
        }
        let mut double = self.double.take_over::<Sh, i64>(narrow, case);
        self.double.run(double.as_mut(), case, tally);
        if case.next > self.steps {
            return;
        }
        let mut wide = self.wide.take_over::<Sh, i128>(double, case);
        self.wide.run(wide.as_mut(), case, tally);
        if case.next > self.steps {
            return;
        }
        let mut big = self.big.take_over::<Sh, Wide>(wide, case);
        self.big.run(big.as_mut(), case, tally);
    }

    /// Whether the hypothesis admits the start.
    fn admits(&self, start: &[i64]) -> bool {
        let setting = Setting { min: 0i128, max: self.length.into(), eps_num: 0, eps_den: 1 };
        // Start predicates multiply by N-1 at most: 128 bits hold that with room to spare.
        let wider: Vec<i128> = start.iter().map(|x| i128::from(*x)).collect();
        let starts = self.theorem.hypothesis(self.form).starts;
        starts.contains(&setting, &wider) == Truth::True
    }

    /// The last step that each kind of integers runs, from narrow to big; `None` where it runs
    /// none.
    pub fn last_steps(&self) -> [Option<usize>; 4] {
        [
            self.narrow.ready.as_ref().map(|r| r.2),
            self.double.ready.as_ref().map(|r| r.2),
            self.wide.ready.as_ref().map(|r| r.2),
            self.big.ready.as_ref().map(|r| r.2),
        ]
    }
}

/// A work item whose number of drones has been turned into a type.
pub trait Engine: Sync {
    /// As [`Exhaust::start`].
    fn start(&self, start: &[i64], whole: bool, tally: &mut Tally);
}

impl<Sh: Shape> Engine for Exhaust<Sh> {
    fn start(&self, start: &[i64], whole: bool, tally: &mut Tally) {
        Exhaust::start(self, start, whole, tally);
    }
}

/// The engine for a work item's number of drones: arrays for the usual few, vectors beyond.
pub fn engine(item: &Item, steps: usize, length: i64) -> Box<dyn Engine> {
    match item.drones {
        3 => Box::new(Exhaust::<Fixed<3>>::new(item, steps, length)),
        4 => Box::new(Exhaust::<Fixed<4>>::new(item, steps, length)),
        5 => Box::new(Exhaust::<Fixed<5>>::new(item, steps, length)),
        6 => Box::new(Exhaust::<Fixed<6>>::new(item, steps, length)),
        7 => Box::new(Exhaust::<Fixed<7>>::new(item, steps, length)),
        8 => Box::new(Exhaust::<Fixed<8>>::new(item, steps, length)),
        _ => Box::new(Exhaust::<Dynamic>::new(item, steps, length)),
    }
}

/// Every start of a piece of a grid.
pub fn sweep(engine: &dyn Engine, grid: &Grid, piece: &Piece) -> Tally {
    let mut tally = Tally::default();
    grid.for_each(piece, |start| {
        engine.start(start, false, &mut tally);
        true
    });
    tally
}
