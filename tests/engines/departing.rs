//! Late messages, drones that wait, weights that change: what is proved for every N holds of the spec's
//! runs and of nothing wider; the critical weight of ordering from both sides.

use cordon_core::Rational;
use cordon_core::random::SplitMix;
use cordon_proof::certificate;
use cordon_proof::prove::{CLAIMS, Scope};
use cordon_proof::threshold::late::{Bracket, WORK, bracket};
use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::Form;
use cordon_spec::{Params, State};
use num_traits::Signed;

fn q(a: i64, b: i64) -> Rational {
    Rational::new(a.into(), b.into())
}

fn certificate_of(name: &str) -> String {
    let claim = CLAIMS.iter().find(|c| c.name == name).unwrap();
    let scope = Scope { form: Form::Sharp, weights: None, drones: None };
    serde_json::to_string_pretty(&claim.prove(&scope).unwrap()).unwrap()
}

/// Each certificate with something wider stated: the proof does not carry it.
#[test]
fn nothing_wider_is_certified() {
    let wider = [
        ("7.2-one-late", "eps <= 2/5", "eps <= 1/2"),
        ("7.2-one-late", "seen(k,i,j) - k + 1 >= 0", "seen(k,i,j) - k + 2 >= 0"),
        (
            "7.2-one-late",
            "(1 - 2*eps)*(x(k,i+1) - x(k,i)) >= 0",
            "(1 - eps)*(x(k,i+1) - x(k,i)) >= 0",
        ),
        ("7.2-one-late", "\"x(0,i+1) - x(0,i) > 0\"", "\"x(0,i+1) - x(0,i) > -1\""),
        ("7.2-cells-delay", "max - min - last*shift > 0", "max - min - last*shift >= 0"),
        ("7.2-cells-delay", "\"shift >= 0\"", "\"shift >= -1\""),
        ("7.8-delay", "seen(k,i,j) - k + d >= 0", "seen(k,i,j) - k + d + 1 >= 0"),
        ("7.8-delay", "k + d - m*(d+1) >= 0", "k + d + 1 - m*(d+1) >= 0"),
        ("7.8-activation", "S(i,m*B+B) - S(i,m*B) >= 1", "S(i,m*B+B) - S(i,m*B) >= 0"),
        ("7.8-activation", "\"B >= 1\"", "\"B >= 0\""),
        ("7.2-gaps-varying", "1 - 2*w(k) >= 0", "2 - 2*w(k) >= 0"),
        ("7.3-varying", "\"w(k) >= 0\"", "\"w(k) >= -1\""),
        ("7.5i-varying", "1 - 2*w(k) >= 0", "2 - 2*w(k) >= 0"),
        ("7.6ii-varying", "\"w(k) > 0\"", "\"w(k) >= 0\""),
        ("7.7-varying", "\"w(k) > 0\"", "\"w(k) >= 0\""),
        ("7.8-varying", "1 - 2*w(k) >= 0", "2 - 2*w(k) >= 0"),
        ("7.2-loss", "\"1 - 2*eps > 0\"", "\"1 - 2*eps >= 0\""),
        ("7.2-loss", "eps - a(k,i) >= 0", "2*eps - a(k,i) >= 0"),
        ("7.2-loss", "(1 - 2*eps)*(x(k,i+1)", "(1 - eps)*(x(k,i+1)"),
        ("7.2-hold", "1/2 - w(k,i) >= 0", "2/3 - w(k,i) >= 0"),
        ("7.2-hold", "\"w(k,i) >= 0\"", "\"w(k,i) >= -1\""),
        ("7.2-hold-sums", "w(k,i) + w(k,i+1) <= 1", "w(k,i) + w(k,i+1) <= 5/4"),
        ("7.2-hold-sums", "\"w(k,i) <= 1\"", "\"w(k,i) <= 2\""),
        ("7.2-hold-exact", "w(0,j) + w(0,j+1) - 1 > 0", "w(0,j) + w(0,j+1) - 1 >= 0"),
        ("7.2-loss-sums", "a(k,i+1) + b(k,i) <= 1", "a(k,i+1) + b(k,i) <= 5/4"),
        ("7.2-loss-exact", "a(0,j+1) + b(0,j) - 1 > 0", "a(0,j+1) + b(0,j) - 1 >= 0"),
        ("7.2-joining", "\"x(k+1,j(k)) < x(k,j(k))\"", "\"x(k+1,j(k)) <= x(k,j(k))\""),
        ("7.2-joining", "w(k,i) <= 1/2", "w(k,i) <= 2/3"),
        ("7.2-joining", "j(k) >= 1", "j(k) >= 0"),
        ("7.8-varying-exact", "last - 3 >= 0", "last - 2 >= 0"),
        ("7.8-varying-exact", "1/2 - S(k) + S(K) >= 0", "1 - S(k) + S(K) >= 0"),
        ("rendez-vous", "w(k,i) <= 1/2", "w(k,i) <= 2/3"),
    ];
    let mut refused = 0;
    for (name, from, to) in wider {
        let page = certificate_of(name);
        assert_eq!(cordon_check::check(&page).code(), 0, "{name}");
        assert!(page.contains(from), "{name}: {from}");
        let verdict = cordon_check::check(&page.replace(from, to));
        assert_eq!(verdict.code(), 4, "{name}: {from} -> {to}: {verdict}");
        refused += 1;
    }
    assert_eq!(refused, 32);
    // Nor for other weights.
    for name in ["7.2-one-late", "7.2-cells-delay", "7.8-delay", "7.8-activation", "7.3-varying"] {
        let claim = CLAIMS.iter().find(|c| c.name == name).unwrap();
        let weights = Some((q(0, 1), q(3, 5)));
        assert!(
            claim.prove(&Scope { form: Form::Sharp, weights, drones: None }).is_none(),
            "{name}"
        );
    }
}

