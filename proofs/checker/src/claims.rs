//! The claims of kind `theorem`: which obligations make up the proof of each.
//!
//! One claim is one function in [`CLAIMS`]. What is not an obligation, the argument that puts
//! the obligations together, is in the text at the function and in TRUST.md.

use cordon_spec::Scalar;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::graph::Path;
use cordon_spec::placement::contraction_weight_at;
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

use crate::format::{TheoremCert, polynomial};
use crate::model::{Class, Family, Mode, Place, Swarm, Weights, named, start_facts};
use crate::poly::{Poly, Var};
use crate::projection;
use crate::rules::Relation::{self, NonNegative, Positive, Zero};
use crate::rules::{Fact, Obligation};

/// What a claim is to be proved for.
pub struct Scope<'c> {
    /// Which form, of a theorem.
    pub form: Form,
    /// Which weights.
    pub weights: Weights,
    /// One N, or all N >= 3.
    pub drones: Option<u32>,
    /// The certificate, for its data.
    pub cert: &'c TheoremCert,
}

/// Why there are no obligations.
pub enum Refusal {
    /// The certificate lacks something.
    Missing(String),
    /// It has something wrong.
    Wrong(String),
}

type Obligations = Result<Vec<Obligation>, Refusal>;
type Plan = fn(&Scope<'_>) -> Obligations;

/// A claim.
pub struct Claim {
    /// Its name: the theorem's number, or an extension's.
    pub name: &'static str,
    /// The theorem that it is, or extends.
    pub theorem: Option<Theorem>,
    /// What it says, the range of weights and N apart.
    pub text: &'static str,
    /// The data that the plan reads.
    pub data: &'static [&'static str],
    plan: Plan,
}

const fn claim(
    name: &'static str,
    theorem: Option<Theorem>,
    text: &'static str,
    data: &'static [&'static str],
    plan: Plan,
) -> Claim {
    Claim { name, theorem, text, data, plan }
}

/// Every claim.
#[rustfmt::skip]
pub const CLAIMS: &[Claim] = &[
    claim("7.2", Some(Theorem::Ordering), "X_i^k < X_{i+1}^k for all i, k", &[],
        |s| invariant(s, &[Family::Ordered], Mode::Plain)),
    claim("7.3", Some(Theorem::UpperBound), "X_i^k <= T_i for all i, k", &[],
        |s| invariant(s, &[Family::UpperBound], Mode::Plain)),
    claim("7.4i", Some(Theorem::SumBounded), "c^k <= N*min + N(N-1)/2*l for all k", &["targets"], sum_bounded),
    claim("7.4ii", Some(Theorem::SumMaximal), "c^k meets its bound iff all drones are at their targets", &["targets"], sum_maximal),
    claim("7.5i", Some(Theorem::SumNonDecreasing), "c^{k+1} >= c^k for all k", &["flux"], sum_non_decreasing),
    claim("7.5ii", Some(Theorem::SumStationary), "at the targets c^{k+1} = c^k", &["flux"], sum_stationary),
    claim("7.6i", Some(Theorem::TargetsFixed), "at the targets the drones stay", &["targets"], targets_fixed),
    claim("7.6ii", Some(Theorem::ConstantSum), "c^{k+h} = c^k for h = 1 .. ceil((N-2)/2) only at the targets", &["flux"], constant_sum),
    claim("7.7", Some(Theorem::GloballyIncreasing), "the first increase is c^{k+h+1} > c^{k+h} with h = min(j, N-1-j) - 1, least over off-target j", &["flux"], globally_increasing),
    claim("7.8", Some(Theorem::Limit), "|e_i^k| <= (1 - 8eps/(N-1)^2)^k max_j(|e_j^0|/w_j) w_i, w_i = i(N-1-i), hence X_i^k -> T_i", &[], limit),
    claim("7.5-identity", None, "c^{k+1} - c^k = eps*(g_{N-2}^k - g_0^k), any start", &["flux"], flux),
    claim("7.3-mirror", Some(Theorem::UpperBound), "X_i^0 >= T_i for all i implies X_i^k >= T_i for all i, k", &[],
        |s| step(s, &[Family::LowerBound], Mode::Plain)),
    claim("7.3-box", Some(Theorem::UpperBound), "X_i^0 in [min, max] for all i implies X_i^k in [min, max] for all i, k", &[],
        |s| step(s, BOX, Mode::Plain)),
    claim("7.2-activation", Some(Theorem::Ordering), "as 7.2, any drones skipping any steps", &[],
        |s| invariant(s, &[Family::Ordered], Mode::Activation)),
    claim("7.3-activation", Some(Theorem::UpperBound), "as 7.3, any drones skipping any steps", &[],
        |s| invariant(s, &[Family::UpperBound], Mode::Activation)),
    claim("7.3-mirror-activation", Some(Theorem::UpperBound), "as 7.3-mirror, any drones skipping any steps", &[],
        |s| step(s, &[Family::LowerBound], Mode::Activation)),
    claim("7.3-box-activation", Some(Theorem::UpperBound), "as 7.3-box, any drones skipping any steps", &[],
        |s| step(s, BOX, Mode::Activation)),
    claim("7.3-delay", Some(Theorem::UpperBound), "as 7.3, neighbours seen where they were at any earlier step", &[],
        |s| invariant(s, &[Family::UpperBound], Mode::Delay)),
    claim("7.3-mirror-delay", Some(Theorem::UpperBound), "as 7.3-mirror, neighbours seen where they were at any earlier step", &[],
        |s| step(s, &[Family::LowerBound], Mode::Delay)),
    claim("7.3-box-delay", Some(Theorem::UpperBound), "as 7.3-box, neighbours seen where they were at any earlier step", &[],
        |s| step(s, BOX, Mode::Delay)),
    claim("consensus-average", None, "consensus on a path preserves the sum of the positions", &["flux"], consensus),
    claim("projection", None, "N local machines compute the global kth_step", &[], projection::obligations),
];

