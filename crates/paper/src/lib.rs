//! What is about the paper itself: its errata and its figures.

pub mod errata;
pub mod figures;
