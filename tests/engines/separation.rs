//! Separation in flight: cones that the loop keeps, found, and judged by the independent checker
//! (PROTOCOL section 3).
use crate::common::q;
use cordon_check::Verdict;
use cordon_core::Rational;
use cordon_core::exact::to_f64;
use cordon_core::linear::matrix::{applied, before, dot};
use cordon_cosim::closed_loop::{ClosedLoop, Tuning};
use cordon_cosim::master::Algorithm;
use cordon_cosim::plant::Integrator;
use cordon_proof::separation::desired::{Update, smallest_gap};
use cordon_proof::separation::{Cone, Finding, Response, decide, masses, negative, nonnegative};
use num_traits::{Signed, Zero};
use serde_json::{Value, json};

const WAYS: [(Integrator, Algorithm); 4] = [
    (Integrator::Euler, Algorithm::Jacobi),
    (Integrator::Euler, Algorithm::GaussSeidel),
    (Integrator::Exact, Algorithm::Jacobi),
    (Integrator::Exact, Algorithm::GaussSeidel),
];

fn looped(gains: (&str, &str), way: (Integrator, Algorithm)) -> ClosedLoop {
    ClosedLoop::of(&Tuning {
        lambda_p: q(gains.0),
        lambda_a: q(gains.1),
        tau: q("1/20"),
        integrator: way.0,
        algorithm: way.1,
    })
    .unwrap()
}

fn response(found: &ClosedLoop, wind: bool) -> Response {
    let mut starts = vec![
        ("command".to_owned(), found.command.clone()),
        ("start".to_owned(), found.rest.clone()),
    ];
    if wind {
        let pushes = found.pushes.iter().enumerate();
        starts.extend(pushes.map(|(i, p)| (format!("push{i}"), p.clone())));
        starts.push(("steadyWind".to_owned(), found.trim.clone()));
    }
    Response {
        state: found.state.iter().map(|s| (*s).to_owned()).collect(),
        matrix: found.matrix.clone(),
        starts,
        readouts: found.places.clone(),
    }
}

fn cone(response: &Response) -> Cone {
    match decide(response) {
        Finding::NonNegative(cone) => cone,
        other => panic!("{other:?}"),
    }
}

fn list(numbers: &[Rational]) -> String {
    numbers.iter().map(Rational::to_string).collect::<Vec<_>>().join(" ")
}

#[test]
fn the_loop_is_the_one_of_the_equations() {
    // u = -(2 lA j + lA^2 (a + 2 lP v + lP^2 x)), one step late under Jacobi.
    let jacobi = looped(("0.4", "4"), WAYS[0]);
    assert_eq!(list(&jacobi.matrix[4]), "-64/25 -64/5 -16 -8 0");
    assert_eq!(list(&jacobi.command), "0 0 0 0 64/25");
    assert_eq!(list(&jacobi.matrix[0]), "1 1/20 0 0 0");
    let direct = looped(("0.4", "4"), WAYS[3]);
    assert_eq!(list(&direct.command), "1/1500000 1/18750 2/625 16/125", "lP^2 lA^2 tau^k/k!");
    for way in WAYS {
        let found = looped(("0.4", "4"), way);
        assert_eq!(list(&found.trim[..3]), "25/4 0 -1", "1/lP^2, leaning into the wind");
        assert!(found.trim[3..].iter().chain(&found.rest[1..]).all(Zero::is_zero));
        assert_eq!(found.pushes.len(), if way.0 == Integrator::Exact { 2 } else { 1 });
        assert_eq!(list(&found.pushes[0][..2]), "0 1");
    }
    // The places: x + v tau/4, x + v tau/2 + a tau^2/12, x + 3/4 v tau + a tau^2/4 + j tau^3/24.
    let places: Vec<String> = direct.places.iter().map(|p| list(p)).collect();
    assert_eq!(places[1..], ["1 1/80 0 0", "1 1/40 1/4800 0", "1 3/80 1/1600 1/192000"]);
    assert_eq!(list(&direct.pushes[1]), "1/20 1 0 0");
}

/// How many claims are proved at every step of every run.
fn claimed(verdict: &Verdict) -> usize {
    verdict.to_string().matches("proved: for all integers k, if k >= 0 then ").count()
}

type Found = ((&'static str, &'static str), usize, bool, usize, usize);