const BOX: &[Family] = &[Family::AboveMin, Family::BelowMax];

impl Claim {
    /// The claim of that name.
    pub fn named(name: &str) -> Option<&'static Self> {
        CLAIMS.iter().find(|c| c.name == name)
    }

    /// Whether it is a theorem itself and so has forms.
    pub fn has_forms(&self) -> bool {
        self.theorem.is_some_and(|t| t.number() == self.name)
    }

    /// The weights that are meant if none are named. 7.8 is proved up to 1/2 for every N; beyond,
    /// per N (kind `contraction`).
    pub fn weights(&self, form: Form) -> WeightRange {
        match self.theorem.map(|t| t.hypothesis(form).weights) {
            None => WeightRange::Any,
            Some(WeightRange::BelowCritical) => WeightRange::PositiveUpToHalf,
            Some(range) => range,
        }
    }

    /// What has to be proved.
    pub fn obligations(&self, scope: &Scope<'_>) -> Obligations {
        (self.plan)(scope)
    }

    fn starts(&self, form: Form) -> StartSet {
        self.theorem.map_or(StartSet::Any, |t| t.hypothesis(form).starts)
    }
}

/// One part of the case split over N.
struct Group {
    prefix: &'static str,
    three: bool,
    facts: Vec<Fact>,
}

/// Every N that the scope speaks of, in at most two groups, with what is known of weight and N.
fn groups(scope: &Scope<'_>) -> Result<Vec<Group>, Refusal> {
    let group = |prefix, three, least: i32, relation| -> Result<Group, Refusal> {
        let mut facts = scope.weights.facts(three).map_err(Refusal::Wrong)?;
        let rest = named("last") - &Poly::from_int(least);
        facts.push(Fact::new("max-min", named("max") - &named("min"), Positive));
        facts.push(Fact::new("last", named("last"), Positive));
        facts.push(Fact::new(&format!("last-{least}"), rest, relation));
        Ok(Group { prefix, three, facts })
    };
    match scope.drones {
        Some(n @ 3..) => {
            let last = i32::try_from(n - 1).map_err(|e| Refusal::Wrong(e.to_string()))?;
            Ok(vec![group("", n == 3, last, Zero)?])
        }
        Some(n) => Err(Refusal::Wrong(format!("{n} drones: expected 3 or more"))),
        None if scope.weights.differ_for_three() => {
            Ok(vec![group("N=3/", true, 2, Zero)?, group("N>=4/", false, 3, NonNegative)?])
        }
        None => Ok(vec![group("", false, 2, NonNegative)?]),
    }
}

