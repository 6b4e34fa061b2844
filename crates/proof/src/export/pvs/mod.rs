//! The protocol as PVS, for the paper's readers.
//!
//! PVS is a specification language of its own, so this is a mirror, not an execution: the
//! theories are files beside this one, close to the paper's listings, with the theorems and
//! their proofs, which are general. Generated are the words about each theorem (`theorems.rs`),
//! the proof files (`proofs.rs`), and the theory of one scenario, which carries positions that
//! the spec computed, for PVSio to replay (`scenario.rs`). A protocol of one's own has a theory of its own
//! (`own.rs`).
//!
//! CI has no PVS. What was replayed, and how, is said in `proofs/pvs`.

mod own;
mod proofs;
mod scenario;
mod theorems;

pub use own::own;
pub use scenario::Instance;

/// A file of the export, with the proofs of its formulas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name without ending: `coverage` of `coverage.pvs` and `coverage.prf`.
    pub name: &'static str,
    /// The theories that it holds.
    pub theories: String,
    /// The text of the proof file.
    pub proofs: String,
}

/// The general theories, of the global protocol, the local one, consensus and formation, and
/// the theory of one scenario.
pub fn files(instance: &Instance) -> Vec<File> {
    let theorems = theorems::with_words(include_str!("theories/coverage_theorems.pvs"));
    let files = [
        ("coverage", include_str!("theories/coverage.pvs").to_owned()),
        ("coverage_theorems", theorems),
        ("fmu_coverage", include_str!("theories/fmu_coverage.pvs").to_owned()),
        ("consensus", include_str!("theories/consensus.pvs").to_owned()),
        ("scenario", instance.theory()),
    ];
    let with_proofs =
        |(name, theories): (_, String)| File { name, proofs: proofs::proofs(&theories), theories };
    files.into_iter().map(with_proofs).collect()
}
