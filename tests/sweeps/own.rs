//! Random protocols, many of them.
use crate::own_random;

#[test]
fn a_thousand_protocols_are_decided_as_they_run() {
    own_random::agree(1_000);
}
