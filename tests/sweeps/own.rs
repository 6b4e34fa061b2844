//! Random protocols, many of them.
use crate::own_random;

#[test]
fn a_thousand_protocols_are_decided_as_they_run() {
    own_random::agree(1_000);
}

#[test]
fn brackets_of_random_protocols_hold_on_both_sides() {
    own_random::brackets_hold(80);
}
