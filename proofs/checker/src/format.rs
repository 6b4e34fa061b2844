//! The file format (FORMAT.md), read strictly: objects are read from objects alone, unknown
//! fields, duplicate keys and `null` are refused.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::expr::Sort;
use crate::number::Number;

/// The only schema there is.
pub const SCHEMA: &str = "cordon-certificate/2";

/// Largest file, in bytes: room for a vector of 10,000 numbers of 400 digits.
pub const MAX_BYTES: usize = 4 << 20;

/// Declares structs that are read from objects alone; what `Deserialize` derives by itself takes
/// positional arrays too.
macro_rules! objects {
    ($($(#[$doc:meta])* $name:ident { $($(#[$about:meta])* $field:ident: $t:ty),* $(,)? })*) => {$(
        $(#[$doc])*
        #[derive(Deserialize, Clone, Debug)]
        #[serde(remote = "Self", deny_unknown_fields)]
        pub struct $name { $($(#[$about])* pub $field: $t),* }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Object;
                impl<'de> Visitor<'de> for Object {
                    type Value = $name;
                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        f.write_str("an object")
                    }
                    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<$name, A::Error> {
                        $name::deserialize(MapAccessDeserializer::new(map))
                    }
                }
                deserializer.deserialize_map(Object)
            }
        }
    )*};
}

/// Fields of an object by name, in any number.
#[derive(Clone, Debug)]
pub struct Named<T>(pub BTreeMap<String, T>);

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Object<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Object<T> {
            type Value = Named<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named<T>, A::Error> {
                let mut all = BTreeMap::new();
                while let Some((key, value)) = map.next_entry::<String, T>()? {
                    if all.contains_key(&key) {
                        return Err(A::Error::custom(format!("duplicate field `{key:.40}`")));
                    }
                    all.insert(key, value);
                }
                Ok(Named(all))
            }
        }
        deserializer.deserialize_map(Object(PhantomData))
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::read(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

impl<'de> Deserialize<'de> for Sort {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match String::deserialize(deserializer)?.as_str() {
            "integer" => Ok(Self::Integer),
            "real" => Ok(Self::Real),
            word => Err(D::Error::unknown_variant(word, &["integer", "real"])),
        }
    }
}

/// An optional field that is there; `null` is not a way to leave it out.
fn present<'de, D: Deserializer<'de>, T: Deserialize<'de>>(d: D) -> Result<Option<T>, D::Error> {
    T::deserialize(d).map(Some)
}

objects! {
    /// A file.
    File {
        /// [`SCHEMA`].
        schema: String,
        /// What it holds.
        certificate: Kind,
    }
    /// A theorem with its proof.
    Theorem {
        /// What is proved.
        statement: Statement,
        /// Why.
        proof: Proofs,
    }
    /// What is proved: of every run of the system that the assumptions hold of, the conclusions do.
    Statement {
        /// What runs, if it is of the spec.
        #[serde(default, deserialize_with = "present")]
        system: Option<System>,
        /// What runs, if it is a user's.
        #[serde(default, deserialize_with = "present")]
        family: Option<Family>,
        /// Constants: every value of their sort is spoken of.
        #[serde(default)]
        constants: Named<Sort>,
        /// Functions that the clauses speak of.
        #[serde(default)]
        definitions: Vec<Definition>,
        /// What is assumed besides.
        #[serde(default)]
        assumptions: Vec<Clause>,
        /// What follows.
        conclusions: Vec<Clause>,
    }
    /// What runs.
    System {
        /// `coverage`, `consensus` or `projection`.
        protocol: String,
        /// `full`, `activation` or `delay`.
        steps: String,
        /// Number and form of the theorem whose range of weights is meant, or an interval, or none.
        #[serde(default)]
        weights: Weights,
        /// Number and form of the theorem whose starts are meant.
        #[serde(default, deserialize_with = "present")]
        starts: Option<Hypothesis>,
        /// One N in the place of every N >= 3.
        #[serde(default, deserialize_with = "present")]
        drones: Option<u32>,
    }
    /// A user's protocol of any number of agents.
    Family {
        /// `line` or `ring`.
        topology: String,
        /// The variables that each agent has.
        state: Vec<String>,
        /// Constants, the same in all steps, with the ends of their ranges.
        #[serde(default)]
        parameters: Named<Range>,
        /// For each class of agents what its variables are after a step; those left out keep their values.
        rules: Named<Named<String>>,
        /// One N in the place of every N >= 3.
        #[serde(default, deserialize_with = "present")]
        drones: Option<u32>,
    }
    /// A closed range, without an end where nothing is given.
    Range {
        /// At least this.
        #[serde(default, deserialize_with = "present")]
        from: Option<Number>,
        /// At most this.
        #[serde(default, deserialize_with = "present")]
        to: Option<Number>,
    }
    /// A theorem's hypothesis.
    Hypothesis {
        /// Its number.
        theorem: String,
        /// `paper` or `sharp`.
        form: String,
    }
    /// A range of weights: any, unless something is given.
    #[derive(Default)]
    Weights {
        /// That of a theorem.
        #[serde(default, deserialize_with = "present")]
        of: Option<Hypothesis>,
        /// At least this.
        #[serde(default, deserialize_with = "present")]
        from: Option<Number>,
        /// At most this.
        #[serde(default, deserialize_with = "present")]
        to: Option<Number>,
    }
    /// A function by recursion on its last argument.
    Definition {
        /// Its name.
        name: String,
        /// Its arguments, integers.
        #[serde(default)]
        of: Vec<String>,
        /// Where the last argument starts.
        #[serde(default)]
        from: String,
        /// The first values.
        #[serde(default)]
        base: Vec<String>,
        /// The next value, times `scale`.
        step: String,
        /// A positive factor of the next value.
        #[serde(default, deserialize_with = "present")]
        scale: Option<Scale>,
    }
    /// A positive factor.
    Scale {
        /// The factor.
        by: String,
        /// Why it is positive: a sum.
        sum: String,
    }
    /// For all values of the variables, if the given literals hold so does the goal.
    Clause {
        /// Its name.
        name: String,
        /// The variables.
        #[serde(default, rename = "for")]
        vars: Vec<Variable>,
        /// The literals given.
        #[serde(default)]
        given: Vec<Given>,
        /// The goal.
        goal: String,
    }
    /// A variable.
    Variable {
        /// Its name.
        name: String,
        /// Its values.
        sort: Sort,
    }
    /// A literal given.
    Given {
        /// Its name, as a fact.
        name: String,
        /// The literal.
        holds: String,
    }
    /// Lemmas in order, then the proof of each conclusion.
    Proofs {
        /// Functions that the statement does not speak of.
        #[serde(default)]
        definitions: Vec<Definition>,
        /// Clauses with their proofs.
        #[serde(default)]
        lemmas: Vec<Lemma>,
        /// The conclusions' proofs by name.
        conclusions: Named<Proof>,
    }
    /// A clause with its proof.
    Lemma {
        /// The clause.
        clause: Clause,
        /// Its proof.
        proof: Proof,
    }
    /// The goal as a sum of products of facts.
    Positivity {
        /// Instances of lemmas: further facts.
        #[serde(rename = "use", default)]
        instances: Vec<Instance>,
        /// Positive facts that multiply the goal.
        #[serde(default)]
        times: Vec<String>,
        /// The sum.
        sum: String,
    }
    /// An instance of a lemma.
    Instance {
        /// The fact's name.
        name: String,
        /// The lemma's.
        lemma: String,
        /// A term for each variable.
        #[serde(default)]
        with: Named<String>,
        /// A sum for each literal given.
        #[serde(default)]
        given: Named<String>,
    }
    /// An integer variable is at its bound or beyond.
    Cases {
        /// The name of the literal that bounds it.
        on: String,
        /// The variable.
        variable: String,
        /// The proof at the bound.
        equal: Box<Proof>,
        /// The proof beyond it.
        beyond: Box<Proof>,
    }
    /// A term is above, equal to or below 0.
    Split {
        /// The fact's name.
        name: String,
        /// The term.
        on: String,
        /// The proof where it is > 0 (an integer: >= 1).
        above: Box<Proof>,
        /// The proof where it is 0.
        equal: Box<Proof>,
        /// The proof where it is < 0 (an integer: <= -1).
        below: Box<Proof>,
    }
    /// Induction over an integer variable.
    Induction {
        /// The name of the literal that bounds it below.
        on: String,
        /// The variable.
        variable: String,
        /// The name of the hypothesis.
        hypothesis: String,
        /// The variable of the hypothesis in its place, and the name of the literal that it is no later.
        earlier: String,
        /// The proof at the bound.
        base: Box<Proof>,
        /// The proof one further.
        step: Box<Proof>,
    }
    /// Convergence for one N and eps.
    Contraction {
        /// N.
        drones: u32,
        /// The weight.
        eps: Number,
        /// The factor by which errors shrink in one step.
        rate: Number,
        /// w on the internal drones.
        vector: Vec<Number>,
    }
    /// No convergence for one N and eps.
    Growth {
        /// N.
        drones: u32,
        /// The weight.
        eps: Number,
        /// w on the internal drones.
        vector: Vec<Number>,
    }
    /// A counterexample.
    Refutation {
        /// The theorem's number.
        theorem: String,
        /// `paper` or `sharp`.
        form: String,
        /// `any`: the weight is exempt.
        #[serde(default, deserialize_with = "present")]
        weights: Option<String>,
        /// Left end of the segment.
        min: Number,
        /// Right end of the segment.
        max: Number,
        /// The weight.
        eps: Number,
        /// X^0.
        start: Vec<Number>,
        /// k.
        step: u32,
        /// What is violated.
        violation: Violation,
        /// Who updates, step by step.
        #[serde(default, deserialize_with = "present")]
        activation: Option<Vec<Vec<usize>>>,
        /// Who sees whom how late, step by step.
        #[serde(default, deserialize_with = "present")]
        delay: Option<Vec<Vec<Delay>>>,
    }
    /// What a conclusion answers on a run.
    Violation {
        /// Placement, counted from the first that the conclusion reads.
        step: usize,
        /// `pair`, `drone`, `sum` or `energy`.
        subject: String,
        /// The index of the drone, or of the first of the pair.
        #[serde(default, deserialize_with = "present")]
        at: Option<usize>,
    }
    /// A late message.
    Delay {
        /// Who sees.
        drone: usize,
        /// Whom.
        sees: usize,
        /// How many steps ago.
        age: usize,
    }
    /// A linear system.
    Linear {
        /// The variables.
        state: Vec<String>,
        /// Parameters with the ends of their ranges; each step may have other values.
        #[serde(default)]
        parameters: Named<[Number; 2]>,
        /// For each mode the variables that it changes, and to what.
        modes: Named<Named<String>>,
    }
    /// A run of a linear system that violates a claim.
    Counterexample {
        /// What runs.
        system: Linear,
        /// Literals that the start is assumed to meet.
        #[serde(default)]
        assumptions: Vec<String>,
        /// The start, a number a variable.
        start: Vec<Number>,
        /// Values of parameters that are the same in all steps.
        #[serde(default)]
        with: Named<Number>,
        /// What acts, step by step.
        steps: Vec<Move>,
        /// The literal that fails after the last step.
        claim: String,
    }
    /// One step of a linear system.
    Move {
        /// The mode.
        by: String,
        /// The values of the other parameters in it.
        #[serde(default)]
        with: Named<Number>,
    }
    /// What holds along the runs of a linear system.
    Invariance {
        /// What runs.
        system: Linear,
        /// Literals about the state.
        nodes: Named<Vec<String>>,
        /// The node that the start is assumed to meet.
        start: String,
        /// Why one node follows from another.
        edges: Vec<Edge>,
        /// What follows from a node.
        claims: Vec<Claim>,
    }
    /// What holds at a node, after a step or at once.
    Edge {
        /// The node known to hold.
        from: String,
        /// The mode of the step, if one is taken.
        #[serde(default, deserialize_with = "present")]
        by: Option<String>,
        /// The node that holds then.
        to: String,
        /// For each of its literals, for each vertex of the parameters in it, the multipliers of the literals known.
        multipliers: Vec<Vec<Named<Number>>>,
    }
    /// What follows from a node.
    Claim {
        /// The node.
        at: String,
        /// The literal.
        holds: String,
        /// The multipliers of the node's literals.
        multipliers: Named<Number>,
    }
    /// A quadratic form of readouts that falls in every step, or never.
    Quadratic {
        /// What runs.
        system: Linear,
        /// Affine forms of the state: y0, y1, ..
        readouts: Vec<String>,
        /// For each mode what a step makes of each readout, in y0, y1, ..
        maps: Named<Vec<String>>,
        /// The form for every mode, as a lower triangle.
        #[serde(default, deserialize_with = "present")]
        matrix: Option<Vec<Vec<Number>>>,
        /// A form for each mode that acts next.
        #[serde(default)]
        matrices: Named<Vec<Vec<Number>>>,
        /// The factor by which its root falls at least.
        #[serde(default, deserialize_with = "present")]
        rate: Option<Number>,
        /// A state from which it does not fall to 0.
        #[serde(default, deserialize_with = "present")]
        start: Option<Vec<Number>>,
    }
    /// Ellipsoids that runs in continuous time do not leave.
    Ellipsoid {
        /// What runs: rows are derivatives.
        system: Linear,
        /// The ellipsoids.
        nodes: Named<Node>,
        /// The nodes in which runs start, of each of them whichever.
        start: Vec<String>,
        /// Points of all of those: runs start between them.
        points: Vec<Vec<Number>>,
        /// Along what runs stay inside.
        edges: Vec<Passage>,
        /// Literals that hold in all ellipsoids.
        claims: Vec<String>,
    }
    /// The set (x - c)' Q^-1 (x - c) <= 1.
    Node {
        /// c.
        centre: Vec<Number>,
        /// Q, as a lower triangle.
        matrix: Vec<Vec<Number>>,
    }
    /// From an ellipsoid to another while a mode acts.
    Passage {
        /// The ellipsoid before.
        from: String,
        /// The mode.
        by: String,
        /// The ellipsoid after.
        to: String,
        /// How fast a run goes inwards at least.
        decay: Number,
        /// How long it takes; any time where the ellipsoid stays.
        #[serde(default, deserialize_with = "present")]
        time: Option<Number>,
    }
}

/// The kinds.
#[derive(Deserialize, Clone, Debug)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// By the kernel.
    Theorem(Box<Theorem>),
    /// By a vector.
    Contraction(Contraction),
    /// By a vector.
    Growth(Growth),
    /// By a run.
    Refutation(Box<Refutation>),
    /// By a run.
    Counterexample(Box<Counterexample>),
    /// By Farkas' lemma.
    Invariance(Box<Invariance>),
    /// By a quadratic form.
    Quadratic(Box<Quadratic>),
    /// By ellipsoids.
    Ellipsoid(Box<Ellipsoid>),
}

/// A proof: a rule with what it reads.
#[derive(Deserialize, Clone, Debug)]
#[serde(rename_all = "kebab-case")]
pub enum Proof {
    /// A sum of products of facts.
    Positivity(Positivity),
    /// The same of -1 >= 0: the facts contradict each other.
    Absurd(Positivity),
    /// An integer variable at its bound or beyond.
    Cases(Cases),
    /// A term above, equal to or below 0.
    Split(Split),
    /// Induction.
    Induction(Induction),
}

/// Reads a certificate.
///
/// # Errors
/// What is wrong with the text, in one line.
pub fn read(text: &str) -> Result<Kind, String> {
    if text.len() > MAX_BYTES {
        return Err(format!("{} bytes: at most {MAX_BYTES} are read", text.len()));
    }
    let file: File = serde_json::from_str(text).map_err(|e| e.to_string())?;
    match file.schema == SCHEMA {
        true => Ok(file.certificate),
        false => Err(format!("schema `{:.40}`: expected `{SCHEMA}`", file.schema)),
    }
}
