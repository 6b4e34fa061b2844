//! What can be proved: the theorems, and their extensions.

use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

use super::window::Step;

/// How a claim's goals arise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A theorem of the paper.
    Theorem(Theorem),
    /// A property that the theorem's start set has and every step preserves.
    Invariant(&'static str, Step),
    /// A property that every step preserves.
    Step(&'static str, Step),
    /// The identity behind 7.5.
    Flux,
    /// Consensus preserves the sum.
    Consensus,
    /// Local machines against the global run.
    Projection,
}

/// A claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claim {
    /// The theorem's number, or the extension's name.
    pub name: &'static str,
    /// The theorem that gives weights and starts.
    pub theorem: Option<Theorem>,
    /// How its goals arise.
    pub kind: Kind,
}

const EXTENSIONS: [Claim; 12] = {
    const fn claim(name: &'static str, theorem: Theorem, kind: Kind) -> Claim {
        Claim { name, theorem: Some(theorem), kind }
    }
    use Theorem::{Ordering, UpperBound};
    [
        Claim { name: "7.5-identity", theorem: None, kind: Kind::Flux },
        claim("7.3-mirror", UpperBound, Kind::Step("lower", Step::Plain)),
        claim("7.3-box", UpperBound, Kind::Step("box", Step::Plain)),
        claim("7.2-activation", Ordering, Kind::Invariant("ordered", Step::Activation)),
        claim("7.3-activation", UpperBound, Kind::Invariant("upper", Step::Activation)),
        claim("7.3-mirror-activation", UpperBound, Kind::Step("lower", Step::Activation)),
        claim("7.3-box-activation", UpperBound, Kind::Step("box", Step::Activation)),
        claim("7.3-delay", UpperBound, Kind::Invariant("upper", Step::Delay)),
        claim("7.3-mirror-delay", UpperBound, Kind::Step("lower", Step::Delay)),
        claim("7.3-box-delay", UpperBound, Kind::Step("box", Step::Delay)),
        Claim { name: "consensus-average", theorem: None, kind: Kind::Consensus },
        Claim { name: "projection", theorem: None, kind: Kind::Projection },
    ]
};

impl Claim {
    /// Every claim: the theorems, then their extensions.
    pub fn all() -> Vec<Self> {
        let theorem =
            |t: Theorem| Self { name: t.number(), theorem: Some(t), kind: Kind::Theorem(t) };
        Theorem::ALL.into_iter().map(theorem).chain(EXTENSIONS).collect()
    }

    /// Whether it is a theorem and so has forms.
    pub fn has_forms(&self) -> bool {
        matches!(self.kind, Kind::Theorem(_))
    }

    /// The weights that it is about. 7.8 is proved for every N up to 1/2.
    pub fn weights(&self, form: Form) -> WeightRange {
        match self.theorem.map(|t| t.hypothesis(form).weights) {
            None => WeightRange::Any,
            Some(WeightRange::BelowCritical) => WeightRange::PositiveUpToHalf,
            Some(range) => range,
        }
    }

    /// The starts that it is about.
    pub fn starts(&self, form: Form) -> StartSet {
        self.theorem.map_or(StartSet::Any, |t| t.hypothesis(form).starts)
    }

    /// The closed form that it needs.
    pub fn primitive(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Flux | Kind::Consensus => Some("flux"),
            Kind::Theorem(Theorem::SumBounded | Theorem::SumMaximal | Theorem::TargetsFixed) => {
                Some("targets")
            }
            Kind::Theorem(
                Theorem::SumNonDecreasing
                | Theorem::SumStationary
                | Theorem::ConstantSum
                | Theorem::GloballyIncreasing,
            ) => Some("flux"),
            _ => None,
        }
    }
}
