//! Co-simulations and their units in the formats of other tools: FMI archives, and FMUs of other tools
//! in the place of units ([`fmi`]); INTO-CPS multi-models and SSP systems ([`interchange`]).

pub mod fmi;
pub mod interchange;