/// Gains, way, whether with wind; rows of the cone, and the step that it is entered after.
const FOUND: [Found; 18] = [
    (("0.4", "4"), 0, false, 8, 16),
    (("0.4", "4"), 1, false, 6, 18),
    (("0.4", "4"), 2, false, 8, 15),
    (("0.4", "4"), 3, false, 6, 16),
    (("0.4", "4"), 0, true, 8, 16),
    (("0.4", "4"), 1, true, 6, 18),
    (("0.4", "4"), 2, true, 8, 15),
    (("0.4", "4"), 3, true, 6, 16),
    (("0.4", "2"), 0, false, 30, 22),
    (("0.4", "2"), 1, false, 30, 18),
    (("0.4", "2"), 2, false, 26, 19),
    (("0.4", "2"), 3, false, 26, 17),
    (("0.4", "2"), 0, true, 30, 42),
    (("0.4", "2"), 1, true, 30, 43),
    (("0.4", "2"), 2, true, 26, 39),
    (("0.4", "2"), 3, true, 26, 40),
    (("0.89", "4"), 0, false, 54, 36),
    (("1", "10"), 1, false, 6, 8),
];

#[test]
fn cones_are_found_and_their_certificates_accepted() {
    for (gains, way, wind, rows, entered) in FOUND {
        let response = response(&looped(gains, WAYS[way]), wind);
        let cone = cone(&response);
        assert!(cone.is_kept_by(&response), "{gains:?} {way} {wind}");
        let verdict = cordon_check::check(&nonnegative(&response, &cone).unwrap().to_string());
        assert!(matches!(verdict, Verdict::Valid { .. }), "{gains:?} {way} {wind}: {verdict}");
        assert_eq!(claimed(&verdict), response.readouts.len());
        assert_eq!((cone.rows.len(), cone.entered), (rows, entered), "{gains:?} {way} {wind}");
    }
}

/// Negative samples of the response to a command, and the step after which they come first.
#[test]
fn quick_positions_have_a_negative_sample_that_the_checker_sees() {
    let cases =
        [("0.915", 0, 71), ("0.9", 1, 72), ("0.995", 2, 68), ("0.97", 3, 136), ("1", 0, 60)];
    for (gain, way, step) in cases {
        let mut response = response(&looped((gain, "4"), WAYS[way]), false);
        response.readouts.truncate(1);
        response.starts.truncate(1);
        let Finding::Negative(found) = decide(&response) else { panic!("{gain}") };
        // The first sample is that after the step of the command.
        assert_eq!(found.step + 1, step, "{gain}");
        assert!(found.value.is_negative());
        let page = negative(&response, &found).unwrap();
        let verdict = cordon_check::check(&page.to_string());
        assert!(matches!(verdict, Verdict::Valid { .. }), "{gain}: {verdict}");
        let claim = format!("proved: 0 > x({})", found.step);
        assert!(verdict.to_string().contains(&claim), "{verdict}");
    }
    // A step earlier it is not, and no certificate can be made; a forged one is refused.
    let mut response = response(&looped(("1", "4"), WAYS[0]), false);
    response.readouts.truncate(1);
    let Finding::Negative(mut found) = decide(&response) else { panic!() };
    let page = negative(&response, &found).unwrap();
    assert_eq!(cordon_check::check(&page.to_string()).code(), 0);
    let forged = changed(&page, |c| {
        let goal = &mut c["statement"]["conclusions"][0]["goal"];
        let earlier = goal
            .as_str()
            .unwrap()
            .replace(&format!("({})", found.step), &format!("({})", found.step - 1));
        *goal = json!(earlier);
    });
    assert!(forged.contains("rule positivity: the sides differ at `x("), "{forged}");
    found.step -= 1;
    assert_eq!(negative(&response, &found), None);
}

fn changed(page: &Value, change: impl Fn(&mut Value)) -> String {
    let mut page = page.clone();
    change(&mut page["certificate"]["theorem"]);
    cordon_check::check(&page.to_string()).to_string()
}

