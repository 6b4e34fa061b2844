//! Ticks, phases and periods (PROTOCOL section 1).
use std::num::NonZeroU32;

use crate::placements::{params_for, placements, q, qs};
use cordon_spec::coverage::kth_step;
use cordon_spec::local::{LocalParams, TickRatio, fmu_kth_step, fmu_tick, project};
use cordon_spec::{Phase, State};

const LONGEST: u32 = 7;
const TICKS: u64 = 40;

/// Every n, both phases: the update falls in the first tick or in tick n+1, then every n+1
/// ticks; between updates nothing moves, and the counter stays in 0..=n.
#[test]
fn updates_fall_where_phase_and_period_say() {
    let start = qs("0,10,20,30,100");
    let placed = placements(&params_for(q("1/5"), &start), start.clone(), TICKS as usize);
    let mut checked = 0;
    for n in 0..=LONGEST {
        for phase in [Phase::First, Phase::Last] {
            let mut p = params_for(q("1/5"), &start);
            p.n = n;
            let period = u64::from(n) + 1;
            let first = if phase == Phase::First { 1 } else { period };
            for k in 0..=TICKS {
                let s = kth_step(&p, State::initial(start.clone(), n, phase), k);
                let updates = if k < first { 0 } else { (k - first) / period + 1 };
                assert_eq!(s.drones, placed[updates as usize], "n {n} {phase:?} tick {k}");
                assert!(s.timesteps <= n);
                checked += 1;
            }
        }
    }
    assert_eq!(checked, u64::from(LONGEST + 1) * 2 * (TICKS + 1));
}

#[test]
fn a_tick_outside_the_counters_range_overflows_nothing() {
    let start = qs("0,1,2");
    let p = params_for(q("1/2"), &start);
    let beyond = State { drones: start, timesteps: u32::MAX };
    let after = kth_step(&p, beyond.clone(), 3);
    assert_eq!(after, beyond);
}

/// Listing 6 counts against a quotient with `>=`: it rounds up.
#[test]
fn local_machines_round_the_quotient_up() {
    let mut checked = 0;
    for num in 0..=12u32 {
        for den in 1..=5u32 {
            let ratio = TickRatio { num, den: NonZeroU32::new(den).unwrap() };
            let limit = ratio.counter_limit();
            assert_eq!(limit, num / den + u32::from(num % den != 0));
            for t in 0..=14 {
                assert_eq!(ratio.reached_by(t), t >= limit, "{num}/{den} at {t}");
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 13 * 5 * 15);
    let widest = TickRatio { num: u32::MAX, den: NonZeroU32::MIN };
    assert!(widest.reached_by(u32::MAX) && !widest.reached_by(u32::MAX - 1));
}

/// Without exchange a local machine keeps seeing its neighbours where they were.
#[test]
fn a_lonely_machine_converges_to_the_middle_of_what_it_saw() {
    let start = qs("0,10,40,100");
    let p = params_for(q("1/4"), &start);
    let s = State { drones: start, timesteps: 0 };
    let local = LocalParams { protocol: p.clone(), count: 4, ratio: TickRatio::whole(0) };
    let machine = project(&p, &s, 1);
    let after = fmu_kth_step(&local, machine.clone(), 2);
    assert_eq!(after, fmu_tick(&local, fmu_tick(&local, machine)));
    // 10 -> 15 -> 17.5, towards (0 + 40)/2.
    assert_eq!(after.st.own, q("35/2"));
    assert_eq!((after.st.prec, after.st.foll), (q("0"), q("40")));
}
