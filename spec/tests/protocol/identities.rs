//! Identities of the protocol, on generated starts and weights (sampled).
use crate::placements::{for_cases, params_for, placements, q, rational, start, weight};
use cordon_core::Rational;
use cordon_core::scalar::{Modulus, Polynomial};
use cordon_spec::activation::exec_coverage_active;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::{exec_coverage, getx, kth_step};
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::formation::exec_formation;
use cordon_spec::graph::{Edges, Graph, Path};
use cordon_spec::local::{LocalParams, TickRatio, project, swarm_tick};
use cordon_spec::placement::{gap, scaled_error, sum};
use cordon_spec::theorems::telescoping_residual;
use cordon_spec::{DroneMap, Phase, Scalar, State};
use num_traits::{One, Zero};
use proptest::prelude::*;

const CASES: u32 = 400;

/// Weights beyond [0, 1] too: identities hold for every weight.
fn any_weight() -> impl Strategy<Value = Rational> {
    rational()
}

fn step(eps: &Rational, x: &[Rational]) -> Vec<Rational> {
    placements(&params_for(eps.clone(), x), x.to_vec(), 1).pop().unwrap()
}

#[test]
fn the_sum_telescopes() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        prop_assert!(telescoping_residual(&eps, &x, &step(&eps, &x)).is_zero());
        Ok(())
    });
}

#[test]
fn gaps_obey_their_recurrence() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let after = step(&eps, &x);
        let (one, two) = (q("1"), q("2"));
        let last = x.len() - 2;
        let g = |i: usize| gap(&x, i);
        for i in 0..=last {
            let expected = match (i == 0, i == last) {
                (true, false) => (&one - &eps) * g(0) + &eps * g(1),
                (false, true) => (&one - &eps) * g(last) + &eps * g(last - 1),
                _ => &eps * g(i - 1) + (&one - &two * &eps) * g(i) + &eps * g(i + 1),
            };
            prop_assert_eq!(gap(&after, i), expected);
        }
        Ok(())
    });
}

#[test]
fn errors_obey_the_homogeneous_protocol() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let error = |x: &[Rational]| -> Vec<Rational> {
            (0..x.len()).map(|i| scaled_error(&x[0], &x[x.len() - 1], x, i)).collect()
        };
        // The errors are zero at the ends, so they move like positions on the segment [0, 0].
        let e = error(&x);
        prop_assert!(e[0].is_zero() && e[e.len() - 1].is_zero());
        prop_assert_eq!(error(&step(&eps, &x)), step(&eps, &e));
        Ok(())
    });
}

#[test]
fn affine_maps_commute_with_a_step() {
    for_cases(CASES, (any_weight(), start(), rational(), rational()), |(eps, x, a, b)| {
        let map = |x: &[Rational]| -> Vec<Rational> { x.iter().map(|xi| &a * xi + &b).collect() };
        prop_assert_eq!(map(&step(&eps, &x)), step(&eps, &map(&x)));
        Ok(())
    });
}

#[test]
fn the_mirror_image_commutes_with_a_step() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let mirror = |x: &[Rational]| -> Vec<Rational> { x.iter().rev().map(|xi| -xi).collect() };
        prop_assert_eq!(mirror(&step(&eps, &x)), step(&eps, &mirror(&x)));
        Ok(())
    });
}

#[test]
fn a_step_with_everyone_active_or_fresh_is_a_step() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let p = params_for(eps, &x);
        let s = State { drones: x, timesteps: 0 };
        let whole = exec_coverage(&p, &s);
        prop_assert_eq!(&exec_coverage_active(&p, &s, |_| true), &whole);
        prop_assert_eq!(&exec_coverage_delayed(&p, &s, |_, j| getx(&s, j)), &whole);
        prop_assert_eq!(&exec_coverage_active(&p, &s, |_| false), &s);
        // A single active drone moves as in the whole step, the others stay.
        for i in 0..s.drones.len() {
            let one = exec_coverage_active(&p, &s, |j| j == i);
            for j in 0..s.drones.len() {
                let expected = if i == j { getx(&whole, j) } else { getx(&s, j) };
                prop_assert_eq!(getx(&one, j), expected);
            }
        }
        Ok(())
    });
}

