//! What a sweep is asked to cover, and the work items it comes to.

use std::ops::RangeInclusive;

use cordon_spec::theorems::{Form, Theorem, Truth};
use serde::{Deserialize, Serialize};

use super::weights::Weights;
use cordon_core::{Error, Rational, Result};

/// What a sweep covers. Two sweeps with equal configurations find exactly the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// Version of the program that ran it: results of different versions are not mixed.
    pub version: String,
    /// Numbers of the theorems, in the paper's order.
    pub theorems: Vec<String>,
    /// `paper`, `sharp` or both.
    pub forms: Vec<String>,
    /// Fewest and most drones, at least 3.
    pub drones: [usize; 2],
    /// The weights.
    pub weights: Weights,
    /// Keep to each theorem's own range of weights; otherwise its conclusion is asked for
    /// every weight, which shows why the range is needed.
    pub only_weights_of_the_theorem: bool,
    /// Last step k at which conclusions are asked; the first is 0.
    pub steps: usize,
    /// How starts are covered.
    pub starts: Starts,
}

/// How the starts are covered: the kind of evidence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Starts {
    /// Every start on the grid.
    Grid {
        /// Least number of grid units across the region where internal drones start.
        resolution: u32,
    },
    /// Random starts on the grid.
    Sample {
        /// As for `Grid`.
        resolution: u32,
        /// How many starts a work item draws.
        samples: u64,
        /// Seed of the draws.
        seed: u64,
    },
    /// All real starts, through the generators of the set they form.
    Complete,
}

/// One piece of work: a theorem in one form for one N and one weight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// Position in the sweep, from 0.
    pub number: usize,
    /// The theorem.
    pub theorem: Theorem,
    /// Its form.
    pub form: Form,
    /// Number of drones N.
    pub drones: usize,
    /// The weight.
    pub eps: Rational,
}

/// Numbers of drones, and most steps: beyond, a sweep would not end in anybody's lifetime.
pub const DRONES: RangeInclusive<usize> = 3..=64;
const MAX_STEPS: usize = 100_000;

/// Most work items in one sweep.
const MAX_ITEMS: usize = 1_000_000;

impl Config {
    /// A configuration of this program's version.
    pub fn new(
        theorems: &[Theorem],
        forms: &[Form],
        drones: [usize; 2],
        weights: Weights,
        steps: usize,
        starts: Starts,
    ) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            theorems: theorems.iter().map(|t| t.number().into()).collect(),
            forms: forms.iter().map(|f| f.label().into()).collect(),
            drones,
            weights,
            only_weights_of_the_theorem: true,
            steps,
            starts,
        }
    }

    /// The work items, by theorem, form, N and weight.
    ///
    /// # Errors
    /// A field that makes no sense, or more work items than anybody can run; the message
    /// names the field.
    pub fn items(&self) -> Result<Vec<Item>> {
        self.validate()?;
        let weights = self.weights.listed()?;
        let [fewest, most] = self.drones;
        let mut items = Vec::new();
        for theorem in &self.theorems {
            let theorem = theorem_of(theorem)?;
            for form in &self.forms {
                let form = form_of(form)?;
                let range = theorem.hypothesis(form).weights;
                for drones in fewest..=most {
                    for eps in &weights {
                        let inside = range.contains(
                            &Rational::from(eps.numer().clone()),
                            &Rational::from(eps.denom().clone()),
                            drones,
                        );
                        if self.only_weights_of_the_theorem && inside != Truth::True {
                            continue;
                        }
                        let number = items.len();
                        if number >= MAX_ITEMS {
                            return Err(Error::input(format!(
                                "max-denominator: more than {MAX_ITEMS} work items: expected fewer weights, drones or theorems"
                            )));
                        }
                        items.push(Item { number, theorem, form, drones, eps: eps.clone() });
                    }
                }
            }
        }
        Ok(items)
    }

    fn validate(&self) -> Result<()> {
        let [fewest, most] = self.drones;
        if most < fewest || !DRONES.contains(&fewest) || !DRONES.contains(&most) {
            let (least, last) = DRONES.into_inner();
            return Err(Error::input(format!(
                "drones: `{fewest}..{most}`: expected LO..HI with {least} <= LO <= HI <= {last}"
            )));
        }
        if self.steps > MAX_STEPS {
            return Err(Error::input(format!(
                "steps: `{}`: expected at most {MAX_STEPS}",
                self.steps
            )));
        }
        match self.starts {
            Starts::Grid { resolution: 0 } | Starts::Sample { resolution: 0, .. } => {
                Err(Error::input("grid: `0`: expected at least 1"))
            }
            Starts::Sample { samples: 0, .. } => {
                Err(Error::input("sample: `0`: expected at least 1"))
            }
            _ => Ok(()),
        }
    }
}

/// The theorem of a number like `7.4ii`.
///
/// # Errors
/// No theorem has it.
pub fn theorem_of(number: &str) -> Result<Theorem> {
    Theorem::ALL
        .into_iter()
        .find(|t| t.number() == number)
        .ok_or_else(|| Error::input(format!("theorem: `{number}` is unknown")))
}

/// The form of a label.
///
/// # Errors
/// No form has it.
pub fn form_of(label: &str) -> Result<Form> {
    Form::ALL
        .into_iter()
        .find(|f| f.label() == label)
        .ok_or_else(|| Error::input(format!("form: `{label}`: expected `paper` or `sharp`")))
}
