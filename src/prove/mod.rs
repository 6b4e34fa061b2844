//! Proofs: the untrusted search for certificates. What it finds counts only once the
//! independent checker (`cordon-check`) has accepted it.

pub mod simplex;