/// Runs drawn from a seed, with departures of every kind, do what the certificates say of them.
#[test]
fn runs_of_the_spec_do_what_is_certified() {
    let mut random = SplitMix::new(18);
    let (mut gaps_kept, mut nearly) = (0, 0);
    for case in 0..300 {
        let count = 3 + random.below(6) as usize;
        let last = count as i64 - 1;
        let eps = [q(1, 5), q(1, 3), q(2, 5), q(1, 2)][random.below(4) as usize].clone();
        let mut cuts: Vec<i64> = (0..count - 2).map(|_| 1 + random.below(998) as i64).collect();
        cuts.sort_unstable();
        cuts.dedup();
        if cuts.len() + 2 != count {
            continue;
        }
        let ordered: Vec<Rational> =
            [0].into_iter().chain(cuts).chain([999]).map(|x| q(x, 999)).collect();
        let params = Params { min: q(0, 1), max: q(1, 1), eps: eps.clone(), n: 0 };
        let gaps =
            |x: &[Rational]| -> Vec<Rational> { x.windows(2).map(|x| &x[1] - &x[0]).collect() };
        let weight = |i: usize| q(i as i64 * (last - i as i64), 1);
        let size = |x: &[Rational]| {
            let error = |i: usize| (q(i as i64, last) - &x[i]).abs() / weight(i);
            (1..count - 1).map(error).max().unwrap()
        };
        let shrinks = |eps: &Rational| q(1, 1) - q(8, last * last) * eps;
        let state = |x: &[Rational]| State { drones: x.to_vec(), timesteps: 0 };

        // One step late: order, and each gap keeps its part; the rate, once in two steps.
        let mut run = vec![ordered.clone()];
        for t in 0..10 {
            let ages: Vec<usize> =
                (0..count * count).map(|_| random.below(2) as usize).map(|a| a.min(t)).collect();
            let seen = |i: usize, j: usize| &run[t - ages[i * count + j]][j];
            let next = exec_coverage_delayed(&params, &state(&run[t]), seen).drones;
            if eps <= q(2, 5) {
                for (new, old) in gaps(&next).iter().zip(gaps(&run[t])) {
                    assert!(new.is_positive() && *new >= (q(1, 1) - q(2, 1) * &eps) * old);
                    gaps_kept += 1;
                }
            }
            run.push(next);
            let rounds = (t as i32 + 2) / 2;
            let factor = (0..rounds).fold(q(1, 1), |f, _| f * shrinks(&eps));
            assert!(size(&run[t + 1]) <= factor * size(&ordered), "{case}, step {t}");
        }

        // Cells, however late.
        let shift = q(random.below(20) as i64, 20 * last);
        let cell = |i: usize, part: i64| q(i as i64, last) + &shift - q(part, 100 * last);
        let parts: Vec<i64> = (0..count).map(|_| random.below(100) as i64).collect();
        let inner = (1..count - 1).map(|i| cell(i, parts[i]));
        let mut run = vec![[q(0, 1)].into_iter().chain(inner).chain([q(1, 1)]).collect::<Vec<_>>()];
        for t in 0..8 {
            let ages: Vec<usize> =
                (0..count * count).map(|_| random.below(t as u64 + 1) as usize).collect();
            let seen = |i: usize, j: usize| &run[t - ages[i * count + j]][j];
            let next = exec_coverage_delayed(&params, &state(&run[t]), seen).drones;
            assert!(gaps(&next).iter().all(Signed::is_positive));
            run.push(next);
        }

        // Waiting, twice on end at most; and one weight for all, another in each step.
        let mut waits = ordered.clone();
        let mut varies = ordered.clone();
        let (least, most) = (gaps(&ordered).into_iter().min(), gaps(&ordered).into_iter().max());
        let mut rested = vec![0; count];
        let mut factor = q(1, 1);
        for t in 0..9 {
            let acts: Vec<bool> =
                (0..count).map(|i| random.below(2) == 0 || rested[i] == 2).collect();
            for (rest, act) in rested.iter_mut().zip(&acts) {
                *rest = if *act { 0 } else { *rest + 1 };
            }
            waits = exec_coverage_active(&params, &state(&waits), |i| acts[i]).drones;
            if t % 3 == 2 {
                let rounds = (0..(t + 1) / 3).fold(q(1, 1), |f, _| f * shrinks(&eps));
                assert!(size(&waits) <= rounds * size(&ordered), "{case}, step {t}");
            }
            let now = &eps * q(random.below(11) as i64, 10);
            factor *= shrinks(&now);
            let params = Params { eps: now, ..params.clone() };
            varies = exec_coverage(&params, &state(&varies)).drones;
            assert!(size(&varies) <= &factor * size(&ordered));
            for run in [&waits, &varies] {
                assert!(
                    gaps(run).into_iter().min() >= least && gaps(run).into_iter().max() <= most
                );
                nearly +=
                    u32::from(gaps(run).into_iter().min() < least.as_ref().map(|g| g * q(3, 2)));
            }
        }
    }
    assert!(gaps_kept > 5_000 && nearly > 500, "{gaps_kept} {nearly}");
}

