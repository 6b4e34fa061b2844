//! Certificates about a linear system: what the kinds `invariance`, `counterexample` and `ellipsoid`
//! hold.
//!
//! Forms are text in the checker's own syntax: sums and products of numbers (`3/4`), names and brackets.
//! Nothing is computed here: that the multipliers fit, the checker says.

use std::collections::BTreeMap;

use num_traits::Zero;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::{invariance, sealed};
use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::system::expression::{add_term, or_zero};

/// What runs: in each step one of the modes acts, with any values of the parameters.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinearSystem {
    /// Names of the variables: a letter, then letters and digits, at most 40; not `last`.
    pub state: Vec<String>,
    /// The ends of each parameter's closed range. Every step may take other values.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub parameters: BTreeMap<String, [String; 2]>,
    /// For each mode the variables that it changes, and to what: affine in the state together and in each
    /// parameter. A variable that is not named keeps its value.
    pub modes: BTreeMap<String, BTreeMap<String, String>>,
}

/// Farkas multipliers by the place of a literal among those known: >= 0, for equations of either sign.
/// A literal that is not there has 0.
pub type Multipliers = BTreeMap<usize, String>;

/// What holds along the runs of a system.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Invariance {
    /// What runs.
    pub system: LinearSystem,
    /// Literals (`form > 0`, `form >= 0`, `form = 0`, the form affine in the state) by the name of the node.
    pub nodes: BTreeMap<String, Vec<String>>,
    /// The node that is assumed of the start.
    pub start: String,
    /// Why one node follows from another.
    pub edges: Vec<Edge>,
    /// What follows from a node: one at least.
    pub claims: Vec<NodeClaim>,
}

/// That `to` holds wherever `from` did a step of mode `by` earlier, or does now.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Edge {
    /// The node known to hold.
    pub from: String,
    /// The mode of the step; none for an edge that takes none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by: Option<String>,
    /// The node shown to hold.
    pub to: String,
    /// For each literal of `to`: of its form after the step, at each vertex of the parameters that occur in
    /// that form (a range that is a point counts once), the multipliers of the literals of `from`. Vertices are ordered by the
    /// parameters' names, low before high, the last name changing fastest; without parameters there is one.
    pub multipliers: Vec<Vec<Multipliers>>,
}

/// A literal that follows from a node.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NodeClaim {
    /// The node.
    pub at: String,
    /// The literal.
    pub holds: String,
    /// The multipliers of the node's literals.
    pub multipliers: Multipliers,
}

/// A run that ends where a claim fails.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counterexample {
    /// What runs.
    pub system: LinearSystem,
    /// Literals that the start is assumed to meet.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<String>,
    /// The start, a number a variable.
    pub start: Vec<String>,
    /// Values of the parameters that are the same in all steps.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub with: BTreeMap<String, String>,
    /// What acts, step by step.
    pub steps: Vec<Move>,
    /// The literal that fails after the last step.
    pub claim: String,
}

/// One step of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Move {
    /// The mode.
    pub by: String,
    /// The values of the other parameters in it.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub with: BTreeMap<String, String>,
}

impl Counterexample {
    /// The certificate.
    pub fn certificate(&self) -> Value {
        sealed("counterexample", json!(self))
    }
}

/// Ellipsoids that the runs of a system in continuous time do not leave: its rows are derivatives.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ellipsoid {
    /// What runs.
    pub system: LinearSystem,
    /// The ellipsoids.
    pub nodes: BTreeMap<String, EllipsoidNode>,
    /// Those in which runs start.
    pub start: Vec<String>,
    /// Points of the latter: runs start between them.
    pub points: Vec<Vec<String>>,
    /// Along what runs stay inside.
    pub edges: Vec<Passage>,
    /// Literals that hold in all ellipsoids and on the way between them: one at least, no equation.
    pub claims: Vec<String>,
}

/// The set (x - c)' Q^-1 (x - c) <= 1.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EllipsoidNode {
    /// c.
    pub centre: Vec<String>,
    /// Q, positive definite, as a lower triangle.
    pub matrix: Vec<Vec<String>>,
}

/// From an ellipsoid to another while a mode acts, both moving straight.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Passage {
    /// The ellipsoid before.
    pub from: String,
    /// The mode.
    pub by: String,
    /// The ellipsoid after.
    pub to: String,
    /// V' <= decay (1 - V), V being the form that is at most 1 inside.
    pub decay: String,
    /// How long it takes; none where the ellipsoid stays, for any time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<String>,
}

impl Ellipsoid {
    /// The certificate.
    pub fn certificate(&self) -> Value {
        sealed("ellipsoid", json!(self))
    }
}

impl Invariance {
    /// The certificate: a theorem about the system's runs. `None` where it cannot be written: see
    /// [`invariance::certificate`].
    pub fn certificate(&self) -> Option<Value> {
        invariance::certificate(self)
    }
}

/// Multipliers from a list with an entry a literal.
pub fn multipliers(all: &[Rational]) -> Multipliers {
    let nonzero = all.iter().enumerate().filter(|(_, m)| !m.is_zero());
    nonzero.map(|(i, m)| (i, fraction(m))).collect()
}

/// The form `constant + sum of coefficients * names` as text.
pub fn form<'n>(
    constant: &Rational,
    terms: impl IntoIterator<Item = (&'n str, &'n Rational)>,
) -> String {
    let mut text = String::new();
    for (name, c) in terms.into_iter().filter(|(_, c)| !c.is_zero()) {
        add_term(&mut text, c, &[name]);
    }
    if !constant.is_zero() {
        add_term(&mut text, constant, &[]);
    }
    or_zero(text)
}