#[test]
fn tampered_and_false_certificates_are_refused_for_the_right_reason() {
    let response = response(&looped(("0.4", "4"), WAYS[0]), true);
    let cone = cone(&response);
    let page = nonnegative(&response, &cone).unwrap();
    assert!(changed(&page, |_| ()).starts_with("valid"), "the twin");
    let lemmas = page["certificate"]["theorem"]["proof"]["lemmas"].as_array().unwrap();
    let kept = lemmas.iter().position(|l| l["proof"]["induction"].is_object()).unwrap();
    let step = |c: &mut Value, change: &dyn Fn(&mut Value)| {
        let step = &mut c["proof"]["lemmas"][kept]["proof"]["induction"]["step"]["positivity"];
        change(step["use"].as_array_mut().unwrap().last_mut().unwrap());
    };
    let assumption = |c: &mut Value, name: &str, from: &str, to: &str| {
        let all = c["statement"]["assumptions"].as_array_mut().unwrap();
        let goal = &mut all.iter_mut().find(|a| a["name"] == name).unwrap()["goal"];
        let text = goal.as_str().unwrap().replace(from, to);
        assert_ne!(*goal, json!(text));
        *goal = json!(text);
    };
    let goal = |c: &mut Value, to: &str| c["statement"]["conclusions"][0]["goal"] = json!(to);
    let found = [
        // Weights that may be negative, or other ones.
        changed(&page, |c| step(c, &|before| before["with"]["l0"] = json!("-l0"))),
        changed(&page, |c| step(c, &|before| before["with"]["l0"] = json!("l0"))),
        // A cone that is left out, or another one.
        changed(&page, |c| drop(c["proof"]["lemmas"].as_array_mut().unwrap().remove(kept))),
        changed(&page, |c| {
            c["proof"]["lemmas"][kept]["clause"]["goal"] = json!("l0*v(k) + c > 0");
        }),
        // Quicker drones, and a start that is moved.
        changed(&page, |c| assumption(c, "step.u", "v(k)", "2*v(k)")),
        changed(&page, |c| assumption(c, "start.4", "u(0)", "u(0) - command(0)")),
        // More than is true.
        changed(&page, |c| goal(c, "x(k) > 0")),
        changed(&page, |c| goal(c, "v(k) >= 0")),
    ];
    let rules = [
        "positivity",
        "positivity",
        "instance",
        "positivity",
        "positivity",
        "positivity",
        "positivity",
        "positivity",
    ];
    for (k, (found, rule)) in found.iter().zip(rules).enumerate() {
        assert!(
            found.starts_with("invalid") && found.contains(&format!("rule {rule}: ")),
            "{k}: {found}"
        );
    }
    // The cone of one loop is none of another, in which the response does turn negative.
    let quick = super::separation::response(&looped(("1", "4"), WAYS[0]), false);
    assert!(cone.is_kept_by(&response) && !cone.is_kept_by(&quick));
    assert_eq!(nonnegative(&quick, &cone), None);
}

#[test]
fn negative_mass_is_bounded_and_hardly_more_than_there_is() {
    let known = [0.036_585, 0.050_331, 0.000_454, 0.005_097];
    for (way, expected) in WAYS.into_iter().zip(known) {
        let response = response(&looped(("1", "4"), way), false);
        let mass = masses(&response).unwrap();
        assert!(mass.cone.is_kept_by(&mass.bounded));
        let page = nonnegative(&mass.bounded, &mass.cone).unwrap();
        let verdict = cordon_check::check(&page.to_string());
        assert!(matches!(verdict, Verdict::Valid { .. }), "{verdict}");
        // In doubles, ten times as long.
        let matrix: Vec<Vec<f64>> =
            response.matrix.iter().map(|row| row.iter().map(to_f64).collect()).collect();
        let mut worst = 0.0_f64;
        for place in &response.readouts {
            let place: Vec<f64> = place.iter().map(to_f64).collect();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            let mut x: Vec<f64> = response.starts[0].1.iter().map(to_f64).collect();
            let mut sum = 0.0;
            for _ in 0..10 * mass.samples {
                sum -= dot(&place, &x).min(0.0);
                x = matrix.iter().map(|row| dot(row, &x)).collect();
            }
            worst = worst.max(sum);
        }
        let n = to_f64(&mass.negative);
        assert!(worst <= n && n <= worst + 2e-6, "{way:?}: {worst} {n}");
        assert!((n - expected).abs() < 2e-6, "{way:?}: {n}");
        assert!(mass.tail <= q("1/1000000"));
    }
    // What grows has no mass.
    assert!(masses(&response(&looped(("1", "10"), WAYS[0]), false)).is_none());
}

