//! The theorems in words, and by the paper's numbers.

use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

use crate::{Error, Result};

/// The numbers of the theorems, joined by `between`.
pub fn numbers(theorems: &[Theorem], between: &str) -> String {
    theorems.iter().map(|t| t.number()).collect::<Vec<_>>().join(between)
}

/// The theorems of a list like `7.2,7.4ii`; a number without its part (`7.4`) stands for all its parts,
/// `all` for all theorems.
///
/// # Errors
/// A number that no theorem has.
pub fn named(list: &str) -> Result<Vec<Theorem>> {
    if list.trim() == "all" {
        return Ok(Theorem::ALL.to_vec());
    }
    let mut named = Vec::new();
    for number in list.split(',').map(str::trim) {
        let found = Theorem::ALL.iter().filter(|t| {
            let full = t.number();
            full == number || full.trim_end_matches('i') == number
        });
        let before = named.len();
        named.extend(found);
        if named.len() == before {
            return Err(Error::input(format!(
                "theorem: `{number}` is unknown: expected {}",
                expected(number, &numbers(&Theorem::ALL, ", "))
            )));
        }
    }
    named.sort_unstable();
    named.dedup();
    Ok(named)
}

/// What is expected in the place of a name that is no theorem: some of the `known`, or --protocol before
/// a protocol file.
pub fn expected(name: &str, known: &str) -> String {
    match std::path::Path::new(name).extension().is_some_and(|e| e == "toml") {
        true => "--protocol before a protocol file".to_owned(),
        false => format!("`all` or some of {known}"),
    }
}

/// A theorem in words; its hypothesis is data, in the spec.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// The paper's name of the theorem, with the part in a word.
    pub name: &'static str,
    /// What is concluded, as printed.
    pub paper: &'static str,
    /// What is concluded under the weakest known hypothesis.
    pub sharp: &'static str,
    /// What is wrong with, or missing from, the printed form.
    pub erratum: Option<&'static str>,
}

impl Words {
    /// The conclusion in the given form.
    pub fn conclusion(&self, form: Form) -> &'static str {
        match form {
            Form::Paper => self.paper,
            Form::Sharp => self.sharp,
        }
    }
}

/// Name, conclusions and erratum of a theorem.
pub fn words(theorem: Theorem) -> &'static Words {
    match theorem {
        Theorem::Ordering => &Words {
            name: "invariant spatial ordering",
            paper: "X_i^k < X_{i+1}^k for all i and k",
            sharp: "X_i^k < X_{i+1}^k for all i and k; for N >= 4 and any eps > 1/2 some start crosses at step 1",
            erratum: Some(
                "the text has eps < 1/3, the appendix eps <= 1/3: neither is needed, 1/2 is exact for N >= 4",
            ),
        },
        Theorem::UpperBound => &Words {
            name: "reference position upper bound",
            paper: "X_i^k <= T_i for all i and k",
            sharp: "X_i^k <= T_i for all i and k; for any eps > 1/2 some such start violates it at step 1",
            erratum: Some(
                "assumption 3 is not needed, X_i^0 <= T_i is enough; the paper's own start (0,10,20,30,100) violates it (30 >= 25)",
            ),
        },
        Theorem::SumBounded => &Words {
            name: "sum of positions: bound",
            paper: "c^k <= N*min + N(N-1)/2 * l for all k",
            sharp: "c^k <= N*min + N(N-1)/2 * l for all k",
            erratum: None,
        },
        Theorem::SumMaximal => &Words {
            name: "sum of positions: equality",
            paper: "c^k = N*min + N(N-1)/2 * l if and only if X_i^k = T_i for all i",
            sharp: "c^k = N*min + N(N-1)/2 * l if and only if X_i^k = T_i for all i",
            erratum: None,
        },
        Theorem::SumNonDecreasing => &Words {
            name: "non-decreasing sum",
            paper: "c^{k+1} >= c^k for all k",
            sharp: "c^{k+1} - c^k = eps*(g_{N-2}^k - g_0^k) for every eps and start, and under this hypothesis it is >= 0",
            erratum: None,
        },
        Theorem::SumStationary => &Words {
            name: "stationary sum at the targets",
            paper: "X_i^k = T_i for all i implies c^{k+1} = c^k",
            sharp: "X_i^k = T_i for all i implies c^{k+1} = c^k",
            erratum: None,
        },
        Theorem::TargetsFixed => &Words {
            name: "convergence: targets are fixed",
            paper: "X_i^k = T_i for all i implies c^{k+h} = c^k for all h >= 1",
            sharp: "X_i^k = T_i for all i implies X_i^{k+h} = T_i for all i and h >= 1",
            erratum: None,
        },
        Theorem::ConstantSum => &Words {
            name: "convergence: a constant sum means targets",
            paper: "c^{k+h} = c^k for all h >= 1 implies X_i^k = T_i for all i",
            sharp: "c^{k+h} = c^k for h = 1 .. ceil((N-2)/2) implies X_i^k = T_i for all i",
            erratum: Some("false at eps = 0, which definition 6 allows"),
        },
        Theorem::GloballyIncreasing => &Words {
            name: "globally increasing",
            paper: "c^{k+1} = c^k, X_j^k < T_j for some j >= 3 and X_i^k = T_i for all i < j imply c^{k+h+1} > c^{k+h} for some h >= 1",
            sharp: "if some drone is off its target at step k, the first increase is c^{k+h+1} > c^{k+h} with h = min over off-target j of min(j, N-1-j) - 1, and c is constant before",
            erratum: Some(
                "false at eps = 0; free index i; j >= 3 should be j >= 1, h > 1 in the text is h >= 1 in the formula; \
         under assumption 3 no drone is ever exactly at its target, so the printed premise is read on UB starts",
            ),
        },
        Theorem::Limit => &Words {
            name: "limit",
            paper: "X_i^k -> T_i for all i (in finite form: the sum of squared errors falls in every step off the targets)",
            sharp: "X_i^k -> T_i for all i, and from every start only for these eps; for eps <= 1/2 at the rate |e_i^k| <= (1 - 8 eps/(N-1)^2)^k * max_j(|e_j^0|/w_j) * w_i, w_i = i(N-1-i)",
            erratum: Some(
                "no bound on eps is printed: false at eps = 0 and from 1/(1 + cos(pi/(N-1))) on; \
         the approach need not be monotonic: (0,10,11,24,100) with eps = 1/5 takes drone 1 from 10 to 8.2",
            ),
        },
    }
}

/// A range of weights in formula.
pub fn weights(range: WeightRange) -> &'static str {
    match range {
        WeightRange::Any => "any eps",
        WeightRange::Unit => "0 <= eps <= 1",
        WeightRange::BelowThird => "0 <= eps < 1/3",
        WeightRange::BelowHalf => "0 <= eps < 1/2",
        WeightRange::UpToHalf => "0 <= eps <= 1/2",
        WeightRange::UpToHalfOrOne => "0 <= eps <= 1/2 (N = 3: 0 <= eps <= 1)",
        WeightRange::PositiveUpToHalf => "0 < eps <= 1/2",
        WeightRange::BelowCritical => "0 < eps < 1/(1 + cos(pi/(N-1)))",
    }
}

/// A set of starts in formula.
pub fn starts(set: StartSet) -> &'static str {
    match set {
        StartSet::Any => "any start",
        StartSet::Ordered => "X_0 < X_1 < ... < X_{N-1}",
        StartSet::FirstSubsegment => "X_0 < X_1 < ... < X_{N-1}, X_i < min + l for internal i",
        StartSet::UpperBounded => "X_i <= T_i for all i",
    }
}
