//! Collisions and violations of the order, between the samples as well.
//!
//! Within a step the plant's motion is known: a straight line with the Euler integrator, a polynomial
//! of degree four with the exact one. The zeros of a gap (in the plane: of the distance less that at
//! which drones touch) are found on that motion, so that no collision between two grid points is
//! missed.

mod bernstein;

use self::bernstein::{Bernstein, MOTION, SQUARE};
use super::plant::Integrator;

/// Something that happened to two drones.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Time of the event in seconds.
    pub time: f64,
    /// The two drones, smaller number first.
    pub drones: (usize, usize),
    /// A collision, or the loss or return of the order.
    pub kind: EventKind,
}

/// What can happen to two neighbouring drones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// They are at the same position; in the plane, close enough to touch.
    Collision,
    /// From here on a drone has passed its successor.
    OrderLost,
    /// They are in order again.
    OrderRestored,
}

impl EventKind {
    /// Its name in machine formats.
    pub fn name(self) -> &'static str {
        match self {
            Self::Collision => "collision",
            Self::OrderLost => "order-lost",
            Self::OrderRestored => "order-restored",
        }
    }

    /// The kind with this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Collision, Self::OrderLost, Self::OrderRestored]
            .into_iter()
            .find(|k| k.name() == name)
    }
}

/// The motion of a drone along an axis at a grid point, as far as the events within a step depend on
/// it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Position along the line, in metres.
    pub x: f64,
    /// Velocity along the line, in m/s.
    pub v: f64,
    /// Acceleration in m/s2: along x it is g theta.
    pub a: f64,
    /// Its rate of change in m/s3.
    pub jerk: f64,
}

/// Looks for events grid point by grid point.
pub struct Watch {
    integrator: Integrator,
    tau: f64,
    /// The distance at which drones collide: 0 on a line, where no drone can pass another without
    /// meeting it.
    reach: f64,
    /// Along each axis the samples of the last grid point.
    last: Vec<Vec<Sample>>,
    /// Along each axis the motion of every drone in the current step.
    motion: Vec<Vec<Bernstein<MOTION>>>,
    /// Least and greatest position of every drone along x in this step.
    ends: Vec<(f64, f64)>,
    /// Drones by the lower end of their motion; nearly sorted from step to step.
    by_place: Vec<usize>,
    /// Pairs that may meet in this step.
    close: Vec<(usize, usize)>,
    /// Whether drone i has passed drone i+1.
    crossed: Vec<bool>,
    events: Vec<Event>,
}

impl Watch {
    /// A watch over drones on a line whose plants have this integrator and step. Two drones collide
    /// where they are at the same position.
    pub fn new(integrator: Integrator, tau: f64) -> Self {
        Self {
            integrator,
            tau,
            reach: 0.0,
            last: Vec::new(),
            motion: Vec::new(),
            ends: Vec::new(),
            by_place: Vec::new(),
            close: Vec::new(),
            crossed: Vec::new(),
            events: Vec::new(),
        }
    }

    /// A watch over drones in the plane, where centres hardly ever coincide: two drones collide where
    /// their distance falls to `reach`, in m. There is no order to lose.
    pub fn in_plane(integrator: Integrator, tau: f64, reach: f64) -> Self {
        Self { reach, ..Self::new(integrator, tau) }
    }

    /// Adds the next grid point: along each axis the samples of the drones. `time` is that of the
    /// previous grid point, where the motion begins.
    pub fn next(&mut self, time: f64, samples: &[Vec<Sample>]) {
        if self.last.is_empty() {
            self.by_place = (0..samples.first().map_or(0, Vec::len)).collect();
            self.crossed = vec![false; self.by_place.len()];
            let at_rest = |s: &Sample| Bernstein::constant(s.x);
            self.motion = samples.iter().map(|axis| axis.iter().map(at_rest).collect()).collect();
            self.start();
            self.last = samples.to_vec();
            return;
        }
        let (integrator, tau) = (self.integrator, self.tau);
        let axes = self.last.iter_mut().zip(samples).zip(&mut self.motion);
        for ((last, now), motions) in axes {
            let pairs = last.iter().zip(now).zip(motions);
            pairs.for_each(|((a, b), motion)| *motion = moved(integrator, tau, a, b));
            last.copy_from_slice(now);
        }
        self.look(time);
    }

    /// All events, by time.
    pub fn finish(mut self) -> Vec<Event> {
        self.events.sort_by(|a, b| {
            a.time.total_cmp(&b.time).then(a.drones.cmp(&b.drones)).then_with(|| {
                let rank = |k: EventKind| u8::from(k != EventKind::Collision);
                rank(a.kind).cmp(&rank(b.kind))
            })
        });
        self.events
    }

