//! The local form (Listings 5 and 6), and the projection theorem: N local machines that exchange
//! their positions compute the global protocol. Integers modulo 16: see `ticks.rs`.

use core::num::NonZeroU32;

use cordon_spec::coverage::{exec_cvg, tick};
use cordon_spec::local::{
    LocalParams, LocalState, SimState, TickRatio, exchange, fmu_exec_cvg, fmu_kth_step, fmu_tick,
    project, swarm_tick,
};
use cordon_spec::{Params, State};

use crate::harness::{covering, harnesses};
use crate::line::same;
use crate::residue::Residue;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "local::TickRatio::counter_limit",
    "local::TickRatio::reached_by",
    "local::TickRatio::whole",
    "local::exchange",
    "local::fmu_exec_cvg",
    "local::fmu_kth_step",
    "local::fmu_tick",
    "local::project",
    "local::swarm_tick",
];

type Ring = Residue<4>;
/// Counter limits: period 1, 2 and 3.
const LIMITS: Domain = Domain::whole(0, 2);
/// The quotient eps/stepsize in the ratio's own harness: products and quotients of free numbers
/// are dear to the solver, so 6 bits each.
const NUMERATORS: Domain = Domain::new(0, 63, 20);
const DENOMINATORS: Domain = Domain::new(1, 63, 7);
const COUNTERS: Domain = Domain::new(0, 63, 21);

fn denominator(n: u32) -> NonZeroU32 {
    // Drawn from 1 on.
    NonZeroU32::new(n).unwrap_or(NonZeroU32::MIN)
}

/// From any counter and placement: after each of T ticks with the exchange after it, machine i
/// is the projection of the global state. Witness: a drone has moved.
fn projection<const N: usize, const T: usize, S: Source>(source: &mut S) -> Case {
    let n = source.integer(LIMITS).unsigned_abs();
    let timesteps = source.integer(LIMITS).unsigned_abs();
    source.assume(timesteps <= n)?;
    let drones: [Ring; N] = core::array::from_fn(|_| Ring::draw(source));
    let eps = Ring::draw(source);
    // The ends of the segment are where no drone need be: the machines know them by themselves.
    let (min, max) = (Ring::draw(source), Ring::draw(source));
    let p = Params { min, max, eps, n };
    // Any quotient that rounds up to n.
    let den = source.integer(Domain::whole(1, 2)).unsigned_abs();
    let below = source.integer(Domain::whole(0, 1)).unsigned_abs();
    source.assume(below < den && below <= n * den)?;
    let ratio = TickRatio { num: n * den - below, den: denominator(den) };
    let local = LocalParams { protocol: p.clone(), count: N, ratio };
    let mut state = State { drones, timesteps };
    let mut machines: [SimState<Ring>; N] = core::array::from_fn(|i| project(&p, &state, i));
    for _ in 0..T {
        state = tick(&p, state);
        machines = swarm_tick(&local, &machines);
        for (i, machine) in machines.iter().enumerate() {
            let expected = project(&p, &state, i);
            let SimState { timesteps, st: LocalState { prec, own, foll, id } } = machine;
            assert!(*id == i && *timesteps == expected.timesteps, "identifier and counter");
            assert!(*own == state.drones[i], "the own position is the global one");
            // What a drone does not have it never receives.
            assert!(i == 0 || *prec == expected.st.prec, "the neighbour's position");
            assert!(i + 1 == N || *foll == expected.st.foll, "the neighbour's position");
        }
    }
    Some(Witness(!same(&state.drones, &drones)))
}

/// `reached_by` compares with the exact quotient, which `counter_limit` rounds up. Witness: the
/// quotient is no integer.
fn rounds_up<S: Source>(source: &mut S) -> Case {
    let num = source.integer(NUMERATORS).unsigned_abs();
    let den = source.integer(DENOMINATORS).unsigned_abs();
    let counter = source.integer(COUNTERS).unsigned_abs();
    let ratio = TickRatio { num, den: denominator(den) };
    let reached = ratio.reached_by(counter);
    assert!(reached == (counter * den >= num), "at least the quotient");
    assert!(reached == (counter >= ratio.counter_limit()), "the limit is the quotient rounded up");
    let whole = TickRatio::whole(num);
    assert!(whole.counter_limit() == num && whole.den.get() == 1, "a whole quotient is itself");
    Some(Witness(!num.is_multiple_of(den)))
}

