//! Every start of a grid, at every step.
//!
//! Starts are stepped sixteen at a time ([`super::lanes`]) on 32-bit integers as long as [`Range`]
//! proves that they hold every number, then on 64-bit ones; then one by one on 128-bit, 256-bit
//! and big integers, each taking over where the narrower one ends. Nothing wraps, nothing is
//! checked at run time, nothing is rounded.

use cordon_spec::Ordered;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};
use num_bigint::BigInt;

use super::config::Item;
use super::finding::Counts;
use super::grid::{Grid, Piece};
use super::kernel::{Dynamic, Fixed, Shape, Update, Window, widened};
use super::lanes::{LANES, Lanes};
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
    narrow: Stage<Lanes<i32>>,
    plain: Stage<Lanes<i64>>,
    double: Stage<i128>,
    wide: Stage<Wide>,
    big: Stage<BigInt>,
    shape: std::marker::PhantomData<fn() -> Sh>,
}

/// The steps that one kind of integers runs.
struct Stage<S> {
    /// Weights of the step, and eps (numerator, denominator), in these integers, and the last
    /// step they hold; `None` where they hold no step.
    ready: Option<(Update<S>, (S, S), usize)>,
}

impl<S: Machine> Stage<S> {
    /// What narrower integers have left behind, in these.
    fn take_over<Sh: Shape, T>(
        &self,
        before: Option<Window<T, Sh::Of<T>>>,
    ) -> Option<Window<S, Sh::Of<S>>>
    where
        T: Clone + Send + Sync,
        S: Widened<T>,
    {
        let (_, (num, den), _) = self.ready.as_ref()?;
        Some(widened::<Sh, T, S>(&before?, (num, den)))
    }

    fn new(item: &Item, update: &Update, range: &Range, steps: usize) -> Self {
        let ready = || {
            let last = range.last_step::<S>(steps)?;
            // Weights that are themselves too large leave the work to wider integers.
            let update = update.try_map(|x| S::narrow(x).ok_or(())).ok()?;
            let weight = (S::narrow(item.eps.numer())?, S::narrow(item.eps.denom())?);
            Some((update, weight, last))
        };
        Self { ready: ready() }
    }

    /// Asks for every step from `next` on that these integers hold, and answers with the
    /// window of the last and the step after it. The window begun with is what narrower
    /// integers have left behind, or else that of step 0, drone i being at `start(i)`.
    #[inline(always)]
    fn run<Sh: Shape>(
        &self,
        of: &Exhaust<Sh>,
        before: Option<Window<S, Sh::Of<S>>>,
        start: impl Fn(usize) -> S,
        next: &mut usize,
        mut ask: impl FnMut(&Window<S, Sh::Of<S>>, usize),
    ) -> Option<Window<S, Sh::Of<S>>> {
        let (update, (num, den), last) = self.ready.as_ref()?;
        let mut window = match before {
            Some(window) => window,
            None => {
                let setting = Setting {
                    min: S::from_i64(0),
                    max: S::from_i64(of.length),
                    eps_num: num.clone(),
                    eps_den: den.clone(),
                };
                Window::new(setting, Sh::build(of.count, start), of.span, update)
            }
        };
        for k in *next..=*last {
            if k > 0 {
                window.advance(update);
            }
            ask(&window, k);
        }
        *next = (*next).max(last + 1);
        Some(window)
    }
}

impl<Sh: Shape> Exhaust<Sh> {
    /// Prepares a work item for the steps `0 ..= steps` and for starts on a segment of the
    /// given length (integers from 0 to `length`).
    pub fn new(item: &Item, steps: usize, length: i64) -> Self {
        let (theorem, form, count) = (item.theorem, item.form, item.drones);
        let range = Range::new(theorem, form, count, &item.eps, &length.into());
        let update = Update::of(&Stencil::of(&item.eps));
        Self {
            theorem,
            form,
            count,
            steps,
            span: theorem.span(form, count),
            length,
            narrow: Stage::new(item, &update, &range, steps),
            plain: Stage::new(item, &update, &range, steps),
            double: Stage::new(item, &update, &range, steps),
            wide: Stage::new(item, &update, &range, steps),
            big: Stage::new(item, &update, &range, steps),
            shape: std::marker::PhantomData,
        }
    }

