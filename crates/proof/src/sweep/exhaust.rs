//! Every start of a grid, at every step.
//!
//! Starts are stepped 32 at a time ([`super::lanes`]) on 32-bit integers as long as [`Range`]
//! proves that they hold every number, then on integers of 53 bits and of 64; then one by one on
//! 128-bit, 256-bit and big integers, each taking over where the narrower one ends. Nothing
//! wraps, nothing is checked at run time, nothing is rounded.

use std::ops::RangeInclusive;

use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};
use num_bigint::BigInt;

use super::config::Item;
use super::finding::Counts;
use super::grid::{Grid, Piece};
use super::kernel::{Update, Window};
use super::lanes::{LANES, Lanes, Number};
use super::machine::{Machine, Wide};
use super::range::Range;
use crate::counterexample::Counterexample;
use cordon_core::Rational;
use cordon_core::stencil::Stencil;
use cordon_vector::{Task, widest};

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
pub struct Exhaust {
    theorem: Theorem,
    form: Form,
    count: usize,
    steps: usize,
    span: usize,
    length: i64,
    narrow: Option<Stage<Lanes<i32>>>,
    exact: Option<Stage<Lanes<f64>>>,
    plain: Option<Stage<Lanes<i64>>>,
    double: Option<Stage<i128>>,
    wide: Option<Stage<Wide>>,
    big: Option<Stage<BigInt>>,
}

/// The steps that one kind of integers runs.
struct Stage<S: Machine> {
    /// Weights of the step.
    update: Update<S::Weight>,
    /// Numerator and denominator of eps.
    eps: (S, S),
    /// The last step that these integers hold.
    last: usize,
}

impl<S: Machine> Stage<S> {
    /// `None` where these integers hold no step, or not the weights: that leaves the work to
    /// wider ones.
    fn new(item: &Item, update: &Update, range: &Range, steps: usize) -> Option<Self> {
        Some(Self {
            last: range.last_step::<S>(steps)?,
            update: update.try_map(S::weight)?,
            eps: (S::narrow(item.eps.numer())?, S::narrow(item.eps.denom())?),
        })
    }

    /// The window of step 0 for a start.
    fn begin(&self, of: &Exhaust, start: Vec<S>) -> Window<S> {
        let setting = Setting {
            min: S::from_i64(0),
            max: S::from_i64(of.length),
            eps_num: self.eps.0.clone(),
            eps_den: self.eps.1.clone(),
        };
        Window::new(setting, start, of.span, &self.update)
    }

    /// What narrower integers have left behind.
    fn take_over<T: Machine>(&self, before: &Window<T>, widened: impl Fn(&T) -> S) -> Window<S> {
        before.map((&self.eps.0, &self.eps.1), widened)
    }

    /// Asks for every step from `next` on that these integers hold; the window is that of
    /// step 0 or of the step before `next`.
    fn run(&self, window: &mut Window<S>, next: &mut usize, ask: impl FnMut(&Window<S>, usize)) {
        let steps = *next..=self.last;
        *next = (*next).max(self.last + 1);
        let task = Steps { update: &self.update, window, steps, ask };
        if S::VECTOR { widest(task) } else { task.run(false) }
    }
}

/// Steps and what is asked at each of them, for the vectors that the machine has.
struct Steps<'a, S: Machine, A> {
    update: &'a Update<S::Weight>,
    window: &'a mut Window<S>,
    steps: RangeInclusive<usize>,
    ask: A,
}

impl<S: Machine, A: FnMut(&Window<S>, usize)> Task for Steps<'_, S, A> {
    type Output = ();

    #[inline(always)]
    fn run(mut self, _: bool) {
        for k in self.steps {
            if k > 0 {
                self.window.advance(self.update);
            }
            (self.ask)(self.window, k);
        }
    }
}

