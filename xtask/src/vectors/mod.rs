//! Test vectors for the mechanised mirrors: positions that the spec computed, as data and as
//! theorems that a proof assistant checks by computation.
//!
//! The Rocq and Lean developments execute the definitions they prove things about on these
//! inputs; the committed files are generated here, and a test compares the bytes.

mod cases;
mod lean;
mod rocq;
mod show;

use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::kth_step;
use cordon_spec::graph::Path;
use cordon_spec::local::{LocalParams, TickRatio, project, swarm_tick};
use cordon_spec::{DroneMap, Params, Phase, State};

use cordon_core::Rational;

pub use lean::lean;
pub use rocq::rocq;
pub use show::{json, tsv};

/// What a vector runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// `kth_step`: k ticks of the whole swarm with counter limit `n`.
    Coverage { min: i64, max: i64, n: u32, phase: Phase },
    /// `swarm_tick`, k times: local machines that exchange positions.
    Local { min: i64, max: i64, ratio: TickRatio, phase: Phase },
    /// `exec_consensus` on the path, k times.
    Consensus,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Coverage { .. } => "coverage",
            Self::Local { .. } => "local",
            Self::Consensus => "consensus",
        }
    }
}

/// A fraction as written in the table of cases.
type Fraction = (i64, i64);

/// Some ks of one run.
struct Series {
    name: &'static str,
    kind: Kind,
    eps: Fraction,
    start: &'static [Fraction],
    ks: &'static [u64],
}

/// One run with its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vector {
    name: String,
    kind: Kind,
    eps: Rational,
    start: Vec<Rational>,
    k: u64,
    expected: Vec<Rational>,
}

fn rational((num, den): Fraction) -> Rational {
    Rational::new(num.into(), den.into())
}

/// All vectors, computed by the spec.
pub fn vectors() -> Vec<Vector> {
    let of_series = |s: &'static Series| s.ks.iter().map(|&k| s.vector(k));
    cases::SERIES.iter().flat_map(of_series).collect()
}

impl Series {
    fn vector(&self, k: u64) -> Vector {
        let eps = rational(self.eps);
        let start: Vec<_> = self.start.iter().map(|&x| rational(x)).collect();
        let expected = expected(self.kind, &eps, &start, k);
        Vector { name: format!("{}_{k}", self.name), kind: self.kind, eps, start, k, expected }
    }
}

fn expected(kind: Kind, eps: &Rational, start: &[Rational], k: u64) -> Vec<Rational> {
    let params = |min: i64, max: i64, n| {
        let (min, max) = (Rational::from_integer(min.into()), Rational::from_integer(max.into()));
        Params { min, max, eps: eps.clone(), n }
    };
    let start = start.to_vec();
    match kind {
        Kind::Coverage { min, max, n, phase } => {
            kth_step(&params(min, max, n), State::initial(start, n, phase), k).drones
        }
        Kind::Local { min, max, ratio, phase } => {
            let n = ratio.counter_limit();
            let p = LocalParams { protocol: params(min, max, n), count: start.len(), ratio };
            let global = State::initial(start, n, phase);
            let machines: Vec<_> = (0..p.count).map(|i| project(&p.protocol, &global, i)).collect();
            let after = (0..k).fold(machines, |m, _| swarm_tick(&p, &m));
            after.into_iter().map(|m| m.st.own).collect()
        }
        Kind::Consensus => {
            let path = Path { count: start.count() };
            (0..k).fold(start, |x, _| exec_consensus(eps, &path, &x))
        }
    }
}
