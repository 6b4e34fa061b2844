//! Collisions and violations of the order, between the samples too.
//!
//! Within a step the plant's motion is known: a straight line with the Euler integrator, a
//! polynomial of degree four with the exact one. The first zero of a gap is found on that
//! motion, so that no meeting slips through between two grid points.

mod bernstein;

use self::bernstein::{Bernstein, DEGREE};
use super::plant::Integrator;

/// Something that happened to two drones.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// When, in seconds.
    pub time: f64,
    /// The two drones, smaller number first.
    pub drones: (usize, usize),
    /// A collision, or the loss or return of the order.
    pub kind: EventKind,
}

/// What can happen to two neighbouring drones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// They are at the same place.
    Collision,
    /// From here on a drone is beyond its successor.
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

    /// The kind of that name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Collision, Self::OrderLost, Self::OrderRestored]
            .into_iter()
            .find(|k| k.name() == name)
    }
}

/// A drone along x at a grid point, as far as its further motion depends on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Position in m.
    pub x: f64,
    /// Velocity in m/s.
    pub v: f64,
    /// Acceleration g theta in m/s2.
    pub a: f64,
    /// Its rate of change, g omega, in m/s3.
    pub jerk: f64,
}

/// Looks for events grid point by grid point.
pub struct Watch {
    integrator: Integrator,
    tau: f64,
    last: Vec<Sample>,
    /// The motion of every drone in the step that is being looked at.
    motion: Vec<Bernstein>,
    /// Drones by the lower end of their motion; nearly sorted from step to step.
    by_place: Vec<usize>,
    /// Whether drone i is beyond drone i+1.
    crossed: Vec<bool>,
    events: Vec<Event>,
    started: bool,
}

impl Watch {
    /// A watch over drones whose plants have this integrator and step.
    pub fn new(integrator: Integrator, tau: f64) -> Self {
        Self {
            integrator,
            tau,
            last: Vec::new(),
            motion: Vec::new(),
            by_place: Vec::new(),
            crossed: Vec::new(),
            events: Vec::new(),
            started: false,
        }
    }

    /// The next grid point; `time` is that of the last one, where the motion begins.
    pub fn next(&mut self, time: f64, samples: &[Sample]) {
        if self.started {
            self.motion.clear();
            let pairs = self.last.iter().zip(samples);
            self.motion.extend(pairs.map(|(a, b)| motion(self.integrator, self.tau, a, b)));
            self.look(time);
        } else {
            self.started = true;
            self.by_place = (0..samples.len()).collect();
            self.crossed = vec![false; samples.len()];
            self.motion = samples.iter().map(|s| Bernstein([s.x; DEGREE + 1])).collect();
            self.start(samples);
        }
        self.last.clear();
        self.last.extend_from_slice(samples);
    }

    /// Everything that happened, by time.
    pub fn finish(mut self) -> Vec<Event> {
        self.events.sort_by(|a, b| {
            a.time.total_cmp(&b.time).then(a.drones.cmp(&b.drones)).then_with(|| {
                let rank = |k: EventKind| u8::from(k != EventKind::Collision);
                rank(a.kind).cmp(&rank(b.kind))
            })
        });
        self.events
    }

    /// Drones that are together or in the wrong order before anything moves.
    fn start(&mut self, samples: &[Sample]) {
        let event = |kind, drones| Event { time: 0.0, drones, kind };
        for (i, j) in self.close_pairs() {
            if let (Some(a), Some(b)) = (samples.get(i), samples.get(j))
                && a.x == b.x
            {
                self.events.push(event(EventKind::Collision, (i, j)));
            }
        }
        for (i, pair) in samples.windows(2).enumerate() {
            if let [a, b] = pair
                && a.x > b.x
            {
                self.events.push(event(EventKind::OrderLost, (i, i + 1)));
                if let Some(crossed) = self.crossed.get_mut(i) {
                    *crossed = true;
                }
            }
        }
    }

    fn look(&mut self, time: f64) {
        for (i, j) in self.close_pairs() {
            let (Some(a), Some(b)) = (self.motion.get(i), self.motion.get(j)) else {
                continue;
            };
            let gap = b.minus(a);
            let zeros = gap.zeros();
            for s in &zeros {
                let time = time + s * self.tau;
                self.events.push(Event { time, drones: (i, j), kind: EventKind::Collision });
            }
            if j == i + 1 {
                self.note_order(time, i, &gap, &zeros);
            }
        }
    }

    /// The order of drones i and i+1 after each zero of their gap, and in between.
    fn note_order(&mut self, time: f64, i: usize, gap: &Bernstein, zeros: &[f64]) {
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

    /// The pairs whose motions' ranges overlap: all others keep apart in this step.
    fn close_pairs(&mut self) -> Vec<(usize, usize)> {
        let motion = &self.motion;
        let lower = |i: usize| motion.get(i).map_or(0.0, Bernstein::least);
        let upper = |i: usize| motion.get(i).map_or(0.0, Bernstein::greatest);
        self.by_place.sort_by(|&i, &j| lower(i).total_cmp(&lower(j)).then(i.cmp(&j)));
        let mut pairs = Vec::new();
        for (place, &i) in self.by_place.iter().enumerate() {
            let later = self.by_place.iter().skip(place + 1);
            for &j in later.take_while(|&&j| lower(j) <= upper(i)) {
                pairs.push((i.min(j), i.max(j)));
            }
        }
        pairs.sort_unstable();
        pairs
    }
}

/// The motion of a drone in one step, by its states at both ends.
fn motion(integrator: Integrator, tau: f64, from: &Sample, to: &Sample) -> Bernstein {
    match integrator {
        Integrator::Euler => Bernstein::line(from.x, to.x),
        Integrator::Exact => {
            // The rotors are constant in the step: the jerk grows evenly.
            let snap = (to.jerk - from.jerk) / tau;
            let powers = [
                from.x,
                from.v * tau,
                from.a * tau * tau / 2.0,
                from.jerk * tau * tau * tau / 6.0,
                snap * tau * tau * tau * tau / 24.0,
            ];
            // The end is the recorded one, to the bit: no gap between two steps.
            Bernstein::from_powers(powers).ending_at(to.x)
        }
    }
}
