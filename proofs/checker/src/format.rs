//! The file format (FORMAT.md), read strictly: objects are read from objects alone, unknown
//! fields, duplicate keys and `null` are refused.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::expr::Sort;
use crate::fault::shown;
use crate::number::Number;

/// The only schema there is.
pub const SCHEMA: &str = "cordon-certificate/2";

/// Largest file, in bytes: room for a vector of 10,000 numbers of 400 digits.
pub const MAX_BYTES: usize = 4 << 20;

/// Declares structs that are read from objects alone; what `Deserialize` derives by itself takes positional arrays too. First the
/// fields that have to be there; after `;` those that are empty, and after another those that are none, where they are left out.
macro_rules! objects {
    ($($(#[$doc:meta])* $name:ident { $($needed:ident: $n:ty),*
        $(; $($empty:ident: $e:ty),* $(; $($none:ident: $o:ty),*)?)? })*) => {$(
        $(#[$doc])*
        #[derive(Deserialize, Clone, Debug)]
        #[serde(remote = "Self", deny_unknown_fields)]
        #[allow(missing_docs, reason = "the doc of the struct and FORMAT.md say what the fields are")]
        pub struct $name {
            $(pub $needed: $n,)*
            $($(#[serde(default)] pub $empty: $e,)*
            $($(#[serde(default, deserialize_with = "present")] pub $none: Option<$o>,)*)?)?
        }

        impl<'de> FromMap<'de> for $name {
            fn from_map<A: MapAccess<'de>>(map: A) -> Result<Self, A::Error> {
                Self::deserialize(MapAccessDeserializer::new(map))
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_map(Object(PhantomData))
            }
        }
    )*};
}

trait FromMap<'de>: Sized {
    fn from_map<A: MapAccess<'de>>(map: A) -> Result<Self, A::Error>;
}

struct Object<T>(PhantomData<T>);

impl<'de, T: FromMap<'de>> Visitor<'de> for Object<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
        T::from_map(map)
    }
}

/// Fields of an object by name, in any number.
#[derive(Clone, Debug)]
pub struct Named<T>(pub BTreeMap<String, T>);

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<'de, T: Deserialize<'de>> FromMap<'de> for Named<T> {
    fn from_map<A: MapAccess<'de>>(mut map: A) -> Result<Self, A::Error> {
        let mut all = BTreeMap::new();
        while let Some((key, value)) = map.next_entry::<String, T>()? {
            if all.contains_key(&key) {
                return Err(A::Error::custom(format!("duplicate field `{key:.40}`")));
            }
            // They stand in the verdict.
            if shown(&key) != key {
                return Err(A::Error::custom(format!("name `{key:.40}` is not all shown")));
            }
            all.insert(key, value);
        }
        Ok(Self(all))
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
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

/// A lower triangle.
type Triangle = Vec<Vec<Number>>;

objects! {
    /// A file: [`SCHEMA`], and what it holds.
    File { schema: String, certificate: Kind }
    /// What is proved, and why.
    Theorem { statement: Statement, proof: Proofs }
    /// What is proved: of every run of the system, for all functions and constants that the
    /// assumptions hold of, the conclusions do; in words of the functions defined.
    Statement {
        conclusions: Vec<Clause>;
        functions: Named<Function>, constants: Named<Sort>, definitions: Vec<Definition>, assumptions: Vec<Clause>; system: System
    }
    /// What runs: `coverage`, `consensus` or `projection`, in `full` steps, with `activation` or `delay`; the weight of drone i in step
    /// k, if it is not `eps`.
    System { protocol: String, steps: String;; weight: String }
    /// A function of so many integers, and what it gives.
    Function { of: usize, to: Sort }
    /// A function by recursion on the last of its arguments, integers: where that starts, the first values, and the next
    /// value times a factor.
    Definition { name: String, of: Vec<String>, from: String, step: String; base: Vec<String>; scale: String }
    /// For all values of the variables, if the literals given hold so does the goal.
    Clause { name: String, goal: String; r#for: Vec<Variable>, given: Vec<Given> }
    /// A variable and its values.
    Variable { name: String, sort: Sort }
    /// A literal given, and its name as a fact.
    Given { name: String, holds: String }
    /// Lemmas in order, and the conclusions' proofs by name.
    Proofs { conclusions: Named<Proof>; lemmas: Vec<Lemma> }
    /// A clause with its proof.
    Lemma { clause: Clause, proof: Proof }
    /// The goal, times positive facts, as a sum of products of facts, instances of lemmas among them.
    Positivity { sum: String; r#use: Vec<Instance>, times: Vec<String> }
    /// A fact of that name: the lemma with a term for each variable, and a sum for each literal given.
    Instance { name: String, lemma: String; with: Named<String>, given: Named<String> }
    /// An integer variable is at the bound that the literal `on` sets it, or beyond.
    Cases { on: String, variable: String, equal: Box<Proof>, beyond: Box<Proof> }
    /// The term `on` is > 0 (an integer: >= 1), 0, or < 0 (an integer: <= -1), as a fact of that name.
    Split { name: String, on: String, above: Box<Proof>, equal: Box<Proof>, below: Box<Proof> }
    /// Induction over an integer variable that the literal `on` bounds below; the hypothesis by name, with the variable that stands in it
    /// for one that is no later, and the proofs at the bound and one further.
    Induction {
        on: String, variable: String, hypothesis: String, earlier: String, base: Box<Proof>, step: Box<Proof>
    }
    /// Convergence for one N and eps: w on the internal drones, and the factor by which errors shrink in one step.
    Contraction { drones: u32, eps: Number, rate: Number, vector: Vec<Number> }
    /// No convergence for one N and eps: w on the internal drones.
    Growth { drones: u32, eps: Number, vector: Vec<Number> }
    /// A counterexample: X^0, k, and what is violated there. The weight is exempt where `weights` is `any`; step by step, who updates, or who
    /// sees whom how late.
    Refutation {
        theorem: String, form: String, min: Number, max: Number, eps: Number, start: Vec<Number>, step: u32,
        violation: Violation;; weights: String, activation: Vec<Vec<usize>>, delay: Vec<Vec<Delay>>
    }
    /// What a conclusion answers on a run: placement, counted from the first that it reads; `pair`, `drone`, `sum` or
    /// `energy`; the index of the drone, or of the first of the pair.
    Violation { step: usize, subject: String;; at: usize }
    /// Who sees whom, and how many steps ago.
    Delay { drone: usize, sees: usize, age: usize }
    /// A linear system: for each mode the variables that it changes, and to what; parameters with the ends of their ranges,
    /// each step may have other values.
    Linear { state: Vec<String>, modes: Named<Named<String>>; parameters: Named<[Number; 2]> }
    /// A run of a linear system, from a start that meets the assumptions, after the last step of which a literal fails; values of
    /// parameters that are the same in all steps.
    Counterexample {
        system: Linear, start: Vec<Number>, steps: Vec<Move>, claim: String; assumptions: Vec<String>, with: Named<Number>
    }
    /// One step of a linear system: the mode, and the values of the other parameters in it.
    Move { by: String; with: Named<Number> }
    /// Ellipsoids that runs in continuous time do not leave, rows being derivatives: runs start between points of all those of
    /// the start, of which of them does not matter, and stay inside along the edges; claims hold in all ellipsoids.
    Ellipsoid {
        system: Linear, nodes: Named<Node>, start: Vec<String>, points: Vec<Vec<Number>>, edges: Vec<Passage>, claims: Vec<String>
    }
    /// The set (x - c)' Q^-1 (x - c) <= 1.
    Node { centre: Vec<Number>, matrix: Triangle }
    /// From an ellipsoid to another while a mode acts: how fast a run goes inwards at least, and how long it takes; any time where
    /// the ellipsoid stays.
    Passage { from: String, by: String, to: String, decay: Number;; time: Number }
}

/// What a certificate holds, by its kind.
#[derive(Deserialize, Clone, Debug)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs, reason = "the structs say it")]
pub enum Kind {
    Theorem(Box<Theorem>),
    Contraction(Contraction),
    Growth(Growth),
    Refutation(Box<Refutation>),
    Counterexample(Box<Counterexample>),
    Ellipsoid(Box<Ellipsoid>),
}

/// A proof: a rule with what it reads.
#[derive(Deserialize, Clone, Debug)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs, reason = "the structs say it")]
pub enum Proof {
    Positivity(Positivity),
    /// The same of -1 >= 0: the facts contradict each other.
    Absurd(Positivity),
    Cases(Cases),
    Split(Split),
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