impl Exhaust {
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
            exact: Stage::new(item, &update, &range, steps),
            plain: Stage::new(item, &update, &range, steps),
            double: Stage::new(item, &update, &range, steps),
            wide: Stage::new(item, &update, &range, steps),
            big: Stage::new(item, &update, &range, steps),
        }
    }

    /// The last step that each kind of integers runs, from narrow to big; `None` where it runs
    /// none.
    pub fn last_steps(&self) -> [Option<usize>; 6] {
        fn last<S: Machine>(stage: &Option<Stage<S>>) -> Option<usize> {
            stage.as_ref().map(|stage| stage.last)
        }
        [
            last(&self.narrow),
            last(&self.exact),
            last(&self.plain),
            last(&self.double),
            last(&self.wide),
            last(&self.big),
        ]
    }

    /// Tries the starts of a batch that the theorem's start set contains: every step from 0 to
    /// the last.
    fn run(&self, batch: &mut Batch, tally: &mut Tally) {
        if batch.filled == 0 {
            return;
        }
        batch.pad();
        // What is admitted in every lane is admitted; one by one where lanes cannot tell.
        let admitted = if self.narrow.is_some() {
            self.admitting(batch.lanes::<i32>())
        } else {
            self.plain.is_some() && self.admitting(batch.lanes::<i64>())
        };
        if !admitted {
            batch.retain(|start| self.admitting(start.iter().map(|x| i128::from(*x)).collect()));
        }
        if batch.filled == 0 {
            return;
        }
        let total = batch.times[..batch.filled].iter().sum::<u64>();
        tally.counts.starts += total;
        tally.counts.updates += (batch.filled * self.count * (self.steps + self.span)) as u64;
        let (mut next, mut start) = (0, Vec::new());
        macro_rules! stage {
            ($stage:ident, $t:ty, $before:expr, $widened:expr) => {{
                let mut window = None;
                if let Some(stage) = &self.$stage {
                    let now = window.insert(match $before {
                        Some(before) => stage.take_over(before, $widened),
                        None => stage.begin(self, batch.lanes::<$t>()),
                    });
                    stage.run(now, &mut next, |window, k| {
                        match window.verdict(self.theorem, self.form) {
                            same @ (Verdict::Holds | Verdict::Vacuous) => {
                                tally.add(same, k, &[], total)
                            }
                            _ => self.apart(window, k, batch, &mut start, tally),
                        }
                    });
                    if next > self.steps {
                        return;
                    }
                }
                window
            }};
        }
        let narrow = stage!(narrow, i32, None::<&Window<Lanes<i32>>>, |x: &Lanes<i32>| *x);
        let exact = stage!(exact, f64, narrow.as_ref(), |x: &Lanes<i32>| Lanes(x.0.map(f64::from)));
        let plain = stage!(plain, i64, exact.as_ref(), |x: &Lanes<f64>| Lanes(x.0.map(f64::whole)));
        for l in 0..batch.filled {
            batch.start(l, &mut start);
            let before = plain.as_ref().map(|window| lane(window, l));
            self.beyond(before, (&start, batch.times[l]), next, tally);
        }
    }

    /// What the theorem says of each lane of a window, where it does not say the same of all.
    #[cold]
    fn apart<T: Number>(
        &self,
        window: &Window<Lanes<T>>,
        k: usize,
        batch: &Batch,
        start: &mut Vec<i64>,
        tally: &mut Tally,
    ) where
        Lanes<T>: Machine,
    {
        for l in 0..batch.filled {
            batch.start(l, start);
            let verdict = lane(window, l).verdict(self.theorem, self.form);
            tally.add(verdict, k, start, batch.times[l]);
        }
    }

    /// The steps of a start beyond those of lanes.
    fn beyond(
        &self,
        before: Option<Window<i128>>,
        (start, times): (&[i64], u64),
        mut next: usize,
        tally: &mut Tally,
    ) {
        macro_rules! stage {
            ($stage:ident, $before:expr, $widened:expr) => {{
                let mut window = None;
                if let Some(stage) = &self.$stage {
                    let now = window.insert(match $before {
                        Some(before) => stage.take_over(before, $widened),
                        None => stage.begin(self, start.iter().map(|x| (*x).into()).collect()),
                    });
                    stage.run(now, &mut next, |window, k| {
                        tally.add(window.verdict(self.theorem, self.form), k, start, times);
                    });
                    if next > self.steps {
                        return;
                    }
                }
                window
            }};
        }
        let double = stage!(double, before.as_ref(), |x: &i128| *x);
        let wide = stage!(wide, double.as_ref(), |x: &i128| x.into());
        stage!(big, wide.as_ref(), |x: &Wide| x.into());
    }

    /// Whether the hypothesis admits the start. Start predicates multiply by N-1 at most: 128
    /// bits hold that with room to spare.
    fn admitting<S: Machine>(&self, start: Vec<S>) -> bool {
        let setting = Setting {
            min: S::from_i64(0),
            max: S::from_i64(self.length),
            eps_num: S::from_i64(0),
            eps_den: S::from_i64(1),
        };
        let starts = self.theorem.hypothesis(self.form).starts;
        starts.contains(&setting, &start) == Truth::True
    }
}

