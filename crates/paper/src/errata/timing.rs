//! Errors about periods, phases and numbering.

use cordon_spec::coverage::{exec_cvg, tick};
use cordon_spec::local::{LocalParams, TickRatio, fmu_tick, project};
use cordon_spec::{Params, Phase, Scalar, State};

use super::runs::paper_start;
use super::{Erratum, Recomputed, recomputed};
use cordon_core::exact::Rational;

pub(super) const ERRATA: &[Erratum] = &[
    Erratum {
        number: 1,
        place: "section 5.3, Listings 4 and 6",
        printed: "every n timesteps the new desired position is computed",
        compute: period_of_the_listings,
    },
    Erratum {
        number: 2,
        place: "section 6, Fig. 8",
        printed: "after 3 eps seconds (0.3 s), with eps = 0.2",
        compute: three_periods,
    },
    Erratum {
        number: 3,
        place: "section 6, Fig. 11",
        printed: "eps = 0.7: recomputed every 12 co-simulation steps",
        compute: period_of_seven_tenths,
    },
    Erratum {
        number: 16,
        place: "equation 10 and section 7",
        printed: "drones 1..N in equation 10, 0..N-1 in section 7",
        compute: numbering,
    },
];

fn tenths(n: i32) -> Rational {
    Rational::new(n.into(), 10.into())
}

fn paper_params(eps: Rational, n: u32) -> Params<Rational> {
    Params { min: Rational::from_int(0), max: Rational::from_int(100), eps, n }
}

/// The ticks in which an update happens, detected by the counter's return to 0, for `n` = 4 and a
/// counter that starts at 0 as in Listing 4.
fn period_of_the_listings() -> Recomputed {
    const N: u32 = 4;
    const TICKS: u64 = 16;
    let params = paper_params(tenths(2), N);
    let mut global = State::initial(paper_start(), N, Phase::Last);
    let mut local = project(&params, &global, 1);
    let local_params =
        LocalParams { count: paper_start().len(), ratio: TickRatio::whole(N), protocol: params };
    let (mut global_updates, mut local_updates) = (Vec::new(), Vec::new());
    for t in 1..=TICKS {
        global = tick(&local_params.protocol, global);
        local = fmu_tick(&local_params, local);
        if global.timesteps == 0 {
            global_updates.push(t);
        }
        if local.timesteps == 0 {
            local_updates.push(t);
        }
    }
    let period = |updates: &[u64]| match updates {
        [a, b, ..] => b - a,
        _ => 0,
    };
    let n = u64::from(N);
    recomputed(
        period(&global_updates) != n && period(&local_updates) != n,
        format!(
            "with n = {n} Listing 4 updates in ticks {global_updates:?} and Listing 6 in ticks {local_updates:?}: every {} ticks",
            period(&global_updates)
        ),
    )
}

fn three_periods() -> Recomputed {
    let seconds = Rational::from_int(3) * tenths(2);
    recomputed(seconds != tenths(3), format!("3 * 0.2 s = {seconds} s"))
}

fn period_of_seven_tenths() -> Recomputed {
    let ticks = tenths(7) / Rational::new(1.into(), 20.into());
    recomputed(ticks != Rational::from_int(12), format!("0.7 s / 0.05 s = {ticks} steps"))
}

/// With indices 0..N-1 the drones that stay are 0 and N-1; index N in equation 10 is neither of them,
/// and index 0 is missing from it.
fn numbering() -> Recomputed {
    let params = paper_params(tenths(2), 0);
    let count = paper_start().len();
    let fixed: Vec<usize> = (0..=count)
        .filter(|&i| {
            let [a, b, c] = [30, 41, 50].map(Rational::from_int);
            let x = exec_cvg(&params, count, &a, &b, &c, i);
            x == params.min || x == params.max
        })
        .collect();
    recomputed(
        !fixed.contains(&count),
        format!(
            "for N = {count} Listing 4 keeps the drones {fixed:?} in place, equation 10 the drones 1 and {count}"
        ),
    )
}