/// The one group of claims whose range of weights does not depend on N.
fn group(scope: &Scope<'_>) -> Result<Group, Refusal> {
    match <[Group; 1]>::try_from(groups(scope)?) {
        Ok([group]) => Ok(group),
        Err(_) => Err(Refusal::Wrong("the range of weights differs for N = 3".into())),
    }
}

fn obligation(name: String, facts: Vec<Fact>, goal: Poly, relation: Relation) -> Obligation {
    Obligation { name, facts, goal, relation }
}

/// Induction over steps: the families hold at the start, and each step preserves them. With
/// [`Mode::Delay`] the induction is over all past steps: the families hold of the neighbours
/// wherever they were.
fn invariant(scope: &Scope<'_>, families: &[Family], mode: Mode) -> Obligations {
    let starts = Claim::named(&scope.cert.claim).map_or(StartSet::Any, |c| c.starts(scope.form));
    let mut all = Vec::new();
    for group in groups(scope)? {
        for (family, class) in cases(families, &group) {
            let swarm = Swarm::new(class, family.of_pairs(), Mode::Plain);
            let facts = [
                group.facts.clone(),
                swarm.index_facts(class),
                start_facts(starts, class, &swarm.place),
            ];
            let (label, relation) = family.label();
            let name = format!("{}start/{label}/{}", group.prefix, class.label());
            all.push(obligation(name, facts.concat(), family.goal(&swarm.place)?, relation));
        }
    }
    all.extend(step(scope, families, mode)?);
    Ok(all)
}

/// The step of [`invariant`] alone: for claims whose start set is the invariant itself.
fn step(scope: &Scope<'_>, families: &[Family], mode: Mode) -> Obligations {
    anchored(mode)?;
    let mut all = Vec::new();
    for group in groups(scope)? {
        for (family, class) in cases(families, &group) {
            let swarm = Swarm::new(class, family.of_pairs(), mode);
            let now = families.iter().flat_map(|f| f.facts(&swarm.place)).collect();
            let facts = [group.facts.clone(), swarm.index_facts(class), now].concat();
            let (label, relation) = family.label();
            for (suffix, after) in swarm.after(mode) {
                let name = format!("{}step/{label}/{}{suffix}", group.prefix, class.label());
                all.push(obligation(name, facts.clone(), family.goal(&after)?, relation));
            }
        }
    }
    Ok(all)
}

/// Every family with every class that occurs for the N of the group.
fn cases(families: &[Family], group: &Group) -> Vec<(Family, Class)> {
    let occurs = |f: &Family, c: Class| !(f.of_pairs() && group.three && c == Class::Inner);
    let of =
        |&f: &Family| Class::ALL.into_iter().filter(move |&c| occurs(&f, c)).map(move |c| (f, c));
    families.iter().flat_map(of).collect()
}

impl Family {
    fn goal(self, place: &Place) -> Result<Poly, Refusal> {
        self.at(place, 0).ok_or_else(|| Refusal::Wrong("the step hides a position".into()))
    }
}

/// Whether a step leaves the end drones in place, as every start set has them.
fn anchored(mode: Mode) -> Result<(), Refusal> {
    for (class, end) in [(Class::First, named("min")), (Class::Last, named("max"))] {
        for (_, after) in Swarm::new(class, false, mode).after(mode) {
            if after.x.get(&0) != Some(&end) {
                return Err(Refusal::Wrong("a step moves an end drone".into()));
            }
        }
    }
    Ok(())
}

