//! Linear mathematics that several engines need: forms as scalars of the
//! spec, simple fractions, Perron vectors.

pub mod affine;
pub mod enclosure;
pub mod errors;
pub mod feasible;
pub mod perron;
pub mod simplest;
