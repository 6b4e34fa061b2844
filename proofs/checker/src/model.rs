//! The swarm on symbols: which drones stand for which, and what a step makes of them.
//!
//! # The case split, and why it covers every N and i
//!
//! `exec_coverage` computes drone i from drones i-1, i, i+1, and branches on `i = 0` and
//! `i + 1 = count` only. For N >= 3 every drone is thus of one [`Class`]: the first (i = 0), the
//! last (i = N-1), or inner (1 <= i <= N-2); and every pair (i, i+1) is the first (i = 0; drone
//! 1 is inner), the last (i = N-2; drone N-2 is inner) or inner (1 <= i <= N-3, both drones
//! inner; there is none if N = 3). Two members of a class differ in i and N only through the
//! indeterminates `i` and `last` (= N-1), and the polynomial that a step gives is the same, so
//! one representative swarm a class, on which the spec's own step is run, stands for all. The
//! position of a neighbour is an indeterminate even where the neighbour may be an end drone:
//! what is proved for every value is true for `min` and `max`.
//! That the spec treats all members of a class alike is what a reader of `exec_cvg` sees; the
//! checker's tests confirm it by execution for every i and N up to 16.

use std::collections::BTreeMap;

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::placement::error_at;
use cordon_spec::theorems::{StartSet, WeightRange};
use cordon_spec::{Params, Scalar, State};

use crate::poly::{Poly, Rational, Var};
use crate::rules::Fact;
use crate::rules::Relation::{self, NonNegative, Positive, Zero};

/// Where a drone, or a pair of neighbours, stands in the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Drone 0; the pair (0, 1).
    First,
    /// Every drone or pair between.
    Inner,
    /// Drone N-1; the pair (N-2, N-1).
    Last,
}

impl Class {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::First, Self::Inner, Self::Last];

    /// Its name in obligations.
    pub fn label(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Inner => "inner",
            Self::Last => "last",
        }
    }
}

/// A property of every drone or of every pair of neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// X_{i+1} - X_i > 0 (7.2).
    Ordered,
    /// (N-1) e_i >= 0: X_i <= T_i (7.3).
    UpperBound,
    /// -(N-1) e_i >= 0: X_i >= T_i, the mirror image.
    LowerBound,
    /// (N-1) e_i = 0: X_i = T_i (7.6 i).
    AtTarget,
    /// X_i - min >= 0.
    AboveMin,
    /// max - X_i >= 0.
    BelowMax,
}

impl Family {
    /// Its name in facts and obligations, and its relation to 0.
    pub fn label(self) -> (&'static str, Relation) {
        match self {
            Self::Ordered => ("gap", Positive),
            Self::UpperBound => ("error", NonNegative),
            Self::LowerBound => ("-error", NonNegative),
            Self::AtTarget => ("error", Zero),
            Self::AboveMin => ("x-min", NonNegative),
            Self::BelowMax => ("max-x", NonNegative),
        }
    }

    /// Whether it speaks of pairs of neighbours.
    pub fn of_pairs(self) -> bool {
        self == Self::Ordered
    }

    /// Its polynomial at drone (or pair) i + offset of a placement, where known.
    pub fn at(self, place: &Place, offset: i32) -> Option<Poly> {
        let x = place.x.get(&offset)?;
        let error = || place.error(offset, x);
        Some(match self {
            Self::Ordered => place.x.get(&(offset + 1))?.clone() - x,
            Self::UpperBound | Self::AtTarget => error(),
            Self::LowerBound => Poly::from_int(0) - &error(),
            Self::AboveMin => x.clone() - &named("min"),
            Self::BelowMax => named("max") - x,
        })
    }

    /// What it says of a placement, wherever the placement is known.
    pub fn facts(self, place: &Place) -> Vec<Fact> {
        let (label, relation) = self.label();
        let at = |&o: &i32| Some(Fact::new(&format!("{label}[{o}]"), self.at(place, o)?, relation));
        place.x.keys().filter_map(at).collect()
    }
}

/// The positions of drones around drone i, by their offset from i.
#[derive(Clone, Debug)]
pub struct Place {
    /// The index i.
    pub index: Poly,
    /// The known positions.
    pub x: BTreeMap<i32, Poly>,
}

impl Place {
    /// (N-1) times the error of drone i + offset at position `x`.
    pub fn error(&self, offset: i32, x: &Poly) -> Poly {
        let i = self.index.clone() + &Poly::from_int(offset);
        error_at(&named("min"), &named("max"), &named("last"), &i, x)
    }
}

/// How a step is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Everybody updates.
    Plain,
    /// Any subset updates.
    Activation,
    /// Neighbours are seen where they were at any earlier step.
    Delay,
}

/// A class's representative swarm.
#[derive(Clone, Debug)]
pub struct Swarm {
    /// What the properties of the present (with [`Mode::Delay`], also of the past) are about.
    pub place: Place,
    /// All its positions, ends included.
    positions: Vec<Poly>,
    /// The index of drone i among them.
    base: usize,
    /// How many drones from i on the goal reads: 2 for a pair.
    read: usize,
}

