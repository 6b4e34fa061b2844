//! The file format (FORMAT.md), read strictly: unknown fields, duplicate keys and numbers that
//! are not in lowest terms are refused, and every size is bounded before anything is computed.

use std::fmt;

use num_bigint::BigInt;
use num_traits::Zero;
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::poly::{Poly, Rational, Var};

/// The only schema there is.
pub const SCHEMA: &str = "cordon-certificate/1";

/// Largest file, in bytes: room for a vector of 10,000 numbers of 400 digits; memory stays a
/// small multiple of it.
pub const MAX_BYTES: usize = 4 << 20;

/// Longest number, in characters: arithmetic is quadratic in it. Room for fractions of 1,000
/// digits, the finest bracket of a critical eps that `cordon threshold` gives.
pub const MAX_NUMBER: usize = 2_100;

/// Most factors of a product. The theorems need 5.
pub const MAX_FACTORS: usize = 8;

/// Most terms of a sum. The theorems need 30.
pub const MAX_TERMS: usize = 128;

/// Most digits in the coefficients of one sum: rational sums cost the square of it. The
/// theorems need 60.
pub const MAX_DIGITS: u64 = 400;

/// An exact number, written as a string in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number(pub Rational);

impl Number {
    /// Reads `7` or `-3/4`: nothing else has the one form in which it prints.
    pub fn read(text: &str) -> Result<Self, String> {
        if text.len() > MAX_NUMBER {
            return Err(format!("number of {} characters: at most {MAX_NUMBER}", text.len()));
        }
        let (num, den) = text.split_once('/').unwrap_or((text, "1"));
        let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
        if !digits(num.strip_prefix('-').unwrap_or(num)) || !digits(den) {
            return Err(format!("`{text}` is no integer or fraction"));
        }
        let parse = |t: &str| t.parse::<BigInt>().map_err(|e| format!("`{text}`: {e}"));
        let (num, den) = (parse(num)?, parse(den)?);
        if den.is_zero() {
            return Err(format!("`{text}` divides by zero"));
        }
        let value = Rational::new(num, den);
        if value.to_string() == text {
            Ok(Self(value))
        } else {
            Err(format!("`{text}` is not in lowest terms: expected `{value}`"))
        }
    }

    /// Digits of numerator and denominator, rounded up: for cost bounds.
    pub fn size(&self) -> u64 {
        1 + (self.0.numer().bits() + self.0.denom().bits()) * 3 / 10
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl Visitor<'_> for Text {
            type Value = Number;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an exact number as a string, like \"-3/4\"")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Number, E> {
                Number::read(text).map_err(E::custom)
            }
        }
        deserializer.deserialize_str(Text)
    }
}

/// An optional field that is there; `null` is not a way to leave it out.
fn present<'de, D: Deserializer<'de>, T: Deserialize<'de>>(d: D) -> Result<Option<T>, D::Error> {
    T::deserialize(d).map(Some)
}

/// Structs are read from objects alone; what `Deserialize` derives takes positional arrays too.
macro_rules! objects {
    ($($t:ty),*) => {$(
        impl<'de> Deserialize<'de> for $t {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Object;
                impl<'de> Visitor<'de> for Object {
                    type Value = $t;
                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        f.write_str("an object")
                    }
                    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<$t, A::Error> {
                        <$t>::deserialize(MapAccessDeserializer::new(map))
                    }
                }
                deserializer.deserialize_map(Object)
            }
        }
    )*};
}

objects!(
    Term,
    Proof,
    Discharge,
    Datum,
    Interval,
    TheoremCert,
    ExactnessCert,
    ContractionCert,
    GrowthCert,
    ViolationName,
    RefutationCert,
    HalfSpace,
    InvarianceCert,
    File
);

/// `c` times a product: of facts in a proof, of indeterminates in a polynomial.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Term {
    /// The coefficient, not zero.
    pub c: Number,
    /// The factors by name, a power as a repetition.
    pub of: Vec<String>,
}

/// One step of a proof. Which fields a rule reads is said at the rule; the others are absent.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Proof {
    /// Name of the rule.
    pub rule: String,
    /// Facts whose product multiplies the goal.
    #[serde(default)]
    pub times: Vec<String>,
    /// The sum that the goal is equal to.
    #[serde(default)]
    pub terms: Vec<Term>,
    /// A polynomial whose sign is split on.
    #[serde(default)]
    pub on: Vec<Term>,
    /// The proofs of the cases.
    #[serde(default)]
    pub branches: Vec<Proof>,
}

