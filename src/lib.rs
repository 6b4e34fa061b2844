//! Cordon: a verification toolkit for a drone coverage protocol with one executable spec.

pub use cordon_core::{Error, Outcome, Rational, Result, exact, linear, scalar, simplex, stencil};
pub use cordon_cosim as cosim;
pub use cordon_cosim::{fmi, interchange, replay};
pub use cordon_paper::{errata, figures};
pub use cordon_proof::{
    certificate, counterexample, export, own_protocol, prove, refute, settle, sweep, threshold,
};
pub use cordon_run::{fast, projection, scenario, simulate, swarm, trace};
pub use cordon_spec as spec;