#[test]
fn stale_messages_change_what_neighbours_see_only() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let p = params_for(eps.clone(), &x);
        let old = State { drones: x, timesteps: 0 };
        let now = exec_coverage(&p, &old);
        let next = exec_coverage_delayed(&p, &now, |_, j| getx(&old, j));
        for i in 1..now.drones.len() - 1 {
            let own = (q("1") - q("2") * &eps) * getx(&now, i);
            let seen = &eps * (getx(&old, i - 1) + getx(&old, i + 1));
            prop_assert_eq!(getx(&next, i), &(own + seen));
        }
        Ok(())
    });
}

#[test]
fn local_machines_project_the_global_protocol() {
    let setup = (any_weight(), start(), 0u32..6, 1u32..4, any::<bool>());
    for_cases(CASES, setup, |(eps, x, num, den, late)| {
        let ratio = TickRatio { num, den: den.try_into().unwrap() };
        let phase = if late { Phase::Last } else { Phase::First };
        let mut p = params_for(eps, &x);
        p.n = ratio.counter_limit();
        let local = LocalParams { protocol: p.clone(), count: x.len(), ratio };
        let initial = State::initial(x, p.n, phase);
        let mut machines: Vec<_> = (0..local.count).map(|i| project(&p, &initial, i)).collect();
        for k in 1..=12 {
            machines = swarm_tick(&local, &machines);
            let global = kth_step(&p, initial.clone(), k);
            for (i, m) in machines.iter().enumerate() {
                prop_assert_eq!(m, &project(&p, &global, i));
            }
        }
        Ok(())
    });
}

#[test]
fn consensus_preserves_the_sum_on_any_graph() {
    let edges = prop::collection::vec((0usize..9, 0usize..9), 0..16);
    for_cases(CASES, (any_weight(), start(), edges), |(eps, x, edges)| {
        let edges: Vec<_> = edges.into_iter().filter(|e| e.0 < x.len() && e.1 < x.len()).collect();
        let graph = Edges { count: x.len(), edges: &edges };
        prop_assert_eq!(sum(&exec_consensus(&eps, &graph, &x)), sum(&x));
        for i in 0..x.len() {
            prop_assert!(!graph.linked(i, i));
            for j in 0..x.len() {
                prop_assert_eq!(graph.linked(i, j), graph.linked(j, i));
            }
        }
        Ok(())
    });
}

#[test]
fn formation_without_displacement_is_consensus_and_keeps_its_formation() {
    for_cases(CASES, (any_weight(), start()), |(eps, x)| {
        let graph = Path { count: x.len() };
        let none = x.lambda(|_| Rational::zero());
        prop_assert_eq!(exec_formation(&eps, &graph, &x, &none), exec_consensus(&eps, &graph, &x));
        // b_i = sum over neighbours (x_i - x_j) makes x a fixed point.
        let b = x.lambda(|i| {
            graph
                .neighbourhood(i)
                .filter(|&j| graph.linked(i, j))
                .fold(Rational::zero(), |s, j| s + &x[i] - &x[j])
        });
        prop_assert_eq!(exec_formation(&eps, &graph, &x, &b), x);
        Ok(())
    });
}

#[test]
fn a_listed_path_is_the_path() {
    for count in 1..8 {
        let edges: Vec<_> = (1..count).map(|i| (i, i - 1)).collect();
        let (listed, path) = (Edges { count, edges: &edges }, Path { count });
        for i in 0..count {
            for j in 0..count {
                assert_eq!(listed.linked(i, j), path.linked(i, j), "{count} {i} {j}");
                assert!(!path.linked(i, j) || path.neighbourhood(i).contains(&j));
            }
        }
    }
}

/// Steps of the agreement tests: few enough for 128-bit fractions to stay in range.
const STEPS: usize = 4;

