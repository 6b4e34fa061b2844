//! Three-valued answers: what scalars that cannot always tell may make of a predicate.

use core::cmp::Ordering;
use core::mem::discriminant;
use core::ops::{Add, Mul, Sub};

use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, StartSet, Theorem, Truth, Verdict, WeightRange};
use cordon_spec::{Ordered, Params, Scalar, State};

use crate::harness::{covering, harnesses};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "theorems::increasing::as_printed",
    "theorems::increasing::first_off_target_is_late",
    "theorems::verdict::Truth::all",
    "theorems::verdict::Truth::and",
    "theorems::verdict::Truth::from",
    "theorems::verdict::Truth::is_true",
    "theorems::verdict::Truth::negated",
    "theorems::verdict::Verdict::for_all",
    "theorems::verdict::Verdict::given",
    "theorems::verdict::Verdict::one",
    "theorems::verdict::at_most",
    "theorems::verdict::equal",
    "theorems::verdict::less",
    "theorems::verdict::order",
];

const POSITIONS: Domain = Domain::new(0, 7, 3);

/// An integer that may be veiled: then nobody can compare it, nor what is computed of it.
#[derive(Clone, Copy, Debug)]
struct Veiled {
    value: i32,
    veiled: bool,
}

impl Veiled {
    fn seen(value: i32) -> Self {
        Self { value, veiled: false }
    }
}

impl Add<&Self> for Veiled {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        Self { value: self.value + other.value, veiled: self.veiled || other.veiled }
    }
}

impl Sub<&Self> for Veiled {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        Self { value: self.value - other.value, veiled: self.veiled || other.veiled }
    }
}

impl Mul<&Self> for Veiled {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        Self { value: self.value * other.value, veiled: self.veiled || other.veiled }
    }
}

impl Scalar for Veiled {
    fn from_int(n: i32) -> Self {
        Self::seen(n)
    }
}

impl Ordered for Veiled {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        (!self.veiled && !other.veiled).then(|| self.value.cmp(&other.value))
    }
}

fn answer<S: Source>(source: &mut S) -> Truth {
    match source.integer(Domain::whole(0, 2)) {
        0 => Truth::False,
        1 => Truth::True,
        _ => Truth::Unknown,
    }
}

/// Conjunction: false as soon as one side is, true where both are, commutative and associative.
/// Witness: unknown.
fn conjoins<S: Source>(source: &mut S) -> Case {
    let [a, b, c] = [answer(source), answer(source), answer(source)];
    let both = a.and(b);
    assert!((both == Truth::False) == (a == Truth::False || b == Truth::False), "false");
    assert!(both.is_true() == (a.is_true() && b.is_true()), "true");
    assert!(both == b.and(a), "commutative");
    assert!(both.and(c) == a.and(b.and(c)), "associative");
    assert!(Truth::all(3, |i| [a, b, c][i]) == both.and(c), "of many");
    assert!(Truth::all(0, |_| a) == Truth::True, "of none");
    let known = source.flag();
    assert!(Truth::from(known).is_true() == known, "of a bool");
    assert!(Truth::from(known) != Truth::Unknown, "a bool is known");
    Some(Witness(both == Truth::Unknown))
}

/// A verdict on scalars of which some are veiled is that on the scalars themselves, or
/// `Undecided`: whatever the start, in both forms. Witness: undecided.
fn veiled<const N: usize, const K: usize, S: Source>(source: &mut S, theorem: Theorem) -> Case {
    let form = if source.flag() { Form::Paper } else { Form::Sharp };
    veiled_in::<N, K, S>(source, theorem, form)
}

/// The same in one form.
fn veiled_in<const N: usize, const K: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    form: Form,
) -> Case {
    let values = source.integers::<N>(POSITIONS);
    let hidden = source.integers::<N>(Domain::whole(0, 1));
    let eps = source.integer(Domain::whole(0, 1));
    source.assume(values[0] < values[N - 1])?;
    let whole = verdict::<_, N, K>(values, eps, theorem, form);
    let x = core::array::from_fn(|i| Veiled { value: values[i], veiled: hidden[i] == 1 });
    let partial = verdict::<_, N, K>(x, Veiled::seen(eps), theorem, form);
    assert!(whole != Verdict::Undecided, "integers can always tell");
    // Another violation may be the first that is certain.
    let agrees = discriminant(&partial) == discriminant(&whole);
    assert!(agrees || partial == Verdict::Undecided, "never a certain lie");
    let shown = hidden.iter().all(|h| *h == 0);
    assert!(!shown || partial == whole, "with nothing veiled the same");
    Some(Witness(partial == Verdict::Undecided))
}

fn verdict<S: Ordered, const N: usize, const K: usize>(
    x: [S; N],
    eps: S,
    theorem: Theorem,
    form: Form,
) -> Verdict {
    let (min, max) = (x[0].clone(), x[N - 1].clone());
    let p = Params { min, max, eps, n: 0 };
    let mut state = State { drones: x, timesteps: 0 };
    let run: [[S; N]; K] = core::array::from_fn(|k| {
        if k > 0 {
            state = exec_coverage(&p, &state);
        }
        state.drones.clone()
    });
    theorem.conclusion(form, &Setting::from(&p), &run)
}