    /// Drones that touch or are in the wrong order before anything moves.
    fn start(&mut self) {
        self.find_close();
        let event = |kind, drones| Event { time: 0.0, drones, kind };
        for &(i, j) in &self.close {
            let together = match self.motion.as_slice() {
                [x] => at(x, i).0 == at(x, j).0,
                axes => self.excess(axes, i, j).at(0.0) <= 0.0,
            };
            if together {
                self.events.push(event(EventKind::Collision, (i, j)));
            }
        }
        let [x] = self.motion.as_slice() else { return };
        for (i, crossed) in (0..x.len().saturating_sub(1)).zip(&mut self.crossed) {
            if at(x, i).at(0.0) > at(x, i + 1).at(0.0) {
                self.events.push(event(EventKind::OrderLost, (i, i + 1)));
                *crossed = true;
            }
        }
    }

    fn look(&mut self, time: f64) {
        self.find_close();
        let close = std::mem::take(&mut self.close);
        for &(i, j) in &close {
            let collision = |s: f64| Event {
                time: time + s * self.tau,
                drones: (i, j),
                kind: EventKind::Collision,
            };
            match self.motion.as_slice() {
                [x] => {
                    let gap = at(x, j).minus(&at(x, i));
                    let zeros = gap.zeros();
                    self.events.extend(zeros.iter().map(|s| collision(*s)));
                    if j == i + 1 {
                        self.note_order(time, i, &gap, &zeros);
                    }
                }
                axes => {
                    let excess = self.excess(axes, i, j);
                    // The zeros where they approach each other, not those where they separate.
                    let mut before = 0.0;
                    for s in excess.zeros() {
                        if excess.at((before + s) / 2.0) > 0.0 {
                            self.events.push(collision(s));
                        }
                        before = s;
                    }
                }
            }
        }
        self.close = close;
    }

    /// The squared distance of two drones less the squared distance at which they collide.
    fn excess(&self, axes: &[Vec<Bernstein<MOTION>>], i: usize, j: usize) -> Bernstein<SQUARE> {
        let squares = axes.iter().map(|axis| at(axis, j).minus(&at(axis, i)).squared());
        squares.fold(Bernstein::constant(-self.reach * self.reach), |sum, s| sum.plus(&s))
    }

    /// Records the order of drones i and i+1 after each zero of their gap, and in between.
    fn note_order(&mut self, time: f64, i: usize, gap: &Bernstein<MOTION>, zeros: &[f64]) {
        let from = std::iter::once(0.0).chain(zeros.iter().copied());
        let to = zeros.iter().copied().chain([1.0]);
        for (from, to) in from.zip(to) {
            let middle = gap.at((from + to) / 2.0);
            let Some(crossed) = self.crossed.get_mut(i) else {
                return;
            };
            if from < to && middle != 0.0 && *crossed != (middle < 0.0) {
                *crossed = middle < 0.0;
                let kind = if *crossed { EventKind::OrderLost } else { EventKind::OrderRestored };
                self.events.push(Event { time: time + from * self.tau, drones: (i, i + 1), kind });
            }
        }
    }

    /// The pairs whose ranges of motion come within reach: all others stay apart in this step.
    fn find_close(&mut self) {
        let Some((x, across)) = self.motion.split_first() else { return };
        self.ends.clear();
        self.ends.extend(x.iter().map(|motion| (motion.least(), motion.greatest())));
        let (ends, reach) = (&self.ends, self.reach);
        let end = |i: usize| ends.get(i).copied().unwrap_or_default();
        self.by_place.sort_by(|&i, &j| end(i).0.total_cmp(&end(j).0).then(i.cmp(&j)));
        self.close.clear();
        for (rank, &i) in self.by_place.iter().enumerate() {
            let limit = end(i).1 + reach;
            let later = self.by_place.iter().skip(rank + 1);
            for &j in later.take_while(|&&j| end(j).0 <= limit) {
                let apart = |axis: &Vec<Bernstein<MOTION>>| {
                    let (a, b) = (at(axis, i), at(axis, j));
                    a.greatest() + reach < b.least() || b.greatest() + reach < a.least()
                };
                if !across.iter().any(apart) {
                    self.close.push((i.min(j), i.max(j)));
                }
            }
        }
        self.close.sort_unstable();
    }
}

fn at(axis: &[Bernstein<MOTION>], drone: usize) -> Bernstein<MOTION> {
    axis.get(drone).copied().unwrap_or(Bernstein::constant(0.0))
}

/// The motion of a drone in one step, from its states at both ends.
fn moved(integrator: Integrator, tau: f64, from: &Sample, to: &Sample) -> Bernstein<MOTION> {
    match integrator {
        Integrator::Euler => Bernstein::line(from.x, to.x),
        Integrator::Exact => {
            // The rotors are constant within the step: the jerk grows linearly.
            let snap = (to.jerk - from.jerk) / tau;
            let powers = [
                from.x,
                from.v * tau,
                from.a * tau * tau / 2.0,
                from.jerk * tau * tau * tau / 6.0,
                snap * tau * tau * tau * tau / 24.0,
            ];
            // End exactly at the recorded position: no gap between two steps.
            Bernstein::from_powers(powers).ending_at(to.x)
        }
    }
}