/// The proof of one obligation.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Discharge {
    /// Its name, as the checker derives it.
    pub obligation: String,
    /// Its proof.
    pub proof: Proof,
}

/// A polynomial that the search has to invent: the primitive of a sum.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Datum {
    /// `targets` or `flux`.
    pub name: String,
    /// The polynomial.
    pub polynomial: Vec<Term>,
}

/// An interval of weights, ends included.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Interval {
    /// Lower end.
    pub from: Number,
    /// Upper end.
    pub to: Number,
}

/// Kind `theorem`: a claim for every step, every real weight in a range and every N, or one N.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct TheoremCert {
    /// A theorem's number or the name of an extension.
    pub claim: String,
    /// `paper` or `sharp`; only for theorems.
    #[serde(default, deserialize_with = "present")]
    pub form: Option<String>,
    /// One N instead of all N >= 3.
    #[serde(default, deserialize_with = "present")]
    pub drones: Option<u32>,
    /// A range of weights instead of the theorem's own.
    #[serde(default, deserialize_with = "present")]
    pub weights: Option<Interval>,
    /// What the plan asks for beside proofs.
    #[serde(default)]
    pub data: Vec<Datum>,
    /// One proof an obligation.
    pub proofs: Vec<Discharge>,
}

/// What a violated conclusion is about.
#[derive(Clone, Copy, Debug)]
pub enum SubjectName {
    /// Drones i and i+1.
    Pair(usize),
    /// Drone i.
    Drone(usize),
    /// The sum of the positions.
    Sum,
    /// The sum of the squared errors.
    Energy,
}

impl<'de> Deserialize<'de> for SubjectName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Subject;
        impl<'de> Visitor<'de> for Subject {
            type Value = SubjectName;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("{\"pair\": i}, {\"drone\": i}, \"sum\" or \"energy\"")
            }
            fn visit_str<E: Error>(self, word: &str) -> Result<SubjectName, E> {
                match word {
                    "sum" => Ok(SubjectName::Sum),
                    "energy" => Ok(SubjectName::Energy),
                    _ => Err(E::unknown_variant(word, &["sum", "energy"])),
                }
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SubjectName, A::Error> {
                let subject = match map.next_entry::<String, usize>()? {
                    Some((key, i)) if key == "pair" => SubjectName::Pair(i),
                    Some((key, i)) if key == "drone" => SubjectName::Drone(i),
                    _ => return Err(A::Error::custom("expected `pair` or `drone`")),
                };
                match map.next_key::<String>()? {
                    None => Ok(subject),
                    Some(key) => Err(A::Error::custom(format!("unknown field `{key}`"))),
                }
            }
        }
        deserializer.deserialize_any(Subject)
    }
}

/// Kind `exactness`: for every eps above a bound and every N from some N on, a start (its
/// positions polynomials in eps, last and i) that violates the conclusion at step 1.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct ExactnessCert {
    /// The theorem's number: 7.2 or 7.3.
    pub theorem: String,
    /// Smallest N spoken of.
    pub drones_from: u32,
    /// The weights spoken of are those above this.
    pub above: Number,
    /// Left end of the segment.
    pub min: Vec<Term>,
    /// Right end of the segment.
    pub max: Vec<Term>,
    /// Positions of drones 0, 1, ...
    pub head: Vec<Vec<Term>>,
    /// Position of drone i, for every later i.
    pub tail: Vec<Term>,
    /// What is violated.
    pub subject: SubjectName,
    /// One proof an obligation.
    pub proofs: Vec<Discharge>,
}

/// Kind `contraction`.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct ContractionCert {
    /// N.
    pub drones: u32,
    /// The weight.
    pub eps: Number,
    /// The factor by which errors shrink in one step.
    pub rate: Number,
    /// w on the internal drones.
    pub vector: Vec<Number>,
}

/// Kind `growth`.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct GrowthCert {
    /// N.
    pub drones: u32,
    /// The weight.
    pub eps: Number,
    /// w on the internal drones.
    pub vector: Vec<Number>,
}

/// Exemption of the weight from a theorem's hypothesis.
#[derive(Deserialize, Clone, Copy, Debug)]
#[serde(try_from = "String")]
pub struct AnyWeight;

impl TryFrom<String> for AnyWeight {
    type Error = String;

    fn try_from(word: String) -> Result<Self, String> {
        if word == "any" { Ok(Self) } else { Err(format!("`{word}`: expected `any`")) }
    }
}