/// Ranges and start sets on veiled scalars are never certain of what the scalars themselves deny.
/// Witness: unknown.
fn hypothesis_veiled<S: Source>(source: &mut S) -> Case {
    let values = source.integers::<4>(POSITIONS);
    let hidden = source.integers::<4>(Domain::whole(0, 1));
    let (num, den) = (source.integer(Domain::whole(-1, 3)), source.integer(Domain::whole(1, 3)));
    let veil = source.flag();
    source.assume(values[0] < values[3])?;
    let x: [Veiled; 4] =
        core::array::from_fn(|i| Veiled { value: values[i], veiled: hidden[i] == 1 });
    let partial_setting = Setting {
        min: x[0],
        max: x[3],
        eps_num: Veiled { value: num, veiled: veil },
        eps_den: Veiled::seen(den),
    };
    let setting = Setting { min: values[0], max: values[3], eps_num: num, eps_den: den };
    let mut unknown = false;
    for set in [StartSet::Any, StartSet::Ordered, StartSet::FirstSubsegment, StartSet::UpperBounded]
    {
        let partial = set.contains(&partial_setting, &x);
        assert!(
            partial == set.contains(&setting, &values) || partial == Truth::Unknown,
            "never a certain lie"
        );
        unknown |= partial == Truth::Unknown;
    }
    for range in [WeightRange::Unit, WeightRange::BelowThird, WeightRange::BelowCritical] {
        let partial = range.contains(&partial_setting.eps_num, &partial_setting.eps_den, 4);
        assert!(
            partial == range.contains(&num, &den, 4) || veil,
            "the same where nothing is veiled"
        );
        assert!(partial == Truth::Unknown || !veil, "unknown where it is");
    }
    Some(Witness(unknown))
}

/// A run shorter than the span decides nothing; an empty one neither. Witness: every theorem.
fn too_short<S: Source>(source: &mut S) -> Case {
    let x = source.integers::<3>(POSITIONS);
    source.assume(x[0] < x[2])?;
    let setting = Setting { min: x[0], max: x[2], eps_num: 1, eps_den: 2 };
    let run = [x; 2];
    let mut undecided = 0;
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            let span = theorem.span(form, 3);
            assert!(span <= 2, "three drones need two steps at most");
            let short = theorem.conclusion(form, &setting, &run[..span]);
            assert!(short == Verdict::Undecided, "a short run decides nothing");
            undecided += 1;
        }
    }
    Some(Witness(undecided == 20))
}

harnesses! {
    functions FUNCTIONS;
    /// Three-valued conjunction.
    conjunction("answers", unwind 5): covering!("all answers") => |s| conjoins(s);
    /// 7.2 on scalars that cannot always tell.
    veiled_ordering("answers", unwind 5): covering!("N = 4, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<4, 1, _>(s, Theorem::Ordering);
    /// 7.3 on scalars that cannot always tell.
    veiled_upper_bound("answers", unwind 5): covering!("N = 4, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<4, 1, _>(s, Theorem::UpperBound);
    /// 7.4 (ii) on scalars that cannot always tell.
    veiled_maximal("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<3, 1, _>(s, Theorem::SumMaximal);
    /// 7.5 (i) on scalars that cannot always tell.
    veiled_non_decreasing("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<3, 2, _>(s, Theorem::SumNonDecreasing);
    /// 7.6 (i) on scalars that cannot always tell.
    veiled_targets_fixed("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<3, 2, _>(s, Theorem::TargetsFixed);
    /// 7.6 (ii) on scalars that cannot always tell.
    veiled_constant_sum("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<3, 2, _>(s, Theorem::ConstantSum);
    /// 7.7 on scalars that cannot always tell.
    veiled_growth("answers", unwind 5): covering!("N = 4, positions {POSITIONS}, any of them veiled")
        => |s| veiled_in::<4, 2, _>(s, Theorem::GloballyIncreasing, Form::Sharp);
    /// 7.7 as printed, on scalars that cannot always tell.
    veiled_growth_printed("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled_in::<3, 3, _>(s, Theorem::GloballyIncreasing, Form::Paper);
    /// 7.8 on scalars that cannot always tell.
    veiled_limit("answers", unwind 4): covering!("N = 3, positions {POSITIONS}, any of them veiled")
        => |s| veiled::<3, 2, _>(s, Theorem::Limit);
    /// Ranges of weights and start sets on scalars that cannot always tell.
    veiled_hypothesis("answers", unwind 5): covering!("N = 4, positions {POSITIONS}, any of them veiled")
        => |s| hypothesis_veiled(s);
    /// Short runs decide nothing.
    short("answers", unwind 11): covering!("N = 3, all theorems, both forms") => |s| too_short(s);
}