    /// What the theorem says of one lane of a window, where it does not say the same of all.
    #[cold]
    fn one<T: Ordered + Copy + Send + Sync>(
        &self,
        window: &Window<Lanes<T>, Sh::Of<Lanes<T>>>,
        l: usize,
    ) -> Verdict {
        lane::<Sh, T>(window, l).verdict(self.theorem, self.form)
    }

    /// The steps of a start beyond those of lanes.
    fn beyond(
        &self,
        before: Option<Window<i64, Sh::Of<i64>>>,
        (start, times): (&[i64], u64),
        mut next: usize,
        tally: &mut Tally,
    ) {
        macro_rules! stage {
            ($stage:ident, $t:ty, $before:expr) => {{
                let at = |i: usize| <$t>::from_i64(start[i]);
                let ask = |window: &Window<$t, Sh::Of<$t>>, k| {
                    tally.add(window.verdict(self.theorem, self.form), k, start, times);
                };
                let window = self.$stage.run(self, $before, at, &mut next, ask);
                if next > self.steps {
                    return;
                }
                window
            }};
        }
        let double = stage!(double, i128, self.double.take_over::<Sh, i64>(before));
        let wide = stage!(wide, Wide, self.wide.take_over::<Sh, i128>(double));
        stage!(big, BigInt, self.big.take_over::<Sh, Wide>(wide));
    }

    /// Whether the hypothesis admits the start.
    fn admits(&self, start: &[i64]) -> bool {
        // Start predicates multiply by N-1 at most: 128 bits hold that with room to spare.
        self.admitting(Sh::build(start.len(), |i| i128::from(start[i])))
    }

    fn admitting<S: Machine>(&self, start: Sh::Of<S>) -> bool {
        let setting = Setting {
            min: S::from_i64(0),
            max: S::from_i64(self.length),
            eps_num: S::from_i64(0),
            eps_den: S::from_i64(1),
        };
        let starts = self.theorem.hypothesis(self.form).starts;
        starts.contains(&setting, start.as_ref()) == Truth::True
    }

    /// The last step that each kind of integers runs, from narrow to big; `None` where it runs
    /// none.
    pub fn last_steps(&self) -> [Option<usize>; 5] {
        [
            self.narrow.ready.as_ref().map(|r| r.2),
            self.plain.ready.as_ref().map(|r| r.2),
            self.double.ready.as_ref().map(|r| r.2),
            self.wide.ready.as_ref().map(|r| r.2),
            self.big.ready.as_ref().map(|r| r.2),
        ]
    }
}

/// A work item whose number of drones has been turned into a type.
pub trait Engine: Sync {
    /// Tries the starts of a batch that the theorem's start set contains: every step from 0 to
    /// the last.
    fn run(&self, batch: &mut Batch, tally: &mut Tally);
}

impl<Sh: Shape> Engine for Exhaust<Sh> {
    fn run(&self, batch: &mut Batch, tally: &mut Tally) {
        // What is admitted in every lane is admitted; one by one where lanes cannot tell.
        let lanes = self.plain.ready.is_some() && !batch.is_empty();
        if !(lanes && self.admitting(Sh::build(self.count, |i| batch.lanes(i, |x| x)))) {
            batch.retain(|start| self.admits(start));
        }
        if batch.is_empty() {
            return;
        }
        let total = batch.times.iter().sum::<u64>();
        tally.counts.starts += total;
        tally.counts.updates += (batch.times.len() * self.count * (self.steps + self.span)) as u64;
        let mut next = 0;
        macro_rules! stage {
            ($stage:ident, $t:ty, $before:expr) => {{
                let at = |i: usize| batch.lanes(i, |x| x as $t);
                let ask = |window: &Window<Lanes<$t>, Sh::Of<Lanes<$t>>>, k| match window
                    .verdict(self.theorem, self.form)
                {
                    same @ (Verdict::Holds | Verdict::Vacuous) => tally.add(same, k, &[], total),
                    _ => {
                        for (l, (start, times)) in batch.each().enumerate() {
                            tally.add(self.one(window, l), k, start, times);
                        }
                    }
                };
                let window = self.$stage.run(self, $before, at, &mut next, ask);
                if next > self.steps {
                    return;
                }
                window
            }};
        }
        let narrow = stage!(narrow, i32, None);
        let plain = stage!(plain, i64, self.plain.take_over::<Sh, Lanes<i32>>(narrow));
        for (l, case) in batch.each().enumerate() {
            self.beyond(plain.as_ref().map(|window| lane::<Sh, i64>(window, l)), case, next, tally);
        }
    }
}