/// A polynomial F(i) from the certificate, in i, x[-1], x[0] and the parameters.
fn datum(scope: &Scope<'_>, name: &str) -> Result<Poly, Refusal> {
    let datum = scope.cert.data.iter().find(|d| d.name == name);
    let datum = datum.ok_or_else(|| Refusal::Missing(format!("datum `{name}`")))?;
    let mut vars = ["eps", "min", "max", "last", "i"].map(Var::Named).to_vec();
    vars.extend([Var::At("x", -1), Var::At("x", 0)]);
    polynomial(&datum.polynomial, &vars)
        .map_err(|reason| Refusal::Wrong(format!("datum `{name}`: {reason}")))
}

/// F at index `i`, the positions of drones i-1 and i being `before` and `here`.
fn at(f: &Poly, i: &Poly, before: &Poly, here: &Poly) -> Poly {
    f.substitute(|v| match v {
        Var::Named("i") => Some(i.clone()),
        Var::At("x", -1) => Some(before.clone()),
        Var::At("x", 0) => Some(here.clone()),
        _ => None,
    })
}

fn x(offset: i32) -> Poly {
    Poly::var(Var::At("x", offset))
}

/// The identity behind 7.5: with x_i' - x_i = F(i+1) - F(i) for every inner i, the sum of all
/// differences telescopes to F(N-1) - F(1); the end drones stay.
fn flux(scope: &Scope<'_>) -> Obligations {
    anchored(Mode::Plain)?;
    let f = datum(scope, "flux")?;
    let swarm = Swarm::new(Class::Inner, false, Mode::Plain);
    let mut all = Vec::new();
    for (_, after) in swarm.after(Mode::Plain) {
        let moved = after.x.get(&0).cloned().unwrap_or_default() - &x(0);
        let next = named("i") + &Poly::from_int(1);
        let step = at(&f, &next, &x(0), &x(1)) - &at(&f, &named("i"), &x(-1), &x(0));
        all.push(obligation("flux/inner".into(), Vec::new(), moved - &step, Zero));
    }
    let (first, final_) = (named("x1"), named("x(N-2)"));
    let gaps = named("max") - &final_ - &(first - &named("min"));
    let goal = increment(scope)? - &(named("eps") * &gaps);
    all.push(obligation("flux/total".into(), Vec::new(), goal, Zero));
    Ok(all)
}

/// c' - c = F(N-1) - F(1), in the positions of drones 1 and N-2.
fn increment(scope: &Scope<'_>) -> Result<Poly, Refusal> {
    let f = datum(scope, "flux")?;
    let end = at(&f, &named("last"), &named("x(N-2)"), &named("max"));
    Ok(end - &at(&f, &Poly::from_int(1), &named("min"), &named("x1")))
}

/// What is known of the errors of drones 1 and N-2.
fn ends(first: Relation, last: Relation) -> Vec<Fact> {
    let (min, max, n) = (named("min"), named("max"), named("last"));
    let error = |i: &Poly, x: &Poly| cordon_spec::placement::error_at(&min, &max, &n, i, x);
    let one = Poly::from_int(1);
    vec![
        Fact::new("error(1)", error(&one, &named("x1")), first),
        Fact::new("error(N-2)", error(&(n.clone() - &one), &named("x(N-2)")), last),
    ]
}

/// 7.5 (i): the identity, and the increment is not negative.
fn sum_non_decreasing(scope: &Scope<'_>) -> Obligations {
    let mut all = invariant(scope, &[Family::UpperBound], Mode::Plain)?;
    all.extend(flux(scope)?);
    let facts = [group(scope)?.facts, ends(NonNegative, NonNegative)].concat();
    all.push(obligation("increment".into(), facts, increment(scope)?, NonNegative));
    Ok(all)
}

/// 7.5 (ii): the identity, and the increment is zero at the targets.
fn sum_stationary(scope: &Scope<'_>) -> Obligations {
    let mut all = flux(scope)?;
    let facts = [group(scope)?.facts, ends(Zero, Zero)].concat();
    all.push(obligation("increment".into(), facts, increment(scope)?, Zero));
    Ok(all)
}

