//! The two kinds of sweep, each of a size that takes about a second.

use std::time::Instant;

use cordon_spec::theorems::{Form, Theorem};

use super::{Evidence, Status, Tier, TierVerdict, this_program};
use cordon_core::Result;
use cordon_proof::sweep::run::{Progress, run};
use cordon_proof::sweep::summary::{Summary, summaries};
use cordon_proof::sweep::{Config, Judgement, StartSpace, WeightSet};

/// Sweeps over every start on a grid.
#[derive(Clone, Copy, Debug)]
pub struct Grid;

/// Sweeps from all real starts.
#[derive(Clone, Copy, Debug)]
pub struct Complete;

/// Fewest drones of a swarm.
const FEWEST: usize = 3;

const GRID: Size = Size { drones: 6, denominator: 6, steps: 10 };
/// Grid units across the region where internal drones start.
const RESOLUTION: u32 = 8;
const COMPLETE: Size = Size { drones: 8, denominator: 12, steps: 16 };

/// The size of a sweep.
struct Size {
    /// Largest number of drones.
    drones: usize,
    /// Largest denominator of the weights.
    denominator: u32,
    /// Last step that is checked.
    steps: usize,
}

impl Size {
    fn sweep(&self, theorem: Theorem, starts: StartSpace) -> Result<Option<Summary>> {
        let weights = WeightSet::unit(self.denominator);
        let drones = [FEWEST, self.drones];
        let config = Config::new(&[theorem], &[Form::Sharp], drones, weights, self.steps, starts);
        let items = config.items()?;
        let mut findings = Vec::new();
        run(&config, &items, 0, &Progress::default(), |finding| {
            findings.push(finding);
            Ok(())
        })?;
        Ok(summaries(&config, &findings, false)?.pop())
    }

    fn evidence(&self, theorem: Theorem, starts: StartSpace, what: &str) -> Status {
        let started = Instant::now();
        let claim = match self.sweep(theorem, starts) {
            Ok(claim) => claim,
            Err(e) => return Status::NotRun(e.to_string()),
        };
        let Some(claim) = claim else {
            return Status::NotRun("the sweep has no work item".into());
        };
        let verdict = match claim.verdict {
            Judgement::Holds => TierVerdict::Holds,
            Judgement::Refuted => TierVerdict::Refuted(format!(
                "{} of {} combinations of N and eps violate it",
                claim.refuted, claim.items
            )),
            Judgement::Vacuous => TierVerdict::Inconclusive("no case meets its premise".into()),
            Judgement::Undecided => {
                let why = claim.reason.unwrap_or_else(|| "no reason given".into());
                TierVerdict::Inconclusive(format!(
                    "{} of {} combinations of N and eps undecided: {why}",
                    claim.undecided, claim.items
                ))
            }
        };
        let scope = format!(
            "N = {FEWEST}..{}, eps = p/q in its range with q <= {}, k <= {}, {what}: {} cases",
            self.drones, self.denominator, self.steps, claim.counts.cases
        );
        Status::Run { verdict, scope, seconds: started.elapsed().as_secs_f64() }
    }
}

const SOURCES: &[&str] = &["spec/src", "crates/proof/src/sweep", "crates/core/src/stencil.rs"];

impl Tier for Grid {
    fn name(&self) -> &'static str {
        "grid"
    }

    fn kind(&self) -> Evidence {
        Evidence::ExhaustiveOnGrid
    }

    fn tool(&self) -> String {
        this_program()
    }

    fn sources(&self) -> &'static [&'static str] {
        SOURCES
    }

    fn status(&self, theorem: Theorem) -> Status {
        let what = format!("every start on a grid of {RESOLUTION} or more units");
        GRID.evidence(theorem, StartSpace::Grid { resolution: RESOLUTION }, &what)
    }
}

impl Tier for Complete {
    fn name(&self) -> &'static str {
        "complete"
    }

    fn kind(&self) -> Evidence {
        Evidence::CompleteForAllStarts
    }

    fn tool(&self) -> String {
        this_program()
    }

    fn sources(&self) -> &'static [&'static str] {
        SOURCES
    }

    fn status(&self, theorem: Theorem) -> Status {
        COMPLETE.evidence(theorem, StartSpace::Complete, "all real starts")
    }
}
