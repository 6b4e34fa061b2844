//! The sweep of theorem 7.2 as a model of the explicit-state checker Stateright, for comparison
//! with `cargo bench --bench sweep`: the same work as its row `7.2 N=5 eps=1/3 k<=30, 64 bits`.
//!
//! A state is a placement as integers over 3^k; the initial states are the strictly ordered
//! starts on 36 grid units (of mirror images the smaller); the one action is a protocol step.
//! The property is asked of every state. `cargo run --release` prints the rate on one thread.

use std::time::Instant;

use stateright::{Checker, Model, Property};

const N: usize = 5;
const LENGTH: i64 = 36;
const STEPS: u8 = 30;
const P: i64 = 1;
const Q: i64 = 3;

#[derive(Clone, Debug, Hash, PartialEq, Eq)]
struct Placement {
    step: u8,
    x: [i64; N],
}

struct Sweep;

impl Model for Sweep {
    type State = Placement;
    type Action = ();

    fn init_states(&self) -> Vec<Placement> {
        let mut starts = Vec::new();
        for a in 1..LENGTH {
            for b in a + 1..LENGTH {
                for c in b + 1..LENGTH {
                    let x = [0, a, b, c, LENGTH];
                    let mirror = [0, LENGTH - c, LENGTH - b, LENGTH - a, LENGTH];
                    if x <= mirror {
                        starts.push(Placement { step: 0, x });
                    }
                }
            }
        }
        starts
    }

    fn actions(&self, state: &Placement, actions: &mut Vec<()>) {
        if state.step < STEPS {
            actions.push(());
        }
    }

    fn next_state(&self, last: &Placement, (): ()) -> Option<Placement> {
        let x = &last.x;
        let mut next = x.map(|x| Q * x);
        for i in 1..N - 1 {
            next[i] = P * x[i - 1] + (Q - 2 * P) * x[i] + P * x[i + 1];
        }
        Some(Placement { step: last.step + 1, x: next })
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![Property::always("ordered", |_, s: &Placement| s.x.is_sorted_by(|a, b| a < b))]
    }
}

fn main() {
    let began = Instant::now();
    let checker = Sweep.checker().threads(1).spawn_bfs().join();
    let seconds = began.elapsed().as_secs_f64();
    checker.assert_properties();
    let starts = Sweep.init_states().len();
    let states = checker.unique_state_count();
    assert_eq!(states, starts * (usize::from(STEPS) + 1));
    let updates = (states - starts) * N;
    println!(
        "{starts} starts, {states} states, {updates} drone updates in {seconds:.3} s: {:.2} million a second",
        updates as f64 / seconds / 1e6
    );
}