/// The sum c of the positions and the sum E of the (N-1) e_i: with F(i+1) - F(i) = (N-1) T_i,
/// the targets telescope, so that E = F(N) - F(0) - (N-1) c. Gives the obligation on F and the fact.
fn total(
    scope: &Scope<'_>,
    c: &'static str,
    e: &'static str,
) -> Result<(Obligation, Fact), Refusal> {
    let f = datum(scope, "targets")?;
    let zero = Poly::from_int(0);
    let next = named("i") + &Poly::from_int(1);
    let at = |i: &Poly| at(&f, i, &zero, &zero);
    let swarm = Swarm::new(Class::Inner, false, Mode::Plain);
    let goal = swarm.place.error(0, &zero) - &(at(&next) - &at(&named("i")));
    let count = named("last") + &Poly::from_int(1);
    let sum = named(e) + &(named("last") * &named(c)) - &(at(&count) - &at(&zero));
    let fact = Fact::new(&format!("{e}-targets+last*{c}"), sum, Zero);
    Ok((obligation("targets".into(), Vec::new(), goal, Zero), fact))
}

/// N(min + max) - 2c: twice what the sum is below its bound.
fn deficit() -> Poly {
    let count = named("last") + &Poly::from_int(1);
    count * &(named("min") + &named("max")) - &(Poly::from_int(2) * &named("c"))
}

/// 7.4 (i): all errors are nonnegative (7.3), so E >= 0.
fn sum_bounded(scope: &Scope<'_>) -> Obligations {
    let mut all = invariant(scope, &[Family::UpperBound], Mode::Plain)?;
    let (targets, fact) = total(scope, "c", "E")?;
    let e = Fact::new("E", named("E"), NonNegative);
    let facts = [group(scope)?.facts, vec![fact, e]].concat();
    all.push(targets);
    all.push(obligation("bound".into(), facts, deficit(), NonNegative));
    Ok(all)
}

/// 7.4 (ii): at the targets E = 0 and the bound is met; if it is met then E <= 0, and a sum of nonnegative
/// errors that is not above zero has zeros only.
fn sum_maximal(scope: &Scope<'_>) -> Obligations {
    let mut all = invariant(scope, &[Family::UpperBound], Mode::Plain)?;
    let (targets, fact) = total(scope, "c", "E")?;
    let known = [group(scope)?.facts, vec![fact]].concat();
    let with = |f: Fact| [known.clone(), vec![f]].concat();
    let at_targets = Fact::new("E", named("E"), Zero);
    let met = Fact::new("deficit", deficit(), Zero);
    all.push(targets);
    all.push(obligation("if".into(), with(at_targets), deficit(), Zero));
    all.push(obligation("only-if".into(), with(met), Poly::from_int(0) - &named("E"), NonNegative));
    Ok(all)
}

/// 7.6 (i): being at the targets is an invariant; so the sum stays (E = 0 before and after).
fn targets_fixed(scope: &Scope<'_>) -> Obligations {
    let mut all = step(scope, &[Family::AtTarget], Mode::Plain)?;
    let ((targets, now), (_, later)) = (total(scope, "c", "E")?, total(scope, "c'", "E'")?);
    let zero = |e| Fact::new(e, named(e), Zero);
    let facts = [group(scope)?.facts, vec![now, later, zero("E"), zero("E'")]].concat();
    all.push(targets);
    all.push(obligation("sum".into(), facts, named("c'") - &named("c"), Zero));
    Ok(all)
}

/// The facts about an inner drone and its neighbours, the errors at offsets -1, 0 and 1 being
/// so related to zero; and its error after a step.
fn inner(scope: &Scope<'_>, errors: [Relation; 3]) -> Result<(Vec<Fact>, Poly, Place), Refusal> {
    let swarm = Swarm::new(Class::Inner, false, Mode::Plain);
    let mut facts = [group(scope)?.facts, swarm.index_facts(Class::Inner)].concat();
    for (offset, relation) in (-1..=1).zip(errors) {
        let error = swarm.place.error(offset, &x(offset));
        facts.push(Fact::new(&format!("error[{offset}]"), error, relation));
    }
    let after = swarm.after(Mode::Plain).into_iter().next();
    let (_, after) = after.ok_or_else(|| Refusal::Wrong("no step".into()))?;
    Ok((facts, Family::UpperBound.goal(&after)?, swarm.place))
}

