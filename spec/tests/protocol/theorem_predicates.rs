//! Every theorem's predicates, in both forms: a run that they accept, one that they reject,
//! and the edges of every hypothesis. What must fail, must go on failing.
use crate::placements::{params_for, placements, q, qs};
use cordon_core::Rational;
use cordon_core::linear::enclosure::Enclosure;
use cordon_spec::theorems::{
    Form, Setting, StartSet, Subject, Theorem, Truth, Verdict, Violation, WeightRange,
    above_targets, in_box,
};

/// The verdict of a theorem about step 0 of the run from `start`.
fn verdict(theorem: Theorem, form: Form, eps: &str, start: &str) -> Verdict {
    let start = qs(start);
    let p = params_for(q(eps), &start);
    let run = placements(&p, start.clone(), theorem.span(form, start.len()));
    theorem.conclusion(form, &Setting::from(&p), &run)
}

fn violated(step: usize, subject: Subject) -> Verdict {
    Verdict::Violated(Violation { step, subject })
}

/// (theorem, form, eps, start, verdict): at least one `Holds` and one violation for each of the
/// ten theorems in each form, or the reason why there is none.
fn cases() -> Vec<(Theorem, Form, &'static str, &'static str, Verdict)> {
    use Form::{Paper, Sharp};
    use Verdict::{Holds, Vacuous};
    let mut cases = Vec::new();
    for form in [Paper, Sharp] {
        cases.extend([
            (Theorem::Ordering, form, "1/5", "0,10,20,30,100", Holds),
            (Theorem::Ordering, form, "1/5", "0,20,20,30,100", violated(0, Subject::Pair(1))),
            (Theorem::Ordering, form, "1/5", "0,10,40,30,100", violated(0, Subject::Pair(2))),
            (Theorem::UpperBound, form, "1/5", "0,25,50,75,100", Holds),
            (Theorem::UpperBound, form, "1/5", "0,25,51,75,100", violated(0, Subject::Drone(2))),
            (Theorem::SumBounded, form, "1/5", "0,25,50,75,100", Holds),
            (Theorem::SumBounded, form, "1/5", "0,24,50,77,100", violated(0, Subject::Sum)),
            (Theorem::SumMaximal, form, "1/5", "0,25,50,75,100", Holds),
            (Theorem::SumMaximal, form, "1/5", "0,25,50,74,100", Vacuous),
            (Theorem::SumMaximal, form, "1/5", "0,24,50,76,100", violated(0, Subject::Sum)),
            (Theorem::SumNonDecreasing, form, "1/5", "0,10,20,30,100", Holds),
            (Theorem::SumNonDecreasing, form, "1/5", "0,70,80,90,100", violated(1, Subject::Sum)),
            (Theorem::SumStationary, form, "1/5", "0,25,50,75,100", Holds),
            (Theorem::SumStationary, form, "1/5", "0,25,50,74,100", Vacuous),
            (Theorem::TargetsFixed, form, "7/10", "0,25,50,75,100", Holds),
            (Theorem::TargetsFixed, form, "1/5", "0,25,50,74,100", Vacuous),
            (Theorem::ConstantSum, form, "1/5", "0,25,50,75,100", Holds),
            (Theorem::ConstantSum, form, "1/5", "0,25,50,74,100", Vacuous),
            (Theorem::ConstantSum, form, "0", "0,25,50,74,100", violated(0, Subject::Sum)),
            (Theorem::Limit, form, "1/5", "0,10,20,30,100", Holds),
            (Theorem::Limit, form, "1/5", "0,25,50,75,100", Vacuous),
            (Theorem::Limit, form, "0", "0,10,20,30,100", violated(1, Subject::Energy)),
            (Theorem::Limit, form, "1", "0,10,12", violated(1, Subject::Energy)),
            // N = 4 at its critical weight: the alternating error keeps its size.
            (Theorem::Limit, form, "2/3", "0,2,1,3", violated(1, Subject::Energy)),
        ]);
    }
    cases.extend([
        // The last drone but one at its target, the first two too: c stays for a step.
        (Theorem::GloballyIncreasing, Paper, "1/5", "0,1,2,2,4,5", Holds),
        (Theorem::GloballyIncreasing, Paper, "0", "0,1,2,2,4,5", violated(3 + 2, Subject::Sum)),
        (Theorem::GloballyIncreasing, Paper, "1/5", "0,10,20,30,100", Vacuous),
        (Theorem::GloballyIncreasing, Sharp, "1/5", "0,10,20,30,100", Holds),
        (Theorem::GloballyIncreasing, Sharp, "1/5", "0,1,2,2,4,5", Holds),
        (Theorem::GloballyIncreasing, Sharp, "0", "0,1,2,2,4,5", violated(2, Subject::Sum)),
        (Theorem::GloballyIncreasing, Sharp, "1/5", "0,25,50,75,100", Vacuous),
        // Beyond its target on one side as far as behind on the other: no increase at once.
        (Theorem::GloballyIncreasing, Sharp, "1/5", "0,26,50,74,100", violated(1, Subject::Sum)),
    ]);
    cases
}