/// One lane of a window.
fn lane<T: Number>(window: &Window<Lanes<T>>, l: usize) -> Window<i128>
where
    Lanes<T>: Machine,
{
    let of = |x: &Lanes<T>| i128::from(x.0[l].whole());
    let Setting { eps_num, eps_den, .. } = &window.setting;
    window.map((&of(eps_num), &of(eps_den)), of)
}

/// Starts that are run at once, at most [`LANES`].
#[derive(Debug)]
struct Batch {
    /// Where each drone is, in each start.
    places: Vec<[i64; LANES]>,
    /// How many starts each stands for.
    times: [u64; LANES],
    /// How many starts there are.
    filled: usize,
}

impl Batch {
    fn new(count: usize) -> Self {
        Self { places: vec![[0; LANES]; count], times: [0; LANES], filled: 0 }
    }

    /// Adds a start, which stands for `times`; there is room.
    fn push(&mut self, start: &[i64], times: u64) {
        for (place, x) in self.places.iter_mut().zip(start) {
            place[self.filled] = *x;
        }
        self.times[self.filled] = times;
        self.filled += 1;
    }

    /// The start of a lane.
    fn start(&self, l: usize, start: &mut Vec<i64>) {
        start.clear();
        start.extend(self.places.iter().map(|place| place[l]));
    }

    /// Lanes without a start repeat the last one.
    fn pad(&mut self) {
        for place in &mut self.places {
            let last = place[self.filled - 1];
            place[self.filled..].fill(last);
        }
    }

    /// Where each drone is.
    fn lanes<T: Number>(&self) -> Vec<Lanes<T>> {
        self.places.iter().map(|place| Lanes(place.map(T::of))).collect()
    }

    /// Keeps the starts that are admitted.
    fn retain(&mut self, admitted: impl Fn(&[i64]) -> bool) {
        let (all, mut start) = (self.filled, Vec::new());
        self.filled = 0;
        for l in 0..all {
            self.start(l, &mut start);
            if admitted(&start) {
                self.push(&start, self.times[l]);
            }
        }
        if self.filled > 0 {
            self.pad();
        }
    }
}

/// Starts of a work item on their way through its engine, and what they came to.
pub struct Trial<'e> {
    engine: &'e Exhaust,
    /// Whether of a mirror pair of starts only the smaller is run, and counted twice.
    mirrored: bool,
    batch: Batch,
    tally: Tally,
}

impl<'e> Trial<'e> {
    /// No start so far.
    pub fn new(engine: &'e Exhaust, mirrored: bool) -> Self {
        Self { engine, mirrored, batch: Batch::new(engine.count), tally: Tally::default() }
    }

    /// Tries one start, now or later.
    pub fn start(&mut self, start: &[i64]) {
        let times = if self.mirrored { Grid::mirror_weight(start) } else { 1 };
        if times > 0 {
            self.batch.push(start, times);
        }
        if self.batch.filled == LANES {
            self.run();
        }
    }

    fn run(&mut self) {
        self.engine.run(&mut self.batch, &mut self.tally);
        self.batch.filled = 0;
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
        let mirrored = self.mirrored;
        let visit = |start: &[i64]| {
            self.start(start);
            true
        };
        if mirrored { grid.for_each_smaller(piece, visit) } else { grid.for_each(piece, visit) }
    }
}