/// 7.6 (ii): let c stay for H = ceil((N-2)/2) steps from step k on.
/// * `ends/*`: while c stays, the errors of drones 1 and N-2 are not above zero, so zero (by 7.3 they
///   are not below): at steps k .. k+H-1.
/// * `pull/*`: where drone j's error is zero after a step, its neighbours' errors were zero
///   before it. By induction over m the errors of drones m and N-1-m are zero at steps k .. k+H-m, m = 1 .. H.
/// * `depth`: no inner drone is farther than H from both ends; so all errors are zero at step k.
fn constant_sum(scope: &Scope<'_>) -> Obligations {
    if scope.form == Form::Paper {
        return Err(Refusal::Wrong(
            "the paper's form is false at eps = 0: see the refutations".into(),
        ));
    }
    let mut all = invariant(scope, &[Family::UpperBound], Mode::Plain)?;
    all.extend(flux(scope)?);
    let known = [group(scope)?.facts, ends(NonNegative, NonNegative)].concat();
    for (fact, label) in ends(Zero, Zero).into_iter().zip(["first", "last"]) {
        let mut facts = known.clone();
        facts.push(Fact::new("c'-c", increment(scope)?, Zero));
        all.push(obligation(
            format!("ends/{label}"),
            facts,
            Poly::from_int(0) - &fact.poly,
            NonNegative,
        ));
    }
    for (offset, label) in [(1, "right"), (-1, "left")] {
        let (mut facts, after, place) = inner(scope, [NonNegative; 3])?;
        facts.push(Fact::new("error'[0]", after, Zero));
        let goal = Poly::from_int(0) - &place.error(offset, &x(offset));
        all.push(obligation(format!("pull/{label}"), facts, goal, NonNegative));
    }
    let (h, j, last, one) = (named("H"), named("j"), named("last"), Poly::from_int(1));
    let beyond = |depth: Poly| depth - &h - &one;
    let facts = vec![
        Fact::new("2H-last+1", Poly::from_int(2) * &h - &last + &one, NonNegative),
        Fact::new("j-H-1", beyond(j.clone()), NonNegative),
        Fact::new("last-j-H-1", beyond(last - &j), NonNegative),
    ];
    all.push(obligation("depth".into(), facts, Poly::from_int(-1), NonNegative));
    Ok(all)
}

/// 7.7: let d >= 1 be the least depth min(j, N-1-j) of a drone off its target at step k. At step k+t, t < d, all
/// drones of depth below d-t are at their targets (`retreat`: neighbours differ in depth by 1
/// at most; the end drones stay) and one of depth d-t is before its own (`advance/*`, from the drone of depth
/// d-t+1 behind it). So c is constant up to step k+d-1 (`constant`) and increases in the next step (`increase/*`).
fn globally_increasing(scope: &Scope<'_>) -> Obligations {
    if scope.form == Form::Paper {
        return Err(Refusal::Wrong(
            "the paper's form is false at eps = 0: see the refutations".into(),
        ));
    }
    let mut all = invariant(scope, &[Family::UpperBound], Mode::Plain)?;
    all.extend(flux(scope)?);
    let (facts, after, _) = inner(scope, [Zero; 3])?;
    all.push(obligation("retreat".into(), facts, after, Zero));
    for (label, errors) in [
        ("right", [NonNegative, NonNegative, Positive]),
        ("left", [Positive, NonNegative, NonNegative]),
    ] {
        let (facts, after, _) = inner(scope, errors)?;
        all.push(obligation(format!("advance/{label}"), facts, after, Positive));
    }
    let known = group(scope)?.facts;
    let mut with = |name: &str, first, last, relation| -> Result<(), Refusal> {
        let facts = [known.clone(), ends(first, last)].concat();
        all.push(obligation(name.into(), facts, increment(scope)?, relation));
        Ok(())
    };
    with("constant", Zero, Zero, Zero)?;
    with("increase/first", Positive, NonNegative, Positive)?;
    with("increase/last", NonNegative, Positive, Positive)?;
    Ok(all)
}