#[test]
fn conclusions_accept_and_reject_what_they_should() {
    let cases = cases();
    assert_eq!(cases.len(), 56);
    for (theorem, form, eps, start, expected) in &cases {
        let found = verdict(*theorem, *form, eps, start);
        assert_eq!(found, *expected, "{} {form:?} eps {eps} start {start}", theorem.number());
    }
    // Nothing is accepted only, nothing rejected only. Three statements cannot be violated by
    // any run of the protocol (they hold for every weight and start); those are rejected on
    // placements that are no run, below.
    let universal = [Theorem::SumStationary, Theorem::TargetsFixed];
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            let of = |wanted: fn(&Verdict) -> bool| {
                cases.iter().any(|c| c.0 == theorem && c.1 == form && wanted(&c.4))
            };
            assert!(of(|v| *v == Verdict::Holds), "{theorem:?} {form:?}");
            let rejects = of(|v| matches!(v, Verdict::Violated(_)));
            assert!(rejects || universal.contains(&theorem), "{theorem:?} {form:?}");
        }
    }
}

#[test]
fn statements_that_no_run_violates_reject_what_is_no_run() {
    let p = params_for(q("1/5"), &qs("0,25,50,75,100"));
    let no_run = [[75].as_slice(), &[74; 4]].concat();
    let no_run: Vec<_> = no_run.iter().map(|x3| qs(&format!("0,25,50,{x3},100"))).collect();
    for theorem in [Theorem::SumStationary, Theorem::TargetsFixed] {
        for form in Form::ALL {
            let found = theorem.conclusion(form, &Setting::from(&p), &no_run);
            assert_eq!(found, violated(1, Subject::Sum), "{theorem:?} {form:?}");
        }
    }
}

#[test]
fn the_rate_of_the_limit_is_part_of_its_sharp_form() {
    // The energy falls, and by less than the rate promises: no step of the protocol.
    let p = params_for(q("1/2"), &qs("0,1,4"));
    let run = [qs("0,1,4"), qs("0,11/10,4")];
    let setting = Setting::from(&p);
    assert_eq!(Theorem::Limit.conclusion(Form::Paper, &setting, &run), Verdict::Holds);
    let sharp = Theorem::Limit.conclusion(Form::Sharp, &setting, &run);
    assert_eq!(sharp, violated(1, Subject::Drone(1)));
}

#[test]
fn a_run_too_short_decides_nothing() {
    let start = qs("0,10,20,30,40,50,100");
    let setting = Setting::from(&params_for(q("1/5"), &start));
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            let span = theorem.span(form, start.len());
            let run = vec![start.clone(); span];
            assert_eq!(theorem.conclusion(form, &setting, &run), Verdict::Undecided);
        }
    }
}