fn checked(found: &Bracket) {
    let kept = found.kept.as_ref().unwrap();
    assert!(kept.eps < found.lost.eps);
    assert_eq!(cordon_check::check(&kept.certificate.to_string()).code(), 0);
    let above = certificate::refutation(&found.lost);
    assert_eq!(cordon_check::check(&above.to_string()).code(), 0);
}

/// A part of the table in the guide.
#[test]
fn the_critical_weight_with_late_messages_is_bracketed_from_both_sides() {
    let mut cells = 0;
    for (count, longest, critical) in
        [(3, 1, q(1, 1)), (3, 3, q(1, 1)), (4, 1, q(1, 2)), (4, 2, q(1, 2)), (5, 1, q(1, 2))]
    {
        let found = bracket(count, longest, 2, WORK).unwrap().unwrap();
        checked(&found);
        assert!(found.is_exact && found.open.is_none(), "{count} {longest}");
        assert_eq!(found.kept.unwrap().eps, critical);
        assert_eq!((found.lost.step, &found.lost.eps - critical), (1, q(1, 100)));
        cells += 1;
    }
    assert_eq!(cells, 5);
}

/// Where no proof is found within so much work, the search ends and says so; the crossing needs none.
#[test]
fn the_search_is_bounded_and_says_what_ended_it() {
    let found = bracket(6, 2, 2, 20_000).unwrap().unwrap();
    let (_, end) = found.open.as_ref().unwrap();
    assert!(end.contains("more work than the search allows"), "{end}");
    assert!(!found.is_exact);
    assert_eq!((found.lost.eps.clone(), found.lost.step), (q(31, 100), 3));
    let above = certificate::refutation(&found.lost);
    assert_eq!(cordon_check::check(&above.to_string()).code(), 0);
}