/// Two drones blown apart as hard as allowed: the gap that is lost comes as near as one likes to
/// 2 W/lambda_P^2 and never beyond.
#[test]
fn the_cost_of_wind_is_tight() {
    for way in WAYS {
        let found = looped(("0.4", "4"), way);
        // The wind of a step: pushes, spread evenly, of +W on one drone and -W on the other.
        let share = q("1/20") / Rational::from_integer(found.pushes.len().into());
        let most = q("2") * found.trim[0].clone();
        let mut gap: Vec<f64> = vec![0.0; found.state.len()];
        let matrix: Vec<Vec<f64>> =
            found.matrix.iter().map(|row| row.iter().map(to_f64).collect()).collect();
        let push: Vec<f64> = (0..gap.len())
            .map(|i| 2.0 * to_f64(&(found.pushes.iter().map(|p| &p[i] * &share).sum())))
            .collect();
        for _ in 0..2_000 {
            let row = |row: &Vec<f64>| row.iter().zip(&gap).map(|(a, x)| a * x).sum::<f64>();
            gap = matrix.iter().zip(&push).map(|(r, p)| row(r) + p).collect();
            assert!(gap[0] <= to_f64(&most) + 1e-9);
        }
        assert!(gap[0] > to_f64(&most) - 1e-6, "{way:?}: {}", gap[0]);
        // What is missing from there is the response to the trim, which a cone has.
        let steady: Vec<Rational> = applied(&found.matrix, &found.trim);
        let pushed = |i: usize| -> Rational { found.pushes.iter().map(|p| &p[i] * &share).sum() };
        assert!((0..steady.len()).all(|i| &steady[i] + pushed(i) == found.trim[i]));
        assert!(found.places.iter().all(|place| dot(place, &found.trim).is_positive()));
        assert_eq!(before(&found.trim, &cordon_core::linear::matrix::unit(gap.len())), found.trim);
    }
}

#[test]
fn the_smallest_desired_gap_is_certified_where_it_is_kept() {
    let start = |list: &str| crate::common::qs(list);
    let mut accepted = 0;
    for (places, eps, least, update, kept) in [
        ("0,10,20,30,100", "1/5", "10", Update::AtOnce, true),
        ("0,10,20,30,100", "1/2", "10", Update::AtOnce, true),
        ("0,10,20,30,100", "3/5", "10", Update::AtOnce, false),
        ("0,10,20,30,100", "1/5", "11", Update::AtOnce, false),
        ("0,10,20,30,100", "1/2", "10", Update::OneByOne, true),
        ("0,10,20,30,100", "1", "10", Update::OneByOne, true),
        ("0,10,20,30,100", "11/10", "10", Update::OneByOne, false),
        ("0,1,5", "1", "1", Update::AtOnce, true),
        ("0,1,5", "11/10", "1", Update::AtOnce, false),
        ("0,1,5", "0", "-1", Update::AtOnce, true),
    ] {
        let page = smallest_gap(&start(places), &q(eps), &q(least), update);
        assert_eq!(page.is_some(), kept, "{places} {eps} {least} {update:?}");
        if let Some(page) = page {
            let verdict = cordon_check::check(&page.to_string());
            assert!(matches!(verdict, Verdict::Valid { .. }), "{verdict}");
            assert_eq!(claimed(&verdict), start(places).len() - 1);
            accepted += 1;
        }
    }
    assert_eq!(accepted, 6);
    let long: Vec<Rational> = (0..150).map(|i| Rational::from_integer((i * i).into())).collect();
    let page = smallest_gap(&long, &q("1/3"), &q("1"), Update::AtOnce).unwrap();
    assert!(cordon_proof::certificate::judged(&page).is_ok());
    let forged = changed(&page, |c| {
        c["statement"]["conclusions"][0]["goal"] = json!("-x0(k) + x1(k) - 2 >= 0");
    });
    assert!(forged.contains("rule positivity: the sides differ in their constants"), "{forged}");
}

/// Along z a drone is z'' = -(2 lambda_P z' + lambda_P^2 (z - z_d)), with the exchange one step late: never past
/// a height that it is sent to from below, by four rows. No exact units fly there: the matrix is written down.
#[test]
fn heights_are_not_passed() {
    let (tau, l) = (q("1/20"), q("2/5"));
    let two = q("2");
    for half in [q("0"), &tau * &tau / &two] {
        let matrix = vec![
            vec![q("1"), tau.clone(), half],
            vec![q("0"), q("1"), tau.clone()],
            vec![-(&l * &l), -(&two * &l), q("0")],
        ];
        let response = Response {
            state: ["z", "v", "u"].map(str::to_owned).to_vec(),
            matrix,
            starts: vec![("command".to_owned(), vec![q("0"), q("0"), &l * &l])],
            readouts: vec![vec![q("1"), q("0"), q("0")]],
        };
        let found = cone(&response);
        assert_eq!(found.rows.len(), 4);
        let page = nonnegative(&response, &found).unwrap();
        assert!(matches!(cordon_check::check(&page.to_string()), Verdict::Valid { .. }));
    }
}