/// (range, N, weights inside, weights outside): the edges themselves, and a thousandth beyond.
#[test]
fn weight_ranges_end_where_they_say() {
    use WeightRange::*;
    let table: [(WeightRange, usize, &str, &str); 12] = [
        (Any, 5, "-3,0,1/2,7", ""),
        (Unit, 5, "0,1/2,1", "-1/1000,1001/1000"),
        (BelowThird, 5, "0,333/1000", "-1/1000,1/3,334/1000"),
        (BelowHalf, 5, "0,499/1000", "-1/1000,1/2,501/1000"),
        (UpToHalf, 5, "0,1/2", "-1/1000,501/1000"),
        (UpToHalfOrOne, 4, "0,1/2", "-1/1000,501/1000"),
        (UpToHalfOrOne, 3, "0,501/1000,1", "-1/1000,1001/1000"),
        (PositiveUpToHalf, 5, "1/1000,1/2", "0,-1/1000,501/1000"),
        (BelowCritical, 3, "1/1000,999/1000", "0,1,1001/1000"),
        (BelowCritical, 4, "1/1000,666/1000", "0,2/3,667/1000"),
        // 2 - sqrt 2 = 0.585786..
        (BelowCritical, 5, "1/1000,1/2,585786/1000000", "0,585787/1000000"),
        // 1/(1 + cos(pi/9)) = 0.515548..
        (BelowCritical, 10, "515/1000", "516/1000"),
    ];
    let mut checked = 0;
    for (range, count, inside, outside) in table {
        for (list, expected) in [(inside, Truth::True), (outside, Truth::False)] {
            for eps in list.split(',').filter(|e| !e.is_empty()) {
                assert_eq!(range.contains(&q(eps), &q("1"), count), expected, "{range:?} {eps}");
                // As a quotient of integers too.
                let (num, den) = (q(eps).numer().clone(), q(eps).denom().clone());
                assert_eq!(range.contains(&num, &den, count), expected, "{range:?} {eps}");
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 54);
}

/// The critical weight against its closed form, from both sides, for every N in 3..=40.
#[test]
fn the_critical_weight_is_where_the_cosine_says() {
    for count in 3..=40usize {
        let closed = 1.0 / (1.0 + (std::f64::consts::PI / (count as f64 - 1.0)).cos());
        let thousandth_off = |sign: f64| {
            let eps = Rational::from_float(closed * (1.0 + sign * 1e-9)).unwrap();
            WeightRange::BelowCritical.contains(&eps, &q("1"), count)
        };
        assert_eq!(thousandth_off(-1.0), Truth::True, "N = {count}");
        assert_eq!(thousandth_off(1.0), Truth::False, "N = {count}");
    }
}

#[test]
fn start_sets_contain_what_they_should() {
    use StartSet::*;
    let table: [(StartSet, &str, bool); 12] = [
        (Any, "0,90,20,-30,100", true),
        (Any, "0,10,20,30,100", true),
        (Ordered, "0,10,20,30,100", true),
        (Ordered, "0,10,10,30,100", false),
        (Ordered, "0,20,10,30,100", false),
        (FirstSubsegment, "0,10,20,24,100", true),
        (FirstSubsegment, "0,10,20,25,100", false),
        (FirstSubsegment, "0,20,10,24,100", false),
        (UpperBounded, "0,25,50,75,100", true),
        (UpperBounded, "0,25,50,76,100", false),
        (UpperBounded, "0,-10,50,-75,100", true),
        (UpperBounded, "0,26,50,75,100", false),
    ];
    for (set, start, expected) in table {
        let start = qs(start);
        let setting = Setting::from(&params_for(q("1/5"), &start));
        assert_eq!(set.contains(&setting, &start), expected.into(), "{set:?} {start:?}");
        // The end drones have to be at the ends.
        let mut shifted = setting.clone();
        shifted.max = q("101");
        assert_eq!(set.contains(&shifted, &start), Truth::False);
        shifted = setting;
        shifted.min = q("-1");
        assert_eq!(set.contains(&shifted, &start), Truth::False);
    }
}

/// Assumptions 2 and 3 imply UB, as PROTOCOL section 2 says: on every ordered grid start.
#[test]
fn the_first_subsegment_is_within_the_upper_bound() {
    let (mut inside, mut outside) = (0, 0);
    let setting = Setting { min: 0i64, max: 24, eps_num: 1, eps_den: 5 };
    for a in 1..23i64 {
        for b in a + 1..23 {
            for c in b + 1..24 {
                let start = [0, a, b, c, 24];
                if StartSet::FirstSubsegment.contains(&setting, &start).is_true() {
                    assert!(StartSet::UpperBounded.contains(&setting, &start).is_true());
                    inside += 1;
                } else {
                    outside += 1;
                }
            }
        }
    }
    assert_eq!((inside, outside), (10, 1761));
}

/// Multiplying all positions by a positive number changes no verdict (see `theorems`).
#[test]
fn verdicts_are_homogeneous() {
    for (theorem, form, eps, start, expected) in cases() {
        let start: Vec<_> = qs(start).into_iter().map(|x| x * q("36")).collect();
        let p = params_for(q(eps), &start);
        let run = placements(&p, start.clone(), theorem.span(form, start.len()));
        assert_eq!(theorem.conclusion(form, &Setting::from(&p), &run), expected);
    }
}

#[test]
fn companions_of_the_upper_bound_accept_and_reject() {
    let setting = Setting::from(&params_for(q("1/5"), &qs("0,25,50,75,100")));
    assert_eq!(above_targets(&setting, &qs("0,25,60,75,100")), Verdict::Holds);
    let below = above_targets(&setting, &qs("0,25,49,75,100"));
    assert_eq!(below, violated(0, Subject::Drone(2)));
    assert_eq!(in_box(&setting, &qs("0,100,0,75,100")), Verdict::Holds);
    assert_eq!(in_box(&setting, &qs("0,101,0,75,100")), violated(0, Subject::Drone(1)));
    assert_eq!(in_box(&setting, &qs("0,10,0,-1,100")), violated(0, Subject::Drone(3)));
}

#[test]
fn scalars_that_cannot_tell_leave_it_undecided() {
    // In halves: 2/3 is all from 1/2 to 1, 3/4 likewise.
    let point = |a: &str| Enclosure::<1>::of(&q(a));
    let setting =
        Setting { min: point("0"), max: point("3"), eps_num: point("1"), eps_den: point("5") };
    let run = [vec![point("0"), point("2/3"), point("3/4"), point("3")]];
    assert_eq!(Theorem::Ordering.conclusion(Form::Sharp, &setting, &run), Verdict::Undecided);
    let apart = [vec![point("0"), point("2/3"), point("7/4"), point("3")]];
    assert_eq!(Theorem::Ordering.conclusion(Form::Sharp, &setting, &apart), Verdict::Holds);
    // A certain violation outweighs an unknown.
    let crossed = [vec![point("0"), point("2/3"), point("3/4"), point("-1"), point("3")]];
    let verdict = Theorem::Ordering.conclusion(Form::Sharp, &setting, &crossed);
    assert_eq!(verdict, violated(0, Subject::Pair(2)));
}