/// One lane of a window.
fn lane<Sh: Shape, T: Copy + Send + Sync>(
    window: &Window<Lanes<T>, Sh::Of<Lanes<T>>>,
    l: usize,
) -> Window<T, Sh::Of<T>> {
    let Setting { min, max, eps_num, eps_den } = &window.setting;
    let [min, max, eps_num, eps_den] = [min, max, eps_num, eps_den].map(|x| x.0[l]);
    let of = |m: &Sh::Of<Lanes<T>>| Sh::build(m.as_ref().len(), |i| m.as_ref()[i].0[l]);
    Window {
        setting: Setting { min, max, eps_num, eps_den },
        run: window.run.iter().map(of).collect(),
    }
}

/// Starts that are run at once, at most [`LANES`].
#[derive(Debug, Default)]
pub struct Batch {
    /// Positions, start after start.
    places: Vec<i64>,
    /// How many starts each stands for.
    times: Vec<u64>,
}

impl Batch {
    fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    fn count(&self) -> usize {
        self.places.len() / self.times.len().max(1)
    }

    /// The starts, and how many each stands for.
    fn each(&self) -> impl Iterator<Item = (&[i64], u64)> {
        self.places.chunks_exact(self.count().max(1)).zip(self.times.iter().copied())
    }

    /// Where drone `i` is in each start; lanes without a start repeat the last one.
    #[inline(always)]
    fn lanes<T>(&self, i: usize, number: impl Fn(i64) -> T) -> Lanes<T> {
        let (count, last) = (self.count(), self.times.len() - 1);
        Lanes(std::array::from_fn(|l| number(self.places[l.min(last) * count + i])))
    }

    fn retain(&mut self, admitted: impl Fn(&[i64]) -> bool) {
        let mut kept = Self::default();
        for (start, times) in self.each().filter(|(start, _)| admitted(start)) {
            kept.places.extend_from_slice(start);
            kept.times.push(times);
        }
        *self = kept;
    }
}

/// Starts of a work item on their way through its engine, and what they came to.
pub struct Trial<'e> {
    engine: &'e dyn Engine,
    /// Whether of a mirror pair of starts only the smaller is run, and counted twice.
    mirrored: bool,
    batch: Batch,
    tally: Tally,
}

impl<'e> Trial<'e> {
    /// No start so far.
    pub fn new(engine: &'e dyn Engine, mirrored: bool) -> Self {
        Self { engine, mirrored, batch: Batch::default(), tally: Tally::default() }
    }

    /// Tries one start, now or later.
    pub fn start(&mut self, start: &[i64]) {
        let times = if self.mirrored { Grid::mirror_weight(start) } else { 1 };
        if times > 0 {
            self.batch.places.extend_from_slice(start);
            self.batch.times.push(times);
        }
        if self.batch.times.len() == LANES {
            self.run();
        }
    }

    fn run(&mut self) {
        self.engine.run(&mut self.batch, &mut self.tally);
        self.batch.places.clear();
        self.batch.times.clear();
    }

    /// What all starts so far that have been run came to.
    pub fn so_far(&self) -> &Tally {
        &self.tally
    }

    /// What all starts came to.
    pub fn end(mut self) -> Tally {
        self.run();
        self.tally
    }

    /// Tries every start of a piece of a grid.
    pub fn sweep(&mut self, grid: &Grid, piece: &Piece) {
        grid.for_each(piece, |start| {
            self.start(start);
            true
        });
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
