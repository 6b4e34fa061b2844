//! The tick counter (Listing 4): an update every n + 1 ticks, nothing between.
//!
//! Positions and weight are integers modulo 4 here, every one of them: the counter reads
//! neither, and the update is a polynomial that any ring executes.

use cordon_spec::coverage::{exec_coverage, kth_step, tick};
use cordon_spec::{Params, Phase, State};

use crate::harness::{covering, harnesses};
use crate::line::same;
use crate::residue::Residue;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] =
    &["coverage::kth_step", "coverage::tick", "state::State::initial", "state::State::tick_with"];

/// Two bits: several updates in a row multiply as often.
type Ring = Residue<2>;
/// The counter limits whose whole periods are walked through: periods 1 to 4.
const LIMITS: Domain = Domain::whole(0, 3);
/// Ticks walked through: two periods of the largest limit, and one more.
const TICKS: u32 = 9;
/// Ticks of a `kth_step`, whose loop the model checker unrolls as often.
const STEPS: Domain = Domain::whole(0, 5);

/// Three drones and a weight.
fn draw<S: Source>(source: &mut S, n: u32) -> (Params<Ring>, [Ring; 3]) {
    let drones = core::array::from_fn(|_| Ring::draw(source));
    let eps = Ring::draw(source);
    (Params { min: drones[0], max: drones[2], eps, n }, drones)
}

/// Which tick of a run the first update is in.
fn phase<S: Source>(source: &mut S) -> Phase {
    if source.flag() { Phase::First } else { Phase::Last }
}

/// One tick, whatever n and the counter in 0 ..= n: the counter stays in range, the drones move
/// exactly when it was n, and then as in a protocol step. Witness: they stay, at a counter that
/// a byte does not hold.
fn ticks_once<S: Source>(source: &mut S) -> Case {
    let (n, timesteps) = (source.word(), source.word());
    source.assume(timesteps <= n)?;
    let (p, drones) = draw(source, n);
    let before = State { drones, timesteps };
    let after = tick(&p, before.clone());
    assert!(after.timesteps <= n, "the counter stays in range");
    if timesteps == n {
        assert!(after.timesteps == 0, "after an update the counter is 0");
        assert!(same(&after.drones, &exec_coverage(&p, &before).drones), "the update is a step");
    } else {
        assert!(after.timesteps == timesteps + 1, "between updates the counter goes up by one");
        assert!(same(&after.drones, &drones), "between updates nothing moves");
    }
    Some(Witness(timesteps < n && n > 255))
}

/// The updates fall in the ticks that the phase says, n + 1 apart, and the drones are where as
/// many steps take them. Witness: at least two updates, with ticks between.
fn is_periodic<S: Source>(source: &mut S) -> Case {
    let n = source.integer(LIMITS).unsigned_abs();
    let phase = phase(source);
    let (p, drones) = draw(source, n);
    let mut state = State::initial(drones, n, phase);
    let mut placement = drones;
    let mut updates = 0;
    for t in 1..=TICKS {
        state = tick(&p, state);
        // In tick 1, n + 2, .. or in tick n + 1, 2 (n + 1), ..
        let update = match phase {
            Phase::First => (t - 1) % (n + 1) == 0,
            Phase::Last => t % (n + 1) == 0,
        };
        if update {
            updates += 1;
            placement = exec_coverage(&p, &State { drones: placement, timesteps: 0 }).drones;
        }
        assert!(
            same(&state.drones, &placement),
            "a step in the ticks of the phase, no motion between"
        );
        assert!((state.timesteps == 0) == update, "the counter is 0 after an update only");
    }
    Some(Witness(updates >= 2 && n > 0))
}

/// `kth_step` is so many ticks. Witness: some, and a motion.
fn iterates<S: Source>(source: &mut S) -> Case {
    let k = source.integer(STEPS).unsigned_abs();
    let n = source.integer(LIMITS).unsigned_abs();
    let phase = phase(source);
    let (p, drones) = draw(source, n);
    let initial = State::initial(drones, n, phase);
    let mut state = initial.clone();
    for t in 0..5 {
        if t < k {
            state = tick(&p, state);
        }
    }
    let found = kth_step(&p, initial, u64::from(k));
    assert!(same(&found.drones, &state.drones), "the drones after k ticks");
    assert!(found.timesteps == state.timesteps, "the counter after k ticks");
    Some(Witness(!same(&state.drones, &drones)))
}

/// The counter starts where the phase says, within its range. Witness: at neither end of it.
fn starts<S: Source>(source: &mut S) -> Case {
    let n = source.word();
    let first = State::initial((), n, Phase::First);
    let last = State::initial((), n, Phase::Last);
    assert!(first.timesteps == n && last.timesteps == 0, "n or 0");
    assert!(Phase::default() == Phase::First, "the first tick is the default");
    Some(Witness(first.timesteps != last.timesteps))
}

harnesses! {
    functions FUNCTIONS;
    /// A tick keeps the counter in range and moves the drones when it is n, never else.
    one_tick("ticks", unwind 5): covering!("every n and every counter up to it, N = 3")
        => |s| ticks_once(s);
    /// The period is n + 1 ticks in both phases, and nothing moves between updates.
    period("ticks", unwind 10): covering!("n in {LIMITS}, both phases, {TICKS} ticks, N = 3")
        => |s| is_periodic(s);
    /// kth_step(k) is tick, k times.
    iterated("ticks", unwind 7): covering!("k in {STEPS}, n in {LIMITS}, both phases, N = 3")
        => |s| iterates(s);
    /// The counter starts at n or at 0.
    initial("ticks", unwind 2): covering!("every n") => |s| starts(s);
}
