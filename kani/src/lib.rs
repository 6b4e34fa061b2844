//! Harnesses of the spec: what the model checker Kani proves of the very code that Cordon's
//! engines execute, bit by bit and within stated bounds.
//!
//! A harness has one body. It draws its values from a [`Source`](source::Source) and has three
//! users: Kani, for which every value is possible at once (`cargo kani`); `cargo test`, which
//! tries every combination of small values and many random ones of the full size; and a fuzzer
//! (`fuzz/`). What is assumed of a drawn state and what is asserted after a step are the theorem
//! predicates of the spec; nothing here states the protocol or a theorem once more.
//!
//! * [`harness`]: what a harness is, [`harnesses`]: all of them.
//! * [`bounds`]: how much they cover, with the reasons. [`source`]: where values come from.
//! * [`fraction`]: the exact scalar that they compute with. [`residue`]: a small ring. [`mod@line`]: a
//!   drawn swarm.
//!
//! How to run them, and what was run: `README.md` in this folder.

pub mod bodies;
pub mod bounds;
pub mod contracts;
pub mod fraction;
pub mod harness;
pub mod harnesses;
pub mod line;
pub mod residue;
pub mod source;

pub use harness::{Expected, Harness};
pub use harnesses::all;
