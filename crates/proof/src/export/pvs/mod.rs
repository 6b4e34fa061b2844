//! The protocol as PVS, for the paper's readers.
//!
//! PVS is a specification language of its own, so this is a mirror, not an execution: the
//! definitions are templates beside this file, close to the paper's listings; hypotheses and
//! comments are generated from the spec's data (`theorems.rs`), and a scenario's theory carries
//! positions that the spec computed (`scenario.rs`), for PVSio to replay.
//!
//! CI has no PVS. Tried by hand with PVS 8.0 (built from its sources at commit `becb0153` under
//! SBCL 2.2.9, without its network server) for the default scenario: all files type-check, PVS
//! proves every TCC by itself, and PVSio answers TRUE to `replays;`. The theorems are statements
//! there; their proofs are elsewhere in this repository. PVS 7 was not tried.

mod scenario;
mod theorems;

pub use scenario::Instance;

/// A file of the export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The name of the file, `coverage.pvs` and so on.
    pub name: &'static str,
    /// The theory that it holds.
    pub text: String,
}

/// The global theory (with theorems) and the local theory, both general, and the theory of one
/// scenario.
pub fn files(instance: &Instance) -> Vec<File> {
    let global = format!("{}{}", include_str!("coverage.pvs"), theorems::theory());
    vec![
        File { name: "coverage.pvs", text: global },
        File { name: "fmu_coverage.pvs", text: include_str!("fmu_coverage.pvs").to_owned() },
        File { name: "scenario.pvs", text: instance.theory() },
    ]
}