/// What a conclusion answers on a run.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct ViolationName {
    /// Placement, counted from the first that the conclusion reads.
    pub step: usize,
    /// What fails there.
    pub subject: SubjectName,
}

/// Kind `refutation`.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct RefutationCert {
    /// The theorem's number.
    pub theorem: String,
    /// `paper` or `sharp`.
    pub form: String,
    /// Whether the weight is exempt.
    #[serde(default, deserialize_with = "present")]
    pub weights: Option<AnyWeight>,
    /// Left end of the segment.
    pub min: Number,
    /// Right end of the segment.
    pub max: Number,
    /// The weight.
    pub eps: Number,
    /// X^0.
    pub start: Vec<Number>,
    /// k.
    pub step: u32,
    /// What is violated.
    pub violation: ViolationName,
    /// Who updates, step by step.
    #[serde(default, deserialize_with = "present")]
    pub activation: Option<Vec<Vec<usize>>>,
    /// Who sees whom how late, step by step.
    #[serde(default, deserialize_with = "present")]
    pub delay: Option<Vec<Vec<(usize, usize, usize)>>>,
}

/// A half-space.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct HalfSpace {
    /// Its normal.
    pub normal: Vec<Number>,
    /// `normal . x >= bound`.
    pub bound: Number,
    /// `>` instead of `>=`.
    pub strict: bool,
}

/// Kind `invariance`.
#[derive(Deserialize, Clone, Debug)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct InvarianceCert {
    /// Linear part of the protocol, row by row.
    pub matrix: Vec<Vec<Number>>,
    /// Constant part.
    pub offset: Vec<Number>,
    /// The half-spaces whose intersection is preserved.
    pub invariant: Vec<HalfSpace>,
    /// Farkas multipliers, one row a half-space.
    pub multipliers: Vec<Vec<Number>>,
}

/// The kinds.
#[derive(Deserialize, Clone, Debug)]
#[serde(rename_all = "kebab-case")]
pub enum Certificate {
    /// A theorem or an extension, by symbols.
    Theorem(TheoremCert),
    /// A bound is exact.
    Exactness(ExactnessCert),
    /// Convergence for one N and eps.
    Contraction(ContractionCert),
    /// No convergence for one N and eps.
    Growth(GrowthCert),
    /// A counterexample.
    Refutation(RefutationCert),
    /// An invariant of a user's protocol.
    Invariance(InvarianceCert),
}

#[derive(Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct File {
    schema: String,
    certificate: Certificate,
}

/// Reads a certificate.
///
/// # Errors
/// What is wrong with the text, in one line.
pub fn read(text: &str) -> Result<Certificate, String> {
    if text.len() > MAX_BYTES {
        return Err(format!("{} bytes: at most {MAX_BYTES} are read", text.len()));
    }
    let file: File = serde_json::from_str(text).map_err(|e| e.to_string())?;
    if file.schema != SCHEMA {
        return Err(format!("schema `{}`: expected `{SCHEMA}`", file.schema));
    }
    Ok(file.certificate)
}

/// Reads a polynomial in the given indeterminates.
///
/// # Errors
/// Too large, a zero coefficient, or a name that is none of `vars`.
pub fn polynomial(terms: &[Term], vars: &[Var]) -> Result<Poly, String> {
    bounded(terms)?;
    let mut p = Poly::default();
    for term in terms {
        let mut monomial = Vec::new();
        for name in &term.of {
            let var = vars.iter().find(|v| v.to_string() == *name);
            monomial.push(*var.ok_or_else(|| format!("`{name}` is no indeterminate here"))?);
        }
        monomial.sort_unstable();
        p.add_term(monomial, term.c.0.clone());
    }
    Ok(p)
}

/// Whether a sum is within the limits.
///
/// # Errors
/// Which limit it exceeds.
pub fn bounded(terms: &[Term]) -> Result<(), String> {
    if terms.len() > MAX_TERMS {
        return Err(format!("{} terms: at most {MAX_TERMS}", terms.len()));
    }
    let digits: u64 = terms.iter().map(|t| t.c.size()).sum();
    if digits > MAX_DIGITS {
        return Err(format!("{digits} digits in the coefficients: at most {MAX_DIGITS}"));
    }
    for term in terms {
        if term.of.len() > MAX_FACTORS {
            return Err(format!("{} factors: at most {MAX_FACTORS}", term.of.len()));
        }
        if term.c.0.is_zero() {
            return Err("a coefficient is zero".into());
        }
    }
    Ok(())
}
