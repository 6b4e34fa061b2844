//! Linear mathematics that several engines need: the step in errors and gaps, forms as scalars
//! of the spec, simple fractions, Perron vectors.

pub mod affine;
pub mod definite;
pub mod enclosure;
pub mod feasible;
pub mod matrix;
pub mod perron;
pub mod rows;
pub mod simplest;