/// 7.8 for weights up to 1/2: with w_i = i(N-1-i), positive on the inner drones (`weight`) and zero at the ends, and M the
/// largest |e_j|/w_j: |e_i'| <= (1 - 8eps/(N-1)^2) M w_i (`step/*`, times (N-1)^2), the rate being in
/// [0, 1) (`rate/*`). By induction over k, |e_i^k| <= rate^k M w_i, which tends to 0.
fn limit(scope: &Scope<'_>) -> Obligations {
    anchored(Mode::Plain)?;
    let (mut facts, after, place) = inner(scope, [NonNegative; 3])?;
    facts.truncate(facts.len() - 3);
    let (m, last, eps) = (named("M"), named("last"), named("eps"));
    let square = last.clone() * &last;
    let kept = square.clone() - &(Poly::from_int(8) * &eps);
    let weight = |o: i32| contraction_weight_at(&last, &(named("i") + &Poly::from_int(o)));
    let scaled = |o: i32| m.clone() * &weight(o);
    let known = facts.clone();
    facts.push(Fact::new("M", m.clone(), NonNegative));
    for o in -1..=1 {
        let error = place.error(o, &x(o));
        facts.push(Fact::new(&format!("M*w-error[{o}]"), scaled(o) - &error, NonNegative));
        facts.push(Fact::new(&format!("M*w+error[{o}]"), scaled(o) + &error, NonNegative));
    }
    let bound = kept.clone() * &scaled(0);
    let moved = square.clone() * &after;
    Ok(vec![
        obligation("weight".into(), known.clone(), weight(0), Positive),
        obligation("step/upper".into(), facts.clone(), bound.clone() - &moved, NonNegative),
        obligation("step/lower".into(), facts, bound + &moved, NonNegative),
        obligation("rate/below-one".into(), known.clone(), square - &kept, Positive),
        obligation("rate/nonnegative".into(), known, kept, NonNegative),
    ])
}

/// Equation 6 on a path: every drone moves by F(i+1) - F(i), where drone 0 has no F(0) and
/// drone N-1 no F(N): the differences telescope to 0.
fn consensus(scope: &Scope<'_>) -> Obligations {
    let f = datum(scope, "flux")?;
    let swarm: Vec<Poly> = (-2..=2).map(x).collect();
    let at = |o: i32| at(&f, &(named("i") + &Poly::from_int(o)), &x(o - 1), &x(o));
    let cases = [
        ("first", &swarm[2..], 0, at(1)),
        ("inner", &swarm[..], 2, at(1) - &at(0)),
        ("last", &swarm[..3], 2, Poly::from_int(0) - &at(0)),
    ];
    Ok(cases
        .into_iter()
        .map(|(label, drones, i, flux)| {
            let path = Path { count: drones.len() };
            let after = exec_consensus(&named("eps"), &path, &drones.to_vec());
            let goal = after[i].clone() - &x(0) - &flux;
            obligation(format!("flux/{label}"), Vec::new(), goal, Zero)
        })
        .collect())
}

/// A range of weights in formula.
pub fn range(weights: WeightRange) -> &'static str {
    match weights {
        WeightRange::Any => "any eps",
        WeightRange::Unit => "0 <= eps <= 1",
        WeightRange::BelowThird => "0 <= eps < 1/3",
        WeightRange::BelowHalf => "0 <= eps < 1/2",
        WeightRange::UpToHalf => "0 <= eps <= 1/2",
        WeightRange::UpToHalfOrOne => "0 <= eps <= 1/2 (N = 3: 0 <= eps <= 1)",
        WeightRange::PositiveUpToHalf => "0 < eps <= 1/2",
        WeightRange::BelowCritical => "0 < eps < 1/(1 + cos(pi/(N-1)))",
    }
}