#[test]
fn residues_agree_with_exact_rationals() {
    let m = Modulus::new((1 << 61) - 1).unwrap();
    for_cases(CASES, (weight(), start()), |(eps, x)| {
        let reduce = |x: &Rational| m.reduce(x).unwrap();
        let reduced: Vec<_> = x.iter().map(reduce).collect();
        let p = params_for(reduce(&eps), &reduced);
        let residues = placements(&p, reduced, STEPS);
        let exact = placements(&params_for(eps, &x), x, STEPS);
        for (r, e) in residues.iter().flatten().zip(exact.iter().flatten()) {
            prop_assert_eq!(*r, reduce(e));
        }
        Ok(())
    });
}

#[test]
fn polynomials_evaluate_to_the_exact_run() {
    // x0 is eps, x1.. are the positions.
    let variable = |i: usize| Polynomial::variable(i as u32 + 1);
    for_cases(40, (weight(), start()), |(eps, x)| {
        let symbols: Vec<_> = (0..x.len()).map(variable).collect();
        let p = params_for(Polynomial::variable(0), &symbols);
        let symbolic = placements(&p, symbols, 2);
        let value = |v: u32| if v == 0 { eps.clone() } else { x[v as usize - 1].clone() };
        let exact = placements(&params_for(eps.clone(), &x), x.clone(), 2);
        for (s, e) in symbolic.iter().flatten().zip(exact.iter().flatten()) {
            prop_assert_eq!(&s.evaluate(value), e);
            // Linear in the positions: what extreme points and stencils rely on.
            for (m, _) in s.terms() {
                let in_positions: u32 = m.powers().filter(|p| p.0 > 0).map(|p| p.1).sum();
                prop_assert_eq!(in_positions, 1);
            }
        }
        Ok(())
    });
}

#[test]
fn machine_integers_agree_with_exact_rationals() {
    // A weight of 0 or 1 keeps integers integers.
    let integers = prop::collection::vec(-50i32..=50, 3..=9);
    for_cases(CASES, (0i32..=1, integers), |(eps, x)| {
        let exact: Vec<_> = x.iter().map(|&n| Rational::from_int(n)).collect();
        let wide: Vec<i128> = x.iter().map(|&n| n.into()).collect();
        let middle: Vec<i64> = x.iter().map(|&n| n.into()).collect();
        let exact = placements(&params_for(Rational::from_int(eps), &exact), exact, STEPS);
        let by_i32 = placements(&params_for(eps, &x), x, STEPS);
        let by_i64 = placements(&params_for(i64::from(eps), &middle), middle, STEPS);
        let by_i128 = placements(&params_for(i128::from(eps), &wide), wide, STEPS);
        for k in 0..=STEPS {
            for i in 0..exact[k].len() {
                prop_assert_eq!(&exact[k][i], &Rational::from_integer(by_i32[k][i].into()));
                prop_assert_eq!(&exact[k][i], &Rational::from_integer(by_i64[k][i].into()));
                prop_assert_eq!(&exact[k][i], &Rational::from_integer(by_i128[k][i].into()));
            }
        }
        Ok(())
    });
}

#[test]
fn arrays_and_vectors_are_the_same_drone_map() {
    let positions = prop::array::uniform5(rational());
    for_cases(CASES, (any_weight(), positions), |(eps, x)| {
        let p = params_for(eps, &x);
        let array = exec_coverage(&p, &State { drones: x.clone(), timesteps: 0 });
        let vector = exec_coverage(&p, &State { drones: x.to_vec(), timesteps: 0 });
        prop_assert_eq!(array.drones.as_slice(), vector.drones.as_slice());
        Ok(())
    });
}

#[test]
fn indices_of_any_size_embed_as_themselves() {
    for i in [0, 1, 2_147_483_647, 2_147_483_648, 4_294_967_295, usize::MAX - 1, usize::MAX] {
        assert_eq!(Rational::from_index(i), Rational::from_integer(i.into()));
        assert_eq!(i128::from_index(i), i as i128);
    }
    assert!(Rational::from_int(1).is_one());
}