impl Swarm {
    /// The swarm for a class of pairs or of single drones, neighbours in place of offset o being
    /// called `x[o]`, or `y[o]` where they are seen late.
    pub fn new(class: Class, pairs: bool, mode: Mode) -> Self {
        let read = if pairs { 2 } else { 1 };
        let low = if class == Class::First { 0 } else { -1 };
        let high = if class == Class::Last { read - 1 } else { read };
        let position = |o: i32| match class {
            Class::First if o == low => named("min"),
            Class::Last if o == high => named("max"),
            _ if mode == Mode::Delay && o != 0 => Poly::var(Var::At("y", o)),
            _ => Poly::var(Var::At("x", o)),
        };
        let x: BTreeMap<i32, Poly> = (low..=high).map(|o| (o, position(o))).collect();
        let index = match class {
            Class::First => Poly::from_int(0),
            Class::Inner => named("i"),
            Class::Last => named("last") - &Poly::from_int(read - 1),
        };
        // Drones before and behind that no goal reads: they make the others inner drones.
        let before = (class != Class::First).then(|| named("min"));
        let behind = (class != Class::Last).then(|| named("max"));
        let base = usize::from(class != Class::First) * 2;
        let positions = before.into_iter().chain(x.values().cloned()).chain(behind).collect();
        Self { place: Place { index, x }, positions, base, read: read as usize }
    }

    /// What is known of i: `i-1 >= 0` and so on, up to the highest index that the class allows.
    pub fn index_facts(&self, class: Class) -> Vec<Fact> {
        if class != Class::Inner {
            return Vec::new();
        }
        let (i, last) = (named("i"), named("last"));
        let reach = self.read as i32;
        vec![
            Fact::new("i-1", i.clone() - &Poly::from_int(1), NonNegative),
            Fact::new(&format!("last-i-{reach}"), last - &i - &Poly::from_int(reach), NonNegative),
        ]
    }

    /// The positions that the goal reads after a step of the spec, for every way to take it; each with
    /// its name.
    pub fn after(&self, mode: Mode) -> Vec<(String, Place)> {
        let params = Params { min: named("min"), max: named("max"), eps: named("eps"), n: 0 };
        let state = State { drones: self.positions.clone(), timesteps: 0 };
        let place = |next: State<Vec<Poly>>| Place {
            index: self.place.index.clone(),
            x: (0..self.read).map(|o| (o as i32, next.drones[self.base + o].clone())).collect(),
        };
        match mode {
            Mode::Plain => vec![(String::new(), place(exec_coverage(&params, &state)))],
            Mode::Delay => {
                let seen = |_, j: usize| &self.positions[j];
                vec![(String::new(), place(exec_coverage_delayed(&params, &state, seen)))]
            }
            Mode::Activation => (0..1_usize << self.read)
                .map(|subset| {
                    let active = |j: usize| {
                        j < self.base
                            || j >= self.base + self.read
                            || subset >> (j - self.base) & 1 == 1
                    };
                    let bits: String = (0..self.read)
                        .map(|o| if subset >> o & 1 == 1 { '1' } else { '0' })
                        .collect();
                    (
                        format!("/active-{bits}"),
                        place(exec_coverage_active(&params, &state, active)),
                    )
                })
                .collect(),
        }
    }
}

/// What a start set says around drone i.
pub fn start_facts(set: StartSet, class: Class, place: &Place) -> Vec<Fact> {
    match set {
        StartSet::Any => Vec::new(),
        StartSet::Ordered => Family::Ordered.facts(place),
        StartSet::UpperBounded => Family::UpperBound.facts(place),
        StartSet::FirstSubsegment => {
            let mut facts = Family::Ordered.facts(place);
            // X_i < min + l, N-1 times; only of inner drones.
            if let (Class::Inner, Some(x)) = (class, place.x.get(&0)) {
                let (min, max, last) = (named("min"), named("max"), named("last"));
                let bound = last.clone() * &min + &(max - &min) - &(last * x);
                facts.push(Fact::new("min+l-x[0]", bound, Positive));
            }
            facts
        }
    }
}

/// Which weights are spoken of.
#[derive(Clone, Debug)]
pub enum Weights {
    /// Those of a theorem.
    Range(WeightRange),
    /// An interval, ends included.
    Interval(Rational, Rational),
}

impl Weights {
    /// What they are known to be, for N = 3 or for larger N.
    ///
    /// # Errors
    /// The range is not given by polynomials.
    pub fn facts(&self, three: bool) -> Result<Vec<Fact>, String> {
        let eps = || named("eps");
        let below = |n: i32, relation| {
            let label = if n == 1 { "1-eps".into() } else { format!("1-{n}eps") };
            Fact::new(&label, Poly::from_int(1) - &(Poly::from_int(n) * &eps()), relation)
        };
        let from = |relation| Fact::new("eps", eps(), relation);
        Ok(match self {
            Self::Range(range) => match range {
                WeightRange::Any => vec![],
                WeightRange::Unit => vec![from(NonNegative), below(1, NonNegative)],
                WeightRange::BelowThird => vec![from(NonNegative), below(3, Positive)],
                WeightRange::BelowHalf => vec![from(NonNegative), below(2, Positive)],
                WeightRange::UpToHalfOrOne if three => {
                    vec![from(NonNegative), below(1, NonNegative)]
                }
                WeightRange::UpToHalf | WeightRange::UpToHalfOrOne => {
                    vec![from(NonNegative), below(2, NonNegative)]
                }
                WeightRange::PositiveUpToHalf => vec![from(Positive), below(2, NonNegative)],
                WeightRange::BelowCritical => {
                    return Err("the range has no polynomial form for every N".into());
                }
            },
            Self::Interval(low, high) => {
                let mut facts = vec![
                    Fact::new("eps-from", eps() - &Poly::constant(low.clone()), NonNegative),
                    Fact::new("to-eps", Poly::constant(high.clone()) - &eps(), NonNegative),
                ];
                if *low > Rational::from_integer(0.into()) {
                    facts.push(from(Positive));
                }
                facts
            }
        })
    }

    /// Whether N = 3 has its own range.
    pub fn differ_for_three(&self) -> bool {
        matches!(self, Self::Range(WeightRange::UpToHalfOrOne))
    }
}

/// The indeterminate of that name.
pub fn named(name: &'static str) -> Poly {
    Poly::named(name)
}
