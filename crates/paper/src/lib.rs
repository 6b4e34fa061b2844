//! The paper itself: its errata and its figures.

pub mod errata;
pub mod figures;
