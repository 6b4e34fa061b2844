//! What a sweep is asked to cover, and the work items it comes to.

use std::ops::RangeInclusive;

use cordon_spec::theorems::{Form, Theorem, Truth};
use serde::{Deserialize, Serialize};

use super::weights::WeightSet;
use crate::counterexample::Counterexample;
use cordon_core::{Error, Rational, Result};

/// What a sweep covers. Two sweeps with equal configurations find exactly the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// Version of the program that ran it: results of different versions are not mixed.
    pub version: String,
    /// The theorems, in the paper's order.
    #[serde(with = "cordon_core::serial::list")]
    pub theorems: Vec<Theorem>,
    /// One form of them or both.
    #[serde(with = "cordon_core::serial::list")]
    pub forms: Vec<Form>,
    /// Fewest and most drones, at least 3.
    pub drones: [usize; 2],
    /// The weights eps, each theorem's own range of them.
    pub weights: WeightSet,
    /// Keep to each theorem's own range of weights; otherwise its conclusion is asked for
    /// every weight, which shows why the range is needed.
    pub only_weights_of_the_theorem: bool,
    /// Last step k at which conclusions are asked; the first is 0.
    pub steps: usize,
    /// How starts are covered.
    pub starts: StartSpace,
}

/// How the starts are covered: the kind of evidence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum StartSpace {
    /// Every start on the grid.
    Grid {
        /// Least number of grid units across the region where internal drones start.
        resolution: u32,
    },
    /// Random starts on the grid.
    Sample {
        /// Grid units across the region where internal drones start, as for `Grid`.
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
    /// The theorem that is swept.
    pub theorem: Theorem,
    /// As printed, or sharp.
    pub form: Form,
    /// Number of drones N.
    pub drones: usize,
    /// The one weight eps of the item.
    pub eps: Rational,
}

impl Item {
    /// The counterexample that a start is for step k, if the spec says that it is one.
    pub fn refuted_by(&self, start: Vec<Rational>, step: usize) -> Option<Counterexample> {
        Counterexample::replay(self.theorem, self.form, &self.eps, start, step)
    }
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
        weights: WeightSet,
        steps: usize,
        starts: StartSpace,
    ) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            theorems: theorems.to_vec(),
            forms: forms.to_vec(),
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
        for &theorem in &self.theorems {
            for &form in &self.forms {
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
            StartSpace::Grid { resolution: 0 } | StartSpace::Sample { resolution: 0, .. } => {
                Err(Error::input("grid: `0`: expected at least 1"))
            }
            StartSpace::Sample { samples: 0, .. } => {
                Err(Error::input("sample: `0`: expected at least 1"))
            }
            _ => Ok(()),
        }
    }
}
