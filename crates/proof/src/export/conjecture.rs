//! What can be exported as an inductive proof: the theorems, and the two companions of 7.3.

use std::fmt;

use cordon_core::theorems::{starts, words};
use cordon_spec::theorems::{
    Form, Setting, StartSet, Theorem, Truth, Verdict, WeightRange, above_targets, in_box,
};
use cordon_spec::{DroneMap, Ordered};

use cordon_core::{Error, Result};

/// A claim about all placements of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Conjecture {
    /// A theorem of the paper.
    Theorem(Theorem),
    /// The mirror image of 7.3: X_i >= T_i for all i (PROTOCOL section 2).
    Mirror,
    /// min <= X_i <= max for all i (PROTOCOL section 2).
    Box,
}

impl Conjecture {
    /// Every claim with an inductive proof one step deep. 7.8, a limit, has none: its proofs
    /// are the contraction certificates and the mechanised ones.
    pub const ALL: [Self; 11] = [
        Self::Theorem(Theorem::Ordering),
        Self::Theorem(Theorem::UpperBound),
        Self::Theorem(Theorem::SumBounded),
        Self::Theorem(Theorem::SumMaximal),
        Self::Theorem(Theorem::SumNonDecreasing),
        Self::Theorem(Theorem::SumStationary),
        Self::Theorem(Theorem::TargetsFixed),
        Self::Theorem(Theorem::ConstantSum),
        Self::Theorem(Theorem::GloballyIncreasing),
        Self::Mirror,
        Self::Box,
    ];

    /// The paper's number, or `mirror`, `box`.
    pub fn number(self) -> &'static str {
        match self {
            Self::Theorem(t) => t.number(),
            Self::Mirror => "mirror",
            Self::Box => "box",
        }
    }

    /// What it says, in formula.
    pub fn conclusion_text(self, form: Form) -> &'static str {
        match self {
            Self::Theorem(t) => words(t).conclusion(form),
            Self::Mirror => "X_i^k >= T_i for all i and k",
            Self::Box => "min <= X_i^k <= max for all i and k",
        }
    }

    /// The claims of a list like `7.2,box`; `7.4` names both parts, `all` all claims.
    ///
    /// # Errors
    /// A number that no claim has.
    pub fn named(list: &str) -> Result<Vec<Self>> {
        if list.trim() == "all" {
            return Ok(Self::ALL.to_vec());
        }
        let mut named = Vec::new();
        for number in list.split(',').map(str::trim) {
            let before = named.len();
            named.extend(
                Self::ALL
                    .iter()
                    .filter(|c| c.number() == number || c.number().trim_end_matches('i') == number),
            );
            if named.len() == before {
                let known: Vec<_> = Self::ALL.iter().map(|c| c.number()).collect();
                let why = if number == "7.8" { " (a limit has no inductive step)" } else { "" };
                return Err(Error::input(format!(
                    "theorem: `{number}` is unknown here{why}: expected `all` or some of {}",
                    known.join(", ")
                )));
            }
        }
        named.sort_unstable();
        named.dedup();
        Ok(named)
    }

    /// The weights of its hypothesis.
    pub fn weights(self, form: Form) -> WeightRange {
        match self {
            Self::Theorem(t) => t.hypothesis(form).weights,
            Self::Mirror | Self::Box => WeightRange::UpToHalf,
        }
    }

    /// The starts of its hypothesis, in words.
    pub fn starts_text(self, form: Form) -> &'static str {
        match self {
            Self::Theorem(t) => starts(t.hypothesis(form).starts),
            Self::Mirror => "X_i >= T_i for all i",
            Self::Box => "min <= X_i <= max for all i",
        }
    }

    /// Whether its hypothesis allows the start `x`.
    pub fn allows<S: Ordered>(self, form: Form, setting: &Setting<S>, x: &[S]) -> Truth {
        let anchored = || StartSet::Any.contains(setting, x);
        match self {
            Self::Theorem(t) => t.hypothesis(form).starts.contains(setting, x),
            Self::Mirror => anchored().and(truth(above_targets(setting, x))),
            Self::Box => anchored().and(truth(in_box(setting, x))),
        }
    }

    /// Whether `x` meets the invariant from which the claim follows: the sharp hypothesis on
    /// starts, which every step preserves (assumption 3 itself is not preserved).
    pub fn invariant<S: Ordered>(self, setting: &Setting<S>, x: &[S]) -> Truth {
        self.allows(Form::Sharp, setting, x)
    }

    /// Whether the starts of this form are the invariant itself.
    pub fn starts_are_invariant(self, form: Form) -> bool {
        match self {
            Self::Theorem(t) => t.hypothesis(form).starts == t.hypothesis(Form::Sharp).starts,
            Self::Mirror | Self::Box => true,
        }
    }

    /// How many placements beyond X^k the conclusion about step k reads.
    pub fn span(self, form: Form, drones: usize) -> usize {
        match self {
            Self::Theorem(t) => t.span(form, drones),
            Self::Mirror | Self::Box => 0,
        }
    }

    /// Whether the conclusion holds of the run `X^k, X^{k+1}, ...`.
    pub fn conclusion<S: Ordered, M: DroneMap<S>>(
        self,
        form: Form,
        setting: &Setting<S>,
        run: &[M],
    ) -> Verdict {
        let now = || run.first().map(AsRef::as_ref);
        match self {
            Self::Theorem(t) => t.conclusion(form, setting, run),
            Self::Mirror => now().map_or(Verdict::Undecided, |x| above_targets(setting, x)),
            Self::Box => now().map_or(Verdict::Undecided, |x| in_box(setting, x)),
        }
    }
}

impl fmt::Display for Conjecture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.number())
    }
}

fn truth(verdict: Verdict) -> Truth {
    match verdict {
        Verdict::Holds | Verdict::Vacuous => Truth::True,
        Verdict::Violated(_) => Truth::False,
        Verdict::Undecided => Truth::Unknown,
    }
}