/// The comparison never overflows: any words. A whole quotient is reached when the counter is as
/// large, and every quotient in the end. Witness: a product beyond 32 bits.
fn never_overflows<S: Source>(source: &mut S) -> Case {
    let (num, den, counter) = (source.word(), source.word(), source.word());
    source.assume(den > 0)?;
    let ratio = TickRatio { num, den: denominator(den) };
    let reached = ratio.reached_by(counter);
    assert!(ratio.reached_by(u32::MAX), "reached in the end");
    assert!(ratio.reached_by(0) == (num == 0), "at once if it is 0");
    assert!(TickRatio::whole(num).reached_by(counter) == (counter >= num), "a whole quotient");
    Some(Witness(reached && counter > 65_536 && den > 65_536))
}

/// One machine: identifier and neighbours stay, the counter stays in range, and the position
/// changes by the global formula exactly when the quotient is reached. Witness: it does.
fn one_machine<S: Source>(source: &mut S) -> Case {
    let count = source.integer(Domain::whole(1, 6)).unsigned_abs() as usize;
    let id = source.integer(Domain::whole(0, 5)).unsigned_abs() as usize;
    source.assume(id < count)?;
    let [prec, own, foll, min, max, eps]: [Ring; 6] = core::array::from_fn(|_| Ring::draw(source));
    let limit = source.word();
    let timesteps = source.word();
    source.assume(timesteps <= limit)?;
    let protocol = Params { min, max, eps, n: 0 };
    let p = LocalParams { protocol, count, ratio: TickRatio::whole(limit) };
    let before = SimState { timesteps, st: LocalState { prec, own, foll, id } };
    let after = fmu_tick(&p, before.clone());
    let (xp, xf) = (if id > 0 { prec } else { min }, if id + 1 < count { foll } else { max });
    let moved = exec_cvg(&p.protocol, count, &xp, &own, &xf, id);
    assert!(fmu_exec_cvg(&p, &xp, &own, &xf, id) == moved, "the same formula");
    let update = timesteps == limit;
    let expected = if update { moved } else { own };
    let kept = LocalState { own: expected, ..before.st.clone() };
    assert!(after.st == kept, "only the own position changes, and when the quotient is reached");
    assert!(after.timesteps == if update { 0 } else { timesteps + 1 }, "the counter");
    assert!(after.timesteps <= limit, "the counter stays in range");
    let thrice = fmu_kth_step(&p, before.clone(), 3);
    let by_hand = fmu_tick(&p, fmu_tick(&p, after));
    assert!(thrice == by_hand, "k ticks");
    assert!(fmu_kth_step(&p, before.clone(), 0) == before, "no tick");
    Some(Witness(expected != own))
}

/// An exchange hands on what the neighbours have and changes nothing else. Witness: something
/// new was received.
fn handed_on<const N: usize, S: Source>(source: &mut S) -> Case {
    let before: [SimState<Ring>; N] = core::array::from_fn(|id| {
        let [prec, own, foll]: [Ring; 3] = core::array::from_fn(|_| Ring::draw(source));
        let timesteps = source.integer(LIMITS).unsigned_abs();
        SimState { timesteps, st: LocalState { prec, own, foll, id } }
    });
    let after = exchange(&before);
    for i in 0..N {
        let prec = if i > 0 { before[i - 1].st.own } else { before[i].st.prec };
        let foll = if i + 1 < N { before[i + 1].st.own } else { before[i].st.foll };
        let st = LocalState { prec, own: before[i].st.own, foll, id: i };
        assert!(after[i] == SimState { timesteps: before[i].timesteps, st }, "as received");
    }
    Some(Witness(after != before))
}

harnesses! {
    functions FUNCTIONS;
    /// Three local machines are the global protocol, tick by tick.
    projection_3("projection", unwind 5): covering!("N = 3, four ticks, n in {LIMITS}, any counter and ends")
        => |s| projection::<3, 4, _>(s);
    /// Four local machines are the global protocol, tick by tick.
    projection_4("projection", unwind 5): covering!("N = 4, three ticks, n in {LIMITS}, any counter and ends")
        => |s| projection::<4, 3, _>(s);
    /// Five local machines are the global protocol, tick by tick.
    projection_5("projection", unwind 6): covering!("N = 5, two ticks, n in {LIMITS}, any counter and ends")
        => |s| projection::<5, 2, _>(s);
    /// A counter has reached a quotient when it has reached the quotient rounded up.
    ratio("projection", unwind 2): covering!("{NUMERATORS} over {DENOMINATORS}, counter {COUNTERS}")
        => |s| rounds_up(s);
    /// The comparison with the quotient never overflows.
    ratio_wide("projection", unwind 2): covering!("all words") => |s| never_overflows(s);
    /// A tick of one machine, whatever it has received.
    machine("projection", unwind 8): covering!("N in 1..=6, every drone, every quotient and counter")
        => |s| one_machine(s);
    /// An exchange hands on the neighbours' positions and nothing else.
    handed_on_4("projection", unwind 6): covering!("N = 4") => |s| handed_on::<4, _>(s);
}
